/* gdb_parts.h — what the files of a session call of each other.
 *
 * Models:     see emu/debug/gdb_session.h. A command reads its fields and writes one reply with
 *             vm_gdb_reply…, or none.
 * Ownership:  all of it works on the caller's session.
 * Errors:     a command that cannot be done is answered with an error packet.
 */
#ifndef EMU_DEBUG_GDB_PARTS_H
#define EMU_DEBUG_GDB_PARTS_H

#include "emu/debug/gdb_session.h"

/* Signals in gdb's numbering. */
enum {
    VM_GDB_SIGINT = 2,
    VM_GDB_SIGILL = 4,
    VM_GDB_SIGTRAP = 5,
    VM_GDB_SIGBUS = 10,
    VM_GDB_SIGSEGV = 11,
    VM_GDB_SIGSYS = 12,
    VM_GDB_SIGTERM = 15,
};

/* gdb_commands.c: whole replies, and the ends of one that was begun in s->reply. */
void vm_gdb_send(struct vm_gdb_session *s);
void vm_gdb_say(struct vm_gdb_session *s, const char *text);
void vm_gdb_ok(struct vm_gdb_session *s, bool ok, const char *error);
#define VM_GDB_NO_MEMORY "E14"
#define VM_GDB_MALFORMED "E22"
#define VM_GDB_NO_ROOM   "E28"

/* gdb_registers.c */
void vm_gdb_read_all(struct vm_gdb_session *s);
void vm_gdb_write_all(struct vm_gdb_session *s, struct vm_gdb_fields *f);
void vm_gdb_read_one(struct vm_gdb_session *s, struct vm_gdb_fields *f);
void vm_gdb_write_one(struct vm_gdb_session *s, struct vm_gdb_fields *f);
bool vm_gdb_set_pc(struct vm_gdb_session *s, uint32_t pc);

/* gdb_description.c: the registers as XML; returns its length, at most `size`. */
size_t vm_gdb_describe(char *text, size_t size);
#define VM_GDB_DESCRIPTION_MAX 8192
/* The CSRs in it, in order, and how many. */
extern const uint16_t vm_gdb_csrs[];
extern const unsigned vm_gdb_csr_count;

/* gdb_query.c: packets beginning with q, Q and v. */
void vm_gdb_query(struct vm_gdb_session *s, struct vm_gdb_fields *f);
void vm_gdb_set(struct vm_gdb_session *s, struct vm_gdb_fields *f);

/* gdb_resume.c */
void vm_gdb_resume(struct vm_gdb_session *s, struct vm_gdb_fields *f, enum vm_gdb_how how,
                   bool with_signal);
void vm_gdb_vcont(struct vm_gdb_session *s, struct vm_gdb_fields *f);
void vm_gdb_back(struct vm_gdb_session *s, struct vm_gdb_fields *f);
void vm_gdb_tell_stop(struct vm_gdb_session *s);
/* Does the instruction that the processor is about to execute reach a watched byte? */
bool vm_gdb_reaches(const struct vm_gdb_points *points, const struct rv_cpu *cpu,
                    struct vm_gdb_stop *stop_there);
/* "1", "0" (any), "-1" (all): this program's only thread. */
bool vm_gdb_take_thread(struct vm_gdb_fields *f);

/* gdb_back.c: one piece of going back; true when it has come to a stop, which is then in run.stop. */
bool vm_gdb_go_back(struct vm_gdb_session *s);

/* gdb_monitor.c: commands of the user to the machine. */
void vm_gdb_monitor(struct vm_gdb_session *s, struct vm_gdb_fields *f);

#endif
