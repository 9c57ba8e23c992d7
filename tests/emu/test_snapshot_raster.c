/* Snapshots of a machine whose raster head is lit: the light goes on alike; what no head could have left
 * behind is refused, and damage that the check sum does not tell of does no harm. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "tests/support/dpu_invariants.h"
#include "tests/support/snapshot_rig.h"

/* Firmware that switches the raster head on, and some millimetres of the screen it is seen on. */
static struct snap_run *open_lit(void)
{
    struct crt_error err;
    struct snap_run *r = snap_open("roms/pattern.elf", false, &snap_plain);
    struct vm_tubes tubes = vm_settings_tubes(&r->settings, VM_VIEW_RASTER);
    tubes.desc[VM_RASTER].grid = crt_grid_closeup(0, 0, 16, 64, 64);
    tubes.desc[VM_RASTER].threads = 1;
    vm_rig_close(&r->rig);
    if (!vm_rig_open(&r->rig, &r->settings, &r->input, DF_TIMING_VALUE, &tubes, &err))
        fail_msg("%s", err.text);
    return r;
}

/* Until rows are being drawn. */
static void run_until_lit(struct snap_run *r)
{
    struct vm_machine *m = r->rig.machine;
    while (!vm_machine_uses_raster(m) && m->now < CRT_PS_PER_S)
        vm_machine_run(m, m->now + MS);
    assert_true(vm_machine_uses_raster(m));
    vm_machine_run(m, m->now + 2 * TICK + 7 * MS);
}

static void light_goes_on_alike(void **state)
{
    (void)state;
    struct snap_run *a = open_lit(), *b = open_lit();
    run_until_lit(a);
    struct crt_state s = snap_save(a);
    snap_must_load(b, &s);
    snap_same(a, b);
    struct snap_run *run[2] = {a, b};
    struct crt_film film[2];
    double sum = 0;
    uint64_t from = a->rig.machine->now + 3 * MS, to = from + TICK;
    for (int i = 0; i < 2; i++) {
        struct crt_error err;
        assert_true(crt_film_init(&film[i], run[i]->rig.tube[VM_RASTER], &err));
        vm_machine_run(run[i]->rig.machine, from);
        crt_film_open(run[i]->rig.tube[VM_RASTER], &film[i], from, to);
        vm_machine_run(run[i]->rig.machine, to + 2 * MS);
    }
    size_t cells = (size_t)film[0].grid.cols * (size_t)film[0].grid.rows;
    for (int c = 0; c < film[0].colours; c++) {
        assert_memory_equal(film[0].light[c], film[1].light[c], cells * sizeof(float));
        for (size_t i = 0; i < cells; i++)
            sum += (double)film[0].light[c][i];
    }
    assert_true(sum > 0);
    snap_same(a, b);
    crt_film_free(&film[0]);
    crt_film_free(&film[1]);
    crt_state_free(&s);
    snap_close(a);
    snap_close(b);
}

/* The check sum as it should be. */
static void mend(struct crt_state *s)
{
    size_t size = s->size - VM_SNAPSHOT_SUM;
    vm_snapshot_sum(s->out, size, s->out + size);
}

/* Puts one number for another wherever it stands within a part of the file. */
static unsigned replace(uint8_t *bytes, size_t size, uint64_t from, uint64_t to)
{
    unsigned count = 0;
    for (size_t i = 0; i + 8 <= size; i++) {
        uint64_t v = 0;
        for (int k = 7; k >= 0; k--)
            v = v << 8 | bytes[i + (size_t)k];
        for (int k = 0; v == from && k < 8; k++)
            bytes[i + (size_t)k] = (uint8_t)(to >> 8 * k);
        count += v == from;
    }
    return count;
}

static size_t find_part(const struct crt_state *s, const char *tag)
{
    for (size_t i = 0; i + 4 < s->size; i++)
        if (memcmp(s->out + i, tag, 4) == 0)
            return i;
    fail_msg("no part %s", tag);
    return 0;
}

/* The next line of the head would come before the tube's last one. */
static void a_tube_ahead_of_its_head_is_refused(void **state)
{
    (void)state;
    struct snap_run *a = open_lit(), *b = open_lit();
    run_until_lit(a);
    uint64_t last = crt_tube_times(a->rig.tube[VM_RASTER]).last_start;
    struct crt_state s = snap_save(a);
    size_t tube = find_part(&s, "TUBE");
    assert_int_equal(
        replace(s.out + tube, 200, last, a->rig.machine->raster.lit_until + CRT_PS_PER_S), 1);
    mend(&s);
    snap_refused(b, &s,
                 "FILE cannot be loaded: the snapshot's raster head is impossible; make it again");
    crt_state_free(&s);
    snap_close(a);
    snap_close(b);
}

static void epochs_that_begin_later_are_refused(void **state)
{
    (void)state;
    struct snap_run *a = open_lit(), *b = open_lit();
    run_until_lit(a);
    struct vm_machine *m = a->rig.machine;
    uint64_t origin = m->raster.origin;
    assert_true(origin > 0);
    struct crt_state s = snap_save(a);
    size_t tube = find_part(&s, "TUBE");
    assert_int_equal(replace(s.out + tube, 200, origin, m->now + CRT_PS_PER_S), 1);
    mend(&s);
    snap_refused(b, &s, "FILE cannot be loaded: the snapshot's time is impossible; make it again");
    crt_state_free(&s);
    snap_close(a);
    snap_close(b);
}

/* Bits turned over in the light, the head, and what stands in front of the buffer's pages. */
static void forged_check_sums_do_no_harm(void **state)
{
    (void)state;
    unsigned taken = 0, no = 0;
    uint64_t seed = 4711;
    struct snap_run *a = open_lit(), *b = open_lit();
    run_until_lit(a);
    struct crt_state before = snap_save(a), s = snap_save(a), fresh = snap_save(b);
    const size_t tube = find_part(&s, "TUBE"), head = find_part(&s, "VID ");
    for (int n = 0; n < (snap_thorough() ? 240 : 60); n++) {
        struct crt_error err;
        uint64_t r = dpu_random(&seed);
        size_t at = n % 3 == 0   ? tube + (size_t)(r % 300)
                    : n % 3 == 1 ? head + (size_t)(r % 1400)
                                 : tube + (size_t)(r % (s.size - VM_SNAPSHOT_SUM - tube));
        s.out[at] = (uint8_t)(s.out[at] ^ (1u << dpu_random(&seed) % 8));
        mend(&s);
        if (snap_load(b, s.out, s.size, &err)) {
            vm_machine_run(b->rig.machine, b->rig.machine->now + 20 * MS);
            taken++;
        } else {
            snap_refused(b, &s, err.text);
            no++;
        }
        memcpy(s.out, before.out, s.size);
        snap_must_load(b, &fresh);
    }
    print_message("# %u damaged snapshots taken, %u refused\n", taken, no);
    assert_true(taken > 20 && no > 20 / (snap_thorough() ? 1 : 4));
    crt_state_free(&s);
    crt_state_free(&before);
    crt_state_free(&fresh);
    snap_close(a);
    snap_close(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(light_goes_on_alike),
        cmocka_unit_test(a_tube_ahead_of_its_head_is_refused),
        cmocka_unit_test(epochs_that_begin_later_are_refused),
        cmocka_unit_test(forged_check_sums_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
