/* plane_ops.h — transformations of the plane as words: "rotate-about 45 4 3 then translate 2 0".
 *
 * Models:     each operation as a matrix, and those about a point or a line as their elementary
 *             steps, too.
 * Units:      degrees, anticlockwise; lengths the user's.
 * Ownership:  plain values.
 * Errors:     as words.h.
 */
#ifndef ROMS_COMMANDS_PLANE_OPS_H
#define ROMS_COMMANDS_PLANE_OPS_H

#include "roms/geometry/matrix3.h"
#include "roms/monitor/words.h"

enum { PLANE_OPS = 12, PLANE_STEPS = 5, PLANE_NAME = 56 };
#define PLANE_OPS_FORM                                                                             \
    "translate tx ty|rotate degrees|rotate-about degrees x y|scale sx sy|scale-about sx sy x y|"   \
    "reflect x|y|origin|y=x|y=-x|x=K|y=K|reflect-line m c|shear x|y k [about K]"

struct plane_step {
    char name[PLANE_NAME];
    struct matrix3 matrix;
};

struct plane_op {
    struct plane_step whole;
    struct plane_step step[PLANE_STEPS]; /* first to last */
    int steps;                           /* 0: it is elementary */
};

struct plane_ops {
    struct plane_op op[PLANE_OPS];
    int count;
    struct matrix3 product; /* the first is applied first */
};

/* Is the next word the name of an operation? */
bool plane_ops_next(const struct words *w);
/* OP args [then OP args …]. */
bool plane_ops_take(struct words *w, struct plane_ops *ops);
/* Every operation's matrix, and its steps'. */
void plane_ops_print(const struct plane_ops *ops);

#endif
