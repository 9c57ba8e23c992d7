/* Snapshots of the board: a copy made anywhere goes on to the same bytes at the same picoseconds,
 * and hostile bytes do no harm. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/board/uart_regs.h"
#include "tests/board/board_rig.h"

#define TICKS  40
#define PERIOD 1777 /* of mtime */

/* The main loop counts into memory; a timer handler prints a letter and sets the next alarm; a
 * receive handler echoes. After TICKS alarms the run ends. */
static void busy_program(struct code *c)
{
    li(c, A0, MAP_CLINT + CLINT_MTIMECMP);
    li(c, A2, MAP_IRQ);
    li(c, A3, MAP_UART);
    li(c, A4, MAP_PROGRAM + 0x100000);
    li(c, A5, PERIOD);
    li(c, T0, MAP_PROGRAM + 4 * 64);
    addi(c, T0, T0, 1); /* vectored */
    csrw(c, CSR_MTVEC, T0);
    sw(c, ZERO, A0, 4);
    sw(c, A5, A0, 0);
    li(c, T1, 1 << IRQ_LINE_UART);
    sw(c, T1, A2, IRQ_ENABLE);
    addi(c, T1, ZERO, FCR_ENABLE | 0x40);
    sb(c, T1, A3, UART_FCR);
    addi(c, T1, ZERO, IER_DATA);
    sb(c, T1, A3, UART_IER);
    li(c, T0, 1 << RV_INT_TIMER | 1 << RV_INT_EXTERNAL);
    csrw(c, CSR_MIE, T0);
    csrsi(c, CSR_MSTATUS, 8);
    unsigned loop = c->n;
    addi(c, S0, S0, 1);
    sw(c, S0, A4, 0);
    jump(c, loop);
    c->n = 64 + RV_INT_TIMER;
    jump(c, 96);
    c->n = 64 + RV_INT_EXTERNAL;
    jump(c, 128);
    c->n = 96;
    addi(c, A5, A5, PERIOD);
    sw(c, A5, A0, 0);
    addi(c, S1, S1, 1);
    addi(c, T2, S1, 'A' - 1);
    sb(c, T2, A3, UART_DATA);
    addi(c, TP, ZERO, TICKS);
    beq(c, S1, TP, 112);
    mret(c);
    c->n = 112;
    finish_with(c, 9);
    c->n = 128;
    lbu(c, T2, A3, UART_DATA);
    sb(c, T2, A3, UART_DATA);
    mret(c);
}

/* A byte of input every third slice or so, by the slice's number: the same for every copy. */
static void feed(struct board_rig *r, unsigned slice)
{
    uint64_t t = vm_board_now(r->b);
    if (slice % 3 == 0 && vm_uart_ready(&r->b->uart, t))
        vm_uart_receive(&r->b->uart, (uint8_t)('0' + slice % 10), t);
}

/* Slices of odd lengths, from number `slice` on; where it stopped. */
static unsigned go_on(struct board_rig *r, unsigned slice, unsigned slices)
{
    for (unsigned n = 0; n < slices && !r->b->finisher.done; n++, slice++) {
        board_run(r, vm_board_now(r->b) + 1234567 * (1 + slice % 17));
        feed(r, slice);
    }
    return slice;
}

static void copy_board(struct board_rig *to, struct board_rig *from)
{
    struct crt_state s, back, again;
    crt_state_save(&s);
    vm_board_state(from->b, &s);
    assert_false(s.failed);
    crt_state_load(&back, s.out, s.size);
    vm_board_state(to->b, &back);
    if (back.failed)
        fail_msg("%s", back.err.text);
    assert_int_equal(back.at, s.size);
    crt_state_save(&again);
    vm_board_state(to->b, &again);
    assert_int_equal(again.size, s.size);
    assert_memory_equal(again.out, s.out, s.size);
    assert_int_equal(to->b->cpu.rom_count, 1);
    assert_int_equal(to->b->cpu.rom[0].low, MAP_PROGRAM);
    crt_state_free(&s);
    crt_state_free(&again);
}

