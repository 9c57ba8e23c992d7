/* volume.h — lines and polygons clipped to the view volume, before the division by h.
 *
 *      parallel: a box          perspective: a frustum          both: −h <= x, y, z <= h
 *        ┌────┐                        ╱│
 *        │    │                  prp ◁  │ far      a place is inside when the six numbers
 *        └────┘                        ╲│          h + x, h − x, h + y, h − y, h + z, h − z
 *                                    near          are all >= 0; then h >= 0, too
 *
 * Clipping after the division would take what is behind the eye for something in front of it,
 * upside down. In homogeneous coordinates a line from front to back is simply cut where h ± x …
 * is 0.
 *
 * Models:     the matrices of both volumes, with the larger z nearer (near: z = h, far: z = −h);
 *             region codes; lines by their parameter; polygons plane by plane.
 * Cost:       a code: 6 additions and comparisons. A line with an end outside: 6 divisions at most
 *             and 8 multiplications. A polygon: 1 comparison a corner and plane, a division and 4
 *             multiplications a cut; a plane that no corner is outside of costs nothing more.
 * Domain:     numbers up to 1e6. Polygons of 3 to VOLUME_CORNERS corners. Points on a plane are
 *             inside. A concave polygon that falls into parts keeps one boundary: parts hang
 *             together by edges along the plane that count for nothing in an even-odd filling.
 * Units:      near and far are z coordinates, zprp > near > far; the window lies on the plane z =
 *             zvp.
 * Ownership:  plain values.
 * Errors:     an empty window or volume, or a reference point within it: false, nothing is written.
 * Source:     J. F. Blinn, M. E. Newell, Clipping Using Homogeneous Coordinates, Computer Graphics
 *             12 (SIGGRAPH 1978) 245; I. E. Sutherland, G. W. Hodgman, Reentrant Polygon Clipping,
 *             Communications of the ACM 17 (1974) 32.
 */
#ifndef ROMS_CLIP_VOLUME_H
#define ROMS_CLIP_VOLUME_H

#include <stdbool.h>

#include "roms/clip/window.h"
#include "roms/geometry/matrix4.h"

/* Bit i of a code: outside of plane i. */
enum volume_plane {
    VOLUME_LEFT,
    VOLUME_RIGHT,
    VOLUME_BELOW,
    VOLUME_ABOVE,
    VOLUME_FAR,
    VOLUME_NEAR,
    VOLUME_PLANES
};
/* A plane makes of n corners at most 3n/2: six of them, 11.4 n. */
enum { VOLUME_CORNERS = 24, VOLUME_ROOM = 288 };

bool volume_parallel(const struct clip_window *window, float near, float far, struct matrix4 *out);
bool volume_perspective(struct vector3 prp, float zvp, const struct clip_window *window, float near,
                        float far, struct matrix4 *out);

/* h + x, h − x, …: below 0 outside of the plane. */
float volume_boundary(const struct vector4 *p, enum volume_plane plane);
unsigned volume_code(const struct vector4 *p);

/* The working: the boundary coordinates of both ends, their codes, the part that is left. */
struct volume_line {
    float a[VOLUME_PLANES], b[VOLUME_PLANES];
    unsigned code_a, code_b;
    float t1, t2; /* t1 > t2: nothing */
};
/* Moves the ends onto what is left; false: nothing is, and they stay. `working` may be NULL. */
bool volume_clip_line(struct vector4 *a, struct vector4 *b, struct volume_line *working);

/* One plane: corners in, corners out (at most half as many more); how many are left. */
int volume_clip_plane(const struct vector4 *in, int count, enum volume_plane plane,
                      struct vector4 *out);
/* All six. 0: nothing is left. */
int volume_clip_polygon(const struct vector4 *in, int count, struct vector4 out[VOLUME_ROOM]);

#endif
