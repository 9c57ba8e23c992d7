/* periodic.h — the cubic spline that closes: C2 everywhere, through points in a ring.
 *
 *      p0 ─h0─ p1 ─h1─ p2 ─ … ─ pn−1 ─hn−1─ p0     slopes m_i by a cyclic system:
 *          h_i m_i−1 + 2(h_i−1 + h_i) m_i + h_i−1 m_i+1 = 3(h_i/h_i−1 · c_i−1 + h_i−1/h_i · c_i)
 *      with chords c_i = p_i+1 − p_i
 *
 * Models:     slopes by Sherman and Morrison: two tridiagonal systems in place of the cyclic one.
 * Domain:     3 to SPLINE_PIECES_MOST points; the ring has as many pieces as points.
 * Units:      the caller's; knots as in spline.h.
 * Ownership:  plain values.
 * Errors:     false: too few or too many points, or neighbours that coincide where the parameter is
 *             their distance.
 * Source:     J. Sherman, W. J. Morrison, Annals of Mathematical Statistics 21 (1950) 124; J. H. Ahlberg,
 *             E. N. Nilson, J. L. Walsh, The Theory of Splines and Their Applications (1967), 2.2.
 */
#ifndef ROMS_SPLINE_PERIODIC_H
#define ROMS_SPLINE_PERIODIC_H

#include "roms/curves/spline.h"

bool periodic_spline(const struct vector3 *points, int count, enum spline_parameter parameter,
                     struct spline *out);

#endif
