/* rv_float_compare.c — order, choice and class: nothing here rounds. */
#include "emu/cpu/rv_float.h"

#include "emu/cpu/rv_float_parts.h"

/* Orders the bits of what is no NaN as the numbers are, −0 just below +0. */
static int32_t key(uint32_t a)
{
    int32_t magnitude = (int32_t)(a & ~RV_SIGN);
    return rv_is_negative(a) ? -1 - magnitude : magnitude;
}

/* a < b as numbers: zeros are equal. */
static bool less(uint32_t a, uint32_t b)
{
    return key(a) < key(b) && !(rv_is_zero(a) && rv_is_zero(b));
}

static bool equal(uint32_t a, uint32_t b)
{
    return a == b || (rv_is_zero(a) && rv_is_zero(b));
}

/* True when there is a NaN; raises RV_NV for a signalling one, or for any. */
static bool unordered(uint32_t a, uint32_t b, bool any, uint32_t *flags)
{
    bool nan = rv_is_nan(a) || rv_is_nan(b);

    if (rv_is_signalling(a) || rv_is_signalling(b) || (nan && any))
        *flags |= RV_NV;
    return nan;
}

/* minimumNumber and maximumNumber: the operand that is a number wins. */
static uint32_t choose(uint32_t a, uint32_t b, bool greater, uint32_t *flags)
{
    if (unordered(a, b, false, flags)) {
        if (!rv_is_nan(a))
            return a;
        return rv_is_nan(b) ? RV_NAN : b;
    }
    return (key(a) > key(b)) == greater ? a : b;
}

uint32_t rv_fmin(uint32_t a, uint32_t b, uint32_t *flags)
{
    return choose(a, b, false, flags);
}

uint32_t rv_fmax(uint32_t a, uint32_t b, uint32_t *flags)
{
    return choose(a, b, true, flags);
}

uint32_t rv_feq(uint32_t a, uint32_t b, uint32_t *flags)
{
    return !unordered(a, b, false, flags) && equal(a, b);
}

uint32_t rv_flt(uint32_t a, uint32_t b, uint32_t *flags)
{
    return !unordered(a, b, true, flags) && less(a, b);
}

uint32_t rv_fle(uint32_t a, uint32_t b, uint32_t *flags)
{
    return !unordered(a, b, true, flags) && (less(a, b) || equal(a, b));
}

/* Bits 0 to 7 from −∞ up to +∞, then the NaNs. */
uint32_t rv_fclass(uint32_t a)
{
    bool sign = rv_is_negative(a);

    if (rv_is_nan(a))
        return rv_is_signalling(a) ? 1u << 8 : 1u << 9;
    if (rv_is_infinite(a))
        return sign ? 1u << 0 : 1u << 7;
    if (rv_is_zero(a))
        return sign ? 1u << 3 : 1u << 4;
    if ((a & RV_INFINITY) == 0)
        return sign ? 1u << 2 : 1u << 5;
    return sign ? 1u << 1 : 1u << 6;
}
