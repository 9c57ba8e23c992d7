/* canvas.h — drawing into pixels: rectangles, lines, ellipses, text.
 *
 *      program ── colours as the format has them ──▶ canvas ──▶ refresh buffer
 *
 * Models:     a rectangle of pixels of 1, 2, 4, 8, 16 or 32 bits (raster/video_regs.h), and the
 *             simplest ways to set them. What lies outside is left out.
 * Position:   pixels; x to the right, y downwards; a pixel is named by its upper left corner.
 * Colours:    pixel values: an index of the look-up table, or red, green and blue together.
 * Ownership:  the pixels are the caller's; they begin at a multiple of 4, as does every row.
 * Errors:     none. A canvas 0 wide and 0 high, which a board without a raster head gives, takes
 *             everything and keeps nothing.
 * Source:     J. E. Bresenham, IBM Systems Journal 4 (1965) 25, for lines (line_bresenham.h);
 *             ellipses row by row from their equation.
 * Not modelled: pixels of 24 bits. Polygons, fills, antialiased and dashed lines have headers of their own.
 */
#ifndef ROMS_RASTER_CANVAS_H
#define ROMS_RASTER_CANVAS_H

#include <stdint.h>

struct canvas {
    uint8_t *pixels;
    uint32_t pitch; /* bytes from row to row */
    int width, height;
    unsigned bits; /* a pixel */
    /* Shape of the screen's pixels: how many dots are as long as one row is high. A circle of
     * radius r rows is an ellipse of r * dots_a_row dots by r rows. */
    float dots_a_row;
};

/* The bytes of a row for pixels of so many bits: a multiple of 4. */
uint32_t canvas_pitch(int width, unsigned bits);

void canvas_fill(const struct canvas *c, int x, int y, int width, int height, uint32_t colour);
void canvas_clear(const struct canvas *c, uint32_t colour);
void canvas_dot(const struct canvas *c, int x, int y, uint32_t colour);
/* A rectangle's edge, `thick` pixels inward. */
void canvas_frame(const struct canvas *c, int x, int y, int width, int height, int thick,
                  uint32_t colour);

/* Bresenham's line (line_bresenham.h), both ends included; a part that lies outside changes no
 * pixel that is within. Coordinates beyond ±2^28: nothing. 7 instructions a pixel of 8, 16 or 32
 * bits. */
void canvas_line(const struct canvas *c, int x0, int y0, int x1, int y1, uint32_t colour);

/* An ellipse's outline, a pixel wide: its extreme pixels are `rx` and `ry` from the middle one. It
 * is the edge of the disc below, so that outlines and areas fit each other; canvas_ellipse_midpoint
 * (ellipse_midpoint.h) lights the pixels nearest to the ellipse through the middles of the extreme
 * ones, and canvas_circle (circle_midpoint.h) is the fastest. */
void canvas_ellipse(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour);
/* What is inside of it, outline included. */
void canvas_disc(const struct canvas *c, int x, int y, int rx, int ry, uint32_t colour);
/* Dots that are as long as so many rows are high; for circles: ellipse(x, y, round_dots(r), r). */
int canvas_round_dots(const struct canvas *c, int rows);
/* Half the length of the row `dy` rows from the middle of an ellipse; -1: none. */
int canvas_chord(int rx, int ry, int dy);

/* Characters of FONT_WIDTH by FONT_HEIGHT pixels (font.h), each pixel `sx` by `sy`. The upper left
 * corner of the first is at x, y. The ground is left as it is.
 *
 *      ·██··   a row of a character is a byte, a bit a dot: eight tests, and stores for lit dots
 *
 * Cost of a character: dots of 1 by 1 pixel, of 8, 16 or 32 bits: 250 instructions; of 2 by 2: 340.
 * Smaller pixels, other dots, and characters that the canvas's edge cuts go stretch by stretch of lit
 * dots, each a rectangle: 800 to 3000. A space, and what lies outside: 5. */
void canvas_text(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                 const char *text);
/* The same about x. */
void canvas_text_middle(const struct canvas *c, int x, int y, int sx, int sy, uint32_t colour,
                        const char *text);

#endif
