#include "crt/waveform.h"

#include <math.h>
#include <stdlib.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

/* ---- within a stretch ------------------------------------------------------------------------------ */

/* Stretches next to the highest ends seen: the peak is within one of them. */
#define SUMMITS 16
struct summit {
    double height, from_s, to_s;
};

struct measuring {
    struct crt_photodiode *diode;
    const struct crt_phosphor *phosphor;
    uint64_t t0, t1;
    double mean, above; /* cd/m²; cd·s/m² of what is above the mean */
    double peak, peak_s, least;
    struct summit summit[SUMMITS];
};

/* ∫ from a to b, seconds of the stretch. */
static double area_in(const struct measuring *m, const struct crt_diode_stretch *s, double a,
                      double b)
{
    double sum = 0;
    for (int k = 0; k < m->phosphor->terms; k++) {
        double tau = m->phosphor->term[k].tau_s;
        double left = (s->start[k] - s->toward[k]) * crt_exp(-a / tau);
        sum += s->toward[k] * (b - a) + left * tau * -crt_expm1(-(b - a) / tau);
    }
    return sum;
}

/* ∫ of all of it: stored light S changes by what falls less what is emitted. */
static double area_of(const struct measuring *m, const struct crt_diode_stretch *s)
{
    double sum = 0;
    for (int k = 0; k < m->phosphor->terms; k++)
        sum += m->phosphor->term[k].tau_s * (s->start[k] - s->end[k]) + s->toward[k] * s->seconds;
    return sum;
}

/* When the luminance crosses the level, once: regula falsi, halving what stays put (Illinois). */
static double crossing_in(const struct measuring *m, const struct crt_diode_stretch *s,
                          double level)
{
    double a = 0, b = s->seconds, fa = s->first - level, fb = s->last - level;
    for (int i = 0; i < 60 && b - a > 1e-13 * s->seconds; i++) {
        double middle = i % 8 == 7 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
        double f = crt_stretch_at(m->phosphor, s, middle) - level;
        if (fabs(f) < 1e-8 * level) /* the area above is flat there: good to 1e-16 */
            return middle;
        if ((f > 0) == (fb > 0)) {
            b = middle;
            fb = f;
            fa /= 2;
        } else {
            a = middle;
            fa = f;
            fb /= 2;
        }
    }
    return (a + b) / 2;
}

/* ---- peak and least ---------------------------------------------------------------------------------- */

static double luminance_at(const struct measuring *m, double seconds)
{
    double t = floor(seconds * 1e12 + 0.5), most = (double)(m->t1 - m->t0);
    return crt_photodiode_luminance(m->diode, m->t0 + (uint64_t)fmin(fmax(t, 0), most));
}

static void note_peak(struct measuring *m, double height, double at_s)
{
    if (height > m->peak) {
        m->peak = height;
        m->peak_s = at_s;
    }
}

static void note_summit(struct measuring *m, struct summit summit)
{
    int lowest = 0;
    for (int i = 0; i < SUMMITS; i++) {
        struct summit *known = &m->summit[i];
        if (fabs(known->height - summit.height) < 1e-9 * summit.height) {
            /* The other side of that end; or the same again, a refresh later. */
            if (fabs(known->to_s - summit.from_s) < 1e-12)
                known->to_s = summit.to_s;
            return;
        }
        if (known->height < m->summit[lowest].height)
            lowest = i;
    }
    if (summit.height > m->summit[lowest].height)
        m->summit[lowest] = summit;
}

static void note_ends(void *context, const struct crt_diode_stretch *s)
{
    struct measuring *m = context;
    m->least = fmin(m->least, fmin(s->first, s->last));
    note_peak(m, s->first, s->at_s);
    if (s->lit)
        note_summit(m, (struct summit){fmax(s->first, s->last), s->at_s, s->at_s + s->seconds});
}

/* The highest luminance in a stretch with one summit, by golden section. */
static void climb(struct measuring *m, double a, double b)
{
    const double golden = 0.61803398874989485;
    double x = b - golden * (b - a), y = a + golden * (b - a);
    double fx = luminance_at(m, x), fy = luminance_at(m, y);
    note_peak(m, luminance_at(m, a), a);
    note_peak(m, luminance_at(m, b), b);
    while (b - a > 2e-12) {
        if (fx > fy) {
            b = y;
            y = x;
            fy = fx;
            x = b - golden * (b - a);
            fx = luminance_at(m, x);
        } else {
            a = x;
            x = y;
            fx = fy;
            y = a + golden * (b - a);
            fy = luminance_at(m, y);
        }
    }
    note_peak(m, fx, x);
}

