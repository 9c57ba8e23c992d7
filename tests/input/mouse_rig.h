/* mouse_rig.h — a mouse with its setup and a hand; header only. */
#ifndef TESTS_MOUSE_RIG_H
#define TESTS_MOUSE_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "input/mouse.h"
#include "input/noise.h"

struct mouse_rig {
    struct inp_mouse_setup setup;
    struct inp_mouse mouse;
};

static inline void mouse_rig_setup(struct mouse_rig *r, unsigned kind)
{
    r->setup = (struct inp_mouse_setup){.kind = kind,
#define X(field, unit, figure, lowest, highest, meaning, from)                                     \
    .field = {.value = (figure), .low = (lowest), .high = (highest), .source = from},
                                        INP_MOUSE_FIGURES(X)
#undef X
    };
}

static inline void mouse_rig_power(struct mouse_rig *r)
{
    struct inp_mouse_desc desc = {&r->setup};
    inp_mouse_init(&r->mouse, &desc);
    inp_mouse_reset(&r->mouse, 0);
}

static inline void mouse_rig_open(struct mouse_rig *r, unsigned kind)
{
    mouse_rig_setup(r, kind);
    mouse_rig_power(r);
}

/* Even between low and high; the next of a fixed row of numbers. */
static inline double mouse_rig_roll(uint64_t *row, double low, double high)
{
    return low + (high - low) * inp_noise_even(88, (*row)++);
}

static inline uint32_t mouse_rig_get(const struct mouse_rig *r, uint32_t offset, uint64_t t)
{
    uint32_t value = 0xDEADBEEF;
    assert_true(inp_mouse_read(&r->mouse, offset, t, &value));
    return value;
}

static inline int32_t mouse_rig_x(const struct mouse_rig *r, uint64_t t)
{
    return (int32_t)mouse_rig_get(r, INPUT_MOUSE_X, t);
}

static inline int32_t mouse_rig_y(const struct mouse_rig *r, uint64_t t)
{
    return (int32_t)mouse_rig_get(r, INPUT_MOUSE_Y, t);
}

static inline void mouse_rig_clear(struct mouse_rig *r, uint64_t t)
{
    assert_true(inp_mouse_write(&r->mouse, INPUT_MOUSE_STATUS, MOUSE_MOVED | MOUSE_OVERRUN, t));
}

static inline void mouse_rig_act(struct mouse_rig *r, enum inp_verb verb, unsigned code, uint64_t t)
{
    struct inp_act act = {
        .t = t, .device = INP_MOUSE, .verb = (uint8_t)verb, .code = (uint8_t)code};
    inp_mouse_act(&r->mouse, &act, t);
}

/* By so many micrometres. */
static inline void mouse_rig_move(struct mouse_rig *r, uint64_t t, uint64_t duration, int32_t x,
                                  int32_t y)
{
    struct inp_act act = {.t = t, .duration = duration, .device = INP_MOUSE, .verb = INP_MOVE};
    act.x = x;
    act.y = y;
    inp_mouse_act(&r->mouse, &act, t);
}

/* All events up to and at `until`. */
static inline void mouse_rig_run(struct mouse_rig *r, uint64_t until)
{
    for (uint64_t t; (t = inp_mouse_next(&r->mouse)) <= until;)
        inp_mouse_event(&r->mouse, t);
}

#endif
