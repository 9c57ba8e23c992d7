/* rings.h — surfaces between rings of vertices, for the model makers.
 *
 *      ring b   ●───●───●───      from a to b the outside is in front when vertices count right;
 *               │   │   │         a ring of one vertex is a pole
 *      ring a   ●───●───●───
 *
 * Models:     bands of quadrilaterals or triangles; flat ends.
 * Ownership:  nothing.
 * Errors:     no room: false.
 */
#ifndef ROMS_SOLIDS_RINGS_H
#define ROMS_SOLIDS_RINGS_H

#include "roms/solids/object.h"

struct ring {
    int first, count; /* vertices, one after the other */
};

enum ring_band { RING_QUADRILATERALS, RING_TRIANGLES };

bool ring_band(struct object *o, struct ring a, struct ring b, enum ring_band kind, int attribute);
/* A polygon that closes the surface before the first ring or behind the last one. */
bool ring_end(struct object *o, struct ring ring, bool last, int attribute);

#endif
