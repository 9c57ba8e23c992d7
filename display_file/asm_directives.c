/* Directives of both dialects, but for blocks. */
#include <string.h>

#include "display_file/asm_state.h"

static bool take_equals(struct df_asm *as)
{
    if (!df_token_is_op(&as->lex.token, '=')) {
        df_asm_unexpected(as, "'=' and a value");
        return false;
    }
    df_lex_next(&as->lex);
    return true;
}

/* The name is defined even when its value is faulty: uses of it are then poison, not errors. */
static void assign(struct df_asm *as, const struct df_token *name, enum df_symbol_kind kind)
{
    struct df_argument argument;
    bool ok = take_equals(as) && df_asm_value(as, &argument) && df_asm_end_of_line(as);
    if (!ok) {
        argument.value =
            (struct df_value){.kind = DF_VALUE_UNKNOWN, .forward = true, .poison = true};
    }
    struct df_local *local = df_asm_local(as, name->text, name->length);
    if (kind == DF_SYMBOL_VARIABLE && local != NULL) {
        local->value = argument.value;
    } else {
        df_asm_define(as, name, kind, argument.value);
    }
}

static void directive_assign(struct df_asm *as, unsigned what)
{
    struct df_token name = as->lex.token;
    if (name.kind != DF_TOKEN_NAME || name.text[0] == '.') {
        df_asm_unexpected(as, "a name");
        return;
    }
    df_lex_next(&as->lex);
    assign(as, &name, (enum df_symbol_kind)what);
}

/* One operand and the end of the line. */
static bool operand(struct df_asm *as, const char *expected, struct df_argument *argument)
{
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, expected);
        return false;
    }
    return df_asm_value(as, argument) && df_asm_end_of_line(as);
}

static void directive_org(struct df_asm *as, unsigned what)
{
    (void)what;
    struct df_argument argument;
    int32_t address;
    as->position = as->position == DF_POISON ? DF_POISON : DF_NOT_KNOWN;
    if (!operand(as, "an address", &argument)) {
        as->layout_broken = true;
        return;
    }
    if (!df_asm_layout_integer(as, &argument, 0, DF_MEMORY_BYTES - 1, "the address", &address)) {
        return;
    }
    if (address % 2 != 0) {
        df_asm_error(as, argument.column, "the address 0o%o is odd; expected an even one",
                     (unsigned)address);
        as->layout_broken = true;
        return;
    }
    df_asm_set_address(as, (uint32_t)address);
}

void df_asm_directive_start(struct df_asm *as)
{
    struct df_argument argument;
    int32_t address;
    uint32_t column = as->lex.token.column;
    if (as->start_given) {
        df_asm_error(as, column, "the start is already given at %s:%u; expected one",
                     df_asm_name(as, as->start_file), (unsigned)as->start_line);
        return;
    }
    if (!operand(as, "an address", &argument) ||
        !df_asm_integer(as, &argument, 0, DF_ADDRESS_SPACE - 1, "the start address", &address)) {
        return;
    }
    if (address % 2 != 0) {
        df_asm_error(as, argument.column, "the start address 0o%o is odd; expected an even one",
                     (unsigned)address);
        return;
    }
    as->start_given = true;
    as->start_file = as->file;
    as->start_line = as->line;
    as->start_column = argument.column;
    if (argument.value.kind == DF_VALUE_NUMBER) {
        as->program->entry = (uint32_t)address;
    }
}

static void directive_start(struct df_asm *as, unsigned what)
{
    (void)what;
    df_asm_directive_start(as);
}

static void directive_word(struct df_asm *as, unsigned what)
{
    (void)what;
    as->position = as->position == DF_POISON ? DF_POISON : DF_NOT_KNOWN;
    bool ok = df_asm_arguments(as, "a word");
    if (!ok) {
        as->layout_broken = true;
    }
    for (uint32_t i = 0; ok && i < as->argument_count; i++) {
        int32_t word;
        df_asm_integer(as, &as->arguments[i], -32768, 65535, "the word", &word);
        df_asm_emit(as, (uint16_t)(word & 0177777));
    }
}

static void directive_include(struct df_asm *as, unsigned what)
{
    (void)what;
    df_asm_include(as);
}

static void directive_assert(struct df_asm *as, unsigned what)
{
    (void)what;
    struct df_argument condition;
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, "a condition");
        return;
    }
    if (!df_asm_value(as, &condition)) {
        return;
    }
    if (!df_token_is_op(&as->lex.token, ',')) {
        df_asm_unexpected(as, "',' and a message in quotes");
        return;
    }
    df_lex_next(&as->lex);
    df_lex_string_again(&as->lex);
    struct df_token message = as->lex.token;
    if (message.kind != DF_TOKEN_STRING) {
        df_asm_unexpected(as, "a message in quotes");
        return;
    }
    df_lex_next(&as->lex);
    if (!df_asm_end_of_line(as)) {
        return;
    }
    if (condition.value.kind == DF_VALUE_STRING) {
        df_asm_error(as, condition.column, "a string where a condition belongs; expected a number");
    } else if (as->pass == 2 && condition.value.kind == DF_VALUE_NUMBER &&
               condition.value.number == 0) {
        df_asm_error(as, condition.column, "assertion failed: %.*s",
                     message.length > 300 ? 300 : (int)message.length - 2, message.text + 1);
    }
}

