/* light_pen.h — the light pen on the vector head: a tracking cross, while somebody uses it.
 *
 *      tip pressed ──▶ the screen is scanned for the pen ──▶ the cross follows it ──▶ pointer
 *                                                           └─ lost for a while: no cross any more
 *
 * Models:     roms/interact/tracking.h, between the stage's picture and its segments.
 * Ownership:  one for the program; it must not move. It has the last TRACKING_BYTES of display memory.
 * Errors:     without a vector head or a pen nothing ever comes.
 */
#ifndef ROMS_SKETCH_LIGHT_PEN_H
#define ROMS_SKETCH_LIGHT_PEN_H

#include "roms/interact/pointer.h"
#include "roms/interact/tracking.h"

enum { LIGHT_PEN_LOW = STAGE_FREE_HIGH - TRACKING_BYTES };

struct light_pen {
    struct tracking tracking;
    bool used;     /* the picture is to go through its words */
    uint32_t seen; /* ticks, modulo 2^32: when it was last followed, or its tip pressed */
};

/* `next`: where the display file goes on after the cross. */
void light_pen_begin(struct light_pen *pen, uint32_t next);
/* Tells the pointer where it is; true: `used` has changed. */
bool light_pen_poll(struct light_pen *pen, struct pointer *pointer);

#endif
