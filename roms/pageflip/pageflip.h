/* pageflip.h — the parts of a moving picture.
 *
 * Models:     a stage with frames and writing, bars that sweep, a solid that turns; each on a page
 *             that remembers what is on it, so that only what moved is drawn.
 * Position:   pixels; the bars' place in pixels swept since the beginning.
 * Ownership:  plain values; draws into the canvas of the page.
 * Errors:     none.
 */
#ifndef ROMS_PAGEFLIP_PAGEFLIP_H
#define ROMS_PAGEFLIP_PAGEFLIP_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/raster/canvas.h"

/* Entries of the look-up table. */
enum {
    PAGEFLIP_GROUND,
    PAGEFLIP_SHADE, /* the first of PAGEFLIP_SHADES */
    PAGEFLIP_SHADES = 60,
    PAGEFLIP_WHITE = PAGEFLIP_SHADE + PAGEFLIP_SHADES,
    PAGEFLIP_FRAME,
    PAGEFLIP_BAR,
    PAGEFLIP_MARK
};

struct pageflip_rect {
    int x, y, width, height;
};

struct pageflip_page {
    struct canvas canvas;
    struct pageflip_rect bars, solid; /* where they move */
    int swept;                        /* of the bars that are on it; -1: none yet */
    int mark;                         /* row of the mark on it; -1: none */
};

/* The look-up table. */
void pageflip_colours(void);
/* An empty page with its frames and two lines of text. */
void pageflip_stage(struct pageflip_page *page, struct canvas canvas);
void pageflip_text(struct pageflip_page *page, bool synced);

/* The bars, `swept` pixels along, row by row from the top. With `look`, a mark is set beside the row
 * where the drawing overtakes the beam: rows above it are seen as they were. */
void pageflip_bars(struct pageflip_page *page, int swept, bool look);
void pageflip_unmark(struct pageflip_page *page);
/* An icosahedron turned by an angle, radians. */
void pageflip_solid(const struct pageflip_page *page, float angle);

#endif
