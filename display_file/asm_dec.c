/* The DEC dialect: MACRO-11 expressions, DEC's own mnemonics, its data directives. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "display_file/asm_state.h"
#include "display_file/df_regs.h"

#define LARGEST 1e9 /* of an intermediate value */

/* ---- DEC's names for bits, as its GT40 and VT11 manuals give them ---- */

static const struct {
    const char *name;
    uint16_t value;
} symbols[] = {
    {"CHAR", 0100000},   {"SHORTV", 0104000}, {"LONGV", 0110000},  {"POINT", 0114000},
    {"GRAPHX", 0120000}, {"GRAPHY", 0124000}, {"RELATV", 0130000}, {"INT0", 02000},
    {"INT1", 02200},     {"INT2", 02400},     {"INT3", 02600},     {"INT4", 03000},
    {"INT5", 03200},     {"INT6", 03400},     {"INT7", 03600},     {"LPOFF", 0100},
    {"LPON", 0140},      {"BLKOFF", 020},     {"BLKON", 030},      {"LINE0", 04},
    {"LINE1", 05},       {"LINE2", 06},       {"LINE3", 07},       {"DJMP", 0160000},
    {"DNOP", 0164000},   {"DSTOP", 0172000},  {"STATSA", 0170000}, {"SINOF", 01000},
    {"SINON", 01400},    {"LPLITE", 0200},    {"LPDARK", 0300},    {"ITAL0", 040},
    {"ITAL1", 060},      {"SYNC", 04},        {"STATSB", 0174000}, {"INCR", 0100},
    {"GREEN", 01000},    {"YELLOW", 01200},   {"ORANGE", 01400},   {"RED", 01600},
    {"INTX", 040000},    {"MAXX", 01777},     {"MAXY", 01377},     {"MINUSX", 020000},
    {"MINUSY", 020000},  {"MAXSX", 017600},   {"MAXSY", 077},      {"MISVX", 020000},
    {"MISVY", 0100},
};

#define SYMBOLS (sizeof symbols / sizeof symbols[0])

bool df_asm_dec_symbol(const char *name, uint32_t length, double *value)
{
    for (unsigned i = 0; i < SYMBOLS; i++) {
        if (df_asm_same(name, length, symbols[i].name, (uint32_t)strlen(symbols[i].name))) {
            *value = symbols[i].value;
            return true;
        }
    }
    return false;
}

const char *df_asm_dec_name(const struct df_asm *as, uint32_t index)
{
    (void)as;
    return index < SYMBOLS ? symbols[index].name : NULL;
}

/* ---- expressions: from left to right ---- */

static bool expression(struct df_asm *as, struct df_value *value);

/* ^O ^D ^B and ^C; the current token is '^'. */
static bool term(struct df_asm *as, struct df_value *value);

static bool caret(struct df_asm *as, struct df_value *value)
{
    uint32_t column = as->lex.token.column;
    uint32_t at = as->lex.position;
    char letter = at < as->lex.length ? as->lex.line[at] : 0;
    letter = letter >= 'a' && letter <= 'z' ? (char)(letter - 'a' + 'A') : letter;
    if (letter == 0 || strchr("ODBC", letter) == NULL) {
        df_asm_error(as, column, "unexpected '^'; expected ^O, ^D, ^B or ^C");
        return false;
    }
    int radix = as->lex.radix;
    as->lex.radix = letter == 'D' ? 10 : letter == 'B' ? 2 : letter == 'O' ? 8 : radix;
    df_lex_seek(&as->lex, at + 1);
    bool ok = term(as, value);
    as->lex.radix = radix;
    if (ok && letter == 'C' && value->kind == DF_VALUE_NUMBER) {
        value->number = -value->number - 1;
    }
    return ok;
}

static bool angle(struct df_asm *as, struct df_value *value)
{
    df_lex_next(&as->lex);
    if (!expression(as, value)) {
        return false;
    }
    if (!df_token_is_op(&as->lex.token, '>')) {
        df_asm_unexpected(as, "an operator or '>'");
        return false;
    }
    df_lex_next(&as->lex);
    return true;
}

static bool plain_term(struct df_asm *as, struct df_value *value)
{
    struct df_token token = as->lex.token;
    if (df_token_is_op(&token, '<')) {
        return angle(as, value);
    }
    if (df_token_is_op(&token, '^')) {
        return caret(as, value);
    }
    if (df_token_is_op(&token, '-') || df_token_is_op(&token, '+')) {
        df_lex_next(&as->lex);
        bool ok = term(as, value);
        if (ok && token.op == '-' && value->kind == DF_VALUE_NUMBER) {
            value->number = -value->number;
        }
        return ok;
    }
    *value = (struct df_value){.kind = DF_VALUE_NUMBER, .number = token.number};
    if (token.kind == DF_TOKEN_NUMBER) {
        df_lex_next(&as->lex);
        return true;
    }
    if (token.kind != DF_TOKEN_NAME) {
        df_asm_unexpected(as, "a number, a name or '<'");
        return false;
    }
    df_lex_next(&as->lex);
    if (token.length == 1 && token.text[0] == '.') {
        value->number = as->address;
        return true;
    }
    *value = df_asm_lookup(as, &token);
    return !as->line_failed;
}

