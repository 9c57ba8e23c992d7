/* gallery_plotting.h — the charts of the plotting program; private to gallery_plotting*.c.
 *
 * Models:     each draws the whole picture, of data that it computes, for so many seconds after it
 *             began.
 * Units:      seconds; stage units; widths: pixels.
 * Ownership:  nothing is kept but what the seconds tell.
 * Errors:     none; without a head nothing is shown.
 */
#ifndef ROMS_LESSONS_GALLERY_PLOTTING_H
#define ROMS_LESSONS_GALLERY_PLOTTING_H

#include "roms/stage/stage.h"

void plot_lines(struct stage *stage, float seconds);
void plot_bars(struct stage *stage, float seconds);
void plot_pie(struct stage *stage, float seconds);
void plot_surface(struct stage *stage, float seconds);

/* A place on the canvas. */
struct point2 plot_canvas(const struct stage *stage, struct point2 p);
/* A polyline, `width` pixels wide on the raster head. */
void plot_polyline(struct stage *stage, const struct point2 *points, int count, float width,
                   enum ink ink);

#endif
