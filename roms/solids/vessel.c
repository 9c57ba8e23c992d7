/* vessel.c — a vessel with a lid, a handle and a spout, made of cubic Bézier curves: profiles that
 * are turned about y, paths that tubes follow. */
#include "roms/curves/bezier.h"
#include "roms/solids/models.h"

enum { PROFILE_POINTS = 3 * VESSEL_SEGMENTS / 4 + 2, TUBE_RINGS = 2 * VESSEL_SEGMENTS / 4 + 4 };

/* (r, y, 0), from below. */
static const struct vector3 body_profile[2][4] = {
    {{0.62f, -0.80f, 0}, {1.10f, -0.62f, 0}, {1.20f, 0.14f, 0}, {0.80f, 0.44f, 0}},
    {{0.80f, 0.44f, 0}, {0.66f, 0.545f, 0}, {0.56f, 0.56f, 0}, {0.62f, 0.70f, 0}},
};
static const struct vector3 lid_profile[3][4] = {
    {{0.58f, 0.69f, 0}, {0.56f, 0.90f, 0}, {0.16f, 0.84f, 0}, {0.09f, 0.95f, 0}},
    {{0.09f, 0.95f, 0}, {0.05f, 1.01f, 0}, {0.20f, 1.02f, 0}, {0.20f, 1.11f, 0}},
    {{0.20f, 1.11f, 0}, {0.20f, 1.18f, 0}, {0.10f, 1.22f, 0}, {0.00f, 1.22f, 0}},
};
static const struct vector3 handle_path[4] = {
    {-0.72f, 0.40f, 0}, {-1.75f, 0.72f, 0}, {-1.72f, -0.52f, 0}, {-0.92f, -0.44f, 0}};
static const struct vector3 spout_path[4] = {
    {0.80f, -0.34f, 0}, {1.60f, -0.30f, 0}, {1.22f, 0.50f, 0}, {1.78f, 0.62f, 0}};

static bool turned(struct object *o, const struct vector3 (*curve)[4], int curves, float size,
                   int segments, int attribute)
{
    struct point2 profile[PROFILE_POINTS];
    int steps = segments / 4, count = 0;
    for (int c = 0; c < curves; c++)
        for (int i = c == 0 ? 0 : 1; i <= steps; i++) {
            struct vector3 p = bezier_point(curve[c], 4, (float)i / (float)steps);
            profile[count++] = (struct point2){p.x * size, p.y * size};
        }
    return object_revolve(o, profile, count, false, segments, attribute);
}

/* Rings along a curve; radii go from r0 to r1. */
static int along_curve(struct tube_ring *ring, const struct vector3 path[4], int steps, float r0,
                       float r1, float size)
{
    for (int i = 0; i <= steps; i++) {
        float u = (float)i / (float)steps;
        struct vector3 at = bezier_point(path, 4, u), along = bezier_derivative(path, 4, u);
        ring[i] = (struct tube_ring){
            {at.x * size, at.y * size}, {along.x, along.y}, size * (r0 + (r1 - r0) * u * (2 - u))};
    }
    return steps + 1;
}

static bool handle(struct object *o, float size, int segments, int attribute)
{
    struct tube_ring ring[TUBE_RINGS];
    int count = along_curve(ring, handle_path, segments / 2, 0.09f, 0.08f, size);
    return object_tube(o, ring, count, segments / 2, attribute);
}

/* Its surface goes on round the lip and some way into the opening. */
static bool spout(struct object *o, float size, int segments, int attribute)
{
    struct tube_ring ring[TUBE_RINGS];
    int count = along_curve(ring, spout_path, segments / 2, 0.26f, 0.095f, size);
    struct tube_ring tip = ring[count - 1], in = ring[count - 2];
    tip.radius *= 0.75f;
    in.radius = tip.radius;
    ring[count++] = tip;
    ring[count++] = in;
    return object_tube(o, ring, count, segments / 2, attribute);
}

bool object_vessel(struct object *o, float size, int segments, int attribute)
{
    segments -= segments % 4;
    if (segments < 8 || segments > VESSEL_SEGMENTS)
        return false;
    return turned(o, body_profile, 2, size, segments, attribute) &&
           turned(o, lid_profile, 3, size, segments, attribute) &&
           handle(o, size, segments, attribute) && spout(o, size, segments, attribute);
}
