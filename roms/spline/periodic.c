#include "roms/spline/periodic.h"

#include "roms/curves/tridiagonal.h"

/* Rows of the cyclic system: a m_i−1 + b m_i + c m_i+1 = r. */
struct periodic_rows {
    float a[SPLINE_PIECES_MOST], b[SPLINE_PIECES_MOST], c[SPLINE_PIECES_MOST];
    struct vector3 r[SPLINE_PIECES_MOST];
    int count;
};

static float gap(struct vector3 a, struct vector3 b, enum spline_parameter parameter)
{
    float length = parameter == SPLINE_UNIFORM ? 1 : vector3_length(vector3_difference(b, a));
    return parameter == SPLINE_CENTRIPETAL ? sqrtf(length) : length;
}

static bool place_ring(const struct vector3 *p, int count, enum spline_parameter parameter,
                       struct spline *s)
{
    if (count < 3 || count > SPLINE_PIECES_MOST)
        return false;
    s->pieces = count;
    s->knot[0] = 0;
    for (int i = 0; i < count; i++) {
        float h = gap(p[i], p[(i + 1) % count], parameter);
        s->knot[i + 1] = s->knot[i] + h;
        if (!(s->knot[i + 1] > s->knot[i]))
            return false;
    }
    return true;
}

static void set_up(const struct vector3 *p, const struct spline *s, struct periodic_rows *rows)
{
    int n = rows->count = s->pieces;
    for (int i = 0; i < n; i++) {
        int j = (i + n - 1) % n;
        float before = s->knot[j + 1] - s->knot[j], after = s->knot[i + 1] - s->knot[i];
        struct vector3 back = vector3_difference(p[i], p[j]),
                       on = vector3_difference(p[(i + 1) % n], p[i]);
        rows->a[i] = after;
        rows->b[i] = 2 * (before + after);
        rows->c[i] = before;
        rows->r[i] = vector3_sum(vector3_times(back, 3 * after / before),
                                 vector3_times(on, 3 * before / after));
    }
}

/* The corners a[0] and c[n−1] are the product of two vectors (g 0 … c) and (1 0 … a/g), taken out of
 * the matrix with g = −b[0], and brought in again behind. */
static void solve_cyclic(struct periodic_rows *rows)
{
    int n = rows->count;
    float b[SPLINE_PIECES_MOST], a0 = rows->a[0], cn = rows->c[n - 1], g = -rows->b[0];
    struct vector3 w[SPLINE_PIECES_MOST] = {0}, *r = rows->r;
    rows->b[0] -= g;
    rows->b[n - 1] -= a0 * cn / g;
    for (int i = 0; i < n; i++)
        b[i] = rows->b[i];
    w[0].x = g;
    w[n - 1].x = cn;
    tridiagonal_solve(rows->a, rows->b, rows->c, r, n);
    tridiagonal_solve(rows->a, b, rows->c, w, n);
    struct vector3 along = vector3_sum(r[0], vector3_times(r[n - 1], a0 / g));
    float under = 1 + w[0].x + w[n - 1].x * a0 / g;
    for (int i = 0; i < n; i++)
        r[i] = vector3_difference(r[i], vector3_times(along, w[i].x / under));
}

bool periodic_spline(const struct vector3 *p, int count, enum spline_parameter parameter,
                     struct spline *out)
{
    struct periodic_rows rows = {0};
    if (!place_ring(p, count, parameter, out))
        return false;
    set_up(p, out, &rows);
    solve_cyclic(&rows);
    for (int i = 0; i < count; i++) {
        int next = (i + 1) % count;
        float h = out->knot[i + 1] - out->knot[i];
        out->piece[i] = (struct cubic_geometry){
            .kind = CUBIC_HERMITE,
            .g = {p[i], p[next], vector3_times(rows.r[i], h), vector3_times(rows.r[next], h)}};
    }
    return true;
}
