/* Of light made anew again and again.
 *
 * A steady glow has just been struck at t = 0 and is struck again at T = 1/hz. Term k then is
 * share·x/(1 − e^(−x))·e^(−t/tau) of the mean, x = T/tau: brightest at 0, dimmest just before T.
 */
#include "crt/flicker.h"

#include <math.h>

#include "crt/maths.h"

#define PI 3.141592653589793

struct crt_glow crt_glow_of(const struct crt_phosphor *p)
{
    struct crt_glow g = {.terms = p->terms, .pulse = 1};
    for (int k = 0; k < p->terms; k++) {
        g.share[k] = p->term[k].w;
        g.tau_s[k] = p->term[k].tau_s;
    }
    return g;
}

double crt_glow_harmonic(const struct crt_glow *g, double hz, int n)
{
    struct crt_phosphor p = {.terms = g->terms};
    for (int k = 0; k < g->terms; k++)
        p.term[k] = (struct crt_phosphor_term){g->share[k], g->tau_s[k], 0};
    double c = crt_phosphor_c1(&p, n * hz); /* the n-th of hz is the first of n·hz */
    return n == 1 ? c * g->pulse : c;
}

/* ---- the waveform's figures ------------------------------------------------------------------- */

/* x/(1 − e^(−x)): a term over its mean just after it was struck; 1 for x -> 0. */
static double just_after(double x)
{
    return x > 0 ? -x / crt_expm1(-x) : 1;
}

/* x/(e^x − 1): the same just before. */
static double just_before(double x)
{
    return just_after(x) * crt_exp(-x);
}

/* The light over its mean, t after it was struck. */
static double light(const struct crt_glow *g, double period, double t)
{
    double sum = 0;
    for (int k = 0; k < g->terms; k++)
        sum += g->share[k] * just_after(period / g->tau_s[k]) * crt_exp(-t / g->tau_s[k]);
    return sum;
}

/* That, summed from 0 to t, over all that the period has. */
static double light_until(const struct crt_glow *g, double period, double t)
{
    double sum = 0;
    for (int k = 0; k < g->terms; k++)
        sum += g->share[k] * crt_expm1(-t / g->tau_s[k]) / crt_expm1(-period / g->tau_s[k]);
    return sum;
}

/* When the falling light passes its mean. */
static double mean_passed(const struct crt_glow *g, double period)
{
    double low = 0, high = period;
    for (;;) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            return high;
        if (light(g, period, middle) > 1)
            low = middle;
        else
            high = middle;
    }
}

/* Rates at which no figure overflows. */
static bool is_rate(double hz)
{
    return hz >= 1e-6 && hz <= 1e12;
}

double crt_glow_percent_flicker(const struct crt_glow *g, double hz)
{
    if (!is_rate(hz))
        return NAN;
    double most = 0, least = 0, swing = 0;
    for (int k = 0; k < g->terms; k++) {
        double x = 1 / (hz * g->tau_s[k]);
        most += g->share[k] * just_after(x);
        least += g->share[k] * just_before(x);
        swing += g->share[k] * x; /* most − least, which loses no digits of a glow nearly steady */
    }
    return 100 * swing / (most + least);
}

double crt_glow_flicker_index(const struct crt_glow *g, double hz)
{
    if (!is_rate(hz))
        return NAN;
    double period = 1 / hz, t = mean_passed(g, period);
    return light_until(g, period, t) - t / period;
}

/* ---- what is seen ----------------------------------------------------------------------------- */

const double crt_fields_deg[CRT_FIELDS] = {10, 30, 50, 70};

/* CFF = m + n·ln(E) Hz, E = trolands of the mean times the fundamental's amplitude over the mean, of 95 %
 * of viewers. J. E. Farrell, B. L. Benson, C. R. Haynie: Predicting flicker thresholds for video display
 * terminals, Proceedings of the SID 28/4, 1987; the figures as ISO 9241-3:1992, annex B, and others quote
 * them. */
static const struct {
    double m, n;
} farrell[CRT_FIELDS] = {{14.6, 7.00}, {13.83, 8.31}, {8.32, 9.73}, {6.79, 10.03}};

static bool is_viewer(const struct crt_viewer *v)
{
    return v->field >= 0 && v->field < CRT_FIELDS && v->pupil_mm > 0;
}

double crt_trolands(double cd_m2, double pupil_mm)
{
    return cd_m2 * PI * pupil_mm * pupil_mm / 4;
}

/* The CFF of `trolands` of the fundamental; below 0 when too little to be seen at all. */
static double cff_of(const struct crt_viewer *v, double trolands)
{
    return farrell[v->field].m + farrell[v->field].n * crt_log(trolands);
}

