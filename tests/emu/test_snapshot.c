/* A run that goes on from a snapshot is the same as one that never stopped; damage is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "display_file/df_regs.h"
#include "emu/debug/snapshot.h"
#include "tests/support/dpu_invariants.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define MS       CRT_PS_PER_MS
#define TICK     (CRT_PS_PER_S / 60)
#define MIE      8u /* of mstatus: interrupts are on */

/* Everything one run needs. Its parts point at each other: it stays where it is. */
struct run {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_settings_options options;
    struct vm_rig rig;
    uint64_t drawn;   /* hash of what the machine did while traced */
    uint64_t printed; /* and of what it printed */
};

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
    struct run *r = ctx;
    mix(&r->drawn, t);
    mix(&r->drawn, (uint64_t)address << 32 | (unsigned)w << 8 | fetched);
    for (unsigned offset = DF_DPC; offset <= DF_YPR; offset += 2)
        mix(&r->drawn, df_dpu_read(dpu, offset));
}

static void stroke(void *ctx, const struct crt_stroke *s)
{
    struct run *r = ctx;
    uint32_t bits[5];
    memcpy(bits, &s->x0, sizeof bits); /* x0, y0, x1, y1, drive */
    mix(&r->drawn, s->t0);
    mix(&r->drawn, s->t1);
    for (int i = 0; i < 5; i++)
        mix(&r->drawn, bits[i]);
}

static void instruction(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t w, bool trapped)
{
    struct run *r = ctx;
    mix(&r->drawn, (uint64_t)pc << 32 | w);
    mix(&r->drawn, cpu->cycle * 2 + trapped);
}

static void printed(void *ctx, uint8_t byte, uint64_t t)
{
    struct run *r = ctx;
    mix(&r->printed, t * 256 + byte);
}

