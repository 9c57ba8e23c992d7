#include "tests/support/line_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979324

struct crt_tube_row line_model_row(double width_mm, double height_mm, double spot_mm)
{
    struct crt_tube_row row = {.name = "MODEL", .phosphor = "MODEL", .kind = CRT_RASTER_TUBE};
    row.width.value = width_mm;
    row.height.value = height_mm;
    row.border.value = 2;
    row.spot.value = spot_mm;
    row.spot_exponent.value = 0.6;
    row.gun_exponent.value = 2.5;
    row.field_luminance.value = 100;
    row.field_duty.value = 0.7;
    row.bandwidth.value = 65;
    row.spot_edge.value = 1;
    return row;
}

struct crt_tube_row line_model_colour_row(double width_mm, double height_mm, double spot_mm)
{
    struct crt_tube_row row = line_model_row(width_mm, height_mm, spot_mm);
    row.mask = CRT_MASK_DELTA;
    row.mask_pitch.value = 0.26;
    row.mask_transmission.value = 0.2;
    return row;
}

struct crt_phosphor line_model_p22(void)
{
    static const struct {
        double a, tau_ms; /* rate amplitude */
        int colour;
    } term[] = {{4, 0.442, 0},   {1.75, 0.0995, 0}, {30, 0.0058, 1}, {6, 0.031, 1},
                {1, 0.169, 1},   {0.15, 0.913, 1},  {30, 0.0055, 2}, {6, 0.030, 2},
                {0.9, 0.165, 2}, {0.12, 0.9, 2}};
    struct crt_phosphor p = {.name = "P22-like",
                             .colours = 3,
                             .colour = {{0.625, 0.340}, {0.285, 0.605}, {0.150, 0.065}}};
    double sum = 0;
    p.terms = (int)(sizeof term / sizeof term[0]);
    for (int k = 0; k < p.terms; k++) {
        p.term[k] = (struct crt_phosphor_term){term[k].a * term[k].tau_ms, term[k].tau_ms * 1e-3,
                                               term[k].colour};
        sum += p.term[k].w;
    }
    for (int k = 0; k < p.terms; k++)
        p.term[k].w /= sum;
    return p;
}

/* Shares of luminance that mix D65, by Cramer's rule. */
static double white_share(const struct crt_phosphor *p, int gun)
{
    double m[3][3], w[3] = {0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290}, det[2];
    for (int c = 0; c < 3; c++) {
        m[0][c] = p->colour[c].x / p->colour[c].y;
        m[1][c] = 1;
        m[2][c] = (1 - p->colour[c].x - p->colour[c].y) / p->colour[c].y;
    }
    for (int i = 0; i < 2; i++) {
        if (i == 1)
            for (int r = 0; r < 3; r++)
                m[r][gun] = w[r];
        det[i] = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                 m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                 m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    }
    return det[1] / det[0];
}

static int guns_of(const struct line_model *m)
{
    return m->row->mask == CRT_MASK_NONE ? 1 : 3;
}

double line_model_power(const struct line_model *m, int gun)
{
    const struct crt_tube_row *r = m->row;
    double full = r->field_luminance.value * r->width.value * r->height.value / r->field_duty.value,
           terms = 0;
    if (guns_of(m) == 1)
        return full;
    for (int k = 0; k < m->phosphor->terms; k++)
        if (m->phosphor->term[k].colour == gun)
            terms += m->phosphor->term[k].w;
    return full * white_share(m->phosphor, gun) / terms;
}

/* Where a gun's beam lands when sent to (x, y), and its sigma at vanishing current. */
static void landing(const struct line_model *m, int gun, double x, double y, double *lx, double *ly,
                    double *sigma)
{
    const struct crt_tube_row *r = m->row;
    double half2 = (r->width.value * r->width.value + r->height.value * r->height.value) / 4;
    double r2 = (x * x + y * y) / half2, miss = r->converge.value + r->converge_edge.value * r2;
    double angle[3] = {7 * PI / 6, 11 * PI / 6, PI / 2};
    *lx = x;
    *ly = y;
    if (r->mask == CRT_MASK_DELTA) {
        *lx += miss * cos(angle[gun]);
        *ly += miss * sin(angle[gun]);
    } else if (r->mask != CRT_MASK_NONE) {
        *lx += miss * (gun - 1);
    }
    *sigma = r->spot.value / CRT_WIDTH60_SIGMA * (1 + (r->spot_edge.value - 1) * r2) *
             sqrt(1 + m->knobs.focus * m->knobs.focus);
}

/* Part of a deposit at t (s) that a colour's terms emit between a and b. */
static double share(const struct crt_phosphor *p, int colour, double t, double a, double b)
{
    double sum = 0;
    for (int k = 0; k < p->terms; k++) {
        double tau = p->term[k].tau_s;
        if (p->term[k].colour != colour || t >= b)
            continue;
        if (t < a)
            sum += p->term[k].w * (exp(-(a - t) / tau) - exp(-(b - t) / tau));
        else
            sum += p->term[k].w * -expm1(-(b - t) / tau);
    }
    return sum;
}

static const double node[8] = {-0.9602898564975363, -0.7966664774136267, -0.5255324099163290,
                               -0.1834346424956498, 0.1834346424956498,  0.5255324099163290,
                               0.7966664774136267,  0.9602898564975363};
static const double load[8] = {0.1012285362903763, 0.2223810344533745, 0.3137066458778873,
                               0.3626837833783620, 0.3626837833783620, 0.3137066458778873,
                               0.2223810344533745, 0.1012285362903763};

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

