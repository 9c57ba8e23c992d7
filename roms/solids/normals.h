/* normals.h — normals at the vertices by averaging.
 *
 *           N1 ▲   ▲ Nv = (N1 + N2 + …) / |N1 + N2 + …|       over polygons that meet at the vertex
 *              │  ╱▲ N2                                       without a crease between them
 *          ────┴─╱─╯──
 *
 * Where two polygons meet at more than the crease's angle a vertex has more than one normal, so
 * that the rim of a cylinder stays an edge. With NORMALS_ROUND every vertex has one, as the formula
 * says.
 *
 * Models:     mean normals.
 * Cost:       object_normals: about 390 instructions a side.
 * Domain:     any object; polygons without area and their corners count for nothing.
 * Units:      normals have length 1.
 * Ownership:  writes normal, side_normal and normals of the object.
 * Errors:     normals that do not fit into OBJECT_NORMALS: false, none are made.
 * Source:     H. Gouraud, IEEE Transactions on Computers C-20 (1971) 623.
 */
#ifndef ROMS_SOLIDS_NORMALS_H
#define ROMS_SOLIDS_NORMALS_H

#include "roms/solids/object.h"

/* The cosine of the angle between two polygons' normals from which on their edge is a crease. */
#define NORMALS_CREASE 0.64f   /* 50° */
#define NORMALS_ROUND  (-2.0f) /* no crease anywhere */

bool object_normals(struct object *o, float crease_cosine);

#endif
