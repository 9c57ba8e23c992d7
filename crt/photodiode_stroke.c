/* Light that a stroke puts on a place. */
#include <math.h>

#include "crt/photodiode_parts.h"
#include "crt/share.h"

/* Shorter ways than this, sigma, are none: to 1e-10. */
#define STAYS 1e-5

static bool add_constant(struct crt_flux *flux, double from, double to, double q)
{
    struct crt_flux_span span = {.from = from, .to = to, .constant = true};
    for (int i = 0; i < CRT_FLUX_NODES; i++)
        span.q[i] = q;
    return !(q > 0) || !(from < to) || crt_flux_add(flux, &span);
}

/* A way along a straight line. */
struct way {
    double along, across2; /* mm, of the place, from the start and from the line, squared */
    double speed;          /* mm/s */
    double power;
};

static bool add_moving(struct crt_flux *flux, const struct crt_aperture *a,
                       const struct crt_view *view, const struct way *way, double from, double to)
{
    struct crt_flux_span span = {.from = from, .to = to};
    for (int i = 0; i < CRT_FLUX_NODES; i++) {
        double off = way->along - crt_flux_time(from, to, i) * way->speed;
        span.q[i] = way->power * crt_aperture_density(a, view, off * off + way->across2);
    }
    return crt_flux_add(flux, &span);
}

bool crt_flux_stroke(struct crt_flux *flux, struct crt_aperture *a, const struct crt_entry *entry,
                     double from, double to)
{
    const struct crt_stroke *s = &entry->stroke;
    double ex = (double)s->x1 - (double)s->x0, ey = (double)s->y1 - (double)s->y0;
    double px = a->x_mm - (double)s->x0, py = a->y_mm - (double)s->y0, sigma = entry->sigma_mm;
    double length = sqrt(ex * ex + ey * ey), reach = crt_aperture_reach(a, sigma);
    if (a->kind == CRT_DIODE_SCREEN)
        return add_constant(flux, from, to, entry->power / a->area_mm2);
    if (length < STAYS * sigma) {
        double d2 = px * px + py * py;
        if (d2 > reach * reach)
            return true;
        struct crt_view view = crt_aperture_view(a, sigma);
        return add_constant(flux, from, to, entry->power * crt_aperture_density(a, &view, d2));
    }
    double cross = (px * ey - py * ex) / length;
    struct way way = {(px * ex + py * ey) / length, cross * cross,
                      length / crt_seconds(s->t0, s->t1), entry->power};
    double half2 = reach * reach - way.across2;
    if (half2 <= 0)
        return true;
    double half = sqrt(half2);
    from = fmax(from, (way.along - half) / way.speed);
    to = fmin(to, (way.along + half) / way.speed);
    if (!(from < to))
        return true;
    struct crt_view view = crt_aperture_view(a, sigma);
    int parts = (int)fmin(ceil((to - from) * way.speed / sigma), 1e6);
    for (int i = 0; i < parts; i++) {
        double begin = from + (to - from) * i / parts;
        double end = i + 1 == parts ? to : from + (to - from) * (i + 1) / parts;
        if (begin < end && !add_moving(flux, a, &view, &way, begin, end))
            return false;
    }
    return true;
}
