/* Native data statements: words that are read in the current graphic mode. */
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"
#include "display_file/df_regs.h"
#include "display_file/encode.h"

/* Why a statement cannot stand in the current mode, once a stretch of text. */
static void wrong_mode(struct df_asm *as, const char *statement, const char *modes)
{
    if (as->mode == DF_MODE_POISON) {
        df_asm_arguments(as, "operands"); /* they may be faulty, too */
        as->layout_broken = true;
        return;
    }
    if (as->mode == DF_MODE_UNSET) {
        df_asm_error(as, as->statement_column, "'%s' before any mode; expected %s above", statement,
                     modes);
    } else {
        df_asm_error(as, as->statement_column, "'%s' in %s mode; expected %s", statement,
                     df_asm_mode_name(as->mode), modes);
    }
    as->mode = DF_MODE_POISON;
    as->position = DF_POISON;
    as->layout_broken = true;
}

static int32_t wrap(int32_t coordinate)
{
    return ((coordinate + 2048) & 07777) - 2048; /* the position registers have 12 bits */
}

static void forget_position(struct df_asm *as)
{
    if (as->position == DF_KNOWN) {
        as->position = DF_NOT_KNOWN;
    }
}

/* Pairs of operands; false when the statement is faulty as a whole. */
static bool take_pairs(struct df_asm *as, const char *expected)
{
    if (!df_asm_arguments(as, expected)) {
        as->layout_broken = true;
        as->position = DF_POISON;
        return false;
    }
    if (as->argument_count % 2 != 0) {
        df_asm_error(as, as->lex.token.column, "%u operand%s; expected pairs: %s",
                     (unsigned)as->argument_count, as->argument_count == 1 ? "" : "s", expected);
        as->layout_broken = true;
        as->position = DF_POISON;
        return false;
    }
    return true;
}

/* ---- at, plot, move, draw ---- */

static void emit_vector(struct df_asm *as, bool lit, int32_t dx, int32_t dy)
{
    if (as->mode == DF_MODE_LONG) {
        df_asm_emit(as, df_encode_long_x(lit, dx));
        df_asm_emit(as, df_encode_long_y(dy));
    } else {
        df_asm_emit(as, df_encode_short(lit, dx, dy));
    }
}

static void emit_point(struct df_asm *as, bool lit, int32_t x, int32_t y)
{
    df_asm_emit(as, df_encode_point_x(lit, x));
    df_asm_emit(as, df_encode_point_y(y));
}

/* The operand's number is not known yet, or its value could not be had: so is the position. */
static bool settled(const struct df_argument *argument)
{
    return argument->value.kind == DF_VALUE_NUMBER && !argument->value.forward;
}

static void track(struct df_asm *as, const struct df_argument *pair, bool absolute, int32_t x,
                  int32_t y)
{
    if (pair[0].value.kind == DF_VALUE_UNKNOWN || pair[1].value.kind == DF_VALUE_UNKNOWN) {
        as->position = DF_POISON; /* silent in pass 1; in pass 2 it has been reported */
    } else if (!settled(&pair[0]) || !settled(&pair[1])) {
        as->position = as->position == DF_POISON && !absolute ? DF_POISON : DF_NOT_KNOWN;
    } else if (absolute) {
        as->position = DF_KNOWN;
        as->x = x;
        as->y = y;
    } else if (as->position == DF_KNOWN) {
        as->x = wrap(as->x + x);
        as->y = wrap(as->y + y);
    }
}

static void point_pairs(struct df_asm *as, bool lit)
{
    if (as->mode != DF_MODE_POINT) {
        wrong_mode(as, lit ? "plot" : "at", "point");
        return;
    }
    if (!take_pairs(as, "x, y")) {
        return;
    }
    for (uint32_t i = 0; i < as->argument_count; i += 2) {
        int32_t x, y;
        df_asm_integer(as, &as->arguments[i], 0, DF_POINT_MAX, "x", &x);
        df_asm_integer(as, &as->arguments[i + 1], 0, DF_POINT_MAX, "y", &y);
        emit_point(as, lit, x, y);
        track(as, &as->arguments[i], true, x, y);
    }
}

static void vector_pairs(struct df_asm *as, bool lit)
{
    if (as->mode != DF_MODE_LONG && as->mode != DF_MODE_SHORT && as->mode != DF_MODE_RELPOINT) {
        wrong_mode(as, lit ? "draw" : "move", "longv, shortv or relpoint");
        return;
    }
    if (!take_pairs(as, "dx, dy")) {
        return;
    }
    int32_t most = as->mode == DF_MODE_LONG ? DF_LONG_MAX : DF_SHORT_MAX;
    for (uint32_t i = 0; i < as->argument_count; i += 2) {
        int32_t dx, dy;
        df_asm_integer(as, &as->arguments[i], -most, most, "dx", &dx);
        df_asm_integer(as, &as->arguments[i + 1], -most, most, "dy", &dy);
        emit_vector(as, lit, dx, dy);
        track(as, &as->arguments[i], false, dx, dy);
    }
}

void df_asm_data_pairs(struct df_asm *as, unsigned what)
{
    bool lit = what & 1;
    if (what >> 1 == DF_MODE_POINT) {
        point_pairs(as, lit);
    } else {
        vector_pairs(as, lit);
    }
}

