/* probe_parts.h — what the files of the probe command share; not for others.
 *
 *      cmd_probe.c   options, the lit run        probe_plan.c     from when to when, of which head
 *      probe_json.c  figures                     probe_csv.c      samples
 *      probe_along.c luminance along a line
 *      probe_signal.h                            probe_traces.c   deflection and grid signals as CSV and plot
 *
 * Time:       picoseconds since power-on.
 * Ownership:  the struct is cmd_probe.c's.
 * Errors:     an exit status and one sentence.
 */
#ifndef EMU_LAB_PROBE_PARTS_H
#define EMU_LAB_PROBE_PARTS_H

#include <stdio.h>

#include "emu/lab/probe.h"
#include "emu/lab/probe_signal.h"
#include "emu/moment.h"
#include "emu/progress.h"
#include "emu/roms.h"
#include "emu/saved.h"

struct vm_probe_options {
    const char *place, *along, *csv, *out, *signal, *field;
    struct vm_time from, to;
    struct vm_size size;
    double area, pupil, luminance, rate;
    bool screen, projector, log, allow_dark;
    struct vm_moment_options moment;
    struct vm_saved_options saved;
    struct vm_roms_options roms;
    struct vm_settings_options settings;
    struct vm_input_options input;
};

struct vm_probe_job {
    struct vm_probe_options o;
    struct vm_input input;
    struct vm_settings settings;
    struct vm_probe_place place;  /* in mm once planned */
    double along[2], along_mm[2]; /* --along: head units, mm */
    uint64_t from, to;            /* asked for, or found */
    unsigned signals;             /* bits of enum vm_signal; 0: light */
    struct vm_progress progress;
};

/* Runs the program without light: head, place and time. An exit status. */
int vm_probe_plan(struct vm_probe_job *job, struct crt_error *err);

/* How long light takes to fade until that part of it is still to come: w·e^(−t/tau) of each term is. At most
 * ten seconds. */
uint64_t vm_probe_fading(const struct crt_phosphor *phosphor, double part);

/* CSV with one line of column names; `path` may be "-". */
bool vm_probe_write_csv(const char *path, const struct vm_probe *probe,
                        const struct vm_probe_wave *wave, struct crt_error *err);

/* For vm_plain_seconds(). */
#define VM_SECONDS_TEXT 40
/* As many digits as a float has; "null" where it is no number. */
void vm_probe_number(FILE *out, double value);

/* A member of a JSON object, on a line of its own after others. */
void vm_probe_put_text(FILE *out, const char *name, const char *value);
void vm_probe_put_number(FILE *out, const char *name, double value);
void vm_probe_put_seconds(FILE *out, const char *name, uint64_t ps);

/* Whether CSV or plot go to standard output, where figures would be in their way. */
bool vm_probe_to_stdout(const struct vm_probe_options *options);

/* --along: from a rig that has run to where light begins to matter, to all that is to be written. */
bool vm_probe_measure_along(struct vm_probe_job *job, struct vm_rig *rig, struct crt_error *err);

/* --signal: the whole of it, with its files. An exit status. */
int vm_probe_signals(struct vm_probe_job *job, struct crt_error *err);

#endif
