/* gdb_target.h — what the debugger needs of a machine.
 *
 *      packets ─▶ session ──▶ registers: struct rv_cpu      memory: read, write
 *                         ──▶ time: run, watch (with hooks)   the past: rewind
 *
 * Models:     the processor itself, and calls for what lies around it, so that a session works on
 *             the whole machine as on a bare processor with some memory.
 * Time:       `now` and `until` in one unit that only the target knows.
 * Ownership:  ctx and cpu belong to whoever made the target and outlive its use.
 * Errors:     see each call.
 */
#ifndef EMU_DEBUG_GDB_TARGET_H
#define EMU_DEBUG_GDB_TARGET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "emu/cpu/rv.h"

struct vm_gdb_target {
    void *ctx;
    struct rv_cpu *cpu;
    uint64_t slice; /* how much time to let pass between looks at the client */

    uint64_t (*now)(void *ctx);
    /* Everything before `until` happens, unless the program ends or the processor halts first. */
    void (*run)(void *ctx, uint64_t until);
    /* The same with the processor by rv_watch; true when hooks->before stopped it. May go on to
     * `until` after an end. */
    bool (*watch)(void *ctx, uint64_t until, const struct rv_hooks *hooks);
    /* The program has ended, with this status. */
    bool (*exited)(void *ctx, int *status);

    /* Memory as a debugger may touch it: without side effects on devices. Both return how many
     * bytes, from the first on, could be reached. */
    size_t (*read)(void *ctx, uint32_t address, uint8_t *bytes, size_t size);
    size_t (*write)(void *ctx, uint32_t address, const uint8_t *bytes, size_t size);

    /* A slice of time has passed with the client there. NULL: nobody minds. */
    void (*remember)(void *ctx);
    /* The client has changed registers or memory, and time is about to pass. NULL: nobody minds. */
    void (*changed)(void *ctx);

    /* Commands of this machine: its answer as text in lines, or false when it has no such command.
     * "help" adds a line for each. NULL: none. */
    bool (*monitor)(void *ctx, const char *command, char *text, size_t size);

    /* The machine as it was at the last moment kept before the processor's clock was `cycle`; false
     * when there is none, and nothing has changed. NULL: the past is not kept. */
    bool (*rewind)(void *ctx, uint64_t cycle);
    uint64_t (*time)(void *ctx, uint64_t cycle); /* when that clock begins; needed to rewind */
};

#endif
