/* check_curves — properties of the curves (roms/curves), on random cases in the machine; a line
 * each. */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/curves/b_spline.h"
#include "roms/curves/bezier_patch.h"
#include "roms/curves/bezier_run.h"
#include "roms/curves/casteljau.h"
#include "roms/curves/spline.h"

static uint32_t random_state = 7;
static bool all = true;

static struct vector3 casteljau_point(const struct vector3 *points, int count, float u)
{
    struct casteljau c;
    casteljau_begin(&c, points, count, u);
    while (casteljau_next(&c))
        continue;
    return casteljau_at(&c, count - 1, 0);
}

static uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

static float random_in(float low, float high)
{
    return low + (high - low) * (float)random_below(1 << 16) / (1 << 16);
}

static void random_points(struct vector3 *p, int count)
{
    for (int i = 0; i < count; i++)
        p[i] = (struct vector3){random_in(-100, 100), random_in(-100, 100), random_in(-100, 100)};
}

static float apart(struct vector3 a, struct vector3 b)
{
    return vector3_length(vector3_difference(a, b));
}

/* Prints how far it was off, and whether that is within the limit. */
static void report(int cases, const char *what, float worst, float limit)
{
    bool holds = worst <= limit;
    printf("%d %s: at most %.6f off%s\n", cases, what, (double)worst, holds ? "" : ": TOO MUCH");
    all = all && holds;
}

static void points_both_ways(void)
{
    enum { CASES = 1000 };
    struct vector3 p[BEZIER_POINTS_MOST];
    float value[BEZIER_POINTS_MOST], worst = 0, sums = 0;
    for (int i = 0; i < CASES; i++) {
        int count = 2 + (int)random_below(BEZIER_POINTS_MOST - 1);
        float u = random_in(0, 1), sum = 0;
        random_points(p, count);
        worst = fmaxf(worst, apart(bezier_point(p, count, u), casteljau_point(p, count, u)));
        bezier_blending(count - 1, u, value);
        for (int k = 0; k < count; k++)
            sum += value[k];
        sums = fmaxf(sums, fabsf(sum - 1));
    }
    report(CASES, "sums of blending functions: 1", sums, 4e-6f);
    report(CASES, "points by blending and by de Casteljau: the same", worst, 4e-4f);
}

static void halves(void)
{
    enum { CASES = 500 };
    struct vector3 p[8], left[8], right[8];
    float worst = 0;
    for (int i = 0; i < CASES; i++) {
        struct casteljau c;
        int count = 2 + (int)random_below(7);
        float u = random_in(0, 1), cut = random_in(0, 1);
        random_points(p, count);
        casteljau_begin(&c, p, count, cut);
        while (casteljau_next(&c))
            continue;
        casteljau_halves(&c, left, right);
        worst = fmaxf(worst, apart(left[count - 1], right[0]));
        worst = fmaxf(worst,
                      apart(casteljau_point(left, count, u), casteljau_point(p, count, u * cut)));
        worst = fmaxf(worst, apart(casteljau_point(right, count, u),
                                   casteljau_point(p, count, cut + u * (1 - cut))));
    }
    report(CASES, "curves cut in two: the same curve", worst, 4e-4f);
}

/* The farthest outside of the points' extent along a direction. */
static void hulls(void)
{
    enum { CASES = 1000 };
    struct vector3 p[8];
    float worst = 0;
    for (int i = 0; i < CASES; i++) {
        float angle = random_in(0, 6.28f), low = 1e9f, high = -1e9f;
        struct vector3 direction = {cosf(angle), sinf(angle), 0};
        random_points(p, 8);
        for (int k = 0; k < 8; k++) {
            low = fminf(low, vector3_dot(direction, p[k]));
            high = fmaxf(high, vector3_dot(direction, p[k]));
        }
        float at = vector3_dot(direction, bezier_point(p, 8, random_in(0, 1)));
        worst = fmaxf(worst, fmaxf(low - at, at - high));
    }
    report(CASES, "points: within the convex hull", worst, 1e-4f);
}

