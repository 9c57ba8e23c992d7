/* uart_regs.h — the console's 16550A as a program sees it: registers and bits.
 *
 * Models:     the registers that polled input and output need; usable from C and from assembly.
 * Units:      a byte each; offsets are bytes from MAP_UART (emu/memmap.h).
 * Source:     National Semiconductor PC16550D data sheet.
 * Not modelled: modem control and status, the divisor latch, interrupt identification.
 */
#ifndef ROMS_BSP_UART_REGS_H
#define ROMS_BSP_UART_REGS_H

#define UART_RBR 0 /* read: the byte received */
#define UART_THR 0 /* write: the byte to send */
#define UART_IER 1 /* interrupts enabled */
#define UART_LSR 5 /* read: line status */

#define UART_IER_RECEIVED 0x01 /* interrupt while a byte waits in RBR */
#define UART_LSR_RECEIVED 0x01 /* a byte waits in RBR */
#define UART_LSR_OVERRUN  0x02 /* one was lost */
#define UART_LSR_EMPTY    0x20 /* THR takes a byte */
#define UART_LSR_IDLE     0x40 /* all that was written is sent */

#endif