static void line(void *ctx, uint64_t t, unsigned number, bool level)
{
    struct run *r = ctx;
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

static void load_input(struct run *r, const char *path)
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

static const struct vm_settings_options plain;

/* `light`: with a tube. Random programs get a spot so wide that a few thousand cells will do. */
static struct run *open_run(const char *path, bool light, const struct vm_settings_options *options)
{
    struct run *r = calloc(1, sizeof *r);
    struct crt_error err;
    assert_non_null(r);
    load_input(r, path);
    if (vm_settings_resolve(options, r->input.is_recording ? &r->input.header : NULL,
                            vm_input_tube(&r->input), &r->settings, &err))
        fail_msg("%s", err.text);
    if (strncmp(path, "random", 6) == 0)
        r->settings.row.spot.value = r->settings.row.width.value / 64;
    struct crt_tube_desc tube = vm_settings_tube(&r->settings);
    if (!vm_rig_open(&r->rig, &r->settings, &r->input, DF_TIMING_VALUE, light ? &tube : NULL, &err))
        fail_msg("%s", err.text);
    if (r->rig.console)
        r->rig.console->desc = (struct vm_console_desc){.ctx = r, .sink = printed};
    if (strncmp(path, "random", 6) == 0)
        r->rig.machine->dpu.desc.beam.offer = pen;
    return r;
}

static void close_run(struct run *r)
{
    vm_rig_close(&r->rig);
    vm_settings_free(&r->settings);
    vm_input_free(&r->input);
    free(r);
}

static struct crt_state save(struct run *r)
{
    struct crt_state s;
    struct crt_error err;
    if (!vm_snapshot_write(&s, &r->rig, &r->settings, &r->input, &err))
        fail_msg("%s", err.text);
    return s;
}

static bool load(struct run *r, const uint8_t *bytes, size_t size, struct crt_error *err)
{
    return vm_snapshot_read(bytes, size, "FILE", &r->rig, &r->settings, &r->input, err);
}

static void must_load(struct run *r, const struct crt_state *s)
{
    struct crt_error err;
    if (!load(r, s->out, s->size, &err))
        fail_msg("%s", err.text);
}

static void same_state(struct run *a, struct run *b)
{
    struct crt_state one = save(a), two = save(b);
    assert_int_equal(one.size, two.size);
    assert_memory_equal(one.out, two.out, one.size);
    crt_state_free(&one);
    crt_state_free(&two);
}

/* ---- going on ---------------------------------------------------------------------------------- */

/* Traced, with a film over part of it. */
static void trace_to(struct run *r, uint64_t t0, uint64_t t1, struct crt_film *film)
{
    const struct rv_hooks processor = {.ctx = r, .after = instruction};
    const struct vm_hooks hooks = {
        .ctx = r, .word = word, .stroke = stroke, .line = line, .processor = &processor};
    vm_machine_trace(r->rig.machine, t0, &hooks);
    if (r->rig.tube)
        crt_film_open(r->rig.tube, film, t0, t1);
    vm_machine_trace(r->rig.machine, t1, &hooks);
}

static void go_on_alike(struct run *a, struct run *b, uint64_t t0, uint64_t t1)
{
    struct crt_film film[2] = {{.colours = 0}, {.colours = 0}};
    struct run *run[2] = {a, b};
    struct crt_error err;
    for (int i = 0; i < 2; i++) {
        if (run[i]->rig.tube)
            assert_true(crt_film_init(&film[i], run[i]->rig.tube, &err));
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
    same_state(a, b);
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
static void run_somewhere(struct run *r, uint64_t *seed, uint64_t span)
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

/* How often the instants were of a kind. */
struct kinds {
    unsigned stroke, datum, sync, vector, second, hit, stop;
    unsigned waiting, handling, sending, change;
};

static void count(struct kinds *k, const struct vm_machine *m)
{
    k->stroke += m->last_light > m->now;
    k->datum += m->dpu.phase != 0;
    k->sync += m->dpu.state == DF_WAITING_SYNC;
    k->vector += m->dpu.vector.active;
    k->second += m->dpu.second.active;
    k->hit += m->dpu.pending[DF_INT_PEN];
    k->stop += m->dpu.state == DF_STOPPED;
    for (int i = 0; i < DF_INT_COUNT; i++)
        k->change += m->interrupt[i].change != VM_NEVER;
    if (!m->desc.board)
        return;
    k->waiting += m->desc.board->cpu.state == RV_WAITING;
    k->handling += !(m->desc.board->cpu.mstatus & MIE) && m->desc.board->cpu.mie;
    k->sending += vm_uart_next(&m->desc.board->uart) != VM_NEVER;
}

/* Under a sanitizer, which makes each try slow, fewer will do. */
static bool thorough(void)
{
    const char *mode = getenv("TEST_MODE");
    return !mode || (strcmp(mode, "asan") != 0 && strcmp(mode, "tsan") != 0);
}

/* One run is saved here and there; each time a fresh one goes on beside it for a while. */
static void try_program(const char *path, uint64_t seed, int times, uint64_t span,
                        struct kinds *kinds)
{
    struct run *a = open_run(path, true, &plain);
    times = thorough() ? times : (times + 3) / 4;
    for (int n = 0; n < times; n++) {
        run_somewhere(a, &seed, span);
        count(kinds, a->rig.machine);
        struct crt_state saved = save(a);
        struct run *b = open_run(path, true, &plain);
        must_load(b, &saved);
        same_state(a, b);
        uint64_t t0 = a->rig.machine->now + dpu_random(&seed) % (TICK / 2);
        go_on_alike(a, b, t0, t0 + 1 + dpu_random(&seed) % (2 * TICK));
        crt_state_free(&saved);
        close_run(b);
    }
    /* And all that saving has not been noticed. */
    struct run *never = open_run(path, true, &plain);
    uint64_t t = a->rig.machine->now + 1;
    vm_machine_run(a->rig.machine, t);
    vm_machine_run(never->rig.machine, t);
    same_state(a, never);
    close_run(never);
    close_run(a);
}

static void programs_go_on_from_any_instant(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/lander.df",        "roms/radar.df", "roms/spin.df",
                                        "roms/charset.df",       "roms/rose.df",  "roms/growing.df",
                                        "tests/programs/star.df"};
    struct kinds kinds = {.stroke = 0};
    for (size_t i = 0; i < COUNT(paths); i++)
        try_program(paths[i], 100 + i, 3, CRT_PS_PER_S / 5, &kinds);
}

static void a_firing_pen_goes_on_too(void **state)
{
    (void)state;
    struct kinds kinds = {.stroke = 0};
    for (unsigned i = 0; i < 6; i++) {
        char name[20];
        snprintf(name, sizeof name, "random%u", 77 + i);
        try_program(name, 200 + i, 32, TICK, &kinds);
    }
    print_message("# in a stroke %u, in a datum %u, at sync %u, vector left %u, character left %u, "
                  "hit pending %u, stopped %u\n",
                  kinds.stroke, kinds.datum, kinds.sync, kinds.vector, kinds.second, kinds.hit,
                  kinds.stop);
    if (!thorough())
        return;
    assert_true(kinds.stroke > 5 && kinds.datum > 5 && kinds.sync > 5 && kinds.vector > 2);
    assert_true(kinds.second > 0 && kinds.hit > 5 && kinds.stop > 5);
}

static void a_recording_goes_on(void **state)
{
    (void)state;
    struct kinds kinds = {.stroke = 0};
    try_program("recording", 300, 12, CRT_PS_PER_S / 8, &kinds);
    assert_true(kinds.stroke > 3 || !thorough());
}

static void firmware_goes_on(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/bounce.elf", "roms/clock.elf",  "roms/stops.elf",
                                        "roms/tables.elf", "roms/village.df", "roms/hello.elf"};
    static const uint64_t span[] = {TICK, TICK, TICK, TICK, TICK, TICK / 100};
    struct kinds kinds = {.stroke = 0};
    for (size_t i = 0; i < COUNT(paths); i++)
        try_program(paths[i], 400 + i, i == 5 ? 20 : 6, span[i], &kinds);
    print_message("# in a stroke %u, in a datum %u, waiting %u, handling %u, sending %u, "
                  "line to change %u\n",
                  kinds.stroke, kinds.datum, kinds.waiting, kinds.handling, kinds.sending,
                  kinds.change);
    if (!thorough())
        return;
    assert_true(kinds.stroke > 2 && kinds.waiting > 2 && kinds.handling > 2 && kinds.sending > 2);
}

/* ---- the file ---------------------------------------------------------------------------------- */

static const char *out_path(const char *name)
{
    static char path[2][512];
    static int turn;
    const char *folder = getenv("TEST_OUT");
    turn = !turn;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder ? folder : ".", name);
    return path[turn];
}

