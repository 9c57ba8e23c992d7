/* font.h — characters for the raster head, eight by twelve pixels.
 *
 * Models:     the 95 printable characters of ASCII; capitals nine high, strokes two wide and one
 *             high, as a beam that sweeps in rows shows them best; a box for all other codes.
 * Position:   row 0 is the top, and empty; the base line is below row 9; bit 7 is the left pixel.
 * Cost:       15 instructions a row when asked for alone, 1 with font_rows; 1152 bytes.
 * Ownership:  constants.
 * Errors:     none.
 * Source:     ours; drawn in font.c as it looks.
 */
#ifndef ROMS_RASTER_FONT_H
#define ROMS_RASTER_FONT_H

#include <stdint.h>

#define FONT_WIDTH  8
#define FONT_HEIGHT 12
/* Eight characters lie side by side: so many bytes from one row of a character to the next. */
#define FONT_NEXT_ROW 8

/* All rows of a character: row r is at r * FONT_NEXT_ROW. */
const uint8_t *font_rows(char c);
/* One row of a character's pixels. */
uint8_t font_row(char c, int row);

#endif
