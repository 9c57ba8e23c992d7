/* console.h — the far end of the UART's cable: what is typed, and what is printed.
 *
 *      --type TEXT, a pipe, a terminal ─▶ queue ─▶ UART receiver
 *      the machine's own keyboard      ─▶ keyed ─┘
 *      UART transmitter ─▶ sink (terminal, file), and the watch for --when console:TEXT
 *
 * Models:     a line without errors. A byte is delivered when the receiver is empty, a byte's time
 *             after the one before, and not before the moment it was typed. Where input comes from
 *             a pipe the next byte is asked for at that very moment, so that what the guest sees
 *             does not depend on when the host had it; but the first byte of a line only when the
 *             guest has printed nothing for VM_CONSOLE_QUIET_PS, so that who waits at the other end
 *             of two pipes has seen the question before the answer is asked for. After the last byte of a pipe, or of
 *             --type, comes one 0x04 (EOT).
 * Time:       picoseconds since power-on.
 * State:      position in the queue and number of bytes printed; the bytes typed are kept, so that a
 *             machine taken back in time is typed the same again, unless somebody types something
 *             else; what was printed already is not printed twice.
 *             What the machine's keyboard sends is the machine's own doing: it waits in a ring that is
 *             part of the state.
 * Ownership:  vm_console_free releases the queue; source and sink belong to the caller.
 * Errors:     out of memory: vm_console_type is false and nothing was typed. A full ring:
 *             vm_console_key is false and nothing was sent.
 */
#ifndef EMU_CONSOLE_H
#define EMU_CONSOLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/state.h"

#define VM_CONSOLE_EOT       0x04
#define VM_CONSOLE_QUIET_PS  UINT64_C(10000000000) /* 10 ms */
#define VM_CONSOLE_WATCH_MAX 128
#define VM_CONSOLE_KEYED     4096 /* bytes from the keyboard that wait at most */

struct vm_typed {
    uint8_t byte;
    uint64_t not_before; /* ps */
};

struct vm_console_desc {
    void *ctx;
    int (*source)(void *ctx); /* the next byte of a pipe, waiting for it; −1 at its end; or NULL */
    void (*sink)(void *ctx, uint8_t byte, uint64_t t); /* or NULL */
};

struct vm_console {
    struct vm_console_desc desc;
    struct vm_typed *queue;
    size_t count, room;
    bool ends;      /* the queue is all there will be: EOT follows it */
    bool exhausted; /* the source has come to its end */
    uint64_t shown; /* bytes that the sink has got */

    /* state */
    size_t next;                     /* of the queue */
    bool ended;                      /* EOT was delivered */
    uint64_t sent;                   /* bytes the guest has printed */
    uint64_t last;                   /* when the last of them came */
    bool in_line;                    /* the last byte taken was not the end of a line */
    uint8_t keyed[VM_CONSOLE_KEYED]; /* ring */
    unsigned keyed_first, keyed_count;

    /* the watch */
    char watch[VM_CONSOLE_WATCH_MAX];
    uint8_t border[VM_CONSOLE_WATCH_MAX]; /* Knuth, Morris and Pratt's failure function */
    size_t watch_length, matched;
    bool found;
};

void vm_console_init(struct vm_console *c, const struct vm_console_desc *desc);
void vm_console_free(struct vm_console *c);

/* Bytes typed at `t`. What had been typed later, before the machine was taken back to then, will not
 * be. */
bool vm_console_type(struct vm_console *c, const char *bytes, size_t length, uint64_t t);
/* Bytes from the machine's keyboard, now. */
bool vm_console_key(struct vm_console *c, const char *bytes, size_t length);
/* Nothing more will be typed. */
void vm_console_close(struct vm_console *c);

/* When the next byte may be delivered, were the receiver ready at `ready`: at or after it;
 * UINT64_MAX: there is none. */
uint64_t vm_console_next(const struct vm_console *c, uint64_t ready);
/* Nothing typed waits. */
bool vm_console_empty(const struct vm_console *c);
/* Takes it; −1 when there is none after all. */
int vm_console_take(struct vm_console *c, uint64_t t);

/* A byte the guest has sent. */
void vm_console_print(struct vm_console *c, uint8_t byte, uint64_t t);

/* From now on looks for `text` (1 … VM_CONSOLE_WATCH_MAX − 1 bytes) in what is printed; c->found
 * tells when it was. */
void vm_console_watch(struct vm_console *c, const char *text);

/* What a snapshot holds of it. A position beyond what this console was typed is its end. */
void vm_console_state(struct vm_console *c, struct crt_state *s);

#endif
