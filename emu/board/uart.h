/* uart.h — the console's serial port: a 16550A.
 *
 *            ┌──────────────────────────────────────────────────────┐
 *   THR ───▶ │ queue of 1 or 16 ─▶ shift register ──┬─▶ out.transmit │
 *            │                           loopback ──┤               │
 *   RBR ◀─── │ queue of 1 or 16 ◀───────────────────┴─◀ vm_uart_receive
 *   IIR ◀─── │ line status > data, time-out > THR empty > modem ─▶ irq
 *            └──────────────────────────────────────────────────────┘
 *
 * Models:     RBR/THR, IER, IIR/FCR, LCR, MCR, LSR, MSR, SCR and the divisor behind DLAB; without
 *             FIFOs as a 16450, with FIFOs of 16 bytes, receive trigger levels 1, 4, 8, 14 and the
 *             character time-out (4 character times without a byte in or out); all interrupts with
 *             their priorities and what clears them; overrun; loopback with its modem status.
 * Time:       picoseconds since power-on. Inside it counts its own clock of 3.6864 MHz, so that
 *             rounding never adds up: a bit is 16 × divisor clocks, a byte 1 start bit, 5–8 data
 *             bits, a parity bit if LCR asks for it, 1, 1½ or 2 stop bits. A byte written to an idle
 *             transmitter waits one bit (8–24 clocks of the divided rate in the datasheet).
 *             A divisor of 0 counts as 65536 (assumed).
 * Power-on:   115200 baud, 8 bits, no parity, 1 stop bit (divisor 2, LCR 3), as if a boot program had
 *             set it up: programs written for QEMU's board, which heeds neither, need not.
 * Reception:  whoever has input asks vm_uart_ready_at and brings the next byte then or later, when
 *             its stop bit ends. Bytes brought sooner overrun: FIFO mode loses the new byte, else the
 *             old one is overwritten; LSR says so. Looped back, what comes from outside is lost.
 * Ownership:  the caller owns the struct; contexts must outlive it. Allocates nothing.
 * Errors:     offsets above 7: false. Writing a full FIFO loses the byte; a full THR is overwritten.
 * Source:     National Semiconductor PC16550D datasheet (1995); clock, register spacing and the
 *             asserted modem inputs as on QEMU's riscv32 "virt" board.
 * Not modelled: the modem's lines (CTS, DSR, DCD are on, RI off), break, framing and parity errors,
 *             DMA modes, delay of the THR interrupt after a single byte, OUT2 as a gate of irq (none).
 */
#ifndef EMU_BOARD_UART_H
#define EMU_BOARD_UART_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/state.h"
#include "emu/board/wire.h"

#define VM_UART_HZ   3686400
#define VM_UART_FIFO 16

/* Receives what is sent, at the end of each byte's last stop bit. */
struct vm_uart_out {
    void *ctx;
    void (*transmit)(void *ctx, uint8_t byte, uint64_t t); /* may be NULL */
};

struct vm_uart_desc {
    struct vm_uart_out out;
    struct vm_wire irq;
};

struct vm_uart_queue {
    uint8_t byte[VM_UART_FIFO];
    unsigned first, count;
};

enum vm_uart_shift {
    VM_UART_IDLE,
    VM_UART_STARTING, /* a byte waits for the start bit */
    VM_UART_SHIFTING,
};

struct vm_uart {
    struct vm_uart_desc desc;

    /* registers */
    uint8_t ier, fcr, lcr, mcr, scr; /* of FCR: enable and trigger level */
    uint16_t divisor;
    bool overrun;        /* LSR OE */
    uint8_t modem_delta; /* MSR, low four bits */
    bool thr_pending, timeout_pending;

    struct vm_uart_queue tx, rx;
    enum vm_uart_shift shift;
    uint8_t shift_byte;

    /* in clocks of the UART since power-on */
    uint64_t shift_end;  /* of the start delay or of the byte; not when idle */
    uint64_t ready_from; /* when the next byte can have arrived */
    uint64_t timeout_at; /* UINT64_MAX: not counting */

    uint64_t next, next_clock; /* the next change by itself, ps and clocks; UINT64_MAX: none */
    bool level;                /* of irq */
};

void vm_uart_init(struct vm_uart *u, const struct vm_uart_desc *desc);
void vm_uart_reset(struct vm_uart *u, uint64_t t);

bool vm_uart_read(struct vm_uart *u, uint32_t offset, uint32_t *value, uint64_t t);
bool vm_uart_write(struct vm_uart *u, uint32_t offset, uint32_t value, uint64_t t);

/* From when on the receiver takes a byte without losing another; UINT64_MAX while it holds data or
 * is looped back. */
uint64_t vm_uart_ready_at(const struct vm_uart *u);
bool vm_uart_ready(const struct vm_uart *u, uint64_t t);
void vm_uart_receive(struct vm_uart *u, uint8_t byte, uint64_t t);

/* When it next does something by itself, and everything of that up to t. */
uint64_t vm_uart_next(const struct vm_uart *u);
void vm_uart_event(struct vm_uart *u, uint64_t t);

/* A snapshot's section "UART". */
void vm_uart_state(struct vm_uart *u, struct crt_state *s);

#endif
