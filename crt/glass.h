/* glass.h — what a viewer sees: the film behind a curved faceplate, in GL 3.3 core.
 *
 *   film (float, per colour) ─▶ resample ─▶ mask ─▶ halation ─▶ face, room light ─▶ tone ─▶ sRGB ─▶ text
 *
 * The same code draws in a GLFW window and in an offscreen context. It creates no context and
 * touches no window system: the caller makes a context current and passes its loader.
 *
 * Models:
 * - Resampling: an exact copy at one cell a pixel; a cubic of four taps made for Gaussian spots
 *   when enlarging; the mean over each pixel's area when reducing.
 * - Curvature: a spherical face seen from far away. The picture keeps its scale at the centre;
 *   towards the rim millimetres are measured along the glass. A dark bezel with a soft edge.
 * - Mask: the light of each colour, on average unchanged, only where its phosphor is lit (crt/mask.h,
 *   with perfect landing, as film has what lands wrong), exactly over each pixel's square: a table of
 *   one period, made when the scale changes. Where the pattern's period is less than three pixels it
 *   fades, and below two nothing is left: finer ones would only give moiré. A screen of which a fifth
 *   is lit is five times as bright there, more than a picture can show: white comes out darker.
 * - Halation: light totally reflected at the front of the glass returns to the phosphor in a ring
 *   of radius 2·t·tan(asin(1/n)), 14 mm for t = 8 mm (estimate) and n = 1.52; here a Gaussian of
 *   the ring's second moment, sigma = 9.9 mm, computed at reduced size.
 * - Room light reflected by glass and phosphor: even; on a curved face also a lamp's soft glint
 *   (its place and strength are estimates).
 * - Tone curve, gamut desaturation and sRGB as in crt/develop.h.
 *
 * - Dither: where room or scattered light may show as rings, less than a step of 8 (or 16) bits
 *   either way, fixed to the pixels.
 *
 * Passes that are off cost nothing.
 * Units:      luminance cd/m²; pixels.
 * Ownership:  crt_glass_create allocates GL objects in the current context; destroy needs it
 *             current. Textures are kept from frame to frame.
 * Errors:     one sentence (missing GL function, shader or framebuffer trouble with the driver
 *             named). Functions that return nothing leave theirs to the next crt_glass_render.
 * Determinism: none, results vary with the GL driver: compare with tolerance. With every pass off
 *             and one cell a pixel it is crt_develop's picture within one step of 8 bits.
 * Not modelled: the dark centre of the halation ring, parallax of the glass's thickness.
 */
#ifndef CRT_GLASS_H
#define CRT_GLASS_H

#include <stdint.h>

#include "crt/develop.h"
#include "crt/image.h"
#include "crt/mask.h"
#include "crt/tube.h"

typedef void (*crt_gl_function)(void);
typedef crt_gl_function (*crt_gl_loader)(const char *name);

struct crt_glass_settings {
    double gain;           /* 1/(cd/m²), crt_auto_gain */
    double room_cd_m2;     /* luminance of the unlit screen in room light; 0 = dark room */
    double halation;       /* share of light scattered; 0 skips the pass */
    double face_radius_mm; /* 0 = flat, skips curvature */
    struct crt_mask mask;  /* crt_mask_init; kind none (all 0) skips it. Not for microscope films */
};

struct crt_glass;

struct crt_glass *crt_glass_create(crt_gl_loader loader, struct crt_error *err);
void crt_glass_destroy(struct crt_glass *glass);

/* "OSMesa / llvmpipe …": GL_RENDERER and GL_VERSION, for the status line. */
const char *crt_glass_driver(const struct crt_glass *glass);

/* Uploads a complete film; it may change or go afterwards. */
void crt_glass_film(struct crt_glass *glass, const struct crt_film *film,
                    const struct crt_phosphor *phosphor);

/* Text and marks drawn over the glass: RGBA, 8 bit, straight alpha, top row first, win_w × win_h;
 * NULL removes it. */
void crt_glass_overlay(struct crt_glass *glass, const uint8_t *rgba, int width, int height);

/* Where a window pixel (origin top left, y down, may be fractional) lies on the glass as
 * crt_glass_draw shows it, in tube millimetres. False off the screen and before the first film. */
bool crt_glass_pick(const struct crt_glass *glass, const struct crt_glass_settings *settings,
                    int width, int height, double x, double y, double *x_mm, double *y_mm);

/* Draws into framebuffer `fbo` (0 = the window) of width × height pixels, letterboxed. */
void crt_glass_draw(struct crt_glass *glass, const struct crt_glass_settings *settings,
                    unsigned fbo, int width, int height);

/* A part of framebuffer `fbo`, itself win_w × win_h pixels: x, y from its top left corner. */
struct crt_glass_part {
    int x, y, w, h;
    int win_w, win_h;
};

/* The same into a part alone; what is outside stays. Without the overlay. */
void crt_glass_draw_part(struct crt_glass *glass, const struct crt_glass_settings *settings,
                         unsigned fbo, const struct crt_glass_part *part);

/* All of `fbo` black, before the parts. */
void crt_glass_clear(struct crt_glass *glass, unsigned fbo, int width, int height);

/* The overlay alone, over whatever `fbo` shows. */
void crt_glass_draw_overlay(struct crt_glass *glass, unsigned fbo, int width, int height);

/* Draws into an offscreen framebuffer and reads it back as an 8- or 16-bit picture. */
bool crt_glass_render(struct crt_glass *glass, const struct crt_glass_settings *settings, int width,
                      int height, int depth, struct crt_image *out, struct crt_error *err);

#endif
