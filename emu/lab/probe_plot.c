/* probe_plot.c — the curve as a plot: cd/m² against ms, with mean, refreshes and figures. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "emu/lab/probe.h"

#define REFRESHES 8 /* marks of them, at most */

/* Three or four digits, never an exponent where people look: 27750, 2352, 0.0123. */
static const char *figure(double v, char text[24])
{
    double a = fabs(v);
    int decimals = a >= 1000 || a == 0 ? 0 : a >= 100 ? 1 : a >= 1 ? 2 : a >= 0.01 ? 4 : -1;
    if (decimals < 0)
        snprintf(text, 24, "%.2g", v);
    else
        snprintf(text, 24, "%.*f", decimals, v);
    return text;
}

static void put_figures(const struct vm_probe *p, const struct vm_probe_report *r, char *text,
                        size_t size)
{
    const struct crt_waveform_figures *f = &r->figures;
    char mean[24], peak[24], least[24], eye[24];
    int n;
    if (r->dark) {
        snprintf(text, size, "dark");
        return;
    }
    n = snprintf(text, size, "mean %s cd/m², peak %s, least %s", figure(f->mean_cd_m2, mean),
                 figure(f->peak_cd_m2, peak), figure(f->least_cd_m2, least));
    if (r->known)
        n += snprintf(text + n, size - (size_t)n,
                      "; at %.4g Hz C1 %.3f, %.3g %% flicker, flicker index %.3f; ", f->hz, f->c[0],
                      f->percent_flicker, f->flicker_index);
    if (r->known && r->cff_harmonic > 1)
        n += snprintf(text + n, size - (size_t)n, "its harmonic at %.4g Hz is ", r->cff_of_hz);
    if (r->known)
        n += snprintf(text + n, size - (size_t)n,
                      "steady for 95 %% of viewers above %.1f Hz (%.0f° field, %s cd/m², %.2g mm "
                      "pupil): %s",
                      r->cff_hz, crt_fields_deg[p->viewer.field], figure(r->eye_cd_m2, eye),
                      p->viewer.pupil_mm, r->flickers ? "flickers" : "does not flicker");
    else if (r->periods > 0)
        n += snprintf(text + n, size - (size_t)n,
                      "; the light %s by %.2g %% in this time: flicker cannot be told from that",
                      r->drift < 0 ? "falls" : "rises", 100 * fabs(r->drift));
    else
        n += snprintf(text + n, size - (size_t)n,
                      "; not a whole period: whether it flickers is not known");
    if (!r->settled)
        snprintf(text + n, size - (size_t)n, "; not settled");
}

static double ms_after(uint64_t t, uint64_t t0)
{
    return ((double)t - (double)t0) * 1e-9;
}

/* The ends of refreshes within the time; of many every so manieth. */
static void mark_refreshes(const struct vm_probe *p, uint64_t t0, uint64_t t1,
                           struct vm_plot_panel *panel)
{
    int first = 0, last = p->beats - 1;
    while (first <= last && p->beat[first].end < t0)
        first++;
    while (last >= first && p->beat[last].end > t1)
        last--;
    int step = (last - first) / REFRESHES + 1;
    for (int i = first; i <= last; i += step)
        panel->mark[panel->mark_count++] = (struct vm_plot_mark){true, ms_after(p->beat[i].end, t0),
                                                                 i == first ? "refresh" : NULL};
}

/* The least of the curve once it has been brightest: what was before the first light is no part of a decay. */
static double least_after_peak(const struct vm_probe_wave *wave)
{
    double least = 0, peak = 0;
    for (size_t i = 0; i < wave->count; i++) {
        least = wave->cd_m2[i] >= peak ? wave->cd_m2[i] : fmin(least, wave->cd_m2[i]);
        peak = fmax(peak, wave->cd_m2[i]);
    }
    return least;
}

static bool draw(const struct vm_probe *p, uint64_t t0, uint64_t t1,
                 const struct vm_probe_report *r, const struct vm_probe_look *look,
                 const struct vm_probe_wave *wave, const double *x, struct crt_image *image,
                 struct crt_error *err)
{
    char note[400], label[64], from[40], mean[40], digits[24];
    struct vm_plot plot = {.title = look->title, .note = note, .panel_count = 1};
    struct vm_plot_panel *panel = &plot.panel[0];
    put_figures(p, r, note, sizeof note);
    vm_format_time(t0, from, sizeof from);
    snprintf(label, sizeof label, t0 ? "time after %s, ms" : "time%.0s, ms", from);
    plot.x = (struct vm_plot_axis){label, false, 0, ms_after(t1, t0)};
    panel->y = (struct vm_plot_axis){"luminance, cd/m²", look->log, 0, 0};
    if (look->log && r->figures.peak_cd_m2 > 0) { /* darkness has no logarithm: five decades at most */
        panel->y.high = r->figures.peak_cd_m2 * 1.5;
        panel->y.low = fmax(least_after_peak(wave) / 1.5, panel->y.high * 1e-5);
    } else {
        panel->y.high = r->figures.peak_cd_m2 > 0 ? r->figures.peak_cd_m2 * 1.05 : 1;
    }
    panel->series[panel->series_count++] =
        (struct vm_plot_series){NULL, VM_PLOT_LINE, x, wave->cd_m2, wave->count, 0, false};
    if (!r->dark) {
        snprintf(mean, sizeof mean, "mean %s", figure(r->figures.mean_cd_m2, digits));
        panel->mark[panel->mark_count++] =
            (struct vm_plot_mark){false, r->figures.mean_cd_m2, mean};
    }
    mark_refreshes(p, t0, t1, panel);
    return vm_plot_draw(&plot, look->size.width ? look->size : vm_plot_size, look->style, image,
                        err);
}

bool vm_probe_plot(struct vm_probe *probe, uint64_t t0, uint64_t t1,
                   const struct vm_probe_report *report, const struct vm_probe_look *look,
                   struct crt_image *image, struct crt_error *err)
{
    struct vm_probe_wave wave;
    if (!vm_probe_wave(probe, t0, t1, VM_PROBE_LOOK, &wave, err))
        return false;
    double *x = malloc(wave.count * sizeof *x);
    bool ok = x || crt_fail(err, "not enough memory for the plot; shorten the time");
    for (size_t i = 0; ok && i < wave.count; i++)
        x[i] = ms_after(wave.t[i], t0);
    ok = ok && draw(probe, t0, t1, report, look, &wave, x, image, err);
    free(x);
    vm_probe_wave_free(&wave);
    return ok;
}
