/* drawing.h — what was digitised: lines of points, gaps in them, and what they measure.
 *
 *      line 1  ●──●──●──●        line 2  ●──●- - -●──●         point  ●
 *              start                             gap: reports were lost before this point
 *
 * Models:     points in the order they came; a line begins with a point that is a start, and is closed
 *             when that says so. Length is the sum of the segments that were seen; what a gap leaves
 *             out is counted apart. Area: the shoelace formula about the line's first point.
 * Domain:     up to DRAWING_POINTS_MOST points.
 * Units:      millimetres of the paper; z above the tablet's surface.
 * Ownership:  plain values, some 100 KB.
 * Errors:     false: no room. Measures of lines with gaps have `gaps` above 0.
 * Source:     A. L. F. Meister, Novi Comm. Soc. Reg. Scient. Gotting. 1 (1769) 144, for the area.
 * Not modelled: areas of lines that cross themselves: parts that run clockwise count against the others.
 */
#ifndef ROMS_DIGITISE_DRAWING_H
#define ROMS_DIGITISE_DRAWING_H

#include <stdbool.h>
#include <stdint.h>

enum { DRAWING_POINTS_MOST = 4000 };

struct drawing_point {
    float x, y, z;
    float deviation;  /* of the measurements, mm; 0: there was one */
    uint16_t samples; /* measurements it is the mean of */
    bool start;       /* of a line */
    bool alone;       /* it is no line, but a point */
    bool closed;      /* of a start: the line ends where it begins */
    bool gap;         /* reports were lost since the point before */
};

struct drawing {
    int count;
    struct drawing_point point[DRAWING_POINTS_MOST];
};

struct drawing_line {
    int first, count;
    bool closed, alone;
};

struct drawing_measure {
    float length;    /* of what was seen, the closing segment included */
    float space;     /* the same with heights */
    float perimeter; /* with the closing segment, whether closed or not */
    float area;      /* mm², positive counter-clockwise; 0 of fewer than three points */
    int gaps;
    float bridged; /* mm: straight across gaps, not in length */
};

bool drawing_add(struct drawing *drawing, const struct drawing_point *point);
bool drawing_delete_point(struct drawing *drawing);
bool drawing_delete_line(struct drawing *drawing);
/* Of the last line; false: it has fewer than three points. */
bool drawing_close(struct drawing *drawing);

/* Lines in order: begins with count 0; false: no more. */
bool drawing_next_line(const struct drawing *drawing, struct drawing_line *line);
/* The last one; count 0: there is none. */
struct drawing_line drawing_last_line(const struct drawing *drawing);
struct drawing_measure drawing_measure(const struct drawing *drawing,
                                       const struct drawing_line *line);

#endif
