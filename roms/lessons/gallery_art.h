/* gallery_art.h — the works of the art program; private to roms/lessons/gallery_art*.c.
 *
 * Models:     each draws the whole picture for so many seconds after it began.
 * Units:      seconds; stage units; colours: pixel values (roms/stage/ink.h).
 * Ownership:  nothing is kept but what the seconds tell.
 * Errors:     none; without a head nothing is shown.
 */
#ifndef ROMS_LESSONS_GALLERY_ART_H
#define ROMS_LESSONS_GALLERY_ART_H

#include "roms/stage/stage.h"

void art_guilloche(struct stage *stage, float seconds);
void art_whirls(struct stage *stage, float seconds);
void art_kaleidoscope(struct stage *stage, float seconds);
void art_lettering(struct stage *stage, float seconds);

/* An area of up to 16 corners: filled with a pixel value on the raster head, an outline on the
 * other. */
void art_area(struct stage *stage, const struct point2 *points, int count, uint32_t colour,
              enum ink vector);

#endif