static void a_file_holds_it(void **state)
{
    (void)state;
    struct run *a = open_run("roms/lander.df", true, &plain);
    struct run *b = open_run("roms/lander.df", true, &plain);
    struct crt_error err;
    const char *path = out_path("lander.state");
    vm_machine_run(a->rig.machine, 7 * TICK + MS);
    if (!vm_snapshot_save(path, &a->rig, &a->settings, &a->input, &err) ||
        !vm_snapshot_load(path, &b->rig, &b->settings, &b->input, &err))
        fail_msg("%s", err.text);
    same_state(a, b);
    go_on_alike(a, b, 8 * TICK, 9 * TICK);
    assert_int_equal(unlink(path), 0);
    assert_false(vm_snapshot_load(path, &b->rig, &b->settings, &b->input, &err));
    assert_non_null(strstr(err.text, "lander.state cannot be opened: No such file"));
    assert_false(vm_snapshot_load("tests", &b->rig, &b->settings, &b->input, &err));
    assert_string_equal(err.text, "tests is not a regular file; give the name of a snapshot");
    assert_false(vm_snapshot_save("tests", &a->rig, &a->settings, &a->input, &err));
    assert_false(vm_snapshot_save("no/such/folder", &a->rig, &a->settings, &a->input, &err));
    assert_non_null(strstr(err.text, "no/such/folder cannot be written"));
    same_state(a, b);
    close_run(a);
    close_run(b);
}

