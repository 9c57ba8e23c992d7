/* Control words: what each of the sixteen codes of bits 14:11 does on a VT11, and colour on a VS60. */
#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"

static void set_graphic_mode(struct df_dpu *dpu, uint16_t word)
{
    dpu->mode = dpu->opcode;
    dpu->shift_out = false;
    if (word & DF_SGM_INTENSITY)
        dpu->intensity = word >> DF_SGM_INTENSITY_SHIFT & 7;
    if (word & DF_SGM_PEN)
        dpu->pen_interrupt = word & DF_SGM_PEN_ON;
    if (word & DF_SGM_BLINK)
        dpu->blink = word & DF_SGM_BLINK_ON;
    if (word & DF_SGM_LINE)
        dpu->line_type = word & DF_LINE_DOTDASH;
    dpu->instructions++;
}

static void no_operation(struct df_dpu *dpu, uint16_t word)
{
    (void)word;
    dpu->instructions++;
}

/* A spare code, or one of the VS60: the processor fetches the same word again and again. */
static void illegal(struct df_dpu *dpu, uint16_t word)
{
    (void)word;
    dpu->dpc = (uint16_t)(dpu->dpc - 2);
    dpu->illegal = true;
    dpu->instructions++;
}

static void jump(struct df_dpu *dpu, uint16_t word)
{
    (void)word;
    dpu->phase = DF_PHASE_ADDRESS;
    dpu->window = dpu->desc.timing.average_ps / 2;
}

static void load_status_a(struct df_dpu *dpu, uint16_t word)
{
    dpu->internal_stop = word & DF_LSA_STOP;
    if (word & DF_LSA_STOP_INT)
        dpu->stop_interrupt = word & DF_LSA_STOP_INT_ON;
    if (word & DF_LSA_INTENSIFY)
        dpu->pen_intensify = !(word & DF_LSA_INTENSIFY_OFF);
    if (word & DF_LSA_ITALICS)
        dpu->italics = word & DF_LSA_ITALICS_ON;
    dpu->instructions++;
    if (dpu->internal_stop) {
        dpu->state = DF_STOPPED;
        if (dpu->stop_interrupt)
            df_dpu_raise(dpu, DF_INT_STOP, dpu->clock + dpu->window);
    } else if (word & DF_LSA_SYNC) {
        dpu->state = DF_WAITING_SYNC;
    }
}

/* The beam stays off until its voltage is that of the new colour. */
static void set_colour(struct df_dpu *dpu, unsigned colour)
{
    uint64_t t0, t1;

    if (colour == dpu->colour)
        return;
    dpu->colour = colour;
    dpu->usage.colours++;
    df_dpu_schedule(dpu, dpu->desc.timing.colour_switch_ps, 0, &t0, &t1);
}

static void load_status_b(struct df_dpu *dpu, uint16_t word)
{
    if (dpu->desc.personality == DF_VS60 && word & DF_LSB_COLOUR)
        set_colour(dpu, (word & (unsigned)DF_LSB_COLOUR_BITS) >> DF_LSB_COLOUR_SHIFT);
    if (word & DF_LSB_STEP)
        dpu->step = word & DF_LSB_VALUE;
    dpu->instructions++;
}

df_word_handler *const df_control_words[16] = {
    set_graphic_mode,               /* character */
    set_graphic_mode,               /* short vector */
    set_graphic_mode,               /* long vector */
    set_graphic_mode,               /* point */
    set_graphic_mode,               /* graphplot X */
    set_graphic_mode,               /* graphplot Y */
    set_graphic_mode,               /* relative point */
    illegal,          no_operation, /* 140000: ignored */
    illegal,          illegal,      illegal, jump, no_operation, load_status_a, load_status_b,
};
