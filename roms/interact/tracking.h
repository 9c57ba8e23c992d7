/* tracking.h — a tracking cross: how a display without a counter of places follows a light pen.
 *
 *                   │ ▲         each refresh draws four strokes through the cross's middle, two either
 *            ───────┼─┼───▶     way; the pen stops the display processor in mid-stroke where the beam
 *              ◀────┼─┼──────   comes into what it sees:
 *                   ▼ │             right arm's stroke at  p + c − v·d       p: the pen, c: half a chord,
 *                                   left arm's stroke at   p − c + v·d       v·d: beam speed times delay
 *                               half their sum is p, whatever c and v·d are
 *
 * Models:     one refresh: cross; where only one way was seen, it is drawn again at what is known; where
 *             nothing was seen, a square spiral whose turns go outward in a geometric series, dense near
 *             the middle; where the spiral is seen, the cross there. The cross goes ahead by the speed
 *             that the pen had (`predicts`). Refreshes without success widen cross and spiral; after
 *             TRACKING_PATIENCE of them the pen is lost: the cross stays and blinks, with a steady mark
 *             in its middle, and the pen takes it up by pointing there; or the whole screen is scanned
 *             for it (tracking_scan).
 * Time:       a cross takes 0.5 ms on a VR17, a spiral up to 2 ms, a scan 15 ms, at the end of a refresh.
 *             The handlers run a few hundred instructions; those that write a spiral or a scan some
 *             thousands, while the display processor stands.
 * Units:      head units of the vector head, 0…1023; times in ticks of the timer.
 * Ownership:  the caller's struct, alive while interrupts come; TRACKING_BYTES of display memory from
 *             `low` on. It takes the pen's and the stop's interrupts (roms/bsp/dpu.h): hits in words of
 *             others are handed to `others`, which must go on with dpu_resume(). Refreshes are declared
 *             by it (board_refresh).
 * Errors:     samples that nobody takes in time: `dropped` counts them. A pen that fires without light
 *             from the cross is not followed: both directions must be seen.
 * Source:     the tracking cross, finding the pen again by a scan about where it was, and losing it by
 *             going too fast are those of I. E. Sutherland, Sketchpad (1963), chapter 3. The strokes, the
 *             prediction and the series are ours.
 * Not modelled: several pens; tubes of fewer than 1024 units up (a cross beyond them is not seen).
 */
#ifndef ROMS_INTERACT_TRACKING_H
#define ROMS_INTERACT_TRACKING_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/geometry/vector.h"

enum {
    TRACKING_BYTES = 1536,
    TRACKING_PATIENCE = 8, /* refreshes without the pen, until it is lost */
    TRACKING_SAMPLES = 64,
};

enum tracking_state { TRACKING_LOST, TRACKING_FOLLOWING, TRACKING_SEARCHING };
/* Strokes, named by the arm that they begin with. */
enum tracking_arm { TRACKING_RIGHT, TRACKING_TOP, TRACKING_LEFT, TRACKING_BOTTOM, TRACKING_ARMS };

struct tracking_hit {
    bool seen;
    bool edge; /* the beam came in: not lit already where the stroke began */
    int at;    /* along its direction, head units */
};

/* One a refresh. */
struct tracking_sample {
    struct point2 at; /* where the pen was last */
    enum tracking_state state;
    bool pressed;
    uint32_t time; /* ticks, modulo 2^32 */
};

struct tracking_counts {
    uint32_t refreshes, followed, searches, found, losses, scans;
};

struct tracking {
    /* For the program to set after tracking_begin. */
    bool predicts;
    float radius;           /* half of what the pen sees across, for `one_way` */
    void (*others)(void *); /* a hit in words that are not the cross's; NULL: goes on */
    void *others_ctx;
    void (*place)(void *,
                  const struct tracking_sample *); /* called by tracking_frame; may be NULL */
    void *place_ctx;
    /* For the program to read. */
    enum tracking_state state;
    struct point2 at;       /* where the pen was last */
    struct point2 one_way;  /* what the right and the top stroke alone would say, less `radius` */
    struct point2 cross;    /* where the cross is drawn */
    struct point2 velocity; /* units a refresh, smoothed */
    struct tracking_hit arm[TRACKING_ARMS]; /* of the last cross */
    float reach;                            /* half a chord less v·d, as learnt */
    struct tracking_counts counts;
    uint32_t dropped;
    /* Private. */
    uint32_t low, next; /* display memory; where the refresh goes on */
    int drawing;        /* enum drawing of tracking.c */
    int start[TRACKING_ARMS];
    int tries, misses;
    int scans; /* still to be made */
    bool searched, wished;
    struct point2 planned, wish; /* of the cross, when this refresh began; of the program */
    struct tracking_hit now[TRACKING_ARMS];
    struct tracking_sample sample[TRACKING_SAMPLES];
    uint32_t made, taken;
};

/* The cross in the middle of the screen, lost. Words are written, none is drawn before something leads
 * to `low`: stage_chain(stage, low), in each picture. After them the refresh goes on at `next`, 0 or
 * where another display file is that the picture was to go on with. */
void tracking_begin(struct tracking *t, uint32_t low, uint32_t next);
/* The cross is elsewhere from the next refresh on, and waits there for the pen. */
void tracking_put(struct tracking *t, struct point2 at);
/* The next refreshes, three at most, scan the whole screen, unless the pen is followed. */
void tracking_scan(struct tracking *t);

enum tracking_state tracking_state(const struct tracking *t);
struct point2 tracking_position(const struct tracking *t);
/* The oldest sample that was not taken; false: there is none. */
bool tracking_take(struct tracking *t, struct tracking_sample *sample);
/* Takes all and calls `place` for each; false: no refresh has ended since. */
bool tracking_frame(struct tracking *t);

#endif
