/* maths.h — exp, log, pow, erf and friends built from + − × ÷ √ alone.
 *
 * The C library's versions differ from one machine to the next in their last bits; these give the
 * same bits on every IEEE 754 host when built with -ffp-contract=off. Everything in crt/ that ends
 * up in a sample uses them; sqrt, floor, ceil, fabs are exact everywhere and are used as they are.
 *
 * Accuracy:   relative error below 4e-15 unless a line says otherwise (tests compare with long
 *             double libm).
 * Errors:     outside the domain the IEEE result (NaN, ±inf, 0) is returned.
 */
#ifndef CRT_MATHS_H
#define CRT_MATHS_H

double crt_exp(double x);
double crt_expm1(double x);
double crt_log(double x);
double crt_pow(double x, double y); /* x >= 0 */
double crt_erf(double x);
double crt_erfcx(double x);     /* e^(x²)·erfc(x), x >= -5 */
double crt_sin(double radians); /* |radians| < 1e5; absolute error below 4e-15 */
double crt_cos(double radians);

#endif
