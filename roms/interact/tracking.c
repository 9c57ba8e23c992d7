/* tracking.c — what is done with hits, and at the end of each try and each refresh. */
#include "roms/interact/tracking.h"

#include <stdlib.h>

#include "roms/bsp/board.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/input.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"
#include "roms/geometry/scalar.h"
#include "roms/interact/tracking_words.h"

enum drawing { DRAWING_CROSS, DRAWING_MARK, DRAWING_SEARCH };

enum {
    ARM = 24, /* of a cross that is followed */
    ARM_MOST = 96,
    TRIES = 7,      /* crosses a refresh, at most */
    EDGE = 2,       /* so near a stroke's start the beam was in sight from the start */
    ARM_LEAST = 16, /* an arm that the edge of the screen cuts shorter begins in sight of the pen */
    REACH_MOST = 24, /* a chord longer than twice that is none of a pen's */
    CENTRED = 3,     /* so near the pen's middle chords are its diameters */
    SCANS = 3,
    MIDDLE = 512,
};

#define REACH_FIRST   5.0f /* before it is learnt: a pen of 3 mm on a VR17 */
#define LEARN         0.25f
#define SMOOTH        0.7f
#define STILL         1.0f /* units a refresh that may be rounding */
#define SPIRAL_FIRST  110.0f
#define SPIRAL_GROWTH 70.0f
#define SPIRAL_MOST   250.0f

/* ---- what a cross has shown ------------------------------------------------------------------ */

/* How well one axis is known. */
enum known { UNSEEN, VAGUE, ONE_WAY, BOTH_WAYS };

static bool is_chord(float half)
{
    return half <= REACH_MOST && half >= -REACH_MOST;
}

/* `high`: the stroke that went down the axis, `low`: up. */
static enum known axis(const struct tracking *t, enum tracking_arm high, enum tracking_arm low,
                       float *place)
{
    const struct tracking_hit *a = &t->now[high], *b = &t->now[low];
    bool down = a->seen && a->edge, up = b->seen && b->edge;
    if (down && up && is_chord((float)(a->at - b->at) / 2))
        *place = (float)(a->at + b->at) / 2;
    else if (down)
        *place = (float)a->at - t->reach;
    else if (up)
        *place = (float)b->at + t->reach;
    else if (a->seen || b->seen)
        *place = (float)(a->seen ? a->at : b->at);
    if (down && up)
        return is_chord((float)(a->at - b->at) / 2) ? BOTH_WAYS : VAGUE;
    return down || up ? ONE_WAY : a->seen || b->seen ? VAGUE : UNSEEN;
}

/* Chords near the pen's middle are its diameters. */
static void learn(struct tracking *t, enum tracking_arm high, enum tracking_arm low)
{
    const struct tracking_hit *a = &t->now[high], *b = &t->now[low];
    float half = (float)(a->at - b->at) / 2;
    if (a->seen && b->seen && a->edge && b->edge && is_chord(half))
        t->reach += LEARN * (half - t->reach);
}

static void sight(struct tracking *t, int arm, int at)
{
    int middle = (int)(arm % 2 == 0 ? t->cross.x : t->cross.y);
    t->now[arm] = (struct tracking_hit){
        true, abs(at - t->start[arm]) > EDGE && abs(middle - t->start[arm]) >= ARM_LEAST, at};
}

/* ---- drawing ------------------------------------------------------------------------------------ */

static void forget_hits(struct tracking *t)
{
    for (int i = 0; i < TRACKING_ARMS; i++)
        t->now[i] = (struct tracking_hit){0};
}

static void write_cross(struct tracking *t, struct point2 at, float half)
{
    forget_hits(t);
    t->drawing = DRAWING_CROSS;
    tracking_write_cross(t, TRACKING_CROSS, at, half);
}

static void try_at(struct tracking *t, struct point2 at)
{
    t->tries++;
    write_cross(t, at, ARM);
    dpu_start(t->low);
}

