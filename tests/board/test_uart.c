/* The UART, register by register: sending, receiving, interrupts, loopback, snapshots. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/state.h"
#include "tests/board/uart_rig.h"

#define BIT  32         /* clocks at 115200 baud */
#define BYTE (10 * BIT) /* 8 bits, no parity, 1 stop bit */

static void power_on(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    assert_int_equal(rig_get(&r, UART_DATA, 0), 0);
    assert_int_equal(rig_get(&r, UART_IER, 0), 0);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_NONE);
    assert_int_equal(rig_get(&r, UART_LCR, 0), 3);
    assert_int_equal(rig_get(&r, UART_MCR, 0), 0);
    assert_int_equal(rig_get(&r, UART_LSR, 0), LSR_THR_EMPTY | LSR_EMPTY);
    assert_int_equal(rig_get(&r, UART_MSR, 0), MSR_CTS | MSR_DSR | MSR_DCD);
    assert_int_equal(rig_get(&r, UART_SCR, 0), 0);
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    assert_true(vm_uart_ready(&r.u, 0));
    uint32_t v;
    assert_false(vm_uart_read(&r.u, UART_REGISTERS, &v, 0));
    assert_false(vm_uart_write(&r.u, UART_REGISTERS, 0, 0));
}

static void writable_bits(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    for (unsigned v = 0; v < 256; v++) {
        rig_set(&r, UART_SCR, v, 0);
        assert_int_equal(rig_get(&r, UART_SCR, 0), v);
        rig_set(&r, UART_LCR, v, 0);
        assert_int_equal(rig_get(&r, UART_LCR, 0), v);
        rig_set(&r, UART_LCR, 3, 0);
        rig_set(&r, UART_MCR, v, 0);
        assert_int_equal(rig_get(&r, UART_MCR, 0), v & 0x1F);
        rig_set(&r, UART_IER, v, 0);
        assert_int_equal(rig_get(&r, UART_IER, 0), v & 0x0F);
    }
    rig_set(&r, UART_IER, 0, 0);
    rig_set(&r, UART_LSR, 0xFF, 0);
    rig_set(&r, UART_MSR, 0xFF, 0);
    assert_int_equal(rig_get(&r, UART_LSR, 0), LSR_THR_EMPTY | LSR_EMPTY);
    rig_set(&r, UART_LCR, LCR_DLAB, 0);
    assert_int_equal(rig_get(&r, UART_DATA, 0), 2);
    assert_int_equal(rig_get(&r, UART_IER, 0), 0);
    rig_set(&r, UART_DATA, 0x34, 0);
    rig_set(&r, UART_IER, 0x12, 0);
    assert_int_equal(rig_get(&r, UART_DATA, 0), 0x34);
    assert_int_equal(rig_get(&r, UART_IER, 0), 0x12);
    rig_set(&r, UART_LCR, 3, 0);
    assert_int_equal(rig_get(&r, UART_IER, 0), 0);
    assert_int_equal(r.sent, 0);
}

/* One bit of waiting, then start bit, data and stop bit; the holding register is free after the
 * first, the shift register after the last. */
static void one_byte(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_DATA, 'A', clocks(100));
    assert_int_equal(rig_get(&r, UART_LSR, clocks(100)), 0);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(100 + BIT) - 1), 0);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(100 + BIT)), LSR_THR_EMPTY);
    assert_int_equal(vm_uart_next(&r.u), clocks(100 + BIT + BYTE));
    vm_uart_event(&r.u, clocks(100 + BIT + BYTE) - 1);
    assert_int_equal(r.sent, 0);
    vm_uart_event(&r.u, clocks(100 + BIT + BYTE));
    assert_int_equal(r.sent, 1);
    assert_int_equal(r.byte[0], 'A');
    assert_int_equal(r.at[0], clocks(100 + BIT + BYTE));
    assert_int_equal(rig_get(&r, UART_LSR, r.at[0]), LSR_THR_EMPTY | LSR_EMPTY);
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    /* A write between two clocks counts from the later one. */
    rig_set(&r, UART_DATA, 'B', clocks(1000) + 1);
    vm_uart_event(&r.u, UINT64_MAX - 1);
    assert_int_equal(r.at[1], clocks(1001 + BIT + BYTE));
}

