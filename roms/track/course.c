/* What the samples say: states, speed, rest; and what is printed of it. */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/timer.h"
#include "roms/geometry/scalar.h"
#include "roms/stage/tenths.h"
#include "roms/track/track.h"

#define STILL 1.5f /* head units within which the pen rests */

const char *track_state_name(enum tracking_state state)
{
    static const char *const names[] = {"lost", "following", "searching"};
    return names[state];
}

static void print_place(struct point2 at)
{
    char x[16], y[16];
    tenths_text(x, sizeof x, at.x, 0, false);
    tenths_text(y, sizeof y, at.y, 0, false);
    printf("%s %s", x, y);
}

/* mm/s over the window; no faster than the shortest way between its ends. */
static void measure(struct course *c, const struct tracking_sample *sample)
{
    for (int i = 0; i + 1 < COURSE_WINDOW; i++)
        c->window[i] = c->window[i + 1];
    c->window[COURSE_WINDOW - 1] = *sample;
    c->filled += c->filled < COURSE_WINDOW;
    if (c->filled < COURSE_WINDOW)
        return;
    const struct tracking_sample *from = &c->window[0];
    float seconds = (float)(sample->time - from->time) / TIMER_HZ;
    if (seconds > 0)
        c->speed =
            TRACK_MM * hypotf(sample->at.x - from->at.x, sample->at.y - from->at.y) / seconds;
    c->greatest = scalar_max(c->greatest, c->speed);
}

static void tell_state(struct course *c, const struct tracking_sample *sample)
{
    printf("track %s at ", track_state_name(sample->state));
    print_place(sample->at);
    printf("\n");
    c->state = sample->state;
    c->still = 0;
}

static void tell_rest(struct course *c, const struct tracking_sample *sample,
                      const struct tracking *t)
{
    bool near =
        fabsf(sample->at.x - c->rest.x) <= STILL && fabsf(sample->at.y - c->rest.y) <= STILL;
    if (!near || sample->state != TRACKING_FOLLOWING) {
        c->rest = sample->at;
        c->still = 0;
        c->rested = false;
    } else if (++c->still >= COURSE_REST && !c->rested) {
        c->rested = true;
        printf("track rests at ");
        print_place(sample->at);
        printf(", one way ");
        print_place(t->one_way);
        printf("\n");
    }
}

void course_take(struct course *c, const struct tracking_sample *sample, const struct tracking *t)
{
    if (sample->state == TRACKING_FOLLOWING) {
        measure(c, sample);
    } else {
        c->filled = 0;
        if (sample->state == TRACKING_LOST)
            c->speed = 0;
    }
    if (sample->state != c->state)
        tell_state(c, sample);
    if (sample->pressed != c->pressed) {
        printf("track tip %s at ", sample->pressed ? "down" : "up");
        print_place(sample->at);
        printf("\n");
    }
    c->pressed = sample->pressed;
    tell_rest(c, sample, t);
}

void course_summary(const struct course *c, const struct tracking *t)
{
    const struct tracking_counts *n = &t->counts;
    printf("track refreshes %lu, followed %lu, spirals %lu, scans %lu, found %lu, lost %lu\n",
           (unsigned long)n->refreshes, (unsigned long)n->followed, (unsigned long)n->searches,
           (unsigned long)n->scans, (unsigned long)n->found, (unsigned long)n->losses);
    printf("track greatest speed %d mm/s\n", scalar_nearest(c->greatest));
}
