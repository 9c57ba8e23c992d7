/* asm_state.h — what the parts of the assembler share. Private to display_file/asm*.c.
 *
 * Passes:     two runs over the same source by the same code. Pass 1 finds addresses; pass 2 has
 *             every label and puts words. Whatever decides how many words there are may use only
 *             names already defined above it, so that both passes lay the words out alike.
 * Errors:     one an executed line; a line that failed in pass 1 stays silent in pass 2. What an
 *             error leaves undefined is poison: it spreads without being reported again.
 * Ownership:  df_assemble_* own the struct and free what is in it.
 */
#ifndef DF_ASM_STATE_H
#define DF_ASM_STATE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "display_file/asm_lex.h"
#include "display_file/program.h"
#include "display_file/text_buffer.h"

#define DF_ASM_LINE_BYTES    4095
#define DF_ASM_FILE_BYTES    (12u << 20)
#define DF_ASM_FILE_LINES    1000000u
#define DF_ASM_INCLUDE_DEPTH 16
#define DF_ASM_REPEAT_DEPTH  8
#define DF_ASM_MACRO_DEPTH   16
#define DF_ASM_PARAMETERS    16
#define DF_ASM_ARGUMENTS     2100 /* more than fit a line */
#define DF_ASM_NESTING       100  /* parentheses and unary operators */
#define DF_ASM_WORDS         1000000u
#define DF_ASM_ERRORS        1000u
#define DF_ASM_SUGGESTIONS   50u /* "did you mean": each looks at every name there is */
#define DF_ASM_FILES         255u
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
#define DF_ASM_STEPS 20000u
#else
#define DF_ASM_STEPS 2000000u /* lines executed in a pass */
#endif

/* ---- source ---- */

enum df_block {
    DF_BLOCK_NONE,
    DF_BLOCK_REPEAT,
    DF_BLOCK_MACRO,
    DF_BLOCK_IF,
    DF_BLOCK_ELSE,
    DF_BLOCK_END_REPEAT,
    DF_BLOCK_END_MACRO,
    DF_BLOCK_END_IF
};

struct df_source_line {
    const char *text;
    uint32_t length;
    uint32_t shown; /* length for messages: of a line that is too long, nothing is read */
    enum df_block block;
    uint32_t match; /* opener: line index of its .else or end; the line count when it has none */
};

struct df_source {
    char *name;
    char *text;
    struct df_source_line *lines;
    uint32_t line_count;
    bool open; /* being assembled: including it again would be a cycle */
};

/* ---- values, names, frames ---- */

enum df_value_kind {
    DF_VALUE_NUMBER,
    DF_VALUE_STRING,  /* text between the quotes, escapes not yet taken */
    DF_VALUE_UNKNOWN, /* not known yet in pass 1, poison in pass 2 */
};

struct df_value {
    enum df_value_kind kind;
    bool forward; /* made from a name defined only further down */
    bool poison;  /* unknown because of an error that has been reported */
    double number;
    const char *text;
    uint32_t length;
};

struct df_argument {
    struct df_value value;
    uint32_t column;
};

enum df_symbol_kind {
    DF_SYMBOL_UNDEFINED,
    DF_SYMBOL_LABEL,
    DF_SYMBOL_CONSTANT,
    DF_SYMBOL_VARIABLE
};

struct df_symbol {
    char *key; /* lower case; local names end in #frame */
    enum df_symbol_kind kind;
    struct df_value value;
    uint8_t pass; /* that defined it last */
    bool referenced, reported;
    uint32_t file, line;
};

struct df_symbols {
    struct df_symbol **slots;
    uint32_t capacity, count;
};

struct df_local {
    const char *name;
    uint32_t length;
    struct df_value value;
};

/* The names of a macro call or a repeat round. */
struct df_frame {
    struct df_frame *outer; /* whose names are visible, too */
    uint32_t id;            /* tells local labels apart */
    uint32_t count;
    struct df_local locals[DF_ASM_PARAMETERS];
};

struct df_macro {
    char *name;
    uint32_t file, first, end; /* line indices of the body */
    bool dec;
    uint32_t parameter_count;
    struct df_local parameters[DF_ASM_PARAMETERS]; /* names only */
};

