#include "crt/footprint.h"

#include <math.h>

#include "crt/footprint_profile.h"

/* Below this length [sigma] a stroke is a slightly oval spot: the fourth-order error is 4e-6. */
#define SHORT 0.25

#define FIXED 4294967296.0 /* 2^32 */

static int clamp_int(double x, int low, int high)
{
    return x <= low ? low : x >= high ? high : (int)x;
}

int crt_shape_start(const struct crt_shape *shape, int at)
{
    int64_t edge = shape->edge + shape->step * (at - shape->a0);
    return (int)((edge + INT64_C(0xffffffff)) >> 32);
}

/* Chunks of a row `reach` cells to both sides of its centre, of which `last` is the last to start
 * at. */
static void row_width(struct crt_shape *s, double reach, int cols)
{
    double width = floor(2 * reach) + 1;
    s->count = (int)fmin(ceil(width / 8), cols / 8);
    s->last = cols - 8 * s->count;
    s->narrow = width <= 8 * s->count - 4;
}

static bool dot_init(struct crt_shape *s, const struct crt_stretch *t, double length, double ux,
                     double uy, int cols, int rows)
{
    double x = (t->x0 + t->x1) / 2, y = (t->y0 + t->y1) / 2;
    double along = sqrt(t->sigma * t->sigma + length * length / 12), reach = CRT_CUT * along;
    if (x + reach < 0 || x - reach > cols - 1)
        return false;
    s->walk = CRT_WALK_DOT;
    s->r0 = clamp_int(ceil(y - reach), 0, rows);
    s->r1 = clamp_int(floor(y + reach) + 1, 0, rows);
    s->a0 = s->mid0 = s->mid1 = s->r0;
    s->a1 = s->r1;
    s->edge = (int64_t)floor((x - reach) * FIXED);
    s->step = 0;
    s->half = (float)reach;
    row_width(s, reach, cols);
    s->along_col = ux / along;
    s->along_row = uy / along;
    s->along_0 = -(x * ux + y * uy) / along;
    s->side_col = -uy / t->sigma;
    s->side_row = ux / t->sigma;
    s->side_0 = (x * uy - y * ux) / t->sigma;
    s->along_step = (float)s->along_col;
    s->ramp_scale = (float)(length / t->sigma / 6);
    s->ramp_0 = 0;
    s->area = CRT_DOT_AREA * t->sigma * along;
    return s->r0 < s->r1;
}

/* Walk index range [lo, hi] of the footprint, and of its part without caps, as real numbers. */
static void line_ends(struct crt_shape *s, double start, double end, double reach, double unit,
                      int limit)
{
    s->a0 = clamp_int(floor((start - reach) / unit), 0, limit);
    s->a1 = clamp_int(floor((end + reach) / unit) + 1, 0, limit);
    double last = unit - 1;
    int mid0 = clamp_int(ceil((start + reach) / unit), s->a0, s->a1);
    int mid1 = clamp_int(floor((end - reach - last) / unit) + 1, s->a0, s->a1);
    s->whole = ceil((start + reach) / unit) >= floor((end - reach - last) / unit) + 1;
    s->mid0 = s->whole ? s->a1 : mid0;
    s->mid1 = s->whole ? s->a1 : mid1;
}

