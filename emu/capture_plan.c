/* capture_plan.c — when pictures are taken, of which head, and for how long. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "crt/plan.h"
#include "crt/spot.h"
#include "emu/capture_parts.h"
#include "emu/command.h"
#include "emu/progress.h"
#include "emu/trouble.h"
#include "emu/view.h"

bool vm_capture_closeup(struct vm_capture *c, struct crt_error *err)
{
    struct crt_error why;
    double v[3];
    char text[64];
    const char *p = c->o.closeup;
    for (int i = 0; i < 3; i++) {
        size_t n = strcspn(p, ",");
        if (n >= sizeof text || (p[n] == ',') != (i < 2))
            return crt_fail(err, "--closeup: '%.60s' is not X,Y,WIDTH_MM, such as 512,512,10",
                            c->o.closeup);
        memcpy(text, p, n);
        text[n] = '\0';
        if (!vm_parse_real(text, i == 2 ? 0.1 : -1e5, i == 2 ? 4000 : 1e5, &v[i], &why))
            return crt_fail(err, "--closeup: %.400s", why.text);
        p += n + 1;
    }
    if (c->o.size.width % 8)
        return crt_fail(err, "--size: with --closeup the width must be a multiple of 8");
    c->closeup = (struct vm_closeup){v[0], v[1], v[2]};
    return true;
}

/* The microscope's grid on the one tube it looks at. */
static bool plan_closeup(struct vm_capture *c, const struct vm_machine *m, struct crt_error *err)
{
    struct vm_size size = c->o.size.width ? c->o.size : (struct vm_size){960, 720};
    enum vm_head head = c->view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
    double most = 2 * c->settings.monitor[head].row.width.value, x, y;
    if (c->view == VM_VIEW_BOTH)
        return crt_fail(err,
                        "--closeup looks at one tube, and %s uses both; give --view vector or "
                        "--view raster",
                        c->input.name);
    if (c->closeup.width_mm > most)
        return crt_fail(err, "--closeup: %g mm is more than this tube has; give at most %g",
                        c->closeup.width_mm, most);
    double coarsest = crt_spot_sigma0(&c->settings.monitor[head].row) / CRT_LEAST_SIGMA;
    if (c->closeup.width_mm > coarsest * size.width)
        return crt_fail(
            err,
            "--closeup: %g mm over %d pixels is coarser than the spot of this tube; give "
            "at most %.3g mm, or a --size of %.0f or more across",
            c->closeup.width_mm, size.width, coarsest * size.width,
            ceil(c->closeup.width_mm / coarsest / 8) * 8);
    vm_view_place(c->view, m, c->closeup.x, c->closeup.y, &x, &y);
    c->tubes.desc[head].grid = crt_grid_closeup(x, y, c->closeup.width_mm, size.width, size.height);
    c->tubes.desc[head].microscope = true;
    return true;
}

/* A head that is to be looked at, and has not been used although the other one has. */
static bool check_use(const struct vm_capture *c, const struct vm_machine *m, struct crt_error *err)
{
    bool vector = vm_machine_uses_vector(m), raster = vm_machine_uses_raster(m);
    if (c->o.allow_dark || c->input.is_recording)
        return true;
    if (c->view == VM_VIEW_VECTOR && !vector && raster)
        return crt_fail(err, "%s draws on the raster head alone by then; give --view raster",
                        c->input.name);
    return c->view != VM_VIEW_RASTER || raster ||
           crt_fail(err, "%s has not switched the raster head on by then; choose a later moment%s",
                    c->input.name, vector ? ", or --view vector" : "");
}

/* Which heads, by what tubes, how long. */
static int plan_view(struct vm_capture *c, const struct vm_machine *m, struct crt_error *err)
{
    c->view = vm_view_now(c->settings.view, m);
    if (!check_use(c, m, err))
        return VM_EXIT_TROUBLE;
    c->tubes = vm_settings_tubes(&c->settings, c->view);
    if (c->o.buffer)
        c->tubes.heads = 0;
    c->shots.exposure = vm_view_exposure(c->view, m);
    return !c->o.closeup || plan_closeup(c, m, err) ? VM_EXIT_OK : VM_EXIT_USAGE;
}

/* The sequence's instants, or the one moment. */
static bool plan_sequence(struct vm_capture *c, struct crt_error *err)
{
    const struct vm_capture_options *o = &c->o;
    uint64_t to;
    if (!vm_time_ps(&o->from, c->settings.tick, &c->shots.from, err) ||
        !vm_time_ps(&o->to, c->settings.tick, &to, err))
        return false;
    if (to <= c->shots.from)
        return crt_fail(err, "--to must be later than --from");
    c->shots.fps = o->fps.num ? o->fps : c->settings.tick;
    /* The pictures with from + n/fps < to. */
    c->shots.count = crt_tick_at(c->shots.fps, to - c->shots.from - 1) + 1;
    if (c->shots.count > 1000000)
        return crt_fail(err, "that would be %llu pictures; shorten the sequence or lower --fps",
                        (unsigned long long)c->shots.count);
    return true;
}

