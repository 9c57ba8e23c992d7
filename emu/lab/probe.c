/* probe.c — the diode at its place, the beat of the machine, and what both make of a time. */
#include "emu/lab/probe.h"

#include <math.h>
#include <string.h>

#include "emu/view.h"

/* Of the field a person looks at and the pupil, by default. */
#define PI         3.14159265358979324
#define FIELD_30   1
#define PUPIL_MM   3.0
#define STEADY     0.005 /* halves of a steady curve differ by less, as a part of their mean */
#define SAME_RATE  0.001 /* rates that differ by less, as a part, are one */
#define DARK_CD_M2 1e-6  /* about where people see anything at all (estimate) */
#define EYE_LEAST  0.05  /* Hz by which another harmonic must be worse to be the one named */
#define ABOUT      0.1   /* what repeats at nearly the refresh rate has it: pictures that change */
#define SLOWER                                                                                     \
    1e-3 /* harmonics below the refresh rate's: with less, of the mean, nothing is slower, */
#define SLOWER_YES 0.01 /* with more it is, and in between what a viewer sees */
#define SLOWER_N   64   /* harmonics looked at, at most */
#define DRIFT      1e-4 /* of the mean: with less over all the time it stands still */
#define DRIFT_PART 0.1  /* of a figure that may be drift rather than flicker */

/* ---- where -------------------------------------------------------------------------------------- */

static bool on_the_glass(const struct vm_probe *p, struct crt_error *err)
{
    const struct crt_tube_row *row = p->row;
    double x = row->width.value / 2 + row->border.value,
           y = row->height.value / 2 + row->border.value;
    if (p->place.kind == CRT_DIODE_SCREEN || (fabs(p->place.x_mm) <= x && fabs(p->place.y_mm) <= y))
        return true;
    return crt_fail(
        err,
        "the place %g,%g is beside the screen: %.0f mm from its middle where the glass of "
        "%s ends at %.0f mm",
        p->place.x, p->place.y, fabs(p->place.x_mm) > x ? fabs(p->place.x_mm) : fabs(p->place.y_mm),
        row->name, fabs(p->place.x_mm) > x ? x : y);
}

bool vm_probe_open(struct vm_probe *probe, const struct vm_rig *rig,
                   const struct vm_probe_place *place, struct crt_error *err)
{
    const struct vm_machine *m = rig->machine;
    bool raster = place->head == VM_RASTER;
    *probe = (struct vm_probe){.place = *place,
                               .tube = rig->tube[place->head],
                               .row = raster ? m->desc.raster_row : m->desc.row,
                               .phosphor = raster ? m->desc.raster_phosphor : m->desc.phosphor,
                               .viewer = {FIELD_30, PUPIL_MM}};
    if (!probe->tube)
        return crt_fail(err, "nobody looks at the %s head: there is no tube to probe",
                        raster ? "raster" : "vector");
    if (place->kind != CRT_DIODE_SCREEN && !place->in_mm)
        vm_view_place(raster ? VM_VIEW_RASTER : VM_VIEW_VECTOR, m, place->x, place->y,
                      &probe->place.x_mm, &probe->place.y_mm);
    if (!on_the_glass(probe, err))
        return false;
    struct crt_photodiode_desc desc = {place->kind, probe->place.x_mm, probe->place.y_mm,
                                       place->area_mm};
    probe->diode = crt_photodiode_open(probe->tube, &desc, err);
    return probe->diode != NULL;
}

void vm_probe_close(struct vm_probe *probe)
{
    if (probe->diode)
        crt_photodiode_close(probe->diode);
    probe->diode = NULL;
}

void vm_probe_forget(struct vm_probe *probe, uint64_t t)
{
    if (t > crt_photodiode_from(probe->diode))
        crt_photodiode_forget(probe->diode, t);
}

/* ---- the beat of the machine -------------------------------------------------------------------- */

void vm_probe_watch(struct vm_probe *probe, const struct vm_machine *machine)
{
    const struct vm_refresh *last = &machine->refreshes.last;
    struct vm_probe_beat *beat = probe->beat;
    int n = probe->beats;
    if (last->number == 0 || (n > 0 && beat[n - 1].number == last->number))
        return;
    if (n > 0 && beat[n - 1].number > last->number) /* another program, or an earlier time */
        n = 0;
    if (n == VM_PROBE_BEATS) { /* each second of the older half, all of the newer */
        for (int i = 0; i < n / 4; i++)
            beat[i] = beat[2 * i];
        memmove(beat + n / 4, beat + n / 2, (size_t)(n - n / 2) * sizeof *beat);
        n -= n / 2 - n / 4;
    }
    beat[n] = (struct vm_probe_beat){last->number, last->end};
    probe->beats = n + 1;
}

void vm_probe_run(struct vm_probe *probe, struct vm_machine *machine, uint64_t until)
{
    while (machine->now < until && vm_machine_run_refresh(machine, until))
        vm_probe_watch(probe, machine);
    if (machine->now < until)
        vm_machine_run(machine, until);
    vm_probe_watch(probe, machine);
}

