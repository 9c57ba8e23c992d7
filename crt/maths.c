#include "crt/maths.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* ---- pairs of doubles: a value as hi + lo, |lo| <= half an ulp of hi (Dekker 1971) ---------- */

struct pair {
    double hi, lo;
};

/* a + b exactly, for any order of magnitudes. */
static struct pair sum2(double a, double b)
{
    double s = a + b, bb = s - a;
    return (struct pair){s, (a - (s - bb)) + (b - bb)};
}

/* The upper 26 bits of a; |a| must stay below 2^996. */
static double upper(double a)
{
    double c = 134217729.0 * a; /* 2^27 + 1 */
    return c - (c - a);
}

/* a · b exactly, barring underflow. */
static struct pair product2(double a, double b)
{
    double p = a * b, ah = upper(a), bh = upper(b), al = a - ah, bl = b - bh;
    return (struct pair){p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

static struct pair pair_add(struct pair a, struct pair b)
{
    struct pair s = sum2(a.hi, b.hi);
    return sum2(s.hi, s.lo + (a.lo + b.lo));
}

static struct pair pair_mul(struct pair a, struct pair b)
{
    struct pair p = product2(a.hi, b.hi);
    return sum2(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* ---- exp and expm1 --------------------------------------------------------------------------- */

#define LN2_HI  0x1.62e42fee00000p-1 /* ln 2, its upper 32 bits: k·LN2_HI is exact */
#define LN2_LO  0x1.a39ef35793c76p-33
#define INV_LN2 0x1.71547652b82fep+0

/* 2^k for -1022 <= k <= 1023. */
static double power_of_two(int k)
{
    uint64_t bits = (uint64_t)(k + 1023) << 52;
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* x · 2^k, -1100 < k < 1100, rounded once when the result is subnormal. */
static double scale(double x, int k)
{
    if (k > 1000)
        return x * 0x1p1000 * power_of_two(k - 1000);
    if (k < -1000)
        return x * power_of_two(k + 600) * 0x1p-600;
    return x * power_of_two(k);
}

/* x = k·ln 2 + r with |r| <= ln 2 / 2. */
static int reduce_by_ln2(double x, double *r)
{
    double k = floor(x * INV_LN2 + 0.5);
    *r = (x - k * LN2_HI) - k * LN2_LO;
    return (int)k;
}

/* e^r − 1 for |r| <= 0.35: Taylor, first term left out below 1e-17 of the value. */
static double expm1_small(double r)
{
    static const double c[] = {1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800,
                               1.0 / 362880,     1.0 / 40320,     1.0 / 5040,     1.0 / 720,
                               1.0 / 120,        1.0 / 24,        1.0 / 6,        1.0 / 2};
    double p = 1.0 / 87178291200;
    for (unsigned i = 0; i < sizeof c / sizeof c[0]; i++)
        p = p * r + c[i];
    return r + r * r * p;
}

double crt_exp(double x)
{
    if (isnan(x))
        return x;
    if (x > 709.79)
        return INFINITY;
    if (x < -745.2)
        return 0;
    double r;
    int k = reduce_by_ln2(x, &r);
    return scale(1 + expm1_small(r), k);
}

double crt_expm1(double x)
{
    if (isnan(x))
        return x;
    if (x > 709.79)
        return INFINITY;
    if (x < -40)
        return -1;
    if (fabs(x) < 1e-300)
        return x;
    double r;
    int k = reduce_by_ln2(x, &r);
    double e = expm1_small(r);
    if (k == 0)
        return e;
    if (k > 60)
        return scale(1 + e, k);
    return (power_of_two(k) - 1) + e * power_of_two(k);
}

/* e^(hi + lo) for a small lo. */
static double exp_pair(struct pair x)
{
    double e = crt_exp(x.hi);
    return isinf(e) || e == 0 ? e : e + e * x.lo;
}

/* ---- log and pow ----------------------------------------------------------------------------- */

/* x = m·2^e with sqrt(1/2) <= m < sqrt(2); x positive and finite. */
static double split_exponent(double x, int *e)
{
    int extra = 0;
    if (x < 0x1p-1022) {
        x *= 0x1p54;
        extra = -54;
    }
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    *e = (int)(bits >> 52) - 1023 + extra;
    bits = (bits & 0xfffffffffffff) | UINT64_C(0x3ff) << 52;
    double m;
    memcpy(&m, &bits, sizeof m);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        *e += 1;
    }
    return m;
}

/* ln x to about 1e-19 of its value; x positive and finite. ln m = 2s·(1 + s²/3 + s⁴/5 + …) with
 * s = (m−1)/(m+1), |s| < 0.172; all but the last, small part in pairs. */
static struct pair log_pair(double x)
{
    int e;
    double m = split_exponent(x, &e), num = m - 1;
    struct pair den = sum2(m, 1);
    double s_hi = num / den.hi;
    struct pair back = product2(s_hi, den.hi);
    double s_lo = (((num - back.hi) - back.lo) - s_hi * den.lo) / den.hi;
    struct pair s = {s_hi, s_lo};
    struct pair z = pair_mul(s, s);
    double q = 0;
    for (int n = 25; n >= 5; n -= 2)
        q = q * z.hi + 1.0 / n;
    struct pair tail = pair_mul(z, (struct pair){0x1.5555555555555p-2, 0x1.5555555555555p-56});
    tail = pair_add(tail, (struct pair){z.hi * z.hi * q, 0});
    struct pair twice_s = {2 * s.hi, 2 * s.lo};
    struct pair ln_m = pair_add(twice_s, pair_mul(twice_s, tail));
    return pair_add(sum2(e * LN2_HI, e * LN2_LO), ln_m);
}

double crt_log(double x)
{
    if (isnan(x) || x < 0)
        return NAN;
    if (x == 0)
        return -INFINITY;
    if (isinf(x))
        return x;
    return log_pair(x).hi;
}

double crt_pow(double x, double y)
{
    if (y == 0 || x == 1)
        return 1;
    if (isnan(x) || isnan(y) || x < 0)
        return NAN;
    if (x == 0)
        return y > 0 ? 0 : INFINITY;
    if (isinf(x))
        return y > 0 ? INFINITY : 0;
    if (isinf(y))
        return (x > 1) == (y > 0) ? INFINITY : 0;
    struct pair l = log_pair(x);
    double rough = y * l.hi;
    if (fabs(rough) > 800)
        return rough > 0 ? INFINITY : 0;
    struct pair p = product2(l.hi, y);
    return exp_pair(sum2(p.hi, p.lo + l.lo * y));
}

/* ---- erf and erfcx --------------------------------------------------------------------------- */

#define TWO_BY_SQRT_PI 0x1.20dd750429b6dp+0
#define ONE_BY_SQRT_PI 0x1.20dd750429b6dp-1

/* (1 + 2x)·e^(x²)·erfc(x) for x >= 0 as a Chebyshev series in t = (x − 3.75)/(x + 3.75), the form
 * of Shepherd and Laframboise (Math. Comp. 36, 1981); coefficients computed to 60 digits. */
static double erfcx_positive(double x)
{
    static const double c[] = {
        1.1775789345674017541,      -0.0045900545806464773309,  -0.084249133366517915584,
        0.059209939998191890498,    -0.026658668435305752277,   0.0090749976707052650939,
        -0.0024131635404176081909,  0.00049077583652580863229,  -0.000069169733025012063671,
        4.1390279860730101675e-6,   7.7403830661984906686e-7,   -2.1886401049234395661e-7,
        1.0764999465670910377e-8,   4.5219598112182868979e-9,   -7.7544002088313511065e-10,
        -6.3180883408866844944e-11, 2.8687950109306698981e-11,  1.945586854577734723e-13,
        -9.6546967484334389059e-13, 3.2525481481487398415e-14,  3.3478119482868053878e-14,
        -1.8645628804193131015e-15, -1.2507950530688647085e-15, 7.418235256624043463e-17,
        5.0681489047961113168e-17};
    if (x > 1e9) /* the next term of the asymptotic series is below 1e-18; x may be infinite */
        return ONE_BY_SQRT_PI / x;
    double t = 1 - 7.5 / (x + 3.75), b1 = 0, b2 = 0;
    for (int j = (int)(sizeof c / sizeof c[0]) - 1; j > 0; j--) { /* Clenshaw */
        double b = 2 * t * b1 - b2 + c[j];
        b2 = b1;
        b1 = b;
    }
    return (t * b1 - b2 + c[0]) / (1 + 2 * x);
}

double crt_erfcx(double x)
{
    if (isnan(x))
        return x;
    if (x >= 0)
        return erfcx_positive(x);
    if (x < -27)
        return INFINITY;
    return 2 * exp_pair(product2(x, x)) - erfcx_positive(-x);
}

double crt_erf(double x)
{
    if (isnan(x))
        return x;
    double a = fabs(x);
    if (a > 6)
        return x > 0 ? 1 : -1;
    if (a > 1) {
        double e = 1 - crt_exp(-(a * a)) * erfcx_positive(a);
        return x > 0 ? e : -e;
    }
    /* 2/√π · Σ (−1)ⁿ x^(2n+1) / (n!·(2n+1)), n <= 17. */
    static const double factorial[] = {1,
                                       1,
                                       2,
                                       6,
                                       24,
                                       120,
                                       720,
                                       5040,
                                       40320,
                                       362880,
                                       3628800,
                                       39916800,
                                       479001600,
                                       6227020800,
                                       87178291200,
                                       1307674368000,
                                       20922789888000,
                                       355687428096000};
    double z = x * x, p = 0;
    for (int n = 17; n >= 1; n--)
        p = (p + (n & 1 ? -1 : 1) / (factorial[n] * (2 * n + 1))) * z;
    return TWO_BY_SQRT_PI * (x + x * p);
}

/* ---- sin and cos ----------------------------------------------------------------------------- */

/* x = n·π/2 + r, |r| <= π/4; returns n mod 4. π/2 in three parts, the first two of 33 bits, so that
 * n times each is exact for |n| < 2^20. */
static int reduce_by_half_pi(double x, double *r)
{
    if (fabs(x) > 1e5) /* outside the stated domain: some angle, at least a bounded result */
        x = fmod(x, 6.283185307179586);
    double n = floor(x * 0x1.45f306dc9c883p-1 + 0.5);
    *r = ((x - n * 0x1.921fb54400000p+0) - n * 0x1.0b4611a600000p-34) - n * 0x1.3198a2e037073p-69;
    return (int)n & 3;
}

static double sin_small(double r)
{
    double z = r * r, p = 0;
    static const double c[] = {
        -1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800, 1.0 / 362880,
        -1.0 / 5040,          1.0 / 120,        -1.0 / 6};
    for (unsigned i = 0; i < sizeof c / sizeof c[0]; i++)
        p = p * z + c[i];
    return r + r * z * p;
}

static double cos_small(double r)
{
    double z = r * r, p = 0;
    static const double c[] = {
        1.0 / 20922789888000, -1.0 / 87178291200, 1.0 / 479001600, -1.0 / 3628800,
        1.0 / 40320,          -1.0 / 720,         1.0 / 24,        -1.0 / 2};
    for (unsigned i = 0; i < sizeof c / sizeof c[0]; i++)
        p = p * z + c[i];
    return 1 + z * p;
}

static double sin_of_quadrant(double r, int quadrant)
{
    double s = quadrant & 1 ? cos_small(r) : sin_small(r);
    return quadrant & 2 ? -s : s;
}

double crt_sin(double radians)
{
    if (isnan(radians) || isinf(radians))
        return NAN;
    double r;
    int n = reduce_by_half_pi(radians, &r);
    return sin_of_quadrant(r, n);
}

double crt_cos(double radians)
{
    if (isnan(radians) || isinf(radians))
        return NAN;
    double r;
    int n = reduce_by_half_pi(radians, &r);
    return sin_of_quadrant(r, (n + 1) & 3);
}
