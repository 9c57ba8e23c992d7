/* reference.h — what the display processor is compared on: fixed random sessions and their figures.
 *
 *      session: words, STARTs, RESUMEs, ticks ─▶ display processor ─▶ registers, lit units
 *                                                                            │
 *                            checkpoints, one per REF_INTERVAL words ◀───────┘
 *
 * Models:     a session is made by a generator that knows nothing of the processor but whether
 *             it runs, stands or waits. Each word is put where the processor fetches next, so
 *             jumps and wild addresses do not matter. Another implementation, given the same
 *             session, gave the figures that test_dpu_reference.c compares with.
 * Lit units:  what a beam path lights on a grid of whole head units: a vector one unit per unit
 *             of its longer axis, a character's dot 2 × 2 units. ref_keep() leaves out what two
 *             right implementations may do differently.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "display_file/df_regs.h"

#define REF_INTERVAL     1000
#define REF_SEED_VR17    1
#define REF_SEED_VR14    2
#define REF_SEED_PEN     4
#define REF_MEMORY_BYTES 0160000u /* so that one START in eight times out */

/* ---- the session --------------------------------------------------------------------------------
 */

enum ref_state { REF_STOPPED, REF_RUNNING, REF_WAITING_SYNC, REF_WAITING_RESUME };

/* Interrupts posted by an action, or-ed. */
enum { REF_STOP_INTERRUPT = 4, REF_PEN_INTERRUPT = 8, REF_CHARACTER_INTERRUPT = 16 };

enum ref_what { REF_WORD, REF_START, REF_RESUME, REF_TICK_LIT, REF_TICK_DARK };

struct ref_action {
    enum ref_what what; /* a tick also says which half of the blinking follows */
    uint16_t value;     /* the word; what is written to DPC */
};

/* A square the pen sees: units at most `radius` from (x, y) on either axis. */
struct ref_pen {
    int x, y, radius;
};

struct ref_session {
    uint64_t random;
    unsigned mode; /* of the last Set Graphic Mode made on purpose */
};

