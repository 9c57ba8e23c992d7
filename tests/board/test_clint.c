/* The CLINT: mtime's exact rate, the comparison, when the timer line changes, snapshots. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"
#include "emu/board/clint.h"
#include "emu/memmap.h"
#include "tests/board/wires.h"

#define TICK UINT64_C(100000) /* ps */

struct rig {
    struct vm_clint c;
    struct listener timer, software;
};

static void begin(struct rig *r)
{
    memset(r, 0, sizeof *r);
    vm_clint_init(&r->c, &(struct vm_clint_desc){{&r->timer, listen}, {&r->software, listen}});
}

static uint32_t get(struct rig *r, uint32_t offset, uint64_t t)
{
    uint32_t v = 0xDEAD;
    assert_true(vm_clint_read(&r->c, offset, &v, t));
    return v;
}

static void set(struct rig *r, uint32_t offset, uint32_t value, uint64_t t)
{
    assert_true(vm_clint_write(&r->c, offset, value, t));
}

static uint64_t get64(struct rig *r, uint32_t offset, uint64_t t)
{
    return get(r, offset, t) | (uint64_t)get(r, offset + 4, t) << 32;
}

static void set64(struct rig *r, uint32_t offset, uint64_t value, uint64_t t)
{
    set(r, offset, (uint32_t)value, t);
    set(r, offset + 4, (uint32_t)(value >> 32), t);
}

static void power_on(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    assert_int_equal(get64(&r, CLINT_MTIMECMP, 0), UINT64_MAX);
    assert_int_equal(get64(&r, CLINT_MTIME, 0), 0);
    assert_int_equal(get(&r, CLINT_MSIP, 0), 0);
    assert_int_equal(vm_clint_next(&r.c), UINT64_MAX);
    assert_int_equal(r.timer.changes + r.software.changes, 0);
}

static void rate(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    assert_int_equal(get64(&r, CLINT_MTIME, TICK - 1), 0);
    assert_int_equal(get64(&r, CLINT_MTIME, TICK), 1);
    assert_int_equal(get64(&r, CLINT_MTIME, 1000000000000), CLINT_HZ);
    assert_int_equal(get64(&r, CLINT_MTIME, UINT64_MAX), UINT64_MAX / TICK);
}

static void software(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    set(&r, CLINT_MSIP, 0xFFFFFFFF, 7);
    assert_true(r.software.level);
    assert_int_equal(r.software.t, 7);
    assert_int_equal(get(&r, CLINT_MSIP, 7), 1);
    set(&r, CLINT_MSIP, 1, 8);
    set(&r, CLINT_MSIP, 2, 9);
    assert_false(r.software.level);
    assert_int_equal(r.software.changes, 2);
}

/* The line rises exactly at the beginning of the tick, falls when mtimecmp moves away. */
static void alarm_clock(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    set64(&r, CLINT_MTIMECMP, 1000, 5 * TICK + 3);
    assert_int_equal(vm_clint_next(&r.c), 1000 * TICK);
    vm_clint_event(&r.c, 1000 * TICK - 1);
    assert_false(r.timer.level);
    vm_clint_event(&r.c, 1000 * TICK);
    assert_true(r.timer.level);
    assert_int_equal(r.timer.t, 1000 * TICK);
    assert_int_equal(vm_clint_next(&r.c), UINT64_MAX);
    set64(&r, CLINT_MTIMECMP, 2000, 1500 * TICK);
    assert_false(r.timer.level);
    assert_int_equal(vm_clint_next(&r.c), 2000 * TICK);
    set64(&r, CLINT_MTIMECMP, 1500, 1500 * TICK);
    assert_true(r.timer.level);
    set64(&r, CLINT_MTIMECMP, UINT64_MAX, 1500 * TICK);
    assert_false(r.timer.level);
    assert_int_equal(vm_clint_next(&r.c), UINT64_MAX);
}

/* The order of the manual for RV32 — low word all ones, high word, low word — never interrupts in
 * between. */
static void halves(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    set64(&r, CLINT_MTIMECMP, 0x00000001FFFFFFF0, 0);
    set64(&r, CLINT_MTIME, 0x00000001FFFFFF00, 0);
    unsigned before = r.timer.changes;
    set(&r, CLINT_MTIMECMP, 0xFFFFFFFF, 0);
    set(&r, CLINT_MTIMECMP + 4, 2, 0);
    set(&r, CLINT_MTIMECMP, 5, 0);
    assert_int_equal(r.timer.changes, before);
    assert_int_equal(vm_clint_next(&r.c), (0x105) * TICK);
    /* The careless order does. */
    set64(&r, CLINT_MTIMECMP, 0x00000001FFFFFFF0, 0);
    set(&r, CLINT_MTIMECMP, 5, 0);
    assert_true(r.timer.level);
}

static void writable_time(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    set64(&r, CLINT_MTIMECMP, 100, 0);
    set64(&r, CLINT_MTIME, 90, 5 * TICK + 7);
    assert_int_equal(get64(&r, CLINT_MTIME, 6 * TICK - 1), 90);
    assert_int_equal(get64(&r, CLINT_MTIME, 6 * TICK), 91);
    assert_int_equal(vm_clint_time(&r.c, 6 * TICK), 91);
    assert_int_equal(vm_clint_next(&r.c), 15 * TICK);
    set64(&r, CLINT_MTIME, 200, 6 * TICK);
    assert_true(r.timer.level);
    vm_clint_reset(&r.c, 20 * TICK);
    assert_false(r.timer.level);
    assert_int_equal(get64(&r, CLINT_MTIME, 20 * TICK), 20);
}

