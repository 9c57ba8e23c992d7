/* The test finisher: what ends a run, and with which status. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"
#include "emu/board/finisher.h"
#include "emu/memmap.h"

struct end {
    unsigned calls;
    uint8_t status;
    uint64_t t;
};

static void finished(void *ctx, uint8_t status, uint64_t t)
{
    struct end *end = ctx;
    *end = (struct end){end->calls + 1, status, t};
}

/* Stores one value; the exit status, -1 when the run goes on. */
static int status_of(uint32_t offset, uint32_t value)
{
    struct vm_finisher f;
    struct end end = {0};
    vm_finisher_init(&f, &(struct vm_finisher_desc){&end, finished});
    assert_false(f.done);
    assert_true(vm_finisher_write(&f, offset, value, 123));
    assert_int_equal(end.calls, f.done);
    if (f.done) {
        assert_int_equal(end.status, f.status);
        assert_int_equal(end.t, 123);
        assert_int_equal(f.t, 123);
    }
    return f.done ? f.status : -1;
}

static void pass(void **state)
{
    (void)state;
    assert_int_equal(status_of(0, FINISHER_PASS), 0);
    assert_int_equal(status_of(0, 0x00075555), 0);
}

static void failures(void **state)
{
    (void)state;
    for (uint32_t code = 0; code < 0x10000; code++) {
        int expected = code % 256 ? (int)(code % 256) : 255;
        assert_int_equal(status_of(0, code << 16 | FINISHER_FAIL), expected);
    }
}

/* All other low halves, QEMU's reset among them, and all other offsets. */
static void nothing(void **state)
{
    (void)state;
    for (uint32_t low = 0; low < 0x10000; low++)
        if (low != FINISHER_PASS && low != FINISHER_FAIL)
            assert_int_equal(status_of(0, 0x00010000 | low), -1);
    assert_int_equal(status_of(0, 0x7777), -1);
    for (uint32_t offset = 4; offset < MAP_FINISHER_SIZE; offset += 4)
        assert_int_equal(status_of(offset, FINISHER_PASS), -1);
}

static void first_counts(void **state)
{
    (void)state;
    struct vm_finisher f;
    struct end end = {0};
    uint32_t v = 1;
    vm_finisher_init(&f, &(struct vm_finisher_desc){&end, finished});
    vm_finisher_write(&f, 0, 3u << 16 | FINISHER_FAIL, 5);
    vm_finisher_write(&f, 0, FINISHER_PASS, 6);
    assert_int_equal(end.calls, 1);
    assert_int_equal(f.status, 3);
    assert_int_equal(f.t, 5);
    assert_true(vm_finisher_read(&f, 0, &v, 7));
    assert_int_equal(v, 0);
    vm_finisher_reset(&f);
    assert_false(f.done);
    vm_finisher_write(&f, 0, FINISHER_PASS, 8);
    assert_int_equal(end.calls, 2);
    assert_int_equal(end.status, 0);
}

static bool load(struct vm_finisher *f, const struct crt_state *saved)
{
    struct crt_state s;
    crt_state_load(&s, saved->out, saved->size);
    vm_finisher_state(f, &s);
    return !s.failed;
}

static void snapshot(void **state)
{
    (void)state;
    struct vm_finisher f, again;
    struct crt_state s;
    vm_finisher_init(&f, &(struct vm_finisher_desc){NULL, NULL});
    again = f;
    vm_finisher_write(&f, 0, 3u << 16 | FINISHER_FAIL, UINT64_C(0x123456789A));
    crt_state_save(&s);
    vm_finisher_state(&f, &s);
    assert_true(load(&again, &s));
    assert_true(again.done);
    assert_int_equal(again.status, 3);
    assert_int_equal(again.t, UINT64_C(0x123456789A));
    s.out[16] = 0; /* not done, and yet a status */
    assert_false(load(&again, &s));
    s.out[16] = 2;
    assert_false(load(&again, &s));
    crt_state_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pass),         cmocka_unit_test(failures), cmocka_unit_test(nothing),
        cmocka_unit_test(first_counts), cmocka_unit_test(snapshot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