static int plan_exposure(struct vm_capture *c, struct crt_error *err)
{
    const struct vm_capture_options *o = &c->o;
    if (o->exposure.given) {
        if (!vm_time_ps(&o->exposure, c->settings.tick, &c->shots.exposure, err))
            return VM_EXIT_USAGE;
        if (c->shots.exposure == 0) {
            crt_fail(err, "--exposure: no light is gathered in no time; give a time above zero");
            return VM_EXIT_USAGE;
        }
        if (!c->sequence && c->shots.exposure > c->shots.from) {
            char moment[32];
            vm_format_time(c->shots.from, moment, sizeof moment);
            crt_fail(err,
                     "--exposure would begin before power-on, as the moment is %s; shorten it or "
                     "choose a later moment with --at",
                     moment);
            return VM_EXIT_USAGE;
        }
    }
    if (c->loaded && c->shots.from < c->loaded + c->shots.exposure) {
        char loaded[32], moment[32];
        vm_format_time(c->loaded, loaded, sizeof loaded);
        vm_format_time(c->shots.from, moment, sizeof moment);
        crt_fail(err,
                 "the machine of --load-state is as of %s; a picture at %s would gather light from "
                 "before that: choose a later moment, or a shorter --exposure",
                 loaded, moment);
        return VM_EXIT_USAGE;
    }
    if (vm_shots_overlap(&c->shots) > VM_OVERLAP_MAX) {
        crt_fail(err, "the exposure overlaps more than %d pictures; shorten it or lower --fps",
                 VM_OVERLAP_MAX);
        return VM_EXIT_USAGE;
    }
    return VM_EXIT_OK;
}

/* A picture of one tick shows little of a refresh that takes many, as on a slow tube. */
static void hint_at_exposure(const struct vm_capture *c, const struct vm_machine *m)
{
    char refresh[32], tick[32];
    uint64_t length = m->refreshes.last.end - m->refreshes.last.begin;
    if (c->sequence || c->o.exposure.given || c->o.moment.at.given || c->input.is_recording ||
        length <= 2 * c->shots.exposure)
        return;
    vm_format_time(length, refresh, sizeof refresh);
    vm_format_time(c->shots.exposure, tick, sizeof tick);
    fprintf(stderr,
            "kinescope capture: a refresh takes %s here and the picture gathers the last %s of "
            "it; --exposure %.0fms gathers all\n",
            refresh, tick, ceil((double)length / (double)CRT_PS_PER_MS));
}

int vm_capture_plan(struct vm_capture *c, struct crt_error *err)
{
    struct vm_rig rig;
    struct crt_error trouble;
    int status = VM_EXIT_OK;
    if (c->sequence && !plan_sequence(c, err))
        return VM_EXIT_USAGE;
    if (!vm_rig_open(&rig, &c->settings, &c->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    if (!vm_saved_load(&c->o.saved, &rig, &c->settings, &c->input, err)) {
        vm_rig_close(&rig);
        return VM_EXIT_TROUBLE;
    }
    c->loaded = rig.machine->now;
    if (c->sequence) {
        vm_progress_begin(&c->progress);
        vm_progress_run(&c->progress, rig.machine,
                        c->shots.from + crt_tick_time(c->shots.fps, c->shots.count - 1));
        vm_progress_end(&c->progress);
    } else {
        c->shots.count = 1;
        status = vm_moment_find(&rig, &c->o.moment, &c->settings, &c->input, &c->shots.from, err);
    }
    bool late = status == VM_EXIT_TIMEOUT, ran = status == VM_EXIT_OK || late;
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (ran && rig.machine->strokes == 0 && !vm_machine_uses_raster(rig.machine))
        vm_machine_run(rig.machine, VM_SETTLED_PS);
    enum vm_trouble found = ran ? vm_find_trouble(rig.machine, &c->input, &trouble) : VM_NO_TROUBLE;
    /* What firmware is waited for may come before its first light. */
    if (found && !(found == VM_TROUBLE_DARK && late && c->input.has_firmware)) {
        if (!c->o.allow_dark || late) {
            *err = trouble;
            status = VM_EXIT_TROUBLE;
        } else {
            fprintf(stderr, "kinescope capture: %s\n", trouble.text);
        }
    }
    if (status == VM_EXIT_OK)
        status = plan_view(c, rig.machine, err);
    if (status == VM_EXIT_OK)
        hint_at_exposure(c, rig.machine);
    vm_rig_close(&rig);
    return status ? status : plan_exposure(c, err);
}
