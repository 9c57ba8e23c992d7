/* trace — one text line per event: words executed, or pieces of lit beam. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/beam_file.h"
#include "display_file/df_regs.h"
#include "emu/command.h"
#include "emu/moment.h"
#include "emu/out_file.h"
#include "emu/progress.h"
#include "emu/summary.h"
#include "emu/trouble.h"

struct options {
    const char *what, *out;
    struct vm_time length;
    bool summary;
    struct vm_settings_options settings;
    struct vm_input_options input;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"what", 0, VM_OPT_CHOICE, ROW(what), "dpu|beam",
     "dpu: a line per executed word (default); beam: a line per piece of lit beam, the .beam "
     "format",
     0, 0},
    {"for", 0, VM_OPT_TIME, ROW(length), "T",
     "trace this much simulated time from power-on; default: dpu one refresh, beam to the moment "
     "capture "
     "would choose",
     0, 0},
    {"summary", 0, VM_OPT_FLAG, ROW(summary), "",
     "print how long a refresh takes, with its uncertainty, instead of the events", 0, 0},
    {"out", 'o', VM_OPT_STRING, ROW(out), "FILE", "where the lines go; default standard output", 0,
     0},
};

struct trace {
    struct options o;
    struct vm_input input;
    struct vm_settings settings;
    struct vm_out file;
    FILE *out;
};

/* How long the default trace of words waits for a refresh to be complete. */
#define PATIENCE_PS (2 * CRT_PS_PER_S)

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_trace, status, err);
}

static void print_word(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                       const struct df_dpu *dpu)
{
    FILE *out = ctx;
    if (!fetched) {
        fprintf(out, "# dpu %llu bus time-out at DPC=%06o\n", (unsigned long long)t, address);
        return;
    }
    fprintf(out, "dpu %llu DPC=%06o WORD=%06o MPR=%06o XPR=%06o YPR=%06o\n", (unsigned long long)t,
            address, word, df_dpu_read(dpu, DF_MPR), df_dpu_read(dpu, DF_XPR),
            df_dpu_read(dpu, DF_YPR));
}

static void print_stroke(void *ctx, const struct crt_stroke *stroke)
{
    crt_beam_write_stroke(ctx, stroke);
}

/* Where the trace ends by default; runs `rig`, which has no tube. */
static int default_end(struct trace *t, struct vm_rig *rig, bool beam, uint64_t *end,
                       struct crt_error *err)
{
    static const struct vm_moment_options none = {{0}, {0}, NULL};
    if (beam || t->input.is_recording)
        return vm_moment_find(rig, &none, &t->settings, &t->input, end, err);
    if (vm_machine_run_refresh(rig->machine, PATIENCE_PS))
        *end = rig->machine->now;
    else
        *end = crt_tick_time(t->settings.tick, 1);
    return VM_EXIT_OK;
}

