/* head_rig.h — a raster head with a buffer, and what came out of it.
 *
 * Lines, interrupts and new timings are noted as they come, up to RIG_NOTES of each; drives of the first
 * RIG_DOTS dots of a line with it. Header only; the buffer is freed by rig_close.
 */
#ifndef TESTS_HEAD_RIG_H
#define TESTS_HEAD_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "raster/head.h"

#define RIG_NOTES 4096
#define RIG_DOTS  256

struct rig_line {
    uint64_t t0, t1;
    float x0, x1, y;
    int dots, guns;
    uint32_t source;
    uint8_t drive[CRT_MAX_GUNS][RIG_DOTS];
};

struct rig_irq {
    enum ras_interrupt which;
    bool level;
    uint64_t t;
};

struct rig_retime {
    struct crt_rate field;
    uint64_t origin;
};

struct head_rig {
    struct ras_head head;
    uint8_t *buffer;
    struct rig_line *line;
    int lines, irqs, retimes;
    struct rig_irq irq[RIG_NOTES];
    struct rig_retime retime[16];
    uint64_t last_t1;
};

static inline void rig_see_line(void *ctx, const struct crt_scan_line *l)
{
    struct head_rig *r = ctx;
    assert_true(l->t1 > l->t0 && l->t0 >= r->last_t1);
    assert_true(l->dots > 0 && l->dots <= CRT_MAX_DOTS && l->y0 == l->y1 && l->x1 > l->x0);
    r->last_t1 = l->t1;
    assert_true(r->lines < RIG_NOTES);
    struct rig_line *n = &r->line[r->lines++];
    *n = (struct rig_line){.t0 = l->t0,
                           .t1 = l->t1,
                           .x0 = l->x0,
                           .x1 = l->x1,
                           .y = l->y0,
                           .dots = l->dots,
                           .guns = l->guns,
                           .source = l->source};
    for (int g = 0; g < l->guns; g++)
        memcpy(n->drive[g], l->drive[g], (size_t)(l->dots < RIG_DOTS ? l->dots : RIG_DOTS));
}

static inline void rig_see_irq(void *ctx, enum ras_interrupt which, bool level, uint64_t t)
{
    struct head_rig *r = ctx;
    assert_true(r->irqs < RIG_NOTES);
    r->irq[r->irqs++] = (struct rig_irq){which, level, t};
}

static inline void rig_see_retime(void *ctx, struct crt_rate field, uint64_t origin)
{
    struct head_rig *r = ctx;
    assert_true(r->retimes < 16);
    r->retime[r->retimes++] = (struct rig_retime){field, origin};
}

/* A monitor that follows everything. */
#define RIG_ANY_MONITOR                                                                            \
    {                                                                                              \
        0, 1e6, 0, 1e6, 1e4                                                                        \
    }

static inline struct head_rig *rig_open(const struct ras_timing *timing, int guns, double border_mm)
{
    struct head_rig *r = calloc(1, sizeof *r);
    assert_non_null(r);
    r->buffer = calloc(1, VIDEO_BUFFER_BYTES);
    r->line = calloc(RIG_NOTES, sizeof *r->line);
    assert_true(r->buffer && r->line);
    struct ras_head_desc desc = {
        .buffer = r->buffer,
        .width_mm = 320,
        .height_mm = 240,
        .border_mm = border_mm,
        .guns = guns,
        .monitor = RIG_ANY_MONITOR,
        .timing = *timing,
        .wires = {r, rig_see_line, rig_see_irq, rig_see_retime, NULL},
    };
    ras_head_init(&r->head, &desc);
    return r;
}

static inline void rig_close(struct head_rig *r)
{
    free(r->buffer);
    free(r->line);
    free(r);
}

static inline void rig_forget(struct head_rig *r)
{
    r->lines = r->irqs = r->retimes = 0;
}

/* Everything up to and at t. */
static inline void rig_run(struct head_rig *r, uint64_t t)
{
    while (ras_head_next(&r->head) <= t)
        ras_head_event(&r->head, ras_head_next(&r->head));
}

static inline void rig_write(struct head_rig *r, uint32_t offset, uint32_t value, uint64_t t)
{
    rig_run(r, t);
    assert_true(ras_head_write(&r->head, offset, value, t));
}

static inline uint32_t rig_read(struct head_rig *r, uint32_t offset, uint64_t t)
{
    uint32_t value = 0xdeadbeef;
    rig_run(r, t);
    assert_true(ras_head_read(&r->head, offset, t, &value));
    return value;
}

/* The time of a dot of a timing that began at `origin`, in the simplest way that is exact. */
static inline uint64_t rig_dot(const struct ras_timing *t, uint64_t origin, uint64_t dot)
{
    return origin + crt_tick_time(t->clock, dot);
}

/* 16 dots of 24 and 10 lines of 15, at 150 kHz: a frame lasts 2.4 ms. */
#define RIG_SMALL                                                                                  \
    {                                                                                              \
        .clock = {150000, 1}, .h = {16, 18, 21, 24}, .v = { 10, 11, 13, 15 }                       \
    }

/* xorshift64*. */
static inline uint64_t rig_random(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * UINT64_C(2685821657736338717) >> 16;
}

#endif
