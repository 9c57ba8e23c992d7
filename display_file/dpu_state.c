/* The display processor in a snapshot. `clock`, `window` and `stopping` live within a word only. */
#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"
#include "display_file/vecgen.h"

#define VERSION 2

/* Longer than any vector is lit (1023 units and its rests, at 1 s each), ps. */
#define LONGEST (UINT64_C(1) << 50)

static void enum_state(struct crt_state *s, int *v, unsigned most)
{
    unsigned n = (unsigned)*v;
    crt_state_unsigned(s, &n, most);
    *v = (int)n;
}

/* ---- fields ------------------------------------------------------------------------------------ */

static void running_state(struct df_dpu *dpu, struct crt_state *s)
{
    int state = (int)dpu->state;
    crt_state_u64(s, &dpu->t);
    enum_state(s, &state, DF_WAITING_RESUME);
    dpu->state = (enum df_state)state;
    crt_state_u16(s, &dpu->dpc);
    crt_state_bool(s, &dpu->illegal);
    crt_state_bool(s, &dpu->timeout);
    crt_state_u64(s, &dpu->words);
    crt_state_u64(s, &dpu->instructions);
    crt_state_u64(s, &dpu->usage.vectors);
    crt_state_u64(s, &dpu->usage.points);
    crt_state_u64(s, &dpu->usage.characters);
    crt_state_u64(s, &dpu->usage.moves);
    crt_state_u64(s, &dpu->usage.strokes);
    crt_state_u64(s, &dpu->usage.lit_ps);
    crt_state_u64(s, &dpu->usage.colours);
}

static void registers_state(struct df_dpu *dpu, struct crt_state *s)
{
    crt_state_unsigned(s, &dpu->mode, DF_MODE_RELPOINT);
    crt_state_unsigned(s, &dpu->intensity, 7);
    crt_state_unsigned(s, &dpu->line_type, DF_LINE_DOTDASH);
    crt_state_unsigned(s, &dpu->step, DF_LSB_VALUE);
    crt_state_unsigned(s, &dpu->colour, DF_COLOUR_RED);
    crt_state_unsigned(s, &dpu->opcode, 15);
    crt_state_bool(s, &dpu->blink);
    crt_state_bool(s, &dpu->italics);
    crt_state_bool(s, &dpu->shift_out);
    crt_state_bool(s, &dpu->pen_interrupt);
    crt_state_bool(s, &dpu->pen_intensify);
    crt_state_bool(s, &dpu->stop_interrupt);
    crt_state_bool(s, &dpu->internal_stop);
    crt_state_bool(s, &dpu->hit);
    crt_state_bool(s, &dpu->edge);
    crt_state_bool(s, &dpu->so_error);
    crt_state_i32(s, &dpu->x);
    crt_state_i32(s, &dpu->y);
    crt_state_u16(s, &dpu->hit_x);
    crt_state_u16(s, &dpu->hit_y);
    crt_state_u16(s, &dpu->character);
    for (int line = 0; line < DF_INT_COUNT; line++)
        crt_state_bool(s, &dpu->pending[line]);
    crt_state_u64(s, &dpu->raised_at);
    crt_state_u16(s, &dpu->first_word);
    crt_state_u8(s, &dpu->phase);
    crt_state_u32(s, &dpu->source);
}

/* Only what is pending: the rest of a vector that is done means nothing. */
static void pending_state(struct df_dpu *dpu, struct crt_state *s)
{
    struct df_pending_vector *v = &dpu->vector;
    crt_state_bool(s, &v->active);
    if (v->active) {
        crt_state_i32(s, &v->x0);
        crt_state_i32(s, &v->y0);
        crt_state_i32(s, &v->x1);
        crt_state_i32(s, &v->y1);
        crt_state_u64(s, &v->span);
        crt_state_u64(s, &v->rest);
        crt_state_u64(s, &v->done);
    }
    crt_state_bool(s, &dpu->second.active);
    if (dpu->second.active)
        crt_state_u8(s, &dpu->second.code);
}

/* ---- what is possible -------------------------------------------------------------------------- */

static bool in_12_bits(int32_t v)
{
    return v >= -2048 && v <= 2047;
}

static bool sane_registers(const struct df_dpu *dpu)
{
    return in_12_bits(dpu->x) && in_12_bits(dpu->y) && dpu->hit_x <= DF_XPR_X &&
           dpu->hit_y <= DF_YPR_Y && dpu->character <= 0177 && dpu->phase <= DF_PHASE_ADDRESS &&
           (dpu->desc.personality == DF_VS60 || dpu->colour == DF_COLOUR_GREEN);
}

static bool sane_addresses(const struct df_dpu *dpu)
{
    bool fetched = dpu->source <= UINT16_MAX && dpu->source + 2 <= dpu->desc.memory_bytes;
    return dpu->dpc % 2 == 0 && dpu->source % 2 == 0 && (dpu->source == 0 || fetched);
}

/* Which lines and flags can be up in which state. */
static bool sane_waiting(const struct df_dpu *dpu)
{
    bool resume = dpu->state == DF_WAITING_RESUME;
    if (dpu->pending[DF_INT_STOP] && dpu->state != DF_STOPPED)
        return false;
    if ((dpu->pending[DF_INT_PEN] || dpu->pending[DF_INT_CHARACTER] || dpu->timeout) && !resume)
        return false;
    if ((dpu->vector.active || dpu->second.active) && !resume)
        return false;
    return (!dpu->illegal || dpu->state == DF_RUNNING) &&
           !(dpu->vector.active && dpu->second.active) && dpu->second.code <= 0177;
}

/* Both ends on screen, some way between them, time for it. */
static bool sane_vector(const struct df_dpu *dpu)
{
    const struct df_pending_vector *v = &dpu->vector;
    return !v->active || (df_on_screen(dpu, v->x0, v->y0) && df_on_screen(dpu, v->x1, v->y1) &&
                          v->units > 0 && v->span <= LONGEST && v->rest < v->span &&
                          2 * v->rest < v->span && v->done <= v->span && v->done <= dpu->t);
}

static void check(const struct df_dpu *dpu, struct crt_state *s)
{
    crt_state_check(s, dpu->t < CRT_STATE_LATEST && dpu->raised_at <= dpu->t,
                    "time of the display processor");
    crt_state_check(s, sane_registers(dpu), "register of the display processor");
    crt_state_check(s, sane_addresses(dpu), "display program counter");
    crt_state_check(s, sane_waiting(dpu), "state of the display processor");
    crt_state_check(s, sane_vector(dpu), "interrupted vector");
}

void df_dpu_state(struct df_dpu *dpu, struct crt_state *s)
{
    crt_state_begin(s, "DPU ", VERSION);
    if (s->loading) {
        dpu->vector = (struct df_pending_vector){.active = false};
        dpu->second = (struct df_pending_character){.active = false};
        dpu->window = 0;
        dpu->stopping = false;
    }
    running_state(dpu, s);
    registers_state(dpu, s);
    pending_state(dpu, s);
    if (s->loading) {
        struct df_pending_vector *v = &dpu->vector;
        bool near = df_on_screen(dpu, v->x0, v->y0) && df_on_screen(dpu, v->x1, v->y1);
        v->units = v->active && near ? df_vecgen_units(v->x0, v->y0, v->x1, v->y1) : 0;
        dpu->clock = dpu->t;
    }
    check(dpu, s);
    crt_state_end(s);
}
