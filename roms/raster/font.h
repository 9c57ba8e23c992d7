/* font.h — characters for the raster head, eight by twelve pixels.
 *
 * Models:     the 95 printable characters of ASCII; capitals nine high, strokes two wide and one
 *             high, as a beam that sweeps in rows shows them best; a box for all other codes.
 * Position:   row 0 is the top, and empty; the base line is below row 9; bit 7 is the left pixel.
 * Ownership:  constants.
 * Errors:     none.
 * Source:     ours; drawn in font.c as it looks.
 */
#ifndef ROMS_RASTER_FONT_H
#define ROMS_RASTER_FONT_H

#include <stdint.h>

#define FONT_WIDTH  8
#define FONT_HEIGHT 12

/* One row of a character's pixels. */
uint8_t font_row(char c, int row);

#endif
