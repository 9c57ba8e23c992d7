/* depth.h — the depth buffer that all lessons and commands share: one is enough, as one runs at a time.
 *
 * Ownership:  static storage of DEPTH_PIXELS floats.
 * Errors:     a canvas with more pixels gets a buffer of 0 by 0, and a sentence that says so.
 */
#ifndef ROMS_SCENERY_DEPTH_H
#define ROMS_SCENERY_DEPTH_H

#include "roms/raster/canvas.h"
#include "roms/visible/depth_buffer.h"

enum { DEPTH_PIXELS = 1600 * 1200 };

/* After the canvas was cleared. As wide and high as the canvas; its contents are whatever was there. */
struct depth_buffer lesson_depth(const struct canvas *canvas);

#endif
