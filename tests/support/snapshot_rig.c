#include "tests/support/snapshot_rig.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "tests/support/dpu_invariants.h"

static void mix(uint64_t *h, uint64_t v)
{
    *h = (*h ^ v) * UINT64_C(0x100000001b3);
    *h ^= *h >> 29;
}

/* A pen without a memory of its own: it fires in about every eighth stroke. */
static uint64_t pen(void *ctx, const struct crt_stroke *s)
{
    uint64_t h = UINT64_C(0xcbf29ce484222325);
    (void)ctx;
    mix(&h, s->t0);
    mix(&h, s->source);
    return h % 8 ? DF_NO_HIT : s->t0 + (h >> 8) % (s->t1 - s->t0);
}

static void word(void *ctx, uint64_t t, uint16_t address, uint16_t w, bool fetched,
                 const struct df_dpu *dpu)
{
    struct snap_run *r = ctx;
    mix(&r->drawn, t);
    mix(&r->drawn, (uint64_t)address << 32 | (unsigned)w << 8 | fetched);
    for (unsigned offset = DF_DPC; offset <= DF_YPR; offset += 2)
        mix(&r->drawn, df_dpu_read(dpu, offset));
}

static void stroke(void *ctx, const struct crt_stroke *s)
{
    struct snap_run *r = ctx;
    uint32_t bits[5];
    memcpy(bits, &s->x0, sizeof bits); /* x0, y0, x1, y1, drive */
    mix(&r->drawn, s->t0);
    mix(&r->drawn, s->t1);
    for (int i = 0; i < 5; i++)
        mix(&r->drawn, bits[i]);
}

static void instruction(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t w, bool trapped)
{
    struct snap_run *r = ctx;
    mix(&r->drawn, (uint64_t)pc << 32 | w);
    mix(&r->drawn, cpu->cycle * 2 + trapped);
}

static void printed(void *ctx, uint8_t byte, uint64_t t)
{
    struct snap_run *r = ctx;
    mix(&r->printed, t * 256 + byte);
}

static void line(void *ctx, uint64_t t, unsigned number, bool level)
{
    struct snap_run *r = ctx;
    mix(&r->drawn, t * 16 + number * 2 + level);
}

/* ---- set-up ------------------------------------------------------------------------------------ */

/* Words at random, with the pen's interrupt on more often than not. */
static void random_program(struct df_program *p, uint64_t seed)
{
    struct crt_error err;
    assert_true(df_program_init(p, &err));
    for (uint32_t at = 0; at < 0x8000; at += 2) {
        uint16_t w = (uint16_t)(dpu_random(&seed) >> 32);
        unsigned op = w >> DF_MODE_SHIFT & 15;
        if (w & DF_CONTROL && (op == 7 || (op >= 9 && op <= 11) || dpu_random(&seed) % 2))
            w &= 0x7fff;
        if (w & DF_CONTROL && op <= DF_MODE_RELPOINT && dpu_random(&seed) % 2)
            w |= DF_SGM_PEN | DF_SGM_PEN_ON;
        df_program_put(p, at, w);
    }
}

/* Strokes one after the other, some with a pause, some longer than a tick. */
static void make_recording(struct vm_input *input)
{
    uint64_t seed = 5, t = 1000;
    *input = (struct vm_input){.is_recording = true, .name = "recording", .count = 12000};
    input->header = (struct crt_beam_header){.tube = "VR17", .tick = {60, 1}};
    input->strokes = malloc(input->count * sizeof input->strokes[0]);
    assert_non_null(input->strokes);
    for (size_t i = 0; i < input->count; i++) {
        struct crt_stroke s = {.t0 = t, .drive = 1, .source = (uint32_t)i * 2};
        s.x0 = (float)(dpu_random(&seed) % 200) - 100;
        s.y1 = (float)(dpu_random(&seed) % 200) - 100;
        s.t1 = t + 1000 + dpu_random(&seed) % (i % 500 == 499 ? 3 * TICK : MS / 4);
        t = s.t1 + (i % 7 ? 0 : dpu_random(&seed) % MS);
        input->strokes[i] = s;
    }
}

