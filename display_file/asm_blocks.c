/* Repeats, conditions, macros, includes. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"

/* The block keyword is the current token; takes it. */
static void take_keyword(struct df_asm *as)
{
    df_lex_next(&as->lex);
}

/* Lines [first, end) are not executed, but the listing shows them. */
static void list_skipped(struct df_asm *as, uint32_t first, uint32_t end)
{
    for (uint32_t i = first; i < end && as->pass == 2; i++) {
        df_asm_list_line(as, i + 1);
    }
}

static uint32_t after(uint32_t match, uint32_t limit)
{
    return match + 1 < limit ? match + 1 : limit;
}

static uint32_t body_end(const struct df_asm *as, uint32_t index, uint32_t limit)
{
    uint32_t match = as->sources[as->file].lines[index].match;
    return match < limit ? match : limit;
}

/* ---- .repeat ---- */

static bool repeat_operands(struct df_asm *as, int32_t *rounds, struct df_local *variable)
{
    struct df_argument argument;
    *variable = (struct df_local){0};
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, "how often to repeat");
        return false;
    }
    if (!df_asm_value(as, &argument)) {
        return false;
    }
    if (df_token_is_op(&as->lex.token, ',')) {
        df_lex_next(&as->lex);
        if (as->lex.token.kind != DF_TOKEN_NAME || as->lex.token.text[0] == '.') {
            df_asm_unexpected(as, "the name of the counting variable");
            return false;
        }
        variable->name = as->lex.token.text;
        variable->length = as->lex.token.length;
        df_lex_next(&as->lex);
    }
    return df_asm_end_of_line(as) &&
           df_asm_layout_integer(as, &argument, 0, 1000000000, "the number of rounds", rounds);
}

static void run_rounds(struct df_asm *as, uint32_t first, uint32_t end, int32_t rounds,
                       const struct df_local *variable)
{
    for (int32_t i = 0; i < rounds && !as->fatal && !as->ended; i++) {
        struct df_frame frame = {.outer = as->frame, .id = as->frame_ids++};
        if (variable->name != NULL) {
            frame.count = 1;
            frame.locals[0] = *variable;
            frame.locals[0].value = (struct df_value){.kind = DF_VALUE_NUMBER, .number = i};
        }
        uint64_t failures = as->failures;
        as->frame = &frame;
        df_asm_run_lines(as, first, end);
        as->frame = frame.outer;
        if (as->failures != failures) {
            as->layout_broken = true; /* one faulty round says it all */
            return;
        }
        if (first == end) {
            return;
        }
    }
}

uint32_t df_asm_repeat(struct df_asm *as, uint32_t index, uint32_t limit)
{
    uint32_t end = body_end(as, index, limit), first = index + 1 < end ? index + 1 : end;
    uint32_t column = as->lex.token.column;
    int32_t rounds = 0;
    struct df_local variable;
    take_keyword(as);
    if (as->repeat_depth == DF_ASM_REPEAT_DEPTH) {
        df_asm_error(as, column, "repeats nested too deeply; expected at most %d levels",
                     DF_ASM_REPEAT_DEPTH);
        as->layout_broken = true;
        rounds = 0;
    } else if (!repeat_operands(as, &rounds, &variable)) {
        as->layout_broken = true;
        rounds = 1; /* so that errors inside are found in the same go */
    }
    if (rounds == 0) {
        list_skipped(as, first, end);
    } else {
        as->repeat_depth++;
        run_rounds(as, first, end, rounds, &variable);
        as->repeat_depth--;
    }
    if (end < limit && !as->fatal) {
        list_skipped(as, end, end + 1);
    }
    return after(end, limit);
}

/* ---- .if ---- */

