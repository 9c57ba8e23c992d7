/* cubic.h — parametric cubics by their coefficients.
 *
 *      p(u) = T · A,   T = (u³ u² u 1),   A = (a b c d) for x, y and z
 *
 * Models:     points by Horner's scheme, derivatives, points at equal steps by forward
 *             differences, and how many steps a given error takes.
 * Cost:       a point 9 multiplications and 9 sums; by forward differences 9 sums. Steps n: the
 *             chord of a step is nowhere farther than max |p″| / 8n² from the curve; p″ is linear,
 *             so its largest value is at an end. Rounding adds about n · 2⁻²⁴ of the curve's size.
 * Domain:     finite coefficients; 1 to CUBIC_STEPS_MOST steps.
 * Units:      the caller's; curves of the plane have z = 0.
 * Ownership:  plain values.
 * Errors:     none: a tolerance that would take more steps gets CUBIC_STEPS_MOST.
 * Source:     elementary; forward differences: S. A. Coons, Surfaces for Computer-Aided Design of
 *             Space Forms, MIT MAC-TR-41 (1967).
 */
#ifndef ROMS_CURVES_CUBIC_H
#define ROMS_CURVES_CUBIC_H

#include <stdbool.h>

#include "roms/geometry/vector.h"

enum { CUBIC_STEPS_MOST = 128 };

struct cubic {
    struct vector3 a, b, c, d; /* of u³, u², u, 1 */
};

struct vector3 cubic_point(const struct cubic *cubic, float u);
/* The first (order 1) or second derivative. */
struct vector3 cubic_derivative(const struct cubic *cubic, int order, float u);
/* How many equal steps keep chords within `tolerance` of the curve. */
int cubic_steps(const struct cubic *cubic, float tolerance);

/* The points at u = 0, 1/steps … 1. */
struct cubic_run {
    struct vector3 at, d1, d2, d3; /* the next point; its first, second and third difference */
    int left;
};
void cubic_run_begin(struct cubic_run *run, const struct cubic *cubic, int steps);

static inline bool cubic_run_next(struct cubic_run *run, struct vector3 *out)
{
    if (run->left-- <= 0)
        return false;
    *out = run->at;
    run->at = vector3_sum(run->at, run->d1);
    run->d1 = vector3_sum(run->d1, run->d2);
    run->d2 = vector3_sum(run->d2, run->d3);
    return true;
}

#endif
