/* continuity.h — how smoothly one curve goes on as another.
 *
 *            p ╭──────╮ q             p(1), p′(1), p″(1) against q(0), q′(0), q″(0)
 *        ╭─────╯      ╰────
 *
 *      C0  q = p                       G0  q = p
 *      C1  C0 and q′ = p′              G1  G0 and q′ = k·p′, k > 0
 *      C2  C1 and q″ = p″              G2  G1 and q″ = k²·p″ + m·p′
 *
 * Models:     parametric continuity (the same derivatives) and geometric continuity (the same
 *             after a change of parameter: direction of the tangent, curvature).
 * Cost:       about 60 multiplications.
 * Domain:     finite vectors. Where p′ or q′ is 0, or shorter than
 *             CONTINUITY_SHORTEST of the other, a curve has no direction: no G1, no G2.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none. Two vectors are taken as equal when they differ by at most
 *             CONTINUITY_TOLERANCE of the longer one, or by no more than rounding does: 4 · 2⁻²³
 *             of the points' distance from the origin (times 6 for p′, 36 for p″). A gap is
 *             measured against the tangents' length.
 * Source:     B. A. Barsky, T. D. DeRose, IEEE Computer Graphics and Applications 9 (1989) 60.
 */
#ifndef ROMS_CURVES_CONTINUITY_H
#define ROMS_CURVES_CONTINUITY_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

#define CONTINUITY_TOLERANCE 1e-4f
#define CONTINUITY_SHORTEST  1e-6f

/* Place, first and second derivative of the end of p and of the beginning of q. */
struct join {
    struct vector3 p[3], q[3];
};

struct continuity {
    bool c0, c1, c2, g0, g1, g2;
    float apart[3];   /* |q − p|, |q′ − p′|, |q″ − p″| */
    float allowed[3]; /* what these may be */
    float k, m; /* of the best fits q′ ≈ k·p′ and q″ ≈ k²·p″ + m·p′; 0 without a direction */
    float off[3];         /* [1] |q′ − k·p′|, [2] |q″ − k²·p″ − m·p′| */
    float off_allowed[3]; /* what these may be */
};

struct continuity continuity_of(const struct join *join);

#endif