uint32_t df_asm_if(struct df_asm *as, uint32_t index, uint32_t limit)
{
    const struct df_source_line *lines = as->sources[as->file].lines;
    uint32_t middle = body_end(as, index, limit), first = index + 1;
    uint32_t end = middle;
    if (middle < limit && lines[middle].block == DF_BLOCK_ELSE) {
        end = body_end(as, middle, limit);
    }
    take_keyword(as);
    struct df_argument argument;
    bool yes = false;
    if (as->lex.token.kind == DF_TOKEN_END) {
        df_asm_unexpected(as, "a condition");
        as->layout_broken = true;
    } else if (df_asm_value(as, &argument) && df_asm_end_of_line(as)) {
        int32_t ignored;
        double number = argument.value.number;
        argument.value.number = number != 0;
        yes = df_asm_layout_integer(as, &argument, 0, 1, "the condition", &ignored) && number != 0;
    }
    if (yes) {
        df_asm_run_lines(as, first < middle ? first : middle, middle);
    } else {
        list_skipped(as, first, middle);
    }
    if (middle < end) {
        list_skipped(as, middle, middle + 1);
        if (yes) {
            list_skipped(as, middle + 1, end);
        } else {
            df_asm_run_lines(as, middle + 1, end);
        }
    }
    if (end < limit && !as->fatal) {
        list_skipped(as, end, end + 1);
    }
    return after(end, limit);
}

/* ---- .macro ---- */

struct df_macro *df_asm_find_macro(struct df_asm *as, const struct df_token *name)
{
    for (uint32_t i = as->macro_count; i-- > 0;) {
        struct df_macro *macro = &as->macros[i];
        if (df_asm_same(macro->name, (uint32_t)strlen(macro->name), name->text, name->length)) {
            return macro;
        }
    }
    return NULL;
}

static bool macro_parameters(struct df_asm *as, struct df_macro *macro)
{
    while (as->lex.token.kind != DF_TOKEN_END) {
        const struct df_token *token = &as->lex.token;
        if (token->kind != DF_TOKEN_NAME || token->text[0] == '.' || token->text[0] == '@') {
            df_asm_unexpected(as, "a parameter's name");
            return false;
        }
        for (uint32_t i = 0; i < macro->parameter_count; i++) {
            if (df_asm_same(macro->parameters[i].name, macro->parameters[i].length, token->text,
                            token->length)) {
                df_asm_error(as, token->column,
                             "parameter '%.*s' appears twice; expected another name",
                             (int)token->length, token->text);
                return false;
            }
        }
        if (macro->parameter_count == DF_ASM_PARAMETERS) {
            df_asm_error(as, token->column, "too many parameters; expected at most %d",
                         DF_ASM_PARAMETERS);
            return false;
        }
        macro->parameters[macro->parameter_count++] =
            (struct df_local){.name = token->text, .length = token->length};
        df_lex_next(&as->lex);
        if (df_token_is_op(&as->lex.token, ',')) {
            df_lex_next(&as->lex);
            if (as->lex.token.kind == DF_TOKEN_END) {
                df_asm_unexpected(as, "a parameter's name");
                return false;
            }
        } else if (as->lex.token.kind != DF_TOKEN_END) {
            df_asm_unexpected(as, "',' or the end of the line");
            return false;
        }
    }
    return true;
}

static bool statement_exists(const struct df_asm *as, const struct df_token *name)
{
    for (uint32_t i = 0; df_asm_statement_name(as, i) != NULL; i++) {
        if (df_token_is(name, df_asm_statement_name(as, i))) {
            return true;
        }
    }
    return false;
}

static void keep_macro(struct df_asm *as, const struct df_macro *macro, const struct df_token *name)
{
    struct df_macro *more = realloc(as->macros, (as->macro_count + 1) * sizeof *more);
    char *copy = malloc(name->length + 1u);
    if (more != NULL) {
        as->macros = more;
    }
    if (more == NULL || copy == NULL) {
        free(copy);
        df_asm_out_of_memory(as);
        return;
    }
    for (uint32_t i = 0; i < name->length; i++) {
        char c = name->text[i];
        copy[i] = c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
    }
    copy[name->length] = 0;
    as->macros[as->macro_count] = *macro;
    as->macros[as->macro_count].name = copy;
    as->macro_count++;
}

