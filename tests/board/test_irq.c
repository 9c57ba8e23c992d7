/* The interrupt controller: lines, enable, claim, the wire to the processor. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"
#include "emu/board/irq.h"
#include "emu/memmap.h"
#include "tests/board/wires.h"

static void begin(struct vm_irq *q, struct listener *out)
{
    *out = (struct listener){0};
    vm_irq_init(q, &(struct vm_irq_desc){{out, listen}});
}

static uint32_t get(struct vm_irq *q, uint32_t offset)
{
    uint32_t v = 0xDEAD;
    assert_true(vm_irq_read(q, offset, &v, 0));
    return v;
}

static void set(struct vm_irq *q, uint32_t offset, uint32_t value, uint64_t t)
{
    assert_true(vm_irq_write(q, offset, value, t));
}

static void power_on(void **state)
{
    (void)state;
    struct vm_irq q;
    struct listener out;
    begin(&q, &out);
    for (uint32_t offset = 0; offset < MAP_IRQ_SIZE; offset += 4)
        assert_int_equal(get(&q, offset), 0);
    assert_int_equal(out.changes, 0);
}

/* A line shows as pending, enabled or not; only an enabled one interrupts; claiming it quiets
 * nothing. */
static void one_line(void **state)
{
    (void)state;
    struct vm_irq q;
    struct listener out;
    for (unsigned line = 1; line < IRQ_LINES; line++) {
        begin(&q, &out);
        vm_irq_set(&q, line, true, 10);
        assert_int_equal(get(&q, IRQ_PENDING), 1u << line);
        assert_int_equal(get(&q, IRQ_CLAIM), 0);
        assert_false(out.level);
        set(&q, IRQ_ENABLE, 1u << line, 20);
        assert_true(out.level);
        assert_int_equal(out.t, 20);
        assert_int_equal(get(&q, IRQ_CLAIM), line);
        assert_int_equal(get(&q, IRQ_CLAIM), line);
        assert_int_equal(get(&q, IRQ_PENDING), 1u << line);
        vm_irq_set(&q, line, false, 30);
        assert_false(out.level);
        assert_int_equal(out.t, 30);
        assert_int_equal(get(&q, IRQ_CLAIM), 0);
        assert_int_equal(out.changes, 2);
    }
}

/* Every combination of lines and enables. */
static void all_combinations(void **state)
{
    (void)state;
    struct vm_irq q;
    struct listener out;
    begin(&q, &out);
    for (uint32_t lines = 0; lines < 256; lines++)
        for (uint32_t enable = 0; enable < 256; enable++) {
            uint32_t claim = 0;
            for (unsigned i = 0; i < 8; i++) {
                vm_irq_set(&q, i + 1, lines >> i & 1, 1);
                if (claim == 0 && (lines & enable) >> i & 1)
                    claim = i + 1;
            }
            set(&q, IRQ_ENABLE, enable << 1, 1);
            assert_int_equal(get(&q, IRQ_PENDING), lines << 1);
            assert_int_equal(get(&q, IRQ_ENABLE), enable << 1);
            assert_int_equal(get(&q, IRQ_CLAIM), claim);
            assert_int_equal(out.level, (lines & enable) != 0);
        }
}

/* Bits of lines that are none stay 0; pending and claim cannot be written. */
static void writes(void **state)
{
    (void)state;
    struct vm_irq q;
    struct listener out;
    begin(&q, &out);
    set(&q, IRQ_ENABLE, 0xFFFFFFFF, 0);
    assert_int_equal(get(&q, IRQ_ENABLE), 0x1FE);
    for (uint32_t offset = 0; offset < 0x20; offset += 4)
        if (offset != IRQ_ENABLE)
            set(&q, offset, 0xFFFFFFFF, 0);
    assert_int_equal(get(&q, IRQ_PENDING), 0);
    assert_int_equal(get(&q, IRQ_ENABLE), 0x1FE);
    assert_int_equal(out.changes, 0);
}

static void reset_keeps_lines(void **state)
{
    (void)state;
    struct vm_irq q;
    struct listener out;
    begin(&q, &out);
    vm_irq_set(&q, 3, true, 0);
    set(&q, IRQ_ENABLE, 8, 0);
    vm_irq_reset(&q, 5);
    assert_false(out.level);
    assert_int_equal(out.t, 5);
    assert_int_equal(get(&q, IRQ_PENDING), 8);
    assert_int_equal(get(&q, IRQ_ENABLE), 0);
}

static bool load(struct vm_irq *q, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    vm_irq_state(q, &s);
    return !s.failed;
}

static void snapshot(void **state)
{
    (void)state;
    struct vm_irq q, again;
    struct listener out, out_again;
    struct crt_state s;
    begin(&q, &out);
    begin(&again, &out_again);
    vm_irq_set(&q, 8, true, 0);
    vm_irq_set(&q, 2, true, 0);
    set(&q, IRQ_ENABLE, 0x104, 0);
    crt_state_save(&s);
    vm_irq_state(&q, &s);
    assert_false(s.failed);
    assert_true(load(&again, s.out, s.size));
    assert_int_equal(get(&again, IRQ_PENDING), 0x104);
    assert_int_equal(get(&again, IRQ_ENABLE), 0x104);
    assert_true(again.level);
    /* Sixteen bytes of header, pending, enable, level: each made impossible in turn. */
    s.out[16] |= 1;
    assert_false(load(&again, s.out, s.size));
    s.out[16] &= 0xFE;
    s.out[22] = 1;
    assert_false(load(&again, s.out, s.size));
    s.out[22] = 0;
    s.out[24] = 0;
    assert_false(load(&again, s.out, s.size));
    s.out[24] = 1;
    assert_true(load(&again, s.out, s.size));
    crt_state_free(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(power_on),          cmocka_unit_test(one_line),
        cmocka_unit_test(all_combinations),  cmocka_unit_test(writes),
        cmocka_unit_test(reset_keeps_lines), cmocka_unit_test(snapshot),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
