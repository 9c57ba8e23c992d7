/* probe_plan.c — from when to when, and at which head: found by running the program without light. */
#include <math.h>
#include <string.h>

#include "crt/maths.h"
#include "emu/command.h"
#include "emu/lab/probe_parts.h"
#include "emu/trouble.h"
#include "emu/view.h"

#define UNSETTLED 1e-4                /* part of the steady light that may still be missing */
#define LEAD_MOST (10 * CRT_PS_PER_S) /* no phosphor is waited for longer */
#define PERIODS   6                   /* of the default time, at least */
#define LENGTH_PS (CRT_PS_PER_S / 10) /* the same */
#define PATIENCE  (10 * CRT_PS_PER_S) /* for so many refreshes */
#define SLACK     1000                /* parts of a period more: what is whole is cut out later */
#define SAMPLES   1e7                 /* of --rate, at most */
#define LINES     4                   /* of the raster head's signals */

/* ---- when --------------------------------------------------------------------------------------- */

uint64_t vm_probe_fading(const struct crt_phosphor *p, double part)
{
    uint64_t t = CRT_PS_PER_MS;
    for (; t < LEAD_MOST; t += t / 16) {
        double left = 0;
        for (int k = 0; k < p->terms; k++)
            left += p->term[k].w * crt_exp(-(double)t * 1e-12 / p->term[k].tau_s);
        if (left <= part)
            return t;
    }
    return LEAD_MOST;
}

/* How long from power-on until all but UNSETTLED of the steady light is there. */
static uint64_t settling(const struct crt_phosphor *p)
{
    uint64_t t = vm_probe_fading(p, UNSETTLED);
    return t > VM_SETTLED_PS ? t : VM_SETTLED_PS;
}

/* A recording ends some time: its second half. */
static uint64_t middle_of_recording(const struct vm_input *input)
{
    return (input->header.end ? input->header.end : input->strokes[input->count - 1].t1) / 2;
}

/* The beginning, with the machine run to it. */
static int find_from(struct vm_probe_job *job, struct vm_rig *rig, struct crt_error *err)
{
    struct vm_machine *m = rig->machine;
    uint64_t loaded = m->now, slow;
    if (job->o.from.given && job->o.moment.when) {
        crt_fail(err, "--from and --when exclude each other");
        return VM_EXIT_USAGE;
    }
    if (job->o.from.given) {
        if (!vm_time_ps(&job->o.from, job->settings.tick, &job->from, err))
            return VM_EXIT_USAGE;
        if (job->from < loaded) {
            crt_fail(err, "--from is before the machine of --load-state");
            return VM_EXIT_USAGE;
        }
    } else if (job->input.is_recording && !job->o.moment.when) {
        job->from = middle_of_recording(&job->input);
    } else {
        int status =
            vm_moment_find(rig, &job->o.moment, &job->settings, &job->input, &job->from, err);
        if (status)
            return status;
        bool raster = vm_view_now(job->settings.view, m) == VM_VIEW_RASTER;
        slow = settling(&job->settings.monitor[raster ? VM_RASTER : VM_VECTOR].phosphor);
        if (!job->o.moment.when && !job->signals && loaded == 0)
            job->from += slow - VM_SETTLED_PS;
    }
    vm_progress_run(&job->progress, m, job->from);
    return VM_EXIT_OK;
}

/* Six refreshes and a tenth of a second by default, or as many as there are within some seconds. */
static uint64_t default_end(struct vm_machine *m, uint64_t from)
{
    const struct vm_refresh *last = &m->refreshes.last;
    struct vm_refresh first = {0};
    uint64_t found = 0;
    while (found < PERIODS && m->now < from + PATIENCE &&
           vm_machine_run_refresh(m, from + PATIENCE)) {
        if (first.number == 0)
            first = *last;
        found = last->number - first.number;
    }
    if (found == 0)
        return from + VM_SETTLED_PS;
    double period = (double)(last->end - first.end) / (double)found;
    double whole =
        found < PERIODS ? (double)found : fmax(PERIODS, ceil((double)LENGTH_PS / period));
    return from + (uint64_t)(whole * period + period / SLACK);
}

/* An oscilloscope shows one refresh of the vector head; of the raster head some lines in the middle of a
 * frame. */
