/* graph.h — a part of the world in a part of the stage, with its axes.
 *
 *      world window ──(one scale for x and y)──▶ viewport on the stage
 *
 * Models:     window to viewport transformation; axes, ticks at 1, 2 or 5 times a power of ten, and
 *             their figures, as many as stand clear of each other.
 * Units:      world: the caller's; viewport: stage units (stage.h).
 * Ownership:  plain value; the stage must outlive it.
 * Errors:     none: an empty window, and one that floats cannot divide, is widened; points that are
 *             not finite, or beyond 1e15, are not looked at.
 */
#ifndef ROMS_STAGE_GRAPH_H
#define ROMS_STAGE_GRAPH_H

#include "roms/stage/stage.h"

struct graph {
    struct stage *stage;
    float scale;         /* stage units a world unit */
    float left, bottom;  /* of the viewport, stage units */
    float width, height; /* of it */
    float x_min, y_min;  /* world */
    float x_max, y_max;
};

/* Shows at least these points of the world, with a margin, in this part of the stage. */
struct graph graph_fit(struct stage *stage, float left, float bottom, float width, float height,
                       const struct point2 *points, int count);
/* The same over the whole picture. */
struct graph graph_whole(struct stage *stage, const struct point2 *points, int count);
void graph_axes(const struct graph *graph);
struct point2 graph_place(const struct graph *graph, struct point2 world);
void graph_line(const struct graph *graph, struct point2 a, struct point2 b);
void graph_polyline(const struct graph *graph, const struct point2 *points, int count);
void graph_polygon(const struct graph *graph, const struct point2 *points, int count);
void graph_marker(const struct graph *graph, struct point2 at);
void graph_text(const struct graph *graph, struct point2 at, const char *text);

#endif
