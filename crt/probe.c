/* Looking at a tube without changing it: luminance at a point, and totals. */
#include "crt/tube.h"

#include <assert.h>
#include <math.h>

#include "crt/line_look.h"
#include "crt/maths.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

#define ROOT_TWO 1.41421356237309505
#define TWO_PI   6.28318530717958648

/* Light further from a stroke than this is left out, sigma: e^−32 = 1e-14. */
#define REACH 8.0

/* ---- strokes --------------------------------------------------------------------------------- */

/* ½·[erf(b/√2) − erf(a/√2)] for a <= b, without cancellation far out. */
static double normal_between(double a, double b)
{
    if (a > 0 && b > 0) {
        double swap = a;
        a = -b;
        b = -swap;
    }
    if (b < 0 && a < 0) {
        double near = crt_erfcx(-b / ROOT_TWO) * crt_exp(-b * b / 2);
        double far = -a > 40 ? 0 : crt_erfcx(-a / ROOT_TWO) * crt_exp(-a * a / 2);
        return (near - far) / 2;
    }
    return (crt_erf(b / ROOT_TWO) - crt_erf(a / ROOT_TWO)) / 2;
}

/* ∫ over u in [0, 1] of the normal density at x − length·u, times e^(−rate·(1 − u)); lengths in
 * sigma. With k = rate/length this is e^(k·(x − length) + k²/2)·½[erf …]/length; where the
 * exponential would overflow, the same through erfcx. */
static double faded_line(double x, double length, double rate)
{
    double k = rate / length, low = x + k - length, high = x + k;
    if (low > 0) {
        double a = crt_erfcx(low / ROOT_TWO) * crt_exp(-(x - length) * (x - length) / 2);
        double b = rate > 700 ? 0 : crt_erfcx(high / ROOT_TWO) * crt_exp(-x * x / 2 - rate);
        return (a - b) / (2 * length);
    }
    return crt_exp(k * (x - length) + k * k / 2) * normal_between(low, high) / length;
}

/* Mean of e^(−rate·(1 − u)) over u in [0, 1]. */
static double faded(double rate)
{
    return rate < 1e-8 ? 1 - rate / 2 : -crt_expm1(-rate) / rate;
}

struct looking {
    double x_mm, y_mm;
    uint64_t t;
    const struct crt_phosphor *phosphor;
    double *cd_m2;
};

/* Light of one entry drawn between `from` and `to`, by the terms of `mask`. */
static void look_at_entry(const struct looking *at, const struct crt_entry *entry, uint64_t from,
                          uint64_t to, uint32_t mask)
{
    const struct crt_stroke *s = &entry->stroke;
    from = s->t0 > from ? s->t0 : from;
    to = s->t1 < to ? s->t1 : to;
    if (from >= to)
        return;
    double whole = (double)(s->t1 - s->t0);
    double u0 = (double)(from - s->t0) / whole, u1 = (double)(to - s->t0) / whole;
    double sx = (double)s->x0, sy = (double)s->y0, ex = (double)s->x1 - sx, ey = (double)s->y1 - sy;
    double dx = ex * (u1 - u0), dy = ey * (u1 - u0), sigma = entry->sigma_mm;
    double px = at->x_mm - (sx + ex * u0), py = at->y_mm - (sy + ey * u0);
    double length = sqrt(dx * dx + dy * dy), along = 0, across2 = px * px + py * py;
    if (length > 0) {
        double cross = (px * dy - py * dx) / length;
        along = (px * dx + py * dy) / length / sigma;
        across2 = cross * cross;
    }
    across2 /= sigma * sigma;
    length /= sigma;
    if (across2 > REACH * REACH || along < -REACH || along > length + REACH)
        return;
    double energy = entry->power * crt_seconds(from, to) / (sigma * sigma);
    double after = crt_seconds(to, at->t), drawn = crt_seconds(from, to);
    /* Shorter than this the position does not matter, to 1e-10. */
    bool line = length > 1e-5;
    double profile = line ? crt_exp(-across2 / 2) / sqrt(TWO_PI) : crt_exp(-across2 / 2) / TWO_PI;
    for (int k = 0; k < at->phosphor->terms; k++) {
        const struct crt_phosphor_term *term = &at->phosphor->term[k];
        if (!(mask >> k & 1) || after / term->tau_s > 60)
            continue;
        double rate = drawn / term->tau_s;
        double shape = line ? faded_line(along, length, rate) : faded(rate);
        at->cd_m2[term->colour] += energy * entry->light[term->colour] * profile * shape * term->w /
                                   term->tau_s * crt_exp(-after / term->tau_s);
    }
}

/* ---- planes ---------------------------------------------------------------------------------- */

enum { TAPS = 12 };

/* Windowed sinc through TAPS cells around `at`: exact on a cell's centre, elsewhere within 0.8 % of
 * the crest for a spot of one cell's sigma, which is all but band-limited. */