static void search(struct tracking *t)
{
    float radius = scalar_min(SPIRAL_FIRST + SPIRAL_GROWTH * (float)t->misses, SPIRAL_MOST);
    t->searched = true;
    t->counts.searches++;
    t->drawing = DRAWING_SEARCH;
    tracking_write_spiral(t, t->tries > 1 ? t->cross : t->at, t->misses % 3, radius);
    dpu_start(tracking_search(t));
}

static void scan(struct tracking *t)
{
    t->counts.scans++;
    t->drawing = DRAWING_SEARCH;
    tracking_write_scan(t, --t->scans);
    dpu_start(tracking_search(t));
}

/* For the next refresh. */
static void write_next(struct tracking *t, struct point2 at)
{
    forget_hits(t);
    t->tries = 1;
    t->searched = false;
    t->planned = at;
    if (t->state == TRACKING_LOST) {
        t->drawing = DRAWING_MARK;
        tracking_write_cross(t, TRACKING_MARK, at, ARM);
        return;
    }
    write_cross(t, at, scalar_min((float)(ARM * (1 + t->misses)), ARM_MOST));
}

/* ---- the end of a refresh ------------------------------------------------------------------------ */

static void note(struct tracking *t)
{
    if (t->made - t->taken == TRACKING_SAMPLES) {
        t->taken++;
        t->dropped++;
    }
    t->sample[t->made++ % TRACKING_SAMPLES] =
        (struct tracking_sample){t->at, t->state, pen_tip(INPUT_VECTOR), (uint32_t)timer_now()};
}

/* Where it had to be searched, what was known of its speed was wrong. */
static float speed_of(const struct tracking *t, float now, float before, float speed)
{
    float measured = (now - before) / (float)(t->misses + 1);
    return t->searched ? measured : speed + SMOOTH * (measured - speed);
}

static struct point2 ahead(const struct tracking *t)
{
    struct point2 v = t->velocity;
    bool still = v.x * v.x + v.y * v.y < STILL * STILL;
    if (!t->predicts || still)
        return t->at;
    return (struct point2){scalar_clamp(t->at.x + v.x, 0, 1023),
                           scalar_clamp(t->at.y + v.y, 0, 1023)};
}

static void leave(struct tracking *t, struct point2 next)
{
    if (t->wished && t->state != TRACKING_LOST)
        t->counts.losses++;
    if (t->wished) {
        t->state = TRACKING_LOST;
        next = t->wish;
    }
    t->wished = false;
    t->counts.refreshes++;
    board_refresh(t->counts.refreshes);
    note(t);
    for (int i = 0; i < TRACKING_ARMS; i++)
        t->arm[i] = t->now[i];
    write_next(t, next);
    dpu_start(tracking_exit(t));
}

static bool is_centred(const struct tracking *t, struct point2 at)
{
    return fabsf(at.x - t->cross.x) <= CENTRED && fabsf(at.y - t->cross.y) <= CENTRED;
}

static void seen_at(struct tracking *t, struct point2 at)
{
    if (is_centred(t, at)) {
        learn(t, TRACKING_RIGHT, TRACKING_LEFT);
        learn(t, TRACKING_TOP, TRACKING_BOTTOM);
    }
    t->one_way = (struct point2){(float)t->now[TRACKING_RIGHT].at - t->radius,
                                 (float)t->now[TRACKING_TOP].at - t->radius};
    if (t->state == TRACKING_LOST)
        t->velocity = (struct point2){0, 0};
    else
        t->velocity = (struct point2){speed_of(t, at.x, t->at.x, t->velocity.x),
                                      speed_of(t, at.y, t->at.y, t->velocity.y)};
    t->counts.found += t->state != TRACKING_FOLLOWING;
    t->counts.followed++;
    t->at = at;
    t->misses = 0;
    t->state = TRACKING_FOLLOWING;
    t->scans = 0;
    leave(t, ahead(t));
}

