#include "crt/aperture.h"

#include <math.h>
#include <stdlib.h>

#include "crt/flux.h"
#include "crt/maths.h"

#define PI       3.14159265358979324
#define ROOT_TWO 1.41421356237309505

#define STEPS_A_LOG   256.0 /* sigmas that have a table: e^(n/STEPS_A_LOG) */
#define STEPS_A_SIGMA 16.0  /* of distance */

struct crt_disc_table {
    int level;            /* of sigma */
    double first, per_mm; /* distance of sample 0; samples a mm */
    int count;
    double at[]; /* density and its change from one sample to the next, in turns */
};

void crt_aperture_init(struct crt_aperture *a, const struct crt_photodiode_desc *desc,
                       const struct crt_tube_row *row)
{
    *a = (struct crt_aperture){.kind = desc->kind};
    a->area_mm2 = row->width.value * row->height.value;
    if (desc->kind == CRT_DIODE_SCREEN)
        return;
    a->x_mm = desc->x_mm;
    a->y_mm = desc->y_mm;
    a->radius_mm = desc->kind == CRT_DIODE_DISC ? desc->diameter_mm / 2 : 0;
}

void crt_aperture_free(struct crt_aperture *a)
{
    for (size_t i = 0; i < a->tables; i++)
        free(a->table[i]);
    free(a->table);
    a->table = NULL;
    a->tables = a->room = 0;
}

double crt_aperture_reach(const struct crt_aperture *a, double sigma_mm)
{
    return CRT_APERTURE_REACH * sigma_mm + a->radius_mm;
}

/* ---- tables of discs --------------------------------------------------------------------------- */

/* asin to 1e-6: the reach of a spot need not be exact. */
static double angle_of(double sine)
{
    double a = -PI / 2, b = PI / 2;
    if (sine >= 1 || sine <= -1)
        return sine > 0 ? b : a;
    for (int i = 0; i < 21; i++) {
        double middle = (a + b) / 2;
        if (crt_sin(middle) < sine)
            a = middle;
        else
            b = middle;
    }
    return (a + b) / 2;
}

/* Mean over the disc of a spot at distance d, and its derivative; u = R·sin(angle) takes the root out of the
 * half chords. */
static void disc_density(double radius, double sigma, double d, double *density, double *slope)
{
    double reach = (CRT_APERTURE_REACH + 1) * sigma;
    double low = fmax(-1, (d - reach) / radius), high = fmin(1, (d + reach) / radius);
    double sum = 0, change = 0;
    *density = *slope = 0;
    if (low >= high)
        return;
    double a = angle_of(low), b = angle_of(high);
    int panels = (int)fmin(ceil((high - low) * radius / sigma * 2), 400) + 3;
    for (int p = 0; p < panels; p++) {
        double from = a + (b - a) * p / panels, to = a + (b - a) * (p + 1) / panels;
        for (int i = 0; i < CRT_FLUX_NODES; i++) {
            double angle = crt_flux_time(from, to, i), cosine = crt_cos(angle);
            double z = (radius * crt_sin(angle) - d) / sigma;
            double light = crt_flux_load[i] * (to - from) / 2 * radius * cosine *
                           crt_exp(-z * z / 2) * crt_erf(radius * cosine / (ROOT_TWO * sigma));
            sum += light;
            change += light * z / sigma;
        }
    }
    double scale = 1 / (PI * radius * radius * sqrt(2 * PI) * sigma);
    *density = sum * scale;
    *slope = change * scale;
}

static double sigma_of(int level)
{
    return crt_exp(level / STEPS_A_LOG);
}

static struct crt_disc_table *make_table(double radius, int level)
{
    double sigma = sigma_of(level), reach = CRT_APERTURE_REACH * sigma,
           step = sigma / STEPS_A_SIGMA;
    double first = fmax(0, radius - reach);
    int count = (int)ceil((radius + reach - first) / step) + 1;
    struct crt_disc_table *t = malloc(sizeof *t + (size_t)count * 2 * sizeof t->at[0]);
    if (!t)
        return NULL;
    *t = (struct crt_disc_table){level, first, 1 / step, count};
    for (int i = 0; i < count; i++) {
        double slope;
        disc_density(radius, sigma, first + i * step, &t->at[2 * i], &slope);
        t->at[2 * i + 1] = slope * step;
    }
    return t;
}

static const struct crt_disc_table *table_of(struct crt_aperture *a, int level)
{
    for (size_t i = a->tables; i-- > 0;)
        if (a->table[i]->level == level)
            return a->table[i];
    if (a->tables == a->room) {
        size_t room = a->room ? 2 * a->room : 16;
        struct crt_disc_table **table = realloc(a->table, room * sizeof *table);
        if (!table)
            return NULL;
        a->table = table;
        a->room = room;
    }
    struct crt_disc_table *made = make_table(a->radius_mm, level);
    if (made)
        a->table[a->tables++] = made;
    return made;
}

/* Cubic through values and slopes. */
static double look_up(const struct crt_disc_table *t, double d)
{
    double at = (d - t->first) * t->per_mm;
    if (at <= 0)
        return t->at[0];
    if (at >= t->count - 1)
        return 0;
    int i = (int)at;
    const double *v = &t->at[2 * i];
    double f = at - i, rise = v[2] - v[0];
    double c = 3 * rise - 2 * v[1] - v[3], e = v[1] + v[3] - 2 * rise;
    return v[0] + f * (v[1] + f * (c + f * e));
}

/* ---- views ------------------------------------------------------------------------------------- */

struct crt_view crt_aperture_view(struct crt_aperture *a, double sigma)
{
    struct crt_view view = {0};
    if (a->kind == CRT_DIODE_SCREEN) {
        view.scale = 1 / a->area_mm2;
    } else if (a->kind == CRT_DIODE_POINT) {
        view.per2 = 1 / (2 * sigma * sigma);
        view.scale = 1 / (2 * PI * sigma * sigma);
    } else {
        double level = fmin(fmax(crt_log(sigma) * STEPS_A_LOG, -1e6), 1e6);
        view.blend = level - floor(level);
        view.low = table_of(a, (int)floor(level));
        view.high = table_of(a, (int)floor(level) + 1);
        if (!view.low || !view.high)
            a->lost++;
    }
    return view;
}

double crt_aperture_density(const struct crt_aperture *a, const struct crt_view *view, double d2)
{
    if (a->kind == CRT_DIODE_SCREEN)
        return view->scale;
    if (a->kind == CRT_DIODE_POINT)
        return view->scale * crt_exp(-d2 * view->per2);
    if (!view->low || !view->high)
        return 0;
    double d = sqrt(d2);
    return look_up(view->low, d) * (1 - view->blend) + look_up(view->high, d) * view->blend;
}
