/* Native statements for control words: modes, status, step, colour, jump, nop. */
#include <stdio.h>
#include <string.h>

#include "display_file/asm_state.h"
#include "display_file/df_regs.h"

static const char *const mode_names[] = {"char",   "shortv", "longv",   "point",
                                         "graphx", "graphy", "relpoint"};

#define MODES (sizeof mode_names / sizeof mode_names[0])

const char *df_asm_mode_name(unsigned mode)
{
    return mode < MODES ? mode_names[mode] : "?";
}

bool df_asm_mode_of(const struct df_token *name, unsigned *mode)
{
    for (unsigned i = 0; i < MODES; i++) {
        if (df_token_is(name, mode_names[i])) {
            *mode = i;
            return true;
        }
    }
    return false;
}

/* ---- options: name=value, or a name alone ---- */

struct option {
    const char *name;
    bool flag;       /* stands alone */
    int32_t highest; /* of the value */
    uint16_t change; /* bits set whenever the option is there */
    uint16_t on;     /* bits set when the value is not 0 (highest == 1) */
    unsigned shift;  /* of the value (highest > 1) */
};

static const struct option mode_options[] = {
    {"i", false, 7, DF_SGM_INTENSITY, 0, DF_SGM_INTENSITY_SHIFT},
    {"pen", false, 1, DF_SGM_PEN, DF_SGM_PEN_ON, 0},
    {"blink", false, 1, DF_SGM_BLINK, DF_SGM_BLINK_ON, 0},
    {"line", false, 3, DF_SGM_LINE, 0, 0},
    {0},
};

static const struct option status_options[] = {
    {"stop", true, 0, DF_LSA_STOP, 0, 0},
    {"sync", true, 0, DF_LSA_SYNC, 0, 0},
    {"stopint", false, 1, DF_LSA_STOP_INT, DF_LSA_STOP_INT_ON, 0},
    /* The hardware's bit switches the spot off; the option says whether it is there. */
    {"penlight", false, 1, DF_LSA_INTENSIFY | DF_LSA_INTENSIFY_OFF, DF_LSA_INTENSIFY_OFF, 0},
    {"italics", false, 1, DF_LSA_ITALICS, DF_LSA_ITALICS_ON, 0},
    {0},
};

static const struct option colour_options[] = {
    {"step", false, DF_LSB_VALUE, DF_LSB_STEP, 0, 0},
    {0},
};

static const struct option *option_of(const struct option *options, const struct df_token *name)
{
    for (; options->name != NULL; options++) {
        if (df_token_is(name, options->name)) {
            return options;
        }
    }
    return NULL;
}

static void unknown_option(struct df_asm *as, const struct option *options)
{
    char list[192] = "";
    for (; options->name != NULL; options++) {
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%s%s", used > 0 ? ", " : "", options->name,
                 options->flag ? "" : "=");
    }
    if (df_token_is_op(&as->lex.token, '!')) {
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, " (for words joined by '!': .dialect dec above)");
    }
    df_asm_unexpected(as, list);
}

/* The value after '='; bits to set are or-ed into *word, `penlight` is the one that is inverted. */
static bool option_value(struct df_asm *as, const struct option *option, uint16_t *word)
{
    struct df_argument argument;
    int32_t value = 0;
    char what[48];
    if (!df_token_is_op(&as->lex.token, '=')) {
        df_asm_unexpected(as, "'=' and a value");
        return false;
    }
    df_lex_next(&as->lex);
    if (!df_asm_value(as, &argument)) {
        return false;
    }
    snprintf(what, sizeof what, "%s", option->name);
    if (option->highest == 1) {
        if (argument.value.kind == DF_VALUE_STRING) {
            df_asm_error(as, argument.column, "a string where %s belongs; expected on or off",
                         what);
            return false;
        }
        value = argument.value.kind == DF_VALUE_NUMBER && argument.value.number != 0;
        bool inverted = option->change & option->on;
        *word = (uint16_t)(*word | (inverted ? option->change & ~option->on : option->change));
        if ((value != 0) != inverted) {
            *word |= option->on;
        }
        return true;
    }
    if (!df_asm_integer(as, &argument, 0, option->highest, what, &value)) {
        return false;
    }
    *word = (uint16_t)(*word | option->change | value << option->shift);
    return true;
}

static bool take_options(struct df_asm *as, const struct option *options, uint16_t *word)
{
    uint16_t given = 0;
    while (as->lex.token.kind != DF_TOKEN_END) {
        struct df_token name = as->lex.token;
        const struct option *option = name.kind == DF_TOKEN_NAME ? option_of(options, &name) : NULL;
        if (option == NULL) {
            unknown_option(as, options);
            return false;
        }
        if (given & option->change) {
            df_asm_error(as, name.column, "'%s' is given twice; expected each option once",
                         option->name);
            return false;
        }
        given |= option->change;
        df_lex_next(&as->lex);
        if (option->flag) {
            *word |= option->change;
        } else if (!option_value(as, option, word)) {
            return false;
        }
        if (df_token_is_op(&as->lex.token, ',')) {
            df_lex_next(&as->lex);
        }
    }
    return true;
}

