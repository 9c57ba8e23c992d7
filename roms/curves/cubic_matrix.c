/* cubic_matrix.c — coefficients as characterising matrix times geometry. */
#include "roms/curves/cubic_kind.h"

struct matrix4 cubic_matrix(enum cubic_kind kind, float tension)
{
    static const struct matrix4 hermite = {
        {{2, -2, 1, 1}, {-3, 3, -2, -1}, {0, 0, 1, 0}, {1, 0, 0, 0}}};
    static const struct matrix4 bezier = {
        {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}};
    static const struct matrix4 b_spline = {{{-1 / 6.0f, 3 / 6.0f, -3 / 6.0f, 1 / 6.0f},
                                             {3 / 6.0f, -6 / 6.0f, 3 / 6.0f, 0},
                                             {-3 / 6.0f, 0, 3 / 6.0f, 0},
                                             {1 / 6.0f, 4 / 6.0f, 1 / 6.0f, 0}}};
    float s = (1 - tension) / 2;
    switch (kind) {
    case CUBIC_BEZIER:
        return bezier;
    case CUBIC_CARDINAL:
        return (struct matrix4){
            {{-s, 2 - s, s - 2, s}, {2 * s, s - 3, 3 - 2 * s, -s}, {-s, 0, s, 0}, {0, 1, 0, 0}}};
    case CUBIC_B_SPLINE:
        return b_spline;
    default:
        return hermite;
    }
}

static struct vector3 row_times_geometry(const float row[4], const struct vector3 g[4])
{
    struct vector3 low = vector3_sum(vector3_times(g[0], row[0]), vector3_times(g[1], row[1]));
    struct vector3 high = vector3_sum(vector3_times(g[2], row[2]), vector3_times(g[3], row[3]));
    return vector3_sum(low, high);
}

struct cubic cubic_by_matrix(const struct cubic_geometry *geometry)
{
    struct matrix4 m = cubic_matrix(geometry->kind, geometry->tension);
    return (struct cubic){
        row_times_geometry(m.at[0], geometry->g), row_times_geometry(m.at[1], geometry->g),
        row_times_geometry(m.at[2], geometry->g), row_times_geometry(m.at[3], geometry->g)};
}
