/* pointer_tracking.h — the pen on the vector head as a pointer: what the tracking cross says.
 *
 *      tracking.h: cross, samples ──▶ pointer_follow ──▶ pointer_pen_place ──▶ pointer
 *
 * Use:        tracking_begin(&tracking, STAGE_FREE_LOW, 0);
 *             pointer_follow(&pointer, &tracking);
 *             in each picture: stage_chain(&stage, tracking.low);
 *             before each poll: tracking_frame(&tracking);
 * Models:     the pen is near while the cross follows it; a cross that has lost it says nothing.
 * Units:      head units in, stage units out.
 * Ownership:  both belong to the caller. tracking.place and place_ctx are taken.
 * Errors:     none.
 */
#ifndef ROMS_INTERACT_POINTER_TRACKING_H
#define ROMS_INTERACT_POINTER_TRACKING_H

#include "roms/interact/pointer.h"
#include "roms/interact/tracking.h"

/* One sample, for programs that take them themselves. A pen that is lost is told of once. */
void pointer_tracked(struct pointer *pointer, const struct tracking_sample *sample);
void pointer_follow(struct pointer *pointer, struct tracking *tracking);

#endif
