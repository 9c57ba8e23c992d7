#include "emu/plot/ink.h"

#include <math.h>
#include <stdlib.h>

#include "crt/maths.h"

/* Beyond this a coordinate is as good as infinite: larger than any picture, small enough to square. */
#define FAR 1e9

static double least(double a, double b)
{
    return a < b ? a : b;
}

static double most(double a, double b)
{
    return a > b ? a : b;
}

/* NaN becomes `low`. */
static int whole(double v, int low, int high)
{
    return v >= high ? high : v > low ? (int)v : low;
}

static double decoded(int sample)
{
    double v = sample / 255.0;
    return v <= 0.04045 ? v / 12.92 : crt_pow((v + 0.055) / 1.055, 2.4);
}

static void nothing_covered(struct vm_ink *ink)
{
    ink->bx0 = ink->image->width;
    ink->by0 = ink->image->height;
    ink->bx1 = ink->by1 = 0;
}

bool vm_ink_open(struct vm_ink *ink, struct crt_image *image, struct crt_error *err)
{
    ink->image = image;
    ink->coverage = calloc((size_t)image->width * (size_t)image->height, sizeof *ink->coverage);
    if (!ink->coverage)
        return crt_fail(
            err, "not enough memory to draw a picture of %d by %d pixels; choose a smaller one",
            image->width, image->height);
    for (int i = 0; i < 256; i++)
        ink->linear[i] = decoded(i);
    crt_srgb_encoder_init(&ink->encoder);
    nothing_covered(ink);
    vm_ink_unclip(ink);
    return true;
}

void vm_ink_close(struct vm_ink *ink)
{
    free(ink->coverage);
    ink->coverage = NULL;
}

void vm_ink_clip(struct vm_ink *ink, struct vm_rect box)
{
    ink->x0 = whole(floor(box.x0 + 0.5), 0, ink->image->width);
    ink->y0 = whole(floor(box.y0 + 0.5), 0, ink->image->height);
    ink->x1 = whole(floor(box.x1 + 0.5), ink->x0, ink->image->width);
    ink->y1 = whole(floor(box.y1 + 0.5), ink->y0, ink->image->height);
}

void vm_ink_unclip(struct vm_ink *ink)
{
    ink->x0 = ink->y0 = 0;
    ink->x1 = ink->image->width;
    ink->y1 = ink->image->height;
}

/* ---- cover ------------------------------------------------------------------------------------ */

static float *row_of(const struct vm_ink *ink, int y)
{
    return ink->coverage + (size_t)y * (size_t)ink->image->width;
}

static void covered(struct vm_ink *ink, int x0, int y0, int x1, int y1)
{
    ink->bx0 = x0 < ink->bx0 ? x0 : ink->bx0;
    ink->by0 = y0 < ink->by0 ? y0 : ink->by0;
    ink->bx1 = x1 > ink->bx1 ? x1 : ink->bx1;
    ink->by1 = y1 > ink->by1 ? y1 : ink->by1;
}

/* Narrows t0 … t1 to where p + t·d lies in low … high. */
static bool narrow(double p, double d, double low, double high, double *t0, double *t1)
{
    if (d == 0.0)
        return p >= low && p <= high;
    double a = (low - p) / d, b = (high - p) / d;
    *t0 = most(*t0, least(a, b));
    *t1 = least(*t1, most(a, b));
    return *t0 <= *t1;
}

/* Cuts the segment to the clip grown by `margin`; false if it misses that. */
static bool cut(const struct vm_ink *ink, double margin, double p[4])
{
    double t0 = 0, t1 = 1, x = p[0], y = p[1], dx = p[2] - x, dy = p[3] - y;
    if (!narrow(x, dx, ink->x0 - margin, ink->x1 + margin, &t0, &t1) ||
        !narrow(y, dy, ink->y0 - margin, ink->y1 + margin, &t0, &t1))
        return false;
    if (t1 < 1) {
        p[2] = x + t1 * dx;
        p[3] = y + t1 * dy;
    }
    if (t0 > 0) {
        p[0] = x + t0 * dx;
        p[1] = y + t0 * dy;
    }
    return true;
}

/* Half the diagonal of a pixel, rounded up: beyond it an edge does not touch it. */
#define CORNER 0.7072

struct capsule {
    double x, y, dx, dy, length2, half, reach;
};

/* The share of a pixel on the inner side of an edge that lies x beyond its centre, `nx` and `ny` >= 0 the edge's
 * normal: the integral of a trapezoid, the pixel seen along the edge. */
static double inner_share(double x, double nx, double ny)
{
    double a = (nx + ny) / 2, b = fabs(nx - ny) / 2, far = fabs(x), beyond;
    if (far >= a)
        beyond = 0;
    else if (far <= b)
        beyond = 0.5 - far / (a + b);
    else
        beyond = (a - far) * (a - far) / (2 * (a * a - b * b));
    return x < 0 ? beyond : 1 - beyond;
}

