/* projection_parallel.h — parallel projections onto the plane z = 0.
 *
 *      orthographic: projectors perpendicular to the view plane: elevations and plan show a face
 *                    as it is; axonometric views, more than one
 *      oblique:      projectors that are not: the front keeps its shape, depth is drawn at an angle
 *
 *      xp, yp: the place on the view plane. z: the depth, kept; larger z is nearer to the viewer.
 *
 * Models:     front, rear, left and right elevation and plan; axonometric views, which turn about
 *             y, then tilt about x: isometric, dimetric and trimetric; cavalier, cabinet and any
 *             other oblique projection.
 * Cost:       a matrix; axonometric: 2 sines and cosines, one product, 3 square roots.
 * Domain:     any finite angle. Dimetric: the factor of z from above 0 to 1.
 * Units:      angles: degrees; lengths: the caller's.
 * Ownership:  plain values.
 * Errors:     dimetric: a factor outside of its domain: false, and nothing is written.
 * Source:     I. Carlbom, J. Paciorek, Computing Surveys 10 (1978) 465; the dimetric angles: D. F.
 *             Rogers, J. A. Adams, Mathematical Elements for Computer Graphics (1976), section
 *             3-14.
 */
#ifndef ROMS_GEOMETRY_PROJECTION_PARALLEL_H
#define ROMS_GEOMETRY_PROJECTION_PARALLEL_H

#include <stdbool.h>

#include "roms/geometry/matrix4.h"

/* From where one looks: from +z, −z, −x, +x, +y (with −z up). */
enum elevation { ELEVATION_FRONT, ELEVATION_REAR, ELEVATION_LEFT, ELEVATION_RIGHT, ELEVATION_PLAN };
struct matrix4 projection_elevation(enum elevation from);

/* Axes 0, 1, 2: x, y, z. */
struct axonometric {
    float turn, tilt; /* about y, then about x */
    float factor[3];  /* how long a unit along each axis is drawn */
    float angle[3];   /* at which each axis is drawn, anticlockwise from the right; 0…360 */
    struct matrix4 matrix;
};
struct axonometric projection_axonometric(float turn, float tilt);
/* All three factors are √(2/3). */
struct axonometric projection_isometric(void);
/* x and y are drawn to one scale, z to z_factor. */
bool projection_dimetric(float z_factor, struct axonometric *out);

/* xp = x + z·f·cos φ, yp = y + z·f·sin φ: the z axis is drawn at the angle φ, a unit of it as long
 * as f. Cavalier: f = 1; cabinet: f = 1/2. At 225 degrees what is behind goes to the upper right.
 * */
struct matrix4 projection_oblique(float degrees, float factor);

#endif
