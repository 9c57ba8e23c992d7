/* probe_wave.c — the curve as samples: evenly spaced, or where it wants them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lab/probe.h"

/* A straight line between samples is off by at most about this part of the curve, or of the floor. */
#define OFF       1e-3
#define FLOOR     1e-4 /* of the peak: below, nobody looks */
#define WEAK      1e-5 /* deposits with less, as a part of the strongest, get no samples of their own */
#define HALVINGS  12   /* of the way, within a deposit */
#define A_LOOK    2000 /* deposits; with more there are only their ends when it is to be looked at */
#define COLUMNS   20000 /* no plot has more */
#define MANY      20000
#define MOST      20000000 /* samples: 1 GB */
#define PER_WHOLE 200      /* at least, so that a curve that hardly bends is drawn smoothly */

/* ---- room --------------------------------------------------------------------------------------- */

static bool no_memory(struct crt_error *err)
{
    return crt_fail(err, "not enough memory for the samples; shorten the time or lower the rate");
}

static bool take_room(struct vm_probe_wave *w, size_t count, struct crt_error *err)
{
    bool ok = (w->t = malloc(count * sizeof *w->t)) != NULL &&
              (w->cd_m2 = malloc(count * sizeof *w->cd_m2)) != NULL;
    for (int c = 0; ok && c < w->colours; c++)
        ok = (w->colour[c] = malloc(count * sizeof **w->colour)) != NULL;
    if (ok)
        return true;
    vm_probe_wave_free(w);
    return no_memory(err);
}

void vm_probe_wave_free(struct vm_probe_wave *w)
{
    free(w->t);
    free(w->cd_m2);
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        free(w->colour[c]);
    *w = (struct vm_probe_wave){0};
}

/* ---- instants ----------------------------------------------------------------------------------- */

struct instants {
    uint64_t *t;
    size_t count, room;
    bool failed;
};

static void add(struct instants *s, uint64_t t)
{
    if (s->count == s->room) {
        size_t room = s->room ? 2 * s->room : 1024;
        uint64_t *more = room > MOST ? NULL : realloc(s->t, room * sizeof *more);
        s->failed = s->failed || !more;
        if (!more)
            return;
        s->t = more;
        s->room = room;
    }
    s->t[s->count++] = t;
}

static void add_within(struct instants *s, double t, uint64_t t0, uint64_t t1)
{
    if (t > (double)t0 && t < (double)t1)
        add(s, (uint64_t)t);
}

static int by_time(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return x < y ? -1 : x > y;
}

static void sort(struct instants *s)
{
    size_t n = 0;
    qsort(s->t, s->count, sizeof *s->t, by_time);
    for (size_t i = 0; i < s->count; i++)
        if (n == 0 || s->t[n - 1] != s->t[i])
            s->t[n++] = s->t[i];
    s->count = n;
}

static double fluence(const struct crt_deposit *d, int colours)
{
    double sum = 0;
    for (int c = 0; c < colours; c++)
        sum += d->fluence[c];
    return sum;
}

/* Ends of a deposit; towards its beginning, where a fast phosphor rises; and, but for a whole screen, whose
 * deposits are even, around the moment at which the beam passes. */
static void add_deposit(struct instants *s, const struct crt_deposit *d, int halvings, bool passes,
                        uint64_t t0, uint64_t t1)
{
    double begin = (double)d->t0, end = (double)d->t1, middle = begin + d->mean_t_s * 1e12,
           step = end - begin;
    add_within(s, begin, t0, t1);
    add_within(s, end, t0, t1);
    if (passes)
        add_within(s, middle, t0, t1);
    for (int k = 0; k < halvings; k++) {
        step /= 2;
        add_within(s, begin + step, t0, t1);
        if (passes && middle - step > begin)
            add_within(s, middle - step, t0, t1);
        if (passes && middle + step < end)
            add_within(s, middle + step, t0, t1);
    }
}

