/* scalar.h — small things about single numbers that every part of the library needs.
 *
 *      scalar_floor     scalar_nearest     scalar_ceil        cos 90° = 0, sin 90° = 1 exactly:
 *      ──┬──●────┬──    ──┬──●────┬──      ──┬──●────┬──      what is left of the nearest quarter
 *        ◀──┘             ◀──┘  a half       └───────▶        of a turn goes to sinf and cosf
 *      −1       0       −1    goes up 0    −1       0
 *
 * Models:     whole numbers below, above and nearest to a float; the smaller, the larger and the
 *             moved-within of two ends; sines and cosines of degrees.
 * Cost:       min, max: 1 instruction each. The C library's fminf and fmaxf are calls, which call a
 *             third function to ask about signalling NaNs; compilers put the instruction in their
 *             place only with -ffinite-math-only or the like. Floor, ceil: 4; nearest: 5. A sine and
 *             cosine: a call each of fmodf, sinf and cosf.
 * Domain:     conversions: below 2^31 in magnitude. Degrees: any finite ones.
 * Units:      angles in radians but where a name or a parameter says degrees.
 * Ownership:  plain values.
 * Errors:     none; min and max of a NaN and a number are the number, a clamped NaN is `low`.
 * Source:     The RISC-V Instruction Set Manual, volume I (20191213), section 11.6, for fmin.s and
 *             fmax.s; the rest is elementary.
 */
#ifndef ROMS_GEOMETRY_SCALAR_H
#define ROMS_GEOMETRY_SCALAR_H

#define PI     3.14159265f
#define TURN   6.28318531f   /* radians */
#define DEGREE (PI / 180.0f) /* radians */

#define SCALAR_INLINE static inline __attribute__((always_inline))

SCALAR_INLINE float scalar_max(float a, float b)
{
#ifdef __riscv_flen
    __asm__("fmax.s %0, %0, %1" : "+f"(a) : "f"(b));
    return a;
#else
    return __builtin_fmaxf(a, b);
#endif
}

SCALAR_INLINE float scalar_min(float a, float b)
{
#ifdef __riscv_flen
    __asm__("fmin.s %0, %0, %1" : "+f"(a) : "f"(b));
    return a;
#else
    return __builtin_fminf(a, b);
#endif
}

SCALAR_INLINE float scalar_clamp(float v, float low, float high)
{
    return scalar_min(scalar_max(v, low), high);
}

SCALAR_INLINE int scalar_max_int(int a, int b)
{
    return a > b ? a : b;
}

SCALAR_INLINE int scalar_min_int(int a, int b)
{
    return a < b ? a : b;
}

SCALAR_INLINE int scalar_clamp_int(int v, int low, int high)
{
    return v < low ? low : v > high ? high : v;
}

/* The greatest whole number that is not above v. */
SCALAR_INLINE int scalar_floor(float v)
{
    int whole = (int)v; /* toward 0 */
    return whole - (v < (float)whole);
}

/* The least whole number that is not below v. */
SCALAR_INLINE int scalar_ceil(float v)
{
    int whole = (int)v;
    return whole + ((float)whole < v);
}

/* The nearest whole number; a half goes up. */
SCALAR_INLINE int scalar_nearest(float v)
{
    return scalar_floor(v + 0.5f);
}

struct sine_cosine {
    float sine, cosine;
};

/* Of multiples of 90 degrees exactly 0, 1 and −1; no zero is negative. */
struct sine_cosine scalar_sine_cosine(float degrees);

#endif
