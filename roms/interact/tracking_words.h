/* tracking_words.h — the tracking cross as words of the display processor; for tracking.c.
 *
 *      low ─▶ cross, stop ┐         the handler of the stop starts one of the others, or the exit
 *             exit, jump ─┼─▶ next
 *             search, stop
 *
 * Models:     see tracking.h. Pen intensify is off meanwhile: its spot of 20 µs would blind the pen for
 *             the next stroke. Between strokes the beam rests dark until the pen is ready again.
 * Units:      head units; byte addresses.
 * Ownership:  writes within the tracking's display memory, while the display processor stands in it.
 * Errors:     places beyond the screen are moved to its edge.
 */
#ifndef ROMS_INTERACT_TRACKING_WORDS_H
#define ROMS_INTERACT_TRACKING_WORDS_H

#include "roms/interact/tracking.h"

enum tracking_words {
    TRACKING_CROSS, /* seen steadily, and measured */
    TRACKING_MARK   /* waits for the pen: arms blink, the middle does not */
};

/* `half`: length of an arm. */
void tracking_write_cross(struct tracking *t, enum tracking_words kind, struct point2 at,
                          float half);
/* Turns from a few units to `radius` about a place; rows of the whole screen. Three phases lie between each
 * other. */
void tracking_write_spiral(struct tracking *t, struct point2 at, int phase, float radius);
void tracking_write_scan(struct tracking *t, int phase);
void tracking_write_exit(const struct tracking *t);

uint32_t tracking_exit(const struct tracking *t);
uint32_t tracking_search(const struct tracking *t);
bool tracking_owns(const struct tracking *t, uint32_t pc);
/* Whether the counter is behind the stop word of the search. */
bool tracking_is_search_end(const struct tracking *t, uint32_t pc);
/* The arm whose words end at the counter; -1: none. */
int tracking_arm_before(const struct tracking *t, uint32_t pc);
/* Which way the long vector went whose words end at the counter: one of x and y is 1 or -1. */
struct point2 tracking_way_before(uint32_t pc);

#endif