static bool term(struct df_asm *as, struct df_value *value)
{
    if (as->nesting >= DF_ASM_NESTING) {
        df_asm_error(as, as->lex.token.column, "nested too deeply; expected at most %d levels",
                     DF_ASM_NESTING);
        return false;
    }
    as->nesting++;
    bool ok = plain_term(as, value);
    as->nesting--;
    if (ok && value->kind == DF_VALUE_STRING) {
        df_asm_error(as, as->lex.token.column, "a string in an expression; expected a number");
        return false;
    }
    return ok;
}

/* A number a native program made may have a fraction; words have none. */
static bool whole(struct df_asm *as, const struct df_token *op, double value, int64_t *out)
{
    if (!(fabs(value) <= LARGEST)) {
        df_asm_error(as, op->column, "the result is too large; expected at most 10^9");
        return false;
    }
    *out = (int64_t)df_asm_round(value);
    return true;
}

static bool compute(struct df_asm *as, const struct df_token *op, double left, double right,
                    double *out)
{
    int64_t a, b;
    if (!whole(as, op, left, &a) || !whole(as, op, right, &b)) {
        return false;
    }
    switch (op->op) {
    case '+':
        *out = (double)(a + b);
        break;
    case '-':
        *out = (double)(a - b);
        break;
    case '*':
        *out = (double)(a * b);
        break;
    case '&':
        *out = (double)(a & b);
        break;
    case '/':
        if (b == 0) {
            df_asm_error(as, op->column, "division by zero; expected another divisor");
            return false;
        }
        *out = (double)(a / b);
        break;
    default:
        *out = (double)(a | b);
    }
    return whole(as, op, *out, &a);
}

static bool is_operator(const struct df_token *token)
{
    return token->kind == DF_TOKEN_OPERATOR && token->op < 128 &&
           strchr("+-*/&!|", token->op) != NULL;
}

static bool expression(struct df_asm *as, struct df_value *value)
{
    if (!term(as, value)) {
        return false;
    }
    while (is_operator(&as->lex.token)) {
        struct df_token op = as->lex.token;
        struct df_value right;
        df_lex_next(&as->lex);
        if (!term(as, &right)) {
            return false;
        }
        struct df_value result = {.kind = DF_VALUE_NUMBER,
                                  .forward = value->forward || right.forward,
                                  .poison = value->poison || right.poison};
        if (value->kind != DF_VALUE_NUMBER || right.kind != DF_VALUE_NUMBER) {
            result.kind = DF_VALUE_UNKNOWN;
        } else if (!compute(as, &op, value->number, right.number, &result.number)) {
            return false;
        }
        *value = result;
    }
    return true;
}

bool df_asm_dec_value(struct df_asm *as, struct df_argument *argument)
{
    return expression(as, &argument->value);
}

/* ---- statements ---- */

static void words(struct df_asm *as)
{
    if (!df_asm_arguments(as, "a word")) {
        as->layout_broken = true;
        return;
    }
    for (uint32_t i = 0; i < as->argument_count; i++) {
        int32_t word;
        df_asm_integer(as, &as->arguments[i], -32768, 65535, "the word", &word);
        df_asm_emit(as, (uint16_t)(word & 0177777));
    }
}

/* NAME = expr, . = expr; the current token is '='. */
static void assign(struct df_asm *as, const struct df_token *name)
{
    df_lex_next(&as->lex);
    if (df_token_is_op(&as->lex.token, '=')) {
        df_lex_next(&as->lex); /* NAME == expr is global in MACRO-11 */
    }
    struct df_argument argument;
    bool dot = name->length == 1 && name->text[0] == '.';
    bool ok = df_asm_value(as, &argument) && df_asm_end_of_line(as);
    if (!ok) {
        argument.value =
            (struct df_value){.kind = DF_VALUE_UNKNOWN, .forward = true, .poison = true};
    }
    if (!dot) {
        df_asm_define(as, name, DF_SYMBOL_VARIABLE, argument.value);
        return;
    }
    int32_t address;
    if (!ok ||
        !df_asm_layout_integer(as, &argument, 0, DF_MEMORY_BYTES - 1, "the address", &address)) {
        as->layout_broken = true;
    } else if (address % 2 != 0) {
        df_asm_error(as, argument.column, "the address %o is odd; expected an even one",
                     (unsigned)address);
        as->layout_broken = true;
    } else {
        df_asm_set_address(as, (uint32_t)address);
    }
}

void df_asm_dec_statement(struct df_asm *as)
{
    if (as->lex.token.kind == DF_TOKEN_NAME) {
        struct df_lexer before = as->lex;
        struct df_token name = as->lex.token;
        df_lex_next(&as->lex);
        if (df_token_is_op(&as->lex.token, '=')) {
            assign(as, &name);
            return;
        }
        as->lex = before;
    }
    words(as);
}

/* ---- directives ---- */

