#include "roms/curves/spline.h"

#include "roms/curves/tridiagonal.h"

/* Knots of `count` points. */
static bool place_knots(const struct vector3 *p, int count, enum spline_parameter parameter,
                        struct spline *out)
{
    if (count < 2 || count > SPLINE_POINTS_MOST)
        return false;
    out->pieces = count - 1;
    out->knot[0] = 0;
    for (int i = 1; i < count; i++) {
        float h = vector3_length(vector3_difference(p[i], p[i - 1]));
        h = parameter == SPLINE_UNIFORM ? 1 : parameter == SPLINE_CHORDAL ? h : sqrtf(h);
        out->knot[i] = out->knot[i - 1] + h;
        if (!(out->knot[i] > out->knot[i - 1]))
            return false;
    }
    return true;
}

static float length_of(const struct spline *s, int piece)
{
    return s->knot[piece + 1] - s->knot[piece];
}

/* (p_i+1 − p_i) · factor. */
static struct vector3 chord(const struct vector3 *p, int i, float factor)
{
    return vector3_times(vector3_difference(p[i + 1], p[i]), factor);
}

/* Slopes with which p″ is the same on both sides of each inner point. The first and the last
 * row are the caller's: b, c, slope at 0 and a, b, slope at the end. */
static void solve_slopes(const struct spline *s, const struct vector3 *p, float *a, float *b,
                         float *c, struct vector3 *slope)
{
    for (int i = 1; i < s->pieces; i++) {
        float before = length_of(s, i - 1), after = length_of(s, i);
        a[i] = after;
        b[i] = 2 * (before + after);
        c[i] = before;
        slope[i] =
            vector3_sum(chord(p, i - 1, 3 * after / before), chord(p, i, 3 * before / after));
    }
    tridiagonal_solve(a, b, c, slope, s->pieces + 1);
}

static void hermite_pieces(const struct vector3 *p, const struct vector3 *slope, struct spline *s)
{
    for (int i = 0; i < s->pieces; i++) {
        float h = length_of(s, i);
        s->piece[i] = (struct cubic_geometry){
            .kind = CUBIC_HERMITE,
            .g = {p[i], p[i + 1], vector3_times(slope[i], h), vector3_times(slope[i + 1], h)}};
    }
}

bool spline_natural(const struct vector3 *p, int count, enum spline_parameter parameter,
                    struct spline *out)
{
    float a[SPLINE_POINTS_MOST], b[SPLINE_POINTS_MOST], c[SPLINE_POINTS_MOST];
    struct vector3 slope[SPLINE_POINTS_MOST];
    if (!place_knots(p, count, parameter, out))
        return false;
    int n = count - 1;
    b[0] = b[n] = 2;
    c[0] = a[n] = 1;
    slope[0] = chord(p, 0, 3 / length_of(out, 0));
    slope[n] = chord(p, n - 1, 3 / length_of(out, n - 1));
    solve_slopes(out, p, a, b, c, slope);
    hermite_pieces(p, slope, out);
    return true;
}

bool spline_clamped(const struct vector3 *p, int count, enum spline_parameter parameter,
                    struct vector3 slope0, struct vector3 slope1, struct spline *out)
{
    float a[SPLINE_POINTS_MOST], b[SPLINE_POINTS_MOST], c[SPLINE_POINTS_MOST];
    struct vector3 slope[SPLINE_POINTS_MOST];
    if (!place_knots(p, count, parameter, out))
        return false;
    int n = count - 1;
    b[0] = b[n] = 1;
    c[0] = a[n] = 0;
    slope[0] = slope0;
    slope[n] = slope1;
    solve_slopes(out, p, a, b, c, slope);
    hermite_pieces(p, slope, out);
    return true;
}

bool spline_hermite(const struct vector3 *p, const struct vector3 *slopes, int count,
                    struct spline *out)
{
    if (!place_knots(p, count, SPLINE_UNIFORM, out))
        return false;
    hermite_pieces(p, slopes, out);
    return true;
}

/* Pieces of four points each, `apart` points from one to the next. */
static bool four_point_pieces(const struct vector3 *p, int count, int apart,
                              struct cubic_geometry form, struct spline *out)
{
    if (count < 4 || count > SPLINE_POINTS_MOST || (count - 4) % apart != 0)
        return false;
    out->pieces = (count - 4) / apart + 1;
    out->knot[0] = 0;
    for (int i = 0; i < out->pieces; i++) {
        out->knot[i + 1] = (float)(i + 1);
        out->piece[i] = form;
        for (int k = 0; k < 4; k++)
            out->piece[i].g[k] = p[i * apart + k];
    }
    return true;
}

bool spline_cardinal(const struct vector3 *p, int count, float tension, struct spline *out)
{
    struct cubic_geometry form = {.kind = CUBIC_CARDINAL, .tension = tension};
    return four_point_pieces(p, count, 1, form, out);
}

bool spline_b_spline(const struct vector3 *p, int count, struct spline *out)
{
    return four_point_pieces(p, count, 1, (struct cubic_geometry){.kind = CUBIC_B_SPLINE}, out);
}

bool spline_bezier(const struct vector3 *p, int count, struct spline *out)
{
    return four_point_pieces(p, count, 3, (struct cubic_geometry){.kind = CUBIC_BEZIER}, out);
}

struct vector3 spline_point(const struct spline *s, float t)
{
    int i = 0;
    while (i + 1 < s->pieces && t >= s->knot[i + 1])
        i++;
    return cubic_by_blending(&s->piece[i], (t - s->knot[i]) / length_of(s, i));
}

struct join spline_join(const struct spline *s, int piece)
{
    struct cubic before = cubic_by_matrix(&s->piece[piece]);
    struct cubic after = cubic_by_matrix(&s->piece[piece + 1]);
    float p = 1 / length_of(s, piece), q = 1 / length_of(s, piece + 1);
    return (struct join){
        .p = {cubic_point(&before, 1), vector3_times(cubic_derivative(&before, 1, 1), p),
              vector3_times(cubic_derivative(&before, 2, 1), p * p)},
        .q = {cubic_point(&after, 0), vector3_times(cubic_derivative(&after, 1, 0), q),
              vector3_times(cubic_derivative(&after, 2, 0), q * q)}};
}
