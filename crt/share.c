#include "crt/share.h"

#include <assert.h>

#include "crt/maths.h"

/* Terms decayed further than this are nothing: e^−60 = 9e-27. */
#define GONE 60.0

double crt_seconds(uint64_t a, uint64_t b)
{
    assert(b >= a);
    return (double)(b - a) * 1e-12;
}

void crt_share_add(struct crt_share *share, double amount, double tau_s)
{
    share->amount[share->terms] = amount;
    share->rate[share->terms++] = 1 / tau_s;
}

double crt_share_total(const struct crt_share *share)
{
    double total = 0;
    for (int k = 0; k < share->terms; k++)
        total += share->amount[k];
    return total;
}

/* e^(−x) averaged over x ± z, less the value in the middle, divided by that value: sinh(z)/z − 1.
 */
static double bulge(double z)
{
    double q = z * z;
    return q / 6 * (1 + q / 20 * (1 + q / 42));
}

/* The straight line's slope over the value in the middle: 3·(z·cosh z − sinh z)/z². */
static double line_slope(double z)
{
    double q = z * z;
    return z * (1 + q / 10 * (1 + q / 28));
}

static void add_slow_term(struct crt_share_fit *fit, bool within, double amount, double x, double z)
{
    double fading = crt_exp(-x), left = amount * fading, slope = left * line_slope(z);
    if (within) /* from the difference where that is good to 1e-12 */
        fit->mean += amount * (x > 1e-3 ? 1 - fading : -crt_expm1(-x)) - left * bulge(z);
    else
        fit->mean += left * (1 + bulge(z));
    fit->slope += within ? -slope : slope;
    fit->off_constant += left * z;
    fit->off_line += left * z * z / 3;
}

/* Decays a good deal within the stretch, which ends `x` time constants before ref. */
static void add_fast_term(struct crt_share_fit *fit, bool within, double amount, double x, double z)
{
    double end = x < GONE ? amount * crt_exp(-x) : 0, left = -end * crt_expm1(-2 * z) / (2 * z);
    fit->mean += within ? amount - left : left;
    fit->off_constant += end;
    fit->off_line += end;
}

struct crt_share_fit crt_share_over(const struct crt_share *share, uint64_t t0, uint64_t t1)
{
    struct crt_share_fit fit = {0};
    double half = crt_seconds(t0, t1) / 2, after = crt_seconds(t1, share->ref);
    for (int k = 0; k < share->terms; k++) {
        double z = half * share->rate[k], x = after * share->rate[k];
        if (z < 0.3)
            add_slow_term(&fit, share->within, share->amount[k], x + z, z);
        else
            add_fast_term(&fit, share->within, share->amount[k], x, z);
    }
    return fit;
}
