/* cubic_conditions.c — coefficients from what must hold at the ends: elimination, largest pivot. */
#include "roms/curves/cubic_kind.h"

/* factor · (to − from). */
static struct vector3 slope_of(struct vector3 from, struct vector3 to, float factor)
{
    return vector3_times(vector3_difference(to, from), factor);
}

/* (before + 4 at + after) / 6. */
static struct vector3 average_of(struct vector3 before, struct vector3 at, struct vector3 after)
{
    struct vector3 sum = vector3_sum(vector3_sum(before, after), vector3_times(at, 4));
    return vector3_times(sum, 1 / 6.0f);
}

struct cubic_conditions cubic_conditions(const struct cubic_geometry *geometry)
{
    const struct vector3 *g = geometry->g;
    struct cubic_conditions c = {
        .row = {{0, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 1, 0}, {3, 2, 1, 0}},
        .value = {g[0], g[1], g[2], g[3]},
    };
    float s = geometry->kind == CUBIC_CARDINAL ? (1 - geometry->tension) / 2 : 0.5f;
    switch (geometry->kind) {
    case CUBIC_BEZIER:
        c.value[1] = g[3];
        c.value[2] = slope_of(g[0], g[1], 3);
        c.value[3] = slope_of(g[2], g[3], 3);
        break;
    case CUBIC_CARDINAL:
    case CUBIC_B_SPLINE:
        c.value[0] = geometry->kind == CUBIC_CARDINAL ? g[1] : average_of(g[0], g[1], g[2]);
        c.value[1] = geometry->kind == CUBIC_CARDINAL ? g[2] : average_of(g[1], g[2], g[3]);
        c.value[2] = slope_of(g[0], g[2], s);
        c.value[3] = slope_of(g[1], g[3], s);
        break;
    default:
        break;
    }
    return c;
}

static void exchange_conditions(struct cubic_conditions *c, int i, int k)
{
    for (int n = 0; n < 4; n++) {
        float t = c->row[i][n];
        c->row[i][n] = c->row[k][n];
        c->row[k][n] = t;
    }
    struct vector3 t = c->value[i];
    c->value[i] = c->value[k];
    c->value[k] = t;
}

static int pivot_of(const struct cubic_conditions *c, int column)
{
    int pivot = column;
    for (int r = column + 1; r < 4; r++)
        if (fabsf(c->row[r][column]) > fabsf(c->row[pivot][column]))
            pivot = r;
    return pivot;
}

struct cubic cubic_by_conditions(const struct cubic_geometry *geometry)
{
    struct cubic_conditions c = cubic_conditions(geometry);
    for (int n = 0; n < 4; n++) {
        exchange_conditions(&c, n, pivot_of(&c, n));
        for (int r = n + 1; r < 4; r++) {
            float factor = c.row[r][n] / c.row[n][n];
            for (int k = n; k < 4; k++)
                c.row[r][k] -= factor * c.row[n][k];
            c.value[r] = vector3_difference(c.value[r], vector3_times(c.value[n], factor));
        }
    }
    struct vector3 x[4];
    for (int n = 3; n >= 0; n--) {
        x[n] = c.value[n];
        for (int k = n + 1; k < 4; k++)
            x[n] = vector3_difference(x[n], vector3_times(x[k], c.row[n][k]));
        x[n] = vector3_times(x[n], 1 / c.row[n][n]);
    }
    return (struct cubic){x[0], x[1], x[2], x[3]};
}