static int taps(double at, double weight[TAPS])
{
    double first = floor(at) - (TAPS / 2 - 1), sum = 0, pi = TWO_PI / 2;
    for (int i = 0; i < TAPS; i++) {
        double d = at - (first + i), half = TAPS / 2;
        double window = fabs(d) < half ? crt_cos(pi * d / (2 * half)) : 0;
        weight[i] = d == 0 ? 1 : crt_sin(pi * d) / (pi * d) * window * window;
        sum += weight[i];
    }
    for (int i = 0; i < TAPS; i++)
        weight[i] /= sum;
    return (int)first;
}

/* What float ageing by the epochs that are due would leave of a cell. */
static double aged(float v, float factor, uint64_t due)
{
    for (; due > 0 && v > 0; due--) {
        v *= factor;
        v = v >= CRT_STORED_FLOOR ? v : 0;
    }
    return (double)v;
}

static double cell_at(const struct crt_planes *planes, const struct crt_plane *plane, int row,
                      int col)
{
    if (row < 0 || col < 0 || row >= planes->rows || col >= planes->cols)
        return 0;
    int tile = row / CRT_TILE_ROWS * planes->tile_cols + col / CRT_TILE_COLS;
    if (!plane->lit[tile])
        return 0;
    return aged(plane->cells[(size_t)row * (size_t)planes->cols + (size_t)col], plane->factor,
                planes->epoch - plane->age[tile]);
}

void crt_tube_look_at_planes(const struct crt_tube *tube, double x_mm, double y_mm, uint64_t t,
                             double cd_m2[CRT_MAX_TERMS])
{
    double col, row, across[TAPS], down[TAPS];
    crt_mm_to_cell(&tube->desc.grid, x_mm, y_mm, &col, &row);
    if (!(col > -TAPS && col < tube->planes.cols + TAPS && row > -TAPS &&
          row < tube->planes.rows + TAPS))
        return; /* no cell within reach */
    int left = taps(col, across), top = taps(row, down);
    double since = crt_seconds(tube->begin, t);
    for (int k = 0; k < tube->planes.count; k++) {
        const struct crt_plane *plane = &tube->planes.plane[k];
        double tau = tube->desc.phosphor->term[plane->term].tau_s, stored = 0;
        for (int r = 0; r < TAPS; r++)
            for (int c = 0; c < TAPS; c++)
                stored += down[r] * across[c] * cell_at(&tube->planes, plane, top + r, left + c);
        cd_m2[plane->term] += fmax(stored, 0) / tau * crt_exp(-since / tau);
    }
}

void crt_tube_probe(const struct crt_tube *tube, double x_mm, double y_mm, uint64_t t,
                    double cd_m2[CRT_MAX_COLOURS])
{
    assert(t >= tube->begin);
    struct looking at = {x_mm, y_mm, t, tube->desc.phosphor, cd_m2};
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        cd_m2[c] = 0;
    double held[CRT_MAX_TERMS] = {0};
    crt_tube_look_at_planes(tube, x_mm, y_mm, t, held);
    for (int k = 0; k < tube->planes.count; k++)
        cd_m2[at.phosphor->term[tube->planes.plane[k].term].colour] +=
            held[tube->planes.plane[k].term];
    const struct crt_journal *journal = &tube->journal;
    for (size_t i = 0; i < journal->before.count; i++)
        look_at_entry(&at, &journal->before.at[i], 0, tube->begin, tube->quick);
    for (size_t i = 0; i < journal->now.count; i++)
        look_at_entry(&at, &journal->now.at[i], tube->begin, t, UINT32_MAX);
    if (!tube->line_pass)
        return;
    crt_lines_look(tube, &tube->lines.before, x_mm, y_mm, t, 0, tube->begin, tube->quick, cd_m2);
    crt_lines_look(tube, &tube->lines.now, x_mm, y_mm, t, tube->begin, t, UINT32_MAX, cd_m2);
}

/* ---- totals ---------------------------------------------------------------------------------- */

void crt_tube_planes_stored(const struct crt_tube *tube, uint64_t t, double total[CRT_MAX_TERMS])
{
    double since = crt_seconds(tube->begin, t);
    for (int k = 0; k < tube->planes.count; k++) {
        const struct crt_plane *plane = &tube->planes.plane[k];
        double sum = 0;
        for (int row = 0; row < tube->planes.rows; row++)
            for (int col = 0; col < tube->planes.cols; col++)
                sum += cell_at(&tube->planes, plane, row, col);
        total[plane->term] += sum * crt_exp(-since / tube->desc.phosphor->term[plane->term].tau_s);
    }
}

struct crt_tube_totals crt_tube_totals(const struct crt_tube *tube)
{
    struct crt_tube_totals totals = {crt_pass_stored(tube), tube->strokes};
    double sum[CRT_MAX_TERMS] = {0};
    crt_tube_planes_stored(tube, tube->now, sum);
    for (int k = 0; k < tube->planes.count; k++)
        totals.stored += sum[tube->planes.plane[k].term];
    return totals;
}
