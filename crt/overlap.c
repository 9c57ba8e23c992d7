#include "crt/overlap.h"

#include <math.h>
#include <stdbool.h>

/* ---- discs ----------------------------------------------------------------------------------- */

/* Abscissas above 0 and weights of Gauss-Legendre quadrature with 8 points (Abramowitz and Stegun,
 * table 25.4). */
static const double gauss_at[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                   0.9602898564975363};
static const double gauss_weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                       0.1012285362903763};

#define MAX_CUTS 12

static double nearest(double low, double high, double v)
{
    return v < low ? low - v : v > high ? v - high : 0;
}

/* Whether the box lies within all discs (1), apart from one of them (-1), or neither (0). */
static int plain_case(const struct crt_disc *disc, int count, const struct crt_box *box)
{
    bool within = true;
    for (int i = 0; i < count; i++) {
        double r2 = disc[i].radius * disc[i].radius;
        double nx = nearest(box->x0, box->x1, disc[i].x), ny = nearest(box->y0, box->y1, disc[i].y);
        double fx = fmax(fabs(box->x0 - disc[i].x), fabs(box->x1 - disc[i].x));
        double fy = fmax(fabs(box->y0 - disc[i].y), fabs(box->y1 - disc[i].y));
        if (nx * nx + ny * ny >= r2)
            return -1;
        within = within && fx * fx + fy * fy <= r2;
    }
    return within;
}

static void cut(double *cuts, int *count, double low, double high, double x)
{
    if (!(x > low && x < high))
        return;
    int i = (*count)++;
    for (; i > 0 && cuts[i - 1] > x; i--)
        cuts[i] = cuts[i - 1];
    cuts[i] = x;
}

/* Where the outline of a disc crosses the line at height y. */
static void cut_at_height(double *cuts, int *count, double low, double high,
                          const struct crt_disc *d, double y)
{
    double h2 = d->radius * d->radius - (y - d->y) * (y - d->y);
    if (h2 <= 0)
        return;
    cut(cuts, count, low, high, d->x - sqrt(h2));
    cut(cuts, count, low, high, d->x + sqrt(h2));
}

/* Where two circles cross. */
static void cut_at_crossings(double *cuts, int *count, double low, double high,
                             const struct crt_disc *d)
{
    double dx = d[1].x - d[0].x, dy = d[1].y - d[0].y, d2 = dx * dx + dy * dy;
    if (!(d2 > 0))
        return;
    double along = (d2 + d[0].radius * d[0].radius - d[1].radius * d[1].radius) / (2 * d2);
    double across2 = d[0].radius * d[0].radius / d2 - along * along;
    if (across2 <= 0)
        return;
    double across = sqrt(across2);
    cut(cuts, count, low, high, d[0].x + along * dx - across * dy);
    cut(cuts, count, low, high, d[0].x + along * dx + across * dy);
}

static double height_at(const struct crt_disc *disc, int count, const struct crt_box *box, double x)
{
    double bottom = box->y0, top = box->y1;
    for (int i = 0; i < count; i++) {
        double h2 = disc[i].radius * disc[i].radius - (x - disc[i].x) * (x - disc[i].x);
        double h = h2 > 0 ? sqrt(h2) : 0;
        bottom = fmax(bottom, disc[i].y - h);
        top = fmin(top, disc[i].y + h);
    }
    return top > bottom ? top - bottom : 0;
}

/* The outline is smooth from a to b, but may be upright at either end, where the height goes as a
 * root: with x = middle + half·(3u − u³)/2 it is smooth in u, too. */
static double area_between(const struct crt_disc *disc, int count, const struct crt_box *box,
                           double a, double b)
{
    double middle = (a + b) / 2, half = (b - a) / 2, sum = 0;
    for (int i = 0; i < 4; i++) {
        double u = gauss_at[i], w = gauss_weight[i] * 1.5 * (1 - u * u);
        double off = half * u * (1.5 - 0.5 * u * u);
        sum += w * (height_at(disc, count, box, middle - off) +
                    height_at(disc, count, box, middle + off));
    }
    return sum * half;
}

double crt_overlap_discs(const struct crt_disc *disc, int count, const struct crt_box *box)
{
    int plain = plain_case(disc, count, box);
    if (plain != 0)
        return plain > 0 ? (box->x1 - box->x0) * (box->y1 - box->y0) : 0;
    double low = box->x0, high = box->x1;
    for (int i = 0; i < count; i++) {
        low = fmax(low, disc[i].x - disc[i].radius);
        high = fmin(high, disc[i].x + disc[i].radius);
    }
    double cuts[MAX_CUTS];
    int n = 0;
    for (int i = 0; i < count; i++) {
        cut_at_height(cuts, &n, low, high, &disc[i], box->y0);
        cut_at_height(cuts, &n, low, high, &disc[i], box->y1);
    }
    if (count == 2)
        cut_at_crossings(cuts, &n, low, high, disc);
    double sum = 0, from = low;
    for (int i = 0; i <= n; i++) {
        double to = i < n ? cuts[i] : high;
        if (to > from)
            sum += area_between(disc, count, box, from, to);
        from = to;
    }
    return sum;
}

/* ---- combs ----------------------------------------------------------------------------------- */

/* Length of teeth from 0 to x, if x < 0 negative. */
static double teeth_up_to(double x, double pitch, double low, double high)
{
    double from_low = x - low, k = floor(from_low / pitch);
    return k * (high - low) + fmin(from_low - k * pitch, high - low);
}

double crt_overlap_comb(double from, double to, double pitch, double low, double high)
{
    return teeth_up_to(to, pitch, low, high) - teeth_up_to(from, pitch, low, high);
}
