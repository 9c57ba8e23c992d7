/* object_check.h — are the tables free of errors?
 *
 *      1  every vertex is an end of at least two edges          V6 ends 0 edges
 *      2  every edge is part of at least one polygon            E9 is part of no polygon
 *      3  every polygon is closed                               S1 does not come back to V1
 *      4  every polygon has at least one shared edge            S6 shares no edge
 *      5  pointers between edges and polygons are reciprocal    E5 points to S4, which lacks it
 *
 * Models:     five guidelines; what is part of a polygon is what the polygon table says.
 * Cost:       about 175 instructions a side.
 * Domain:     any tables whose indices are within them.
 * Units:      none.
 * Ownership:  the state is the caller's (about 5 KB); the object must outlive it.
 * Errors:     none: it reports faults one by one.
 * Source:     the guidelines are those of D. Hearn, M. P. Baker, Computer Graphics, C Version
 *             (1997), section 10-1.
 * Not modelled: geometry: planes, orientation, polygons that cut one another.
 */
#ifndef ROMS_SOLIDS_OBJECT_CHECK_H
#define ROMS_SOLIDS_OBJECT_CHECK_H

#include "roms/solids/object.h"

enum object_rule {
    RULE_VERTEX_ENDS,
    RULE_EDGE_USED,
    RULE_POLYGON_CLOSED,
    RULE_POLYGON_SHARED,
    RULE_RECIPROCAL,
    OBJECT_RULES
};

struct object_fault {
    enum object_rule rule;
    int index; /* of the vertex, edge or polygon; of the edge for RULE_RECIPROCAL */
    int other; /* RULE_VERTEX_ENDS: how many edges; RULE_RECIPROCAL: the polygon */
};

struct object_check {
    const struct object *object;
    enum object_rule rule;
    int index;                     /* looked at next */
    int polygon;                   /* that of the side looked at */
    uint8_t ends[OBJECT_VERTICES]; /* edges that end there, 2: two or more */
    uint8_t uses[OBJECT_EDGES];    /* polygons that it is part of, 2: two or more */
};

void object_check_begin(struct object_check *check, const struct object *object);
/* The next fault; false: there is none left. */
bool object_check_next(struct object_check *check, struct object_fault *fault);
/* "every edge is part of at least one polygon" */
const char *object_rule_text(enum object_rule rule);

#endif
