/* The board: time, the memory map, and programs of a few instructions that use every device. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/board/uart_regs.h"
#include "tests/board/board_rig.h"

#define MHZ50   ((struct crt_rate){VM_CPU_HZ, 1})
#define CYCLE   20000 /* ps, at 50 MHz */
#define MIE_ALL (1 << RV_INT_SOFTWARE | 1 << RV_INT_TIMER | 1 << RV_INT_EXTERNAL)

/* ---- time -------------------------------------------------------------------------------------------- */

static void conversions(void **state)
{
    (void)state;
    static const struct crt_rate rate[] = {{VM_CPU_HZ, 1}, {1, 1}, {3000000, 1},
                                           {33333333, 1},  {7, 3}, {CRT_PS_PER_S, 1}};
    for (unsigned i = 0; i < sizeof rate / sizeof rate[0]; i++) {
        struct board_rig r;
        board_open(&r, rate[i]);
        assert_int_equal(vm_board_time(r.b, 0), 0);
        for (uint64_t n = 1; n < 3000000000; n = n * 3 + 1) {
            uint64_t t = vm_board_time(r.b, n);
            double exact = 1e12 * (double)rate[i].den / (double)rate[i].num * (double)n;
            if (exact > 1e19)
                break;
            assert_true((double)t >= exact * (1 - 1e-15) - 1 && (double)t <= exact * (1 + 1e-15));
            assert_int_equal(vm_board_cycle(r.b, t), n);
            assert_int_equal(vm_board_cycle(r.b, t + 1), n + 1);
            assert_int_equal(vm_board_cycle(r.b, t - 1),
                             t - 1 > vm_board_time(r.b, n - 1) ? n : n - 1);
        }
        board_close(&r);
    }
}

static void short_way(void **state)
{
    (void)state;
    struct board_rig r;
    board_open(&r, MHZ50);
    assert_int_equal(r.b->period_ps, CYCLE);
    board_close(&r);
    board_open(&r, (struct crt_rate){3, 1});
    assert_int_equal(r.b->period_ps, 0);
    board_close(&r);
}

/* ---- memory map -------------------------------------------------------------------------------------- */

static bool loads(struct board_rig *r, uint32_t address, unsigned width)
{
    const struct rv_bus *bus = &r->b->cpu.desc.bus;
    uint32_t v;
    return bus->load(bus->ctx, address, width, &v);
}

static bool stores(struct board_rig *r, uint32_t address, unsigned width)
{
    const struct rv_bus *bus = &r->b->cpu.desc.bus;
    return bus->store(bus->ctx, address, width, 0);
}

static void memory_map(void **state)
{
    (void)state;
    static const struct {
        uint32_t base, size;
        unsigned width;
    } range[] = {
        {0x00100000, 0x1000, 4},  /* finisher */
        {0x02000000, 0x10000, 4}, /* CLINT */
        {0x10000000, 8, 1},       /* UART: eight registers */
        {0x40040000, 0x1000, 4},  /* interrupt controller */
    };
    struct board_rig r;
    board_open(&r, MHZ50);
    for (unsigned i = 0; i < 4; i++)
        for (unsigned width = 1; width <= 4; width *= 2) {
            bool answers = width == range[i].width;
            uint32_t last = range[i].base + range[i].size - width;
            assert_int_equal(loads(&r, range[i].base, width), answers);
            assert_int_equal(stores(&r, range[i].base, width), answers);
            assert_int_equal(loads(&r, last, width), answers);
            assert_int_equal(stores(&r, last, width), answers);
            assert_false(loads(&r, range[i].base - width, width));
            assert_false(stores(&r, range[i].base + range[i].size, width));
        }
    static const uint32_t nothing[] = {0,          0x40000000, 0x41000000, 0x42000000,
                                       0x7FFFFFFC, 0x81000000, 0xFFFFFFFC};
    for (unsigned i = 0; i < sizeof nothing / sizeof nothing[0]; i++) {
        assert_false(loads(&r, nothing[i], 4));
        assert_false(stores(&r, nothing[i], 4));
    }
    board_close(&r);
}

/* The machine adds its own. */
static bool constant_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    (void)offset;
    (void)width;
    *value = *(uint32_t *)ctx;
    return true;
}

static bool no_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    (void)ctx;
    (void)offset;
    (void)width;
    (void)value;
    return false;
}

