/* tablet_rig.h — a tablet with every figure as listed, a hand, and the time: what its tests share. Header
 * only.
 */
#ifndef TESTS_TABLET_RIG_H
#define TESTS_TABLET_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "input/tablet.h"

struct tablet_rig {
    struct inp_tablet_setup setup;
    struct inp_tablet tablet;
    uint64_t now, seed;
};

static inline void rig_setup(struct inp_tablet_setup *setup, unsigned kind)
{
    *setup = (struct inp_tablet_setup){.kind = kind};
#define X(field, unit, is, least, most, meaning, from)                                             \
    setup->field = (struct crt_figure){is, least, most, from};
    INP_TABLET_FIGURES(X)
#undef X
}

/* Counts of 10 µm, so that rounding hides nothing. Figures may be changed until the first event. */
static inline void rig_open(struct tablet_rig *r, unsigned kind)
{
    *r = (struct tablet_rig){.seed = 88172645463325252};
    rig_setup(&r->setup, kind);
    r->setup.resolution.value = 0.01;
    struct inp_tablet_desc desc = {&r->setup, 5};
    inp_tablet_init(&r->tablet, &desc);
}

static inline uint64_t rig_bits(struct tablet_rig *r)
{
    r->seed ^= r->seed << 13;
    r->seed ^= r->seed >> 7;
    return r->seed ^= r->seed << 17;
}

static inline double rig_between(struct tablet_rig *r, double low, double high)
{
    return low + (high - low) * (double)(rig_bits(r) >> 11) / 9007199254740992.0;
}

static inline uint32_t rig_read(const struct tablet_rig *r, uint32_t offset)
{
    uint32_t value = 0xDEADBEEF;
    assert_true(inp_tablet_read(&r->tablet, offset, &value));
    return value;
}

static inline void rig_write(struct tablet_rig *r, uint32_t offset, uint32_t value)
{
    assert_true(inp_tablet_write(&r->tablet, offset, value, r->now));
}

static inline void rig_act(struct tablet_rig *r, enum inp_verb verb, unsigned code)
{
    struct inp_act act = {
        .t = r->now, .device = INP_TABLET, .verb = (uint8_t)verb, .code = (uint8_t)code};
    inp_tablet_act(&r->tablet, &act, r->now);
}

static inline int32_t rig_um(double mm)
{
    return (int32_t)lround(mm * 1000);
}

static inline void rig_move(struct tablet_rig *r, double x, double y, double z, uint64_t duration)
{
    struct inp_act act = {.t = r->now,
                          .device = INP_TABLET,
                          .verb = INP_MOVE,
                          .x = rig_um(x),
                          .y = rig_um(y),
                          .z = rig_um(z),
                          .duration = duration};
    inp_tablet_act(&r->tablet, &act, r->now);
}

/* To the next measurement; whether it made a report. */
static inline bool rig_event(struct tablet_rig *r)
{
    uint64_t t = inp_tablet_next(&r->tablet);
    assert_true(t != UINT64_MAX && t > r->now);
    r->now = t;
    return inp_tablet_event(&r->tablet, t);
}

static inline void rig_on(struct tablet_rig *r, uint32_t more)
{
    rig_write(r, INPUT_TABLET_CONTROL, TABLET_ON | more);
}

/* What the program sees, mm. */
struct rig_seen {
    double x, y, z;
    unsigned proximity, buttons, serial;
};

static inline struct rig_seen rig_take(struct tablet_rig *r)
{
    assert_true(rig_read(r, INPUT_TABLET_STATUS) & TABLET_REPORT);
    double mm = rig_read(r, INPUT_TABLET_UNIT) / 1e6;
    struct rig_seen seen = {
        .x = (int32_t)rig_read(r, INPUT_TABLET_X) * mm,
        .y = (int32_t)rig_read(r, INPUT_TABLET_Y) * mm,
        .z = (int32_t)rig_read(r, INPUT_TABLET_Z) * mm,
        .proximity = rig_read(r, INPUT_TABLET_PROXIMITY),
        .buttons = rig_read(r, INPUT_TABLET_BUTTONS),
        .serial = rig_read(r, INPUT_TABLET_SERIAL),
    };
    rig_write(r, INPUT_TABLET_STATUS, TABLET_REPORT);
    return seen;
}

/* One measurement with the hand at x, y, z; false: none was reported, or it was far. */
static inline bool rig_measure(struct tablet_rig *r, double x, double y, double z,
                               struct rig_seen *seen)
{
    *seen = (struct rig_seen){0};
    if (!(rig_read(r, INPUT_TABLET_CONTROL) & TABLET_ON))
        rig_on(r, 0);
    rig_move(r, x, y, z, 0);
    if (!rig_event(r))
        return false;
    *seen = rig_take(r);
    return seen->proximity != TABLET_FAR;
}

/* Mean, root mean square and greatest of a number of errors. */
struct rig_errors {
    double sum, squares, most;
    unsigned count;
};

static inline void rig_add(struct rig_errors *e, double error)
{
    e->sum += error;
    e->squares += error * error;
    e->most = fabs(error) > e->most ? fabs(error) : e->most;
    e->count++;
}

static inline double rig_rms(const struct rig_errors *e)
{
    return sqrt(e->squares / e->count);
}

static inline double rig_mean(const struct rig_errors *e)
{
    return e->sum / e->count;
}

static inline void rig_within(double value, double low, double high)
{
    if (!(value >= low && value <= high))
        fail_msg("%g does not lie between %g and %g", value, low, high);
}

#endif
