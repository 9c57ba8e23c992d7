/* tube.c — tubes along a path. */
#include "roms/geometry/scalar.h"
#include "roms/solids/models.h"
#include "roms/solids/rings.h"

/* Vertices counter-clockwise seen from the path's end; a count of 0: no room. */
static struct ring tube_vertices(struct object *o, const struct tube_ring *t, int segments)
{
    float length = sqrtf(t->along.x * t->along.x + t->along.y * t->along.y);
    struct point2 side = {-t->along.y / length, t->along.x / length};
    struct ring ring = {o->vertices, segments};
    for (int k = 0; k < segments; k++) {
        float angle = TURN * (float)k / (float)segments;
        float out = t->radius * cosf(angle);
        if (object_vertex(o, t->centre.x + out * side.x, t->centre.y + out * side.y,
                          t->radius * sinf(angle)) < 0)
            return (struct ring){0, 0};
    }
    return ring;
}

bool object_tube(struct object *o, const struct tube_ring *t, int count, int segments,
                 int attribute)
{
    struct ring first = {0, 0}, before = {0, 0};
    if (count < 2 || segments < 3 || segments > MODEL_SEGMENTS)
        return false;
    for (int i = 0; i < count; i++) {
        struct ring ring = tube_vertices(o, &t[i], segments);
        if (ring.count == 0 || (i > 0 && !ring_band(o, before, ring, RING_TRIANGLES, attribute)))
            return false;
        first = i == 0 ? ring : first;
        before = ring;
    }
    return ring_end(o, first, false, attribute) && ring_end(o, before, true, attribute);
}
