#include "emu/headless.h"

#include "emu/record.h"

#include <stdio.h>

#include "emu/command.h"
#include "emu/debug/gdb_past.h"
#include "emu/moment.h"
#include "emu/progress.h"
#include "emu/rig.h"
#include "emu/terminal.h"
#include "emu/trouble.h"

#define DISPLAY_FILE_PS (10 * CRT_PS_PER_S)
#define FOR_EVER_PS     (UINT64_MAX / 2)
#define KEYS_S          0.002 /* host seconds between looks at the keyboard */
#define DEBUGGER_MS     20 /* a held machine waits for the debugger between looks at the keyboard */
#define LONGEST_S       0.05 /* a late look does not make the machine hurry after it */

/* ---- running ------------------------------------------------------------------------------------
 */

/* Who has a say in a run. */
struct run {
    struct vm_rig *rig;
    struct vm_terminal *terminal; /* NULL: no --console */
    struct vm_gdb *gdb;           /* NULL: no --gdb */
    struct vm_history *history;   /* for the debugger to go back */
};

/* To the end of the firmware or `until`; true when it has ended. A debugger may hold the machine. */
static bool run_end(const struct run *r, uint64_t until)
{
    if (!r->gdb)
        return vm_machine_run_end(r->rig->machine, until);
    struct vm_gdb_past past;
    struct vm_gdb_target target = vm_gdb_with_past(&past, r->rig->machine, r->history);
    return vm_gdb_run(r->gdb, &target, until, DEBUGGER_MS) == VM_GDB_OVER;
}

/* In real time, until the firmware ends, the limit, or who types leaves. */
static void run_live(const struct run *r, uint64_t limit)
{
    struct vm_machine *m = r->rig->machine;
    double last = vm_host_seconds();
    while (m->now < limit && !r->terminal->left) {
        double now = vm_host_seconds(), elapsed = now - last;
        last = now;
        uint64_t ps = (uint64_t)((elapsed < LONGEST_S ? elapsed : LONGEST_S) * 1e12);
        if (run_end(r, limit - m->now < ps ? limit : m->now + ps))
            return;
        vm_terminal_poll(r->terminal, r->rig->console, m->now, KEYS_S);
    }
}

static void run(const struct run *r, uint64_t limit)
{
    struct vm_progress progress;
    if (r->terminal && r->terminal->live) {
        run_live(r, limit);
        return;
    }
    if (r->gdb) {
        while (r->rig->machine->now < limit && !run_end(r, limit))
            ;
        return;
    }
    vm_progress_begin(&progress);
    progress.shown &= !r->terminal;
    vm_progress_run_end(&progress, r->rig->machine, limit);
    vm_progress_end(&progress);
}

/* What the UART still holds when the firmware is lost or ends itself: it was meant to be read. */
static void drain(struct vm_rig *rig)
{
    for (int events = 0; events < 4 * VM_UART_FIFO; events++) {
        uint64_t next = vm_uart_next(&rig->board->uart);
        if (next == VM_NEVER)
            return;
        vm_machine_run(rig->machine, next + 1);
    }
}

/* ---- the outcome --------------------------------------------------------------------------------
 */

/* What there was before a run: all of it is 0 but after --load-state. */
struct before {
    uint64_t now, words, strokes, refreshes, retired, printed;
};

static struct before before(const struct vm_rig *rig)
{
    const struct vm_machine *m = rig->machine;
    return (struct before){.now = m->now,
                           .words = m->dpu.words,
                           .strokes = m->strokes,
                           .refreshes = m->refreshes.last.number,
                           .retired = rig->board ? rv_retired(&rig->board->cpu) : 0,
                           .printed = rig->console ? rig->console->sent : 0};
}

static void say_speed(const struct vm_rig *rig, const struct vm_input *input,
                      const struct before *b, double took)
{
    const struct before after = before(rig);
    double simulated = (double)(after.now - b->now) / (double)CRT_PS_PER_S;
    took = took > 1e-9 ? took : 1e-9;
    fprintf(
        stderr,
        "%s: %.6g simulated seconds in %.3g s, %.0f simulated seconds a second; %llu words, %llu "
        "strokes, %llu refreshes\n",
        input->name, simulated, took, simulated / took,
        (unsigned long long)(after.words - b->words),
        (unsigned long long)(after.strokes - b->strokes),
        (unsigned long long)(after.refreshes - b->refreshes));
    if (!rig->board)
        return;
    fprintf(stderr, "%s: %llu instructions, %.0f million a second", input->name,
            (unsigned long long)(after.retired - b->retired),
            (double)(after.retired - b->retired) / took / 1e6);
    if (after.printed > b->printed)
        fprintf(stderr, "; the console printed %llu bytes, --console shows them",
                (unsigned long long)(after.printed - b->printed));
    fputs("\n", stderr);
}

