/* rv_float_convert.c — between singles and 32-bit integers. */
#include "emu/cpu/rv_float.h"

#include "emu/cpu/rv_float_parts.h"

/* Bits behind the binary point while a number is rounded to an integer: 2^32 still fits before it. */
enum { FRACTION = 30 };

struct limits {
    uint64_t negative, positive; /* greatest magnitudes with either sign */
};

static const struct limits SIGNED = {UINT64_C(1) << 31, (UINT64_C(1) << 31) - 1};
static const struct limits UNSIGNED = {0, (UINT64_C(1) << 32) - 1};

static uint32_t with_sign(bool sign, uint64_t magnitude)
{
    return (uint32_t)(sign ? 0 - magnitude : magnitude);
}

/* Out of range after rounding: the nearest limit, RV_NV and not RV_NX. A NaN counts as positive. */
static uint32_t to_integer(uint32_t a, const struct limits *limits, unsigned rm, uint32_t *flags)
{
    bool sign = rv_is_negative(a) && !rv_is_nan(a);
    uint64_t limit = sign ? limits->negative : limits->positive;
    uint64_t magnitude = UINT64_MAX;
    bool inexact = false;

    if (!rv_is_nan(a) && !rv_is_infinite(a)) {
        struct rv_unpacked p = rv_unpack(a);
        int distance = 62 - FRACTION - p.exponent;
        if (distance > 0) /* else it is 2^32 or more */
            magnitude = rv_round_off(rv_shift_sticky(p.significand, distance), FRACTION, sign, rm,
                                     &inexact);
    }
    if (magnitude > limit) {
        *flags |= RV_NV;
        return with_sign(sign, limit);
    }
    if (inexact)
        *flags |= RV_NX;
    return with_sign(sign, magnitude);
}

uint32_t rv_fcvt_w(uint32_t a, unsigned rm, uint32_t *flags)
{
    return to_integer(a, &SIGNED, rm, flags);
}

uint32_t rv_fcvt_wu(uint32_t a, unsigned rm, uint32_t *flags)
{
    return to_integer(a, &UNSIGNED, rm, flags);
}

uint32_t rv_fcvt_from_w(uint32_t a, unsigned rm, uint32_t *flags)
{
    bool sign = (a & RV_SIGN) != 0;
    struct rv_unpacked p = {.sign = sign, .exponent = 62, .significand = sign ? 0 - a : a};
    return rv_pack(p, rm, flags);
}

uint32_t rv_fcvt_from_wu(uint32_t a, unsigned rm, uint32_t *flags)
{
    struct rv_unpacked p = {.exponent = 62, .significand = a};
    return rv_pack(p, rm, flags);
}
