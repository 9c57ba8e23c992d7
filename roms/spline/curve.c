/* curve.c — points, derivatives, joints, length. */
#include "roms/spline/curve.h"

#include "roms/geometry/scalar.h"

const struct vector3 *curve_piece(const struct curve *c, int piece)
{
    return c->control + piece * c->order;
}

float curve_t(const struct curve *c, float part)
{
    return c->knot[0] + part * (c->knot[c->pieces] - c->knot[0]);
}

/* ---- points -------------------------------------------------------------------------------------- */

static struct vector3 second_of(const struct vector3 *p, int count, float u)
{
    struct vector3 slope[BEZIER_POINTS_MOST];
    for (int i = 0; i + 1 < count; i++)
        slope[i] = vector3_times(vector3_difference(p[i + 1], p[i]), (float)(count - 1));
    return bezier_derivative(slope, count - 1, u);
}

static float curvature_of(struct vector3 first, struct vector3 second)
{
    float length = vector3_length(first);
    float cubed = length * length * length;
    return cubed > 1e-12f ? (first.x * second.y - first.y * second.x) / cubed : 0;
}

static struct curve_place place_in(const struct curve *c, int piece, float u)
{
    const struct vector3 *p = curve_piece(c, piece);
    float h = c->knot[piece + 1] - c->knot[piece];
    struct curve_place place = {.piece = piece, .u = u};
    place.at = bezier_point(p, c->order, u);
    place.first = vector3_times(bezier_derivative(p, c->order, u), 1 / h);
    place.second = vector3_times(second_of(p, c->order, u), 1 / (h * h));
    place.curvature = curvature_of(place.first, place.second);
    return place;
}

static int piece_of(const struct curve *c, float t)
{
    int i = 0;
    while (i + 1 < c->pieces && t >= c->knot[i + 1])
        i++;
    return i;
}

static float u_of(const struct curve *c, int piece, float t)
{
    float h = c->knot[piece + 1] - c->knot[piece];
    return scalar_min(scalar_max((t - c->knot[piece]) / h, 0), 1);
}

struct curve_place curve_at(const struct curve *c, float t)
{
    int piece = piece_of(c, t);
    return place_in(c, piece, u_of(c, piece, t));
}

static struct vector3 point_at(const struct curve *c, float part)
{
    float t = curve_t(c, part);
    int piece = piece_of(c, t);
    return bezier_point(curve_piece(c, piece), c->order, u_of(c, piece, t));
}

/* ---- joints -------------------------------------------------------------------------------------- */

int curve_joints(const struct curve *c)
{
    return c->closed ? c->pieces : c->pieces - 1;
}

struct join curve_join(const struct curve *c, int joint)
{
    struct curve_place p = place_in(c, joint, 1), q = place_in(c, (joint + 1) % c->pieces, 0);
    return (struct join){.p = {p.at, p.first, p.second}, .q = {q.at, q.first, q.second}};
}

/* ---- measures ------------------------------------------------------------------------------------ */

static int samples_of(const struct curve *c)
{
    return c->pieces > 1 ? 12 * c->pieces : 64;
}

static float distance_at(const struct curve *c, float part, struct vector3 place)
{
    return vector3_length(vector3_difference(point_at(c, part), place));
}

/* From a sample on, in steps that shrink. */
static float refine(const struct curve *c, struct vector3 place, float part, float step,
                    float *least)
{
    for (int i = 0; i < 12; i++) {
        step /= 2;
        for (int side = -1; side <= 1; side += 2) {
            float to = scalar_min(scalar_max(part + (float)side * step, 0), 1);
            float d = distance_at(c, to, place);
            part = d < *least ? to : part;
            *least = scalar_min(d, *least);
        }
    }
    return part;
}

/* Samples that are nearer than their neighbours: the nearest place is beside one of them. */
float curve_nearest(const struct curve *c, struct vector3 place, float *distance)
{
    int samples = samples_of(c);
    float step = 1 / (float)samples, best = 0, before = 1e9f, here = distance_at(c, 0, place);
    *distance = here;
    for (int i = 0; i <= samples; i++) {
        float after = i < samples ? distance_at(c, (float)(i + 1) * step, place) : 1e9f;
        float least = here;
        if (here <= before && here <= after) {
            float part = refine(c, place, (float)i * step, step, &least);
            best = least <= *distance ? part : best;
            *distance = scalar_min(least, *distance);
        }
        before = here;
        here = after;
    }
    return best;
}

float curve_length(const struct curve *c)
{
    float sum = 0;
    int steps = c->pieces > 1 ? 8 : 48; /* even */
    for (int i = 0; i < c->pieces; i++)
        for (int k = 0; k <= steps; k++) {
            float weight = k == 0 || k == steps ? 1.0f : k % 2 ? 4.0f : 2.0f;
            struct vector3 d =
                bezier_derivative(curve_piece(c, i), c->order, (float)k / (float)steps);
            sum += weight * vector3_length(d) / (3 * (float)steps);
        }
    return sum;
}