/* Recorded; the same from every compiler and processor. To be recorded anew when what is saved, or
 * the tube, is changed on purpose. */
static void the_bytes_are_the_same_everywhere(void **state)
{
    (void)state;
    static const char recorded[] =
        "dfd26fe968ea22f77c58f85b6399c80260ed9a6d73111910087f5c2a8acf3d3e";
    static const char digits[] = "0123456789abcdef";
    struct run *a = open_run("random7", true, &plain);
    char hex[2 * VM_SNAPSHOT_SUM + 1] = "";
    vm_machine_run(a->rig.machine, 9 * TICK + 3 * MS + 1);
    struct crt_state s = save(a);
    for (size_t i = 0; i < VM_SNAPSHOT_SUM; i++) {
        uint8_t byte = s.out[s.size - VM_SNAPSHOT_SUM + i];
        hex[2 * i] = digits[byte >> 4];
        hex[2 * i + 1] = digits[byte & 15];
    }
    print_message("# %zu bytes, %s\n", s.size, hex);
    assert_string_equal(hex, recorded);
    crt_state_free(&s);
    close_run(a);
}

/* The host's choices are no part of it. */
static void threads_and_kernels_do_not_matter(void **state)
{
    (void)state;
    const struct vm_settings_options other = {.threads = 3, .simd = "baseline"};
    struct run *a = open_run("roms/spin.df", true, &plain);
    struct run *b = open_run("roms/spin.df", true, &other);
    vm_machine_run(a->rig.machine, 10 * TICK + 5 * MS);
    vm_machine_run(b->rig.machine, 3 * TICK + MS);
    vm_machine_run(b->rig.machine, 10 * TICK + 5 * MS);
    same_state(a, b);
    close_run(a);
    close_run(b);
}

/* ---- refusals ---------------------------------------------------------------------------------- */

static void refused(struct run *r, const struct crt_state *s, const char *sentence)
{
    struct crt_error err = {""};
    struct crt_state before = save(r);
    assert_false(load(r, s->out, s->size, &err));
    assert_string_equal(err.text, sentence);
    struct crt_state after = save(r);
    assert_int_equal(before.size, after.size);
    assert_memory_equal(before.out, after.out, after.size);
    crt_state_free(&before);
    crt_state_free(&after);
}

static void another_configuration_is_refused(void **state)
{
    (void)state;
    struct vm_settings_options options[8] = {
        {.tube = "VR14"},      {.phosphor = "P31"},   {.refresh = {50, 1}},  {.on_stop = "halt"},
        {.set = {.count = 1}}, {.set = {.count = 1}}, {.set = {.count = 1}}, {.set = {.count = 1}}};
    static const char *const sentences[8] = {
        "FILE was made with another tube (VR17, this run has VR14); give the same --tube, --tubes "
        "and --set figures",
        "FILE was made with another phosphor (P39, this run has P31); give the same --phosphor and "
        "--tubes",
        "FILE was made with another sync tick (60 Hz, this run has 50 Hz); give the same --refresh",
        "FILE was made with another machine; give the same --set memory, --set dpu.average and "
        "--on-stop",
        "FILE was made with another machine; give the same --set memory, --set dpu.average and "
        "--on-stop",
        "FILE was made with another version of the tube VR17; give the same --tube, --tubes and "
        "--set figures",
        "FILE was made with another machine; give the same --set memory, --set dpu.average and "
        "--on-stop",
        NULL};
    options[4].set.item[0] = "memory=32K";
    options[5].set.item[0] = "spot=0.5";
    options[6].set.item[0] = "dpu.average=20us";
    options[7].set.item[0] = "brightness=0.2"; /* knobs are state */
    struct run *a = open_run("roms/lander.df", true, &plain);
    vm_machine_run(a->rig.machine, 3 * TICK + MS);
    struct crt_state s = save(a);
    for (size_t i = 0; i < COUNT(options); i++) {
        struct run *b = open_run("roms/lander.df", true, &options[i]);
        if (sentences[i])
            refused(b, &s, sentences[i]);
        else
            must_load(b, &s);
        close_run(b);
    }
    struct run *b =
        open_run("roms/radar.df", true, &(struct vm_settings_options){.tube = "VR17/P39"});
    refused(b, &s,
            "FILE was made with another program (lander.df, this run has radar.df); run that "
            "program");
    close_run(b);
    b = open_run("random2", false, &plain);
    strcpy(b->input.name, "lander.df");
    refused(b, &s, "FILE was made with another version of the program lander.df; run that program");
    close_run(b);
    crt_state_free(&s);
    close_run(a);
}

