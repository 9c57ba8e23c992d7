/* uart_rig.h — a UART on the bench: its register names, its wire, and what it sends, with times. */
#ifndef TESTS_BOARD_UART_RIG_H
#define TESTS_BOARD_UART_RIG_H

#include <string.h>

#include "crt/ticks.h"
#include "emu/board/uart.h"
#include "emu/board/uart_regs.h"
#include "tests/board/wires.h"

struct uart_rig {
    struct vm_uart u;
    struct listener irq;
    unsigned sent;
    uint8_t byte[256];
    uint64_t at[256];
};

static inline void rig_transmit(void *ctx, uint8_t byte, uint64_t t)
{
    struct uart_rig *r = ctx;
    r->byte[r->sent % 256] = byte;
    r->at[r->sent % 256] = t;
    r->sent++;
}

static inline void rig_begin(struct uart_rig *r)
{
    memset(r, 0, sizeof *r);
    vm_uart_init(&r->u, &(struct vm_uart_desc){{r, rig_transmit}, {&r->irq, listen}});
}

static inline uint8_t rig_get(struct uart_rig *r, uint32_t offset, uint64_t t)
{
    uint32_t v = 0xDEAD;
    assert_true(vm_uart_read(&r->u, offset, &v, t));
    assert_true(v <= 0xFF);
    return (uint8_t)v;
}

static inline void rig_set(struct uart_rig *r, uint32_t offset, uint32_t value, uint64_t t)
{
    assert_true(vm_uart_write(&r->u, offset, value, t));
}

/* Picoseconds of n clocks of the UART. */
static inline uint64_t clocks(uint64_t n)
{
    return crt_tick_time((struct crt_rate){VM_UART_HZ, 1}, n);
}

#endif
