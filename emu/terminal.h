/* terminal.h — the host's terminal, or a pipe, at the far end of the console.
 *
 *      stdin, a terminal ─ raw mode ─▶ keys, as they come (Ctrl-A x leaves) ─▶ vm_console_type
 *      stdin, a pipe     ────────────▶ bytes, when asked for ──────────────▶ console source
 *      console sink ─────────────────▶ stdout
 *
 * Models:     nothing. In raw mode every key goes to the guest, Ctrl-C too; Ctrl-A is the escape:
 *             Ctrl-A x leaves, Ctrl-A Ctrl-A is one Ctrl-A. Output is left to the terminal's own
 *             settings, so that a newline goes to the first column.
 * Restoring:  the terminal is as it was after vm_terminal_close, at exit() and after every signal
 *             that ends or stops a program; when the program goes on after a stop it is raw again.
 * Global:     what a signal handler must find: one terminal at a time.
 * Ownership:  the caller's struct.
 * Errors:     one sentence when raw mode cannot be had.
 */
#ifndef EMU_TERMINAL_H
#define EMU_TERMINAL_H

#include "crt/error.h"
#include "emu/console.h"

struct vm_terminal {
    bool live;   /* stdin is a terminal, in raw mode */
    bool escape; /* Ctrl-A was the last key */
    bool left;   /* Ctrl-A x was */
    bool ended;  /* stdin has come to its end */
    uint8_t buffer[4096];
    size_t at, size; /* of a pipe's bytes read ahead */
};

bool vm_terminal_open(struct vm_terminal *terminal, struct crt_error *err);
void vm_terminal_close(struct vm_terminal *terminal);

/* The console's source (a pipe's only) and sink. */
struct vm_console_desc vm_terminal_console(struct vm_terminal *terminal);

/* Of a terminal: waits up to `seconds` for keys and types what came, at t. `console` NULL: there is
 * nobody to type for, but who types can leave. */
void vm_terminal_poll(struct vm_terminal *terminal, struct vm_console *console, uint64_t t,
                      double seconds);

#endif
