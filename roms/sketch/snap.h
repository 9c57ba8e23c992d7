/* snap.h — where the cursor is drawn to: points first, then lines and circles, then the grid.
 *
 *      ·   ·   ·   ·        within reach of a point: there
 *        ○───────────       else within reach of a line, a circle, an arc: the nearest place on it
 *      ·   ·   ·   ·        (where it goes through the grid, if that is meant)
 *                           else on the grid, when it attracts
 *
 * Models:     Sketchpad's pseudo light pen position: gravity, and a grid. Points are ends of figures
 *             and middles of circles, those within copies, too.
 * Units:      reach in stage units; places as in drawing.h.
 * Ownership:  plain values.
 * Errors:     none.
 * Source:     I. E. Sutherland, Sketchpad (MIT, 1963), chapter V.
 */
#ifndef ROMS_SKETCH_SNAP_H
#define ROMS_SKETCH_SNAP_H

#include "roms/sketch/expand.h"

struct snap_settings {
    bool grid, gravity;
    int32_t spacing; /* of the grid, hundredths; above 0 */
    float reach;     /* of gravity; less where the grid is close and attracts, too */
};

enum snap_kind { SNAP_NONE, SNAP_GRID, SNAP_LINE, SNAP_CIRCLE, SNAP_POINT };

struct snapped {
    enum snap_kind kind;
    struct place at;
    int point;  /* of the picture; -1: none, or within a copy */
    int figure; /* whose it is; -1: none */
};

/* What is being moved attracts nothing. */
struct snap_moving {
    bool point[DRAWING_POINTS], figure[DRAWING_FIGURES];
};

struct snapped snap(const struct drawing_state *s, int picture,
                    const struct snap_settings *settings, struct place at,
                    const struct snap_moving *moving);

/* What is pointed at: a point or a figure within reach, whatever attracts. */
struct snapped snap_pick(const struct drawing_state *s, int picture, float reach, struct place at);

struct place snap_to_grid(struct place at, int32_t spacing);

#endif
