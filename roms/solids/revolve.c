/* revolve.c — surfaces of revolution: sphere, cylinder, torus. */
#include "roms/geometry/scalar.h"
#include "roms/solids/models.h"
#include "roms/solids/rings.h"

/* The ring of a point of the profile; a count of 0: no room. */
static struct ring turn_point(struct object *o, struct point2 p, int segments)
{
    struct ring ring = {o->vertices, p.x == 0 ? 1 : segments};
    for (int k = 0; k < ring.count; k++) {
        float angle = TURN * (float)k / (float)segments;
        if (object_vertex(o, p.x * sinf(angle), p.y, p.x * cosf(angle)) < 0)
            return (struct ring){0, 0};
    }
    return ring;
}

bool object_revolve(struct object *o, const struct point2 *profile, int count, bool closed,
                    int segments, int attribute)
{
    if (count < 2 || segments < 3 || segments > MODEL_SEGMENTS)
        return false;
    struct ring first = turn_point(o, profile[0], segments), before = first;
    for (int i = 1; i < count; i++) {
        struct ring ring = turn_point(o, profile[i], segments);
        if (ring.count == 0 || before.count == 0 ||
            !ring_band(o, before, ring, RING_QUADRILATERALS, attribute))
            return false;
        before = ring;
    }
    if (closed)
        return ring_band(o, before, first, RING_QUADRILATERALS, attribute);
    return ring_end(o, first, false, attribute) && ring_end(o, before, true, attribute);
}

bool object_sphere(struct object *o, float radius, int segments, int rings, int attribute)
{
    struct point2 profile[MODEL_RINGS + 1];
    if (rings < 2 || rings > MODEL_RINGS)
        return false;
    for (int i = 0; i <= rings; i++) {
        float angle = TURN / 2 * (float)i / (float)rings;
        bool pole = i == 0 || i == rings;
        profile[i] = (struct point2){pole ? 0 : radius * sinf(angle), -radius * cosf(angle)};
    }
    return object_revolve(o, profile, rings + 1, false, segments, attribute);
}

bool object_cylinder(struct object *o, float radius, float height, int segments, int attribute)
{
    struct point2 profile[] = {{radius, -height / 2}, {radius, height / 2}};
    return object_revolve(o, profile, 2, false, segments, attribute);
}

bool object_torus(struct object *o, float radius, float tube, int segments, int rings,
                  int attribute)
{
    struct point2 profile[MODEL_RINGS];
    if (rings < 3 || rings > MODEL_RINGS)
        return false;
    for (int i = 0; i < rings; i++) {
        float angle = TURN * (float)i / (float)rings;
        profile[i] = (struct point2){radius + tube * cosf(angle), tube * sinf(angle)};
    }
    return object_revolve(o, profile, rings, true, segments, attribute);
}
