/* gdb_points.h — where and at which accesses a program is to stop.
 *
 *      pc ──▶ breakpoints          load, store ──▶ watchpoints
 *
 * Models:     a set of instruction addresses, software or hardware (the same here: no memory is
 *             changed, so ROM takes them too); ranges of bytes watched for stores, loads, or both.
 * Ownership:  the caller's; plain struct.
 * Errors:     too many: false.
 */
#ifndef EMU_DEBUG_GDB_POINTS_H
#define EMU_DEBUG_GDB_POINTS_H

#include <stdbool.h>
#include <stdint.h>

#include "emu/cpu/rv.h"

/* The numbers are those of the packets Z0 to Z4. */
enum vm_gdb_kind {
    VM_GDB_BREAK_SOFT,
    VM_GDB_BREAK_HARD,
    VM_GDB_WATCH_STORE,
    VM_GDB_WATCH_LOAD,
    VM_GDB_WATCH_BOTH,
};

#define VM_GDB_MAX_BREAKS  256
#define VM_GDB_MAX_WATCHES 64

struct vm_gdb_break {
    uint32_t pc;
    bool soft, hard; /* set as either, or as both */
};

struct vm_gdb_watch {
    uint32_t address, length; /* bytes; the range may not wrap */
    enum vm_gdb_kind kind;
};

struct vm_gdb_points {
    int breaks, watches;
    struct vm_gdb_break at[VM_GDB_MAX_BREAKS]; /* in order of pc */
    struct vm_gdb_watch on[VM_GDB_MAX_WATCHES];
    uint64_t perhaps; /* bit of pc / 4 modulo 64: clear when no breakpoint is there */
};

void vm_gdb_points_clear(struct vm_gdb_points *p);
/* Inserting twice is as good as once, taking out what is not there does nothing. A watchpoint of
 * no bytes watches one. */
bool vm_gdb_points_insert(struct vm_gdb_points *p, enum vm_gdb_kind kind, uint32_t address,
                          uint32_t length);
void vm_gdb_points_remove(struct vm_gdb_points *p, enum vm_gdb_kind kind, uint32_t address,
                          uint32_t length);

/* NULL: none. */
const struct vm_gdb_break *vm_gdb_break_at(const struct vm_gdb_points *p, uint32_t pc);
const struct vm_gdb_watch *vm_gdb_watch_on(const struct vm_gdb_points *p,
                                           const struct rv_access *access);

#endif
