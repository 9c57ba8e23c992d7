/* Acts and devices in the machine: at their times, whatever the run is cut into, live or from a script,
 * before and after a snapshot. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "emu/memmap.h"
#include "tests/support/dpu_invariants.h"
#include "tests/support/snapshot_rig.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define MS       CRT_PS_PER_MS
#define US       CRT_PS_PER_US
#define TICK     (CRT_PS_PER_S / 60)

/* A person who does something of everything, at random, within `span`. */
static size_t random_acts(struct inp_act *act, size_t count, uint64_t *seed, uint64_t span)
{
    uint64_t t = 0;
    for (size_t i = 0; i < count; i++) {
        struct inp_act a = {.space = INP_MM};
        t += dpu_random(seed) % (2 * span / count) / US * US;
        a.t = t;
        a.device = (uint8_t)(dpu_random(seed) % INP_KNOB);
        a.screen = a.device == INP_TOUCH ? INP_RASTER : (uint8_t)(dpu_random(seed) % 8 == 0);
        unsigned kind = (unsigned)(dpu_random(seed) % 6);
        if (a.device == INP_KEYBOARD) {
            a.verb = kind < 3 ? INP_PRESS : INP_RELEASE;
            a.code = (uint8_t)('A' + dpu_random(seed) % 4);
            a.character = kind < 3 ? (uint8_t)(a.code + 32) : 0;
        } else if (kind == 0) {
            a.verb = INP_AWAY;
        } else if (kind == 1) {
            a.verb = dpu_random(seed) % 2 ? INP_PRESS : INP_RELEASE;
        } else {
            a.verb = INP_MOVE;
            a.duration = dpu_random(seed) % 3 ? dpu_random(seed) % (100 * MS) : 0;
            a.x = (int32_t)(dpu_random(seed) % 200000) - 100000;
            a.y = (int32_t)(dpu_random(seed) % 200000) - 100000;
            if (a.device == INP_TABLET) {
                a.x += 140000;
                a.y += 140000;
                a.z = dpu_random(seed) % 2 ? 0 : 5000;
            }
            if (a.device == INP_PEN && a.screen == INP_VECTOR && dpu_random(seed) % 2) {
                a.space = INP_UNITS;
                a.x = (int32_t)(dpu_random(seed) % 1024000);
                a.y = (int32_t)(dpu_random(seed) % 1024000);
            }
        }
        act[i] = a;
    }
    return count;
}

static struct snap_run *open_with(const char *path, const struct inp_act *act, size_t count)
{
    static const char *const wide[] = {"spot=3.7"}; /* few cells: light is not what is tested */
    struct vm_settings_options options = {.threads = 1};
    for (size_t i = 0; i < COUNT(wide); i++)
        options.set.item[options.set.count++] = wide[i];
    struct snap_run *r = snap_open(path, true, &options);
    assert_true(vm_operator_read(r->rig.person, act, count));
    return r;
}

/* ---- time --------------------------------------------------------------------------------------- */

struct heard {
    struct vm_machine *machine;
    const struct inp_act *act;
    size_t count;
};

static void hear(void *ctx, const struct inp_act *act)
{
    struct heard *h = ctx;
    assert_int_equal(act->t, h->machine->now);
    assert_memory_equal(act, &h->act[h->count], sizeof *act);
    h->count++;
}

static void acts_come_at_their_times_in_order(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/spin.df", "roms/clock.elf"};
    for (size_t p = 0; p < COUNT(paths); p++) {
        uint64_t seed = 5 + p;
        struct inp_act act[300];
        random_acts(act, COUNT(act), &seed, CRT_PS_PER_S / 2);
        struct snap_run *r = open_with(paths[p], act, COUNT(act));
        struct heard heard = {r->rig.machine, act, 0};
        const struct vm_hooks hooks = {.ctx = &heard, .act = hear};
        vm_machine_trace(r->rig.machine, act[COUNT(act) - 1].t, &hooks);
        assert_true(heard.count < COUNT(act)); /* up to, and not at, that time */
        vm_machine_trace(r->rig.machine, act[COUNT(act) - 1].t + 1, &hooks);
        assert_int_equal(heard.count, COUNT(act));
        snap_close(r);
    }
}

static void cutting_the_run_changes_nothing(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/lander.df", "roms/clock.elf", "roms/heads.elf"};
    for (size_t p = 0; p < COUNT(paths); p++) {
        uint64_t seed = 70 + p, end = CRT_PS_PER_S / 4;
        struct inp_act act[120];
        random_acts(act, COUNT(act), &seed, end);
        struct snap_run *whole = open_with(paths[p], act, COUNT(act));
        struct snap_run *cut = open_with(paths[p], act, COUNT(act));
        vm_machine_run(whole->rig.machine, end);
        while (cut->rig.machine->now < end) {
            uint64_t t = cut->rig.machine->now + 1 + dpu_random(&seed) % (3 * MS);
            vm_machine_run(cut->rig.machine, t < end ? t : end);
        }
        snap_same(whole, cut);
        snap_close(whole);
        snap_close(cut);
    }
}

