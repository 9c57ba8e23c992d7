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
static bool plan_closeup(const struct vm_capture *c, struct vm_capture_side *side,
                         const struct vm_machine *m, struct crt_error *err)
{
    struct vm_size size = c->o.size.width ? c->o.size : (struct vm_size){960, 720};
    enum vm_head head = side->view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
    double most = 2 * side->settings.monitor[head].row.width.value, x, y;
    if (side->view == VM_VIEW_BOTH)
        return crt_fail(err,
                        "--closeup looks at one tube, and %s uses both; give --view vector or "
                        "--view raster",
                        c->input.name);
    if (c->closeup.width_mm > most)
        return crt_fail(err, "--closeup: %g mm is more than this tube has; give at most %g",
                        c->closeup.width_mm, most);
    double coarsest = crt_spot_sigma0(&side->settings.monitor[head].row) / CRT_LEAST_SIGMA;
    if (c->closeup.width_mm > coarsest * size.width)
        return crt_fail(
            err,
            "--closeup: %g mm over %d pixels is coarser than the spot of this tube; give "
            "at most %.3g mm, or a --size of %.0f or more across",
            c->closeup.width_mm, size.width, coarsest * size.width,
            ceil(c->closeup.width_mm / coarsest / 8) * 8);
    vm_view_place(side->view, m, c->closeup.x, c->closeup.y, &x, &y);
    side->tubes.desc[head].grid =
        crt_grid_closeup(x, y, c->closeup.width_mm, size.width, size.height);
    side->tubes.desc[head].microscope = true;
    return true;
}

/* A head that is to be looked at, and has not been used although the other one has. */
static bool check_use(const struct vm_capture *c, enum vm_view view, const struct vm_machine *m,
                      struct crt_error *err)
{
    bool vector = vm_machine_uses_vector(m), raster = vm_machine_uses_raster(m);
    if (c->o.allow_dark || c->input.is_recording)
        return true;
    if (view == VM_VIEW_VECTOR && !vector && raster)
        return crt_fail(err, "%s draws on the raster head alone by then; give --view raster",
                        c->input.name);
    return view != VM_VIEW_RASTER || raster ||
           crt_fail(err, "%s has not switched the raster head on by then; choose a later moment%s",
                    c->input.name, vector ? ", or --view vector" : "");
}

/* Which heads, by what tubes, how long. */
static int plan_view(const struct vm_capture *c, struct vm_capture_side *side,
                     const struct vm_machine *m, struct crt_error *err)
{
    side->view = vm_view_now(side->settings.view, m);
    if (!check_use(c, side->view, m, err))
        return VM_EXIT_TROUBLE;
    side->timing = m->desc.buffer ? m->raster.timing : side->settings.timing;
    side->tubes = vm_settings_tubes(&side->settings, side->view);
    if (c->o.buffer)
        side->tubes.heads = 0;
    side->exposure = c->step ? 0 : vm_view_exposure(side->view, m);
    return !c->o.closeup || plan_closeup(c, side, m, err) ? VM_EXIT_OK : VM_EXIT_USAGE;
}

/* ---- instants -----------------------------------------------------------------------------------
 */

/* The sequence's instants: those with from + n/fps < to. */
static bool plan_sequence(struct vm_capture *c, struct crt_error *err)
{
    const struct vm_capture_options *o = &c->o;
    struct crt_rate tick = c->side[0].settings.tick;
    uint64_t from, to;
    if (!vm_time_ps(&o->from, tick, &from, err) || !vm_time_ps(&o->to, tick, &to, err))
        return false;
    if (to <= from)
        return crt_fail(err, "--to must be later than --from");
    c->fps = o->fps.num ? o->fps : tick;
    uint64_t count = crt_tick_at(c->fps, to - from - 1) + 1;
    if (count > 1000000)
        return crt_fail(err, "that would be %llu pictures; shorten the sequence or lower --fps",
                        (unsigned long long)count);
    if (!vm_shots_init(&c->shots, count, err))
        return false;
    vm_shots_at_rate(&c->shots, from, c->fps);
    return true;
}

static uint64_t last_instant(const struct vm_capture *c)
{
    return c->shots.shot[c->shots.count - 1].at;
}

