/* text_antialiased.h — text smaller than its font, in shades.
 *
 *      ▓▓▒░    a pixel is as dark as the dots of the font cover it; cells of any size, at any place
 *      ▓░▒▓
 *
 * Models:     the font of font.h, each dot a rectangle, seen through a box as wide as a pixel.
 * Cost:       a character of 4 by 7 pixels about 4000 instructions, of 8 by 12 about 7000; when
 *             kept, 400 and 1000.
 * Domain:     cells from 2 by 3 pixels up to 16 times the font's; beyond nothing is drawn.
 * Units:      pixels of the canvas; a pixel's upper left corner is a whole number.
 * Ownership:  the ramp is the caller's.
 * Errors:     none; what lies outside the canvas is left out; a ramp of fewer than 2 values draws
 *             nothing.
 * Source:     E. Catmull, A Hidden-Surface Algorithm with Anti-Aliasing, Computer Graphics 12
 *             (SIGGRAPH 1978) 6, for the box.
 * Not modelled: what was there: the ramp's first value is the ground's, and is not drawn.
 */
#ifndef ROMS_RASTER_TEXT_ANTIALIASED_H
#define ROMS_RASTER_TEXT_ANTIALIASED_H

#include <stdbool.h>

#include "roms/raster/canvas.h"

/* Upper left corner of the first cell, and a cell's size. */
void canvas_text_antialiased(const struct canvas *c, float x, float y, float width, float height,
                             const uint32_t *ramp, int levels, const char *text);

/* ---- characters that are kept: for pages of text --------------------------------------------- */

enum { TEXT_SHADES_WIDTH = 16, TEXT_SHADES_HEIGHT = 24, TEXT_SHADES_CODES = 128 };

/* Characters of one size as they were drawn: 48 KiB. All 0 at first. */
struct text_shades {
    float width, height; /* of a cell */
    const uint32_t *ramp;
    int levels;
    bool known[TEXT_SHADES_CODES];
    uint8_t glyph[TEXT_SHADES_CODES][TEXT_SHADES_WIDTH * TEXT_SHADES_HEIGHT];
};

/* Whether a cell is neither too small nor too large to be kept. */
bool text_shades_fit(float width, float height);
/* For this size and ramp; what was kept for another one is forgotten. */
void text_shades_begin(struct text_shades *shades, float width, float height, const uint32_t *ramp,
                       int levels);
/* Each character begins at the nearest pixel. Pixels of 8 bits only. */
void canvas_text_shades(const struct canvas *c, struct text_shades *shades, float x, float y,
                        const char *text);

#endif
