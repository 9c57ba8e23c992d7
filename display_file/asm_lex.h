/* asm_lex.h — one line of .df source into tokens, in either dialect.
 *
 * Models:     the words of display_file/LANGUAGE.md: names, numbers, strings, operators, comments.
 * Units:      columns are bytes from 1.
 * Ownership:  tokens point into the line, which must outlive them.
 * Errors:     a malformed token is DF_TOKEN_BAD; `message` then says what is wrong.
 * Source:     the DEC dialect's numbers and characters after DEC's MACRO-11 manual.
 */
#ifndef DF_ASM_LEX_H
#define DF_ASM_LEX_H

#include <stdbool.h>
#include <stdint.h>

enum df_token_kind {
    DF_TOKEN_END,  /* end of line or a comment */
    DF_TOKEN_NAME, /* also a directive with its dot, and a lone dot */
    DF_TOKEN_NUMBER,
    DF_TOKEN_STRING, /* text includes the quotes */
    DF_TOKEN_OPERATOR,
    DF_TOKEN_BAD,
};

/* Operators of two characters. */
#define DF_OP2(a, b) ((int)(a) << 8 | (int)(b))

struct df_token {
    enum df_token_kind kind;
    const char *text;
    uint32_t length;
    uint32_t column;
    double number;
    int op;
    bool spaced; /* white space before it */
};

struct df_lexer {
    const char *line;
    uint32_t length, position;
    bool dec;              /* DEC dialect */
    int radix;             /* DEC: of numbers without a final point */
    struct df_token token; /* the current one */
    char message[128];
};

/* Starts a line and takes its first token. */
void df_lex_start(struct df_lexer *lex, const char *line, uint32_t length, bool dec);
void df_lex_next(struct df_lexer *lex);
/* Takes the current token again as a quoted string; in the DEC dialect it is none by itself. */
void df_lex_string_again(struct df_lexer *lex);
/* Takes the token that starts at `position` (0-based) next. */
void df_lex_seek(struct df_lexer *lex, uint32_t position);

bool df_token_is_op(const struct df_token *token, int op);
/* Compares without case. */
bool df_token_is(const struct df_token *token, const char *name);

/* The next character of a string token's inside: advances *p below `end`; false at its end. */
bool df_string_next(const char **p, const char *end, unsigned *code);

#endif