static bool line_init(struct crt_shape *s, const struct crt_stretch *t, double length, double ux,
                      double uy, int cols, int rows)
{
    double cut = CRT_CUT * t->sigma, reach = cut * (fabs(ux) + fabs(uy));
    double left = fmin(t->x0, t->x1) - reach, right = fmax(t->x0, t->x1) + reach;
    if (right < 0 || left > cols - 1)
        return false;
    s->r0 = clamp_int(ceil(fmin(t->y0, t->y1) - reach), 0, rows);
    s->r1 = clamp_int(floor(fmax(t->y0, t->y1) + reach) + 1, 0, rows);
    if (s->r0 >= s->r1)
        return false;
    bool steep = fabs(uy) > fabs(ux);
    s->walk = steep ? CRT_WALK_ROWS : CRT_WALK_COLUMNS;
    if (steep) {
        double slope = ux / uy, half = cut / fabs(uy);
        line_ends(s, t->y0, t->y1, reach, 1, rows);
        row_width(s, half, cols);
        s->edge = (int64_t)floor((t->x0 + (s->a0 - t->y0) * slope - half) * FIXED);
        s->step = (int64_t)floor(slope * FIXED + 0.5);
        s->half = (float)half;
        s->cross = (float)(fabs(uy) / t->sigma / CRT_CROSS_UNIT);
        s->slant = 0;
        s->r0 = s->a0;
        s->r1 = s->a1;
    } else {
        double slope = uy / ux, half = cut / fabs(ux) + 3.5 * fabs(slope);
        line_ends(s, t->x0, t->x1, reach, 8, cols / 8);
        s->count = (int)floor(2 * half) + 1;
        s->edge = (int64_t)floor((t->y0 + (8 * s->a0 + 3.5 - t->x0) * slope - half) * FIXED);
        s->step = (int64_t)floor(8 * slope * FIXED + 0.5);
        s->half = (float)half;
        s->cross = (float)(fabs(ux) / t->sigma / CRT_CROSS_UNIT);
        s->slant = (float)(-slope * fabs(ux) / t->sigma / CRT_CROSS_UNIT);
    }
    s->along_col = ux / t->sigma;
    s->along_row = uy / t->sigma;
    s->along_0 = -(t->x0 * ux + t->y0 * uy) / t->sigma;
    s->along_step = (float)s->along_col;
    s->length = (float)(length / t->sigma);
    s->rest_start = (float)(t->rest0 * length / t->sigma);
    s->rest_end = (float)(t->rest1 * length / t->sigma);
    s->rested = s->rest_start != 0 || s->rest_end != 0;
    s->ramp_scale = (float)(2 * t->sigma / length);
    s->ramp_0 = -1;
    s->area = CRT_LINE_AREA * t->sigma * length;
    return s->a0 < s->a1 && s->r0 < s->r1;
}

bool crt_shape_init(struct crt_shape *shape, const struct crt_stretch *stretch, int cols, int rows)
{
    struct crt_stretch t = *stretch;
    double dx = t.x1 - t.x0, dy = t.y1 - t.y0, length = sqrt(dx * dx + dy * dy);
    *shape = (struct crt_shape){0};
    if (length < SHORT * t.sigma) {
        double ux = length > 0 ? dx / length : 1, uy = length > 0 ? dy / length : 0;
        return dot_init(shape, &t, length, ux, uy, cols, rows);
    }
    if (fabs(dy) > fabs(dx) ? dy < 0 : dx < 0) {
        t = (struct crt_stretch){t.x1, t.y1, t.x0, t.y0, t.sigma, t.rest1, t.rest0};
        dx = -dx;
        dy = -dy;
        shape->turned = true;
    }
    return line_init(shape, &t, length, dx / length, dy / length, cols, rows);
}

size_t crt_part_chunks(const struct crt_shape *shape, struct crt_part part)
{
    int lo = part.laid_out_whole ? shape->r0 : part.lo,
        hi = part.laid_out_whole ? shape->r1 : part.hi;
    if (shape->walk != CRT_WALK_COLUMNS)
        return (size_t)(hi - lo) * (size_t)shape->count;
    int rows = part.laid_out_whole || shape->count < hi - lo ? shape->count : hi - lo;
    return (size_t)(shape->a1 - shape->a0) * (size_t)rows;
}

const struct crt_kernels *crt_kernels_find(enum crt_simd simd, struct crt_error *err)
{
#if defined(__x86_64__)
    bool avx2 = __builtin_cpu_supports("avx2");
    if (avx2 && simd != CRT_SIMD_BASELINE)
        return &crt_kernels_avx2;
#endif
    if (simd == CRT_SIMD_AVX2) {
        crt_fail(err, "this processor has no AVX2 instructions; leave the choice to the program");
        return NULL;
    }
    return &crt_kernels_baseline;
}
