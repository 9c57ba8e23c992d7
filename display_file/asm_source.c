/* Source files of an assembly: read, cut into lines, their blocks matched. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "display_file/asm_state.h"

const char *df_asm_name(const struct df_asm *as, uint32_t file)
{
    return as->sources[file].name;
}

char *df_asm_read(const char *path, bool regular_only, size_t *length, char *reason, size_t size)
{
    struct stat info;
    if (stat(path, &info) != 0) {
        snprintf(reason, size, "%s", strerror(errno));
        return NULL;
    }
    if (S_ISDIR(info.st_mode) || (regular_only && !S_ISREG(info.st_mode))) {
        snprintf(reason, size, "%s",
                 S_ISDIR(info.st_mode) ? "it is a directory" : "it is a device");
        return NULL;
    }
    FILE *in = fopen(path, "rb");
    if (in == NULL) {
        snprintf(reason, size, "%s", strerror(errno));
        return NULL;
    }
    size_t capacity = 1u << 16, used = 0;
    char *text = malloc(capacity);
    while (text != NULL) {
        used += fread(text + used, 1, capacity - used, in);
        if (used < capacity || used > DF_ASM_FILE_BYTES) {
            break;
        }
        char *more = realloc(text, capacity * 2);
        if (more == NULL) {
            free(text);
        }
        text = more;
        capacity *= 2;
    }
    bool failed = ferror(in) != 0;
    int error = errno;
    fclose(in);
    if (text == NULL) {
        snprintf(reason, size, "out of memory");
        return NULL;
    }
    if (failed) {
        snprintf(reason, size, "%s", strerror(error));
        free(text);
        return NULL;
    }
    *length = used;
    return text;
}

uint32_t df_asm_find_source(const struct df_asm *as, const char *name)
{
    for (uint32_t i = 0; i < as->source_count; i++) {
        if (strcmp(as->sources[i].name, name) == 0) {
            return i;
        }
    }
    return UINT32_MAX;
}

/* ---- blocks ---- */

static const struct {
    const char *name;
    enum df_block block;
} keywords[] = {
    {".repeat", DF_BLOCK_REPEAT},  {".rept", DF_BLOCK_REPEAT},  {".macro", DF_BLOCK_MACRO},
    {".if", DF_BLOCK_IF},          {".else", DF_BLOCK_ELSE},    {".endr", DF_BLOCK_END_REPEAT},
    {".endm", DF_BLOCK_END_MACRO}, {".endif", DF_BLOCK_END_IF}, {".endc", DF_BLOCK_END_IF},
};

/* The block keyword a line starts with, after its labels. */
static enum df_block block_in(const struct df_source_line *line, bool dec)
{
    struct df_lexer lex;
    df_lex_start(&lex, line->text, line->length, dec);
    while (lex.token.kind == DF_TOKEN_NAME) {
        struct df_token name = lex.token;
        df_lex_next(&lex);
        if (df_token_is_op(&lex.token, ':')) {
            df_lex_next(&lex);
            continue;
        }
        for (unsigned i = 0; i < sizeof keywords / sizeof keywords[0]; i++) {
            if (df_token_is(&name, keywords[i].name)) {
                return keywords[i].block;
            }
        }
        break;
    }
    return DF_BLOCK_NONE;
}

/* Which dialect the line will be in is not known yet: their labels differ, their keywords do not.
 */
static enum df_block block_of(const struct df_source_line *line)
{
    if (line->length == 0 || memchr(line->text, '.', line->length) == NULL) {
        return DF_BLOCK_NONE;
    }
    enum df_block block = block_in(line, false);
    return block != DF_BLOCK_NONE ? block : block_in(line, true);
}

static enum df_block end_of(enum df_block block)
{
    return block == DF_BLOCK_REPEAT  ? DF_BLOCK_END_REPEAT
           : block == DF_BLOCK_MACRO ? DF_BLOCK_END_MACRO
                                     : DF_BLOCK_END_IF;
}

static const char *word_of(enum df_block block)
{
    switch (block) {
    case DF_BLOCK_REPEAT:
        return ".repeat";
    case DF_BLOCK_MACRO:
        return ".macro";
    case DF_BLOCK_IF:
        return ".if";
    case DF_BLOCK_ELSE:
        return ".else";
    case DF_BLOCK_END_REPEAT:
        return ".endr";
    case DF_BLOCK_END_MACRO:
        return ".endm";
    default:
        return ".endif";
    }
}

