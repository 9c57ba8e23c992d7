/* models.h — solids to begin with: box, sphere, cylinder, torus, and a vessel.
 *
 *          ┌──┐       ring of vertices                    lid ╭○╮
 *         ╱  ╱│      ╭─────────╮ ◀─ profile (r, y)      ╭───┴─┴──╮  ╱╱  spout: a tube along a
 *        ┌──┐ │      │─────────│    turned about y    ╭─┤  body  ├─╱╱   Bézier
 *        │  │╱       ╰─────────╯                      ╰─┤        │╱    curve; handle: another
 *        └──┘                                            ╰──────╯
 *
 * Each adds its polygons to the object, about the origin, y up, corners counter-clockwise from
 * outside; object_normals is for the caller to call after the last. The vessel is four closed
 * solids, which reach into each other; it is this project's own design.
 *
 * Models:     surfaces of revolution and tubes, approximated by quadrilaterals and triangles.
 * Cost:       about 830 instructions a polygon.
 * Domain:     segments 3…MODEL_SEGMENTS round the axis, rings 2…MODEL_RINGS along it.
 * Units:      the caller's. A vessel of size 1 is about 2 high and 3.4 long.
 * Ownership:  nothing.
 * Errors:     what does not fit, or lies outside of the domain: false; the object then holds a
 *             part.
 * Source:     elementary.
 * Not modelled: the vessel's inside.
 */
#ifndef ROMS_SOLIDS_MODELS_H
#define ROMS_SOLIDS_MODELS_H

#include "roms/solids/object.h"

enum { MODEL_SEGMENTS = 64, MODEL_RINGS = 64, VESSEL_SEGMENTS = 24, VESSEL_PARTS = 4 };

bool object_box(struct object *o, float width, float height, float depth, int attribute);
bool object_sphere(struct object *o, float radius, int segments, int rings, int attribute);
bool object_cylinder(struct object *o, float radius, float height, int segments, int attribute);
/* `radius` from the axis to the tube's middle. */
bool object_torus(struct object *o, float radius, float tube, int segments, int rings,
                  int attribute);
/* Segments 8…VESSEL_SEGMENTS; 16 give about 1000 triangles. */
bool object_vessel(struct object *o, float size, int segments, int attribute);

/* A profile (r, y) turned about y; from the lowest point to the highest its outside is on the
 * right. Ends with r > 0 become flat; a closed one goes on from its last point to its first. */
bool object_revolve(struct object *o, const struct point2 *profile, int count, bool closed,
                    int segments, int attribute);

/* A ring of a tube in the plane z = 0. */
struct tube_ring {
    struct point2 centre;
    struct point2 along; /* the tube's direction there; of any length */
    float radius;
};

/* Triangles from ring to ring, flat ends. */
bool object_tube(struct object *o, const struct tube_ring *ring, int count, int segments,
                 int attribute);

#endif