/* Whether somebody looks makes no difference to what the pens see. */
static void devices_do_not_depend_on_tubes(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/lander.df", "roms/heads.elf"};
    for (size_t p = 0; p < COUNT(paths); p++) {
        const uint64_t end = CRT_PS_PER_S;
        struct inp_act act[40];
        for (size_t i = 0; i < COUNT(act); i++)
            act[i] = (struct inp_act){.t = i * 25 * MS,
                                      .duration = 20 * MS,
                                      .device = INP_PEN,
                                      .verb = INP_MOVE,
                                      .screen = (uint8_t)(p == 1 && i % 8 < 6),
                                      .x = (int32_t)(i * 37 % 80) * 1000 - 40000,
                                      .y = (int32_t)(i * 53 % 80) * 1000 - 40000};
        const struct vm_settings_options options = {.threads = 1};
        struct snap_run *run[2];
        for (int light = 0; light < 2; light++) {
            run[light] = snap_open(paths[p], light, &options);
            assert_true(vm_operator_read(run[light]->rig.person, act, COUNT(act)));
            vm_machine_run(run[light]->rig.machine, end);
        }
        for (int s = 0; s < INP_SCREENS; s++) {
            const struct inp_pen_port *dark = &run[0]->rig.machine->devices.port[s];
            const struct inp_pen_port *lit = &run[1]->rig.machine->devices.port[s];
            assert_int_equal(dark->firings > 0, s == (int)p); /* lander: vector, heads: raster */
            assert_memory_equal(dark, lit, sizeof *dark);
            assert_memory_equal(&run[0]->rig.machine->devices.pen[s].sight,
                                &run[1]->rig.machine->devices.pen[s].sight,
                                sizeof run[0]->rig.machine->devices.pen[s].sight);
        }
        snap_close(run[0]);
        snap_close(run[1]);
    }
}

/* ---- live, and taken back ----------------------------------------------------------------------- */

static void live_acts_are_as_those_of_a_script(void **state)
{
    (void)state;
    uint64_t seed = 9, end = CRT_PS_PER_S / 4;
    struct inp_act act[100];
    random_acts(act, COUNT(act), &seed, end);
    struct snap_run *script = open_with("roms/lander.df", act, COUNT(act));
    struct snap_run *live = open_with("roms/lander.df", NULL, 0);
    for (size_t i = 0; i < COUNT(act) && act[i].t < end; i++) {
        vm_machine_run(live->rig.machine, act[i].t);
        assert_true(vm_operator_do(live->rig.person, &act[i]));
    }
    vm_machine_run(live->rig.machine, end);
    vm_machine_run(script->rig.machine, end);
    snap_same(script, live);
    snap_close(script);
    snap_close(live);
}

static void a_new_act_makes_later_ones_forgotten(void **state)
{
    (void)state;
    struct vm_operator o = {.script = {.count = 0}};
    struct inp_act act[5] = {{.t = 10}, {.t = 20}, {.t = 20, .x = 1}, {.t = 30}, {.t = 20, .x = 2}};
    for (int i = 0; i < 4; i++)
        assert_true(vm_operator_do(&o, &act[i]));
    assert_true(vm_operator_do(&o, &act[4])); /* the machine was taken back to 20 */
    assert_int_equal(o.live.count, 4);
    assert_int_equal(o.live.act[3].x, 2);
    struct vm_done done = vm_operator_before(&o, 20);
    assert_int_equal(done.live, 1);
    assert_int_equal(vm_operator_before(&o, 21).live, 4);
    vm_operator_free(&o);
}

/* ---- snapshots ---------------------------------------------------------------------------------- */

static void runs_with_devices_go_on_from_any_instant(void **state)
{
    (void)state;
    static const char *const paths[] = {"roms/lander.df", "roms/clock.elf", "roms/heads.elf"};
    for (size_t p = 0; p < COUNT(paths); p++) {
        uint64_t seed = 170 + p;
        struct inp_act act[200];
        random_acts(act, COUNT(act), &seed, CRT_PS_PER_S);
        struct snap_run *a = open_with(paths[p], act, COUNT(act));
        for (int n = 0; n < (snap_thorough() ? 6 : 2); n++) {
            snap_run_somewhere(a, &seed, CRT_PS_PER_S / 10);
            struct crt_state saved = snap_save(a);
            struct snap_run *b = open_with(paths[p], act, COUNT(act));
            snap_must_load(b, &saved);
            snap_same(a, b);
            uint64_t t0 = a->rig.machine->now + dpu_random(&seed) % (TICK / 2);
            snap_go_on_alike(a, b, t0, t0 + 1 + dpu_random(&seed) % (2 * TICK));
            crt_state_free(&saved);
            snap_close(b);
        }
        snap_close(a);
    }
}

