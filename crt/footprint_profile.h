/* footprint_profile.h — the two profiles a footprint is made of, as polynomials.
 *
 *      cross: e^(−d²/2) ≈ p(x)^32, x = (d/CRT_CROSS_UNIT)², p cubic; p falls for every x, and stops
 *             at its value at the cut, whose 32nd power is then subtracted
 *      step:  ½·erfc(s/√2) ≈ r(|s|)^8, r of degree 5, also falling everywhere and stopped at the
 *             cut
 *
 * Units:      sigma.
 * Method:     coefficients from a weighted minimax fit (Lawson) on 0 … 4.8 sigma: absolute errors
 *             7e-7 and 2e-6. The areas are those of these very profiles, integrated with 30 digits.
 */
#ifndef CRT_FOOTPRINT_PROFILE_H
#define CRT_FOOTPRINT_PROFILE_H

#define CRT_CROSS_UNIT 8.0 /* sigma: √(2·32) */

#define CRT_CROSS_0   0.999999979377F
#define CRT_CROSS_1   (-0.999990107558F)
#define CRT_CROSS_2   0.499407129267F
#define CRT_CROSS_3   (-0.157164051783F)
#define CRT_CROSS_CUT 0x1.6510d6p-1F /* p at 4.8 sigma */

#define CRT_STEP_0   0.9170044661F
#define CRT_STEP_1   (-0.0914779678F)
#define CRT_STEP_2   (-0.03178656474F)
#define CRT_STEP_3   (-0.001020168304F)
#define CRT_STEP_4   0.00189470523F
#define CRT_STEP_5   (-0.0001833205024F)
#define CRT_STEP_CUT 0.17140575752F /* r at 4.8 sigma */

#define CRT_LINE_AREA 2.50653087659072930 /* ∫ cross dd */
#define CRT_DOT_AREA  6.28240447660796260 /* ∫∫ cross, round */

#endif
