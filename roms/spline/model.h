/* model.h — the points of a drawing, and what a curve makes of them.
 *
 *          in ○──────●──────○ out      a joint: corner   in and out as they are
 *                   at                          G1       in line, each as long as it is
 *                                               C1       in line and equally long: out = −in
 *
 * Models:     control points that every kind of curve takes in its own way (curve.h); tangent handles
 *             of the piecewise cubic, as vectors from the point. Handles that nobody has moved
 *             follow the neighbours, as Catmull and Rom have them: a third of (next − before)/2.
 * Domain:     0 to MODEL_POINTS_MOST points within the drawing area, handles up to MODEL_HANDLE_MOST
 *             long.
 * Units:      stage units. Points lie on a grid of MODEL_GRIDth parts of a unit, so that text has few digits.
 * Ownership:  plain values: a model is copied to be kept.
 * Errors:     what cannot be done (no such point, no room) changes nothing and returns false. Places
 *             beyond the area are moved to its edge; ones that are not finite are not taken.
 * Source:     E. Catmull, R. Rom, A class of local interpolating splines (1974), for the handles.
 */
#ifndef ROMS_SPLINE_MODEL_H
#define ROMS_SPLINE_MODEL_H

#include <stdbool.h>

#include "roms/curves/bezier.h"
#include "roms/curves/spline.h"

/* Closed, a Bézier curve has one point more; a B-spline three: SPLINE_POINTS_MOST holds them. */
enum { MODEL_POINTS_MOST = BEZIER_POINTS_MOST - 1, MODEL_GRID = 16, MODEL_HANDLE_MOST = 4000 };
/* The area in which points may be. */
enum { MODEL_LEFT = 10, MODEL_RIGHT = 950, MODEL_BOTTOM = 60, MODEL_TOP = 790 };

enum model_kind { MODEL_BEZIER, MODEL_PIECES, MODEL_NATURAL, MODEL_B_SPLINE, MODEL_KINDS };
enum model_joint { JOINT_C1, JOINT_G1, JOINT_CORNER, JOINTS };

struct model_point {
    struct vector3 at;
    struct vector3 in, out; /* handles, from `at` */
    bool own;               /* the handles were moved */
    enum model_joint joint;
};

struct model {
    enum model_kind kind;
    enum spline_parameter parameter; /* of the natural spline */
    bool closed;
    int count;
    struct model_point point[MODEL_POINTS_MOST];
};

/* Some points, so that there is something to see. */
void model_example(struct model *model);

/* Into place `at`, 0…count: those from there on move up. */
bool model_add(struct model *model, int at, struct vector3 place);
bool model_delete(struct model *model, int index);
bool model_move(struct model *model, int index, struct vector3 place);
/* The end of a handle to a place; the other one follows as the joint wants it. */
bool model_move_handle(struct model *model, int index, bool out, struct vector3 place);
/* Another kind of joint; the handles are brought in line with it. */
bool model_set_joint(struct model *model, int index, enum model_joint joint);
/* The handles follow the neighbours again. */
bool model_free_handles(struct model *model, int index);

/* Handles that follow, anew. What changes points by itself calls it. */
void model_follow(struct model *model);

/* Where the handle has its end; whether the curve has it: ends of an open curve have one. */
struct vector3 model_handle(const struct model *model, int index, bool out);
bool model_has_handle(const struct model *model, int index, bool out);
/* The control polygon's corners, the first again at the end when closed; MODEL_POINTS_MOST + 1 at most. */
int model_polygon(const struct model *model, struct vector3 *out);

#endif
