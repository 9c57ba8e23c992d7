/* Where the pen was: its trail, and what it drew. */
#include <math.h>

#include "roms/track/track.h"

enum { LEAST = 3 /* head units between points of ink */ };

static void add_trail(struct strokes *s, struct point2 at, bool gap)
{
    if (s->trail_count == TRAIL_POINTS) {
        s->trail_first = (s->trail_first + 1) % TRAIL_POINTS;
        s->trail_count--;
    }
    int i = (s->trail_first + s->trail_count++) % TRAIL_POINTS;
    s->trail[i] = at;
    s->gap[i] = gap;
}

static void add_ink(struct strokes *s, struct point2 at, bool begins)
{
    int last = (s->first + s->count - 1) % STROKES_POINTS;
    if (!begins && s->count > 0 && hypotf(at.x - s->ink[last].x, at.y - s->ink[last].y) < LEAST)
        return;
    if (s->count == STROKES_POINTS) {
        s->first = (s->first + 1) % STROKES_POINTS;
        s->begins[s->first] = true;
        s->count--;
    }
    int i = (s->first + s->count++) % STROKES_POINTS;
    s->ink[i] = at;
    s->begins[i] = begins;
}

void strokes_take(struct strokes *s, const struct tracking_sample *sample)
{
    bool followed = sample->state == TRACKING_FOLLOWING, drawing = followed && sample->pressed;
    if (followed)
        add_trail(s, sample->at, !s->followed);
    else if (sample->state == TRACKING_LOST && s->trail_count > 0) {
        s->trail_first = (s->trail_first + 1) % TRAIL_POINTS; /* it fades */
        s->trail_count--;
    }
    if (drawing)
        add_ink(s, sample->at, !s->drawing);
    s->followed = followed;
    s->drawing = drawing;
}

void strokes_clear(struct strokes *s)
{
    s->count = 0;
    s->drawing = false;
}
