#include "display_file/asm_lex.h"

#include <stdio.h>
#include <string.h>

#define NUMBER_LIMIT 1e15

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$';
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static int digit_value(char c)
{
    if (is_digit(c)) {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    if (c >= 'A' && c <= 'F') {
        return c - 'A' + 10;
    }
    return 99;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static char peek(const struct df_lexer *lex, uint32_t ahead)
{
    uint32_t at = lex->position + ahead;
    return at < lex->length ? lex->line[at] : '\n';
}

static void bad(struct df_lexer *lex, const char *message)
{
    lex->token.kind = DF_TOKEN_BAD;
    snprintf(lex->message, sizeof lex->message, "%s", message);
}

static bool name_character(const struct df_lexer *lex, char c)
{
    return is_letter(c) || is_digit(c) || (lex->dec && c == '.');
}

static void take_name(struct df_lexer *lex)
{
    lex->token.kind = DF_TOKEN_NAME;
    lex->position++;
    while (name_character(lex, peek(lex, 0))) {
        lex->position++;
    }
    if (lex->line[lex->token.column - 1] == '@' && lex->position == lex->token.column) {
        bad(lex, "'@' stands alone; expected a local name such as @loop");
    }
}

/* Digits in a power-of-two radix after 0o, 0x or 0b. */
static void take_prefixed(struct df_lexer *lex, int radix)
{
    double value = 0;
    unsigned digits = 0;
    lex->position += 2;
    while (digit_value(peek(lex, 0)) < radix) {
        value = value * radix + digit_value(peek(lex, 0));
        lex->position++;
        digits++;
    }
    lex->token.number = value;
    if (name_character(lex, peek(lex, 0)) || digits == 0) {
        snprintf(lex->message, sizeof lex->message, "malformed number; expected digits below %d",
                 radix);
        lex->token.kind = DF_TOKEN_BAD;
    } else if (value > NUMBER_LIMIT) {
        bad(lex, "number too large; expected at most 10^15");
    }
}

static void take_fraction(struct df_lexer *lex)
{
    double scale = 1;
    lex->position++;
    while (is_digit(peek(lex, 0))) {
        /* Digits beyond the precision of a double are dropped. */
        if (scale < 1e15 && lex->token.number < 1e14) {
            lex->token.number = lex->token.number * 10 + digit_value(peek(lex, 0));
            scale *= 10;
        }
        lex->position++;
    }
    lex->token.number /= scale;
}

static void take_native_number(struct df_lexer *lex)
{
    char prefix = lower(peek(lex, 1));
    if (peek(lex, 0) == '0' && (prefix == 'x' || prefix == 'o' || prefix == 'b')) {
        take_prefixed(lex, prefix == 'x' ? 16 : prefix == 'o' ? 8 : 2);
        return;
    }
    double value = 0;
    while (is_digit(peek(lex, 0))) {
        value = value * 10 + digit_value(peek(lex, 0));
        lex->position++;
    }
    lex->token.number = value;
    if (value > NUMBER_LIMIT) {
        bad(lex, "number too large; expected at most 10^15");
        return;
    }
    if (peek(lex, 0) == '.' && is_digit(peek(lex, 1))) {
        take_fraction(lex);
    }
    if (name_character(lex, peek(lex, 0)) || peek(lex, 0) == '.') {
        bad(lex,
            "malformed number; expected decimal digits, 0o octal, 0x hexadecimal or 0b binary");
    }
}

static void take_dec_number(struct df_lexer *lex)
{
    double octal = 0, decimal = 0;
    int highest = 0;
    while (is_digit(peek(lex, 0))) {
        int digit = digit_value(peek(lex, 0));
        octal = octal * lex->radix + digit;
        decimal = decimal * 10 + digit;
        highest = digit > highest ? digit : highest;
        lex->position++;
    }
    bool point = peek(lex, 0) == '.' && !is_digit(peek(lex, 1)) && !is_letter(peek(lex, 1));
    if (point) {
        lex->position++;
    }
    lex->token.number = point ? decimal : octal;
    if (!point && highest >= lex->radix) {
        snprintf(lex->message, sizeof lex->message,
                 "digit %d in a number of radix %d; expected digits below %d, or a final point for "
                 "decimal",
                 highest, lex->radix, lex->radix);
        lex->token.kind = DF_TOKEN_BAD;
    } else if (name_character(lex, peek(lex, 0))) {
        bad(lex, "malformed number; expected octal digits, or decimal digits and a final point");
    } else if (decimal > NUMBER_LIMIT) {
        bad(lex, "number too large; expected at most 10^15");
    }
}

static void take_number(struct df_lexer *lex)
{
    lex->token.kind = DF_TOKEN_NUMBER;
    if (lex->dec) {
        take_dec_number(lex);
    } else {
        take_native_number(lex);
    }
}

bool df_string_next(const char **p, const char *end, unsigned *code)
{
    if (*p >= end) {
        return false;
    }
    char c = *(*p)++;
    if (c != '\\' || *p >= end) {
        *code = (unsigned char)c;
        return true;
    }
    c = *(*p)++;
    switch (c) {
    case 'n':
        *code = '\n';
        break;
    case 'r':
        *code = '\r';
        break;
    case 'b':
        *code = '\b';
        break;
    case 't':
        *code = '\t';
        break;
    case '0':
        *code = 0;
        break;
    case 'x':
        *code = 0;
        for (int i = 0; i < 2 && *p < end && digit_value(**p) < 16; i++) {
            *code = *code * 16 + (unsigned)digit_value(*(*p)++);
        }
        break;
    default:
        *code = (unsigned char)c;
    }
    return true;
}

/* Steps over one character of quoted text, an escape included; false when it is malformed. */
static bool quoted_character(struct df_lexer *lex)
{
    char c = peek(lex, 0);
    if (c != '\\') {
        if ((unsigned char)c < 32 || (unsigned char)c > 126) {
            lex->token.column = lex->position + 1;
            bad(lex, "a character that is not printable ASCII; expected an escape such as \\x07");
            return false;
        }
        lex->position++;
        return true;
    }
    char escape = peek(lex, 1);
    if (escape == 0 || escape == '\n' || strchr("nrbt0\\\"'x", escape) == NULL) {
        lex->token.column = lex->position + 1;
        bad(lex, "unknown escape; expected \\n \\r \\b \\t \\0 \\\\ \\\" \\' or \\xHH");
        return false;
    }
    lex->position += 2;
    if (escape == 'x') {
        if (digit_value(peek(lex, 0)) > 7 || digit_value(peek(lex, 1)) > 15) {
            lex->token.column = lex->position - 1;
            bad(lex, "malformed \\x escape; expected two hexadecimal digits, at most \\x7f");
            return false;
        }
        lex->position += 2;
    }
    return true;
}

static void take_string(struct df_lexer *lex)
{
    lex->token.kind = DF_TOKEN_STRING;
    lex->position++;
    while (lex->position < lex->length && peek(lex, 0) != '"') {
        if (!quoted_character(lex)) {
            return;
        }
    }
    if (lex->position >= lex->length) {
        bad(lex, "the string is not closed; expected \" before the end of the line");
        return;
    }
    lex->position++;
}

/* 'A' */
static void take_character(struct df_lexer *lex)
{
    lex->token.kind = DF_TOKEN_NUMBER;
    lex->position++;
    const char *start = lex->line + lex->position;
    if (lex->position >= lex->length || peek(lex, 0) == '\'') {
        bad(lex, "empty character; expected one such as 'A'");
        return;
    }
    if (!quoted_character(lex)) {
        return;
    }
    const char *end = lex->line + lex->position;
    if (peek(lex, 0) != '\'') {
        bad(lex, "the character is not closed; expected one character between ' and '");
        return;
    }
    lex->position++;
    unsigned code = 0;
    df_string_next(&start, end, &code);
    lex->token.number = code;
}

/* DEC: 'A is one character, "AB two, the first in the low byte. */
static void take_dec_character(struct df_lexer *lex, uint32_t count)
{
    lex->token.kind = DF_TOKEN_NUMBER;
    if (lex->position + count >= lex->length) {
        bad(lex, "the line ends in a character constant; expected 'A or \"AB");
        return;
    }
    unsigned value = 0;
    for (uint32_t i = count; i >= 1; i--) {
        unsigned char c = (unsigned char)peek(lex, i);
        if (c < 32 || c > 126) {
            bad(lex, "a character that is not printable ASCII; expected its octal code");
            return;
        }
        value = value << 8 | c;
    }
    lex->position += 1 + count;
    lex->token.number = value;
}

static void take_operator(struct df_lexer *lex)
{
    static const char pairs[][3] = {"<<", ">>", "<=", ">=", "==", "!="};
    char a = peek(lex, 0), b = peek(lex, 1);
    lex->token.kind = DF_TOKEN_OPERATOR;
    lex->token.op = (unsigned char)a;
    for (unsigned i = 0; i < sizeof pairs / sizeof pairs[0] && !lex->dec; i++) {
        if (a == pairs[i][0] && b == pairs[i][1]) {
            lex->token.op = DF_OP2(a, b);
            lex->position += 2;
            return;
        }
    }
    lex->position++;
    if ((unsigned char)a < 33 || (unsigned char)a > 126) {
        snprintf(lex->message, sizeof lex->message,
                 "byte 0x%02x is not part of the language; expected printable ASCII",
                 (unsigned)(unsigned char)a);
        lex->token.kind = DF_TOKEN_BAD;
    }
}

static void skip_space(struct df_lexer *lex)
{
    while (lex->position < lex->length && (peek(lex, 0) == ' ' || peek(lex, 0) == '\t')) {
        lex->position++;
    }
}

static void begin_token(struct df_lexer *lex)
{
    uint32_t before = lex->position;
    skip_space(lex);
    lex->token = (struct df_token){.text = lex->line + lex->position,
                                   .column = lex->position + 1,
                                   .spaced = lex->position > before};
}

void df_lex_next(struct df_lexer *lex)
{
    begin_token(lex);
    uint32_t start = lex->position;
    char c = peek(lex, 0);
    if (lex->position >= lex->length || c == ';') {
        lex->token.kind = DF_TOKEN_END;
        return;
    }
    if (is_letter(c) || c == '.' || (c == '@' && !lex->dec)) {
        take_name(lex);
    } else if (is_digit(c)) {
        take_number(lex);
    } else if (c == '"' && !lex->dec) {
        take_string(lex);
    } else if (c == '\'' && !lex->dec) {
        take_character(lex);
    } else if (c == '"' || c == '\'') {
        take_dec_character(lex, c == '"' ? 2 : 1);
    } else {
        take_operator(lex);
    }
    lex->token.length = lex->position - start;
}

void df_lex_seek(struct df_lexer *lex, uint32_t position)
{
    lex->position = position;
    df_lex_next(lex);
}

void df_lex_string_again(struct df_lexer *lex)
{
    if (!lex->dec || lex->token.text == NULL || lex->token.kind == DF_TOKEN_END ||
        lex->token.text[0] != '"') {
        return;
    }
    uint32_t start = lex->token.column - 1;
    lex->position = start;
    take_string(lex);
    lex->token.length = lex->position - start;
}

void df_lex_start(struct df_lexer *lex, const char *line, uint32_t length, bool dec)
{
    *lex = (struct df_lexer){.line = line, .length = length, .dec = dec, .radix = 8};
    df_lex_next(lex);
}

bool df_token_is_op(const struct df_token *token, int op)
{
    return token->kind == DF_TOKEN_OPERATOR && token->op == op;
}

bool df_token_is(const struct df_token *token, const char *name)
{
    if (token->kind != DF_TOKEN_NAME || strlen(name) != token->length) {
        return false;
    }
    for (uint32_t i = 0; i < token->length; i++) {
        if (lower(token->text[i]) != name[i]) {
            return false;
        }
    }
    return true;
}