static void added_range(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    uint32_t word = IDENTITY_KNSC;
    board_open(&r, MHZ50);
    bus_add(&r.b->bus,
            &(struct bus_range){MAP_IDENTITY, 4, BUS_32, &word, constant_read, no_write});
    li(&c, A0, MAP_IDENTITY);
    lw(&c, A1, A0, 0);
    sw(&c, A1, A0, 0); /* faults: nobody handles it */
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_MS);
    assert_int_equal(r.b->cpu.x[A1], IDENTITY_KNSC);
    assert_int_equal(r.b->cpu.state, RV_HALTED);
    assert_int_equal(r.b->cpu.trouble.cause, RV_STORE_FAULT);
    assert_int_equal(r.b->cpu.trouble.value, MAP_IDENTITY);
    board_close(&r);
}

/* ---- programs ---------------------------------------------------------------------------------------- */

static void finish(struct code *c)
{
    li(c, T0, MAP_FINISHER);
    li(c, T1, FINISHER_PASS);
    sw(c, T1, T0, 0);
    jump(c, c->n);
}

/* The run ends with the very instruction. */
static void exit_status(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    finish_with(&c, 42);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_S);
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->finisher.status, 42);
    assert_int_equal(r.b->finisher.t, 4 * CYCLE);
    assert_int_equal(r.b->cpu.cycle, 5);
    board_close(&r);
}

/* Asks for an interrupt at mtime = 100, sleeps; the handler reads cycle, time and cause, then ends.
 * 10 µs are 500 cycles: the first cycle that may begin after the event. The slice that the store to
 * mtimecmp ends had no limit, so an event moved closer must have ended it. */
static void timer(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A0, MAP_CLINT + CLINT_MTIMECMP);
    li(&c, A1, 100);
    sw(&c, ZERO, A0, 4);
    sw(&c, A1, A0, 0);
    li(&c, T0, MAP_PROGRAM + 4 * 32);
    csrw(&c, CSR_MTVEC, T0);
    li(&c, T0, 1 << RV_INT_TIMER);
    csrw(&c, CSR_MIE, T0);
    csrsi(&c, CSR_MSTATUS, 8);
    wfi(&c);
    unsigned after = c.n;
    jump(&c, c.n);
    c.n = 32;
    csrr(&c, S0, CSR_MCYCLE);
    csrr(&c, S1, CSR_TIME);
    csrr(&c, A2, CSR_MCAUSE);
    csrr(&c, A3, CSR_MEPC);
    finish(&c);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_S);
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->finisher.status, 0);
    assert_int_equal(r.b->cpu.x[S0], 500);
    assert_int_equal(r.b->cpu.x[S1], 100);
    assert_int_equal(r.b->cpu.x[A2], 0x80000000u | RV_INT_TIMER);
    assert_int_equal(r.b->cpu.x[A3], MAP_PROGRAM + 4 * after);
    board_close(&r);
}

/* The same while the processor is busy: the interrupt comes between two instructions of a loop of
 * two, in the cycle that begins with the event. */
static void timer_while_busy(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A0, MAP_CLINT + CLINT_MTIMECMP);
    li(&c, A1, 1000);
    sw(&c, A1, A0, 0);
    sw(&c, ZERO, A0, 4);
    li(&c, T0, MAP_PROGRAM + 4 * 32);
    csrw(&c, CSR_MTVEC, T0);
    li(&c, T0, 1 << RV_INT_TIMER);
    csrw(&c, CSR_MIE, T0);
    csrsi(&c, CSR_MSTATUS, 8);
    addi(&c, S0, S0, 1);
    jump(&c, c.n - 1);
    unsigned before = 13; /* instructions up to the loop */
    c.n = 32;
    csrr(&c, S1, CSR_MCYCLE);
    finish(&c);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_S);
    assert_int_equal(r.b->cpu.x[S1], 5000);
    assert_int_equal(r.b->cpu.x[S0], (5000 - before + 1) / 2);
    board_close(&r);
}

