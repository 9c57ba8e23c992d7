/* Runs source lines: labels, then whatever the line says. */
#include "display_file/asm_state.h"

#include <string.h>

static void define_label(struct df_asm *as, const struct df_token *name)
{
    struct df_value value = {.kind = DF_VALUE_NUMBER, .number = as->address};
    if (!df_asm_define(as, name, DF_SYMBOL_LABEL, value)) {
        return;
    }
    struct df_symbol *symbol = df_asm_find(as, name->text, name->length);
    /* Control may come here from elsewhere. What refers to a label is known from pass 1 on. */
    if (as->pass == 2 && symbol != NULL && symbol->referenced && as->position == DF_KNOWN) {
        as->position = DF_NOT_KNOWN;
    }
}

static void take_labels(struct df_asm *as)
{
    while (as->lex.token.kind == DF_TOKEN_NAME && as->lex.token.text[0] != '.') {
        struct df_lexer before = as->lex;
        struct df_token name = as->lex.token;
        df_lex_next(&as->lex);
        if (!df_token_is_op(&as->lex.token, ':')) {
            as->lex = before;
            return;
        }
        define_label(as, &name);
        df_lex_next(&as->lex);
        if (as->dec && df_token_is_op(&as->lex.token, ':')) {
            df_lex_next(&as->lex); /* NAME:: is global in MACRO-11 */
        }
    }
}

static const char *statement_or_macro(const struct df_asm *as, uint32_t index)
{
    if (index < as->macro_count) {
        return as->macros[index].name;
    }
    const char *name = df_asm_statement_name(as, index - as->macro_count);
    return name;
}

/* Reported once a name. What the statement would have changed is no longer trusted. */
static void unknown_statement(struct df_asm *as)
{
    struct df_token name = as->lex.token;
    bool directive = name.text[0] == '.';
    as->mode = DF_MODE_POISON;
    as->position = DF_POISON;
    char key[DF_ASM_LINE_BYTES + 2];
    key[0] = '!';
    memcpy(key + 1, name.text, name.length);
    struct df_symbol *symbol = df_asm_symbol(as, key, name.length + 1);
    if (symbol == NULL || symbol->reported || as->names_missing) {
        as->line_failed = true;
        as->failures++;
        return;
    }
    symbol->reported = true;
    int shown = name.length > 40 ? 40 : (int)name.length;
    const char *nearest =
        df_asm_nearest(as, &name, false, directive ? df_asm_directive_name : statement_or_macro);
    if (!as->dec && df_asm_dec_knows(&name)) {
        df_asm_error(as, name.column, "'%.*s' is of the DEC dialect; expected .dialect dec above",
                     shown, name.text);
    } else if (nearest != NULL) {
        df_asm_error(as, name.column, "unknown %s '%.*s'; did you mean '%s'?",
                     directive ? "directive" : "statement", shown, name.text, nearest);
    } else {
        df_asm_error(as, name.column, "unknown %s '%.*s'; expected %s",
                     directive ? "directive" : "statement", shown, name.text,
                     directive ? "one such as .org or .word"
                               : "a mode, a data statement, a directive or a macro");
    }
}

static void run_statement(struct df_asm *as)
{
    const struct df_token *token = &as->lex.token;
    as->statement_column = token->column;
    if (token->kind == DF_TOKEN_END) {
        return;
    }
    struct df_macro *macro = token->kind == DF_TOKEN_NAME ? df_asm_find_macro(as, token) : NULL;
    if (macro != NULL) {
        df_asm_call_macro(as, macro);
    } else if (token->kind == DF_TOKEN_NAME && token->text[0] == '.' && df_asm_directive(as)) {
        return;
    } else if (as->dec) {
        if (token->kind == DF_TOKEN_NAME && token->text[0] == '.' && token->length > 1) {
            if (!df_asm_dec_directive(as)) {
                unknown_statement(as);
            }
        } else {
            df_asm_dec_statement(as);
        }
    } else if (token->kind != DF_TOKEN_NAME) {
        df_asm_unexpected(as, "a label, a statement or a directive");
    } else if (!df_asm_statement(as)) {
        unknown_statement(as);
    }
}

/* A line that opens, divides or closes a block; returns the line to go on at. */
static uint32_t run_block(struct df_asm *as, uint32_t index, uint32_t end)
{
    const struct df_source_line *line = &as->sources[as->file].lines[index];
    switch (line->block) {
    case DF_BLOCK_REPEAT:
        return df_asm_repeat(as, index, end);
    case DF_BLOCK_MACRO:
        return df_asm_define_macro(as, index, end);
    case DF_BLOCK_IF:
        return df_asm_if(as, index, end);
    default:
        return index + 1; /* .else and ends that belong to nothing are reported already */
    }
}

static uint32_t run_line(struct df_asm *as, uint32_t index, uint32_t end)
{
    const struct df_source_line *line = &as->sources[as->file].lines[index];
    as->line = index + 1;
    as->line_failed = false;
    df_lex_start(&as->lex, line->text, line->length, as->dec);
    if (as->pass == 2) {
        df_asm_list_line(as, index + 1);
    }
    if (++as->steps > DF_ASM_STEPS) {
        df_asm_error(as, 1,
                     "the program does not come to an end; expected at most %u lines in all "
                     "repeats and macros together",
                     DF_ASM_STEPS);
        as->fatal = true;
        return end;
    }
    take_labels(as);
    if (line->block != DF_BLOCK_NONE) {
        return run_block(as, index, end);
    }
    run_statement(as);
    return as->ended ? end : index + 1;
}

void df_asm_run_lines(struct df_asm *as, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end && !as->fatal && !as->ended;) {
        i = run_line(as, i, end);
    }
}

void df_asm_run_file(struct df_asm *as, uint32_t file)
{
    struct df_frame frame = {.id = as->frame_ids++};
    struct df_frame *outer_frame = as->frame;
    uint32_t outer_file = as->file, outer_line = as->line;
    bool outer_dec = as->dec;
    as->frame = &frame;
    as->file = file;
    as->dec = false;
    as->sources[file].open = true;
    df_asm_run_lines(as, 0, as->sources[file].line_count);
    as->sources[file].open = false;
    as->ended = false;
    as->frame = outer_frame;
    as->file = outer_file;
    as->line = outer_line;
    as->dec = outer_dec;
}
