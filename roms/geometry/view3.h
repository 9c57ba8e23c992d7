/* view3.h — from world coordinates to viewing coordinates.
 *
 *             VUP                 n = VPN / |VPN|            toward the viewer
 *              ▲  ▲ v             u = VUP × n / |VUP × n|    to the right
 *              │ ╱                v = n × u                  up
 *       VRP    ●───▶ u
 *             ◢ n                 M = R · T,  rows of R: u, v, n;  T: VRP to the origin
 *
 * Models:     the viewing transformation from view reference point, view-plane normal and view-up.
 * Cost:       2 cross products, 3 square roots and one product of matrices.
 * Domain:     coordinates up to 1e6; vectors of length 1e-6 at least.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     a normal of length 0, or a view-up that is parallel to the normal (within 0.06
 *             degrees): false, and nothing is written.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (1986); ISO 8805, GKS-3D
 *             (1988).
 */
#ifndef ROMS_GEOMETRY_VIEW3_H
#define ROMS_GEOMETRY_VIEW3_H

#include <stdbool.h>

#include "roms/geometry/matrix4.h"

struct view3 {
    struct vector3 u, v, n;
    struct matrix4 translate, rotate;
    struct matrix4 matrix; /* rotate · translate */
};

bool view3(struct vector3 reference, struct vector3 normal, struct vector3 up, struct view3 *out);

#endif
