/* plane_picture.h — figures before and after a transformation, on axes.
 *
 * Models:     the figure before in cyan, after in orange, filled where the head can; corners are
 *             lettered.
 * Units:      world, by a graph (roms/stage/graph.h).
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef ROMS_COMMANDS_PLANE_PICTURE_H
#define ROMS_COMMANDS_PLANE_PICTURE_H

#include "roms/clip/window.h"
#include "roms/commands/flat_words.h"
#include "roms/geometry/matrix3.h"
#include "roms/monitor/monitor.h"
#include "roms/stage/graph.h"

struct plane_figure {
    struct point2 corner[FLAT_POINTS];
    int count;
};

/* A letter F, which looks different after any transformation. */
struct plane_figure plane_figure_default(void);
/* Its image. */
struct plane_figure plane_figure_image(const struct plane_figure *f, const struct matrix3 *m);
/* All corners within ±1e9. */
bool plane_figure_sane(const struct plane_figure *f);
/* Every corner and its image, one a line. */
void plane_figure_print(const struct plane_figure *before, const struct plane_figure *after);

/* Its outline, the area if `filled`, and the corners' letters with a mark behind them. */
void plane_picture_figure(const struct graph *g, const struct plane_figure *f, enum ink ink,
                          bool filled, const char *mark);
/* Both, on axes over the whole picture. */
void plane_picture_both(struct monitor *m, const struct plane_figure *before,
                        const struct plane_figure *after);
void plane_picture_rectangle(const struct graph *g, const struct clip_window *w, enum ink ink);

#endif
