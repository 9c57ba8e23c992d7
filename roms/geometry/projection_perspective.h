/* projection_perspective.h — perspective projection, and where parallel lines meet.
 *
 *       P = (x, y, z)
 *       ●──────────╲                   dp = zprp − zvp
 *                   ╲ (xp, yp, zvp)    xp = x·dp/(zprp − z)      (prp on the z axis)
 *                  ──●──────────╲      yp = y·dp/(zprp − z)
 *                 view plane     ● prp
 *
 *      | 1  0     0        0     |     h = (zprp − z)/dp; the place is xh/h, yh/h. All z are zvp
 *      | 0  1     0        0     |     after the division. h > 0: on the view plane's side of the
 *      | 0  0  −zvp/dp  zvp·zprp/dp |  projection reference point; h <= 0: beside or behind it.
 *      | 0  0   −1/dp    zprp/dp |
 *
 * Models:     projection from any projection reference point onto the plane z = zvp; for one that
 *             is not on the z axis, x = xprp + (x − xprp)·dp/(zprp − z), y likewise. Vanishing
 *             points: the picture of the point at infinity in a direction.
 * Cost:       one division for the matrix; 16 multiplications and 2 divisions a point.
 * Domain:     coordinates up to 1e6, |dp| at least PERSPECTIVE_NEAREST.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     a view plane through the projection reference point: false. A direction parallel to
 *             the view plane has no vanishing point: false. Nothing is written then.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (1986); vanishing points:
 *             B. Taylor, Linear Perspective (1715).
 * Not modelled: depth is lost; volume.h keeps it for clipping and hidden surfaces.
 */
#ifndef ROMS_GEOMETRY_PROJECTION_PERSPECTIVE_H
#define ROMS_GEOMETRY_PROJECTION_PERSPECTIVE_H

#include <stdbool.h>

#include "roms/geometry/matrix4.h"

#define PERSPECTIVE_NEAREST 1e-4f

bool projection_perspective(struct vector3 prp, float zvp, struct matrix4 *out);
/* A point's place; false: it lies beside or behind the projection reference point. */
bool projection_place(const struct matrix4 *projection, struct vector3 p, struct point2 *out);

/* Where lines of this direction meet; `projection` may contain a viewing or modelling
 * transformation. */
bool projection_vanishing(const struct matrix4 *projection, struct vector3 direction,
                          struct point2 *out);
/* The principal vanishing points, those of x, y and z: how many there are is the number in
 * "one-point", "two-point" and "three-point perspective". */
struct vanishing {
    bool has[3];
    struct point2 at[3];
    int count;
};
struct vanishing projection_vanishing_axes(const struct matrix4 *projection);

#endif
