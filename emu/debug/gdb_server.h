/* gdb_server.h — the debugger's door: a TCP port at which one client at a time is let in.
 *
 *      gdb ──TCP──▶ listener ─▶ client ─▶ session ─▶ target         front end ─▶ vm_gdb_run
 *
 * Models:     who connects stops the machine; who leaves, or vanishes, lets it run on without
 *             points. Until the first client has come the machine does not start. A second client
 *             is turned away.
 * Time:       a slice of the target's between looks at the sockets, so that ^C works; host clocks
 *             are not read.
 * Ownership:  vm_gdb_open allocates, vm_gdb_close frees; targets belong to the caller.
 * Errors:     vm_gdb_open: one sentence. Later trouble with a connection ends that connection.
 * Not modelled: IPv6, several machines, encryption: whoever can connect controls the program, which
 *             is why only this host can unless the user says otherwise.
 */
#ifndef EMU_DEBUG_GDB_SERVER_H
#define EMU_DEBUG_GDB_SERVER_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/error.h"
#include "emu/debug/gdb_target.h"

struct vm_gdb;

/* Whether vm_gdb_open may try this. */
bool vm_gdb_check(const char *place, bool anywhere, struct crt_error *err);
/* Listens at "ADDRESS:PORT", an IPv4 address or "localhost" (or nothing, which is the same); port 0
 * is any that is free. Addresses at which other machines can connect need `anywhere`. */
struct vm_gdb *vm_gdb_open(const char *place, bool anywhere, struct crt_error *err);
/* A client whose program still runs is told that it was terminated. Targets may be gone. */
void vm_gdb_close(struct vm_gdb *gdb);

/* "127.0.0.1:1234" */
const char *vm_gdb_place(const struct vm_gdb *gdb);
/* One line on standard error: where it waits, and how to connect with this program file. */
void vm_gdb_announce(const struct vm_gdb *gdb, const char *file);

enum vm_gdb_ran {
    VM_GDB_RAN,  /* the time has come to `until` */
    VM_GDB_HELD, /* the machine stands, for the client */
    VM_GDB_OVER, /* the program has ended, or is lost in a trap with no client there, or is to end */
};

/* What a front end calls instead of running the machine. While the machine is held it waits until
 * the client has been silent for wait_ms: a few in a window, which has other things to do. */
enum vm_gdb_ran vm_gdb_run(struct vm_gdb *gdb, const struct vm_gdb_target *target, uint64_t until,
                           int wait_ms);
/* The client wants the program to end. */
bool vm_gdb_killed(const struct vm_gdb *gdb);

#endif
