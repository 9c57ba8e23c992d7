/* gdb_session.h — a debugger's conversation with a machine: bytes in, bytes out, time in between.
 *
 *      bytes ──feed──▶ receiver ─▶ commands ─▶ target (registers, memory)
 *                                     │ c s vCont bs bc
 *      bytes ◀─output── replies ◀── run: hooks, points ─▶ target (time)
 *
 * Models:     one thread ("1") of one program, stopped or running (all-stop). Commands: ? g G p P
 *             m M X c C s S vCont Z z H T D k bc bs, the queries that gdb asks, monitor commands.
 *             A step passes over interrupt handlers: what an interrupt starts runs to its mret
 *             first ("monitor step into" steps through them as well). Nothing in memory is changed
 *             for a breakpoint and no clock stands still: the program runs as without a debugger.
 *             Another pc ends a wait in wfi.
 * Ownership:  the caller's struct (about 100 KiB); nothing is allocated.
 * Errors:     bytes are hostile: what is malformed is answered E22 or not at all, unknown packets
 *             with an empty reply; memory that is not there E14; too many points E28.
 * Source:     GDB manual, appendix E "GDB Remote Serial Protocol"; signal numbers include/gdb/signals.def.
 * Not modelled: several clients, non-stop mode, inserting code, file transfer.
 */
#ifndef EMU_DEBUG_GDB_SESSION_H
#define EMU_DEBUG_GDB_SESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "emu/debug/gdb_packet.h"
#include "emu/debug/gdb_points.h"
#include "emu/debug/gdb_target.h"

enum vm_gdb_state {
    VM_GDB_STOPPED, /* the machine stands, the client may ask */
    VM_GDB_RUNNING, /* until something stops it; then the client is told */
    VM_GDB_FREE,    /* the client let go of it */
    VM_GDB_KILLED,  /* the client wants it to end */
};

enum vm_gdb_reason {
    VM_GDB_BY_SIGNAL, /* attached, stepped, interrupted, trapped */
    VM_GDB_BY_BREAK_SOFT,
    VM_GDB_BY_BREAK_HARD,
    VM_GDB_BY_WATCH,
    VM_GDB_BY_EXIT,
    VM_GDB_BY_BEGINNING, /* going back: nothing earlier is known */
};

struct vm_gdb_stop {
    enum vm_gdb_reason reason;
    uint8_t value; /* signal, or exit status */
    enum vm_gdb_kind kind;
    uint32_t address; /* of the watched byte that was reached */
};

enum vm_gdb_how { VM_GDB_CONTINUE, VM_GDB_STEP, VM_GDB_STEP_RANGE, VM_GDB_BACK, VM_GDB_STEP_BACK };

/* The run since the client last resumed. */
struct vm_gdb_run {
    enum vm_gdb_how how;
    uint32_t low, high; /* STEP_RANGE: goes on while pc is in [low, high) */
    bool first;         /* the first instruction has not begun */
    unsigned depth;     /* handlers entered by interrupts, and not left */
    struct vm_gdb_stop stop;
    uint64_t goal; /* BACK, STEP_BACK: stop at an instruction begun before this clock */
};

#define VM_GDB_OUTPUT_MAX (2 * VM_GDB_PACKET_MAX)

struct vm_gdb_session {
    struct vm_gdb_target target;
    enum vm_gdb_state state;
    bool acks;                 /* not after QStartNoAckMode */
    bool says_soft, says_hard; /* the client knows these reasons to stop */
    bool step_into;            /* interrupt handlers */
    bool interrupted;          /* the client asked for a stop */
    bool changed;              /* registers or memory, by the client, since it last ran */
    struct vm_gdb_stop stop;   /* the last one */
    uint64_t reported_cycle;   /* the access that a watchpoint last stopped before */
    uint32_t reported_pc;
    struct vm_gdb_run run;
    struct vm_gdb_points points;
    struct vm_gdb_receiver in;
    struct vm_gdb_packet reply; /* the last packet sent, for when the client missed it */
    size_t output_size;
    uint8_t output[VM_GDB_OUTPUT_MAX];
};

/* A client has come: the machine is stopped, by SIGTRAP. */
void vm_gdb_session_begin(struct vm_gdb_session *s, const struct vm_gdb_target *target);

/* Takes bytes of the client's and returns how many: fewer when replies wait to be fetched or the
 * session has ended. */
size_t vm_gdb_session_feed(struct vm_gdb_session *s, const uint8_t *bytes, size_t size);
/* What is to be sent; `sent` bytes of it have been. */
const uint8_t *vm_gdb_session_output(const struct vm_gdb_session *s, size_t *size);
void vm_gdb_session_sent(struct vm_gdb_session *s, size_t sent);

/* VM_GDB_RUNNING: lets one slice of time pass, to `until` at most, or less when something stops it
 * and the client is told. */
void vm_gdb_session_run(struct vm_gdb_session *s, uint64_t until);
/* It runs, but into the past: `until` means nothing then. */
bool vm_gdb_goes_back(const struct vm_gdb_session *s);
/* The front end ends a program that runs: the client is told that it was terminated. The target may
 * be gone already. */
void vm_gdb_session_end(struct vm_gdb_session *s);

#endif