static void load_input(struct snap_run *r, const char *path)
{
    const bool typed = strstr(path, ".elf") != NULL;
    const struct vm_input_options options = {.type = typed ? "One\\nline and another\\n" : NULL};
    struct crt_error err;
    if (strcmp(path, "recording") == 0) {
        make_recording(&r->input);
    } else if (strncmp(path, "random", 6) == 0) {
        strcpy(r->input.name, "random");
        random_program(&r->input.program, strtoul(path + 6, NULL, 10));
    } else if (!vm_input_load(&r->input, path, &options, &err, NULL)) {
        fail_msg("%s", err.text);
    }
}

const struct vm_settings_options snap_plain;

/* `light`: with a tube. Random programs get a spot so wide that a few thousand cells will do. */
struct snap_run *snap_open(const char *path, bool light, const struct vm_settings_options *options)
{
    struct snap_run *r = calloc(1, sizeof *r);
    struct crt_error err;
    assert_non_null(r);
    load_input(r, path);
    if (vm_settings_resolve(options, r->input.is_recording ? &r->input.header : NULL,
                            vm_input_tube(&r->input), &r->settings, &err))
        fail_msg("%s", err.text);
    if (strncmp(path, "random", 6) == 0)
        r->settings.monitor[VM_VECTOR].row.spot.value =
            r->settings.monitor[VM_VECTOR].row.width.value / 64;
    struct vm_tubes tubes = vm_settings_tubes(&r->settings, VM_VIEW_VECTOR);
    if (!vm_rig_open(&r->rig, &r->settings, &r->input, DF_TIMING_VALUE, light ? &tubes : NULL,
                     &err))
        fail_msg("%s", err.text);
    if (r->rig.console)
        r->rig.console->desc = (struct vm_console_desc){.ctx = r, .sink = printed};
    if (strncmp(path, "random", 6) == 0) {
        r->pen = true;
        r->rig.machine->dpu.desc.beam.offer = pen;
    }
    return r;
}

void snap_close(struct snap_run *r)
{
    vm_rig_close(&r->rig);
    vm_settings_free(&r->settings);
    vm_input_free(&r->input);
    free(r);
}

struct crt_state snap_save(struct snap_run *r)
{
    struct crt_state s;
    struct crt_error err;
    if (!vm_snapshot_write(&s, &r->rig, &r->settings, &r->input, &err))
        fail_msg("%s", err.text);
    return s;
}

bool snap_load(struct snap_run *r, const uint8_t *bytes, size_t size, struct crt_error *err)
{
    bool ok = vm_snapshot_read(bytes, size, "FILE", &r->rig, &r->settings, &r->input, err);
    if (r->pen) /* loading has wired the machine's own */
        r->rig.machine->dpu.desc.beam.offer = pen;
    return ok;
}

void snap_must_load(struct snap_run *r, const struct crt_state *s)
{
    struct crt_error err;
    if (!snap_load(r, s->out, s->size, &err))
        fail_msg("%s", err.text);
}

void snap_refused(struct snap_run *r, const struct crt_state *s, const char *sentence)
{
    struct crt_error err = {""};
    struct crt_state before = snap_save(r);
    assert_false(snap_load(r, s->out, s->size, &err));
    assert_string_equal(err.text, sentence);
    struct crt_state after = snap_save(r);
    assert_int_equal(before.size, after.size);
    assert_memory_equal(before.out, after.out, after.size);
    crt_state_free(&before);
    crt_state_free(&after);
}