static void other_devices_are_refused(void **state)
{
    (void)state;
    struct snap_run *a = snap_open("roms/spin.df", true, &snap_plain);
    struct vm_settings_options options = {.set = {.count = 0}};
    options.set.item[options.set.count++] = "pen.aperture=4";
    struct snap_run *b = snap_open("roms/spin.df", true, &options);
    vm_machine_run(a->rig.machine, 3 * TICK);
    struct crt_state saved = snap_save(a);
    snap_refused(b, &saved,
                 "FILE was made with other input devices; give the same --set pen, tablet, touch, "
                 "mouse, keyboard and their figures");
    crt_state_free(&saved);
    snap_close(a);
    snap_close(b);
}

/* ---- the pen and the display processor ----------------------------------------------------------- */

/* One vector of 800 units at level 7 across the middle, the pen's interrupt enabled, and a stop. */
static struct df_program *vector_program(void)
{
    static uint16_t words[DF_MEMORY_BYTES / 2];
    static struct df_program program;
    static const uint16_t text[] = {
        0100000 | 014000 | 03400 | 0140 | 4, /* point mode, level 7, pen on, solid */
        100,
        512, /* no beam */
        0110000,
        040000 | 800,
        0,       /* long vector */
        0173400, /* stop */
    };
    memset(words, 0, sizeof words);
    memcpy(words, text, sizeof text);
    program = (struct df_program){.words = words, .low = 0, .high = sizeof text, .entry = 0};
    return &program;
}

static void a_vector_stops_under_the_pen_and_goes_on(void **state)
{
    (void)state;
    const struct inp_act at = {
        .device = INP_PEN, .verb = INP_MOVE, .space = INP_UNITS, .x = 500000, .y = 512000};
    struct vm_settings_options options = {.threads = 1, .on_stop = "halt", .phosphor = "P31"};
    struct snap_run *r = snap_open("roms/spin.df", true, &options);
    struct crt_error err;
    struct vm_machine *m = r->rig.machine;
    assert_true(vm_operator_read(r->rig.person, &at, 1));
    vm_machine_run(m, 5 * MS);
    assert_true(vm_machine_load(m, vector_program(), "vector", &err));
    uint64_t strokes = m->strokes;
    vm_machine_run(m, m->now + 3 * MS);
    assert_int_equal(m->dpu.state, DF_WAITING_RESUME);
    assert_true(df_dpu_read(&m->dpu, DF_MPR) & DF_MPR_HIT);
    unsigned x = df_dpu_read(&m->dpu, DF_XPR) & DF_XPR_X;
    /* The beam enters the aperture (radius 1.5 mm of 0.2297 mm a unit) at 493.5 and moves 10 units a
     * microsecond: it is somewhat further. */
    assert_in_range(x, 494, 520);
    assert_int_equal(df_dpu_read(&m->dpu, DF_YPR) & DF_YPR_Y, 512);
    assert_true(m->strokes > strokes);
    /* At the next tick the stand-in resumes; the rest is drawn, and the processor stops. */
    vm_machine_run(m, m->now + 2 * TICK);
    assert_int_equal(m->dpu.state, DF_STOPPED);
    assert_int_equal(df_dpu_read(&m->dpu, DF_XPR) & DF_XPR_X, 900);
    assert_true(m->devices.port[INP_VECTOR].firings >= 1);
    snap_close(r);
}

static void without_a_pen_nothing_stops(void **state)
{
    (void)state;
    const struct inp_act at = {
        .device = INP_PEN, .verb = INP_MOVE, .space = INP_UNITS, .x = 500000, .y = 512000};
    struct vm_settings_options options = {.threads = 1, .on_stop = "halt", .phosphor = "P31"};
    struct crt_error err;
    options.set.item[options.set.count++] = "pen=none";
    struct snap_run *r = snap_open("roms/spin.df", true, &options);
    struct vm_machine *m = r->rig.machine;
    assert_true(vm_operator_read(r->rig.person, &at, 1));
    vm_machine_run(m, 5 * MS);
    assert_true(vm_machine_load(m, vector_program(), "vector", &err));
    vm_machine_run(m, m->now + 3 * MS);
    assert_int_equal(m->dpu.state, DF_STOPPED);
    assert_false(df_dpu_read(&m->dpu, DF_MPR) & DF_MPR_HIT);
    snap_close(r);
}

/* ---- knobs -------------------------------------------------------------------------------------- */

