/* transform3.h — transformations of space as 4 by 4 matrices.
 *
 *            y                  a rotation is positive anticlockwise, seen from the positive
 *            ▲                  end of its axis: Rx turns y to z, Ry turns z to x, Rz turns x to y
 *            └──▶ x
 *           ◢                   a transformation of several steps:
 *          z                    M = step[n−1] · … · step[1] · step[0]
 *
 * Models:     translation; scaling about the origin and about a fixed point; rotation about an axis
 *             and about a line parallel to one; reflection in the axes and in the planes that they
 *             span; shear along an axis.
 * Cost:       none takes a multiplication of matrices but those of several steps: 64
 *             multiplications a product.
 * Domain:     finite numbers. Sines and cosines of multiples of 90 degrees are exactly 0 and ±1.
 * Units:      angles: degrees; the rest: the caller's.
 * Ownership:  plain values; names are constant strings.
 * Errors:     none. A scale of 0 gives a matrix without inverse.
 * Source:     J. D. Foley et al., Computer Graphics (1990), sections 5.6 and 5.7.
 * Not modelled: shear about a plane that does not pass through the origin.
 */
#ifndef ROMS_GEOMETRY_TRANSFORM3_H
#define ROMS_GEOMETRY_TRANSFORM3_H

#include "roms/geometry/matrix4.h"

enum axis3 { AXIS3_X, AXIS3_Y, AXIS3_Z };
enum plane3 { PLANE3_XY, PLANE3_YZ, PLANE3_XZ };

/* A transformation with its steps, in the order in which they are applied. */
enum { TRANSFORM3_STEPS = 7 };
struct transform3 {
    struct {
        const char *name;
        struct matrix4 matrix;
    } step[TRANSFORM3_STEPS];
    int steps;
    struct matrix4 matrix; /* of all of them */
};

/* Appends a step; there must be room. */
void transform3_step(struct transform3 *t, const char *name, struct matrix4 matrix);

struct matrix4 transform3_translate(struct vector3 by);
struct matrix4 transform3_scale(struct vector3 factors);
struct matrix4 transform3_rotate(enum axis3 axis, float degrees);
/* The same with the sine and cosine of the angle. */
struct matrix4 transform3_turn(enum axis3 axis, float sine, float cosine);
/* In an axis: half a turn about it. In a plane: the coordinate across it changes its sign. */
struct matrix4 transform3_reflect_axis(enum axis3 axis);
struct matrix4 transform3_reflect_plane(enum plane3 plane);
/* Along an axis, whose coordinate stays: the two others, in the order x, y, z, grow by a and b
 * times it. */
struct matrix4 transform3_shear(enum axis3 axis, float a, float b);

/* T(fixed) · S · T(−fixed). */
struct transform3 transform3_scale_about(struct vector3 factors, struct vector3 fixed);
/* T(through) · R · T(−through): about the line through that point which is parallel to the axis. */
struct transform3 transform3_rotate_parallel(enum axis3 axis, float degrees,
                                             struct vector3 through);

/* The determinant of the upper left 3 by 3: below 0 where left and right change places. */
float transform3_determinant(const struct matrix4 *m);

#endif