static int find_end(struct trace *t, bool beam, uint64_t *end, struct crt_error *err)
{
    struct vm_rig rig;
    if (t->o.length.given) {
        if (!vm_time_ps(&t->o.length, t->settings.tick, end, err))
            return VM_EXIT_USAGE;
        if (*end == 0) {
            crt_fail(err, "--for: nothing happens in no time; give a time above zero");
            return VM_EXIT_USAGE;
        }
        return VM_EXIT_OK;
    }
    if (!vm_rig_open(&rig, &t->settings, &t->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    int status = default_end(t, &rig, beam, end, err);
    vm_rig_close(&rig);
    return status;
}

static void print_header(const struct trace *t, uint64_t end)
{
    struct crt_beam_header header = {.tick = t->settings.tick, .end = end};
    snprintf(header.tube, sizeof header.tube, "%s", t->settings.row.name);
    if (strcmp(t->settings.phosphor.name, t->settings.row.phosphor) != 0)
        snprintf(header.phosphor, sizeof header.phosphor, "%s", t->settings.phosphor.name);
    crt_beam_write_header(t->out, &header);
}

static int print_events(struct trace *t, struct crt_error *err)
{
    bool beam = t->o.what && strcmp(t->o.what, "beam") == 0;
    struct vm_hooks hooks = {t->out, beam ? NULL : print_word, beam ? print_stroke : NULL};
    struct crt_error trouble;
    struct vm_rig rig;
    uint64_t end = 0;
    int status = find_end(t, beam, &end, err);
    if (status)
        return status;
    if (!vm_rig_open(&rig, &t->settings, &t->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    if (beam)
        print_header(t, end);
    struct vm_progress progress;
    vm_progress_begin(&progress);
    vm_progress_trace(&progress, rig.machine, end, &hooks);
    vm_progress_end(&progress);
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (rig.machine->strokes == 0)
        vm_machine_run(rig.machine, VM_SETTLED_PS);
    enum vm_trouble found = vm_find_trouble(rig.machine, &t->input, &trouble);
    vm_rig_close(&rig);
    /* A trace of words in the dark is a good trace. */
    if (found == VM_NO_TROUBLE || (found == VM_TROUBLE_DARK && !beam))
        return VM_EXIT_OK;
    *err = trouble;
    return VM_EXIT_TROUBLE;
}

static int trace(struct trace *t)
{
    struct crt_error err;
    struct crt_error closing;
    int status =
        vm_settings_resolve(&t->o.settings, t->input.is_recording ? &t->input.header : NULL,
                            vm_input_tube(&t->input), &t->settings, &err);
    if (!status && !vm_out_open(&t->file, t->o.out ? t->o.out : "-", &err))
        status = VM_EXIT_TROUBLE;
    t->out = t->file.file;
    if (!status)
        status = t->o.summary
                     ? vm_print_summary(t->out, &t->o.length, &t->settings, &t->input, &err)
                     : print_events(t, &err);
    /* The trace of a program that hangs is kept: it shows how it came there. */
    bool keep = status == VM_EXIT_OK || status == VM_EXIT_TROUBLE;
    if (!vm_out_close(&t->file, keep, status ? &closing : &err) && !status)
        status = VM_EXIT_TROUBLE;
    vm_settings_free(&t->settings);
    return status ? fail(status, &err) : status;
}

static int run(int argc, char **argv)
{
    struct trace t = {0};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &t.o),
                                             VM_OPTION_TABLE(vm_settings_rows, &t.o.settings),
                                             VM_OPTION_TABLE(vm_input_rows, &t.o.input)};
    struct vm_args args;
    struct crt_error err;
    char *report;
    int status = vm_command_parse(&vm_command_trace, tables, 3, argc, argv, &args, 1, 1);
    if (status >= 0)
        return status;
    if (!vm_out_spares(t.o.out, args.item[0], &err))
        return fail(VM_EXIT_USAGE, &err);
    if (!vm_input_load(&t.input, args.item[0], &t.o.input, &err, &report)) {
        if (report)
            fputs(report, stderr);
        free(report);
        return report ? VM_EXIT_TROUBLE : fail(VM_EXIT_TROUBLE, &err);
    }
    bool words = t.o.summary || !t.o.what || strcmp(t.o.what, "dpu") == 0;
    if (t.input.is_recording && words) {
        crt_fail(&err, "%s is a recording; it has no words, only --what beam", t.input.name);
        status = fail(VM_EXIT_USAGE, &err);
    } else {
        status = trace(&t);
    }
    vm_input_free(&t.input);
    return status;
}

const struct vm_command vm_command_trace = {
    "trace",
    "FILE [--what dpu|beam] [--summary]",
    "Print what the machine does, one line per event",
    "dpu <time_ps> DPC=oooooo WORD=oooooo MPR=oooooo XPR=oooooo YPR=oooooo: a word, fetched at "
    "that time "
    "from DPC, and the registers as read after it. --what beam is the .beam format: capture reads "
    "it back "
    "to the same film.",
    "  kinescope trace roms/rose.df | head\n"
    "  kinescope trace roms/growing.df --summary --for 10s\n"
    "  kinescope trace roms/rose.df --what beam -o rose.beam",
    run,
};
