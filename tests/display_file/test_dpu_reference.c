/* test_dpu_reference.c — the display processor against figures of an independent one, word by word.
 *
 * Source:     dpu_reference_*.inc hold figures obtained from open-simh's display/vt11.c (repository
 *             open-simh/simh), set up as a VT11 at full resolution, on the sessions of reference.h:
 *             state, interrupts and registers after every word, and the units it lights, as one
 *             line of checksums per 1000 words. A mistake shows as the first interval to differ.
 *
 * Over these sessions and millions of further words the registers never differed without a pen.
 * What did differ, and what was done so that the figures can be compared all the same:
 *   - It keeps positions in 32 bits; the VT11 and we wrap at 12 bits, as its own comments say the
 *     hardware does. Its positions were wrapped between words.
 *   - Its dot patterns are its own; ours were put in their place, with our descenders.
 *   - A vector unit exactly half-way between two rows or columns: its two-step line algorithm
 *     takes either (one in five the nearer to the start). Both count as the same unit.
 *   - A dot half over the top or bottom edge: it lights the half on screen; ours is one spot
 *     whose centre is off screen, and stays dark. Such dots are not compared.
 *   - Italics: it shifts half dots by a rule that also looks at the neighbouring column. Lower
 *     halves follow the same slant of one in three as ours and are compared; upper halves are
 *     not, nor is what leans over the right edge.
 *   - It blinks and synchronises by its host's clock; both were driven by the session's ticks.
 *   - A second character that waits for RESUME is drawn by its next cycle, by ours at once.
 * With a pen (state, interrupts, registers and intensify spots are compared):
 *   - It sees no light below level 3; to us that is the pen's business. The pen here is as blind.
 *   - A hit in a word's first character stops it after the second, us after the first. The pen
 *     here does not look at characters.
 *   - It takes the coordinate across the vector from a tangent cut to 12 bits, at times a unit
 *     nearer to the start than the unit lit; ours is the unit lit. Only the other is compared.
 *   - A hit one unit before the end: it lights the last unit all the same and latches that one.
 *     Rare; none in this session.
 *   - What RESUME draws of a vector is a new line to it, so its units may lie one beside ours.
 *   - With several units in view and the interrupt off, its last hit counts and our first, which
 *     no register shows.
 *   - It divides by zero when a vector clipped to a single unit follows a hit. That step, which
 *     draws nothing on a VT11, was left out.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "crt/geometry.h"
#include "crt/ticks.h"
#include "display_file/dpu.h"
#include "tests/display_file/reference.h"

#define BLINK_HALF_PS (266 * CRT_PS_PER_MS)
#define NEAR          1e-2 /* units: strokes leave as floats in millimetres */

static const struct ref_checkpoint vr17_figures[] = {
#include "tests/display_file/dpu_reference_vr17.inc"
};

static const struct ref_checkpoint vr14_figures[] = {
#include "tests/display_file/dpu_reference_vr14.inc"
};

static const struct ref_checkpoint pen_figures[] = {
#include "tests/display_file/dpu_reference_pen.inc"
};

struct bench {
    struct df_dpu dpu;
    uint16_t memory[REF_MEMORY_BYTES / 2];
    struct ref_session session, pen_session;
    struct ref_pen pen;
    bool has_pen, pen_open;
    unsigned posted;            /* REF_*_INTERRUPT of the current action */
    unsigned rests;             /* with a pen: strokes of the current action that stay put */
    struct ref_drawing drawing; /* of the current action; x1, y1 are the processor's position */
    struct ref_checkpoint now;
    uint32_t words;
};

/* ---- beam pieces back to lit units
 * --------------------------------------------------------------- */

struct span {
    double x0, y0, x1, y1; /* head units */
    bool rests;
};

static struct span span_of(const struct bench *b, const struct crt_stroke *s)
{
    const struct crt_screen *screen = &b->dpu.desc.screen;
    struct span span;
    crt_mm_to_units(screen, s->x0, s->y0, &span.x0, &span.y0);
    crt_mm_to_units(screen, s->x1, s->y1, &span.x1, &span.y1);
    span.rests = span.x0 == span.x1 && span.y0 == span.y1;
    return span;
}

/* How far along the vector a place on it is, in units of the longer axis. */
static double along_vector(const struct ref_drawing *d, double x, double y)
{
    int across, units = ref_units(d, &across);
    int dx = d->x1 - d->x0, dy = d->y1 - d->y0;
    double k = abs(dx) > abs(dy) ? (x - d->x0) / dx * units : (y - d->y0) / dy * units;

    assert_true(fabs(d->x0 + dx * k / units - x) < NEAR);
    assert_true(fabs(d->y0 + dy * k / units - y) < NEAR);
    return k;
}

