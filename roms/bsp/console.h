/* console.h — the terminal at the UART, polled.
 *
 *      console_put ──▶ THR        RBR ──▶ console_poll, console_get ──▶ console_line
 *
 * Models:     bytes out and in, and lines with echo and rubbing out. printf and getchar come here,
 *             too, when a program uses them (console_stdio.c).
 * Time:       console_put waits while the UART sends, console_get until a byte arrives. Input that
 *             nobody fetches in time is lost.
 * Units:      bytes; '\n' is sent as "\r\n".
 * Ownership:  nothing.
 * Errors:     none; a byte of 0x04 (control-D) is the end of input.
 * Source:     roms/bsp/uart_regs.h. It is polled so that the same program runs on other boards,
 *             whose interrupt controllers differ.
 */
#ifndef ROMS_BSP_CONSOLE_H
#define ROMS_BSP_CONSOLE_H

#include <stddef.h>
#include <stdint.h>

#define CONSOLE_EOF 0x04

void console_put(char c);
void console_write(const char *text);
/* Eight hexadecimal digits. */
void console_hex(uint32_t value);

/* Waits until everything is sent. */
void console_drain(void);

/* The next byte of input, or -1 when none is there yet. */
int console_poll(void);
/* The next byte of input. */
int console_get(void);

/* A line without its end, ended by '\0', at most size - 1 bytes: what is typed beyond them is not
 * taken and rings the bell. Echoes; backspace or delete rubs out. Returns its length, or -1 at
 * the end of input with nothing typed before it. */
int console_line(char *line, size_t size);

#endif