/* From the first to the last refresh that ends within the time, or of the last two before its end. */
static double refresh_hz(const struct vm_probe *p, uint64_t t0, uint64_t t1)
{
    int last = p->beats - 1, first = 0;
    if (p->beats < 2)
        return NAN;
    while (last > 0 && p->beat[last].end > t1)
        last--;
    while (first < last && p->beat[first].end < t0)
        first++;
    if (first == last)
        first = last - 1;
    if (first < 0 || p->beat[last].end > t1 || p->beat[last].end == p->beat[first].end)
        return NAN;
    return (double)(p->beat[last].number - p->beat[first].number) * 1e12 /
           (double)(p->beat[last].end - p->beat[first].end);
}

static double mean_of(const struct vm_probe *p, uint64_t t0, uint64_t t1,
                      double colour[CRT_MAX_COLOURS])
{
    double sum = 0, seconds = (double)(t1 - t0) * 1e-12;
    crt_photodiode_gather(p->diode, t0, t1, colour);
    for (int c = 0; c < p->phosphor->colours; c++) {
        colour[c] /= seconds;
        sum += colour[c];
    }
    return sum;
}

/* Whether what comes again only after n refreshes differs from refresh to refresh by anything that matters. */
static bool is_slower(const struct vm_probe *p, uint64_t t0, uint64_t t1, double refresh, int n)
{
    double colour[CRT_MAX_COLOURS], c[SLOWER_N], hz = refresh / n;
    double whole = floor(((double)(t1 - t0) + 1) * 1e-12 * hz);
    if (!(whole > 0)) /* not a period: there is nothing to tell it by */
        return true;
    uint64_t end = t0 + (uint64_t)floor(whole / hz * 1e12 + 0.5);
    end = end < t1 ? end : t1;
    double mean = mean_of(p, t0, end, colour);
    if (!(mean > DARK_CD_M2))
        return true;
    int count = n * CRT_HARMONICS < SLOWER_N ? n * CRT_HARMONICS : SLOWER_N;
    crt_waveform_harmonics(p->diode, t0, end, hz, mean, c, count);
    for (int k = 1; k <= count; k++)
        if (k % n &&
            (c[k - 1] > SLOWER_YES ||
             (c[k - 1] > SLOWER &&
              crt_flickers(&p->viewer, p->eye_cd_m2 > 0 ? p->eye_cd_m2 : mean, k * hz, c[k - 1]))))
            return true;
    return false;
}

/* What the place repeats by: see Models. */
static double fundamental(const struct vm_probe *p, uint64_t t0, uint64_t t1, double refresh,
                          double repeats)
{
    if (!(refresh > 0))
        return repeats > 0 ? repeats : 0;
    if (!(repeats > 0) || repeats > refresh * (1 - ABOUT))
        return refresh;
    double n = floor(refresh / repeats + 0.5);
    if (fabs(refresh / n - repeats) >= SAME_RATE * repeats)
        return repeats;
    return n > SLOWER_N || is_slower(p, t0, t1, refresh, (int)n) ? refresh / n : refresh;
}

double vm_probe_hz(const struct vm_probe *probe, uint64_t t0, uint64_t t1)
{
    double refresh = refresh_hz(probe, t0, t1);
    return fundamental(probe, t0, t1, refresh,
                       crt_waveform_repeats_hz(probe->diode, t0, t1, refresh));
}

/* ---- the report --------------------------------------------------------------------------------- */

static uint64_t periods_ps(double periods, double hz)
{
    return (uint64_t)floor(periods / hz * 1e12 + 0.5);
}

/* As many whole periods as there are; with 1 ps to spare for what rounding takes. */
static void cut_to_periods(struct vm_probe_report *r, double hz)
{
    double n = hz > 0 ? floor(((double)(r->t1 - r->t0) + 1) * 1e-12 * hz) : 0;
    r->periods = (uint64_t)n;
    if (n > 0 && r->t0 + periods_ps(n, hz) < r->t1)
        r->t1 = r->t0 + periods_ps(n, hz);
}

/* Whether it goes on as it began: halves of whole periods, or of what there is. Light that only rises or falls has
 * harmonics, too, of a saw-tooth: of the change over the time / (pi · periods) of the mean, for the first. */
static void see_drift(struct vm_probe *p, struct vm_probe_report *r)
{
    const struct crt_waveform_figures *f = &r->figures;
    double colour[CRT_MAX_COLOURS];
    uint64_t half =
        r->periods >= 2 ? periods_ps((double)(r->periods / 2), f->hz) : (r->t1 - r->t0) / 2;
    double early = mean_of(p, r->t0, r->t0 + half, colour),
           late = mean_of(p, r->t1 - half, r->t1, colour);
    r->settled = fabs(late - early) <= STEADY * (late > early ? late : early);
    r->known = r->periods > 0;
    if (r->periods < 2)
        return;
    /* From the middle of one half to that of the other, and so over all. */
    double all = (double)(r->t1 - r->t0), drift = (late - early) / f->mean_cd_m2;
    r->drift = drift * all / (all - (double)half);
    double change = fabs(r->drift);
    if (change > DRIFT && (change / (PI * (double)r->periods) > DRIFT_PART * f->c[0] ||
                           50 * change > DRIFT_PART * f->percent_flicker))
        r->known = false;
}

