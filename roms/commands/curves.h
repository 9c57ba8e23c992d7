/* curves.h — what the commands about curves share.
 *
 *      words ──▶ curves_take_... ──▶ points, splines ──▶ curves_print_...
 *                                                 └──▶ curves_frame, curves_draw_... ──▶ stage
 *
 * Models:     splines by their names; figures: as many decimals as they need, at most five.
 * Units:      world: the user's; coordinates within ±WORDS_FARTHEST.
 * Ownership:  plain values.
 * Errors:     curves_take_... return false after words_refuse.
 */
#ifndef ROMS_COMMANDS_CURVES_H
#define ROMS_COMMANDS_CURVES_H

#include "roms/curves/bezier.h"
#include "roms/curves/spline.h"
#include "roms/monitor/monitor.h"
#include "roms/stage/graph.h"

enum { CURVES_POINTS = SPLINE_POINTS_MOST, CURVES_PLACES = 24, CURVES_FIGURE = 56 };

struct curve_points {
    struct vector3 at[CURVES_POINTS];
    int count;
};

/* [at u1 u2 ...] to the end of the line, within low...high; without it five places from low to
 * high. */
bool curves_take_places(struct words *w, float low, float high, float *place, int *count);

/* A spline with the points that it was made of. */
struct named_spline {
    const char *name;
    struct spline spline;
    struct curve_points points;
    bool through; /* interpolating: the knots are the points */
};
/* natural|clamped|hermite|cardinal|catmull-rom|b-spline|bezier and what belongs to it. */
bool curves_take_spline(struct words *w, struct named_spline *out);
#define CURVES_SPLINE_FORM                                                                         \
    "natural|clamped [chordal|centripetal] x0 y0 x1 y1 ... [slopes dx0 dy0 dxn dyn]\n"             \
    "  or hermite x0 y0 dx0 dy0 x1 y1 dx1 dy1 ...\n"                                               \
    "  or cardinal TENSION x0 y0 ...\n"                                                            \
    "  or catmull-rom|b-spline|bezier x0 y0 ..."

/* 5.76, 2.15625, 4 */
const char *curves_figure(char text[CURVES_FIGURE], float value);
/* (5.76,4) or (2,2,0) */
void curves_print_point(struct vector3 p, int dimensions);
void curves_text_of_point(char *text, int room, struct vector3 p, int dimensions);

/* ---- pictures ---- */

/* What must be on the picture. */
struct curves_bounds {
    struct point2 low, high;
    bool any;
};
/* In the drawing: cabinet projection, so that z = 0 is the plane of the picture. */
struct point2 curves_flat(struct vector3 p);
void curves_include(struct curves_bounds *bounds, const struct vector3 *points, int count);
void curves_include_spline(struct curves_bounds *bounds, const struct spline *spline);
/* Begins a picture with axes. */
struct graph curves_frame(struct monitor *m, const char *title, const struct curves_bounds *bounds);

void curves_draw_lines(const struct graph *g, const struct vector3 *points, int count,
                       enum ink ink);
/* Markers with p0, p1, ... */
void curves_draw_points(const struct graph *g, char name, const struct vector3 *points, int count,
                        enum ink ink);
void curves_draw_bezier(const struct graph *g, const struct vector3 *points, int count,
                        enum ink ink);
void curves_draw_spline(const struct graph *g, const struct spline *spline, enum ink ink);
void curves_draw_marker(const struct graph *g, struct vector3 at, enum ink ink);
void curves_draw_arrow(const struct graph *g, struct vector3 from, struct vector3 along,
                       enum ink ink);

/* ---- commands, each in the file of that name ---- */

bool curves_bezier(struct monitor *m, struct words *w);
bool curves_bezier3(struct monitor *m, struct words *w);
bool curves_bezier_ends(struct monitor *m, struct words *w);
bool curves_bezier_ends3(struct monitor *m, struct words *w);
bool curves_spline(struct monitor *m, struct words *w);
bool curves_three_ways(struct monitor *m, struct words *w);
bool curves_continuity(struct monitor *m, struct words *w);
bool curves_de_boor(struct monitor *m, struct words *w);
bool curves_patch(struct monitor *m, struct words *w);

#endif
