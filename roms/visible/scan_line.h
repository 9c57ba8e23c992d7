/* scan_line.h — the scan-line method: one row at a time, all surfaces together.
 *
 *      edge table:   row 12: AB, AD    row 15: EH, EF    row 20: …           edges by their first
 *             row edges: AD ──── EH ──── BC ──── FG                              of this row, by x
 *      flags:            S1     S1,S2    S2                                  on between its two
 *             edges                   └ two flags: depths decide
 *
 * Where more than one flag is on, depths are compared at the run's first pixel and the run ends
 * where another surface comes to the front, so that surfaces which pierce one another are right,
 * too.
 *
 * Models:     edge table, active edge list, a flag a surface; depths only where flags overlap.
 * Cost:       about 260 instructions an active edge and row, its run and that run's pixels
 *             included; depths only where there is more than one flag, 60 a flag. No depth buffer.
 * Domain:     convex surfaces, at most SCAN_ROWS rows.
 * Units:      pixels, y downwards.
 * Ownership:  the state is the caller's (about 160 KB: static storage); the scene must outlive it.
 * Errors:     none; rows beyond SCAN_ROWS are left out.
 * Source:     C. Wylie, G. Romney, D. Evans, A. Erdahl, AFIPS FJCC 31 (1967) 49; W. J. Bouknight,
 *             Communications of the ACM 13 (1970) 527.
 */
#ifndef ROMS_VISIBLE_SCAN_LINE_H
#define ROMS_VISIBLE_SCAN_LINE_H

#include "roms/raster/canvas.h"
#include "roms/visible/scan_edge.h"
#include "roms/visible/scene.h"

enum { SCAN_ROWS = 1024, SCAN_END = 0xFFFF };

struct scan_line_edge {
    struct scan_edge edge;
    uint16_t surface;
    uint16_t next; /* in the same row of the edge table; SCAN_END: none */
};

struct scan_line {
    int y;                          /* the row */
    uint16_t active[SCENE_CORNERS]; /* edges that cross it, by x */
    int active_count;
    struct scan_line_edge edge[SCENE_CORNERS];
    /* Surfaces whose flag is on at the run last given, in the order of the list. */
    uint16_t flagged[SCENE_SURFACES];
    int flags;
    /* Private. */
    const struct scene *scene;
    int width, height, edges, at, x;
    uint16_t row[SCAN_ROWS];
};

/* Pixels x0 … x1 − 1 of the row. */
struct scan_run {
    int x0, x1;
    int surface; /* SURFACE_NONE: background */
    float depth; /* at x0 */
};

void scan_line_begin(struct scan_line *s, const struct scene *scene, int width, int height);
/* The next row, from 0; false: there is none left. */
bool scan_line_next(struct scan_line *s);
/* The next run of the row, from the left; false: the row is at its end. */
bool scan_line_run(struct scan_line *s, struct scan_run *run);

/* The whole picture; background is left as it is. */
void scan_line_scene(struct scan_line *s, const struct canvas *canvas, const struct scene *scene);

#endif
