/* grid.h — pixels enlarged, so that a class can see each.
 *
 *      ┌─┬─┬─┬─┐   a pixel is a cell; its middle is the point with its coordinates
 *      ├─┼─╳─┤█│   ideal curves are drawn over the cells, candidates are outlined
 *      └─┴─┴─┴─┘
 *
 * Models:     a part of the integer grid on the stage, on both heads.
 * Units:      pixels of the grid, y up. On the stage: stage units.
 * Ownership:  plain value; the stage must outlive it.
 * Errors:     none: what lies outside is left out. When cells would be smaller than a few dots the
 *             rules are left out, too, and pixels are lines or dots on the vector head.
 */
#ifndef ROMS_STAGE_GRID_H
#define ROMS_STAGE_GRID_H

#include "roms/stage/stage.h"

struct grid {
    struct stage *stage;
    int x0, y0, x1, y1;       /* the pixels shown, those on the edge included */
    float left, bottom, cell; /* stage units */
};

/* Fits these pixels, with one more all round, into a part of the stage. */
struct grid grid_fit(struct stage *stage, float left, float bottom, float width, float height,
                     int x0, int y0, int x1, int y1);
/* Rules, and the coordinates along the edges. */
void grid_rules(const struct grid *grid);
/* Whether cells are large enough for them. */
bool grid_ruled(const struct grid *grid);
void grid_pixel(const struct grid *grid, int x, int y, enum ink ink);
/* Pixels x0…x1 of a row. */
void grid_run(const struct grid *grid, int y, int x0, int x1, enum ink ink);
/* Its outline. */
void grid_candidate(const struct grid *grid, int x, int y, enum ink ink);
/* The ideal: places between pixels. */
struct point2 grid_place(const struct grid *grid, float x, float y);
void grid_line(const struct grid *grid, float x0, float y0, float x1, float y1, enum ink ink);

#endif
