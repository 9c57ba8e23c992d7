/* What a photodiode saw, as samples. */
#include <math.h>

#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"
#include "crt/waveform.h"

uint64_t crt_waveform_time(uint64_t t0, uint64_t t1, size_t n, size_t i)
{
    double part = (double)(t1 - t0) / (double)n * (double)i;
    return t0 + (uint64_t)floor(part + 0.5);
}

void crt_waveform_sample(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, size_t n,
                         double *cd_m2)
{
    for (size_t i = 0; i < n; i++)
        cd_m2[i] = crt_photodiode_luminance(diode, crt_waveform_time(t0, t1, n, i));
}

struct columns {
    const struct crt_phosphor *phosphor;
    double seconds; /* of a column */
    size_t n;
    struct crt_waveform_range *range;
};

/* Extremes are at the ends of a stretch, or of the column. */
static void add_stretch(void *context, const struct crt_diode_stretch *s)
{
    struct columns *c = context;
    size_t at = (size_t)fmax(floor(s->at_s / c->seconds), 0);
    for (; at < c->n && (double)at * c->seconds < s->at_s + s->seconds; at++) {
        double begin = (double)at * c->seconds - s->at_s, end = begin + c->seconds;
        double v[2] = {begin > 0 ? crt_stretch_at(c->phosphor, s, begin) : s->first,
                       end < s->seconds ? crt_stretch_at(c->phosphor, s, end) : s->last};
        for (int i = 0; i < 2; i++) {
            c->range[at].least = fmin(c->range[at].least, v[i]);
            c->range[at].most = fmax(c->range[at].most, v[i]);
        }
    }
}

void crt_waveform_ranges(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, size_t n,
                         struct crt_waveform_range *range)
{
    struct columns c = {diode->tube->desc.phosphor, crt_seconds(t0, t1) / (double)n, n, range};
    for (size_t i = 0; i < n; i++)
        range[i] = (struct crt_waveform_range){INFINITY, 0};
    crt_diode_walk(diode, t0, t1, INFINITY, add_stretch, &c);
    for (size_t i = 0; i < n; i++)
        range[i].least = fmin(range[i].least, range[i].most);
}
