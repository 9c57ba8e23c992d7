/* pipeline2.h — the viewing pipeline of the plane, from a model to the device.
 *
 *      MC ──model──▶ WC ──view──▶ VC ──normalize──▶ NVC ──(clip)──device──▶ DC
 *      modelling     world        viewing           normalized viewing      device coordinates
 *
 * Models:     one matrix a stage and their products; points, lines and polygons through all of it,
 *             clipped to the viewport in normalized coordinates.
 * Cost:       15 matrix elements a setting; then 4 multiplications a point, the clipper's, and 2
 *             more a point that is left.
 * Units:      MC, WC, VC: the caller's; NVC: 0…1; DC: the device's.
 * Ownership:  plain values.
 * Errors:     begin: false for a window without an area or a frame without a direction up; nothing
 *             is then written.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (2nd ed. 1994), section 6-1; ISO 7942 (GKS,
 *             1985).
 */
#ifndef ROMS_CLIP_PIPELINE2_H
#define ROMS_CLIP_PIPELINE2_H

#include <stdbool.h>

#include "roms/clip/sutherland_hodgman.h"
#include "roms/clip/window.h"
#include "roms/geometry/matrix3.h"

/* What is to be seen where. */
struct view2 {
    struct point2 origin, up;    /* of the viewing frame, in WC */
    struct clip_window window;   /* in VC */
    struct clip_window viewport; /* in NVC */
    struct clip_window device;   /* the unit square, in DC; y_max below y_min: rows go down */
};

struct pipeline2 {
    struct matrix3 model;     /* MC to WC */
    struct matrix3 view;      /* WC to VC */
    struct matrix3 normalize; /* VC to NVC */
    struct matrix3 device;    /* NVC to DC */
    struct matrix3 before;    /* MC to NVC: the first three as one */
    struct matrix3 whole;     /* MC to DC: all as one */
    struct clip_window viewport;
};

/* The model is where it was made: MC = WC. */
bool pipeline2_begin(struct pipeline2 *p, const struct view2 *view);
/* Another model in the same view. */
void pipeline2_model(struct pipeline2 *p, const struct matrix3 *model);

/* To DC; false: nothing of it is within the viewport, and it stays as it was. */
bool pipeline2_point(const struct pipeline2 *p, struct point2 *at);
bool pipeline2_line(const struct pipeline2 *p, struct point2 *a, struct point2 *b);
/* Calls line(…) with what is left of each line between neighbours; every point is transformed
 * once. */
void pipeline2_polyline(const struct pipeline2 *p, const struct point2 *points, int count,
                        void (*line)(void *ctx, struct point2 a, struct point2 b), void *ctx);
/* Leaves what is left in work->corner, in DC; its corners, 0: nothing, or more than
 * CLIP_POLYGON_MOST. */
int pipeline2_polygon(const struct pipeline2 *p, const struct point2 *corners, int count,
                      struct sutherland_hodgman *work);

#endif
