/* develop.h — film to picture: linear light to sRGB samples through one tone curve.
 *
 *      light [cd·s/m²] ─÷ exposure─▶ cd/m² per colour ─▶ Y, x,y ─▶ Y·gain ─tone─▶ Y' ─▶ linear sRGB
 *                                                              (desaturated toward D65 until it fits)
 *
 * Models:     tone(v): linear to a shoulder that approaches 1; tabulated once, the same table serves the
 *             film picture (here) and the glass (as a texture). Colours outside sRGB are mixed
 *             with D65 at constant luminance until they fit; nothing is clipped channel by channel.
 * Units:      gain is 1/(cd/m²): relative luminance = gain · luminance; `auto` gain maps the row's
 *             line_luminance to 0.8 of white whatever the exposure.
 * Determinism: only + − × ÷ √ and crt/maths.h.
 */
#ifndef CRT_DEVELOP_H
#define CRT_DEVELOP_H

#include "crt/image.h"
#include "crt/tube.h"

#define CRT_TONE_SIZE 1024
#define CRT_TONE_MAX  64.0 /* relative luminance at the end of the table */

/* tone[i] is the display luminance of relative luminance v(i); v is quadratic in i:
 * v(i) = CRT_TONE_MAX·(i/(CRT_TONE_SIZE−1))². Linear interpolation between entries. */
struct crt_tone {
    float curve[CRT_TONE_SIZE];
};
void crt_tone_init(struct crt_tone *tone);
double crt_tone_at(const struct crt_tone *tone, double v);

double crt_auto_gain(const struct crt_tube_row *row);

/* Linear sRGB of display luminance y and chromaticity, desaturated to fit 0…1. */
void crt_fit_srgb(double y, struct crt_chromaticity c, double rgb[3]);

/* colour[i] is the chromaticity of film->light[i]. `depth` is 8 or 16. */
bool crt_develop(const struct crt_film *film, const struct crt_phosphor *phosphor, double gain,
                 int depth, int threads, struct crt_image *out, struct crt_error *err);

#endif
