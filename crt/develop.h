/* develop.h — film to picture: linear light to sRGB samples through one tone curve.
 *
 *      light [cd·s/m²] ─÷ exposure─▶ cd/m² per colour ─▶ Y, x,y ─▶ Y·gain ─tone─▶ Y'
 *                       Y', x,y ─(desaturated toward D65 until it fits)─▶ linear sRGB
 *
 * Models:     tone(v): the identity to CRT_TONE_SHOULDER; above, with u = (v − shoulder)/(1 −
 *             shoulder) and U the u of CRT_TONE_MAX,
 *                 tone = shoulder + (1 − shoulder)·U·u / (U + (U − 1)·u),
 *             a hyperbola that leaves with slope 1 and reaches 1, flat to 1e-5, at CRT_TONE_MAX;
 *             1 beyond. Tabulated once; the same table serves the film picture (here) and the
 *             glass (as a texture). The XYZ of a phosphor of several colours are the sums of
 *             its colours'.
 * Gamut:      the linear sRGB of a colour at luminance y is y·(1 + e), e = crt_hue.e. It is mixed
 *             with D65 at constant luminance, y + chroma·e; nothing is clipped channel by channel.
 *             First chroma is held to where no channel falls below 0; then, so that none exceeds
 *             1, rise (what the strongest channel gains) and room (1 − y) give
 *                 chroma ← chroma/√(1 + (rise/room)²).
 *             This is smooth in y. The greatest chroma that fits would leave a hard ring around
 *             bright points, and make full-drive lines (0.8 of white, where a full green is
 *             0.715) rows of white beads. The price: a colour that would just fit keeps 0.71 of
 *             its chroma, one that fills a tenth of its room 0.995. No channel falls as y rises.
 * Units:      gain is 1/(cd/m²): relative luminance = gain · luminance; `auto` gain maps the
 *             row's line_luminance (of raster tubes field_luminance) to 0.8 of white whatever the
 *             exposure.
 * Rounding:   samples as defined in crt/srgb.h (halves up); row 0 of the picture is row 0 of the
 *             film.
 * Determinism: only + − × ÷ √ and crt/maths.h; every pixel by itself, so the same samples for any
 *             number of threads.
 * Errors:     out of memory and impossible sizes give a sentence. Light below 0 or NaN counts
 *             as 0.
 * Not modelled: the eye's adaptation, and its loss of colour at low luminance.
 */
#ifndef CRT_DEVELOP_H
#define CRT_DEVELOP_H

#include "crt/image.h"
#include "crt/tube.h"

#define CRT_TONE_SIZE 1024
#define CRT_TONE_MAX  64.0 /* relative luminance at the end of the table */
#define CRT_TONE_KNEE 115  /* the entry at which the shoulder begins */

/* 0.809: the entry next above 0.8, where `auto` gain puts a full-drive line, so that the picture is
 * linear up to there. */
#define CRT_TONE_SHOULDER                                                                          \
    (CRT_TONE_MAX * CRT_TONE_KNEE * CRT_TONE_KNEE / ((CRT_TONE_SIZE - 1.0) * (CRT_TONE_SIZE - 1.0)))

/* tone[i] is the display luminance of relative luminance v(i); v is quadratic in i:
 * v(i) = CRT_TONE_MAX·(i/(CRT_TONE_SIZE−1))². Linear interpolation in v between entries:
 * t = v·(CRT_TONE_SIZE−1)²/CRT_TONE_MAX, i = floor(√t), fraction (t − i²)/(2i + 1).
 * Up to the shoulder the entries are v itself, so it may be returned without looking. */
struct crt_tone {
    float curve[CRT_TONE_SIZE];
};
void crt_tone_init(struct crt_tone *tone);
double crt_tone_at(const struct crt_tone *tone, double v);

/* What `auto` gain shows at 0.8 of white: a full-drive line, or field, cd/m². */
double crt_full_luminance(const struct crt_tube_row *row);
double crt_auto_gain(const struct crt_tube_row *row);

/* A colour as the way from D65 to it, at luminance 1 in linear sRGB. */
struct crt_hue {
    double e[3]; /* linear sRGB of the colour minus that of D65 (1, 1, 1) */
    double keep; /* min(1, 1/max(−e)): how far toward the colour before a channel falls below 0 */
    double high; /* max(e) */
};
struct crt_hue crt_hue_of(struct crt_chromaticity c);

/* The hue of two lights that shine together; share of the luminance is b's, 0…1. */
struct crt_hue crt_hue_mix(const struct crt_hue *a, const struct crt_hue *b, double share);

/* Linear sRGB of display luminance y (brought into 0…1), desaturated to fit 0…1:
 *      chroma = y·keep;  rise = chroma·high;  room = 1 − y;
 *      if (rise > 0) chroma = chroma·room/√(room² + rise²);  rgb = y + chroma·e. */
void crt_fit_hue(double y, const struct crt_hue *hue, double rgb[3]);

/* The same for a chromaticity. */
void crt_fit_srgb(double y, struct crt_chromaticity c, double rgb[3]);

/* colour[i] is the chromaticity of film->light[i]. `depth` is 8 or 16. `out` need not be
 * initialised; the caller frees it. */
bool crt_develop(const struct crt_film *film, const struct crt_phosphor *phosphor, double gain,
                 int depth, int threads, struct crt_image *out, struct crt_error *err);

#endif
