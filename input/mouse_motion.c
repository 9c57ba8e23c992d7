#include "input/mouse_motion.h"

#define PM_PER_MM    1e9
#define RATE_SECONDS 1000

/* 128-bit integers are a compiler extension; __extension__ keeps -Wpedantic quiet about it. A way of 10 m is
 * 10^13 pm, times are below 2^63 ps, and their products, and those with a rate of 10^9, below 2^127. */
__extension__ typedef __int128 wide;

#define UNITS ((wide)RATE_SECONDS * (wide)CRT_PS_PER_S) /* ps in which `rate` counts go by */

static wide floor_of(wide a, wide b)
{
    wide q = a / b;
    return q * b > a ? q - 1 : q;
}

static wide ceil_of(wide a, wide b)
{
    return -floor_of(-a, b);
}

static int64_t magnitude(int64_t v)
{
    return v < 0 ? -v : v;
}

struct inp_mouse_pitch inp_mouse_pitch(const struct inp_mouse_setup *setup)
{
    bool optical = setup->kind == MOUSE_OPTICAL;
    double period = optical ? setup->line.value : setup->slot.value;
    int64_t quarter = (int64_t)(period * PM_PER_MM / 4 + 0.5);
    uint64_t rate = (uint64_t)(setup->fastest.value * RATE_SECONDS + 0.5);
    return (struct inp_mouse_pitch){quarter, optical ? 4 * quarter : quarter, rate};
}

int64_t inp_mouse_gone(const struct inp_mouse_axis *axis, struct inp_mouse_move move, uint64_t t)
{
    if (t >= move.t1)
        return axis->way;
    if (t <= move.t0)
        return 0;
    return (int64_t)floor_of((wide)axis->way * (wide)(t - move.t0), (wide)(move.t1 - move.t0));
}

uint64_t inp_mouse_crossed(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                           struct inp_mouse_pitch pitch, uint64_t t)
{
    int64_t place = axis->from + inp_mouse_gone(axis, move, t);
    wide cells = floor_of(place, pitch.cell) - axis->from / pitch.cell;
    return (uint64_t)magnitude((int64_t)cells);
}

/* A move of duration 0 is faster than anything. */
static bool too_fast(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                     struct inp_mouse_pitch pitch)
{
    wide time = (wide)(move.t1 - move.t0);
    return (wide)magnitude(axis->way) * UNITS > (wide)pitch.rate * pitch.cell * time;
}

uint64_t inp_mouse_taken(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                         struct inp_mouse_pitch pitch, uint64_t t)
{
    if (t > move.t1)
        t = move.t1;
    uint64_t crossed = inp_mouse_crossed(axis, move, pitch, t);
    if (crossed == 0 || !too_fast(axis, move, pitch))
        return crossed;
    if (t < axis->free)
        return 0;
    wide room = (wide)(t - axis->free) * (wide)pitch.rate / UNITS + 1;
    return room < (wide)crossed ? (uint64_t)room : crossed;
}

/* When the hand crosses count n > 0 of the move: upwards it is there when it reaches the edge, downwards
 * when it is below it. */
static wide crossing(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                     struct inp_mouse_pitch pitch, uint64_t n)
{
    wide time = (wide)(move.t1 - move.t0), cell = axis->from / pitch.cell;
    if (axis->way > 0) {
        wide edge = (cell + (wide)n) * pitch.cell;
        return (wide)move.t0 + ceil_of((edge - axis->from) * time, axis->way);
    }
    wide edge = (cell - (wide)n + 1) * pitch.cell;
    return (wide)move.t0 + floor_of((axis->from - edge) * time, -(wide)axis->way) + 1;
}

/* When the counter can take the count after so many of the move. */
static wide taking(const struct inp_mouse_axis *axis, struct inp_mouse_pitch pitch, uint64_t counts)
{
    return (wide)axis->free + ceil_of((wide)counts * UNITS, (wide)pitch.rate);
}

uint64_t inp_mouse_due(const struct inp_mouse_axis *axis, struct inp_mouse_move move,
                       struct inp_mouse_pitch pitch)
{
    uint64_t n = axis->done + 1;
    if (axis->way == 0 || n > inp_mouse_crossed(axis, move, pitch, move.t1))
        return UINT64_MAX;
    wide when = crossing(axis, move, pitch, n);
    if (too_fast(axis, move, pitch)) {
        wide ready = taking(axis, pitch, n - 1);
        when = ready > when ? ready : when;
    }
    return (uint64_t)when;
}

uint64_t inp_mouse_through(const struct inp_mouse_axis *axis, struct inp_mouse_pitch pitch,
                           uint64_t counts, uint64_t t)
{
    wide latest = (wide)t + ceil_of(UNITS, pitch.rate), when = taking(axis, pitch, counts);
    return (uint64_t)(when < latest ? when : latest);
}

int64_t inp_mouse_wrapped(int64_t place, struct inp_mouse_pitch pitch)
{
    int64_t period = 4 * pitch.quarter;
    int64_t rest = place % period;
    return rest < 0 ? rest + period : rest;
}

unsigned inp_mouse_quarter(int64_t place, struct inp_mouse_pitch pitch)
{
    return (unsigned)(inp_mouse_wrapped(place, pitch) / pitch.quarter);
}
