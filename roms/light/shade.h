/* shade.h — triangles of a lit surface into a canvas with a depth buffer: four shadings.
 *
 *      flat        one intensity a triangle                       ▒▒▓▓██  facets
 *      Gouraud     an intensity a corner, interpolated            ░▒▒▓▓█  Mach bands, stars
 *      Phong       a normal a corner, interpolated, light a pixel ░▒▓█▓▒  highlights
 *      fast Phong  the same by a polynomial of second degree      ░▒▓█▓▒  for small angles
 *
 * Models:     what a polygon renderer does after projection; larger z is nearer. Intensity 0…1
 *             becomes one of the levels of a ramp, the nearest: 8-bit pixels are `first` + level,
 *             32-bit ones colours[level].
 * Cost:       instructions a pixel that is drawn, over triangles of about 150 pixels, vertices and
 *             rows included: flat 14, Gouraud 16, fast Phong 33, Phong 40 with one light and eye at
 *             infinity (Phong with a light at a place 280); of these 7, 9, 18 and 25 are the
 *             pixel's own, 36…100 a row's, 200…450 a triangle's. Measured:
 *             tests/roms/check_light.c; the command `shade` tells it for any solid.
 * Domain:     canvases of 8 or 32 bits and depth buffers of their size; up to 256 levels; corners
 *             as in triangle.h. Both sides of a triangle are drawn: leave out those that turn their
 *             back before.
 * Units:      pixels; intensities 0…1, linear.
 * Ownership:  plain value; canvas, depth buffer, lights and table must outlive it.
 * Errors:     none: a canvas of another format, or without its depth buffer, takes everything and
 *             keeps nothing.
 * Source:     H. Gouraud, IEEE Trans. Computers C-20 (1971) 623; Bui Tuong Phong, CACM 18 (1975)
 *             311; G. Bishop, D. M. Weimer, Fast Phong Shading, Computer Graphics 20 (1986) 103.
 * Not modelled: colours of surfaces that differ within a triangle, textures.
 */
#ifndef ROMS_LIGHT_SHADE_H
#define ROMS_LIGHT_SHADE_H

#include "roms/geometry/scalar.h"
#include "roms/light/illumination.h"
#include "roms/light/power.h"
#include "roms/light/triangle.h"
#include "roms/raster/canvas.h"
#include "roms/visible/depth_buffer.h"

enum shading { SHADE_FLAT, SHADE_GOURAUD, SHADE_PHONG, SHADE_FAST_PHONG, SHADINGS };
enum { SHADE_LEVELS = 256 };

extern const char *const shading_names[]; /* ends with NULL */

struct shade {
    /* Where to. */
    uint8_t *pixels;
    uint32_t pitch;
    float *depth;
    int width, height;
    unsigned bits;
    float first, scale;      /* pixel value = whole part of first + intensity * scale */
    float top;               /* the largest of them */
    const uint32_t *colours; /* for 32 bits */
    /* What. */
    const struct lighting *lighting;
    const struct material *material;
    const struct power_table *power; /* of the material's n; for Phong and fast Phong */
    /* What was done. */
    uint32_t triangles, covered; /* covered: pixels that were compared with the depth buffer */
};

/* Entries first … first + levels - 1 of a look-up table. */
struct shade shade_begin(const struct canvas *canvas, const struct depth_buffer *depth,
                         uint32_t first, int levels);
/* Pixels of 32 bits: `levels` colours. */
struct shade shade_begin_colours(const struct canvas *canvas, const struct depth_buffer *depth,
                                 const uint32_t *colours, int levels);

/* With one intensity; with those of the corners; with their normals. */
void shade_flat(struct shade *s, float intensity, const struct shade_vertex *a,
                const struct shade_vertex *b, const struct shade_vertex *c);
void shade_gouraud(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                   const struct shade_vertex *c);
void shade_phong(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                 const struct shade_vertex *c);
void shade_fast_phong(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                      const struct shade_vertex *c);

/* The value of a pixel with that intensity. */
static inline uint32_t shade_pixel(const struct shade *s, float intensity)
{
    float v = scalar_clamp(fmaf(intensity, s->scale, s->first), s->first, s->top);
    return s->bits == 32 ? s->colours[(int)v] : (uint32_t)v;
}

#endif
