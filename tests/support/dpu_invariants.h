/* dpu_invariants.h — what must hold of a display processor whatever it is fed, for the random test
 * and the fuzzer.
 *
 * Strokes: in order, not overlapping, t1 > t0, on the screen (a slanted dot included), drive 0…1,
 * from an even address. Words: time advances, the state is valid, no stroke ends after the next
 * fetch. Header only, so that the fuzzer needs no library. Failure: one line and abort().
 */
#ifndef TESTS_DPU_INVARIANTS_H
#define TESTS_DPU_INVARIANTS_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "display_file/dpu.h"

struct dpu_watch {
    struct df_dpu *dpu;
    uint64_t last_t1;
    uint64_t strokes;
    uint64_t pen; /* the synthetic pen's state; 0: no pen */
    unsigned bells;
    bool lines[DF_INT_COUNT];
    uint64_t line_t;
};

#define WATCH(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #condition);                \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* Times of about a VT11's, with rests. By name: a field that is added cannot shift the others. */
#define DPU_WATCH_TIMING                                                                           \
    {                                                                                              \
        .fetch_ps = 1500000, .vector_setup_ps = 2000000, .vector_unit_ps = 100000,                 \
        .vector_rest_ps = 100000, .settle_ps = 1000000, .settle_unit_ps = 18000,                   \
        .settle_max_ps = 18000000, .point_ps = 1000000, .character_ps = 15000000,                  \
        .dot_ps = 250000, .intensify_ps = 20000000, .colour_switch_ps = 100000000                  \
    }

/* xorshift64*: the same numbers everywhere. */
static inline uint64_t dpu_random(uint64_t *state)
{
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return *state * UINT64_C(2685821657736338717);
}

/* Fires somewhere in about one stroke of eight, at times beside it. */
static inline uint64_t dpu_watch_offer(void *ctx, const struct crt_stroke *s)
{
    struct dpu_watch *w = ctx;
    if (w->pen == 0)
        return DF_NO_HIT;
    uint64_t n = dpu_random(&w->pen);
    if (n % 8)
        return DF_NO_HIT;
    if (n % 1024 == 0)
        return s->t0 / 2; /* too early: a pen ought not, the processor must not mind */
    return s->t0 + (n >> 10) % (s->t1 - s->t0 + 2);
}

static inline void dpu_watch_commit(void *ctx, const struct crt_stroke *s)
{
    struct dpu_watch *w = ctx;
    const struct crt_screen *screen = &w->dpu->desc.screen;
    double half_w = screen->width_mm / 2, half_h = screen->height_mm / 2;

    WATCH(s->t1 > s->t0);
    WATCH(s->t0 >= w->last_t1);
    WATCH(s->t0 >= w->dpu->t);
    WATCH(fabs((double)s->x0) <= half_w && fabs((double)s->x1) <= half_w);
    WATCH(fabs((double)s->y0) <= half_h && fabs((double)s->y1) <= half_h);
    WATCH(s->drive >= 0 && s->drive <= 1);
    WATCH(s->level == (unsigned)df_dpu_level(w->dpu) && s->level <= CRT_LEVEL_GREEN);
    WATCH(s->source < 0x10000 && s->source % 2 == 0 && s->source < w->dpu->desc.memory_bytes);
    w->last_t1 = s->t1;
    w->strokes++;
}

static inline void dpu_watch_interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    struct dpu_watch *w = ctx;
    WATCH(line < DF_INT_COUNT && w->lines[line] != level);
    WATCH(t >= w->line_t);
    w->lines[line] = level;
    w->line_t = t;
}

static inline void dpu_watch_bell(void *ctx, uint64_t t)
{
    struct dpu_watch *w = ctx;
    (void)t;
    w->bells++;
}

static inline void dpu_watch_state(const struct dpu_watch *w)
{
    const struct df_dpu *d = w->dpu;

    WATCH(d->state <= DF_WAITING_RESUME);
    WATCH(d->dpc % 2 == 0);
    WATCH(d->mode <= 6 && d->opcode <= 15 && d->intensity <= 7 && d->line_type <= 3);
    WATCH(d->colour <= 3 && (d->colour == 0 || d->desc.personality == DF_VS60));
    WATCH(d->step <= 63 && d->phase <= 2 && d->character <= 0177);
    WATCH(d->x >= -2048 && d->x <= 2047 && d->y >= -2048 && d->y <= 2047);
    WATCH(d->hit_x <= 1023 && d->hit_y <= 1023);
    WATCH(d->t >= w->last_t1);
    WATCH(!d->vector.active || d->state == DF_WAITING_RESUME);
    WATCH(!d->second.active || d->state == DF_WAITING_RESUME);
    WATCH(!d->stopping);
    WATCH(!d->illegal || d->state == DF_RUNNING);
    WATCH(d->usage.strokes == w->strokes);
    for (int line = 0; line < DF_INT_COUNT; line++)
        WATCH(d->pending[line] == w->lines[line]);
    WATCH(d->state == DF_STOPPED || !d->pending[DF_INT_STOP]);
    WATCH(d->state == DF_WAITING_RESUME || !d->pending[DF_INT_PEN]);
    WATCH(d->state == DF_WAITING_RESUME || !d->pending[DF_INT_CHARACTER]);
    for (unsigned offset = 0; offset < 8; offset += 2)
        (void)df_dpu_read(d, offset);
}

static inline void dpu_watch_step(struct dpu_watch *w)
{
    uint64_t before = w->dpu->t;
    df_dpu_step(w->dpu);
    WATCH(w->dpu->t > before);
    dpu_watch_state(w);
}

#endif