static double coverage_at(const struct capsule *c, double px, double py)
{
    double vx = px - c->x, vy = py - c->y;
    double t = c->length2 > 0 ? (vx * c->dx + vy * c->dy) / c->length2 : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    double ex = vx - t * c->dx, ey = vy - t * c->dy, d2 = ex * ex + ey * ey,
           inner = c->half - CORNER;
    if (d2 >= c->reach * c->reach)
        return 0;
    if (inner > 0 && d2 <= inner * inner)
        return 1;
    double d = sqrt(d2), nx = 1, ny = 0;
    if (d > 1e-6) {
        nx = fabs(ex) / d;
        ny = fabs(ey) / d;
    } else if (c->length2 > 0) {
        nx = fabs(c->dy) / sqrt(c->length2);
        ny = fabs(c->dx) / sqrt(c->length2);
    }
    return most(0, inner_share(c->half - d, nx, ny) + inner_share(c->half + d, nx, ny) - 1);
}

/* The columns of a row within reach of the segment's line. */
static void columns_of(const struct vm_ink *ink, const struct capsule *c, double py, int *x0,
                       int *x1)
{
    double left = least(c->x, c->x + c->dx) - c->reach, right = most(c->x, c->x + c->dx) + c->reach;
    if (fabs(c->dy) > 1e-9) {
        double at = c->x + c->dx * ((py - c->y) / c->dy);
        double side = c->reach * sqrt(c->length2) / fabs(c->dy);
        left = most(left, at - side);
        right = least(right, at + side);
    }
    *x0 = whole(floor(left), ink->x0, ink->x1);
    *x1 = whole(ceil(right) + 1, ink->x0, ink->x1);
}

void vm_ink_segment(struct vm_ink *ink, double x0, double y0, double x1, double y1, double width)
{
    double p[4] = {x0, y0, x1, y1};
    for (int i = 0; i < 4; i++)
        if (!(fabs(p[i]) <= FAR))
            return;
    double half = width / 2;
    if (!(half > 0) || !cut(ink, half + 2, p))
        return;
    struct capsule c = {p[0], p[1], p[2] - p[0], p[3] - p[1], 0, half, half + CORNER};
    c.length2 = c.dx * c.dx + c.dy * c.dy;
    int top = whole(floor(least(p[1], p[3]) - c.reach), ink->y0, ink->y1);
    int bottom = whole(ceil(most(p[1], p[3]) + c.reach) + 1, ink->y0, ink->y1);
    int low = ink->x1, high = ink->x0;
    for (int y = top; y < bottom; y++) {
        float *row = row_of(ink, y);
        int left, right;
        columns_of(ink, &c, y + 0.5, &left, &right);
        for (int x = left; x < right; x++) {
            float v = (float)coverage_at(&c, x + 0.5, y + 0.5);
            row[x] = v > row[x] ? v : row[x];
        }
        low = left < low ? left : low;
        high = right > high ? right : high;
    }
    if (low < high && top < bottom)
        covered(ink, low, top, high, bottom);
}

/* Adds a column's part between y0 < y1, `share` of its width. */
static void add_column(struct vm_ink *ink, int x, double y0, double y1, double share)
{
    int top = whole(floor(y0), ink->y0, ink->y1), bottom = whole(ceil(y1), ink->y0, ink->y1);
    for (int y = top; y < bottom; y++) {
        double part = least(y1, y + 1.0) - most(y0, y);
        if (part > 0)
            row_of(ink, y)[x] += (float)(part * share);
    }
    if (top < bottom)
        covered(ink, x, top, x + 1, bottom);
}

void vm_ink_area(struct vm_ink *ink, double x0, double y0, double x1, double y1, double base)
{
    if (!(fabs(x0) <= FAR && fabs(y0) <= FAR && fabs(x1) <= FAR && fabs(y1) <= FAR &&
          fabs(base) <= FAR))
        return;
    double left = least(x0, x1), right = most(x0, x1);
    int first = whole(floor(left), ink->x0, ink->x1), end = whole(ceil(right), ink->x0, ink->x1);
    for (int x = first; x < end; x++) {
        double a = most(left, x), b = least(right, x + 1.0);
        if (!(b > a))
            continue;
        double y = y0 + (y1 - y0) * (((a + b) / 2 - x0) / (x1 - x0));
        add_column(ink, x, least(y, base), most(y, base), b - a);
    }
}

void vm_ink_lift(struct vm_ink_pen *pen)
{
    pen->down = false;
    pen->done = 0;
}