static void directive_mode(struct df_asm *as, unsigned what)
{
    (void)what;
    unsigned mode;
    if (!df_asm_mode_of(&as->lex.token, &mode)) {
        df_asm_unexpected(as, "point, longv, shortv, relpoint, graphx, graphy or char");
        as->mode = DF_MODE_POISON;
        return;
    }
    df_lex_next(&as->lex);
    if (df_asm_end_of_line(as)) {
        as->mode = mode;
    }
}

static void directive_pos(struct df_asm *as, unsigned what)
{
    (void)what;
    int32_t x = 0, y = 0;
    as->position = DF_POISON;
    if (!df_asm_arguments(as, "x, y")) {
        return;
    }
    if (as->argument_count != 2) {
        df_asm_error(as, as->arguments[0].column, "%u operand%s; expected x, y",
                     (unsigned)as->argument_count, as->argument_count == 1 ? "" : "s");
        return;
    }
    if (df_asm_layout_integer(as, &as->arguments[0], -2048, 2047, "x", &x) &&
        df_asm_layout_integer(as, &as->arguments[1], -2048, 2047, "y", &y)) {
        as->position = DF_KNOWN;
        as->x = x;
        as->y = y;
    }
}

static void directive_dialect(struct df_asm *as, unsigned what)
{
    (void)what;
    bool dec = df_token_is(&as->lex.token, "dec");
    if (!dec && !df_token_is(&as->lex.token, "native")) {
        df_asm_unexpected(as, "dec or native");
        return;
    }
    df_lex_next(&as->lex);
    if (df_asm_end_of_line(as)) {
        as->dec = dec;
        as->mode = DF_MODE_UNSET;
        as->position = DF_NOT_KNOWN;
        df_asm_even(as);
    }
}

/* A name in quotes, nothing else, into a field of the program. */
static void take_name(struct df_asm *as, const char *expected, bool (*allowed)(char c), char *field,
                      size_t size)
{
    df_lex_string_again(&as->lex);
    struct df_token token = as->lex.token;
    bool good = token.kind == DF_TOKEN_STRING && token.length >= 3;
    for (uint32_t i = 1; good && i < token.length - 1; i++) {
        good = allowed(token.text[i]);
    }
    if (!good) {
        df_asm_unexpected(as, expected);
        return;
    }
    if (token.length - 2 >= size) {
        df_asm_error(as, token.column, "the name is too long; expected at most %d characters",
                     (int)size - 1);
        return;
    }
    df_lex_next(&as->lex);
    if (df_asm_end_of_line(as)) {
        memcpy(field, token.text + 1, token.length - 2);
        field[token.length - 2] = '\0';
    }
}

static bool in_tube_name(char c)
{
    return c != '\\';
}

/* Which tube the program was made for; whether there is such a row is for the machine to say. */
static void directive_tube(struct df_asm *as, unsigned what)
{
    (void)what;
    take_name(as, "the name of a tube in quotes, such as \"VR17\" or \"VR17/P31\"", in_tube_name,
              as->program->tube, sizeof as->program->tube);
}

/* It becomes part of a file's name: a file elsewhere cannot be named. */
static bool in_firmware_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
}

/* Which firmware the program needs; whether there is such an image is for the machine to say. */
static void directive_firmware(struct df_asm *as, unsigned what)
{
    (void)what;
    take_name(as, "the name of firmware in quotes (letters, digits, _ and -), such as \"rt11\"",
              in_firmware_name, as->program->firmware, sizeof as->program->firmware);
}

static const struct df_asm_statement directives[] = {
    {".equ", directive_assign, DF_SYMBOL_CONSTANT},
    {".set", directive_assign, DF_SYMBOL_VARIABLE},
    {".org", directive_org, 0},
    {".start", directive_start, 0},
    {".word", directive_word, 0},
    {".include", directive_include, 0},
    {".assert", directive_assert, 0},
    {".pos", directive_pos, 0},
    {".mode", directive_mode, 0},
    {".dialect", directive_dialect, 0},
    {".tube", directive_tube, 0},
    {".firmware", directive_firmware, 0},
};

#define DIRECTIVES (sizeof directives / sizeof directives[0])

const char *df_asm_directive_name(const struct df_asm *as, uint32_t index)
{
    static const char *const blocks[] = {".repeat", ".endr", ".macro", ".endm",
                                         ".if",     ".else", ".endif"};
    (void)as;
    if (index < DIRECTIVES) {
        return directives[index].name;
    }
    index -= (uint32_t)DIRECTIVES;
    return index < sizeof blocks / sizeof blocks[0] ? blocks[index] : NULL;
}

bool df_asm_directive(struct df_asm *as)
{
    for (unsigned i = 0; i < DIRECTIVES; i++) {
        if (df_token_is(&as->lex.token, directives[i].name)) {
            df_lex_next(&as->lex);
            directives[i].handler(as, directives[i].what);
            return true;
        }
    }
    return false;
}
