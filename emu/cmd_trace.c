/* trace — one text line per event: words, pieces of lit beam, instructions, interrupts. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/beam_file.h"
#include "emu/command.h"
#include "emu/moment.h"
#include "emu/out_file.h"
#include "emu/progress.h"
#include "emu/saved.h"
#include "emu/program_settings.h"
#include "emu/summary.h"
#include "emu/trace_lines.h"
#include "emu/trouble.h"
#include "emu/view.h"

struct options {
    const char *what, *out;
    struct vm_time from, length;
    bool summary;
    struct vm_saved_options saved;
    struct vm_settings_options settings;
    struct vm_input_options input;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"what", 0, VM_OPT_CHOICE, ROW(what), "dpu|beam|cpu|irq|video|input",
     "dpu: a line per word executed (default); beam: a line per piece of lit beam, the .beam "
     "format; "
     "cpu: a line per instruction with its effect; irq: a line per change of an interrupt line, "
     "and "
     "per interrupt taken; video: sync pulses, rows of the picture and what is taken at retrace; "
     "input: what a person does (--input), and what the devices report",
     0, 0},
    {"for", 0, VM_OPT_TIME, ROW(length), "T",
     "trace this much simulated time; default: dpu one refresh, beam to the moment capture would "
     "choose, cpu 1 ms, irq 0.5 s, video one frame, input to the end of the script",
     0, 0},
    {"from", 0, VM_OPT_TIME, ROW(from), "T",
     "begin to trace then; default power-on, of video when it is on", 0, 0},
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

static enum vm_trace_what what_of(const struct trace *t)
{
    static const char *const names[] = {"dpu", "beam", "cpu", "irq", "video", "input"};
    int what = 0;
    for (int i = 0; i < 6; i++)
        if (t->o.what && strcmp(t->o.what, names[i]) == 0)
            what = i;
    return (enum vm_trace_what)what;
}

/* Where the trace ends by default; runs `rig`, which has no tube. */
static int default_end(struct trace *t, struct vm_rig *rig, uint64_t from, uint64_t *end,
                       struct crt_error *err)
{
    static const struct vm_moment_options none = {{0}, {0}, NULL};
    enum vm_trace_what what = what_of(t);
    if (what == VM_TRACE_BEAM || t->input.is_recording) {
        int status = vm_moment_find(rig, &none, &t->settings, &t->input, end, err);
        *end = *end > from ? *end : from + 1;
        return status;
    }
    if (what == VM_TRACE_VIDEO) {
        vm_machine_run(rig->machine, from);
        *end = from + vm_view_exposure(VM_VIEW_RASTER, rig->machine);
        return VM_EXIT_OK;
    }
    if (what == VM_TRACE_INPUT) {
        uint64_t last = t->input.script.end;
        *end = (last > from ? last : from) + VM_SETTLED_PS;
        return VM_EXIT_OK;
    }
    if (what == VM_TRACE_CPU || what == VM_TRACE_IRQ) {
        *end = from + (what == VM_TRACE_CPU ? CRT_PS_PER_MS : VM_SETTLED_PS);
        return VM_EXIT_OK;
    }
    vm_machine_run(rig->machine, from);
    if (vm_machine_run_refresh(rig->machine, from + PATIENCE_PS))
        *end = rig->machine->now;
    else
        *end = from + crt_tick_time(t->settings.tick, 1);
    return VM_EXIT_OK;
}

/* A rig as --load-state has it; lit only for --save-state. */
static bool open_rig(struct trace *t, bool lit, struct vm_rig *rig, struct crt_error *err)
{
    struct vm_tubes tubes = vm_settings_tubes(&t->settings, t->settings.view);
    if (!vm_rig_open(rig, &t->settings, &t->input, DF_TIMING_VALUE, lit ? &tubes : NULL, err))
        return false;
    if (vm_saved_load(&t->o.saved, rig, &t->settings, &t->input, err))
        return true;
    vm_rig_close(rig);
    return false;
}