static void run_to(struct vm_capture *c, struct vm_machine *m, uint64_t until)
{
    vm_progress_begin(&c->progress);
    vm_progress_run(&c->progress, m, until);
    vm_progress_end(&c->progress);
}

/* To where the raster head's next picture begins: lines of blanking are nothing to look at. */
static void run_to_top(struct vm_machine *m)
{
    uint64_t limit = m->now + CRT_PS_PER_S / 2;
    uint32_t line, dot;
    while (vm_machine_run_line(m, limit))
        if (ras_head_beam(&m->raster, m->now, &line, &dot) && line == 0)
            return;
}

/* The steps from `moment` on; a machine that has run further is of no use for that. */
static int plan_steps(struct vm_capture *c, struct vm_rig *rig, uint64_t moment,
                      struct crt_error *err)
{
    if (rig->machine->now > moment) {
        vm_rig_close(rig);
        if (!vm_rig_open(rig, &c->side[0].settings, &c->input, DF_TIMING_VALUE, NULL, err) ||
            !vm_saved_load(&c->o.saved, rig, &c->side[0].settings, &c->input, err))
            return VM_EXIT_TROUBLE;
    }
    run_to(c, rig->machine, moment);
    if (c->unit == VM_UNIT_LINE && !c->o.moment.at.given && !c->o.moment.when)
        run_to_top(rig->machine);
    return vm_capture_steps(c, rig->machine, err);
}

/* Runs the left side's machine through all instants, which it finds where events say them. */
static int find_instants(struct vm_capture *c, struct vm_rig *rig, struct crt_error *err)
{
    uint64_t moment = rig->machine->now; /* kept when there is no such moment */
    if (c->sequence && !c->step) {
        run_to(c, rig->machine, last_instant(c));
        return VM_EXIT_OK;
    }
    int status = vm_moment_find(rig, &c->o.moment, &c->side[0].settings, &c->input, &moment, err);
    if (status == VM_EXIT_OK && c->step)
        return plan_steps(c, rig, moment, err);
    if (!vm_shots_init(&c->shots, 1, err))
        return VM_EXIT_TROUBLE;
    c->shots.shot[0] = (struct vm_shot){moment, moment};
    return status;
}

/* ---- exposure -----------------------------------------------------------------------------------
 */

static int usage(bool ok)
{
    return ok ? VM_EXIT_OK : VM_EXIT_USAGE;
}

static bool take_exposure(const struct vm_capture *c, struct vm_capture_side *side,
                          struct crt_error *err)
{
    uint64_t first = c->shots.shot[0].at;
    if (!side->o.exposure.given)
        return true;
    if (!vm_time_ps(&side->o.exposure, side->settings.tick, &side->exposure, err))
        return false;
    if (side->exposure == 0)
        return crt_fail(err, "--exposure: no light is gathered in no time; give a time above zero");
    if (!c->sequence && side->exposure > first) {
        char moment[32];
        vm_format_time(first, moment, sizeof moment);
        return crt_fail(err,
                        "--exposure would begin before power-on, as the moment is %s; shorten it "
                        "or choose a later moment with --at",
                        moment);
    }
    return true;
}

static int plan_exposure(const struct vm_capture *c, struct vm_capture_side *side,
                         struct crt_error *err)
{
    const struct vm_shot *first = &c->shots.shot[0];
    if (!take_exposure(c, side, err))
        return VM_EXIT_USAGE;
    uint64_t opens = side->exposure ? first->at - (first->at < side->exposure ? 0 : side->exposure)
                                    : first->begin;
    if (side->loaded && (opens < side->loaded || first->at < side->exposure)) {
        char loaded[32], moment[32];
        vm_format_time(side->loaded, loaded, sizeof loaded);
        vm_format_time(first->at, moment, sizeof moment);
        crt_fail(err,
                 "the machine of --load-state is as of %s; a picture at %s would gather light from "
                 "before that: choose a later moment, or a shorter --exposure",
                 loaded, moment);
        return VM_EXIT_USAGE;
    }
    return usage(vm_shots_overlap(&c->shots, side->exposure) <= VM_OVERLAP_MAX ||
                 crt_fail(err, "the exposure overlaps more than %d pictures; shorten it or %s",
                          VM_OVERLAP_MAX, c->step ? "take longer steps" : "lower --fps"));
}