static void define_macro(struct df_asm *as, uint32_t first, uint32_t end)
{
    struct df_token name = as->lex.token;
    if (name.kind != DF_TOKEN_NAME || name.text[0] == '.' || name.text[0] == '@') {
        df_asm_unexpected(as, "the macro's name");
        return;
    }
    if (!as->dec && statement_exists(as, &name)) {
        df_asm_error(as, name.column, "'%.*s' is a statement already; expected another name",
                     (int)name.length, name.text);
        return;
    }
    const struct df_macro *old = df_asm_find_macro(as, &name);
    if (old != NULL) {
        df_asm_error(as, name.column,
                     "macro '%.*s' is already defined at %s:%u; expected a new name",
                     (int)name.length, name.text, df_asm_name(as, old->file), (unsigned)old->first);
        return;
    }
    struct df_macro macro = {.file = as->file, .first = first, .end = end, .dec = as->dec};
    df_lex_next(&as->lex);
    if (df_token_is_op(&as->lex.token, ',')) {
        df_lex_next(&as->lex);
    }
    macro_parameters(as, &macro);
    keep_macro(as, &macro, &name);
}

uint32_t df_asm_define_macro(struct df_asm *as, uint32_t index, uint32_t limit)
{
    uint32_t end = body_end(as, index, limit), first = index + 1 < end ? index + 1 : end;
    take_keyword(as);
    define_macro(as, first, end);
    list_skipped(as, first, end < limit ? end + 1 : end);
    return after(end, limit);
}

/* Fills the frame with the call's arguments. */
static bool macro_arguments(struct df_asm *as, const struct df_macro *macro, struct df_frame *frame)
{
    as->argument_count = 0;
    if (as->lex.token.kind != DF_TOKEN_END && !df_asm_arguments(as, "arguments")) {
        return false;
    }
    if (as->argument_count != macro->parameter_count) {
        df_asm_error(as, as->lex.token.column, "macro '%s' called with %u argument%s; expected %u",
                     macro->name, (unsigned)as->argument_count, as->argument_count == 1 ? "" : "s",
                     (unsigned)macro->parameter_count);
        return false;
    }
    frame->count = macro->parameter_count;
    for (uint32_t i = 0; i < frame->count; i++) {
        frame->locals[i] = macro->parameters[i];
        frame->locals[i].value = as->arguments[i].value;
    }
    return true;
}

/* Of the calls that led here, the innermost few. */
static size_t calls_shown(const struct df_asm *as)
{
    const char *end = as->calls.bytes;
    for (int i = 0; i < 4 && *end != 0; i++) {
        end = strchr(end, '\n') + 1;
    }
    return (size_t)(end - as->calls.bytes);
}

/* Runs lines of another place: what an error says about how it got there. */
static void run_called(struct df_asm *as, const struct df_macro *macro, struct df_frame *frame)
{
    uint32_t file = as->file, line = as->line;
    bool dec = as->dec, failed = as->line_failed;
    struct df_frame *outer = as->frame;
    uint64_t chain = as->chain;
    /* The innermost call stands first. */
    struct df_text text = {0};
    df_text_add(&text, "    in macro %s called at %s:%u\n", macro->name, df_asm_name(as, file),
                (unsigned)line);
    if (as->calls.length > 0) {
        df_text_bytes(&text, as->calls.bytes, calls_shown(as));
    }
    struct df_text outer_calls = as->calls;
    as->calls = text;
    as->chain = (chain ^ ((uint64_t)file << 32 | line)) * UINT64_C(1099511628211) + 1;
    as->frame = frame;
    as->file = macro->file;
    as->dec = macro->dec;
    uint32_t first = macro->first, end = macro->end;
    df_asm_run_lines(as, first, end);
    df_text_free(&as->calls);
    as->calls = outer_calls;
    as->chain = chain;
    as->frame = outer;
    as->file = file;
    as->line = line;
    as->dec = dec;
    as->line_failed = failed;
}

