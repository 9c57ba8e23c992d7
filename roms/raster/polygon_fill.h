/* polygon_fill.h — areas between edges, scan line by scan line.
 *
 *      edges, by their lowest row ──▶ active edges, by x ──▶ pairs of crossings ──▶ runs of pixels
 *           (edge table)                └── x moves by dx/dy a row: whole numbers, a remainder
 *
 * Models:     the even-odd rule and the non-zero winding rule; any number of contours, so that
 *             areas have holes. A pixel belongs to the area when its middle does; a middle on an
 *             edge belongs to the area on its right or below, so that areas which share an edge
 *             share no pixel and leave no gap. Crossings are exact for the corners as they were
 *             rounded.
 * Cost:       an edge about 150 instructions, 2 of them divisions; a row with two active edges
 *             about 85, with more about 35 an edge and 60 a run; then 1.3 instructions a pixel of
 *             32 bits, 0.35 of 8 bits. A triangle 40 pixels high takes 5.7 a pixel, one 400 high
 *             0.8 (8 bits) or 1.7 (32 bits).
 * Domain:     corners within POLYGON_REACH pixels of the origin; those beyond are moved there.
 *             Corners are rounded to 1/64 pixel, the same for all areas.
 * Units:      pixels; middles of pixels are whole numbers; y downwards.
 * Ownership:  plain values: struct polygon_fill is about 6 KiB.
 * Errors:     a polygon of fewer than 3 or more than POLYGON_CORNERS corners (of all contours
 *             together) is not filled; polygon_fill_contour says so.
 * Source:     J. D. Foley et al., Computer Graphics: Principles and Practice (1990), section 3.6;
 *             C. Wylie et al., Half-Tone Perspective Drawings by Computer, AFIPS FJCC 31 (1967) 49,
 *             for the tables.
 */
#ifndef ROMS_RASTER_POLYGON_FILL_H
#define ROMS_RASTER_POLYGON_FILL_H

#include <stdbool.h>

#include "roms/geometry/vector.h"
#include "roms/raster/canvas.h"

enum { POLYGON_CORNERS = 128, POLYGON_REACH = 8192, POLYGON_PARTS = 64 /* of a pixel */ };
enum polygon_rule { POLYGON_EVEN_ODD, POLYGON_NON_ZERO };

void canvas_polygon(const struct canvas *c, const struct point2 *corners, int count,
                    enum polygon_rule rule, uint32_t colour);
/* Several contours: `counts` corners each, one after the other. */
void canvas_polygons(const struct canvas *c, const struct point2 *corners, const int *counts,
                     int contours, enum polygon_rule rule, uint32_t colour);

/* The first row or column at or behind an upright edge there: an upright rectangle is filled from
 * polygon_first(low) up to, not including, polygon_first(high). */
int polygon_first(float v);

/* ---- row by row ------------------------------------------------------------------------------ */

/* An edge that crosses rows first…last. Where it crosses the row that is being done, rounded up to
 * 1/64 pixel, is `x`; `over` / `height` is by how much that is too far. */
struct polygon_edge {
    int first, last;
    int32_t x, over;
    int32_t step_x, step_over; /* for the next row */
    int32_t height;            /* 1/64 pixel */
    int winding;               /* +1: goes down */
    struct point2 a, b;        /* as it was given, for those who show it */
};

/* What changes stands first: the processor reaches it without computing where it is. */
struct polygon_fill {
    int count, waiting; /* edges; the next one to become active */
    int active_count;
    int y;            /* the row that is being done */
    int top, bottom;  /* rows wanted */
    int next, inside; /* runs of the row: the next active edge; the rule's counter before it */
    enum polygon_rule rule;
    bool sorted;
    uint8_t active[POLYGON_CORNERS];           /* edges that cross row y, from left to right */
    struct polygon_edge edge[POLYGON_CORNERS]; /* by first row, once polygon_fill_row was called */
};

/* Pixels x0…x1 − 1 of a row. */
struct polygon_run {
    int x0, x1;
};

/* For rows top…bottom. */
void polygon_fill_begin(struct polygon_fill *f, enum polygon_rule rule, int top, int bottom);
/* Adds the edges of a contour, which closes itself; false: they are too few or too many. */
bool polygon_fill_contour(struct polygon_fill *f, const struct point2 *corners, int count);
/* The next row that edges cross; false: there is none left. */
bool polygon_fill_row(struct polygon_fill *f);

/* The first pixel on or to the right of a place in 1/64 pixel. */
static inline int polygon_pixel(int32_t x)
{
    return (x + (POLYGON_PARTS - 1)) >> 6;
}

/* The next run of the row, which has pixels; false: there is none left. */
static inline bool polygon_fill_run(struct polygon_fill *f, struct polygon_run *run)
{
    while (f->next + 1 < f->active_count) {
        int i = f->next++;
        f->inside =
            f->rule == POLYGON_EVEN_ODD ? !f->inside : f->inside + f->edge[f->active[i]].winding;
        if (!f->inside)
            continue;
        run->x0 = polygon_pixel(f->edge[f->active[i]].x);
        run->x1 = polygon_pixel(f->edge[f->active[i + 1]].x);
        if (run->x0 < run->x1)
            return true;
    }
    return false;
}

#endif