static void find_signals(struct vm_probe_job *job, struct vm_machine *m)
{
    bool found = vm_machine_run_refresh(m, job->from + PATIENCE);
    const struct vm_refresh *last = &m->refreshes.last;
    if (job->place.head == VM_VECTOR) {
        job->to = found ? last->end : job->from + crt_tick_time(m->desc.tick, 1);
        if (found && !job->o.from.given && !job->o.moment.when)
            job->from = last->begin;
        return;
    }
    struct crt_rate lines = ras_line_rate(&m->raster.timing);
    if (found && !job->o.from.given && !job->o.moment.when) {
        uint64_t middle = last->begin + (last->end - last->begin) / 2, origin = m->raster.origin;
        job->from = origin + crt_tick_time(lines, crt_tick_at(lines, middle - origin));
    }
    job->to = job->from + crt_tick_time(lines, LINES);
}

static int find_to(struct vm_probe_job *job, struct vm_machine *m, struct crt_error *err)
{
    const struct vm_input *input = &job->input;
    if (job->o.to.given) {
        if (!vm_time_ps(&job->o.to, job->settings.tick, &job->to, err))
            return VM_EXIT_USAGE;
        if (job->to <= job->from) {
            char text[32];
            vm_format_time(job->from, text, sizeof text);
            crt_fail(err, "--to must be later than --from, which is %s here", text);
            return VM_EXIT_USAGE;
        }
    } else if (input->is_recording) {
        job->to = 2 * job->from;
    } else if (job->signals) {
        find_signals(job, m);
    } else {
        job->to = default_end(m, job->from);
    }
    return VM_EXIT_OK;
}

/* More samples than anybody reads are a slip of the hand. */
static bool check_samples(const struct vm_probe_job *job, struct crt_error *err)
{
    double count = job->o.rate * (double)(job->to - job->from) * 1e-12;
    return count <= SAMPLES ||
           crt_fail(err, "--rate: that would be %.3g samples; shorten the time or lower the rate",
                    count);
}

/* ---- where -------------------------------------------------------------------------------------- */

static bool find_head(struct vm_probe_job *job, const struct vm_machine *m, struct crt_error *err)
{
    enum vm_view view = vm_view_now(job->settings.view, m);
    bool vector = vm_machine_uses_vector(m), raster = vm_machine_uses_raster(m);
    if (view == VM_VIEW_BOTH)
        return crt_fail(err,
                        "a probe is at one head, and %s uses both; give --view vector or --view "
                        "raster",
                        job->input.name);
    if (view == VM_VIEW_VECTOR && !vector && raster && !job->o.allow_dark)
        return crt_fail(err, "%s draws on the raster head alone by then; give --view raster",
                        job->input.name);
    if (view == VM_VIEW_RASTER && !raster && !job->o.allow_dark)
        return crt_fail(err,
                        "%s has not switched the raster head on by then; choose a later --from%s",
                        job->input.name, vector ? ", or --view vector" : "");
    job->place.head = view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
    if (job->place.kind != CRT_DIODE_SCREEN)
        vm_view_place(view, m, job->place.x, job->place.y, &job->place.x_mm, &job->place.y_mm);
    if (job->o.along)
        vm_view_place(view, m, job->along[0], job->along[1], &job->along_mm[0], &job->along_mm[1]);
    job->place.in_mm = true;
    return true;
}

/* A program in trouble has no light worth measuring. */
static bool check_trouble(const struct vm_probe_job *job, struct vm_machine *m,
                          struct crt_error *err)
{
    struct crt_error trouble;
    /* What has not lit the beam yet may still do so, after its first sync tick. */
    if (m->strokes == 0 && !vm_machine_uses_raster(m))
        vm_machine_run(m, VM_SETTLED_PS);
    enum vm_trouble found = vm_find_trouble(m, &job->input, &trouble);
    if (!found || job->o.allow_dark || (found == VM_TROUBLE_DARK && vm_machine_uses_raster(m)))
        return true;
    *err = trouble;
    return false;
}

static int plan(struct vm_probe_job *job, struct vm_rig *rig, struct crt_error *err)
{
    struct vm_machine *m = rig->machine;
    int status = find_from(job, rig, err);
    if (status)
        return status;
    if (!find_head(job, m, err))
        return VM_EXIT_USAGE;
    status = find_to(job, m, err);
    if (status)
        return status;
    if (!check_samples(job, err))
        return VM_EXIT_USAGE;
    vm_progress_run(&job->progress, m, job->to);
    return check_trouble(job, m, err) ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}

int vm_probe_plan(struct vm_probe_job *job, struct crt_error *err)
{
    struct vm_rig rig;
    if (!vm_rig_open(&rig, &job->settings, &job->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    int status = vm_saved_load(&job->o.saved, &rig, &job->settings, &job->input, err)
                     ? VM_EXIT_OK
                     : VM_EXIT_TROUBLE;
    vm_progress_begin(&job->progress);
    if (!status)
        status = plan(job, &rig, err);
    vm_progress_end(&job->progress);
    vm_rig_close(&rig);
    return status;
}