static void light_is_needed_where_somebody_looks(void **state)
{
    (void)state;
    struct run *dark = open_run("random4", false, &plain);
    struct run *light = open_run("random4", true, &plain);
    vm_machine_run(dark->rig.machine, 3 * TICK + MS);
    struct crt_state s = save(dark);
    refused(light, &s,
            "FILE cannot be loaded: it holds no light, as it was made by a run without a tube "
            "(headless); make it again");
    crt_state_free(&s);
    vm_machine_run(light->rig.machine, 4 * TICK + MS);
    s = save(light);
    must_load(dark, &s);
    assert_int_equal(dark->rig.machine->now, 4 * TICK + MS);
    go_on_alike(dark, dark, 5 * TICK, 6 * TICK);
    vm_machine_run(light->rig.machine, 6 * TICK);
    assert_int_equal(dark->rig.machine->dpu.words, light->rig.machine->dpu.words);
    assert_int_equal(dark->rig.machine->dpu.t, light->rig.machine->dpu.t);
    crt_state_free(&s);
    close_run(dark);
    close_run(light);
}

/* Another film grid: a close-up. */
static void another_close_up_is_refused(void **state)
{
    (void)state;
    struct run *a = open_run("random4", true, &plain);
    struct crt_error err;
    struct crt_state s = save(a);
    struct crt_tube_desc tube = vm_settings_tube(&a->settings);
    tube.grid = crt_grid_closeup(0, 0, 20, 64, 64);
    vm_rig_close(&a->rig);
    assert_true(vm_rig_open(&a->rig, &a->settings, &a->input, DF_TIMING_VALUE, &tube, &err));
    refused(a, &s,
            "FILE cannot be loaded: the snapshot's light lies on other film cells than this "
            "tube's: one of the two is a close-up, or another one; make it again");
    crt_state_free(&s);
    close_run(a);
}

static void other_files_are_refused(void **state)
{
    (void)state;
    struct run *a = open_run("random4", false, &plain);
    struct crt_state s = save(a), cut = s;
    refused(a, &(struct crt_state){.out = (uint8_t *)"P6 3 3 255 ............", .size = 20},
            "FILE is no snapshot of kinescope's; make one with --save-state");
    s.out[8] = 2;
    refused(a, &s,
            "FILE is a snapshot of version 2, and this kinescope reads version 1; make it again");
    s.out[8] = 1;
    cut.size = 999;
    char sentence[128];
    snprintf(sentence, sizeof sentence,
             "FILE is cut short: 999 of its bytes are there, not %zu; make it again", s.size);
    refused(a, &cut, sentence);
    s.out[s.size / 2] ^= 4;
    refused(a, &s, "FILE is damaged: its check sum is wrong; make it again");
    s.out[s.size / 2] ^= 4;
    must_load(a, &s);
    crt_state_free(&s);
    close_run(a);
}