/* splitmix64 */
static inline uint64_t ref_random(uint64_t *state)
{
    uint64_t z = (*state += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static inline unsigned ref_below(struct ref_session *s, unsigned n)
{
    return (unsigned)((ref_random(&s->random) >> 32) * n >> 32);
}

static inline unsigned ref_bits(struct ref_session *s, unsigned mask)
{
    return (unsigned)(ref_random(&s->random) >> 20) & mask;
}

/* Mostly printing; any code comes. */
static inline unsigned ref_code(struct ref_session *s)
{
    return ref_below(s, 12) == 0 ? ref_bits(s, 037) : 040 + ref_below(s, 96);
}

static inline unsigned ref_data(struct ref_session *s)
{
    if (s->mode == DF_MODE_CHAR) {
        unsigned first = ref_code(s) | ref_bits(s, 0200); /* bit 7 means nothing */
        return first | ref_code(s) << 8;
    }
    if (s->mode == DF_MODE_LONG && ref_below(s, 2))
        return ref_bits(s, 077777 & ~01600u); /* short enough to stay on screen for a while */
    return ref_bits(s, 077777);
}

static inline unsigned ref_word(struct ref_session *s)
{
    static const unsigned spare[] = {7, 8, 9, 10, 11}; /* 8 is ignored, the others hang */
    unsigned r = ref_below(s, 256);

    if (r < 32) { /* points come more often: they bring the beam back on screen */
        s->mode = ref_below(s, 4) == 0 ? DF_MODE_POINT : ref_below(s, 7);
        return DF_SET_MODE | s->mode << DF_MODE_SHIFT | ref_bits(s, 03777);
    }
    if (r < 40)
        return DF_STATUS_A | ref_bits(s, 03777 & ~(unsigned)(DF_LSA_STOP | DF_LSA_SYNC));
    if (r < 44)
        return DF_STATUS_B | ref_bits(s, 03777);
    if (r < 46)
        return DF_NOP | ref_bits(s, 03777);
    if (r < 48)
        return DF_JUMP | ref_bits(s, 03777);
    if (r < 49)
        return DF_STOP | ref_bits(s, 01777);
    if (r < 50)
        return DF_STATUS_A | DF_LSA_SYNC | ref_bits(s, 01777);
    if (r < 51)
        return DF_CONTROL | spare[ref_below(s, 5)] << DF_MODE_SHIFT | ref_bits(s, 03777);
    if (r < 59)
        return ref_bits(s, 0177777);
    return ref_data(s);
}

static inline struct ref_action ref_next(struct ref_session *s, enum ref_state state)
{
    unsigned r = ref_below(s, 1024);

    if (state == REF_WAITING_SYNC && r >= 128)
        return (struct ref_action){ref_below(s, 2) ? REF_TICK_LIT : REF_TICK_DARK, 0};
    if (state == REF_RUNNING && r >= 2)
        return (struct ref_action){REF_WORD, (uint16_t)ref_word(s)};
    if (ref_below(s, 2))
        return (struct ref_action){REF_RESUME, (uint16_t)(ref_bits(s, 0177777) | 1)};
    return (struct ref_action){REF_START, (uint16_t)ref_bits(s, 0177776)};
}

static inline void ref_move_pen(struct ref_session *s, struct ref_pen *pen)
{
    if (pen->radius && ref_below(s, 100) != 0)
        return;
    pen->x = (int)ref_below(s, 1024);
    pen->y = (int)ref_below(s, 1024);
    pen->radius = (int)ref_below(s, 400) + 1;
}

static inline bool ref_pen_sees(const struct ref_pen *pen, int x, int y)
{
    return abs(x - pen->x) <= pen->radius && abs(y - pen->y) <= pen->radius;
}

/* ---- lit units ----------------------------------------------------------------------------------
 */

enum ref_kind { REF_POINTS, REF_VECTOR, REF_CHARACTERS };

/* What an action drew, and where it started and ended before wrapping. */
struct ref_drawing {
    enum ref_kind kind;
    int x0, y0, x1, y1;
    bool italics;
    int rows; /* units up the screen */
};

/* Units of the longer axis; *across is the way along the other one. */
static inline int ref_units(const struct ref_drawing *d, int *across)
{
    int dx = abs(d->x1 - d->x0), dy = abs(d->y1 - d->y0);
    *across = dx > dy ? dy : dx;
    return dx > dy ? dx : dy;
}

/* Unit k of a vector, nearest to the line; halves go away from the start. */
static inline void ref_vector_unit(const struct ref_drawing *d, int k, int *x, int *y)
{
    int across, units = ref_units(d, &across);
    int side = (2 * across * k + units) / (2 * units);
    bool along_x = abs(d->x1 - d->x0) > abs(d->y1 - d->y0);
    int step_x = d->x1 < d->x0 ? -1 : 1, step_y = d->y1 < d->y0 ? -1 : 1;

    *x = d->x0 + step_x * (along_x ? k : side);
    *y = d->y0 + step_y * (along_x ? side : k);
}

/* Which position registers are compared while they show a pen hit: those along a vector. */
static inline bool ref_reads_x(const struct ref_drawing *d)
{
    return d->kind != REF_VECTOR || abs(d->x1 - d->x0) >= abs(d->y1 - d->y0);
}

static inline bool ref_reads_y(const struct ref_drawing *d)
{
    return d->kind != REF_VECTOR || abs(d->x1 - d->x0) < abs(d->y1 - d->y0);
}

/* Is a lit unit one of those compared? A unit that is exactly half-way between two becomes the
 * one farther from the start. */
static inline bool ref_keep(const struct ref_drawing *d, int *x, int *y)
{
    if (d->kind == REF_VECTOR) {
        int across, units = ref_units(d, &across);
        bool along_x = abs(d->x1 - d->x0) > abs(d->y1 - d->y0);
        int k = along_x ? abs(*x - d->x0) : abs(*y - d->y0);
        int side = along_x ? abs(*y - d->y0) : abs(*x - d->x0);
        int nearest = (2 * across * k + units) / (2 * units);

        if (2 * across * k % (2 * units) == units && side == nearest - 1)
            ref_vector_unit(d, k, x, y);
    } else if (d->kind == REF_CHARACTERS) {
        bool upper = (*y - d->y0) & 1; /* half of a dot; line feeds are even */
        if ((*y == d->rows - 1 && !upper) || (*y == 0 && upper))
            return false; /* the dot is half off screen */
        if (d->italics && (upper || *x >= 1022))
            return false; /* upper halves lean by their own rules */
    }
    return true;
}

/* ---- figures ------------------------------------------------------------------------------------
 */

/* Over the words of one interval and the other actions between them. */
struct ref_checkpoint {
    uint32_t registers; /* of state, interrupts, DPC, MPR, XPR, YPR, action by action */
    uint32_t count; /* units lit; with a pen, pen interrupts and intensify spots of those hits */
    uint32_t units; /* of the lit units and their levels, in any order within an action */
};

static inline uint32_t ref_mix(uint32_t sum, uint32_t value)
{
    uint64_t state = (uint64_t)sum << 32 | value;
    return (uint32_t)ref_random(&state);
}

static inline void ref_add_unit(struct ref_checkpoint *c, const struct ref_drawing *d, int x, int y,
                                unsigned level, uint32_t word)
{
    if (!ref_keep(d, &x, &y))
        return;
    c->count++;
    c->units += ref_mix(word, (uint32_t)x | (uint32_t)y << 12 | level << 24);
}

#endif