struct df_error {
    uint32_t file, line, column; /* line from 1; 0: the whole file */
    uint32_t order;
    uint64_t chain;
    char *message;
    char *note; /* where the macro was called, or NULL */
};

struct df_listing_row {
    uint32_t file, line; /* line from 1 */
    uint32_t address;
    uint32_t words; /* index of the first in `list_words`, and how many */
    uint32_t count;
    bool seen; /* an earlier round or call has already shown this line */
};

/* ---- the state of an assembly ---- */

#define DF_MODE_UNSET  16u /* no mode statement yet */
#define DF_MODE_POISON 17u

enum df_known { DF_KNOWN, DF_NOT_KNOWN, DF_POISON };

struct df_asm {
    struct df_program *program;
    int pass;
    bool fatal;         /* stop: the limits are reached or memory is out */
    bool layout_broken; /* addresses are no longer right: do not complain about them */

    struct df_source *sources;
    uint32_t source_count;
    struct df_symbols symbols;
    struct df_macro *macros;
    uint32_t macro_count;
    struct df_error *errors;
    uint32_t error_count, errors_dropped;
    uint64_t failures; /* lines that failed, reported or not */

    /* where we are */
    uint32_t file, line; /* line from 1 */
    struct df_lexer lex;
    uint32_t statement_column;
    bool dec, line_failed, ended;
    bool names_missing; /* an include failed: names it may define are not complained about */
    struct df_frame *frame;
    uint32_t frame_ids;
    uint32_t repeat_depth, macro_depth, include_depth;
    uint64_t chain;       /* which calls led here */
    struct df_text calls; /* the same for people, one call a line */
    uint32_t nesting;
    uint32_t steps;
    uint32_t suggestions;

    /* output */
    uint32_t address;  /* byte address, odd after an odd number of bytes */
    uint8_t low_byte;  /* waiting for its other half when the address is odd */
    bool address_lost; /* beyond memory, reported */
    uint32_t emitted;
    bool start_given;
    uint32_t start_file, start_line, start_column;

    /* what is tracked */
    unsigned mode;
    enum df_known position;
    int32_t x, y;

    /* operands of the current statement */
    struct df_argument arguments[DF_ASM_ARGUMENTS];
    uint32_t argument_count;

    /* listing, pass 2 only */
    bool listing;
    struct df_listing_row *rows;
    uint32_t row_count, row_capacity;
    uint16_t *list_words;
    uint32_t list_word_count, list_word_capacity;
};

/* asm_errors.c */
#if defined(__GNUC__)
#define DF_PRINTF(a, b) __attribute__((format(printf, a, b)))
#else
#define DF_PRINTF(a, b)
#endif
/* At this column of the current line. The rest of the line's errors are dropped. */
void df_asm_error(struct df_asm *as, uint32_t column, const char *format, ...) DF_PRINTF(3, 4);
void df_asm_error_at(struct df_asm *as, uint32_t file, uint32_t line, uint32_t column,
                     const char *format, ...) DF_PRINTF(5, 6);
/* The current token is not what belongs here. */
void df_asm_unexpected(struct df_asm *as, const char *expected);
void df_asm_out_of_memory(struct df_asm *as);
char *df_asm_errors_text(struct df_asm *as);
void df_asm_errors_free(struct df_asm *as);

/* asm_source.c */
/* Takes over `text`. Returns the index or UINT32_MAX (reported). */
uint32_t df_asm_add_source(struct df_asm *as, const char *name, char *text, size_t length);
/* Reads a whole file; NULL and a reason when that fails. */
char *df_asm_read(const char *path, bool regular_only, size_t *length, char *reason, size_t size);
uint32_t df_asm_find_source(const struct df_asm *as, const char *name);
void df_asm_sources_free(struct df_asm *as);
const char *df_asm_name(const struct df_asm *as, uint32_t file);

/* asm_run.c */
void df_asm_run_file(struct df_asm *as, uint32_t file);
void df_asm_run_lines(struct df_asm *as, uint32_t first, uint32_t end);

/* asm_symbols.c */
struct df_symbol *df_asm_symbol(struct df_asm *as, const char *name, uint32_t length);
struct df_symbol *df_asm_find(struct df_asm *as, const char *name, uint32_t length);
struct df_local *df_asm_local(struct df_asm *as, const char *name, uint32_t length);
bool df_asm_define(struct df_asm *as, const struct df_token *name, enum df_symbol_kind kind,
                   struct df_value value);
