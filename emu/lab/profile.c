#include "emu/lab/profile.h"

#include <math.h>

#define LEAST_CREST 0.01  /* of the highest */
#define STANDS_OUT  0.001 /* the same */

enum { POINTS = VM_PROFILE_POINTS };

bool vm_profile_open(struct vm_profile *p, struct crt_tube *tube, const double from_mm[2],
                     const double to_mm[2], struct crt_error *err)
{
    double dx = to_mm[0] - from_mm[0], dy = to_mm[1] - from_mm[1], length = sqrt(dx * dx + dy * dy);
    *p = (struct vm_profile){.mm = {0}};
    if (!(length > 0))
        return crt_fail(err, "a profile of no length; give two places");
    for (int i = 0; i < POINTS; i++) {
        double part = i / (POINTS - 1.0);
        const struct crt_photodiode_desc desc = {.kind = CRT_DIODE_POINT,
                                                 .x_mm = from_mm[0] + part * dx,
                                                 .y_mm = from_mm[1] + part * dy};
        p->mm[i] = part * length;
        p->diode[i] = crt_photodiode_open(tube, &desc, err);
        if (!p->diode[i]) {
            vm_profile_close(p);
            return false;
        }
    }
    return true;
}

void vm_profile_close(struct vm_profile *p)
{
    for (int i = 0; i < POINTS; i++) {
        if (p->diode[i])
            crt_photodiode_close(p->diode[i]);
        p->diode[i] = NULL;
    }
}

void vm_profile_forget(struct vm_profile *p, uint64_t t)
{
    for (int i = 0; i < POINTS; i++)
        crt_photodiode_forget(p->diode[i], t);
}

/* ---- figures ------------------------------------------------------------------------------------ */

/* Where the light falls to `level` on the way from point i by `step`; NaN: the line ends before. */
static double falls_to(const struct vm_profile *p, int i, int step, double level)
{
    for (; i + step >= 0 && i + step < POINTS; i += step) {
        double here = p->cd_m2[i], next = p->cd_m2[i + step];
        if (next <= level)
            return p->mm[i] + (p->mm[i + step] - p->mm[i]) * (here - level) / (here - next);
    }
    return NAN;
}

static int highest(const struct vm_profile *p)
{
    int best = 0;
    for (int i = 1; i < POINTS; i++)
        if (p->cd_m2[i] > p->cd_m2[best])
            best = i;
    return best;
}

/* The next crest from point i on, and after it; POINTS when there is none. A crest is left when the light has
 * fallen by `out` below it; one is begun when it has risen as much above what lies between. */
static int next_crest(const struct vm_profile *p, int *i, double out)
{
    double least = *i == 0 ? 0 : p->cd_m2[*i]; /* the line's end may be a crest */
    for (; *i < POINTS && p->cd_m2[*i] <= least + out; ++*i)
        least = fmin(least, p->cd_m2[*i]);
    int crest = *i;
    for (; *i < POINTS && p->cd_m2[*i] > p->cd_m2[crest] - out; ++*i)
        if (p->cd_m2[*i] > p->cd_m2[crest])
            crest = *i;
    return crest;
}

static void find_crests(const struct vm_profile *p, struct vm_profile_figures *f)
{
    double top = f->crest_cd_m2;
    int first = -1, second = -1;
    for (int i = 0; i < POINTS;) {
        int crest = next_crest(p, &i, STANDS_OUT * top);
        if (crest >= POINTS || p->cd_m2[crest] < LEAST_CREST * top)
            continue;
        f->crests++;
        if (first < 0 || p->cd_m2[crest] > p->cd_m2[first]) {
            second = first;
            first = crest;
        } else if (second < 0 || p->cd_m2[crest] > p->cd_m2[second]) {
            second = crest;
        }
    }
    if (second < 0)
        return;
    int a = first < second ? first : second, b = first < second ? second : first;
    double dip = p->cd_m2[a];
    for (int i = a; i <= b; i++)
        dip = fmin(dip, p->cd_m2[i]);
    double lower = p->cd_m2[second];
    f->dip_cd_m2 = dip;
    f->dip_modulation = (lower - dip) / (lower + dip);
    f->apart_mm = p->mm[b] - p->mm[a];
}

bool vm_profile_measure(struct vm_profile *p, uint64_t t0, uint64_t t1,
                        struct vm_profile_figures *f, struct crt_error *err)
{
    double seconds = (double)(t1 - t0) / (double)CRT_PS_PER_S, sum = 0;
    for (int i = 0; i < POINTS; i++) {
        double light[CRT_MAX_COLOURS] = {0};
        if (!crt_photodiode_intact(p->diode[i], err))
            return false;
        crt_photodiode_gather(p->diode[i], t0, t1, light);
        p->cd_m2[i] = (light[0] + light[1] + light[2]) / seconds;
        sum += p->cd_m2[i] * (i == 0 || i == POINTS - 1 ? 0.5 : 1);
    }
    int top = highest(p);
    *f = (struct vm_profile_figures){.length_mm = p->mm[POINTS - 1],
                                     .crest_cd_m2 = p->cd_m2[top],
                                     .crest_mm = p->mm[top],
                                     .mean_cd_m2 = sum / (POINTS - 1),
                                     .least_cd_m2 = p->cd_m2[top],
                                     .dip_cd_m2 = NAN,
                                     .apart_mm = NAN};
    for (int i = 0; i < POINTS; i++)
        f->least_cd_m2 = fmin(f->least_cd_m2, p->cd_m2[i]);
    f->width60_mm =
        falls_to(p, top, 1, 0.6 * f->crest_cd_m2) - falls_to(p, top, -1, 0.6 * f->crest_cd_m2);
    f->width50_mm =
        falls_to(p, top, 1, 0.5 * f->crest_cd_m2) - falls_to(p, top, -1, 0.5 * f->crest_cd_m2);
    if (f->crest_cd_m2 > 0)
        find_crests(p, f);
    f->width60_mm = f->apart_mm < f->width60_mm ? NAN : f->width60_mm;
    f->width50_mm = f->apart_mm < f->width50_mm ? NAN : f->width50_mm;
    return true;
}