void df_asm_call_macro(struct df_asm *as, struct df_macro *macro)
{
    struct df_macro called = *macro; /* the table may move while the body runs */
    struct df_frame frame = {.id = as->frame_ids++};
    uint32_t column = as->lex.token.column;
    df_lex_next(&as->lex);
    if (!macro_arguments(as, &called, &frame)) {
        as->layout_broken = true;
        as->mode = DF_MODE_POISON;
        as->position = DF_POISON;
        return;
    }
    if (as->macro_depth == DF_ASM_MACRO_DEPTH) {
        df_asm_error(as, column, "macros call each other too deeply; expected at most %d levels",
                     DF_ASM_MACRO_DEPTH);
        as->layout_broken = true;
        return;
    }
    as->macro_depth++;
    run_called(as, &called, &frame);
    as->macro_depth--;
}

void df_asm_macros_free(struct df_asm *as)
{
    for (uint32_t i = 0; i < as->macro_count; i++) {
        free(as->macros[i].name);
    }
    free(as->macros);
    as->macros = NULL;
    as->macro_count = 0;
}

/* ---- .include ---- */

/* The path beside the file that says it; malloced. */
static char *beside(const char *includer, const char *path, uint32_t length)
{
    const char *slash = strrchr(includer, '/');
    size_t folder = slash == NULL || path[0] == '/' ? 0 : (size_t)(slash - includer) + 1;
    char *joined = malloc(folder + length + 1);
    if (joined == NULL) {
        return NULL;
    }
    memcpy(joined, includer, folder);
    size_t used = folder;
    const char *end = path + length;
    unsigned code;
    while (df_string_next(&path, end, &code)) {
        joined[used++] = (char)code;
    }
    joined[used] = 0;
    return joined;
}

static uint32_t open_source(struct df_asm *as, const char *path, uint32_t column)
{
    uint32_t file = df_asm_find_source(as, path);
    if (file != UINT32_MAX) {
        return file;
    }
    char reason[128];
    size_t length = 0;
    char *text = df_asm_read(path, true, &length, reason, sizeof reason);
    if (text == NULL) {
        df_asm_error(as, column, "cannot read '%s' (%s); expected a file beside this one", path,
                     reason);
        return UINT32_MAX;
    }
    return df_asm_add_source(as, path, text, length);
}

static void include_file(struct df_asm *as, uint32_t file, uint32_t column)
{
    if (as->sources[file].open) {
        df_asm_error(as, column, "'%s' includes itself; expected no cycle", df_asm_name(as, file));
    } else if (as->include_depth == DF_ASM_INCLUDE_DEPTH) {
        df_asm_error(as, column, "includes nested too deeply; expected at most %d levels",
                     DF_ASM_INCLUDE_DEPTH);
    } else {
        bool failed = as->line_failed;
        as->include_depth++;
        df_asm_run_file(as, file);
        as->include_depth--;
        as->line_failed = failed;
    }
}

void df_asm_include(struct df_asm *as)
{
    df_lex_string_again(&as->lex);
    struct df_token name = as->lex.token;
    if (name.kind != DF_TOKEN_STRING) {
        df_asm_unexpected(as, "a file name in quotes");
        return;
    }
    df_lex_next(&as->lex);
    if (!df_asm_end_of_line(as)) {
        return;
    }
    char *path = beside(df_asm_name(as, as->file), name.text + 1, name.length - 2);
    if (path == NULL) {
        df_asm_out_of_memory(as);
        return;
    }
    uint32_t file = open_source(as, path, name.column);
    free(path);
    if (file != UINT32_MAX) {
        include_file(as, file, name.column);
    } else {
        as->layout_broken = true;
        as->names_missing = true;
    }
}
