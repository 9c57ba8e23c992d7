/* probe_along.c — probe --along: the mean luminance along a line, as JSON, CSV and a plot. */
#include <math.h>

#include "emu/json_out.h"
#include "emu/lab/probe_parts.h"
#include "emu/lab/profile.h"
#include "emu/out_file.h"

#define STEPS 256 /* of a run to its beginning, at most so many pieces of light to forget at once */

struct along {
    struct vm_probe_job *job;
    const struct vm_monitor *monitor;
    struct vm_profile profile;
    struct vm_profile_figures figures;
};

static void lead_in(struct along *a, struct vm_machine *m)
{
    uint64_t piece = a->job->from / STEPS + 1;
    while (m->now < a->job->from) {
        uint64_t next = m->now + piece;
        vm_progress_run(&a->job->progress, m, next < a->job->from ? next : a->job->from);
        vm_profile_forget(&a->profile, m->now);
    }
}

static void print_json(const struct along *a)
{
    const struct vm_profile_figures *f = &a->figures;
    fputs("{\"program\": ", stdout);
    vm_json_text(stdout, a->job->input.name);
    vm_probe_put_text(stdout, "tube", a->monitor->row.name);
    vm_probe_put_text(stdout, "phosphor", a->monitor->phosphor.name);
    vm_probe_put_text(stdout, "head", a->job->place.head == VM_RASTER ? "raster" : "vector");
    vm_probe_put_number(stdout, "x", a->job->place.x);
    vm_probe_put_number(stdout, "y", a->job->place.y);
    vm_probe_put_number(stdout, "x2", a->job->along[0]);
    vm_probe_put_number(stdout, "y2", a->job->along[1]);
    vm_probe_put_seconds(stdout, "from_s", a->job->from);
    vm_probe_put_seconds(stdout, "to_s", a->job->to);
    vm_probe_put_number(stdout, "length_mm", f->length_mm);
    vm_probe_put_number(stdout, "mean_cd_m2", f->mean_cd_m2);
    vm_probe_put_number(stdout, "least_cd_m2", f->least_cd_m2);
    vm_probe_put_number(stdout, "crest_cd_m2", f->crest_cd_m2);
    vm_probe_put_number(stdout, "crest_mm", f->crest_mm);
    printf(",\n \"crests\": %d", f->crests);
    vm_probe_put_number(stdout, "width60_mm", f->width60_mm);
    vm_probe_put_number(stdout, "width50_mm", f->width50_mm);
    vm_probe_put_number(stdout, "dip_cd_m2", f->dip_cd_m2);
    vm_probe_put_number(stdout, "dip_modulation", f->dip_modulation);
    vm_probe_put_number(stdout, "apart_mm", f->apart_mm);
    puts("}");
}

static bool write_csv(const struct along *a, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    bool ok = vm_out_open(&out, a->job->o.csv, err);
    if (ok)
        fputs("mm,cd_m2\n", out.file);
    for (int i = 0; ok && i < VM_PROFILE_POINTS; i++) {
        vm_probe_number(out.file, a->profile.mm[i]);
        putc(',', out.file);
        vm_probe_number(out.file, a->profile.cd_m2[i]);
        putc('\n', out.file);
    }
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}

static void put_note(const struct along *a, char *text, size_t size)
{
    const struct vm_profile_figures *f = &a->figures;
    int n = snprintf(text, size, "highest %.4g cd/m², %d crest%s", f->crest_cd_m2, f->crests,
                     f->crests == 1 ? "" : "s");
    if (isfinite(f->width60_mm))
        n += snprintf(text + n, size - (size_t)n, "; %.3f mm wide at 60 %%, %.3f mm at half",
                      f->width60_mm, f->width50_mm);
    if (f->crests > 1)
        snprintf(text + n, size - (size_t)n,
                 "; between the two highest, %.3f mm apart, %.4g cd/m²: modulation %.3g %%",
                 f->apart_mm, f->dip_cd_m2, 100 * f->dip_modulation);
}

static bool write_plot(const struct along *a, struct crt_error *err)
{
    const struct vm_probe_options *o = &a->job->o;
    char title[200], note[300];
    struct crt_image image;
    snprintf(title, sizeof title, "%s on %s %s, from %s to %s", a->job->input.name,
             a->monitor->row.name, a->monitor->phosphor.name, o->place, o->along);
    put_note(a, note, sizeof note);
    struct vm_plot plot = {
        .title = title, .note = note, .x = {.label = "along the line, mm"}, .panel_count = 1};
    plot.panel[0] = (struct vm_plot_panel){
        .y = {.label = "mean luminance, cd/m²", .log = o->log},
        .series = {{.kind = VM_PLOT_LINE,
                    .x = a->profile.mm,
                    .y = a->profile.cd_m2,
                    .count = VM_PROFILE_POINTS,
                    .colour = -1}},
        .series_count = 1,
    };
    if (a->figures.crests == 1 && isfinite(a->figures.width60_mm)) {
        plot.panel[0].mark[0] =
            (struct vm_plot_mark){.at = 0.6 * a->figures.crest_cd_m2, .label = "60 %"};
        plot.panel[0].mark_count = 1;
    }
    if (!vm_plot_draw(&plot, o->size.width ? o->size : vm_plot_size,
                      o->projector ? VM_PLOT_PROJECTOR : VM_PLOT_PAPER, &image, err))
        return false;
    bool ok = vm_plot_write(o->out, &image, title, err);
    crt_image_free(&image);
    return ok;
}

static bool write_all(const struct along *a, struct crt_error *err)
{
    const struct vm_probe_options *o = &a->job->o;
    if (!(a->figures.crest_cd_m2 > 0) && !o->allow_dark)
        return crt_fail(
            err,
            "there is no light of %s along that line at that time: choose other places, "
            "another time, or --allow-dark",
            a->job->input.name);
    if ((o->csv && !write_csv(a, err)) || (o->out && !write_plot(a, err)))
        return false;
    if (!vm_probe_to_stdout(o))
        print_json(a);
    return true;
}

bool vm_probe_measure_along(struct vm_probe_job *job, struct vm_rig *rig, struct crt_error *err)
{
    struct along a = {.job = job, .monitor = &job->settings.monitor[job->place.head]};
    const double from[2] = {job->place.x_mm, job->place.y_mm};
    if (!vm_profile_open(&a.profile, rig->tube[job->place.head], from, job->along_mm, err))
        return false;
    lead_in(&a, rig->machine);
    vm_progress_run(&job->progress, rig->machine, job->to);
    vm_progress_end(&job->progress);
    bool ok =
        vm_profile_measure(&a.profile, job->from, job->to, &a.figures, err) && write_all(&a, err);
    vm_profile_close(&a.profile);
    return ok;
}
