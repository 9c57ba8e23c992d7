/* srgb.h — the sRGB colour space: chromaticity to linear RGB, linear light to encoded samples.
 *
 *      xyY ──matrix──▶ linear R,G,B 0…1 ──encode──▶ 0…1 ──× 255 or 65535, + ½, floor──▶ sample
 *
 * Models:     IEC 61966-2-1. The matrix is the one that follows from its primaries (x,y) and white
 *             D65 (0.3127, 0.3290) in exact arithmetic, not the standard's table of four digits.
 * Method:     encoding is *defined* as the table of struct crt_srgb_encoder: 128 knots an octave
 *             from 2^-9 to 1, straight lines between them (less than 0.1 of a 16-bit step below the
 *             standard's curve), and 12.92·v below. So it is fast, continuous and increasing.
 * Determinism: + − × ÷ and crt/maths.h only.
 * Errors:     none; a value outside 0…1 is brought to the nearer end, NaN to 0.
 */
#ifndef CRT_SRGB_H
#define CRT_SRGB_H

#include <stdint.h>
#include <string.h>

#include "crt/phosphor.h"

/* D65, the white of sRGB. */
#define CRT_D65_X 0.3127
#define CRT_D65_Y 0.3290

/* Linear sRGB of a colour at luminance 1 (white = 1); channels may be negative or exceed 1. The
 * luminance 0.2126·R + 0.7152·G + 0.0722·B (to four digits) of the result is 1. c.y > 0. */
void crt_srgb_of(struct crt_chromaticity c, double rgb[3]);

/* Luminance (white = 1) of linear sRGB. */
double crt_srgb_luminance(const double rgb[3]);

/* The standard's curve itself: linear light 0…1 to encoded 0…1. Slow; the tables are made of it. */
double crt_srgb_encode_exact(double linear);

#define CRT_SRGB_KNOT_BITS  7 /* 2^7 knots an octave */
#define CRT_SRGB_OCTAVES    9 /* from 2^-9, below which the curve is straight (up to 0.0031308) */
#define CRT_SRGB_FIRST_KNOT UINT64_C(0x3f60000000000000) /* 2^-9 as an IEEE 754 double */
#define CRT_SRGB_KNOT_SHIFT (52 - CRT_SRGB_KNOT_BITS)
#define CRT_SRGB_KNOTS      ((CRT_SRGB_OCTAVES << CRT_SRGB_KNOT_BITS) + 1)

struct crt_srgb_encoder {
    struct {
        double at_zero, slope; /* encoded = at_zero + slope·linear between this knot and the next */
    } line[CRT_SRGB_KNOTS];
};
void crt_srgb_encoder_init(struct crt_srgb_encoder *encoder);

/* Linear light to a sample 0…max, halves rounded up. */
static inline uint16_t crt_srgb_sample(const struct crt_srgb_encoder *encoder, double linear,
                                       double max)
{
    if (!(linear > 0.0))
        return 0;
    if (linear >= 1.0)
        return (uint16_t)max;
    double encoded = 12.92 * linear;
    if (linear >= 0x1p-9) {
        /* Equal steps of the bits of a double are equal steps within each octave. */
        uint64_t bits;
        memcpy(&bits, &linear, sizeof bits);
        unsigned i = (unsigned)((bits - CRT_SRGB_FIRST_KNOT) >> CRT_SRGB_KNOT_SHIFT);
        encoded = encoder->line[i].at_zero + encoder->line[i].slope * linear;
    }
    return (uint16_t)(encoded * max + 0.5);
}

#endif