/* A program that polls THRE keeps the line busy: bytes follow without a gap, and a thousand of
 * them take a thousand byte times to the picosecond, 1 s · 10 000 / 115 200. */
static void no_gap(void **state)
{
    (void)state;
    struct uart_rig r;
    uint64_t t = 0;
    rig_begin(&r);
    for (unsigned n = 0; n < 1000; n++) {
        while (!(rig_get(&r, UART_LSR, t) & LSR_THR_EMPTY))
            t = vm_uart_next(&r.u);
        rig_set(&r, UART_DATA, n, t);
    }
    vm_uart_event(&r.u, UINT64_MAX - 1);
    assert_int_equal(r.sent, 1000);
    uint64_t whole = r.at[999 % 256] - clocks(BIT);
    uint64_t exact = UINT64_C(10000) * CRT_PS_PER_S / 115200;
    assert_in_range(whole, exact - 1, exact + 1);
}

/* Lengths against the sum of the bits, for every format and a few divisors. */
static void formats(void **state)
{
    (void)state;
    static const unsigned divisor[] = {1, 2, 24, 12345, 65535, 0};
    for (unsigned i = 0; i < sizeof divisor / sizeof divisor[0]; i++)
        for (unsigned lcr = 0; lcr < 32; lcr++) {
            struct uart_rig r;
            double bits = 1 + 5 + (lcr & 3) + ((lcr & 8) ? 1 : 0);
            bits += !(lcr & 4) ? 1 : (lcr & 3) ? 2 : 1.5;
            double hz = 3686400.0 / 16 / (divisor[i] ? divisor[i] : 65536);
            rig_begin(&r);
            rig_set(&r, UART_LCR, LCR_DLAB, 0);
            rig_set(&r, UART_DATA, divisor[i] & 255, 0);
            rig_set(&r, UART_IER, divisor[i] >> 8, 0);
            rig_set(&r, UART_LCR, lcr, 0);
            rig_set(&r, UART_DATA, 0xFF, 0);
            vm_uart_event(&r.u, UINT64_MAX - 1);
            assert_int_equal(r.sent, 1);
            assert_int_equal(r.byte[0], 0xFF >> (3 - (lcr & 3)));
            double expected = 1e12 * (bits + 1) / hz;
            assert_true((double)r.at[0] >= expected - 1 && (double)r.at[0] <= expected + 1);
        }
}

static void full_transmitter(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_DATA, 1, 0); /* overwritten */
    rig_set(&r, UART_DATA, 2, 0);
    vm_uart_event(&r.u, CRT_PS_PER_S);
    assert_int_equal(r.sent, 1);
    assert_int_equal(r.byte[0], 2);
    rig_set(&r, UART_FCR, FCR_ENABLE, CRT_PS_PER_S);
    for (unsigned n = 0; n < 20; n++) /* the last four are lost */
        rig_set(&r, UART_DATA, n, CRT_PS_PER_S);
    assert_int_equal(rig_get(&r, UART_LSR, CRT_PS_PER_S), 0);
    vm_uart_event(&r.u, 2 * CRT_PS_PER_S);
    assert_int_equal(r.sent, 17);
    for (unsigned n = 0; n < 16; n++)
        assert_int_equal(r.byte[1 + n], n);
}