#define BLOCK_DEPTH 64

static uint32_t keyword_column(const struct df_source_line *line)
{
    const char *dot = memchr(line->text, '.', line->length);
    return dot == NULL ? 1 : (uint32_t)(dot - line->text) + 1;
}

struct matcher {
    struct df_asm *as;
    struct df_source *source;
    uint32_t file;
    uint32_t open[BLOCK_DEPTH];
    uint32_t depth;
    uint32_t forgiven[DF_BLOCK_END_IF + 1]; /* ends whose block was closed too early */
};

static void report_open(struct matcher *m)
{
    uint32_t line = m->open[--m->depth];
    enum df_block block = m->source->lines[line].block;
    df_asm_error_at(m->as, m->file, line + 1, keyword_column(&m->source->lines[line]),
                    "this %s is never closed; expected %s", word_of(block),
                    word_of(end_of(block == DF_BLOCK_ELSE ? DF_BLOCK_IF : block)));
    m->as->layout_broken = true;
}

static void open_block(struct matcher *m, uint32_t line)
{
    if (m->depth == BLOCK_DEPTH) {
        df_asm_error_at(m->as, m->file, line + 1, keyword_column(&m->source->lines[line]),
                        "blocks nested too deeply; expected at most %d levels", BLOCK_DEPTH);
        m->source->lines[line].block = DF_BLOCK_NONE;
        return;
    }
    m->open[m->depth++] = line;
}

/* Is there an open block that this line could belong to? */
static bool belongs(const struct matcher *m, enum df_block block)
{
    for (uint32_t i = m->depth; i-- > 0;) {
        enum df_block open = m->source->lines[m->open[i]].block;
        if (block == DF_BLOCK_ELSE ? open == DF_BLOCK_IF : end_of(open) == block) {
            return true;
        }
    }
    return false;
}

static void close_block(struct matcher *m, uint32_t line)
{
    struct df_source_line *lines = m->source->lines;
    enum df_block block = lines[line].block;
    if (!belongs(m, block) && m->forgiven[block] > 0) {
        m->forgiven[block]--;
        return;
    }
    if (!belongs(m, block)) {
        df_asm_error_at(m->as, m->file, line + 1, keyword_column(&m->source->lines[line]),
                        "%s without %s", word_of(block),
                        block == DF_BLOCK_END_REPEAT  ? ".repeat"
                        : block == DF_BLOCK_END_MACRO ? ".macro"
                                                      : ".if");
        return;
    }
    for (;;) {
        uint32_t opener = m->open[m->depth - 1];
        enum df_block open = lines[opener].block;
        if (block == DF_BLOCK_ELSE ? open == DF_BLOCK_IF : end_of(open) == block) {
            lines[opener].match = line;
            m->depth--;
            break;
        }
        /* What is still open inside can no longer be closed: it ends here, too. */
        lines[opener].match = line;
        m->forgiven[end_of(open)]++;
        report_open(m);
    }
    if (block == DF_BLOCK_ELSE) {
        open_block(m, line);
    }
}

/* A line that ends or divides a block is not executed: it must hold nothing else. */
static void check_end(struct df_asm *as, uint32_t file, uint32_t index)
{
    const struct df_source_line *line = &as->sources[file].lines[index];
    const char *word = word_of(line->block);
    struct df_lexer lex;
    df_lex_start(&lex, line->text, line->length, true);
    if (lex.token.kind != DF_TOKEN_NAME || lex.token.text[0] != '.') {
        df_asm_error_at(as, file, index + 1, lex.token.column,
                        "a label on a line with %s; expected it on a line of its own", word);
        return;
    }
    df_lex_next(&lex);
    if (line->block == DF_BLOCK_END_MACRO && lex.token.kind == DF_TOKEN_NAME) {
        df_lex_next(&lex); /* .ENDM NAME */
    }
    if (lex.token.kind != DF_TOKEN_END) {
        df_asm_error_at(as, file, index + 1, lex.token.column,
                        "more after %s; expected the end of the line", word);
    }
}