/* The strokes of the pattern from where the pen is. A pattern that would be finer than a tenth of a pixel, or
 * longer than any picture needs, is drawn through. */
static void dashes(struct vm_ink *ink, struct vm_ink_pen *pen, double x, double y)
{
    double dx = x - pen->x, dy = y - pen->y, length = sqrt(dx * dx + dy * dy);
    double period = pen->on + pen->off, at = 0;
    if (!(length > 0))
        return;
    if (length > 1e5 || period < 0.1) {
        vm_ink_segment(ink, pen->x, pen->y, x, y, pen->width);
        return;
    }
    while (at < length) {
        bool on = pen->done < pen->on;
        double step = least((on ? pen->on : period) - pen->done, length - at), to = at + step;
        if (on)
            vm_ink_segment(ink, pen->x + dx * (at / length), pen->y + dy * (at / length),
                           pen->x + dx * (to / length), pen->y + dy * (to / length), pen->width);
        pen->done += step;
        if (pen->done >= period - 1e-9)
            pen->done = 0;
        else if (on && pen->done >= pen->on - 1e-9)
            pen->done = pen->on;
        at = step > 0 ? to : length;
    }
}

void vm_ink_to(struct vm_ink *ink, struct vm_ink_pen *pen, double x, double y)
{
    if (pen->down && pen->on > 0)
        dashes(ink, pen, x, y);
    else if (pen->down)
        vm_ink_segment(ink, pen->x, pen->y, x, y, pen->width);
    pen->x = x;
    pen->y = y;
    pen->down = true;
}

double vm_ink_covered(const struct vm_ink *ink, struct vm_rect box, double enough)
{
    int x0 = whole(floor(box.x0), ink->bx0, ink->bx1), x1 = whole(ceil(box.x1), ink->bx0, ink->bx1);
    int y0 = whole(floor(box.y0), ink->by0, ink->by1), y1 = whole(ceil(box.y1), ink->by0, ink->by1);
    double sum = 0;
    for (int y = y0; y < y1 && sum < enough; y++)
        for (int x = x0; x < x1; x++)
            sum += row_of(ink, y)[x];
    return sum;
}

/* ---- spread ----------------------------------------------------------------------------------- */

static void blend(const struct vm_ink *ink, uint16_t *sample, struct vm_rgb colour, double share)
{
    if (!(share > 0))
        return;
    const uint8_t to[3] = {colour.r, colour.g, colour.b};
    for (int i = 0; i < 3; i++) {
        double light = ink->linear[sample[i] & 255] * (1 - share) + ink->linear[to[i]] * share;
        sample[i] = share >= 1 ? to[i] : crt_srgb_sample(&ink->encoder, light, 255);
    }
}

static uint16_t *pixel(const struct vm_ink *ink, int x, int y)
{
    return ink->image->samples + 3 * ((size_t)y * (size_t)ink->image->width + (size_t)x);
}

void vm_ink_spread(struct vm_ink *ink, struct vm_rgb colour, double opacity)
{
    for (int y = ink->by0; y < ink->by1; y++)
        for (int x = ink->bx0; x < ink->bx1; x++) {
            float *v = row_of(ink, y) + x;
            if (*v > 0)
                blend(ink, pixel(ink, x, y), colour, least(*v, 1) * opacity);
            *v = 0;
        }
    nothing_covered(ink);
}

void vm_ink_forget(struct vm_ink *ink)
{
    for (int y = ink->by0; y < ink->by1; y++)
        for (int x = ink->bx0; x < ink->bx1; x++)
            row_of(ink, y)[x] = 0;
    nothing_covered(ink);
}

/* How much of pixel i lies in low … high. */
static double overlap(double low, double high, int i)
{
    return most(0, least(high, i + 1.0) - most(low, i));
}

static void put(uint16_t *sample, struct vm_rgb colour)
{
    sample[0] = colour.r;
    sample[1] = colour.g;
    sample[2] = colour.b;
}

void vm_ink_box(struct vm_ink *ink, struct vm_rect box, struct vm_rgb colour, double opacity)
{
    int x0 = whole(floor(box.x0), ink->x0, ink->x1), x1 = whole(ceil(box.x1), ink->x0, ink->x1);
    int y0 = whole(floor(box.y0), ink->y0, ink->y1), y1 = whole(ceil(box.y1), ink->y0, ink->y1);
    for (int y = y0; y < y1; y++) {
        double row = overlap(box.y0, box.y1, y) * opacity;
        for (int x = x0; x < x1; x++) {
            uint16_t *sample = pixel(ink, x, y);
            if (row >= 1 && x >= box.x0 && x + 1 <= box.x1)
                put(sample, colour);
            else
                blend(ink, sample, colour, overlap(box.x0, box.x1, x) * row);
        }
    }
}