/* Cleared: what waits, not what is on its way. */
static void clear_transmitter(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_FCR, FCR_ENABLE, 0);
    rig_set(&r, UART_IER, IER_THR, 0);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_FIFO | IIR_THR);
    for (unsigned n = 1; n <= 5; n++)
        rig_set(&r, UART_DATA, n, 0);
    assert_false(r.irq.level);
    vm_uart_event(&r.u, clocks(BIT));
    rig_set(&r, UART_FCR, FCR_CLEAR_TX, clocks(BIT)); /* without the enable bit: FIFOs off */
    assert_int_equal(rig_get(&r, UART_IIR, clocks(BIT)), IIR_THR);
    vm_uart_event(&r.u, CRT_PS_PER_S);
    assert_int_equal(r.sent, 1);
    rig_set(&r, UART_FCR, FCR_ENABLE, CRT_PS_PER_S);
    rig_set(&r, UART_DATA, 6, CRT_PS_PER_S);
    rig_set(&r, UART_FCR, FCR_ENABLE | FCR_CLEAR_TX, CRT_PS_PER_S); /* before its start bit */
    assert_true(r.irq.level);
    vm_uart_event(&r.u, 2 * CRT_PS_PER_S);
    assert_int_equal(r.sent, 1);
    assert_int_equal(rig_get(&r, UART_LSR, 2 * CRT_PS_PER_S), LSR_THR_EMPTY | LSR_EMPTY);
}

/* Raised when the register falls empty and when it is enabled while empty; quieted by a byte, or by
 * reading IIR when that says so. */
static void thr_interrupt(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_IER, IER_THR, 5);
    assert_true(r.irq.level);
    assert_int_equal(r.irq.t, 5);
    assert_int_equal(rig_get(&r, UART_IIR, 6), IIR_THR);
    assert_false(r.irq.level);
    assert_int_equal(rig_get(&r, UART_IIR, 7), IIR_NONE);
    rig_set(&r, UART_DATA, 'x', clocks(10));
    vm_uart_event(&r.u, clocks(10 + BIT));
    assert_true(r.irq.level);
    assert_int_equal(r.irq.t, clocks(10 + BIT));
    rig_set(&r, UART_DATA, 'y', clocks(10 + BIT));
    assert_false(r.irq.level);
    vm_uart_event(&r.u, clocks(10 + BIT + BYTE) - 1);
    assert_false(r.irq.level);
    vm_uart_event(&r.u, clocks(10 + BIT + BYTE));
    assert_true(r.irq.level);
    rig_set(&r, UART_IER, 0, clocks(10 + BIT + BYTE));
    assert_false(r.irq.level);
    rig_set(&r, UART_IER, IER_THR, clocks(10 + BIT + BYTE));
    assert_true(r.irq.level);
}

static void receive_one(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_IER, IER_DATA, 0);
    vm_uart_receive(&r.u, 'q', clocks(50));
    assert_true(r.irq.level);
    assert_int_equal(r.irq.t, clocks(50));
    assert_false(vm_uart_ready(&r.u, clocks(5000)));
    assert_int_equal(vm_uart_ready_at(&r.u), UINT64_MAX);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(51)), LSR_DATA | LSR_THR_EMPTY | LSR_EMPTY);
    assert_int_equal(rig_get(&r, UART_IIR, clocks(51)), IIR_DATA);
    assert_int_equal(rig_get(&r, UART_DATA, clocks(52)), 'q');
    assert_false(r.irq.level);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(52)), LSR_THR_EMPTY | LSR_EMPTY);
    assert_int_equal(vm_uart_ready_at(&r.u), clocks(50 + BYTE));
    assert_false(vm_uart_ready(&r.u, clocks(50 + BYTE) - 1));
    assert_true(vm_uart_ready(&r.u, clocks(50 + BYTE)));
    rig_set(&r, UART_LCR, 2, clocks(60)); /* seven bits */
    vm_uart_receive(&r.u, 0xFF, clocks(1000));
    assert_int_equal(rig_get(&r, UART_DATA, clocks(1000)), 0x7F);
}

