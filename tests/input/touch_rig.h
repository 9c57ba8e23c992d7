/* touch_rig.h — a touch panel with its setup, a finger, and a program that reads it; header only. */
#ifndef TESTS_TOUCH_RIG_H
#define TESTS_TOUCH_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "input/noise.h"
#include "input/touch.h"

struct touch_rig {
    struct inp_touch_setup setup;
    struct inp_touch touch;
};

static inline void touch_rig_open(struct touch_rig *r, unsigned kind, double width, double height)
{
    r->setup = (struct inp_touch_setup){.kind = kind,
                                        .screen = INP_RASTER,
#define X(field, unit, figure, lowest, highest, meaning, from)                                     \
    .field = {.value = (figure), .low = (lowest), .high = (highest), .source = from},
                                        INP_TOUCH_FIGURES(X)
#undef X
    };
    struct inp_touch_desc desc = {&r->setup, width, height, 1234};
    inp_touch_init(&r->touch, &desc);
}

/* Even between low and high; the next of a fixed row of numbers. */
static inline double touch_rig_roll(uint64_t *row, double low, double high)
{
    return low + (high - low) * inp_noise_even(77, (*row)++);
}

static inline uint32_t touch_rig_get(const struct touch_rig *r, uint32_t offset)
{
    uint32_t value = 0xDEADBEEF;
    assert_true(inp_touch_read(&r->touch, offset, &value));
    return value;
}

static inline void touch_rig_set(struct touch_rig *r, uint32_t offset, uint32_t value, uint64_t t)
{
    assert_true(inp_touch_write(&r->touch, offset, value, t));
}

static inline void touch_rig_put(struct touch_rig *r, uint64_t t, uint64_t duration, double x,
                                 double y, double newton)
{
    struct inp_act act = {.t = t, .duration = duration, .device = INP_TOUCH, .verb = INP_MOVE};
    act.x = (int32_t)(x * 1000 + (x < 0 ? -0.5 : 0.5));
    act.y = (int32_t)(y * 1000 + (y < 0 ? -0.5 : 0.5));
    act.z = (int32_t)(newton * 1000 + (newton < 0 ? -0.5 : 0.5));
    inp_touch_act(&r->touch, &act, t);
}

static inline void touch_rig_lift(struct touch_rig *r, uint64_t t)
{
    struct inp_act act = {.t = t, .device = INP_TOUCH, .verb = INP_AWAY};
    inp_touch_act(&r->touch, &act, t);
}

/* All events up to and at `until`; how many of them said that there is something new. */
static inline unsigned touch_rig_run(struct touch_rig *r, uint64_t until)
{
    unsigned told = 0;
    for (uint64_t t; (t = inp_touch_next(&r->touch)) <= until;)
        told += inp_touch_event(&r->touch, t);
    return told;
}

/* Switches on at 0, the finger being there, and takes the first report. */
static inline bool touch_rig_first(struct touch_rig *r)
{
    touch_rig_set(r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
    bool told = inp_touch_event(&r->touch, inp_touch_next(&r->touch));
    assert_int_equal(told, (touch_rig_get(r, INPUT_TOUCH_STATUS) & TOUCH_TOUCHED) != 0);
    return told;
}

static inline bool touch_rig_unsure(const struct touch_rig *r)
{
    return (touch_rig_get(r, INPUT_TOUCH_STATUS) & TOUCH_UNSURE) != 0;
}

/* Where the registers put a position on an axis (0 across, 1 up), mm from the middle of the screen. */
static inline double touch_rig_mm(const struct touch_rig *r, int axis, unsigned beam)
{
    bool across = axis == 0;
    double first = (int32_t)touch_rig_get(r, across ? INPUT_TOUCH_LEFT : INPUT_TOUCH_BOTTOM);
    double pitch = touch_rig_get(r, across ? INPUT_TOUCH_PITCH_X : INPUT_TOUCH_PITCH_Y);
    double extent = across ? r->touch.desc.width_mm : r->touch.desc.height_mm;
    return (first + pitch * beam) / 1000 - extent / 2;
}

/* Where a program puts the finger, mm from the middle of the screen. */
static inline double touch_rig_x(const struct touch_rig *r)
{
    double um = (int32_t)touch_rig_get(r, INPUT_TOUCH_LEFT) +
                touch_rig_get(r, INPUT_TOUCH_PITCH_X) * (touch_rig_get(r, INPUT_TOUCH_X) / 2.0);
    return um / 1000 - r->touch.desc.width_mm / 2;
}

static inline double touch_rig_y(const struct touch_rig *r)
{
    double um = (int32_t)touch_rig_get(r, INPUT_TOUCH_BOTTOM) +
                touch_rig_get(r, INPUT_TOUCH_PITCH_Y) * (touch_rig_get(r, INPUT_TOUCH_Y) / 2.0);
    return um / 1000 - r->touch.desc.height_mm / 2;
}

#endif