static void complete_drawing(struct bench *b)
{
    b->drawing.x1 = b->dpu.x;
    b->drawing.y1 = b->dpu.y;
}

static void commit(void *ctx, const struct crt_stroke *stroke)
{
    struct bench *b = ctx;
    struct ref_drawing *d = &b->drawing;
    struct span s = span_of(b, stroke);
    unsigned level = (unsigned)lrint(stroke->drive * 8) - 1;

    if (b->has_pen) {
        b->rests += s.rests;
        return;
    }
    complete_drawing(b);
    switch (d->kind) {
    case REF_POINTS:
        assert_true(s.rests);
        ref_add_unit(&b->now, d, (int)lrint(s.x0), (int)lrint(s.y0), level, b->words);
        break;
    case REF_VECTOR: {
        int from = (int)ceil(along_vector(d, s.x0, s.y0) - NEAR);
        int to = (int)floor(along_vector(d, s.x1, s.y1) + NEAR);
        for (int k = from; k <= to; k++) {
            int x, y;
            ref_vector_unit(d, k, &x, &y);
            ref_add_unit(&b->now, d, x, y, level, b->words);
        }
        break;
    }
    case REF_CHARACTERS: {
        int x = (int)floor(s.x0 - 0.5 + NEAR), y = (int)floor(s.y0 - 0.5 + NEAR);
        assert_true(s.rests);
        for (int i = 0; i < 4; i++)
            ref_add_unit(&b->now, d, x + (i & 1), y + (i >> 1), level, b->words);
        break;
    }
    }
}

/* ---- the pen
 * -------------------------------------------------------------------------------------- */

static uint64_t offer(void *ctx, const struct crt_stroke *stroke)
{
    struct bench *b = ctx;
    struct ref_drawing *d = &b->drawing;
    struct span s = span_of(b, stroke);
    double from, to;

    if (!b->pen_open || lrint(stroke->drive * 8) - 1 < 3)
        return DF_NO_HIT;
    complete_drawing(b);
    if (d->kind == REF_POINTS)
        return ref_pen_sees(&b->pen, (int)lrint(s.x0), (int)lrint(s.y0)) ? stroke->t0 : DF_NO_HIT;
    from = along_vector(d, s.x0, s.y0);
    to = along_vector(d, s.x1, s.y1);
    for (int k = (int)ceil(from - NEAR); k <= (int)floor(to + NEAR); k++) {
        double part = fmin(fmax((k - from) / (to - from), 0), 1);
        int x, y;
        ref_vector_unit(d, k, &x, &y);
        if (ref_pen_sees(&b->pen, x, y))
            return stroke->t0 + (uint64_t)llrint(part * (double)(stroke->t1 - stroke->t0));
    }
    return DF_NO_HIT;
}

/* ---- the session ------------------------------------------------------------------------------
 */

static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    static const unsigned bits[DF_INT_COUNT] = {
        [DF_INT_STOP] = REF_STOP_INTERRUPT,
        [DF_INT_PEN] = REF_PEN_INTERRUPT,
        [DF_INT_CHARACTER] = REF_CHARACTER_INTERRUPT,
    };
    struct bench *b = ctx;
    (void)t;
    if (level)
        b->posted |= bits[line];
}

static void act(struct bench *b, struct ref_action action)
{
    struct df_dpu *dpu = &b->dpu;
    uint64_t half;

    switch (action.what) {
    case REF_WORD:
        b->memory[dpu->dpc < REF_MEMORY_BYTES ? dpu->dpc / 2 : 0] = action.value;
        b->words++;
        df_dpu_step(dpu);
        break;
    case REF_START:
    case REF_RESUME:
        df_dpu_write(dpu, DF_DPC, action.value, dpu->t);
        break;
    case REF_TICK_LIT:
    case REF_TICK_DARK:
        half = dpu->t / BLINK_HALF_PS + 1;
        if ((half & 1) != (action.what == REF_TICK_DARK))
            half++;
        df_dpu_sync(dpu, half * BLINK_HALF_PS);
        break;
    }
}

static enum ref_state state_of(const struct df_dpu *dpu)
{
    switch (dpu->state) {
    case DF_STOPPED:
        return REF_STOPPED;
    case DF_RUNNING:
        return REF_RUNNING;
    case DF_WAITING_SYNC:
        return REF_WAITING_SYNC;
    case DF_WAITING_RESUME:
        break;
    }
    return REF_WAITING_RESUME;
}

