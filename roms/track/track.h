/* track.h — the parts of the program that shows how a pen is tracked.
 *
 *      tracking ──samples──▶ course: states, speed, what rests ──▶ console
 *                       └──▶ strokes: trail, ink ──▶ view ──▶ stage
 *
 * Models:     what is remembered of where the pen was.
 * Units:      head units; millimetres on a VR17.
 * Time:       ticks of the timer.
 * Ownership:  plain values.
 * Errors:     ink beyond STROKES_POINTS: the oldest is forgotten.
 * Source:     the tube's width is that of the VR17 in crt/tube_rows.c.
 */
#ifndef ROMS_TRACK_TRACK_H
#define ROMS_TRACK_TRACK_H

#include "roms/interact/tracking.h"
#include "roms/stage/stage.h"

#define TRACK_MM (9.25f * 25.4f / 1024) /* a head unit */

enum { STROKES_POINTS = 900, TRAIL_POINTS = 100, COURSE_WINDOW = 6, COURSE_REST = 30 };

struct strokes {
    struct point2 ink[STROKES_POINTS]; /* a ring */
    bool begins[STROKES_POINTS];       /* a stroke begins with this point */
    int first, count;
    struct point2 trail[TRAIL_POINTS];
    bool gap[TRAIL_POINTS]; /* before it the pen was not followed */
    int trail_first, trail_count;
    bool drawing, followed;
};

struct course {
    struct tracking_sample window[COURSE_WINDOW]; /* the last ones that were followed */
    int filled;
    enum tracking_state state;
    bool pressed;
    float speed, greatest; /* mm/s; while followed */
    int still;             /* refreshes that it has rested */
    struct point2 rest;
    bool rested; /* has been said */
};

void strokes_take(struct strokes *s, const struct tracking_sample *sample);
void strokes_clear(struct strokes *s);
/* Says on the console what has changed. */
void course_take(struct course *c, const struct tracking_sample *sample, const struct tracking *t);
void course_summary(const struct course *c, const struct tracking *t);

const char *track_state_name(enum tracking_state state);
void view_draw(struct stage *stage, const struct tracking *t, const struct course *c,
               const struct strokes *s);

#endif
