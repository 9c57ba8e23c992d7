/* tools_parts.h — what the files of the tools tell each other.
 *
 *      tools.c: commands     tools_place.c: new figures, copies     tools_move.c: moving, selecting
 *
 * Models:     see tools.h.
 * Ownership:  as there.
 * Errors:     as there.
 */
#ifndef ROMS_SKETCH_TOOLS_PARTS_H
#define ROMS_SKETCH_TOOLS_PARTS_H

#include "roms/sketch/tools.h"

enum {
    TOOLS_FAR = 8 * PLACE_UNIT,    /* a press and release closer together are no drag */
    TOOLS_STEADY = 4 * PLACE_UNIT, /* until then nothing moves */
};

/* True, or the sentence is said. */
bool tools_worked(struct tools *t, enum drawing_status status);
bool tools_is_far(struct place a, struct place b, int32_t distance);
/* Nothing is under way; the step ends so. */
void tools_finish(struct tools *t);
void tools_leave_off(struct tools *t);
/* These follow the pointer: they, and what constraints make follow, attract nothing. */
void tools_follow(struct tools *t, const int *points, int count);
struct snapped tools_snap(const struct tools *t, struct place at);
/* The nearer of horizontal and vertical through `from`. */
struct place tools_aligned(struct place from, struct place at);

void place_point(struct tools *t);
void copy_point(struct tools *t);
/* The copy that follows the pointer is turned and scaled as copies to come are. */
void copy_renew(struct tools *t);

void move_point(struct tools *t);
void select_point(struct tools *t);
/* Tools that do something to what is pointed at. */
void apply_point(struct tools *t);
void apply_selection(struct tools *t, enum command command);

#endif
