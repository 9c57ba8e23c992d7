/* uart_regs.h — the console's registers and their bits: a 16550A's, a byte each.
 *
 *      0  RBR/THR, with DLAB divisor low      4  MCR
 *      1  IER, with DLAB divisor high         5  LSR
 *      2  read IIR, write FCR                 6  MSR
 *      3  LCR                                 7  SCR
 *
 * Models:     the programming interface of emu/board/uart.h, usable from C and from assembly.
 * Units:      byte offsets from MAP_UART (emu/memmap.h).
 * Source:     National Semiconductor PC16550D datasheet (1995), table II.
 * Not modelled: LCR break, stick parity; FCR DMA mode: without effect.
 */
#ifndef EMU_BOARD_UART_REGS_H
#define EMU_BOARD_UART_REGS_H

#define UART_DATA      0
#define UART_IER       1
#define UART_IIR       2 /* read */
#define UART_FCR       2 /* write */
#define UART_LCR       3
#define UART_MCR       4
#define UART_LSR       5
#define UART_MSR       6
#define UART_SCR       7
#define UART_REGISTERS 8

#define IER_DATA  0x01 /* received data, and the character time-out */
#define IER_THR   0x02 /* transmitter holding register, or FIFO, empty */
#define IER_LINE  0x04 /* line status */
#define IER_MODEM 0x08
#define IER_BITS  0x0F

#define IIR_NONE    0x01
#define IIR_MODEM   0x00
#define IIR_THR     0x02
#define IIR_DATA    0x04
#define IIR_LINE    0x06
#define IIR_TIMEOUT 0x0C
#define IIR_ID      0x0F
#define IIR_FIFO    0xC0 /* FIFOs are on */

#define FCR_ENABLE   0x01
#define FCR_CLEAR_RX 0x02
#define FCR_CLEAR_TX 0x04
#define FCR_TRIGGER  0xC0 /* receive level: 1, 4, 8 or 14 bytes */

#define LCR_LENGTH 0x03 /* + 5 bits */
#define LCR_STOP   0x04 /* 2 stop bits, 1½ for words of 5 bits */
#define LCR_PARITY 0x08
#define LCR_DLAB   0x80

#define MCR_DTR  0x01
#define MCR_RTS  0x02
#define MCR_OUT1 0x04
#define MCR_OUT2 0x08
#define MCR_LOOP 0x10
#define MCR_BITS 0x1F

#define LSR_DATA      0x01
#define LSR_OVERRUN   0x02
#define LSR_THR_EMPTY 0x20
#define LSR_EMPTY     0x40 /* shift register, too */

#define MSR_CTS 0x10
#define MSR_DSR 0x20
#define MSR_RI  0x40
#define MSR_DCD 0x80

#endif
