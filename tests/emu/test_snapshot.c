/* A run that goes on from a snapshot is the same as one that never stopped. */
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
#include "tests/support/dpu_invariants.h"
#include "tests/support/snapshot_rig.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define MIE      8u /* of mstatus: interrupts are on */

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

/* One run is saved here and there; each time a fresh one goes on beside it for a while. */
static void try_program(const char *path, uint64_t seed, int times, uint64_t span,
                        struct kinds *kinds)
{
    struct snap_run *a = snap_open(path, true, &snap_plain);
    times = snap_thorough() ? times : (times + 3) / 4;
    for (int n = 0; n < times; n++) {
        snap_run_somewhere(a, &seed, span);
        count(kinds, a->rig.machine);
        struct crt_state saved = snap_save(a);
        struct snap_run *b = snap_open(path, true, &snap_plain);
        snap_must_load(b, &saved);
        snap_same(a, b);
        uint64_t t0 = a->rig.machine->now + dpu_random(&seed) % (TICK / 2);
        snap_go_on_alike(a, b, t0, t0 + 1 + dpu_random(&seed) % (2 * TICK));
        crt_state_free(&saved);
        snap_close(b);
    }
    /* And all that saving has not been noticed. */
    struct snap_run *never = snap_open(path, true, &snap_plain);
    uint64_t t = a->rig.machine->now + 1;
    vm_machine_run(a->rig.machine, t);
    vm_machine_run(never->rig.machine, t);
    snap_same(a, never);
    snap_close(never);
    snap_close(a);
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
    if (!snap_thorough())
        return;
    assert_true(kinds.stroke > 5 && kinds.datum > 5 && kinds.sync > 5 && kinds.vector > 2);
    assert_true(kinds.second > 0 && kinds.hit > 5 && kinds.stop > 5);
}

static void a_recording_goes_on(void **state)
{
    (void)state;
    struct kinds kinds = {.stroke = 0};
    try_program("recording", 300, 12, CRT_PS_PER_S / 8, &kinds);
    assert_true(kinds.stroke > 3 || !snap_thorough());
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
    if (!snap_thorough())
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
    struct snap_run *a = snap_open("roms/lander.df", true, &snap_plain);
    struct snap_run *b = snap_open("roms/lander.df", true, &snap_plain);
    struct crt_error err;
    const char *path = out_path("lander.state");
    vm_machine_run(a->rig.machine, 7 * TICK + MS);
    if (!vm_snapshot_save(path, &a->rig, &a->settings, &a->input, &err) ||
        !vm_snapshot_load(path, &b->rig, &b->settings, &b->input, &err))
        fail_msg("%s", err.text);
    snap_same(a, b);
    snap_go_on_alike(a, b, 8 * TICK, 9 * TICK);
    assert_int_equal(unlink(path), 0);
    assert_false(vm_snapshot_load(path, &b->rig, &b->settings, &b->input, &err));
    assert_non_null(strstr(err.text, "lander.state cannot be opened: No such file"));
    assert_false(vm_snapshot_load("tests", &b->rig, &b->settings, &b->input, &err));
    assert_string_equal(err.text, "tests is not a regular file; give the name of a snapshot");
    assert_false(vm_snapshot_save("tests", &a->rig, &a->settings, &a->input, &err));
    assert_false(vm_snapshot_save("no/such/folder", &a->rig, &a->settings, &a->input, &err));
    assert_non_null(strstr(err.text, "no/such/folder cannot be written"));
    snap_same(a, b);
    snap_close(a);
    snap_close(b);
}

/* Recorded; the same from every compiler and processor. To be recorded anew when what is saved, or
 * the tube, is changed on purpose. */
static void the_bytes_are_the_same_everywhere(void **state)
{
    (void)state;
    static const char recorded[] =
        "c4153ab513c16149e976e1f670f912ce590004b5655dac8479d63db426d0cfc4";
    static const char digits[] = "0123456789abcdef";
    struct snap_run *a = snap_open("random7", true, &snap_plain);
    char hex[2 * VM_SNAPSHOT_SUM + 1] = "";
    vm_machine_run(a->rig.machine, 9 * TICK + 3 * MS + 1);
    struct crt_state s = snap_save(a);
    for (size_t i = 0; i < VM_SNAPSHOT_SUM; i++) {
        uint8_t byte = s.out[s.size - VM_SNAPSHOT_SUM + i];
        hex[2 * i] = digits[byte >> 4];
        hex[2 * i + 1] = digits[byte & 15];
    }
    print_message("# %zu bytes, %s\n", s.size, hex);
    assert_string_equal(hex, recorded);
    crt_state_free(&s);
    snap_close(a);
}

/* The host's choices are no part of it. */
static void threads_and_kernels_do_not_matter(void **state)
{
    (void)state;
    const struct vm_settings_options other = {.threads = 3, .simd = "baseline"};
    struct snap_run *a = snap_open("roms/spin.df", true, &snap_plain);
    struct snap_run *b = snap_open("roms/spin.df", true, &other);
    vm_machine_run(a->rig.machine, 10 * TICK + 5 * MS);
    vm_machine_run(b->rig.machine, 3 * TICK + MS);
    vm_machine_run(b->rig.machine, 10 * TICK + 5 * MS);
    snap_same(a, b);
    snap_close(a);
    snap_close(b);
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
