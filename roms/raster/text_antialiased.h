/* text_antialiased.h — text smaller than its font, in shades.
 *
 *      ▓▓▒░    a pixel is as dark as the dots of the font cover it; cells of any size, at any place
 *      ▓░▒▓
 *
 * Models:     the font of font.h, each dot a rectangle, seen through a box as wide as a pixel.
 * Cost:       a character of 4 by 7 pixels about 1600 instructions; of 8 by 12 about 2500.
 * Domain:     cells from 2 by 3 pixels up to 16 times the font's; beyond nothing is drawn.
 * Units:      pixels of the canvas; a pixel's upper left corner is a whole number.
 * Ownership:  the ramp is the caller's.
 * Errors:     none; what lies outside the canvas is left out; a ramp of fewer than 2 values draws nothing.
 * Source:     E. Catmull, A Hidden-Surface Algorithm with Anti-Aliasing, Computer Graphics 12 (SIGGRAPH
 *             1978) 6, for the box.
 * Not modelled: what was there: the ramp's first value is the ground's, and is not drawn.
 */
#ifndef ROMS_RASTER_TEXT_ANTIALIASED_H
#define ROMS_RASTER_TEXT_ANTIALIASED_H

#include "roms/raster/canvas.h"

/* Upper left corner of the first cell, and a cell's size. */
void canvas_text_antialiased(const struct canvas *c, float x, float y, float width, float height,
                             const uint32_t *ramp, int levels, const char *text);

#endif