/* External before software before timer. */
static void three_interrupts(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A0, MAP_CLINT);
    li(&c, A1, MAP_CLINT + CLINT_MTIMECMP);
    li(&c, A2, MAP_IRQ);
    li(&c, A3, MAP_UART);
    li(&c, T0, MAP_PROGRAM + 4 * 64);
    addi(&c, T0, T0, 1); /* vectored */
    csrw(&c, CSR_MTVEC, T0);
    addi(&c, T1, ZERO, 1);
    sw(&c, T1, A0, 0);   /* msip */
    sw(&c, ZERO, A1, 4); /* mtimecmp = 0…: at once */
    sw(&c, ZERO, A1, 0);
    li(&c, T1, 1 << IRQ_LINE_UART);
    sw(&c, T1, A2, IRQ_ENABLE);
    addi(&c, T1, ZERO, IER_THR);
    sb(&c, T1, A3, UART_IER); /* empty: interrupts at once */
    li(&c, T0, MIE_ALL);
    csrw(&c, CSR_MIE, T0);
    csrsi(&c, CSR_MSTATUS, 8);
    jump(&c, c.n);
    /* Each handler quiets its source and adds its digit. */
    c.n = 64 + RV_INT_SOFTWARE;
    jump(&c, 96);
    c.n = 64 + RV_INT_TIMER;
    jump(&c, 112);
    c.n = 64 + RV_INT_EXTERNAL;
    jump(&c, 128);
    c.n = 96;
    sw(&c, ZERO, A0, 0);
    emit(&c, 0x00441413); /* slli s0, s0, 4 */
    addi(&c, S0, S0, 2);
    mret(&c);
    c.n = 112;
    emit(&c, 0x00441413);
    addi(&c, S0, S0, 3);
    finish(&c);
    c.n = 128;
    lw(&c, S1, A2, IRQ_CLAIM);
    lbu(&c, T1, A3, UART_IIR);
    emit(&c, 0x00441413);
    addi(&c, S0, S0, 1);
    mret(&c);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_S);
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->cpu.x[S0], 0x123);
    assert_int_equal(r.b->cpu.x[S1], IRQ_LINE_UART);
    board_close(&r);
}

/* Prints by polling, as the simplest programs do; the run lasts as long as the line needs. */
static void print(void **state)
{
    (void)state;
    static const char text[] = "hi\n";
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A3, MAP_UART);
    for (const char *p = text; *p; p++) {
        unsigned wait = c.n;
        lbu(&c, T0, A3, UART_LSR);
        andi(&c, T0, T0, LSR_THR_EMPTY);
        beq(&c, T0, ZERO, wait);
        addi(&c, T1, ZERO, *p);
        sb(&c, T1, A3, UART_DATA);
    }
    unsigned wait = c.n;
    lbu(&c, T0, A3, UART_LSR);
    andi(&c, T0, T0, LSR_EMPTY);
    beq(&c, T0, ZERO, wait);
    finish(&c);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_S);
    assert_int_equal(r.sent, 3);
    assert_memory_equal(r.byte, text, 3);
    /* Start bit at once or a clock of 271 ns later, then 31 bits of 8.68 µs. */
    uint64_t bit = CRT_PS_PER_S / 115200;
    assert_in_range(r.at[2], 31 * bit, 31 * bit + 2 * 271300);
    assert_in_range(r.b->finisher.t, r.at[2], r.at[2] + 20 * CYCLE);
    board_close(&r);
}

static void echo_program(struct code *c)
{
    li(c, A2, MAP_IRQ);
    li(c, A3, MAP_UART);
    li(c, T0, MAP_PROGRAM + 4 * 32);
    csrw(c, CSR_MTVEC, T0);
    li(c, T1, 1 << IRQ_LINE_UART);
    sw(c, T1, A2, IRQ_ENABLE);
    addi(c, T1, ZERO, IER_DATA);
    sb(c, T1, A3, UART_IER);
    li(c, T0, 1 << RV_INT_EXTERNAL);
    csrw(c, CSR_MIE, T0);
    csrsi(c, CSR_MSTATUS, 8);
    wfi(c);
    jump(c, c->n - 1);
    c->n = 32;
    lw(c, S1, A2, IRQ_CLAIM);
    lbu(c, T0, A3, UART_DATA);
    addi(c, T1, ZERO, 'q');
    beq(c, T0, T1, 48);
    sb(c, T0, A3, UART_DATA);
    addi(c, S0, S0, 1);
    mret(c);
    c->n = 48;
    finish_with(c, 7);
}

/* Offers the next byte of `input` as soon as the receiver takes it. */
static void feed(struct board_rig *r, const char **input)
{
    uint64_t t = vm_board_now(r->b);
    if (**input && vm_uart_ready(&r->b->uart, t))
        vm_uart_receive(&r->b->uart, (uint8_t) * (*input)++, t);
}