/* Of firmware: its own exit status, or what became of it. */
static int firmware_outcome(const struct vm_rig *rig, const struct vm_input *input, bool left,
                            struct crt_error *err)
{
    int status;
    char after[32];
    if (vm_machine_exited(rig->machine, &status))
        return status;
    enum vm_trouble trouble = vm_find_trouble(rig->machine, input, err);
    if (trouble == VM_TROUBLE_TRAP)
        vm_print_registers(stderr, &rig->board->cpu);
    if (trouble != VM_NO_TROUBLE && trouble != VM_TROUBLE_DARK)
        return VM_EXIT_TROUBLE;
    if (left)
        return VM_EXIT_OK;
    vm_format_time(rig->machine->now, after, sizeof after);
    crt_fail(err, "%s has not ended itself within %s of simulated time; --for allows more",
             input->name, after);
    return VM_EXIT_TIMEOUT;
}

static int outcome(const struct vm_rig *rig, const struct vm_input *input, bool left,
                   struct crt_error *err)
{
    err->text[0] = '\0';
    if (input->has_firmware)
        return firmware_outcome(rig, input, left, err);
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (rig->machine->strokes == 0 && !vm_machine_uses_raster(rig->machine))
        vm_machine_run(rig->machine, VM_SETTLED_PS);
    return vm_find_trouble(rig->machine, input, err) ? VM_EXIT_TROUBLE : VM_EXIT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------
 */

static bool open_rig(const struct vm_headless *h, const struct vm_settings *settings,
                     const struct vm_input *input, struct vm_rig *rig, struct crt_error *err)
{
    struct vm_tubes tubes = vm_settings_tubes(settings, settings->view);
    if (!vm_rig_open(rig, settings, input, DF_TIMING_VALUE, h->saved.save ? &tubes : NULL, err))
        return false;
    if (vm_saved_load(&h->saved, rig, settings, input, err))
        return true;
    vm_rig_close(rig);
    return false;
}

/* The terminal, and the debugger with its way back. */
static bool join(struct run *r, const struct vm_headless *h, struct vm_terminal *terminal,
                 struct crt_error *err)
{
    if (h->console) {
        if (!vm_terminal_open(terminal, err))
            return false;
        r->terminal = terminal;
        r->rig->console->desc = vm_terminal_console(terminal);
    }
    r->gdb = h->gdb;
    if (r->gdb)
        r->history = vm_history_create(&(struct vm_history_desc){.rig = r->rig}, err);
    return !r->gdb || r->history;
}

static void part(struct run *r)
{
    if (r->terminal)
        vm_terminal_close(r->terminal);
    vm_history_destroy(r->history);
}

/* Runs an open rig to its end. False: a sentence, and nothing has run. */
static bool play(const struct vm_headless *h, struct vm_rig *rig, const struct vm_input *input,
                 uint64_t limit, bool *left, struct crt_error *err)
{
    struct vm_terminal terminal = {0};
    struct run r = {.rig = rig};
    bool ok = join(&r, h, &terminal, err);
    /* Nobody will type any more. */
    if (ok && input->typed && !terminal.live)
        vm_console_close(rig->console);
    double begin = vm_host_seconds();
    const struct before b = before(rig);
    if (ok)
        run(&r, limit);
    if (ok && h->console)
        drain(rig);
    part(&r);
    if (ok && !h->console && !h->gdb)
        say_speed(rig, input, &b, vm_host_seconds() - begin);
    if (ok && h->record)
        ok = vm_record_save(h->record, rig->machine, input->name, err);
    *left = terminal.left || (h->gdb && vm_gdb_killed(h->gdb));
    return ok;
}

int vm_headless(const struct vm_headless *h, const struct vm_settings *settings,
                const struct vm_input *input, struct crt_error *err)
{
    struct vm_rig rig;
    bool left = false;
    uint64_t length = input->has_firmware ? FOR_EVER_PS : DISPLAY_FILE_PS;
    int status;
    if (!input->has_firmware && input->script.end > length)
        length = input->script.end;
    if (h->length.given && !vm_time_ps(&h->length, settings->tick, &length, err))
        return VM_EXIT_USAGE;
    if (!open_rig(h, settings, input, &rig, err))
        return VM_EXIT_TROUBLE;
    if (!play(h, &rig, input, rig.machine->now + length, &left, err) ||
        !vm_saved_save(&h->saved, &rig, settings, input, err))
        status = VM_EXIT_TROUBLE;
    else
        status = outcome(&rig, input, left, err);
    vm_rig_close(&rig);
    return status;
}