static void three_ways(void)
{
    enum { CASES = 2000 };
    float worst = 0;
    for (int i = 0; i < CASES; i++) {
        struct cubic_geometry g = {.kind = (enum cubic_kind)(i % CUBIC_KINDS),
                                   .tension = random_in(-1, 1)};
        float u = random_in(0, 1);
        random_points(g.g, 4);
        struct cubic solved = cubic_by_conditions(&g), product = cubic_by_matrix(&g);
        struct vector3 a = cubic_point(&solved, u), b = cubic_point(&product, u);
        worst = fmaxf(worst, fmaxf(apart(a, b), apart(b, cubic_by_blending(&g, u))));
    }
    report(CASES, "cubics by conditions, matrix and blending: the same", worst,
           CUBIC_WAYS_TOLERANCE * 2 * 173);
}

/* The largest difference of an n-th derivative at inner joins, as a part of its size. */
static float jump(const struct spline *s, int n)
{
    float worst = 0;
    for (int i = 0; i + 1 < s->pieces; i++) {
        struct join j = spline_join(s, i);
        float size = 1 + vector3_length(j.p[n]) + vector3_length(j.q[n]);
        if (n == 0) /* what the coefficients cancel from */
            size += vector3_length(j.p[1]) * (s->knot[i + 2] - s->knot[i]);
        worst = fmaxf(worst, apart(j.p[n], j.q[n]) / size);
    }
    return worst;
}

static void splines(void)
{
    enum { CASES = 300 };
    struct vector3 p[12];
    struct spline s;
    float places = 0, first = 0, second = 0, ends = 0, slopes = 0;
    for (int i = 0; i < CASES; i++) {
        int count = 4 + (int)random_below(9);
        enum spline_parameter parameter = (enum spline_parameter)random_below(3);
        random_points(p, count);
        for (int kind = 0; kind < 4; kind++) {
            bool made = kind == 0   ? spline_natural(p, count, parameter, &s)
                        : kind == 1 ? spline_clamped(p, count, parameter, p[1], p[2], &s)
                        : kind == 2 ? spline_b_spline(p, count, &s)
                                    : spline_cardinal(p, count, random_in(-1, 1), &s);
            all = all && made;
            places = fmaxf(places, jump(&s, 0));
            first = fmaxf(first, jump(&s, 1));
            if (kind < 3)
                second = fmaxf(second, jump(&s, 2));
            struct cubic q = cubic_by_matrix(&s.piece[0]);
            float h = s.knot[1];
            if (kind == 0)
                ends = fmaxf(ends, vector3_length(cubic_derivative(&q, 2, 0)));
            if (kind == 1)
                slopes =
                    fmaxf(slopes, apart(vector3_times(cubic_derivative(&q, 1, 0), 1 / h), p[1]));
            for (int k = 0; kind < 2 && k < count; k++)
                places = fmaxf(places, apart(spline_point(&s, s.knot[k]), p[k]) / 1000);
        }
    }
    report(4 * CASES, "splines: joined, and through their points", places, 1e-5f);
    report(4 * CASES, "splines: C1", first, 1e-4f);
    report(3 * CASES, "natural, clamped and B-splines: C2", second, 2e-3f);
    report(CASES, "natural splines: p\" = 0 at the end", ends, 0.02f);
    report(CASES, "clamped splines: p' as given", slopes, 0.002f);
}

static void b_splines(void)
{
    enum { CASES = 500 };
    float worst = 0, sums = 0;
    for (int i = 0; i < CASES; i++) {
        struct b_spline s = {.degree = 1 + (int)random_below(B_SPLINE_DEGREE_MOST)};
        float value[B_SPLINE_POINTS_MOST], sum = 0;
        struct vector3 at = {0, 0, 0};
        s.count = s.degree + 1 + (int)random_below(8);
        random_points(s.point, s.count);
        if (i % 2 == 0)
            b_spline_open(&s);
        else
            b_spline_uniform(&s);
        float t = random_in(b_spline_start(&s), b_spline_end(&s));
        b_spline_basis(&s, t, value);
        for (int k = 0; k < s.count; k++) {
            at = vector3_sum(at, vector3_times(s.point[k], value[k]));
            sum += value[k];
        }
        sums = fmaxf(sums, fabsf(sum - 1));
        worst = fmaxf(worst, apart(at, b_spline_point(&s, t)));
    }
    report(CASES, "sums of B-spline bases: 1", sums, 1e-5f);
    report(CASES, "B-splines by their basis and by de Boor: the same", worst, 1e-3f);
}