/* Without FIFOs the new byte takes the place of the old, with FIFOs it is lost. */
static void overrun(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_IER, IER_LINE | IER_DATA, 0);
    vm_uart_receive(&r.u, 1, 0);
    vm_uart_receive(&r.u, 2, 1);
    assert_int_equal(rig_get(&r, UART_IIR, 2), IIR_LINE);
    assert_int_equal(rig_get(&r, UART_LSR, 2), 0x63);
    assert_int_equal(rig_get(&r, UART_LSR, 2), 0x61);
    assert_int_equal(rig_get(&r, UART_IIR, 2), IIR_DATA);
    assert_int_equal(rig_get(&r, UART_DATA, 2), 2);
    rig_set(&r, UART_FCR, FCR_ENABLE, 3);
    for (unsigned n = 1; n <= 17; n++)
        vm_uart_receive(&r.u, (uint8_t)n, 3 + n);
    assert_int_equal(rig_get(&r, UART_LSR, 30), 0x63);
    for (unsigned n = 1; n <= 16; n++)
        assert_int_equal(rig_get(&r, UART_DATA, 30), n);
    assert_int_equal(rig_get(&r, UART_LSR, 30), 0x60);
    assert_false(r.irq.level);
}

static void triggers(void **state)
{
    (void)state;
    static const unsigned level[4] = {1, 4, 8, 14};
    for (unsigned i = 0; i < 4; i++) {
        struct uart_rig r;
        rig_begin(&r);
        rig_set(&r, UART_FCR, FCR_ENABLE | i << 6, 0);
        rig_set(&r, UART_IER, IER_DATA, 0);
        for (unsigned n = 1; n <= 16; n++) {
            vm_uart_receive(&r.u, (uint8_t)n, n);
            assert_int_equal(r.irq.level, n >= level[i]);
            assert_int_equal(rig_get(&r, UART_IIR, n), n >= level[i] ? 0xC4 : 0xC1);
        }
        for (unsigned n = 16; n > 0; n--) {
            assert_int_equal(r.irq.level, n >= level[i]);
            rig_get(&r, UART_DATA, 20);
        }
        assert_false(r.irq.level);
    }
}

/* Four byte times after the last byte in or out, while one is left; reading one restarts it. */
static void time_out(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_FCR, FCR_ENABLE | 0xC0, 0);
    rig_set(&r, UART_IER, IER_DATA, 0);
    vm_uart_receive(&r.u, 1, clocks(100));
    vm_uart_receive(&r.u, 2, clocks(200));
    vm_uart_receive(&r.u, 3, clocks(500));
    assert_int_equal(vm_uart_next(&r.u), clocks(500 + 4 * BYTE));
    vm_uart_event(&r.u, clocks(500 + 4 * BYTE));
    assert_true(r.irq.level);
    assert_int_equal(r.irq.t, clocks(500 + 4 * BYTE));
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    assert_int_equal(rig_get(&r, UART_IIR, clocks(2000)), IIR_FIFO | IIR_TIMEOUT);
    assert_true(r.irq.level); /* reading IIR does not quiet it */
    assert_int_equal(rig_get(&r, UART_DATA, clocks(2000)), 1);
    assert_false(r.irq.level);
    assert_int_equal(vm_uart_next(&r.u), clocks(2000 + 4 * BYTE));
    assert_int_equal(rig_get(&r, UART_DATA, clocks(2100)), 2);
    assert_int_equal(vm_uart_next(&r.u), clocks(2100 + 4 * BYTE));
    assert_int_equal(rig_get(&r, UART_DATA, clocks(2200)), 3);
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    vm_uart_receive(&r.u, 4, clocks(3000));
    rig_set(&r, UART_FCR, FCR_ENABLE | FCR_CLEAR_RX, clocks(3001));
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(3001)), 0x60);
    /* None without FIFOs. */
    rig_set(&r, UART_FCR, 0, clocks(3001));
    vm_uart_receive(&r.u, 5, clocks(3002));
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
}

