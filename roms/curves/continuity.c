#include "roms/curves/continuity.h"

#include "roms/geometry/scalar.h"

static float distance_of(struct vector3 a, struct vector3 b)
{
    return vector3_length(vector3_difference(a, b));
}

/* Rounding of an n-th derivative that was computed from points so far from the origin. */
static float rounding(float distance, int order)
{
    static const float factor[] = {1, 6, 36};
    return 4 * 1.1920929e-7f * distance * factor[order];
}

static void parametric(const struct join *j, struct continuity *c)
{
    float length[3], distance = scalar_max(vector3_length(j->p[0]), vector3_length(j->q[0]));
    for (int n = 0; n < 3; n++) {
        length[n] = scalar_max(vector3_length(j->p[n]), vector3_length(j->q[n]));
        c->apart[n] = distance_of(j->q[n], j->p[n]);
        c->allowed[n] =
            CONTINUITY_TOLERANCE * length[n] + rounding(scalar_max(distance, length[1]), n);
    }
    c->allowed[0] = CONTINUITY_TOLERANCE * length[1] + rounding(distance, 0);
    c->c0 = c->apart[0] <= c->allowed[0];
    c->c1 = c->c0 && c->apart[1] <= c->allowed[1];
    c->c2 = c->c1 && c->apart[2] <= c->allowed[2];
}

/* A tangent so short beside everything else is none: dividing by it would say nothing. */
static bool no_direction(const struct join *j)
{
    float p = vector3_length(j->p[1]), q = vector3_length(j->q[1]), shorter = p < q ? p : q;
    float bend = scalar_max(vector3_length(j->p[2]), vector3_length(j->q[2]));
    float far = scalar_max(vector3_length(j->p[0]), vector3_length(j->q[0]));
    return shorter <= rounding(far, 1) || shorter <= CONTINUITY_SHORTEST * scalar_max(p, q) ||
           shorter <= CONTINUITY_SHORTEST * CONTINUITY_SHORTEST * bend || shorter < 1e-15f;
}

/* k by least squares, then what is left of q″ along p′. */
static void geometric(const struct join *j, struct continuity *c)
{
    c->g0 = c->c0;
    if (no_direction(j))
        return;
    float square = vector3_dot(j->p[1], j->p[1]);
    c->k = vector3_dot(j->q[1], j->p[1]) / square;
    c->off[1] = distance_of(j->q[1], vector3_times(j->p[1], c->k));
    c->off_allowed[1] = c->allowed[1];
    struct vector3 bent = vector3_times(j->p[2], c->k * c->k);
    struct vector3 rest = vector3_difference(j->q[2], bent);
    c->m = vector3_dot(rest, j->p[1]) / square;
    c->off[2] = distance_of(rest, vector3_times(j->p[1], c->m));
    c->off_allowed[2] =
        scalar_max(c->allowed[2], CONTINUITY_TOLERANCE *
                                      scalar_max(vector3_length(bent), vector3_length(j->q[2])));
    c->g1 = c->g0 && c->k > 0 && c->off[1] <= c->off_allowed[1];
    c->g2 = c->g1 && c->off[2] <= c->off_allowed[2];
}

struct continuity continuity_of(const struct join *join)
{
    struct continuity c = {0};
    parametric(join, &c);
    geometric(join, &c);
    return c;
}