/* ---- moveto, lineto ---- */

/* From here to there in as many words as it takes, in equal parts. */
static void go_to(struct df_asm *as, bool lit, int32_t x, int32_t y)
{
    int32_t most = as->mode == DF_MODE_LONG ? DF_LONG_MAX : DF_SHORT_MAX;
    int32_t dx = x - as->x, dy = y - as->y;
    int32_t longer = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
    int32_t parts = (longer + most - 1) / most;
    int32_t done_x = 0, done_y = 0;
    for (int32_t i = 1; i <= parts; i++) {
        int32_t to_x = (int32_t)df_asm_round((double)dx * i / parts);
        int32_t to_y = (int32_t)df_asm_round((double)dy * i / parts);
        emit_vector(as, lit, to_x - done_x, to_y - done_y);
        done_x = to_x;
        done_y = to_y;
    }
    as->x = x;
    as->y = y;
}

static void one_absolute(struct df_asm *as, bool lit, const struct df_argument *pair)
{
    int32_t lo = as->mode == DF_MODE_POINT ? 0 : -2048;
    int32_t hi = as->mode == DF_MODE_POINT ? DF_POINT_MAX : 2047;
    int32_t x, y;
    bool ok = df_asm_layout_integer(as, &pair[0], lo, hi, "x", &x);
    ok = df_asm_layout_integer(as, &pair[1], lo, hi, "y", &y) && ok;
    if (!ok) {
        as->position = DF_POISON;
    } else if (as->mode == DF_MODE_POINT) {
        emit_point(as, lit, x, y);
        as->position = DF_KNOWN;
        as->x = x;
        as->y = y;
    } else if (as->position == DF_KNOWN) {
        go_to(as, lit, x, y);
    }
}

void df_asm_data_absolute(struct df_asm *as, unsigned what)
{
    bool lit = what != 0;
    const char *name = lit ? "lineto" : "moveto";
    bool vectors = as->mode == DF_MODE_LONG || as->mode == DF_MODE_SHORT;
    if (!vectors && (lit || (as->mode != DF_MODE_RELPOINT && as->mode != DF_MODE_POINT))) {
        wrong_mode(as, name, lit ? "longv or shortv" : "point, longv, shortv or relpoint");
        return;
    }
    if (as->position == DF_NOT_KNOWN && as->mode != DF_MODE_POINT) {
        df_asm_error(as, as->statement_column,
                     "'%s' from an unknown place; expected at, plot or .pos before it", name);
        as->position = DF_POISON;
        as->layout_broken = true;
    }
    if (!take_pairs(as, "x, y")) {
        return;
    }
    for (uint32_t i = 0; i < as->argument_count; i += 2) {
        one_absolute(as, lit, &as->arguments[i]);
    }
}

/* ---- value, text ---- */

void df_asm_data_values(struct df_asm *as, unsigned what)
{
    (void)what;
    if (as->mode != DF_MODE_GRAPHX && as->mode != DF_MODE_GRAPHY) {
        wrong_mode(as, "value", "graphx or graphy");
        return;
    }
    forget_position(as);
    if (!df_asm_arguments(as, "a value")) {
        as->layout_broken = true;
        return;
    }
    for (uint32_t i = 0; i < as->argument_count; i++) {
        int32_t value;
        df_asm_integer(as, &as->arguments[i], 0, DF_POINT_MAX, "the value", &value);
        df_asm_emit(as, (uint16_t)value);
    }
}

/* Two characters a word, the first in the low byte. */
struct packer {
    struct df_asm *as;
    uint16_t low;
    bool half;
};

static void pack(struct packer *p, unsigned code)
{
    if (p->half) {
        df_asm_emit(p->as, (uint16_t)(p->low | code << 8));
    }
    p->low = (uint16_t)code;
    p->half = !p->half;
}

static void pack_string(struct packer *p, const struct df_argument *argument)
{
    const struct df_value *value = &argument->value;
    if (value->forward) {
        df_asm_error(p->as, argument->column,
                     "the string is defined further down; expected a name defined above");
        p->as->layout_broken = true;
    }
    const char *bytes = value->text, *end = bytes + value->length;
    unsigned code;
    while (df_string_next(&bytes, end, &code)) {
        pack(p, code & 0177); /* the lexer lets no other in */
    }
}

void df_asm_data_text(struct df_asm *as, unsigned what)
{
    (void)what;
    if (as->mode != DF_MODE_CHAR) {
        wrong_mode(as, "text", "char");
        return;
    }
    forget_position(as);
    if (!df_asm_arguments(as, "a string in quotes or a character code")) {
        as->layout_broken = true;
        return;
    }
    struct packer p = {.as = as};
    for (uint32_t i = 0; i < as->argument_count; i++) {
        const struct df_value *value = &as->arguments[i].value;
        int32_t code;
        if (value->kind == DF_VALUE_STRING) {
            pack_string(&p, &as->arguments[i]);
        } else {
            df_asm_integer(as, &as->arguments[i], 0, 0177, "the character code", &code);
            pack(&p, (unsigned)code);
        }
    }
    if (p.half) {
        pack(&p, 0);
    }
}