/* A picture of one tick shows little of a refresh that takes many, as on a slow tube. */
static void hint_at_exposure(const struct vm_capture *c, const struct vm_capture_side *side,
                             const struct vm_machine *m)
{
    char refresh[32], tick[32];
    uint64_t length = m->refreshes.last.end - m->refreshes.last.begin;
    if (c->sequence || side->o.exposure.given || c->o.moment.at.given || c->input.is_recording ||
        length <= 2 * side->exposure)
        return;
    vm_format_time(length, refresh, sizeof refresh);
    vm_format_time(side->exposure, tick, sizeof tick);
    fprintf(stderr,
            "kinescope capture: a refresh takes %s here and the picture gathers the last %s of "
            "it; --exposure %.0fms gathers all\n",
            refresh, tick, ceil((double)length / (double)CRT_PS_PER_MS));
}

/* ---- all ----------------------------------------------------------------------------------------
 */

/* Whether the program is in trouble where the pictures are; `late`: its moment has not come. */
static int check_trouble(const struct vm_capture *c, struct vm_machine *m, bool late,
                         struct crt_error *err)
{
    struct crt_error trouble;
    /* A program that has not lit the beam yet may still do so, after its first sync tick. */
    if (m->strokes == 0 && !vm_machine_uses_raster(m))
        vm_machine_run(m, VM_SETTLED_PS);
    enum vm_trouble found = vm_find_trouble(m, &c->input, &trouble);
    /* What firmware is waited for may come before its first light. */
    if (!found || (found == VM_TROUBLE_DARK && late && c->input.has_firmware))
        return late ? VM_EXIT_TIMEOUT : VM_EXIT_OK;
    if (!c->o.allow_dark || late) {
        *err = trouble;
        return VM_EXIT_TROUBLE;
    }
    fprintf(stderr, "kinescope capture: %s\n", trouble.text);
    return VM_EXIT_OK;
}

static int plan_run(struct vm_capture *c, struct vm_capture_side *side, struct vm_rig *rig,
                    struct crt_error *err)
{
    int status = VM_EXIT_OK;
    if (!vm_saved_load(&c->o.saved, rig, &side->settings, &c->input, err))
        return VM_EXIT_TROUBLE;
    side->loaded = rig->machine->now;
    if (side == &c->side[0])
        status = find_instants(c, rig, err);
    else
        run_to(c, rig->machine, last_instant(c));
    bool late = status == VM_EXIT_TIMEOUT;
    if (status == VM_EXIT_OK || late)
        status = check_trouble(c, rig->machine, late, err);
    if (status == VM_EXIT_OK)
        status = plan_view(c, side, rig->machine, err);
    if (status == VM_EXIT_OK)
        hint_at_exposure(c, side, rig->machine);
    return status;
}

static int plan_side(struct vm_capture *c, struct vm_capture_side *side, struct crt_error *err)
{
    struct vm_rig rig;
    if (!vm_rig_open(&rig, &side->settings, &c->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    int status = plan_run(c, side, &rig, err);
    vm_rig_close(&rig);
    return status;
}

/* As many pictures as the sheet has places. */
static void choose_for_sheet(struct vm_capture *c)
{
    uint64_t most = (uint64_t)c->places.width * (uint64_t)c->places.height;
    for (uint64_t n = 0; c->word && n < most && n < c->shots.count; n++)
        c->word[n] = c->word[vm_shots_chosen(n, c->shots.count, most)];
    c->all = c->shots.count;
    vm_shots_choose(&c->shots, most);
}

int vm_capture_plan(struct vm_capture *c, struct crt_error *err)
{
    int status = VM_EXIT_OK;
    struct crt_error why;
    if (c->sequence && !c->step && !plan_sequence(c, err))
        return VM_EXIT_USAGE;
    for (int i = 0; i < c->sides && status == VM_EXIT_OK; i++) {
        status = plan_side(c, &c->side[i], &why);
        if (status == VM_EXIT_OK && i == 0 && c->places.width)
            choose_for_sheet(c);
        if (status == VM_EXIT_OK)
            status = plan_exposure(c, &c->side[i], &why);
        if (status != VM_EXIT_OK)
            crt_fail(err, "%s%.490s", i ? "--versus: " : "", why.text);
    }
    return status;
}
