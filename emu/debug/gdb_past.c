#include "emu/debug/gdb_past.h"

#include <stdio.h>
#include <string.h>

#include "emu/quantity.h"

/* ---- forward ---- */

static uint64_t now(void *ctx)
{
    const struct vm_gdb_past *p = ctx;
    return p->machine.now(p->machine.ctx);
}

static void run(void *ctx, uint64_t until)
{
    const struct vm_gdb_past *p = ctx;
    p->machine.run(p->machine.ctx, until);
}

static bool watch(void *ctx, uint64_t until, const struct rv_hooks *hooks)
{
    const struct vm_gdb_past *p = ctx;
    return p->machine.watch(p->machine.ctx, until, hooks);
}

static void remember(void *ctx)
{
    vm_history_note(((struct vm_gdb_past *)ctx)->history);
}

static bool exited(void *ctx, int *status)
{
    const struct vm_gdb_past *p = ctx;
    return p->machine.exited(p->machine.ctx, status);
}

/* ---- from outside ---- */

static size_t read(void *ctx, uint32_t address, uint8_t *bytes, size_t size)
{
    const struct vm_gdb_past *p = ctx;
    return p->machine.read(p->machine.ctx, address, bytes, size);
}

static size_t write(void *ctx, uint32_t address, const uint8_t *bytes, size_t size)
{
    const struct vm_gdb_past *p = ctx;
    return p->machine.write(p->machine.ctx, address, bytes, size);
}

static void changed(void *ctx)
{
    vm_history_mark(((struct vm_gdb_past *)ctx)->history);
}

/* ---- back ---- */

static bool rewind_to(void *ctx, uint64_t cycle)
{
    struct vm_gdb_past *p = ctx;
    const struct vm_machine *m = p->machine.ctx;
    if (m->desc.tube)
        crt_tube_cancel_films(m->desc.tube);
    return vm_history_rewind(p->history, cycle);
}

static uint64_t time_of(void *ctx, uint64_t cycle)
{
    const struct vm_gdb_past *p = ctx;
    const struct vm_machine *m = p->machine.ctx;
    return vm_board_time(m->desc.board, cycle);
}

/* ---- monitor commands ---- */

static bool monitor(void *ctx, const char *command, char *text, size_t size)
{
    const struct vm_gdb_past *p = ctx;
    if (strcmp(command, "past") == 0) {
        struct vm_history_extent extent = vm_history_extent(p->history);
        char oldest[40];
        vm_format_seconds(extent.oldest, oldest, sizeof oldest);
        snprintf(text, size, "remembered from %s on, by %zu snapshots of %zu KiB\n", oldest,
                 extent.snapshots, extent.bytes / 1024);
        return true;
    }
    if (!p->machine.monitor(p->machine.ctx, command, text, size))
        return false;
    size_t used = strlen(text);
    if (strcmp(command, "help") == 0)
        snprintf(text + used, size - used, "past         how far back the run is remembered\n");
    return true;
}

struct vm_gdb_target vm_gdb_with_past(struct vm_gdb_past *past, struct vm_machine *m,
                                      struct vm_history *history)
{
    *past = (struct vm_gdb_past){vm_gdb_machine(m), history};
    struct vm_gdb_target target = past->machine;
    target.ctx = past;
    target.now = now;
    target.run = run;
    target.watch = watch;
    target.exited = exited;
    target.read = read;
    target.write = write;
    target.remember = remember;
    target.changed = changed;
    target.monitor = monitor;
    target.rewind = rewind_to;
    target.time = time_of;
    return target;
}