/* ---- the statements ---- */

static void statement_mode(struct df_asm *as, unsigned mode)
{
    uint16_t word = (uint16_t)(DF_SET_MODE | mode << DF_MODE_SHIFT);
    take_options(as, mode_options, &word);
    df_asm_emit(as, word);
    as->mode = mode;
}

static void statement_status(struct df_asm *as, unsigned bits)
{
    uint16_t word = (uint16_t)(DF_STATUS_A | bits);
    take_options(as, status_options, &word);
    df_asm_emit(as, word);
}

/* One operand in lo … hi and the end of the line. */
static bool one_integer(struct df_asm *as, int32_t hi, const char *what, int32_t *value,
                        uint32_t *column)
{
    struct df_argument argument;
    *value = 0;
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, what);
        return false;
    }
    if (!df_asm_value(as, &argument) || !df_asm_end_of_line(as)) {
        return false;
    }
    *column = argument.column;
    return df_asm_integer(as, &argument, 0, hi, what, value);
}

static void statement_step(struct df_asm *as, unsigned what)
{
    (void)what;
    int32_t step;
    uint32_t column;
    one_integer(as, DF_LSB_VALUE, "the step", &step, &column);
    df_asm_emit(as, (uint16_t)(DF_STATUS_B | DF_LSB_STEP | step));
}

/* The same word can set the step, too. */
static void statement_colour(struct df_asm *as, unsigned what)
{
    (void)what;
    static const char expected[] = "a colour: green, yellow, orange or red";
    struct df_argument argument;
    int32_t colour = 0;
    uint16_t word = DF_STATUS_B | DF_LSB_COLOUR;
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, expected);
    } else if (df_asm_value(as, &argument)) {
        df_asm_integer(as, &argument, DF_COLOUR_GREEN, DF_COLOUR_RED, "the colour", &colour);
        if (df_token_is_op(&as->lex.token, ',')) {
            df_lex_next(&as->lex);
        }
        take_options(as, colour_options, &word);
    }
    df_asm_emit(as, (uint16_t)(word | colour << DF_LSB_COLOUR_SHIFT));
}

static void statement_jump(struct df_asm *as, unsigned what)
{
    (void)what;
    int32_t address;
    uint32_t column;
    if (one_integer(as, DF_ADDRESS_SPACE - 1, "the address", &address, &column) &&
        address % 2 != 0) {
        df_asm_error(as, column, "the address 0o%o is odd; expected an even one",
                     (unsigned)address);
    }
    df_asm_emit(as, DF_JUMP);
    df_asm_emit(as, (uint16_t)address);
    if (as->position == DF_KNOWN) {
        as->position = DF_NOT_KNOWN;
    }
}

static void statement_nop(struct df_asm *as, unsigned what)
{
    (void)what;
    df_asm_end_of_line(as);
    df_asm_emit(as, DF_NOP);
}

static const struct df_asm_statement statements[] = {
    {"char", statement_mode, DF_MODE_CHAR},
    {"shortv", statement_mode, DF_MODE_SHORT},
    {"longv", statement_mode, DF_MODE_LONG},
    {"point", statement_mode, DF_MODE_POINT},
    {"graphx", statement_mode, DF_MODE_GRAPHX},
    {"graphy", statement_mode, DF_MODE_GRAPHY},
    {"relpoint", statement_mode, DF_MODE_RELPOINT},
    {"status", statement_status, 0},
    {"stop", statement_status, DF_LSA_STOP},
    {"sync", statement_status, DF_LSA_SYNC},
    {"step", statement_step, 0},
    {"colour", statement_colour, 0},
    {"jump", statement_jump, 0},
    {"nop", statement_nop, 0},
    {"at", df_asm_data_pairs, DF_MODE_POINT << 1},
    {"plot", df_asm_data_pairs, DF_MODE_POINT << 1 | 1},
    {"move", df_asm_data_pairs, DF_MODE_LONG << 1},
    {"draw", df_asm_data_pairs, DF_MODE_LONG << 1 | 1},
    {"moveto", df_asm_data_absolute, 0},
    {"lineto", df_asm_data_absolute, 1},
    {"value", df_asm_data_values, 0},
    {"text", df_asm_data_text, 0},
};

#define STATEMENTS (sizeof statements / sizeof statements[0])

const char *df_asm_statement_name(const struct df_asm *as, uint32_t index)
{
    (void)as;
    return index < STATEMENTS ? statements[index].name : NULL;
}

bool df_asm_statement(struct df_asm *as)
{
    for (unsigned i = 0; i < STATEMENTS; i++) {
        if (df_token_is(&as->lex.token, statements[i].name)) {
            df_lex_next(&as->lex);
            statements[i].handler(as, statements[i].what);
            return true;
        }
    }
    return false;
}