static void same_end(const struct board_rig *a, const struct board_rig *b)
{
    assert_true(a->b->finisher.done && b->b->finisher.done);
    assert_int_equal(a->b->finisher.status, b->b->finisher.status);
    assert_int_equal(a->b->finisher.t, b->b->finisher.t);
    assert_int_equal(a->b->cpu.cycle, b->b->cpu.cycle);
    assert_memory_equal(a->b->cpu.x, b->b->cpu.x, 32 * sizeof a->b->cpu.x[0]);
    assert_memory_equal(a->b->memory, b->b->memory, MAP_PROGRAM_SIZE);
    assert_int_equal(vm_board_next(a->b), vm_board_next(b->b));
}

static void goes_on(void **state)
{
    (void)state;
    struct board_rig whole, copy;
    struct code c = {{0}, 0};
    busy_program(&c);
    board_open(&whole, (struct crt_rate){VM_CPU_HZ, 1});
    board_load(&whole, &c);
    unsigned slices = go_on(&whole, 0, 10000);
    assert_int_equal(whole.b->finisher.status, 9);
    assert_in_range(whole.sent, TICKS, 256);
    assert_true(slices > 200);
    for (unsigned at = 0; at < slices; at += 1 + slices / 40) {
        struct board_rig part;
        board_open(&part, (struct crt_rate){VM_CPU_HZ, 1});
        board_open(&copy, (struct crt_rate){VM_CPU_HZ, 1});
        board_load(&part, &c);
        unsigned slice = go_on(&part, 0, at);
        copy_board(&copy, &part);
        copy.sent = part.sent;
        memcpy(copy.byte, part.byte, sizeof copy.byte);
        memcpy(copy.at, part.at, sizeof copy.at);
        go_on(&copy, slice, 10000);
        same_end(&whole, &copy);
        assert_int_equal(copy.sent, whole.sent);
        assert_memory_equal(copy.byte, whole.byte, whole.sent);
        assert_memory_equal(copy.at, whole.at, whole.sent * sizeof whole.at[0]);
        board_close(&part);
        board_close(&copy);
    }
    board_close(&whole);
}

static uint32_t random_below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}

/* One to three bytes changed, behind the pages of memory mostly: refused, or the board runs on. */
static void hostile(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    struct crt_state good;
    uint64_t seed = 11;
    int taken = 0, refused = 0;
    busy_program(&c);
    board_open(&r, (struct crt_rate){VM_CPU_HZ, 1});
    board_load(&r, &c);
    go_on(&r, 0, 50);
    crt_state_save(&good);
    vm_board_state(r.b, &good);
    assert_false(good.failed);
    uint8_t *bytes = malloc(good.size);
    assert_non_null(bytes);
    for (int round = 0; round < 400; round++) {
        struct crt_state s;
        memcpy(bytes, good.out, good.size);
        for (unsigned n = 1 + random_below(&seed, 3); n > 0; n--) {
            uint32_t most =
                random_below(&seed, 10) ? (uint32_t)good.size - 8192 : (uint32_t)good.size;
            bytes[good.size - 1 - random_below(&seed, most)] = (uint8_t)random_below(&seed, 256);
        }
        crt_state_load(&s, bytes,
                       round % 50 ? good.size : random_below(&seed, (uint32_t)good.size));
        vm_board_state(r.b, &s);
        taken += !s.failed;
        refused += s.failed;
        if (!s.failed)
            go_on(&r, 0, 5);
    }
    assert_true(taken > 20 && refused > 20);
    /* Safe to load again: the good one still goes to its end. */
    struct crt_state s;
    crt_state_load(&s, good.out, good.size);
    vm_board_state(r.b, &s);
    assert_false(s.failed);
    go_on(&r, 50, 10000);
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->finisher.status, 9);
    free(bytes);
    crt_state_free(&good);
    board_close(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_on),
        cmocka_unit_test(hostile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