/* Until the program switches the raster head on, if it does soon. */
static void wait_for_video(struct vm_machine *m)
{
    uint64_t limit = m->now + VM_SETTLED_PS;
    while (m->now < limit && !vm_machine_uses_raster(m))
        vm_machine_run(m, m->now + CRT_PS_PER_MS);
}

static int find_times(struct trace *t, struct vm_rig *rig, uint64_t *from, uint64_t *end,
                      struct crt_error *err)
{
    uint64_t length;
    *from = rig->machine->now;
    if (t->o.from.given) {
        if (!vm_time_ps(&t->o.from, t->settings.tick, from, err))
            return VM_EXIT_USAGE;
        if (*from < rig->machine->now) {
            crt_fail(err, "--from is before the machine of --load-state");
            return VM_EXIT_USAGE;
        }
    } else if (what_of(t) == VM_TRACE_VIDEO) {
        wait_for_video(rig->machine);
        *from = rig->machine->now;
    }
    if (!t->o.length.given)
        return default_end(t, rig, *from, end, err);
    if (!vm_time_ps(&t->o.length, t->settings.tick, &length, err))
        return VM_EXIT_USAGE;
    *end = *from + length;
    if (length > 0)
        return VM_EXIT_OK;
    crt_fail(err, "--for: nothing happens in no time; give a time above zero");
    return VM_EXIT_USAGE;
}

/* From when to when, found on a rig of its own. */
static int plan(struct trace *t, uint64_t *from, uint64_t *end, struct crt_error *err)
{
    struct vm_rig rig;
    if (!open_rig(t, false, &rig, err))
        return VM_EXIT_TROUBLE;
    int status = find_times(t, &rig, from, end, err);
    vm_rig_close(&rig);
    return status;
}

static void print_header(const struct trace *t, uint64_t end)
{
    struct crt_beam_header header = {.tick = t->settings.tick, .end = end};
    snprintf(header.tube, sizeof header.tube, "%s", t->settings.monitor[VM_VECTOR].row.name);
    if (strcmp(t->settings.monitor[VM_VECTOR].phosphor.name,
               t->settings.monitor[VM_VECTOR].row.phosphor) != 0)
        snprintf(header.phosphor, sizeof header.phosphor, "%s",
                 t->settings.monitor[VM_VECTOR].phosphor.name);
    crt_beam_write_header(t->out, &header);
}

/* Whether the program did what its trace is for. A trace of words, instructions or interrupts in the
 * dark is a good trace. */
static int judge(struct trace *t, struct vm_rig *rig, struct crt_error *err)
{
    struct crt_error trouble;
    const struct vm_machine *m = rig->machine;
    if (what_of(t) == VM_TRACE_BEAM && vm_machine_uses_raster(m) && !vm_machine_uses_vector(m)) {
        crt_fail(err,
                 "--what beam writes the strokes of the vector head, and %s draws with the raster "
                 "head alone; --what video writes its rows",
                 t->input.name);
        return VM_EXIT_TROUBLE;
    }
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (rig->machine->strokes == 0 && !rig->board)
        vm_machine_run(rig->machine, VM_SETTLED_PS);
    enum vm_trouble found = vm_find_trouble(rig->machine, &t->input, &trouble);
    if (what_of(t) == VM_TRACE_VIDEO && !vm_machine_uses_raster(rig->machine)) {
        crt_fail(err,
                 "%s has not switched the raster head on by then: there are no rows and no sync "
                 "pulses",
                 t->input.name);
        return VM_EXIT_TROUBLE;
    }
    if (found == VM_NO_TROUBLE || (found == VM_TROUBLE_DARK && what_of(t) != VM_TRACE_BEAM))
        return VM_EXIT_OK;
    *err = trouble;
    return VM_EXIT_TROUBLE;
}