double crt_cff(const struct crt_viewer *v, double cd_m2, const struct crt_glow *g)
{
    if (!is_viewer(v) || isnan(cd_m2))
        return NAN;
    double all = crt_trolands(fmax(cd_m2, 0), v->pupil_mm);
    /* The modulation falls as the frequency rises: one crossing, below the CFF of light unsmoothed. */
    double low = 0, high = cff_of(v, all * 2 * g->pulse);
    if (!(high > 0))
        return 0;
    if (isinf(high))
        return INFINITY;
    for (;;) {
        double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high)
            return middle;
        if (cff_of(v, all * crt_glow_harmonic(g, middle, 1)) > middle)
            low = middle;
        else
            high = middle;
    }
}

bool crt_flickers(const struct crt_viewer *v, double cd_m2, double hz, double c)
{
    if (!is_viewer(v) || !(cd_m2 > 0) || !(hz > 0) || !(c > 0))
        return false;
    return cff_of(v, crt_trolands(cd_m2, v->pupil_mm) * c) > hz;
}

double crt_flicker_luminance(const struct crt_viewer *v, double hz, const struct crt_glow *g)
{
    if (!is_viewer(v) || !(hz > 0))
        return NAN;
    double trolands = crt_exp((hz - farrell[v->field].m) / farrell[v->field].n);
    double c = crt_glow_harmonic(g, hz, 1);
    return c > 0 ? trolands / (crt_trolands(1, v->pupil_mm) * c) : INFINITY;
}

/* Of a small field looked at straight, fully modulated. That the law holds up to 10⁴ trolands and that
 * the eye's centre ends at 50 … 55 Hz there: C. W. Tyler and R. D. Hamer, Analysis of visual modulation
 * sensitivity IV, J. Opt. Soc. Am. A 7, 1990. 10 Hz a decade and 12 Hz at 1 troland lie in that range
 * (estimate). */
#define PORTER_A 10.0
#define PORTER_B 12.0

double crt_cff_ferry_porter(double cd_m2, double pupil_mm)
{
    if (isnan(cd_m2) || !(pupil_mm > 0))
        return NAN;
    double hz = PORTER_A * crt_log(crt_trolands(fmax(cd_m2, 0), pupil_mm)) / 2.302585092994046;
    return fmax(hz + PORTER_B, 0);
}

/* ---- standards of lighting --------------------------------------------------------------------- */

/* IEEE Std 1789-2015, clause 8, recommended practices 1 (low risk) and 2 (no observable effect), as commonly
 * quoted: modulation in % up to a factor times the frequency. */
static const struct {
    double below_90, from_90, end; /* % per Hz; Hz, above which any modulation is allowed */
} low_risk = {.025, .08, 1250}, no_effect = {.01, .0333, 3000};

static double allowed(double hz, double below_90, double from_90, double end)
{
    return hz < 90 ? below_90 * hz : hz <= end ? from_90 * hz : INFINITY;
}

enum crt_ieee1789 crt_ieee1789(double hz, double percent)
{
    if (!(hz > 0))
        return CRT_IEEE_ABOVE;
    if (percent <= allowed(hz, no_effect.below_90, no_effect.from_90, no_effect.end))
        return CRT_IEEE_NO_EFFECT;
    if (percent <= allowed(hz, low_risk.below_90, low_risk.from_90, low_risk.end))
        return CRT_IEEE_LOW_RISK;
    return CRT_IEEE_ABOVE;
}

const char *crt_ieee1789_name(enum crt_ieee1789 c)
{
    static const char *const name[] = {"no observable effect", "low risk",
                                       "above the low-risk limit"};
    return name[c];
}

/* CIE TN 006:2016 and IEC TR 63158:2018, as commonly quoted: (Σ (C_m/T_m)^3.7)^(1/3.7) with the threshold of visibility of a
 * sine T(f) = 1/(1 + e^(−0.00518·(f − 306.6 Hz))) + 20·e^(−f/10 Hz), 80 Hz … 2 kHz. */
#define SVM_LOW   80.0
#define SVM_HIGH  2000.0
#define SVM_POWER 3.7

static double svm_threshold(double hz)
{
    return 1 / (1 + crt_exp(-0.00518 * (hz - 306.6))) + 20 * crt_exp(-hz / 10);
}

double crt_svm(double hz, const double *c, int count)
{
    if (!(hz >= SVM_LOW && hz <= SVM_HIGH))
        return NAN;
    double sum = 0;
    for (int i = 0; i < count && (i + 1) * hz <= SVM_HIGH; i++)
        sum += crt_pow(c[i] / svm_threshold((i + 1) * hz), SVM_POWER);
    return crt_pow(sum, 1 / SVM_POWER);
}