static void directive_byte(struct df_asm *as, unsigned what)
{
    (void)what;
    if (!df_asm_arguments(as, "a byte")) {
        as->layout_broken = true;
        return;
    }
    for (uint32_t i = 0; i < as->argument_count; i++) {
        int32_t byte;
        df_asm_integer(as, &as->arguments[i], -128, 255, "the byte", &byte);
        df_asm_emit_byte(as, (uint8_t)(byte & 0377));
    }
}

/* One <octal> part of .ASCII; position is at '<'. */
static bool ascii_code(struct df_asm *as)
{
    struct df_value value;
    struct df_argument argument = {.column = as->lex.token.column};
    as->nesting = 0;
    if (!angle(as, &value)) {
        return false;
    }
    argument.value = value;
    int32_t code;
    df_asm_integer(as, &argument, 0, 0377, "the character code", &code);
    df_asm_emit_byte(as, (uint8_t)code);
    return true;
}

/* One /text/ part of .ASCII, between two of whatever character comes first. */
static bool ascii_text(struct df_asm *as)
{
    uint32_t start = as->lex.token.column - 1;
    const char *line = as->lex.line;
    char quote = line[start];
    const char *text = line + start + 1;
    const char *end = memchr(text, quote, as->lex.length - start - 1);
    if (end == NULL) {
        df_asm_error(as, start + 1,
                     "the text is not closed; expected '%c' before the end of the line", quote);
        return false;
    }
    for (; text < end; text++) {
        if ((unsigned char)*text < 32 || (unsigned char)*text > 126) {
            df_asm_error(as, (uint32_t)(text - line) + 1,
                         "a character that is not printable ASCII; expected <octal code>");
            return false;
        }
        df_asm_emit_byte(as, (uint8_t)*text);
    }
    df_lex_seek(&as->lex, (uint32_t)(end - line) + 1);
    return true;
}

static void directive_ascii(struct df_asm *as, unsigned zero)
{
    /* The text may start with any character, even one that is no token. */
    if (as->lex.token.column - 1 >= as->lex.length) {
        df_asm_unexpected(as, "text between two equal characters");
        return;
    }
    bool ok = true;
    do {
        uint32_t at = as->lex.token.column - 1;
        ok = as->lex.line[at] == '<' ? ascii_code(as) : ascii_text(as);
    } while (ok && as->lex.token.kind != DF_TOKEN_END);
    if (!ok) {
        as->layout_broken = true;
    }
    if (zero) {
        df_asm_emit_byte(as, 0);
    }
}

static void directive_even(struct df_asm *as, unsigned what)
{
    (void)what;
    df_asm_end_of_line(as);
    df_asm_even(as);
}

static void directive_block(struct df_asm *as, unsigned bytes)
{
    int32_t count = 0;
    if (!df_asm_arguments(as, "how many")) {
        as->layout_broken = true;
        return;
    }
    if (as->argument_count != 1) {
        df_asm_error(as, as->arguments[1].column, "too many operands; expected one");
        return;
    }
    if (!df_asm_layout_integer(as, &as->arguments[0], 0, DF_MEMORY_BYTES, "the count", &count)) {
        return;
    }
    for (int32_t i = 0; i < count && !as->address_lost && !as->fatal; i++) {
        if (bytes == 1) {
            df_asm_emit_byte(as, 0);
        } else {
            df_asm_emit(as, 0);
        }
    }
}

static void directive_end(struct df_asm *as, unsigned what)
{
    (void)what;
    if (as->lex.token.kind != DF_TOKEN_END) {
        df_asm_directive_start(as);
    }
    as->ended = true;
}

static void directive_ignored(struct df_asm *as, unsigned what)
{
    (void)as;
    (void)what;
}

static const struct df_asm_statement directives[] = {
    {".byte", directive_byte, 0},     {".ascii", directive_ascii, 0},
    {".asciz", directive_ascii, 1},   {".even", directive_even, 0},
    {".blkw", directive_block, 2},    {".blkb", directive_block, 1},
    {".end", directive_end, 0},       {".title", directive_ignored, 0},
    {".sbttl", directive_ignored, 0}, {".ident", directive_ignored, 0},
    {".page", directive_ignored, 0},  {".list", directive_ignored, 0},
    {".nlist", directive_ignored, 0}, {".enabl", directive_ignored, 0},
    {".dsabl", directive_ignored, 0}, {".asect", directive_ignored, 0},
};

static const struct df_asm_statement *directive_of(const struct df_token *name)
{
    for (unsigned i = 0; i < sizeof directives / sizeof directives[0]; i++) {
        if (df_token_is(name, directives[i].name)) {
            return &directives[i];
        }
    }
    return NULL;
}

bool df_asm_dec_directive(struct df_asm *as)
{
    const struct df_asm_statement *directive = directive_of(&as->lex.token);
    if (directive == NULL) {
        return false;
    }
    df_lex_next(&as->lex);
    directive->handler(as, directive->what);
    return true;
}

bool df_asm_dec_knows(const struct df_token *name)
{
    double value;
    return directive_of(name) != NULL || df_asm_dec_symbol(name->text, name->length, &value);
}