/* mtime runs over: a line that was high falls. */
static void wrap(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    set64(&r, CLINT_MTIMECMP, 50, 0);
    set64(&r, CLINT_MTIME, UINT64_MAX - 9, 0);
    assert_true(r.timer.level);
    assert_int_equal(vm_clint_next(&r.c), 10 * TICK);
    vm_clint_event(&r.c, 10 * TICK);
    assert_false(r.timer.level);
    assert_int_equal(get64(&r, CLINT_MTIME, 10 * TICK), 0);
    assert_int_equal(vm_clint_next(&r.c), 60 * TICK);
    set64(&r, CLINT_MTIMECMP, 0, 11 * TICK); /* 0: always */
    assert_int_equal(vm_clint_next(&r.c), UINT64_MAX);
}

static void other_registers(void **state)
{
    (void)state;
    struct rig r;
    begin(&r);
    for (uint32_t offset = 0; offset < MAP_CLINT_SIZE; offset += 4) {
        uint32_t base = offset & ~4u;
        if (offset == CLINT_MSIP || base == CLINT_MTIMECMP || base == CLINT_MTIME)
            continue;
        set(&r, offset, 0xFFFFFFFF, 0);
        assert_int_equal(get(&r, offset, 0), 0);
    }
    assert_int_equal(r.timer.changes + r.software.changes, 0);
}

static uint64_t random64(uint64_t *seed)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (*seed >> 33) | (*seed >> 33) << 31 | (*seed & 3) << 62;
}

/* Values where something happens: near now, near the ends, anywhere. */
static uint64_t awkward(uint64_t *seed, uint64_t now)
{
    uint64_t r = random64(seed);
    switch (r & 7) {
    case 0:
        return r >> 3 & 15;
    case 1:
        return UINT64_MAX - (r >> 3 & 15);
    case 2:
        return UINT64_C(0xFFFFFFFF) + (r >> 3 & 3);
    case 3:
        return r;
    default:
        return now + (r >> 3 & 31) - 8;
    }
}

/* Random writes against the definition: the line is mtime >= mtimecmp whenever one looks, and
 * vm_clint_next names the very picosecond at which that changes. */
static void definition(void **state)
{
    (void)state;
    uint64_t seed = 7;
    for (int round = 0; round < 2000; round++) {
        struct rig r;
        uint64_t t = random64(&seed) >> (round % 40), mtime_then = 0, written_at = 0,
                 cmp = UINT64_MAX;
        begin(&r);
        for (int step = 0; step < 30; step++) {
            uint64_t mtime = mtime_then + (t / TICK - written_at / TICK);
            vm_clint_event(&r.c, t);
            assert_int_equal(get64(&r, CLINT_MTIME, t), mtime);
            assert_int_equal(r.timer.level, mtime >= cmp);
            uint64_t next = vm_clint_next(&r.c);
            assert_true(next > t);
            if (next != UINT64_MAX) {
                uint64_t then = mtime_then + (next / TICK - written_at / TICK);
                uint64_t before = mtime_then + ((next - 1) / TICK - written_at / TICK);
                assert_int_equal(before >= cmp, r.timer.level);
                assert_int_not_equal(then >= cmp, r.timer.level);
            }
            uint64_t what = random64(&seed);
            if (what % 3 == 0) {
                cmp = awkward(&seed, mtime);
                set64(&r, CLINT_MTIMECMP, cmp, t);
            } else if (what % 3 == 1) {
                mtime_then = awkward(&seed, cmp);
                written_at = t;
                set64(&r, CLINT_MTIME, mtime_then, t);
            } else if (next != UINT64_MAX && next - t < 64 * TICK) {
                t = next - (what >> 8 & 1);
            } else if (t < UINT64_MAX / 2) {
                t += what >> 40;
            }
        }
    }
}

static bool load(struct rig *r, const struct crt_state *saved)
{
    struct crt_state s;
    crt_state_load(&s, saved->out, saved->size);
    vm_clint_state(&r->c, &s);
    return !s.failed;
}

static void snapshot(void **state)
{
    (void)state;
    struct rig r, again;
    struct crt_state s;
    begin(&r);
    begin(&again);
    set64(&r, CLINT_MTIMECMP, 0x123456789, 5 * TICK);
    set64(&r, CLINT_MTIME, 0x123456700, 5 * TICK);
    set(&r, CLINT_MSIP, 1, 6 * TICK);
    crt_state_save(&s);
    vm_clint_state(&r.c, &s);
    assert_true(load(&again, &s));
    assert_int_equal(get64(&again, CLINT_MTIMECMP, 7 * TICK), 0x123456789);
    assert_int_equal(get64(&again, CLINT_MTIME, 7 * TICK), 0x123456702);
    assert_int_equal(get(&again, CLINT_MSIP, 7 * TICK), 1);
    assert_int_equal(vm_clint_next(&again.c), vm_clint_next(&r.c));
    s.out[32]++; /* the next change: at a time at which nothing changes */
    assert_false(load(&again, &s));
    s.out[32]--;
    s.out[40] = 1; /* the level: already high */
    assert_false(load(&again, &s));
    crt_state_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(power_on),   cmocka_unit_test(rate),
        cmocka_unit_test(software),   cmocka_unit_test(alarm_clock),
        cmocka_unit_test(halves),     cmocka_unit_test(writable_time),
        cmocka_unit_test(wrap),       cmocka_unit_test(other_registers),
        cmocka_unit_test(definition), cmocka_unit_test(snapshot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