static int print_events(struct trace *t, struct crt_error *err)
{
    struct vm_trace_lines lines;
    struct vm_rig rig;
    uint64_t from, end = 0;
    int status = plan(t, &from, &end, err);
    if (status)
        return status;
    if (!open_rig(t, t->o.saved.save != NULL, &rig, err))
        return VM_EXIT_TROUBLE;
    if (what_of(t) == VM_TRACE_BEAM)
        print_header(t, end);
    struct vm_progress progress;
    vm_progress_begin(&progress);
    vm_progress_run(&progress, rig.machine, from);
    vm_trace_lines_init(&lines, what_of(t), t->out, rig.machine);
    vm_progress_trace(&progress, rig.machine, end, &lines.hooks);
    vm_progress_end(&progress);
    status = vm_saved_save(&t->o.saved, &rig, &t->settings, &t->input, err) ? judge(t, &rig, err)
                                                                            : VM_EXIT_TROUBLE;
    vm_rig_close(&rig);
    return status;
}

static int trace(struct trace *t)
{
    struct crt_error err;
    struct crt_error closing;
    int status = vm_program_settings(&t->o.settings, &t->input, &t->settings, &err);
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
    const struct vm_option_table tables[] = {
        VM_OPTION_TABLE(rows, &t.o), VM_OPTION_TABLE(vm_settings_rows, &t.o.settings),
        VM_OPTION_TABLE(vm_input_rows, &t.o.input), VM_OPTION_TABLE(vm_saved_rows, &t.o.saved)};
    struct vm_args args;
    struct crt_error err;
    int status = vm_command_parse(&vm_command_trace, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 1, 1);
    if (status >= 0)
        return status;
    if (!vm_input_check(&t.o.input, &err))
        return fail(VM_EXIT_USAGE, &err);
    status = vm_saved_check(&t.o.saved, args.item[0], &t.o.input, t.o.out, &err);
    if (status)
        return fail(status, &err);
    if (!vm_command_load(&t.input, args.item[0], &t.o.input, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    enum vm_trace_what what = what_of(&t);
    if (t.input.is_recording && (t.o.summary || what != VM_TRACE_BEAM)) {
        crt_fail(&err, "%s is a recording; it has no words, only --what beam", t.input.name);
        status = fail(VM_EXIT_USAGE, &err);
    } else if (!t.input.has_firmware &&
               (what == VM_TRACE_CPU || what == VM_TRACE_IRQ || what == VM_TRACE_VIDEO)) {
        crt_fail(&err, "--what %s needs firmware; %s runs without a processor", t.o.what,
                 t.input.name);
        status = fail(VM_EXIT_USAGE, &err);
    } else if (t.o.summary && (t.o.saved.load || t.o.saved.save || t.o.from.given)) {
        crt_fail(&err, "--summary measures from power-on; leave out --load-state, --save-state and "
                       "--from");
        status = fail(VM_EXIT_USAGE, &err);
    } else {
        status = trace(&t);
    }
    vm_input_free(&t.input);
    return status;
}

const struct vm_command vm_command_trace = {
    "trace",
    "FILE [--what dpu|beam|cpu|irq|video|input]",
    "Print what the machine does, one line per event",
    "dpu <time_ps> DPC=oooooo WORD=oooooo MPR=oooooo XPR=oooooo YPR=oooooo: a word, fetched at "
    "that time "
    "from DPC, and the registers as read after it. --what beam is the .beam format: capture reads "
    "it back "
    "to the same film. cpu <time_ps> PC=hhhhhhhh WORD=hhhhhhhh text effect: an instruction, begun "
    "at that "
    "time, and the register or memory it wrote.",
    "  kinescope trace roms/rose.df | head\n"
    "  kinescope trace roms/growing.df --summary --for 10s\n"
    "  kinescope trace roms/rose.df --what beam -o rose.beam\n"
    "  kinescope trace roms/hello.elf --what cpu | head\n"
    "  kinescope trace roms/stops.elf --what irq --for 100ms\n"
    "  kinescope trace roms/sketch.elf --what input --input roms/sketch.script",
    run,
};