void snap_same(struct snap_run *a, struct snap_run *b)
{
    struct crt_state one = snap_save(a), two = snap_save(b);
    assert_int_equal(one.size, two.size);
    assert_memory_equal(one.out, two.out, one.size);
    crt_state_free(&one);
    crt_state_free(&two);
}

/* ---- going on ---------------------------------------------------------------------------------- */

/* Traced, with a film over part of it. */
static void trace_to(struct snap_run *r, uint64_t t0, uint64_t t1, struct crt_film *film)
{
    const struct rv_hooks processor = {.ctx = r, .after = instruction};
    const struct vm_hooks hooks = {
        .ctx = r, .word = word, .stroke = stroke, .line = line, .processor = &processor};
    vm_machine_trace(r->rig.machine, t0, &hooks);
    if (r->rig.tube[VM_VECTOR])
        crt_film_open(r->rig.tube[VM_VECTOR], film, t0, t1);
    vm_machine_trace(r->rig.machine, t1, &hooks);
}

void snap_go_on_alike(struct snap_run *a, struct snap_run *b, uint64_t t0, uint64_t t1)
{
    struct crt_film film[2] = {{.colours = 0}, {.colours = 0}};
    struct snap_run *run[2] = {a, b};
    struct crt_error err;
    for (int i = 0; i < 2; i++) {
        if (run[i]->rig.tube[VM_VECTOR])
            assert_true(crt_film_init(&film[i], run[i]->rig.tube[VM_VECTOR], &err));
        run[i]->drawn = run[i]->printed = 0;
        trace_to(run[i], t0, t1, &film[i]);
    }
    assert_int_equal(a->drawn, b->drawn);
    assert_int_equal(a->printed, b->printed);
    size_t cells = (size_t)film[0].grid.cols * (size_t)film[0].grid.rows;
    for (int c = 0; c < film[0].colours; c++)
        assert_memory_equal(film[0].light[c], film[1].light[c], cells * sizeof(float));
    crt_film_free(&film[0]);
    crt_film_free(&film[1]);
    snap_same(a, b);
}

/* Some words on, and from there to what is rare. */
static void go_into_a_word(struct vm_machine *m, uint64_t kind)
{
    for (int i = 0; i < 300 && m->has_program; i++) {
        bool there = kind < 4   ? m->dpu.vector.active
                     : kind < 5 ? m->dpu.phase != 0
                     : kind < 7 ? m->last_light > m->now
                                : i == 7;
        if (i >= 4 && there)
            break;
        if (kind == 6) /* not between words */
            vm_machine_run(m, m->now + 1000000);
        else
            vm_machine_step(m);
    }
}

/* Runs to some instant: any, after some word, at the end of a refresh, after a stop word. */
void snap_run_somewhere(struct snap_run *r, uint64_t *seed, uint64_t span)
{
    struct vm_machine *m = r->rig.machine;
    uint64_t n = dpu_random(seed), t = m->now + (n >> 16) % span;
    if (n % 2) /* in the part of a refresh in which something is drawn */
        t = crt_tick_time(m->desc.tick, crt_tick_at(m->desc.tick, t)) + (n >> 4) % (3 * MS);
    vm_machine_run(m, t > m->now ? t : m->now + 1);
    if (n / 2 % 4 == 0)
        go_into_a_word(m, n / 8 % 8);
    else if (n / 2 % 4 == 1)
        (void)vm_machine_run_refresh(m, m->now + 2 * TICK);
    else if (n / 2 % 4 == 2)
        (void)vm_machine_run_stop(m, m->now + 2 * TICK);
    else if (m->desc.board)
        (void)vm_machine_run_retired(m, rv_retired(&m->desc.board->cpu) + n / 8 % 3000,
                                     m->now + TICK);
}

/* Under a sanitizer, which makes each try slow, fewer will do. */
bool snap_thorough(void)
{
    const char *mode = getenv("TEST_MODE");
    return !mode || (strcmp(mode, "asan") != 0 && strcmp(mode, "tsan") != 0);
}