static void find_peak(struct measuring *m)
{
    double highest = 0;
    for (int i = 0; i < SUMMITS; i++)
        highest = fmax(highest, m->summit[i].height);
    for (int i = 0; i < SUMMITS; i++)
        if (m->summit[i].height > 0.5 * highest)
            climb(m, m->summit[i].from_s, m->summit[i].to_s);
    note_peak(m, luminance_at(m, 0), 0);
}

/* ---- figures ------------------------------------------------------------------------------------------- */

static void add_above(void *context, const struct crt_diode_stretch *s)
{
    struct measuring *m = context;
    bool first = s->first > m->mean, last = s->last > m->mean;
    if (!first && !last)
        return;
    double at = first == last ? 0 : crossing_in(m, s, m->mean);
    double a = first ? 0 : at, b = last ? s->seconds : at;
    double area = first == last ? area_of(m, s) : area_in(m, s, a, b);
    m->above += area - m->mean * (b - a);
}

/* From the peak until a tenth is left of what is stored then. */
static double persistence_10(const struct measuring *m)
{
    double term[CRT_MAX_TERMS], longest = 0, a = 0;
    crt_photodiode_terms(m->diode, m->t0 + (uint64_t)(m->peak_s * 1e12 + 0.5), term);
    struct crt_diode_stretch s = {0};
    for (int k = 0; k < m->phosphor->terms; k++) {
        s.start[k] = term[k];
        longest = fmax(longest, m->phosphor->term[k].tau_s);
    }
    double b = 2.4 * longest,
           level = 0.1 * crt_stretch_at(m->phosphor, &s, 0); /* e^-2.4 is less than a tenth */
    for (int i = 0; i < 80; i++) {
        double middle = (a + b) / 2;
        if (crt_stretch_at(m->phosphor, &s, middle) > level)
            a = middle;
        else
            b = middle;
    }
    return (a + b) / 2;
}

void crt_waveform_harmonics(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, double hz,
                            double mean_cd_m2, double *c, int count)
{
    double total = mean_cd_m2 * crt_seconds(t0, t1);
    for (int n = 0; n < count; n++) {
        struct crt_phasor p = crt_photodiode_harmonic(diode, t0, t1, hz * (n + 1));
        c[n] = 2 * sqrt(p.re * p.re + p.im * p.im) / total;
    }
}

static struct crt_waveform_figures darkness(double hz)
{
    struct crt_waveform_figures f = {.hz = hz};
    for (int n = 0; n < CRT_HARMONICS; n++)
        f.c[n] = NAN;
    f.percent_flicker = f.flicker_index = f.persistence_10_s = f.peak_t_s = NAN;
    return f;
}

void crt_waveform_measure(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, double hz,
                          struct crt_waveform_figures *figures)
{
    struct measuring m = {.diode = diode, .t0 = t0, .t1 = t1, .least = INFINITY};
    double light[CRT_MAX_COLOURS];
    m.phosphor = diode->tube->desc.phosphor;
    *figures = darkness(hz);
    if (t0 >= t1)
        return;
    crt_photodiode_gather(diode, t0, t1, light);
    m.mean = (light[0] + light[1] + light[2]) / crt_seconds(t0, t1);
    if (!(m.mean > 0))
        return;
    crt_diode_walk(diode, t0, t1, INFINITY, note_ends, &m);
    find_peak(&m);
    crt_diode_walk(diode, t0, t1, m.mean, add_above, &m);
    figures->mean_cd_m2 = m.mean;
    figures->peak_cd_m2 = m.peak;
    figures->least_cd_m2 = m.least;
    figures->peak_t_s = m.peak_s;
    figures->percent_flicker = 100 * (m.peak - m.least) / (m.peak + m.least);
    figures->flicker_index = m.above / (m.mean * crt_seconds(t0, t1));
    figures->persistence_10_s = persistence_10(&m);
    crt_waveform_harmonics(diode, t0, t1, hz, m.mean, figures->c, CRT_HARMONICS);
}