struct df_value df_asm_lookup(struct df_asm *as, const struct df_token *name);
/* The nearest name to a misspelt one, or NULL. `more` are further candidates. */
const char *df_asm_nearest(struct df_asm *as, const struct df_token *name, bool symbols,
                           const char *(*more)(const struct df_asm *as, uint32_t index));
bool df_asm_builtin(const char *name, uint32_t length, double *value);
void df_asm_symbols_free(struct df_asm *as);
bool df_asm_same(const char *a, uint32_t a_length, const char *b, uint32_t b_length);

/* asm_expr.c */
bool df_asm_native_value(struct df_asm *as, struct df_value *value);

/* asm_operands.c */
/* An expression, or a string standing alone. False: reported. */
bool df_asm_value(struct df_asm *as, struct df_argument *argument);
/* All of a comma-separated list to the end of the line, into as->arguments. */
bool df_asm_arguments(struct df_asm *as, const char *expected);
/* Rounded, lo … hi. False: reported or poison. *out is 0 while the value is unknown. */
bool df_asm_integer(struct df_asm *as, const struct df_argument *argument, int32_t lo, int32_t hi,
                    const char *what, int32_t *out);
/* The same for what decides the layout: known now, or an error. */
bool df_asm_layout_integer(struct df_asm *as, const struct df_argument *argument, int32_t lo,
                           int32_t hi, const char *what, int32_t *out);
bool df_asm_end_of_line(struct df_asm *as);
double df_asm_round(double value);

/* asm_dec.c */
bool df_asm_dec_value(struct df_asm *as, struct df_argument *argument);
bool df_asm_dec_symbol(const char *name, uint32_t length, double *value);
void df_asm_dec_statement(struct df_asm *as);
bool df_asm_dec_directive(struct df_asm *as);
/* A mnemonic or directive of the DEC dialect? */
bool df_asm_dec_knows(const struct df_token *name);
const char *df_asm_dec_name(const struct df_asm *as, uint32_t index);

/* asm_output.c */
void df_asm_emit(struct df_asm *as, uint16_t word);
void df_asm_emit_byte(struct df_asm *as, uint8_t byte);
void df_asm_even(struct df_asm *as);
void df_asm_set_address(struct df_asm *as, uint32_t address);
void df_asm_list_line(struct df_asm *as, uint32_t line);
char *df_asm_listing(struct df_asm *as);

/* asm_statements.c and asm_data.c */
typedef void (*df_asm_handler)(struct df_asm *as, unsigned what);
struct df_asm_statement {
    const char *name;
    df_asm_handler handler;
    unsigned what;
};
/* Runs the statement named by the current token; false when there is none of that name. */
bool df_asm_statement(struct df_asm *as);
const char *df_asm_statement_name(const struct df_asm *as, uint32_t index);
const char *df_asm_mode_name(unsigned mode);
void df_asm_data_pairs(struct df_asm *as, unsigned what);
void df_asm_data_absolute(struct df_asm *as, unsigned what);
void df_asm_data_values(struct df_asm *as, unsigned what);
void df_asm_data_text(struct df_asm *as, unsigned what);
bool df_asm_mode_of(const struct df_token *name, unsigned *mode);

/* asm_directives.c */
bool df_asm_directive(struct df_asm *as);
const char *df_asm_directive_name(const struct df_asm *as, uint32_t index);
void df_asm_directive_start(struct df_asm *as);

/* asm_blocks.c: they return the line index to go on at */
uint32_t df_asm_repeat(struct df_asm *as, uint32_t index, uint32_t limit);
uint32_t df_asm_if(struct df_asm *as, uint32_t index, uint32_t limit);
uint32_t df_asm_define_macro(struct df_asm *as, uint32_t index, uint32_t limit);
struct df_macro *df_asm_find_macro(struct df_asm *as, const struct df_token *name);
void df_asm_call_macro(struct df_asm *as, struct df_macro *macro);
void df_asm_include(struct df_asm *as);
void df_asm_macros_free(struct df_asm *as);

#endif
