#include "roms/solids/rings.h"

static int ring_vertex(struct ring r, int k)
{
    return r.first + (r.count > 1 ? k % r.count : 0);
}

static bool quadrilateral(struct object *o, const int corner[4], enum ring_band kind, int attribute)
{
    if (kind == RING_QUADRILATERALS)
        return object_polygon(o, corner, 4, attribute) >= 0;
    int rest[3] = {corner[0], corner[2], corner[3]};
    return object_polygon(o, corner, 3, attribute) >= 0 &&
           object_polygon(o, rest, 3, attribute) >= 0;
}

bool ring_band(struct object *o, struct ring a, struct ring b, enum ring_band kind, int attribute)
{
    int count = a.count > b.count ? a.count : b.count;
    for (int k = 0; k < count && count > 1; k++) {
        int corner[4] = {ring_vertex(a, k), ring_vertex(a, k + 1), ring_vertex(b, k + 1),
                         ring_vertex(b, k)};
        bool added;
        if (a.count == 1)
            added = object_polygon(o, corner + 1, 3, attribute) >= 0;
        else if (b.count == 1)
            added = object_polygon(o, corner, 3, attribute) >= 0;
        else
            added = quadrilateral(o, corner, kind, attribute);
        if (!added)
            return false;
    }
    return true;
}

bool ring_end(struct object *o, struct ring ring, bool last, int attribute)
{
    int corner[OBJECT_CORNERS];
    if (ring.count > OBJECT_CORNERS)
        return false;
    for (int k = 0; k < ring.count; k++)
        corner[k] = ring.first + (last ? k : ring.count - 1 - k);
    return ring.count == 1 || object_polygon(o, corner, ring.count, attribute) >= 0;
}
