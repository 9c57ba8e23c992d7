/* dpu_rig.h — a display processor on the bench: memory, a recorder of strokes and lines, a
 * synthetic pen.
 *
 * The screen is 1024 × 1024 mm of 1024 × 1024 units, so that unit u lies at u − 511.5 mm.
 * The times are those of RIG_TIMING, chosen to be added up by hand.
 */
#ifndef TESTS_DPU_RIG_H
#define TESTS_DPU_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "display_file/df_regs.h"
#include "display_file/dpu.h"

#define NS UINT64_C(1000)    /* ps */
#define US UINT64_C(1000000) /* ps */

/* Fetch 1.5 µs; vector 2 µs + 0.1 µs a unit; settle 1 µs + 18 ns a unit, 18 µs at most; point 1 µs;
 * character 15 µs with dots of 0.25 µs; intensify spot 20 µs. */
#define RIG_TIMING                                                                                 \
    {                                                                                              \
        .fetch_ps = 1500 * NS, .vector_setup_ps = 2 * US, .vector_unit_ps = 100 * NS,              \
        .settle_ps = 1 * US, .settle_unit_ps = 18 * NS, .settle_max_ps = 18 * US,                  \
        .point_ps = 1 * US, .character_ps = 15 * US, .dot_ps = 250 * NS, .intensify_ps = 20 * US   \
    }
#define FETCH (1500 * NS)

#define RIG_STROKES    8192
#define DPU_RIG_EVENTS 64

struct dpu_rig_event {
    enum df_interrupt line;
    bool level;
    uint64_t t;
};

struct dpu_rig {
    struct df_dpu dpu;
    struct df_dpu_desc desc;
    uint16_t memory[32768];
    struct crt_stroke strokes[RIG_STROKES];
    size_t count;
    struct dpu_rig_event events[DPU_RIG_EVENTS];
    size_t event_count;
    unsigned bells;
    uint64_t pen_at; /* fires in the stroke that contains this time; UINT64_MAX: no pen light */
    uint64_t offered;
};

/* Fills memory with stops, connects everything, leaves the processor reset at 0. */
void dpu_rig_init(struct dpu_rig *r);
/* The same again with what the caller changed in r->desc. */
void dpu_rig_restart(struct dpu_rig *r);
void dpu_rig_load(struct dpu_rig *r, uint16_t address, const uint16_t *words, size_t count);
#define LOAD(r, address, ...)                                                                      \
    dpu_rig_load(r, address, (const uint16_t[]){__VA_ARGS__},                                      \
                 sizeof((const uint16_t[]){__VA_ARGS__}) / sizeof(uint16_t))
/* START at the address and now; runs until the processor is no longer running (at most 10000
 * words). */
void dpu_rig_go(struct dpu_rig *r, uint16_t address);
void dpu_rig_continue(struct dpu_rig *r);
/* Loads at 0 what is given and a stop behind it, and runs it. */
#define RUN(r, ...)                                                                                \
    do {                                                                                           \
        LOAD(r, 0, __VA_ARGS__, DF_STOP);                                                          \
        dpu_rig_go(r, 0);                                                                          \
    } while (0)

uint16_t dpu_rig_reg(const struct dpu_rig *r, unsigned offset);
/* A stroke's ends in head units. */
double rig_x0(const struct crt_stroke *s);
double rig_y0(const struct crt_stroke *s);
double rig_x1(const struct crt_stroke *s);
double rig_y1(const struct crt_stroke *s);

/* Stroke `index` goes from (x0, y0) to (x1, y1). */
void dpu_rig_expect_stroke(const struct dpu_rig *r, size_t index, double x0, double y0, double x1,
                           double y1);

#endif