static void add_registers(struct bench *b)
{
    struct ref_checkpoint *c = &b->now;
    const struct df_dpu *dpu = &b->dpu;
    bool latched = dpu->pending[DF_INT_PEN];

    c->registers = ref_mix(c->registers, (uint32_t)state_of(dpu) | b->posted);
    c->registers = ref_mix(c->registers, df_dpu_read(dpu, DF_DPC));
    c->registers = ref_mix(c->registers, df_dpu_read(dpu, DF_MPR));
    complete_drawing(b);
    if (!latched || ref_reads_x(&b->drawing))
        c->registers = ref_mix(c->registers, df_dpu_read(dpu, DF_XPR));
    if (!latched || ref_reads_y(&b->drawing))
        c->registers = ref_mix(c->registers, df_dpu_read(dpu, DF_YPR));
}

static void one_action(struct bench *b)
{
    struct df_dpu *dpu = &b->dpu;
    bool was_latched = dpu->pending[DF_INT_PEN];
    enum ref_kind kind = dpu->mode == DF_MODE_CHAR                                 ? REF_CHARACTERS
                         : dpu->mode == DF_MODE_SHORT || dpu->mode == DF_MODE_LONG ? REF_VECTOR
                                                                                   : REF_POINTS;

    b->rests = b->posted = 0;
    b->pen_open = b->has_pen && kind != REF_CHARACTERS && !was_latched;
    b->drawing = (struct ref_drawing){.kind = kind,
                                      .x0 = dpu->x,
                                      .y0 = dpu->y,
                                      .italics = dpu->italics,
                                      .rows = (int)dpu->desc.screen.units_y};
    act(b, ref_next(&b->session, state_of(dpu)));
    add_registers(b);
    if (!was_latched && dpu->pending[DF_INT_PEN]) /* the hit, and its spots without the point */
        b->now.count += 1 + b->rests - (kind == REF_POINTS);
    if (b->has_pen)
        ref_move_pen(&b->pen_session, &b->pen);
}

static void set_up(struct bench *b, unsigned rows, uint64_t seed, bool has_pen)
{
    struct df_dpu_desc desc = {
        .memory = b->memory,
        .memory_bytes = REF_MEMORY_BYTES,
        .screen = {1024, rows, 1024, rows}, /* a millimetre a unit */
        .timing = {.fetch_ps = 1000,
                   .vector_unit_ps = 1000,
                   .settle_max_ps = 1000,
                   .point_ps = 1000,
                   .character_ps = 48000,
                   .dot_ps = 1000,
                   .intensify_ps = 1000},
        .beam = {.ctx = b, .commit = commit, .offer = has_pen ? offer : NULL},
        .wires = {.ctx = b, .interrupt = interrupt},
    };
    for (unsigned level = 0; level < 8; level++)
        desc.drive[level] = (level + 1) / 8.0;
    memset(b, 0, sizeof *b);
    b->session.random = seed;
    b->pen_session.random = ~seed;
    b->has_pen = has_pen;
    df_dpu_init(&b->dpu, &desc);
}

static void compare(unsigned rows, uint64_t seed, bool has_pen,
                    const struct ref_checkpoint *expected, size_t intervals)
{
    static struct bench bench;
    struct bench *b = &bench;

    set_up(b, rows, seed, has_pen);
    if (has_pen)
        ref_move_pen(&b->pen_session, &b->pen);
    for (size_t i = 0; i < intervals; i++) {
        uint32_t first = b->words;
        b->now = (struct ref_checkpoint){0};
        while (b->words < first + REF_INTERVAL)
            one_action(b);
        if (b->now.registers != expected[i].registers)
            fail_msg("registers differ between words %u and %u", first, b->words);
        if (b->now.count != expected[i].count)
            fail_msg("%u units, or hits and spots, instead of %u between words %u and %u",
                     b->now.count, expected[i].count, first, b->words);
        if (b->now.units != expected[i].units)
            fail_msg("other units lit between words %u and %u", first, b->words);
    }
}

#define COUNT(figures) (sizeof(figures) / sizeof(figures)[0])

static void a_hundred_thousand_words_agree(void **state)
{
    (void)state;
    assert_int_equal(COUNT(vr17_figures) * REF_INTERVAL, 100000);
    compare(1024, REF_SEED_VR17, false, vr17_figures, COUNT(vr17_figures));
}

static void a_screen_of_768_rows_agrees(void **state)
{
    (void)state;
    assert_int_equal(COUNT(vr14_figures) * REF_INTERVAL, 20000);
    compare(768, REF_SEED_VR14, false, vr14_figures, COUNT(vr14_figures));
}

static void pen_hits_agree(void **state)
{
    (void)state;
    assert_int_equal(COUNT(pen_figures) * REF_INTERVAL, 100000);
    compare(1024, REF_SEED_PEN, true, pen_figures, COUNT(pen_figures));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hundred_thousand_words_agree),
        cmocka_unit_test(a_screen_of_768_rows_agrees),
        cmocka_unit_test(pen_hits_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