/* All five at once, taken away from the top. */
static void priorities(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_MCR, MCR_LOOP | MCR_RTS, 0); /* DSR and DCD go off */
    rig_set(&r, UART_MCR, 0, 0);
    rig_set(&r, UART_IER, 0x0F, 0);
    vm_uart_receive(&r.u, 1, 0);
    vm_uart_receive(&r.u, 2, 0);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_LINE);
    rig_get(&r, UART_LSR, 0);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_DATA);
    rig_get(&r, UART_DATA, 0);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_THR);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_MODEM);
    assert_int_equal(rig_get(&r, UART_MSR, 0), 0xBA);
    assert_int_equal(rig_get(&r, UART_IIR, 0), IIR_NONE);
    assert_int_equal(rig_get(&r, UART_MSR, 0), 0xB0);
    assert_false(r.irq.level);
}

/* Sent bytes come back, nothing leaves, nothing enters; the modem lines are MCR's. */
static void loopback(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_MCR, MCR_LOOP, 0);
    assert_int_equal(vm_uart_ready_at(&r.u), UINT64_MAX);
    vm_uart_receive(&r.u, 'n', 0);
    assert_int_equal(rig_get(&r, UART_LSR, 0), 0x60);
    rig_set(&r, UART_DATA, 'L', 0);
    vm_uart_event(&r.u, clocks(BIT + BYTE) - 1);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(BIT + BYTE) - 1), 0x20);
    assert_int_equal(rig_get(&r, UART_LSR, clocks(BIT + BYTE)), 0x61);
    assert_int_equal(rig_get(&r, UART_DATA, clocks(BIT + BYTE)), 'L');
    assert_int_equal(r.sent, 0);
    static const uint8_t expected[16] = {0x00, 0x20, 0x10, 0x30, 0x40, 0x60, 0x50, 0x70,
                                         0x80, 0xA0, 0x90, 0xB0, 0xC0, 0xE0, 0xD0, 0xF0};
    for (unsigned v = 0; v < 16; v++) {
        rig_set(&r, UART_MCR, MCR_LOOP | v, CRT_PS_PER_S);
        assert_int_equal(rig_get(&r, UART_MSR, CRT_PS_PER_S) & 0xF0, expected[v]);
    }
    /* The trailing edge of RI alone is told. */
    rig_set(&r, UART_MCR, MCR_LOOP, CRT_PS_PER_S);
    rig_get(&r, UART_MSR, CRT_PS_PER_S);
    rig_set(&r, UART_MCR, MCR_LOOP | MCR_OUT1, CRT_PS_PER_S);
    assert_int_equal(rig_get(&r, UART_MSR, CRT_PS_PER_S), 0x40);
    rig_set(&r, UART_MCR, MCR_LOOP, CRT_PS_PER_S);
    assert_int_equal(rig_get(&r, UART_MSR, CRT_PS_PER_S), 0x04);
}

static void reset(void **state)
{
    (void)state;
    struct uart_rig r;
    rig_begin(&r);
    rig_set(&r, UART_FCR, FCR_ENABLE, 0);
    rig_set(&r, UART_IER, 0x0F, 0);
    rig_set(&r, UART_DATA, 1, 0);
    vm_uart_receive(&r.u, 2, 0);
    assert_true(r.irq.level);
    vm_uart_reset(&r.u, 10);
    assert_false(r.irq.level);
    assert_int_equal(vm_uart_next(&r.u), UINT64_MAX);
    assert_int_equal(rig_get(&r, UART_LSR, 10), 0x60);
    assert_int_equal(rig_get(&r, UART_IIR, 10), IIR_NONE);
    vm_uart_event(&r.u, CRT_PS_PER_S);
    assert_int_equal(r.sent, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(power_on),
        cmocka_unit_test(writable_bits),
        cmocka_unit_test(one_byte),
        cmocka_unit_test(no_gap),
        cmocka_unit_test(formats),
        cmocka_unit_test(full_transmitter),
        cmocka_unit_test(clear_transmitter),
        cmocka_unit_test(thr_interrupt),
        cmocka_unit_test(receive_one),
        cmocka_unit_test(overrun),
        cmocka_unit_test(triggers),
        cmocka_unit_test(time_out),
        cmocka_unit_test(priorities),
        cmocka_unit_test(loopback),
        cmocka_unit_test(reset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
