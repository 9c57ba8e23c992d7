#include "display_file/dpu.h"

#include <assert.h>
#include <string.h>

#include "display_file/chargen.h"
#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"
#include "display_file/vecgen.h"

/* 128-bit products for average mode; an extension that -Wpedantic need not hear about. */
__extension__ typedef unsigned __int128 u128;

static uint64_t later(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

/* ---- interrupts ------------------------------------------------------------------------------ */

static void drive_line(struct df_dpu *dpu, enum df_interrupt line, bool level, uint64_t t)
{
    if (dpu->pending[line] == level)
        return;
    dpu->pending[line] = level;
    if (dpu->desc.wires.interrupt)
        dpu->desc.wires.interrupt(dpu->desc.wires.ctx, line, level, t);
}

void df_dpu_raise(struct df_dpu *dpu, enum df_interrupt line, uint64_t t)
{
    dpu->raised_at = t;
    drive_line(dpu, line, true, t);
}

void df_dpu_stop_for_pen(struct df_dpu *dpu, uint64_t t)
{
    if (!dpu->stopping)
        return;
    dpu->stopping = false;
    dpu->state = DF_WAITING_RESUME;
    df_dpu_raise(dpu, DF_INT_PEN, t);
}

/* A write may come while the word that raised the line is still being drawn: no line falls before
 * it rises. */
static void drop_interrupts(struct df_dpu *dpu, uint64_t t)
{
    t = later(t, dpu->raised_at);
    for (int line = 0; line < DF_INT_COUNT; line++)
        drive_line(dpu, (enum df_interrupt)line, false, t);
}

/* ---- set-up ---------------------------------------------------------------------------------- */

static void limit(uint64_t *ps, uint64_t least)
{
    if (*ps < least)
        *ps = least;
    if (*ps > CRT_PS_PER_S)
        *ps = CRT_PS_PER_S;
}

/* Keeps every product of time and units inside 64 bits, and every word longer than nothing. */
static void limit_timing(struct df_timing *t)
{
    limit(&t->fetch_ps, 1);
    limit(&t->vector_setup_ps, 0);
    limit(&t->vector_unit_ps, 1);
    if (t->vector_rest_ps > t->vector_setup_ps / 2)
        t->vector_rest_ps = t->vector_setup_ps / 2;
    limit(&t->settle_ps, 0);
    limit(&t->settle_unit_ps, 0);
    limit(&t->settle_max_ps, 0);
    limit(&t->point_ps, 1);
    limit(&t->character_ps, 0);
    limit(&t->dot_ps, 1);
    limit(&t->intensify_ps, 0);
    limit(&t->colour_switch_ps, 0);
    limit(&t->average_ps, 0);
    if (t->average_ps == 1) /* half of it must still be something */
        t->average_ps = 2;
}

/* The last unit of an axis: positions on screen have ten bits. */
static int32_t last_unit(double units)
{
    return units >= 1024 ? 1023 : units >= 1 ? (int32_t)units - 1 : 0;
}

void df_dpu_init(struct df_dpu *dpu, const struct df_dpu_desc *desc)
{
    assert(desc->memory && desc->beam.commit);
    memset(dpu, 0, sizeof *dpu);
    dpu->desc = *desc;
    limit_timing(&dpu->desc.timing);
    dpu->max_x = last_unit(desc->screen.units_x);
    dpu->max_y = last_unit(desc->screen.units_y);
    dpu->placing = crt_screen_placing(&desc->screen);
    df_dpu_reset(dpu, 0);
}

void df_dpu_reset(struct df_dpu *dpu, uint64_t t)
{
    struct df_dpu fresh = {0};

    drop_interrupts(dpu, t);
    fresh.desc = dpu->desc;
    fresh.max_x = dpu->max_x;
    fresh.max_y = dpu->max_y;
    fresh.placing = dpu->placing;
    fresh.t = later(dpu->t, t);
    fresh.state = DF_STOPPED;
    fresh.mode = DF_MODE_CHAR;
    fresh.intensity = 4;
    fresh.line_type = DF_LINE_SOLID;
    fresh.colour = DF_COLOUR_GREEN;
    fresh.pen_intensify = true;
    *dpu = fresh;
}

/* ---- registers ------------------------------------------------------------------------------- */

static uint16_t mode_parameters(const struct df_dpu *dpu)
{
    unsigned v = dpu->opcode << DF_MODE_SHIFT | dpu->intensity << 8 | dpu->line_type;
    v |= dpu->internal_stop ? DF_MPR_STOP : 0;
    v |= dpu->hit ? DF_MPR_HIT : 0;
    v |= dpu->so_error ? DF_MPR_SO : 0;
    v |= dpu->edge ? DF_MPR_EDGE : 0;
    v |= dpu->italics ? DF_MPR_ITALICS : 0;
    v |= dpu->blink ? DF_MPR_BLINK : 0;
    return (uint16_t)v;
}

uint16_t df_dpu_read(const struct df_dpu *dpu, unsigned offset)
{
    bool latched = dpu->pending[DF_INT_PEN];

    switch (offset) {
    case DF_DPC:
        return dpu->dpc;
    case DF_MPR:
        return mode_parameters(dpu);
    case DF_XPR:
        return (uint16_t)(dpu->step << 10 | (latched ? dpu->hit_x : (unsigned)dpu->x & DF_XPR_X));
    case DF_YPR:
        return (uint16_t)((dpu->character & 077u) << 10 |
                          (latched ? dpu->hit_y : (unsigned)dpu->y & DF_YPR_Y));
    case DF_SCR:
        return dpu->desc.personality == DF_VS60 ? (uint16_t)(dpu->colour << DF_SCR_COLOUR_SHIFT)
                                                : 0;
    default:
        return 0;
    }
}

enum crt_level df_dpu_level(const struct df_dpu *dpu)
{
    static const enum crt_level levels[] = {[DF_COLOUR_GREEN] = CRT_LEVEL_GREEN,
                                            [DF_COLOUR_YELLOW] = CRT_LEVEL_YELLOW,
                                            [DF_COLOUR_ORANGE] = CRT_LEVEL_ORANGE,
                                            [DF_COLOUR_RED] = CRT_LEVEL_RED};
    return dpu->desc.personality == DF_VS60 ? levels[dpu->colour] : CRT_LEVEL_ONLY;
}

/* What START and (assumed) RESUME have in common: every cause of a stop is forgotten. */
static void clear_flags(struct df_dpu *dpu, uint64_t t)
{
    dpu->internal_stop = dpu->timeout = dpu->hit = dpu->edge = dpu->so_error = false;
    drop_interrupts(dpu, t);
}

static void start(struct df_dpu *dpu, uint16_t address, uint64_t t)
{
    clear_flags(dpu, t);
    dpu->dpc = address;
    dpu->phase = DF_PHASE_FIRST;
    dpu->illegal = false;
    dpu->vector.active = false;
    dpu->second.active = false;
    dpu->t = later(dpu->t, t);
    dpu->state = DF_RUNNING;
}

/* Goes on where the processor stopped: first with what an interrupt left undrawn. Assumed: a wait
 * for the sync tick goes on. */
static void resume(struct df_dpu *dpu, uint64_t t)
{
    clear_flags(dpu, t);
    if (dpu->state == DF_RUNNING || dpu->state == DF_WAITING_SYNC)
        return;
    dpu->state = DF_RUNNING;
    dpu->t = later(dpu->t, t);
    dpu->clock = dpu->t;
    if (dpu->vector.active) {
        df_vecgen_resume(dpu);
    } else if (dpu->second.active) {
        dpu->second.active = false;
        dpu->window = dpu->desc.timing.average_ps / 2;
        df_chargen_code(dpu, dpu->second.code);
    }
    dpu->t = dpu->clock;
}

void df_dpu_write(struct df_dpu *dpu, unsigned offset, uint16_t value, uint64_t t)
{
    if (offset == DF_DPC) {
        if (value & 1)
            resume(dpu, t);
        else
            start(dpu, value, t);
    } else if (offset == DF_MPR && dpu->desc.wires.bell) {
        dpu->desc.wires.bell(dpu->desc.wires.ctx, t);
    }
}

/* ---- execution ------------------------------------------------------------------------------- */

uint64_t df_ratio(uint64_t whole, uint64_t part, uint64_t of)
{
    return (uint64_t)((u128)whole * part / of);
}

void df_dpu_schedule(struct df_dpu *dpu, uint64_t lead, uint64_t lit, uint64_t *t0, uint64_t *t1)
{
    const struct df_timing *timing = &dpu->desc.timing;

    if (timing->average_ps == 0) {
        *t0 = dpu->clock + lead;
        *t1 = *t0 + lit;
    } else {
        uint64_t dark = timing->fetch_ps + lead;
        *t0 = dpu->clock + df_ratio(dpu->window, dark, dark + lit);
        *t1 = dpu->clock + dpu->window;
    }
    dpu->clock = *t1;
}

/* Assumed: the attempt takes as long as a fetch, and DPC is past the word, as at any interrupt. */
static void time_out(struct df_dpu *dpu)
{
    dpu->t += dpu->desc.timing.fetch_ps;
    dpu->timeout = true;
    dpu->state = DF_WAITING_RESUME;
    df_dpu_raise(dpu, DF_INT_CHARACTER, dpu->t);
}

static void execute(struct df_dpu *dpu, uint16_t word)
{
    if (dpu->phase == DF_PHASE_ADDRESS) {
        dpu->dpc = (uint16_t)(word & ~1u);
        dpu->phase = DF_PHASE_FIRST;
        dpu->instructions++;
    } else if (word & DF_CONTROL) {
        dpu->opcode = word >> DF_MODE_SHIFT & 15u;
        dpu->phase = DF_PHASE_FIRST;
        df_control_words[dpu->opcode](dpu, word);
    } else {
        dpu->opcode = dpu->mode;
        df_data_words[dpu->mode](dpu, word);
    }
}

/* Average mode: an instruction of one word has the whole of it, the words of one of two half each.
 */
static void execute_averaged(struct df_dpu *dpu, uint16_t word)
{
    uint64_t average = dpu->desc.timing.average_ps;
    bool second =
        dpu->phase == DF_PHASE_ADDRESS || (dpu->phase == DF_PHASE_SECOND && !(word & DF_CONTROL));

    dpu->window = second ? average - average / 2 : average;
    dpu->clock = dpu->t;
    execute(dpu, word);
    /* What an interrupt left for RESUME takes its share then; but no word takes nothing. */
    if (dpu->vector.active)
        dpu->clock = later(dpu->clock, dpu->t + 1);
    else if (dpu->second.active)
        dpu->clock = later(dpu->clock, dpu->t + (dpu->window + 1) / 2);
    else
        dpu->clock = later(dpu->clock, dpu->t + dpu->window);
}

void df_dpu_step(struct df_dpu *dpu)
{
    uint16_t address = dpu->dpc, word;

    assert(dpu->state == DF_RUNNING);
    dpu->dpc = (uint16_t)(address + 2);
    if (address + 2u > dpu->desc.memory_bytes) {
        time_out(dpu);
        return;
    }
    word = dpu->desc.memory[address >> 1];
    dpu->words++;
    dpu->illegal = false;
    if (dpu->phase != DF_PHASE_SECOND)
        dpu->source = address;
    if (dpu->desc.timing.average_ps == 0) {
        dpu->clock = dpu->t + dpu->desc.timing.fetch_ps;
        execute(dpu, word);
    } else {
        execute_averaged(dpu, word);
    }
    dpu->t = dpu->clock;
}

void df_dpu_sync(struct df_dpu *dpu, uint64_t t)
{
    if (dpu->state != DF_WAITING_SYNC)
        return;
    dpu->state = DF_RUNNING;
    dpu->t = later(dpu->t, t);
}