/* The phosphor's terms by their share of the mean: a colour's light is shared by its terms as their
 * energies are. */
static struct crt_glow glow_of(const struct crt_phosphor *phosphor, const double *colour,
                               double mean)
{
    struct crt_glow glow = {.terms = phosphor->terms, .pulse = 1};
    double whole[CRT_MAX_COLOURS] = {0};
    for (int k = 0; k < phosphor->terms; k++)
        whole[phosphor->term[k].colour] += phosphor->term[k].w;
    for (int k = 0; k < phosphor->terms; k++) {
        const struct crt_phosphor_term *term = &phosphor->term[k];
        double w = whole[term->colour];
        glow.tau_s[k] = term->tau_s;
        glow.share[k] = w > 0 ? term->w / w * colour[term->colour] / mean : 0;
    }
    return glow;
}

/* Of all harmonics that it counts, which may be more than are shown. */
static double svm(struct vm_probe *p, const struct vm_probe_report *r)
{
    const struct crt_waveform_figures *f = &r->figures;
    double c[CRT_SVM_HARMONICS] = {0};
    if (isnan(crt_svm(f->hz, c, CRT_SVM_HARMONICS)))
        return NAN;
    crt_waveform_harmonics(p->diode, r->t0, r->t1, f->hz, f->mean_cd_m2, c, CRT_SVM_HARMONICS);
    return crt_svm(f->hz, c, CRT_SVM_HARMONICS);
}

static void predict(struct vm_probe *p, const double *colour, struct vm_probe_report *r)
{
    const struct crt_waveform_figures *f = &r->figures;
    double eye = r->eye_cd_m2 = p->eye_cd_m2 > 0 ? p->eye_cd_m2 : f->mean_cd_m2;
    struct crt_glow glow = glow_of(p->phosphor, colour, f->mean_cd_m2);
    double worst = 0; /* as a rate of the fundamental, so that harmonics compare */
    r->cff_harmonic = 1;
    for (int n = 1; n <= CRT_HARMONICS; n++) {
        struct crt_glow part = glow;
        double c = f->c[n - 1];
        part.pulse = c / crt_glow_harmonic(&glow, n * f->hz, 1);
        double cff = crt_cff(&p->viewer, eye, &part);
        if (cff / n > worst + (n > 1 ? EYE_LEAST : 0)) {
            worst = cff / n;
            r->cff_hz = cff;
            r->cff_harmonic = n;
        }
        r->flickers = r->flickers || crt_flickers(&p->viewer, eye, n * f->hz, c);
    }
    r->cff_of_hz = r->cff_harmonic * f->hz;
    r->cff_ferry_porter_hz = crt_cff_ferry_porter(eye, p->viewer.pupil_mm);
    r->ieee = crt_ieee1789(f->hz, f->percent_flicker);
    r->svm = svm(p, r);
}

/* Nothing repeats, not a whole period was asked for, or it drifts: what is left is how much light there is. */
static void leave_out_harmonics(const struct vm_probe *p, struct vm_probe_report *r)
{
    for (int n = 0; n < CRT_HARMONICS; n++)
        r->figures.c[n] = NAN;
    r->figures.percent_flicker = r->figures.flicker_index = NAN;
    r->eye_cd_m2 = p->eye_cd_m2 > 0 ? p->eye_cd_m2 : r->figures.mean_cd_m2;
    r->cff_hz = r->cff_of_hz = r->svm = NAN;
    r->cff_ferry_porter_hz = crt_cff_ferry_porter(r->eye_cd_m2, p->viewer.pupil_mm);
}

bool vm_probe_report(struct vm_probe *probe, uint64_t t0, uint64_t t1,
                     struct vm_probe_report *report, struct crt_error *err)
{
    double colour[CRT_MAX_COLOURS];
    struct vm_probe_report *r = report;
    if (!crt_photodiode_intact(probe->diode, err) || !crt_tube_intact(probe->tube, err))
        return false;
    *r = (struct vm_probe_report){.t0 = t0, .t1 = t1, .svm = NAN};
    r->refresh_hz = refresh_hz(probe, t0, t1);
    double repeats = crt_waveform_repeats_hz(probe->diode, t0, t1, r->refresh_hz);
    double hz = fundamental(probe, t0, t1, r->refresh_hz, repeats);
    r->repeats_hz = repeats > 0 ? repeats : NAN;
    cut_to_periods(r, hz);
    crt_waveform_measure(probe->diode, r->t0, r->t1, hz > 0 ? hz : 1, &r->figures);
    r->dark = !(r->figures.mean_cd_m2 > DARK_CD_M2);
    if (!r->dark)
        see_drift(probe, r);
    if (r->dark)
        r->cff_hz = r->cff_of_hz = r->cff_ferry_porter_hz = NAN;
    else if (!r->known)
        leave_out_harmonics(probe, r);
    else {
        mean_of(probe, r->t0, r->t1, colour);
        predict(probe, colour, r);
    }
    return true;
}
