#include "crt/srgb.h"

#include <string.h>

#include "crt/maths.h"

void crt_srgb_of(struct crt_chromaticity c, double rgb[3])
{
    /* The inverse of the matrix whose columns are the primaries scaled to add up to D65. */
    static const double from_xyz[3][3] = {
        {3.2409699419045213, -1.5373831775700935, -0.4986107602930033},
        {-0.9692436362808798, 1.8759675015077206, 0.04155505740717561},
        {0.05563007969699361, -0.20397695888897657, 1.0569715142428786},
    };
    double x = c.x / c.y, z = (1.0 - c.x - c.y) / c.y;
    for (int i = 0; i < 3; i++)
        rgb[i] = from_xyz[i][0] * x + from_xyz[i][1] + from_xyz[i][2] * z;
}

double crt_srgb_luminance(const double rgb[3])
{
    return 0.21263900587151036 * rgb[0] + 0.7151686787677559 * rgb[1] +
           0.07219231536073371 * rgb[2];
}

double crt_srgb_encode_exact(double linear)
{
    if (!(linear > 0.0))
        return 0.0;
    if (linear >= 1.0)
        return 1.0;
    if (linear <= 0.0031308)
        return 12.92 * linear;
    return 1.055 * crt_pow(linear, 1.0 / 2.4) - 0.055;
}

static double knot(int i)
{
    uint64_t bits = CRT_SRGB_FIRST_KNOT + ((uint64_t)i << CRT_SRGB_KNOT_SHIFT);
    double linear;
    memcpy(&linear, &bits, sizeof linear);
    return linear;
}

void crt_srgb_encoder_init(struct crt_srgb_encoder *encoder)
{
    for (int i = 0; i < CRT_SRGB_KNOTS - 1; i++) {
        double a = knot(i), b = knot(i + 1);
        double at_a = crt_srgb_encode_exact(a), at_b = crt_srgb_encode_exact(b);
        encoder->line[i].slope = (at_b - at_a) / (b - a);
        encoder->line[i].at_zero = at_a - encoder->line[i].slope * a;
    }
    encoder->line[CRT_SRGB_KNOTS - 1].slope = 0.0;
    encoder->line[CRT_SRGB_KNOTS - 1].at_zero = 1.0;
}
