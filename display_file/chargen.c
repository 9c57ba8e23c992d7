#include "display_file/chargen.h"

#include <stddef.h>

#include "display_file/beam.h"
#include "display_file/dpu_internal.h"
#include "display_file/glyphs.h"
#include "display_file/vecgen.h"

#define DOT_UNITS       2
#define DESCENDER_UNITS 4
#define CELL_DOTS       (DF_GLYPH_COLUMNS * DF_GLYPH_ROWS)

enum { NUL = 0, BS = 010, LF = 012, CR = 015, SO = 016, SI = 017, SPACE = 040 };

/* One dot, lit for at most `lit` ps, in the slot of column c and row r of a cell that takes `cell` ps
 * from t0. Returns the ps that a pen hit added. */
static uint64_t dot(struct df_dpu *dpu, int c, int r, int32_t base_y, uint64_t t0, uint64_t cell,
                    uint64_t lit, bool *hits)
{
    uint64_t slot = (uint64_t)(c * DF_GLYPH_ROWS + r);
    uint64_t begin = t0 + cell * slot / CELL_DOTS, end = t0 + cell * (slot + 1) / CELL_DOTS;
    int32_t x = dpu->x + DOT_UNITS * c, y = base_y + DOT_UNITS * r;
    double ux = x + 0.5 + (dpu->italics ? DOT_UNITS * r / 3.0 : 0), uy = y + 0.5;
    bool may_hit = *hits && c != 0 && c != DF_GLYPH_COLUMNS - 1;
    bool still = may_hit;
    uint64_t added;

    if (ux < 0 || ux > dpu->max_x || uy < 0 || uy > dpu->max_y)
        return 0;
    if (lit < end - begin)
        end = begin + lit;
    added = df_beam_dot(dpu, x, y, ux, uy, begin, end, &still);
    if (may_hit && !still)
        *hits = false;
    return added;
}

static void draw(struct df_dpu *dpu, const struct df_glyph *glyph, uint64_t t0, uint64_t t1)
{
    int32_t base_y = dpu->y - (glyph->descends ? DESCENDER_UNITS : 0);
    const struct df_timing *timing = &dpu->desc.timing;
    uint64_t added = 0, lit;
    bool hits = true;

    if (t1 <= t0 || timing->character_ps == 0)
        return;
    /* In average mode the cell is stretched or squeezed, and its dots with it. */
    lit = (uint64_t)((double)timing->dot_ps * ((double)(t1 - t0) / (double)timing->character_ps));
    for (int c = 0; c < DF_GLYPH_COLUMNS; c++)
        for (int r = 0; r < DF_GLYPH_ROWS; r++)
            if (glyph->column[c] >> r & 1)
                added += dot(dpu, c, r, base_y, t0 + added, t1 - t0, lit, &hits);
    dpu->clock += added;
}

/* A printing code: NULL is a space. */
static void cell(struct df_dpu *dpu, const struct df_glyph *glyph)
{
    uint64_t t0, t1;

    dpu->usage.characters++;
    df_dpu_schedule(dpu, 0, dpu->desc.timing.character_ps, &t0, &t1);
    if (glyph) {
        int32_t end = dpu->x + DOT_UNITS * DF_GLYPH_COLUMNS - 1;
        bool starts_on = df_on_screen(dpu, dpu->x, dpu->y);
        bool ends_on = df_on_screen(dpu, end, dpu->y);

        /* Assumed: the edge indicator tells of the last character whether it left the screen. */
        dpu->edge = starts_on && !ends_on;
        if (starts_on && ends_on && !df_blinked_out(dpu, t0))
            draw(dpu, glyph, t0, t1);
    }
    dpu->x = df_wrap12(dpu->x + DF_CHARACTER_ADVANCE);
    df_dpu_stop_for_pen(dpu, dpu->clock);
}

static void move_to(struct df_dpu *dpu, int32_t x, int32_t y)
{
    uint32_t units = df_vecgen_units(dpu->x, dpu->y, x, y);
    uint64_t t0, t1;

    dpu->usage.moves++;
    df_dpu_schedule(dpu, df_vecgen_settle_ps(&dpu->desc.timing, units), 0, &t0, &t1);
    dpu->x = df_wrap12(x);
    dpu->y = df_wrap12(y);
}

static void shifted_out(struct df_dpu *dpu, unsigned code)
{
    dpu->character = (uint16_t)code;
    if (code == SI) {
        dpu->shift_out = false;
    } else if (code >= SPACE) {
        dpu->so_error = true;
        dpu->state = DF_WAITING_RESUME;
        df_dpu_raise(dpu, DF_INT_CHARACTER, dpu->clock);
    } else {
        cell(dpu, df_glyph_special(code));
    }
}

void df_chargen_code(struct df_dpu *dpu, unsigned code)
{
    if (dpu->shift_out) {
        shifted_out(dpu, code);
        return;
    }
    if (code == NUL) /* assumed: not even copied to the character register */
        return;
    dpu->character = (uint16_t)code;
    switch (code) {
    case BS:
        move_to(dpu, dpu->x - DF_CHARACTER_ADVANCE, dpu->y);
        break;
    case LF:
        move_to(dpu, dpu->x, dpu->y - DF_LINE_FEED);
        break;
    case CR:
        move_to(dpu, 0, dpu->y);
        break;
    case SO:
        dpu->shift_out = true;
        break;
    case SPACE:
        cell(dpu, NULL);
        break;
    default:
        if (code > SPACE)
            cell(dpu, df_glyph_ascii(code));
        break;
    }
}
