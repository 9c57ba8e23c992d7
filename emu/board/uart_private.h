/* uart_private.h — what the UART's two halves, uart.c and uart_registers.c, share. */
#ifndef EMU_BOARD_UART_PRIVATE_H
#define EMU_BOARD_UART_PRIVATE_H

#include "emu/board/uart.h"
#include "emu/board/uart_regs.h"

static inline bool vm_uart_fifo(const struct vm_uart *u)
{
    return u->fcr & FCR_ENABLE;
}

/* The interrupt of highest priority that is enabled and there: IIR_…. */
uint8_t vm_uart_interrupt(const struct vm_uart *u);
/* After anything that may have changed when something happens, or the wire. */
void vm_uart_settle(struct vm_uart *u, uint64_t t);

/* RBR, THR. */
uint8_t vm_uart_take(struct vm_uart *u, uint64_t t);
void vm_uart_put(struct vm_uart *u, uint8_t byte, uint64_t t);

void vm_uart_clear_receiver(struct vm_uart *u, uint64_t t);
/* At t the receiver has become able to take a byte: the next one is there a clock later at the
 * earliest, when the access that made room has ended, however the run is cut into pieces. */
void vm_uart_listen(struct vm_uart *u, uint64_t t);
/* But not the byte being shifted out. */
void vm_uart_clear_transmitter(struct vm_uart *u);

#endif