static void add_deposits(struct instants *s, const struct vm_probe *p, uint64_t t0, uint64_t t1,
                         size_t many)
{
    size_t count, first = 0;
    const struct crt_deposit *d = crt_photodiode_deposits(p->diode, &count);
    bool whole = p->place.kind == CRT_DIODE_SCREEN;
    double most = 0;
    while (first < count && d[first].t1 <= t0)
        first++;
    while (count > first && d[count - 1].t0 >= t1)
        count--;
    int halvings = count - first > many ? 0 : whole ? HALVINGS / 2 : HALVINGS;
    for (size_t i = first; i < count; i++)
        most = fmax(most, fluence(&d[i], p->phosphor->colours));
    for (size_t i = first; i < count; i++)
        if (fluence(&d[i], p->phosphor->colours) >= WEAK * most)
            add_deposit(s, &d[i], halvings, !whole, t0, t1);
}

/* From t, how far a straight line follows the decay: its error is dt²/8 times the second derivative. */
static double stride(const struct vm_probe *p, uint64_t t, double peak)
{
    double terms[CRT_MAX_TERMS], light = 0, bend = 0;
    crt_photodiode_terms(p->diode, t, terms);
    for (int k = 0; k < p->phosphor->terms; k++) {
        double tau = p->phosphor->term[k].tau_s;
        light += terms[k];
        bend += terms[k] / (tau * tau);
    }
    return bend > 0 ? sqrt(8 * OFF * fmax(light, FLOOR * peak) / bend) * 1e12 : INFINITY;
}

static void add_decays(struct instants *all, const struct instants *ends, const struct vm_probe *p,
                       double peak, double least)
{
    double most = (double)(ends->t[ends->count - 1] - ends->t[0]) / PER_WHOLE;
    for (size_t i = 0; i + 1 < ends->count && !all->failed; i++) {
        uint64_t t = ends->t[i], end = ends->t[i + 1];
        while (t < end && !all->failed) {
            add(all, t);
            double far = fmax(fmin(stride(p, t, peak), most), least);
            uint64_t left = end - t;
            t = far < (double)left ? t + (uint64_t)far : end;
        }
    }
    add(all, ends->t[ends->count - 1]);
}

/* `least`: no step is shorter, ps, but for ends of deposits. */
static void adapt(struct instants *s, const struct vm_probe *p, uint64_t t0, uint64_t t1,
                  double least)
{
    struct instants ends = {0};
    struct crt_waveform_figures figures;
    crt_waveform_measure(p->diode, t0, t1, 1e12 / (double)(t1 - t0), &figures);
    add(&ends, t0);
    add(&ends, t1);
    add_deposits(&ends, p, t0, t1, least > 1 ? A_LOOK : MANY);
    if (!ends.failed) {
        sort(&ends);
        add_decays(s, &ends, p, figures.peak_cd_m2, least);
    }
    s->failed = s->failed || ends.failed;
    free(ends.t);
}

static void space_evenly(struct instants *s, uint64_t t0, uint64_t t1, double hz)
{
    for (uint64_t n = 0;; n++) {
        double dt = (double)n / hz * 1e12;
        if (!(dt < (double)(t1 - t0)) || s->failed)
            return;
        add(s, t0 + (uint64_t)(dt + 0.5));
    }
}

/* ---- samples ------------------------------------------------------------------------------------ */

static void sample(struct vm_probe *p, struct vm_probe_wave *w)
{
    double colour[CRT_MAX_COLOURS];
    for (size_t i = 0; i < w->count; i++) {
        crt_photodiode_read(p->diode, w->t[i], colour);
        w->cd_m2[i] = 0;
        for (int c = 0; c < w->colours; c++) {
            w->colour[c][i] = colour[c];
            w->cd_m2[i] += colour[c];
        }
    }
}

bool vm_probe_wave(struct vm_probe *probe, uint64_t t0, uint64_t t1, double hz,
                   struct vm_probe_wave *wave, struct crt_error *err)
{
    struct instants s = {0};
    *wave = (struct vm_probe_wave){.colours = probe->phosphor->colours};
    if (hz > 0)
        space_evenly(&s, t0, t1, hz);
    else
        adapt(&s, probe, t0, t1, hz < 0 ? fmax((double)(t1 - t0) / COLUMNS, 1) : 1);
    bool ok = s.failed ? no_memory(err) : take_room(wave, s.count, err);
    if (ok) {
        wave->count = s.count;
        memcpy(wave->t, s.t, s.count * sizeof *s.t);
        sample(probe, wave);
    }
    free(s.t);
    return ok && crt_photodiode_intact(probe->diode, err);
}
