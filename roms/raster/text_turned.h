/* text_turned.h — the raster head's characters in any size and in four directions.
 *
 *      TEXT_RIGHT  ABC      TEXT_UP  C        (x, y): the corner where the first cell begins;
 *                                    B        the cell is turned about it
 *      TEXT_LEFT, TEXT_DOWN          A
 *
 * Models:     the font of font.h; each of its dots becomes a rectangle, so that a cell is as wide
 *             and high as is asked for. Dots of uneven size differ by one pixel.
 * Cost:       a stretch of lit dots in a row is one canvas_fill: about 10 a character; 2400
 *             instructions for 8 by 12 pixels.
 * Domain:     cells of 1…TEXT_LARGEST pixels; below 8 by 12 strokes are lost.
 * Units:      pixels; x to the right, y downwards.
 * Ownership:  nothing.
 * Errors:     a cell beyond the domain draws nothing; what lies outside the canvas is left out.
 * Source:     elementary: nearest dot.
 * Not modelled: other angles; characters of different widths.
 */
#ifndef ROMS_RASTER_TEXT_TURNED_H
#define ROMS_RASTER_TEXT_TURNED_H

#include "roms/raster/canvas.h"

enum { TEXT_LARGEST = 1000 };
enum text_direction { TEXT_RIGHT, TEXT_UP, TEXT_LEFT, TEXT_DOWN };

struct text_cell {
    int width, height; /* along the text, across it */
    enum text_direction direction;
};

/* The ground is left as it is. */
void canvas_text_turned(const struct canvas *c, int x, int y, const struct text_cell *cell,
                        uint32_t colour, const char *text);

#endif