static void match_blocks(struct df_asm *as, uint32_t file)
{
    struct matcher m = {.as = as, .source = &as->sources[file], .file = file};
    for (uint32_t i = 0; i < m.source->line_count; i++) {
        struct df_source_line *line = &m.source->lines[i];
        line->block = block_of(line);
        line->match = m.source->line_count;
        switch (line->block) {
        case DF_BLOCK_NONE:
            break;
        case DF_BLOCK_REPEAT:
        case DF_BLOCK_MACRO:
        case DF_BLOCK_IF:
            open_block(&m, i);
            break;
        default:
            close_block(&m, i);
            check_end(as, file, i);
        }
    }
    while (m.depth > 0) {
        report_open(&m);
    }
}

/* ---- lines ---- */

static void check_line(struct df_asm *as, uint32_t file, uint32_t index)
{
    struct df_source_line *line = &as->sources[file].lines[index];
    if (line->length > DF_ASM_LINE_BYTES) {
        df_asm_error_at(as, file, index + 1, DF_ASM_LINE_BYTES + 1,
                        "the line has %u bytes; expected at most %d", (unsigned)line->length,
                        DF_ASM_LINE_BYTES);
        line->length = 0;
        as->layout_broken = true;
    }
}

static bool cut_lines(struct df_asm *as, uint32_t file, size_t length)
{
    struct df_source *source = &as->sources[file];
    const char *text = source->text, *end = text + length;
    uint32_t count = 1;
    for (const char *p = text; p < end; p++) {
        count += *p == '\n';
    }
    if (count > DF_ASM_FILE_LINES) {
        df_asm_error_at(as, file, 0, 0, "the file has more than %u lines; expected .df source",
                        DF_ASM_FILE_LINES);
        return true;
    }
    source->lines = calloc(count, sizeof *source->lines);
    if (source->lines == NULL) {
        df_asm_out_of_memory(as);
        return false;
    }
    if (length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        text += 3; /* byte order mark */
    }
    while (text < end) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        const char *next = stop == NULL ? end : stop + 1;
        stop = stop == NULL ? end : stop;
        if (stop > text && stop[-1] == '\r') {
            stop--;
        }
        source->lines[source->line_count++] = (struct df_source_line){
            .text = text, .length = (uint32_t)(stop - text), .shown = (uint32_t)(stop - text)};
        text = next;
    }
    return true;
}

static void check_text(struct df_asm *as, uint32_t file, size_t *length)
{
    const struct df_source *source = &as->sources[file];
    if (*length > DF_ASM_FILE_BYTES) {
        df_asm_error_at(as, file, 0, 0, "the file is larger than %u MiB; expected .df source",
                        DF_ASM_FILE_BYTES >> 20);
        *length = 0;
        return;
    }
    const char *nul = *length == 0 ? NULL : memchr(source->text, 0, *length);
    if (nul != NULL) {
        df_asm_error_at(as, file, 0, 0, "byte %zu is NUL: this is not text; expected .df source",
                        (size_t)(nul - source->text));
        *length = 0;
    }
}

uint32_t df_asm_add_source(struct df_asm *as, const char *name, char *text, size_t length)
{
    char *copy = malloc(strlen(name) + 1);
    if (copy == NULL || as->source_count == DF_ASM_FILES) {
        free(copy);
        free(text);
        if (as->source_count == DF_ASM_FILES) {
            df_asm_error(as, 1, "too many files; expected at most %u", DF_ASM_FILES);
        } else {
            df_asm_out_of_memory(as);
        }
        return UINT32_MAX;
    }
    strcpy(copy, name);
    uint32_t file = as->source_count++;
    as->sources[file] = (struct df_source){.name = copy, .text = text};
    check_text(as, file, &length);
    if (!cut_lines(as, file, length)) {
        return UINT32_MAX;
    }
    for (uint32_t i = 0; i < as->sources[file].line_count; i++) {
        check_line(as, file, i);
    }
    match_blocks(as, file);
    return file;
}

void df_asm_sources_free(struct df_asm *as)
{
    for (uint32_t i = 0; i < as->source_count; i++) {
        free(as->sources[i].name);
        free(as->sources[i].text);
        free(as->sources[i].lines);
    }
    free(as->sources);
}
