/* The assembler's errors: kept once each, sorted by place, shown with their line and a caret. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"

#define SHOWN 96 /* bytes of a long source line shown */

void df_asm_out_of_memory(struct df_asm *as)
{
    as->fatal = true;
    as->failures++;
    as->errors_dropped++;
}

/* One error a line and way to it; and what is wrong whatever the arguments, once for all calls. */
static bool already_reported(const struct df_asm *as, uint32_t file, uint32_t line, uint32_t column,
                             const char *message)
{
    for (uint32_t i = 0; i < as->error_count; i++) {
        const struct df_error *e = &as->errors[i];
        if (e->file != file || e->line != line) {
            continue;
        }
        if (e->chain == as->chain || (e->column == column && strcmp(e->message, message) == 0)) {
            return true;
        }
    }
    return false;
}

static char *copy(const char *text, size_t length)
{
    char *bytes = malloc(length + 1);
    if (bytes != NULL) {
        memcpy(bytes, text, length);
        bytes[length] = 0;
    }
    return bytes;
}

static void keep(struct df_asm *as, uint32_t file, uint32_t line, uint32_t column,
                 const char *message)
{
    as->failures++;
    if (already_reported(as, file, line, column, message)) {
        return;
    }
    if (as->error_count == DF_ASM_ERRORS) {
        as->errors_dropped++;
        as->fatal = true;
        return;
    }
    if (as->errors == NULL) {
        as->errors = calloc(DF_ASM_ERRORS, sizeof *as->errors);
    }
    char *text = copy(message, strlen(message));
    if (as->errors == NULL || text == NULL) {
        free(text);
        df_asm_out_of_memory(as);
        return;
    }
    for (char *c = text; *c != 0; c++) {
        if ((unsigned char)*c < 32 || *c == 127) {
            *c = '?'; /* a file name may hold anything */
        }
    }
    char *note = as->calls.length > 0 ? copy(as->calls.bytes, as->calls.length) : NULL;
    as->errors[as->error_count] =
        (struct df_error){file, line, column, as->error_count, as->chain, text, note};
    as->error_count++;
}

void df_asm_error_at(struct df_asm *as, uint32_t file, uint32_t line, uint32_t column,
                     const char *format, ...)
{
    char message[512];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    keep(as, file, line, column, message);
}

void df_asm_error(struct df_asm *as, uint32_t column, const char *format, ...)
{
    if (as->line_failed) {
        return;
    }
    as->line_failed = true;
    char message[512];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    keep(as, as->file, as->line, column, message);
}

void df_asm_unexpected(struct df_asm *as, const char *expected)
{
    const struct df_token *token = &as->lex.token;
    if (token->kind == DF_TOKEN_BAD) {
        df_asm_error(as, token->column, "%s", as->lex.message);
    } else if (token->kind == DF_TOKEN_END) {
        df_asm_error(as, token->column, "the statement ends too early; expected %s", expected);
    } else {
        int length = token->length > 40 ? 40 : (int)token->length;
        df_asm_error(as, token->column, "unexpected '%.*s'; expected %s", length, token->text,
                     expected);
    }
}

static int by_place(const void *a, const void *b)
{
    const struct df_error *p = a, *q = b;
    if (p->file != q->file) {
        return p->file < q->file ? -1 : 1;
    }
    if (p->line != q->line) {
        return p->line < q->line ? -1 : 1;
    }
    if (p->column != q->column) {
        return p->column < q->column ? -1 : 1;
    }
    return p->order < q->order ? -1 : p->order > q->order;
}

/* The source line, or the part of it around the column, and a caret below. */
static void show_line(const struct df_source_line *line, uint32_t column, struct df_text *text)
{
    uint32_t at = column - 1 < line->shown ? column - 1 : line->shown;
    uint32_t from = at > SHOWN - 16 ? at - (SHOWN - 16) : 0;
    uint32_t to = line->shown - from > SHOWN ? from + SHOWN : line->shown;
    df_text_add(text, "    %s", from > 0 ? "..." : "");
    for (uint32_t i = from; i < to; i++) {
        char c = line->text[i];
        bool plain = c == '\t' || ((unsigned char)c >= 32 && c != 127);
        df_text_bytes(text, plain ? &c : "?", 1);
    }
    df_text_add(text, "%s\n    %s", to < line->shown ? "..." : "", from > 0 ? "   " : "");
    for (uint32_t i = from; i < at; i++) {
        /* Bytes 200–277 (octal) continue a UTF-8 character and take no column of their own. */
        if (((unsigned char)line->text[i] & 0xc0) != 0x80) {
            df_text_bytes(text, line->text[i] == '\t' ? "\t" : " ", 1);
        }
    }
    df_text_add(text, "^\n");
}

static void show(const struct df_asm *as, const struct df_error *e, struct df_text *text)
{
    const struct df_source *source = &as->sources[e->file];
    if (e->line == 0 || e->line > source->line_count) {
        df_text_add(text, "%s: %s\n", source->name, e->message);
        return;
    }
    df_text_add(text, "%s:%u:%u: %s\n", source->name, (unsigned)e->line, (unsigned)e->column,
                e->message);
    show_line(&source->lines[e->line - 1], e->column, text);
    if (e->note != NULL) {
        df_text_add(text, "%s", e->note);
    }
}

char *df_asm_errors_text(struct df_asm *as)
{
    struct df_text text = {0};
    if (as->error_count > 1) {
        qsort(as->errors, as->error_count, sizeof *as->errors, by_place);
    }
    for (uint32_t i = 0; i < as->error_count; i++) {
        show(as, &as->errors[i], &text);
    }
    if (as->error_count >= DF_ASM_ERRORS && as->errors_dropped > 0) {
        df_text_add(&text, "More than %u errors: the rest is not shown.\n", DF_ASM_ERRORS);
    } else if (as->errors_dropped > 0) {
        df_text_add(&text, "Out of memory while assembling; close other programs.\n");
    }
    return df_text_take(&text);
}

void df_asm_errors_free(struct df_asm *as)
{
    for (uint32_t i = 0; i < as->error_count; i++) {
        free(as->errors[i].message);
        free(as->errors[i].note);
    }
    free(as->errors);
    df_text_free(&as->calls);
}