/* Of a short snapshot, a minute's work otherwise. */
static void every_flip_and_every_cut_is_refused(void **state)
{
    (void)state;
    struct run *a = open_run("tests/programs/star.df", false, &plain);
    struct crt_error err;
    vm_machine_run(a->rig.machine, TICK + MS / 3);
    struct crt_state s = save(a), again;
    print_message("# %zu bytes\n", s.size);
    for (size_t i = 0; i < s.size; i++) {
        s.out[i] ^= (uint8_t)(1u << i % 8);
        assert_false(load(a, s.out, s.size, &err));
        s.out[i] ^= (uint8_t)(1u << i % 8);
        assert_false(load(a, s.out, i, &err));
    }
    again = save(a);
    assert_memory_equal(s.out, again.out, s.size);
    crt_state_free(&again);
    crt_state_free(&s);
    close_run(a);
}

/* Where the fields of processor and machine begin. */
static size_t fields_of(const struct crt_state *s)
{
    size_t at = s->size - 4;
    while (memcmp(s->out + at, "DPU ", 4) != 0)
        at--;
    return at;
}

static void mend(struct crt_state *s)
{
    size_t size = s->size - VM_SNAPSHOT_SUM;
    vm_snapshot_sum(s->out, size, s->out + size);
}

/* Damage that the check sum does not tell of: refused, and then nothing has changed, or harmless. */
static void forged_check_sums_do_no_harm(void **state)
{
    (void)state;
    unsigned taken = 0, no = 0;
    uint64_t seed = 99;
    for (unsigned round = 0; round < 6; round++) {
        struct run *a = open_run("random5", true, &plain), *b;
        for (unsigned i = 0; i <= round; i++)
            run_somewhere(a, &seed, TICK);
        struct crt_state before = save(a), s = save(a);
        b = open_run("random5", true, &plain);
        struct crt_state fresh = save(b);
        for (int n = 0; n < (thorough() ? 250 : 60); n++) {
            struct crt_error err;
            size_t at = (size_t)(dpu_random(&seed) % s.size);
            at = n % 2 ? fields_of(&s) + (size_t)(dpu_random(&seed) % 600) : at;
            s.out[at] = (uint8_t)(s.out[at] ^ (1u << dpu_random(&seed) % 8));
            mend(&s);
            if (load(b, s.out, s.size, &err)) {
                vm_machine_run(b->rig.machine, b->rig.machine->now + 3 * MS);
                taken++;
            } else {
                refused(b, &s, err.text);
                no++;
            }
            memcpy(s.out, before.out, s.size);
            must_load(b, &fresh);
        }
        crt_state_free(&s);
        crt_state_free(&before);
        crt_state_free(&fresh);
        close_run(a);
        close_run(b);
    }
    print_message("# %u damaged snapshots taken, %u refused\n", taken, no);
    assert_true(taken > 50 && no > 50 / (thorough() ? 1 : 4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(programs_go_on_from_any_instant),
        cmocka_unit_test(a_firing_pen_goes_on_too),
        cmocka_unit_test(a_recording_goes_on),
        cmocka_unit_test(firmware_goes_on),
        cmocka_unit_test(a_file_holds_it),
        cmocka_unit_test(the_bytes_are_the_same_everywhere),
        cmocka_unit_test(threads_and_kernels_do_not_matter),
        cmocka_unit_test(another_configuration_is_refused),
        cmocka_unit_test(light_is_needed_where_somebody_looks),
        cmocka_unit_test(another_close_up_is_refused),
        cmocka_unit_test(other_files_are_refused),
        cmocka_unit_test(every_flip_and_every_cut_is_refused),
        cmocka_unit_test(forged_check_sums_do_no_harm),
    };
    return cmocka_run_group_tests_name("snapshot", tests, NULL, NULL);
}