/* An echo by receive interrupts, asleep in between. */
static void echo(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    const char *input = "abcdefq";
    board_open(&r, MHZ50);
    echo_program(&c);
    board_load(&r, &c);
    for (uint64_t t = 0; t < CRT_PS_PER_S && !r.b->finisher.done; t += CRT_PS_PER_US) {
        board_run(&r, t);
        feed(&r, &input);
    }
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->finisher.status, 7);
    assert_int_equal(r.b->cpu.x[S0], 6);
    assert_int_equal(r.b->cpu.x[S1], IRQ_LINE_UART);
    assert_int_equal(r.sent, 5); /* the sixth is still on its way */
    assert_memory_equal(r.byte, "abcde", 5);
    /* A byte every byte time: that is what the receiver takes. */
    assert_in_range(r.at[4] - r.at[0], 4 * 86 * CRT_PS_PER_US, 4 * 89 * CRT_PS_PER_US);
    board_close(&r);
}

/* ---- loading ----------------------------------------------------------------------------------------- */

static void read_only_text(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A0, MAP_PROGRAM + 0x100000);
    sw(&c, A0, A0, 0); /* data: fine */
    li(&c, A1, MAP_PROGRAM);
    sw(&c, A0, A1, 0); /* text: faults */
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_MS);
    assert_int_equal(r.b->cpu.state, RV_HALTED);
    assert_int_equal(r.b->cpu.trouble.cause, RV_STORE_FAULT);
    assert_int_equal(r.b->cpu.trouble.value, MAP_PROGRAM);
    assert_int_equal(r.b->cpu.trouble.pc, MAP_PROGRAM + 4 * 5);
    /* Another program is not protected by this one's segments, nor does it see its memory. */
    const struct vm_elf_segment data = {
        MAP_PROGRAM + 0x2000, (const uint8_t *)"\0", 1, 1, true, true};
    struct vm_elf elf = {.segment = {data}, .segments = 1, .entry = MAP_PROGRAM + 0x2000};
    uint64_t retired = rv_retired(&r.b->cpu);
    vm_board_load(r.b, &elf, CRT_PS_PER_MS);
    assert_int_equal(r.b->cpu.state, RV_RUNNING);
    assert_int_equal(r.b->cpu.rom_count, 0);
    assert_int_equal(r.b->cpu.pc, MAP_PROGRAM + 0x2000);
    assert_int_equal(r.b->cpu.cycle, vm_board_cycle(r.b, CRT_PS_PER_MS));
    assert_int_equal(rv_retired(&r.b->cpu), retired);
    for (uint32_t i = 0; i < MAP_PROGRAM_SIZE; i++)
        if (r.b->memory[i] != 0)
            fail_msg("memory[%u] is not 0", i);
    board_close(&r);
}

/* Loading is power-on for the devices too. */
static void load_resets(void **state)
{
    (void)state;
    struct board_rig r;
    struct code c = {{0}, 0};
    board_open(&r, MHZ50);
    li(&c, A1, MAP_CLINT + CLINT_MTIMECMP);
    sw(&c, ZERO, A1, 0);
    sw(&c, ZERO, A1, 4);
    li(&c, A2, MAP_IRQ);
    li(&c, T1, 0x1FE);
    sw(&c, T1, A2, IRQ_ENABLE);
    li(&c, A3, MAP_UART);
    addi(&c, T1, ZERO, IER_THR);
    sb(&c, T1, A3, UART_IER);
    finish(&c);
    board_load(&r, &c);
    board_run(&r, CRT_PS_PER_MS);
    assert_true(r.b->finisher.done);
    assert_int_equal(r.b->cpu.mip, 1 << RV_INT_TIMER | 1 << RV_INT_EXTERNAL);
    board_load(&r, &c);
    assert_false(r.b->finisher.done);
    assert_int_equal(r.b->cpu.mip, 0);
    assert_int_equal(r.b->irq.enable | r.b->irq.pending, 0);
    assert_int_equal(vm_board_next(r.b), UINT64_MAX);
    board_close(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(conversions),
        cmocka_unit_test(short_way),
        cmocka_unit_test(memory_map),
        cmocka_unit_test(added_range),
        cmocka_unit_test(exit_status),
        cmocka_unit_test(timer),
        cmocka_unit_test(timer_while_busy),
        cmocka_unit_test(three_interrupts),
        cmocka_unit_test(print),
        cmocka_unit_test(echo),
        cmocka_unit_test(read_only_text),
        cmocka_unit_test(load_resets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