static void joins(void)
{
    enum { CASES = 1000 };
    int wrong = 0;
    for (int i = 0; i < CASES; i++) {
        struct vector3 p[3], q[3];
        random_points(p, 3);
        float k = random_in(1.2f, 3), m = random_in(-2, 2);
        struct vector3 cross = vector3_cross(p[1], p[2]);
        if (vector3_length(cross) < 100)
            continue;
        q[0] = p[0];
        q[1] = vector3_times(p[1], k);
        q[2] = vector3_sum(vector3_times(p[2], k * k), vector3_times(p[1], m));
        struct join j = {{p[0], p[1], p[2]}, {q[0], q[1], q[2]}};
        struct continuity c = continuity_of(&j);
        wrong += !(c.c0 && !c.c1 && !c.c2 && c.g1 && c.g2);
        j.q[1] = vector3_times(p[1], -k);
        wrong += continuity_of(&j).g1;
        j.q[1] = p[1];
        j.q[2] = p[2];
        wrong += !continuity_of(&j).c2;
        j.q[2] = vector3_sum(p[2], vector3_times(vector3_direction(cross), 5));
        c = continuity_of(&j);
        wrong += c.c2 || c.g2 || !c.c1;
    }
    printf("%d joins made C0 and G2, backward, C2, and C1: %d wrong verdicts\n", CASES, wrong);
    all = all && wrong == 0;
}

/* Normals against chords of the surface. */
static void patches(void)
{
    enum { CASES = 200 };
    float worst = 0;
    for (int i = 0; i < CASES; i++) {
        struct bezier_patch patch;
        float u = random_in(0, 0.99f), v = random_in(0, 0.99f), h = 0.005f;
        for (int k = 0; k < 16; k++)
            patch.at[k / 4][k % 4] =
                (struct vector3){(float)(k % 4), (float)(k / 4), random_in(0, 1)};
        struct vector3 n = bezier_patch_normal(&patch, u, v), p = bezier_patch_point(&patch, u, v);
        struct vector3 du = vector3_difference(bezier_patch_point(&patch, u + h, v), p);
        struct vector3 dv = vector3_difference(bezier_patch_point(&patch, u, v + h), p);
        worst = fmaxf(worst, fabsf(vector3_dot(n, vector3_direction(du))));
        worst = fmaxf(worst, fabsf(vector3_dot(n, vector3_direction(dv))));
    }
    report(CASES, "normals of patches: perpendicular", worst, 0.02f);
}

static float from_chord(struct vector3 p, struct vector3 a, struct vector3 b)
{
    struct vector3 d = vector3_difference(b, a), to = vector3_difference(p, a);
    float square = vector3_dot(d, d);
    float t = square > 0 ? fminf(fmaxf(vector3_dot(d, to) / square, 0), 1) : 0;
    return apart(to, vector3_times(d, t));
}

/* The middle of each line of a run, looked for along the whole curve. */
static void runs(void)
{
    enum { CASES = 12, PLACES = 64 };
    static struct vector3 line[1 << BEZIER_RUN_DEPTH];
    float worst = 0;
    for (int i = 0; i < CASES; i++) {
        struct vector3 p[4];
        struct bezier_run run;
        int count = 0;
        random_points(p, 4);
        bezier_run_begin(&run, p, 4, 0.5f);
        while (bezier_run_next(&run, &line[count]))
            count++;
        for (int k = 0; k <= PLACES; k++) {
            struct vector3 at = bezier_point(p, 4, (float)k / PLACES);
            float nearest = 1e9f;
            for (int n = 1; n < count; n++)
                nearest = fminf(nearest, from_chord(at, line[n - 1], line[n]));
            worst = fmaxf(worst, nearest);
        }
    }
    report(CASES * (PLACES + 1), "places of curves drawn with lines: within 0.5", worst, 0.5f);
}

int main(void)
{
    points_both_ways();
    halves();
    hulls();
    three_ways();
    splines();
    b_splines();
    joins();
    patches();
    runs();
    board_exit(all ? 0 : 1);
}