struct sweep {
    const struct line_model *m;
    const struct crt_scan_line *line;
    int gun, colour;
    double x, y, a, b; /* the point; the exposure, s from the line's start */
    double lit;        /* s */
};

/* Notes a moment within a dot; no number is none. */
static int add_inside(double *at, int n, double moment, double dot_s)
{
    if (moment > 0 && moment < dot_s)
        at[n++] = moment;
    return n;
}

/* Light of one dot: from `v` at its start the amplifier goes to `drive`. */
static double dot_light(const struct sweep *s, int dot, double v, double drive, double tau)
{
    const struct crt_tube_row *r = s->m->row;
    double dot_s = s->lit / s->line->dots, start = dot * dot_s, at[600], sum = 0;
    double speed = ((double)s->line->x1 - (double)s->line->x0) / s->lit;
    double sigma0 = r->spot.value / CRT_WIDTH60_SIGMA, growth = r->spot_growth.value;
    int n = 0;
    at[n++] = 0;
    at[n++] = dot_s;
    n = add_inside(at, n, s->a - start, dot_s);
    n = add_inside(at, n, s->b - start, dot_s);
    for (double t = 0.5; t < 60; t *= 2)
        n = add_inside(at, n, t * tau, dot_s);
    if (drive > 1 || drive < 0 || v > 1 || v < 0) { /* where it is clipped */
        n = add_inside(at, n, tau * log((v - drive) / (1 - drive)), dot_s);
        n = add_inside(at, n, tau * log((v - drive) / (0 - drive)), dot_s);
    }
    double there = (s->x - (double)s->line->x0) / speed - start, sigma_s = sigma0 / speed;
    for (int i = -12; i <= 12; i++)
        n = add_inside(at, n, there + i * sigma_s, dot_s);
    for (int k = 0; k < s->m->phosphor->terms; k++)
        for (double back = 0.25; back < 40; back *= 2) {
            double tau_s = s->m->phosphor->term[k].tau_s;
            n = add_inside(at, n, s->a - start - back * tau_s, dot_s);
            n = add_inside(at, n, s->b - start - back * tau_s, dot_s);
        }
    qsort(at, (size_t)n, sizeof at[0], ascending);
    for (int i = 0; i + 1 < n; i++)
        for (int j = 0; j < 8 && at[i + 1] > at[i]; j++) {
            double half = (at[i + 1] - at[i]) / 2, t = at[i] + half * (1 + node[j]);
            double u = fmin(fmax(drive + (v - drive) * exp(-t / tau), 0), 1), lx, ly, sigma;
            double current = pow(u, r->gun_exponent.value);
            if (current <= 0)
                continue;
            landing(s->m, s->gun, (double)s->line->x0 + (start + t) * speed, (double)s->line->y0,
                    &lx, &ly, &sigma);
            double d2 = ((s->x - lx) * (s->x - lx) + (s->y - ly) * (s->y - ly)) / (sigma * sigma);
            double spot = exp(-d2 / 2);
            if (growth > 0) {
                double wide = 1 + growth * growth / (sigma0 * sigma0);
                double part = pow(current, 2 * r->spot_exponent.value);
                spot = (1 - part) * spot + part * exp(-d2 / wide / 2) / wide;
            }
            double emitted = share(s->m->phosphor, s->colour, start + t, s->a, s->b);
            sum += half * load[j] * current * spot * emitted / (2 * PI * sigma * sigma);
        }
    return sum;
}

static double line_light(const struct sweep *s)
{
    const struct crt_knobs *knobs = &s->m->knobs;
    const struct crt_tube_row *r = s->m->row;
    double tau = 1 / (2 * PI * r->bandwidth.value * 1e6), v = knobs->brightness, sum = 0;
    double dot_s = s->lit / s->line->dots, reach = 0;
    double pitch = ((double)s->line->x1 - (double)s->line->x0) / s->line->dots;
    double sigma0 = r->spot.value / CRT_WIDTH60_SIGMA;
    reach = 6.5 * (sqrt(sigma0 * sigma0 + r->spot_growth.value * r->spot_growth.value) *
                   r->spot_edge.value * sqrt(1 + knobs->focus * knobs->focus)) +
            r->converge.value + 2 * r->converge_edge.value;
    if (fabs(s->y - (double)s->line->y0) > reach)
        return 0;
    for (int dot = 0; dot < s->line->dots; dot++) {
        double drive = knobs->contrast * s->line->drive[s->gun][dot] / 255 + knobs->brightness;
        double x = (double)s->line->x0 + dot * pitch;
        if (s->x > x - reach && s->x < x + pitch + reach)
            sum += dot_light(s, dot, v, drive, tau);
        v = drive + (v - drive) * exp(-dot_s / tau);
    }
    return sum;
}

double line_model_light(const struct line_model *m, const struct crt_scan_line *lines, int count,
                        int colour, double x, double y, uint64_t a, uint64_t b)
{
    int gun = guns_of(m) == 1 ? 0 : colour;
    double sum = 0, power = line_model_power(m, gun);
    for (int i = 0; i < count; i++) {
        struct sweep s = {m, &lines[i], gun, colour, x, y, 0, 0, 0};
        s.a = ((double)a - (double)lines[i].t0) * 1e-12;
        s.b = ((double)b - (double)lines[i].t0) * 1e-12;
        s.lit = (double)(lines[i].t1 - lines[i].t0) * 1e-12;
        sum += line_light(&s);
    }
    return sum * power;
}
