/* bracket.h — a mechanical part: an angle bracket with two holes.
 *
 *            ╭───╮            front: width, height, hole           ▲ y
 *            │ ○ │ upright    side: depth, thickness               │
 *            │   │            plan: the other hole                 └──▶ x, z toward the viewer
 *         ┌──┴───┴──┐
 *        ╱    ◯    ╱ base     x from −width/2 to width/2; the upright's back is z = 0, the bottom
 *       └─────────┘           of the base y = 0
 *
 * Models:     a closed solid with two tunnels: V − E + S = −2. Holes and the round top are polygons
 *             of 24 and a few sides. Faces with holes are cut into convex polygons of one plane.
 * Cost:       about 150 polygons.
 * Domain:     bracket_fits; every dimension above 0.
 * Units:      the caller's: millimetres.
 * Ownership:  nothing.
 * Errors:     what does not fit together, or no room: false.
 * Source:     this project's own design.
 */
#ifndef ROMS_SOLIDS_BRACKET_H
#define ROMS_SOLIDS_BRACKET_H

#include "roms/solids/object.h"

struct bracket {
    float width;          /* of both plates; the upright's top is a half circle of that width */
    float height;         /* of the upper hole's middle above the bottom */
    float depth;          /* of the base */
    float thickness;      /* of both plates */
    float upper_diameter; /* of the upright's hole */
    float lower_diameter; /* of the base's */
};

bool bracket_fits(const struct bracket *b);
bool object_bracket(struct object *o, const struct bracket *b, int attribute);
/* Where the middle of the base's hole is: z. */
float bracket_lower_z(const struct bracket *b);

#endif
