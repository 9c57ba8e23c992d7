/* line_thick.h — lines as wide as is wanted, with caps and joins.
 *
 *      butt ▐████▌   square ▐██████▌   round ◖████◗       caps, at the ends
 *      bevel ╱▔      miter ┌          round ╭             joins, between segments
 *
 *      polyline ──▶ pieces: a rectangle a segment, a polygon a join or cap ──▶ polygon_fill
 *
 * Models:     the area within half the width of the polyline; caps and joins as in PostScript. A
 *             miter longer than MITER_LIMIT widths becomes a bevel. Round parts are polygons that
 *             are at most 1/16 pixel off.
 * Cost:       a segment and its join: 3 square roots and the filling of 7 or 8 edges; a round part:
 *             2 sines and an edge for each of its corners, about 300 instructions each.
 * Domain:     widths above 0 up to THICK_WIDEST; coordinates as of polygon_fill.h.
 * Units:      pixels of the canvas; whole numbers are middles of pixels.
 * Ownership:  the points are the caller's.
 * Errors:     none: a width beyond the domain gives no pieces. Points that repeat are left out; a
 *             line of length 0 is what its caps are: nothing, a square, a disc.
 * Source:     Adobe Systems, PostScript Language Reference Manual (1985), setlinecap, setlinejoin.
 * Not modelled: pieces overlap: what is filled must not be mixed with what was there.
 */
#ifndef ROMS_RASTER_LINE_THICK_H
#define ROMS_RASTER_LINE_THICK_H

#include <stdbool.h>

#include "roms/raster/canvas.h"
#include "roms/raster/polygon_fill.h"

enum { THICK_WIDEST = 400, THICK_MITER_LIMIT = 10 };
enum line_cap { CAP_BUTT, CAP_SQUARE, CAP_ROUND };
enum line_join { JOIN_BEVEL, JOIN_MITER, JOIN_ROUND };

struct line_style {
    float width;
    enum line_cap cap;
    enum line_join join;
};

enum thick_piece_kind { PIECE_SEGMENT, PIECE_JOIN, PIECE_CAP };

struct thick_piece {
    enum thick_piece_kind kind;
    struct point2 corner[POLYGON_CORNERS];
    int count;
};

struct line_thick {
    const struct point2 *point;
    int count;
    bool closed;
    struct line_style style;
    int at;   /* the segment that is being done: its first point */
    int part; /* what comes next of it */
};

/* closed: the last point is joined to the first. */
void line_thick_begin(struct line_thick *line, const struct point2 *points, int count, bool closed,
                      const struct line_style *style);
bool line_thick_next(struct line_thick *line, struct thick_piece *piece);

void canvas_line_thick(const struct canvas *c, const struct point2 *points, int count, bool closed,
                       const struct line_style *style, uint32_t colour);

#endif
