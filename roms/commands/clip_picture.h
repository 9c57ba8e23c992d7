/* clip_picture.h — pictures of clipping: the window, the nine regions, what is left and what is cut
 * away.
 *
 * Models:     what is left is bright, what is cut away red on the raster head, dim and dashed on
 *             the vector head.
 * Units:      world, by a graph (roms/stage/graph.h).
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_COMMANDS_CLIP_PICTURE_H
#define ROMS_COMMANDS_CLIP_PICTURE_H

#include "roms/clip/window.h"
#include "roms/stage/graph.h"

/* Shows the window and these points in a part of the stage (roms/stage/graph.h). */
struct graph clip_picture_fit(struct stage *stage, float left, float width,
                              const struct clip_window *window, const struct point2 *points,
                              int count);
void clip_picture_window(const struct graph *graph, const struct clip_window *window);
/* The window's edges on and on, and the code of each region. */
void clip_picture_regions(const struct graph *graph, const struct clip_window *window);
void clip_picture_cut_away(const struct graph *graph, struct point2 a, struct point2 b);

/* The four digits ABRL. */
void clip_code_text(unsigned code, char text[5]);
const char *clip_edge_name(unsigned region);

#endif
