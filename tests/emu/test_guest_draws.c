/* Nothing of a lesson's picture comes from the host: what the refresh buffer and display memory hold is what the
 * processor's own store instructions put there, one by one; and where the firmware does not get beyond its first
 * instruction both are empty and both heads dark, whatever is typed. The former for every lesson of the monitor. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "emu/memmap.h"
#include "emu/rig.h"
#include "emu/settings.h"

#define MONITOR "roms/monitor.elf"

enum { LESSONS = 64, STILL = 0x0000006F /* j . */ };

/* ---- a machine with something typed ------------------------------------------------------------- */

struct subject {
    struct vm_settings settings;
    struct vm_input input;
    struct vm_rig rig;
};

static void open_subject(struct subject *s, const char *image, const char *typed)
{
    struct vm_settings_options options = {0};
    struct vm_input_options input = {.type = typed};
    struct crt_error err;
    char *report;
    assert_int_equal(vm_settings_resolve(&options, NULL, NULL, &s->settings, &err), 0);
    assert_true(vm_input_load(&s->input, image, &input, &err, &report));
    assert_true(vm_rig_open(&s->rig, &s->settings, &s->input, DF_TIMING_VALUE, NULL, &err));
}

static void close_subject(struct subject *s)
{
    vm_rig_close(&s->rig);
    vm_input_free(&s->input);
    vm_settings_free(&s->settings);
}

/* ---- what the monitor says its lessons are ------------------------------------------------------- */

static struct {
    char text[16384];
    size_t length;
} said;

static void listen(void *ctx, uint8_t byte, uint64_t t)
{
    (void)ctx;
    (void)t;
    if (said.length + 1 < sizeof said.text)
        said.text[said.length++] = (char)byte;
}

/* Names, the first word of lines that begin with two blanks. */
static int lesson_names(char name[LESSONS][32])
{
    struct subject s;
    int count = 0;
    memset(&said, 0, sizeof said);
    open_subject(&s, MONITOR, "lessons\\n");
    s.rig.console->desc.sink = listen;
    vm_machine_run(s.rig.machine, CRT_PS_PER_S);
    close_subject(&s);
    for (char *line = strtok(said.text, "\r\n"); line && count < LESSONS;
         line = strtok(NULL, "\r\n"))
        if (sscanf(line, "  %31[a-z0-9-]", name[count]) == 1)
            count++;
    return count;
}

/* ---- stores ------------------------------------------------------------------------------------- */

struct shadow {
    uint8_t buffer[VIDEO_BUFFER_BYTES];
    uint8_t display[DF_MEMORY_BYTES];
    uint64_t stores;
};

static void store(uint8_t *memory, uint32_t offset, uint32_t value, unsigned width)
{
    for (unsigned i = 0; i < width; i++)
        memory[offset + i] = (uint8_t)(value >> 8 * i);
}

static bool before(void *ctx, struct rv_cpu *cpu)
{
    struct shadow *shadow = ctx;
    struct rv_access access;
    uint32_t word;
    if (!rv_fetch(cpu, cpu->pc, &word) || !rv_access_of(cpu, word, &access) || !access.store)
        return false;
    unsigned source = word >> 20 & 31;
    uint32_t value = (word & 0x7F) == 0x27 ? cpu->f[source] : cpu->x[source];
    if (access.address - MAP_VIDEO_BUFFER < VIDEO_BUFFER_BYTES)
        store(shadow->buffer, access.address - MAP_VIDEO_BUFFER, value, access.width);
    else if (access.address - MAP_DISPLAY < DF_MEMORY_BYTES)
        store(shadow->display, access.address - MAP_DISPLAY, value, access.width);
    else
        return false;
    shadow->stores++;
    return false;
}

static size_t not_zero(const uint8_t *bytes, size_t count)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++)
        n += bytes[i] != 0;
    return n;
}

static void type_lesson(char *typed, size_t size, const char *name)
{
    snprintf(typed, size, "lesson %.31s\\n", name);
}

static void draws_itself(const char *name, struct shadow *shadow)
{
    struct subject s;
    char typed[64];
    memset(shadow, 0, sizeof *shadow);
    type_lesson(typed, sizeof typed, name);
    open_subject(&s, MONITOR, typed);
    vm_machine_watch(s.rig.machine, CRT_PS_PER_S * 6 / 10,
                     &(struct rv_hooks){.ctx = shadow, .before = before});
    const struct vm_machine *m = s.rig.machine;
    if (memcmp(shadow->buffer, m->desc.buffer, sizeof shadow->buffer) != 0 ||
        memcmp(shadow->display, m->memory, sizeof shadow->display) != 0)
        fail_msg("%s: the picture is not what the firmware stored", name);
    if (not_zero(shadow->buffer, sizeof shadow->buffer) < 1000 ||
        not_zero(shadow->display, sizeof shadow->display) < 200 || m->strokes == 0)
        fail_msg("%s: hardly anything is drawn", name);
    close_subject(&s);
}

static void all_pictures_are_stores(void **state)
{
    (void)state;
    static char name[LESSONS][32];
    struct shadow *shadow = malloc(sizeof *shadow);
    assert_non_null(shadow);
    int count = lesson_names(name);
    assert_true(count >= 10);
    for (int i = 0; i < count; i++)
        draws_itself(name[i], shadow);
    free(shadow);
}

/* ---- the firmware stands still ------------------------------------------------------------------- */

static uint32_t word_of(const uint8_t *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* The same image, whose first instruction jumps to itself. */
static void write_still(const char *path)
{
    struct crt_error err;
    size_t length;
    uint8_t *image = (uint8_t *)vm_read_file(MONITOR, "image", 1 << 24, &length, &err);
    assert_non_null(image);
    uint32_t entry = word_of(image + 24);
    /* The program headers, 32 bytes each: the segment in which the entry lies. */
    const uint8_t *header = image + word_of(image + 28);
    while (entry - word_of(header + 8) >= word_of(header + 16)) {
        header += 32;
        assert_true(header + 32 <= image + length);
    }
    store(image, word_of(header + 4) + entry - word_of(header + 8), STILL, 4);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(image, 1, length, file), length);
    fclose(file);
    free(image);
}

static void nothing_runs_nothing_shows(void **state)
{
    (void)state;
    const char *folder = getenv("TEST_OUT");
    char path[512];
    struct subject s;
    snprintf(path, sizeof path, "%s/still.elf", folder ? folder : "/tmp");
    write_still(path);
    open_subject(&s, path, "lesson lines\\n");
    vm_machine_run(s.rig.machine, CRT_PS_PER_S * 6 / 10);
    const struct vm_machine *m = s.rig.machine;
    assert_int_equal(not_zero(m->desc.buffer, VIDEO_BUFFER_BYTES), 0);
    assert_int_equal(not_zero((const uint8_t *)m->memory, sizeof m->memory), 0);
    assert_int_equal(m->strokes, 0);
    assert_false(vm_machine_uses_raster(m) || vm_machine_uses_vector(m));
    close_subject(&s);
    remove(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_pictures_are_stores),
                                       cmocka_unit_test(nothing_runs_nothing_shows)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