static void a_knob_turns_the_tubes_and_the_pens(void **state)
{
    (void)state;
    const struct inp_act turn = {.t = MS,
                                 .device = INP_KNOB,
                                 .verb = INP_TURN,
                                 .screen = INP_VECTOR,
                                 .code = INP_CONTRAST,
                                 .x = 1500};
    struct snap_run *r = open_with("roms/spin.df", &turn, 1);
    vm_machine_run(r->rig.machine, 2 * MS);
    assert_true(crt_tube_knobs(r->rig.tube[VM_VECTOR]).contrast == 1.5);
    assert_true(r->rig.machine->devices.pen[INP_VECTOR].knobs.contrast == 1.5);
    snap_close(r);
}

/* A knob turned after a snapshot leaves the others as they were at the snapshot: not as at power-on, not as
 * they were turned later. */
static void knobs_are_what_they_were_at_the_snapshot(void **state)
{
    (void)state;
    struct inp_act act[3];
    static const uint8_t code[] = {INP_CONTRAST, INP_FOCUS, INP_BRIGHTNESS};
    static const int32_t value[] = {1500, 2000, 250};
    for (int i = 0; i < 3; i++)
        act[i] = (struct inp_act){.t = (uint64_t)(1 + 2 * i) * MS,
                                  .device = INP_KNOB,
                                  .verb = INP_TURN,
                                  .code = code[i],
                                  .x = value[i]};
    struct snap_run *a = open_with("roms/spin.df", act, COUNT(act));
    struct snap_run *b = open_with("roms/spin.df", act, COUNT(act));
    vm_machine_run(a->rig.machine, 2 * MS);
    struct crt_state saved = snap_save(a);
    vm_machine_run(a->rig.machine, 6 * MS);
    vm_machine_run(b->rig.machine, 6 * MS); /* and is taken back */
    for (int n = 0; n < 2; n++) {
        struct snap_run *c = n == 0 ? b : open_with("roms/spin.df", act, COUNT(act));
        snap_must_load(c, &saved);
        vm_machine_run(c->rig.machine, 4 * MS);
        struct crt_knobs knobs = crt_tube_knobs(c->rig.tube[VM_VECTOR]);
        assert_true(knobs.contrast == 1.5 && knobs.focus == 2 && knobs.brightness == 0);
        vm_machine_run(c->rig.machine, 6 * MS);
        snap_same(a, c);
        if (n)
            snap_close(c);
    }
    crt_state_free(&saved);
    snap_close(b);
    snap_close(a);
}

static bool at_the_act(void *ctx, struct rv_cpu *cpu)
{
    struct vm_machine *m = ctx;
    return m->done.script > 0 && cpu->cycle > 0;
}

/* A debugger stops the firmware right after an act, at its very time: going on, also from a snapshot or with
 * another act at that time, does it no second time. */
static void an_act_is_done_once(void **state)
{
    (void)state;
    for (int n = 0; n < 3; n++) {
        const struct inp_act act = {
            .t = 20 * MS, .device = INP_MOUSE, .verb = INP_MOVE, .x = 10000, .y = 0};
        struct snap_run *a = open_with("roms/monitor.elf", &act, 1);
        struct vm_machine *m = a->rig.machine;
        const struct rv_hooks hooks = {.ctx = m, .before = at_the_act};
        assert_true(vm_machine_watch(m, 40 * MS, &hooks));
        assert_int_equal(m->now, act.t);
        if (n == 1) {
            struct crt_state saved = snap_save(a);
            snap_must_load(a, &saved);
            crt_state_free(&saved);
        } else if (n == 2) {
            const struct inp_act press = {
                .t = act.t, .device = INP_MOUSE, .verb = INP_PRESS, .code = 0};
            assert_true(vm_operator_do(a->rig.person, &press));
        }
        assert_int_equal(m->done.script, 1);
        vm_machine_run(m, 200 * MS);
        assert_int_equal(m->done.script, 1);
        assert_int_equal(m->done.live, n == 2);
        snap_close(a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(acts_come_at_their_times_in_order),
        cmocka_unit_test(cutting_the_run_changes_nothing),
        cmocka_unit_test(devices_do_not_depend_on_tubes),
        cmocka_unit_test(live_acts_are_as_those_of_a_script),
        cmocka_unit_test(a_new_act_makes_later_ones_forgotten),
        cmocka_unit_test(runs_with_devices_go_on_from_any_instant),
        cmocka_unit_test(other_devices_are_refused),
        cmocka_unit_test(a_vector_stops_under_the_pen_and_goes_on),
        cmocka_unit_test(without_a_pen_nothing_stops),
        cmocka_unit_test(a_knob_turns_the_tubes_and_the_pens),
        cmocka_unit_test(knobs_are_what_they_were_at_the_snapshot),
        cmocka_unit_test(an_act_is_done_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