static void missed(struct tracking *t)
{
    if (t->state != TRACKING_LOST && ++t->misses >= TRACKING_PATIENCE) {
        t->state = TRACKING_LOST;
        t->counts.losses++;
        t->misses = 0;
    } else if (t->state != TRACKING_LOST) {
        t->state = TRACKING_SEARCHING;
    }
    t->velocity = (struct point2){0, 0};
    leave(t, t->state == TRACKING_LOST ? t->planned : t->tries > 1 ? t->cross : t->at);
}

/* ---- interrupts ---------------------------------------------------------------------------------- */

/* Two ways are exact wherever the cross is; one way is only in the middle, where chords are as learnt. */
static void cross_ended(struct tracking *t)
{
    struct point2 at = t->cross;
    enum known x = axis(t, TRACKING_RIGHT, TRACKING_LEFT, &at.x);
    enum known y = axis(t, TRACKING_TOP, TRACKING_BOTTOM, &at.y);
    bool known = x >= ONE_WAY && y >= ONE_WAY, exact = x == BOTH_WAYS && y == BOTH_WAYS;
    bool more = t->tries < TRIES;
    if (exact || (known && (is_centred(t, at) || !more)))
        seen_at(t, at);
    else if ((x != UNSEEN || y != UNSEEN) && more)
        try_at(t, at);
    else if (!t->searched && t->state != TRACKING_LOST)
        search(t);
    else
        missed(t);
}

static void stopped(void *ctx)
{
    struct tracking *t = ctx;
    uint32_t pc = dpu_pc();
    if (!tracking_owns(t, pc))
        dpu_resume();
    else if (tracking_is_search_end(t, pc))
        missed(t);
    else if (t->drawing == DRAWING_CROSS)
        cross_ended(t);
    else if (t->scans > 0)
        scan(t);
    else
        missed(t);
}

static void hit(void *ctx)
{
    struct tracking *t = ctx;
    uint32_t pc = dpu_pc();
    struct point2 at = {(float)dpu_x(), (float)dpu_y()};
    if (!tracking_owns(t, pc)) {
        if (t->others)
            t->others(t->others_ctx);
        else
            dpu_resume();
        return;
    }
    int arm = tracking_arm_before(t, pc);
    if (t->drawing == DRAWING_CROSS) {
        if (arm >= 0)
            sight(t, arm, (int)(arm % 2 == 0 ? at.x : at.y));
        dpu_resume();
        return;
    }
    if (t->drawing == DRAWING_SEARCH) {
        struct point2 way = tracking_way_before(pc);
        at.x += way.x * t->reach;
        at.y += way.y * t->reach;
    }
    try_at(t, at);
}

/* ---- for the program ----------------------------------------------------------------------------- */

void tracking_begin(struct tracking *t, uint32_t low, uint32_t next)
{
    *t = (struct tracking){.predicts = true,
                           .radius = 6.5f,
                           .state = TRACKING_LOST,
                           .at = {MIDDLE, MIDDLE},
                           .reach = REACH_FIRST,
                           .low = low,
                           .next = next};
    tracking_write_exit(t);
    write_next(t, t->at);
    dpu_on_pen(hit, t);
    dpu_on_stop(stopped, t);
}

void tracking_put(struct tracking *t, struct point2 at)
{
    uint32_t state = irq_lock();
    t->wished = true;
    t->wish = at;
    irq_unlock(state);
}

void tracking_scan(struct tracking *t)
{
    t->scans = SCANS;
}

enum tracking_state tracking_state(const struct tracking *t)
{
    return t->state;
}

struct point2 tracking_position(const struct tracking *t)
{
    uint32_t state = irq_lock();
    struct point2 at = t->at;
    irq_unlock(state);
    return at;
}

bool tracking_take(struct tracking *t, struct tracking_sample *sample)
{
    uint32_t state = irq_lock();
    bool any = t->made != t->taken;
    if (any)
        *sample = t->sample[t->taken++ % TRACKING_SAMPLES];
    irq_unlock(state);
    return any;
}

bool tracking_frame(struct tracking *t)
{
    struct tracking_sample sample;
    bool any = false;
    while (tracking_take(t, &sample)) {
        any = true;
        if (t->place)
            t->place(t->place_ctx, &sample);
    }
    return any;
}
