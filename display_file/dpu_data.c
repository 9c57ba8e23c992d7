/* Data words: one function per graphic mode. */
#include "display_file/beam.h"
#include "display_file/chargen.h"
#include "display_file/df_regs.h"
#include "display_file/dpu_internal.h"
#include "display_file/vecgen.h"

/* True when `word` completes a datum of two words; else it has been kept as the first. */
static bool second_word(struct df_dpu *dpu, uint16_t word)
{
    if (dpu->phase == DF_PHASE_SECOND) {
        dpu->phase = DF_PHASE_FIRST;
        return true;
    }
    dpu->first_word = word;
    dpu->phase = DF_PHASE_SECOND;
    dpu->window = dpu->desc.timing.average_ps / 2;
    return false;
}

static int32_t signed_by(uint16_t word, unsigned sign, unsigned magnitude)
{
    return word & sign ? -(int32_t)magnitude : (int32_t)magnitude;
}

static int32_t short_x(uint16_t word)
{
    return signed_by(word, DF_SIGN_X, (word & (unsigned)DF_SHORT_DX) >> DF_SHORT_DX_SHIFT);
}

static int32_t short_y(uint16_t word)
{
    return signed_by(word, DF_SHORT_SIGN_Y, word & DF_SHORT_DY);
}

static void characters(struct df_dpu *dpu, uint16_t word)
{
    uint64_t window = dpu->window;

    /* In average mode each of the two has half the word's time. */
    dpu->instructions++;
    dpu->window = window - window / 2;
    df_chargen_code(dpu, word & 0177);
    dpu->window = window / 2;
    if (dpu->state == DF_RUNNING)
        df_chargen_code(dpu, word >> 8 & 0177);
    else
        dpu->second = (struct df_pending_character){true, (uint8_t)(word >> 8 & 0177)};
    dpu->window = window;
}

static void short_vector(struct df_dpu *dpu, uint16_t word)
{
    dpu->instructions++;
    df_vecgen_vector(dpu, word & DF_BEAM_ON, short_x(word), short_y(word));
}

static void long_vector(struct df_dpu *dpu, uint16_t word)
{
    uint16_t first = dpu->first_word;

    if (!second_word(dpu, word))
        return;
    dpu->instructions++;
    df_vecgen_vector(dpu, first & DF_BEAM_ON, signed_by(first, DF_SIGN_X, first & DF_LONG_DELTA),
                     signed_by(word, DF_SIGN_X, word & DF_LONG_DELTA));
}

/* Moves to (x, y) before wrapping; then, when `on`, lights the point. */
static void plot(struct df_dpu *dpu, bool on, int32_t x, int32_t y)
{
    const struct df_timing *timing = &dpu->desc.timing;
    uint32_t units = df_vecgen_units(dpu->x, dpu->y, x, y);
    uint64_t settle = df_vecgen_settle_ps(timing, units);
    uint64_t t0, t1;
    bool hits = true;

    dpu->instructions++;
    dpu->x = df_wrap12(x);
    dpu->y = df_wrap12(y);
    if (!on) {
        dpu->usage.moves++;
        df_dpu_schedule(dpu, settle, 0, &t0, &t1);
        return;
    }
    dpu->usage.points++;
    df_dpu_schedule(dpu, settle, timing->point_ps, &t0, &t1);
    if (!df_on_screen(dpu, dpu->x, dpu->y) || df_blinked_out(dpu, t0))
        return;
    dpu->clock += df_beam_dot(dpu, dpu->x, dpu->y, dpu->x, dpu->y, t0, t1, &hits);
    df_dpu_stop_for_pen(dpu, dpu->clock);
}

static void point(struct df_dpu *dpu, uint16_t word)
{
    uint16_t first = dpu->first_word;

    if (!second_word(dpu, word))
        return;
    dpu->edge = false; /* assumed, as in graphplot: an absolute coordinate is on screen */
    plot(dpu, first & DF_BEAM_ON, first & DF_LONG_DELTA, word & DF_LONG_DELTA);
}

/* Graphplot ignores the beam bit: every datum is a lit point. */
static void graphplot_x(struct df_dpu *dpu, uint16_t word)
{
    dpu->edge = false;
    plot(dpu, true, word & DF_LONG_DELTA, dpu->y + (int32_t)dpu->step);
}

static void graphplot_y(struct df_dpu *dpu, uint16_t word)
{
    dpu->edge = false;
    plot(dpu, true, dpu->x + (int32_t)dpu->step, word & DF_LONG_DELTA);
}

static void relative_point(struct df_dpu *dpu, uint16_t word)
{
    bool starts_on = df_on_screen(dpu, dpu->x, dpu->y);
    int32_t x = dpu->x + short_x(word), y = dpu->y + short_y(word);

    /* Assumed: the edge indicator tells that the point left the screen. */
    dpu->edge = starts_on && !df_on_screen(dpu, df_wrap12(x), df_wrap12(y));
    plot(dpu, word & DF_BEAM_ON, x, y);
}

df_word_handler *const df_data_words[7] = {
    [DF_MODE_CHAR] = characters,         [DF_MODE_SHORT] = short_vector,
    [DF_MODE_LONG] = long_vector,        [DF_MODE_POINT] = point,
    [DF_MODE_GRAPHX] = graphplot_x,      [DF_MODE_GRAPHY] = graphplot_y,
    [DF_MODE_RELPOINT] = relative_point,
};
