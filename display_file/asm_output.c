/* Words out of the assembler, and the listing of what became which word. */
#include <stdlib.h>
#include <string.h>

#include "display_file/asm_state.h"

/* ---- listing rows ---- */

void df_asm_list_line(struct df_asm *as, uint32_t line)
{
    if (!as->listing) {
        return;
    }
    if (as->row_count == as->row_capacity) {
        uint32_t capacity = as->row_capacity == 0 ? 1024 : as->row_capacity * 2;
        struct df_listing_row *rows = realloc(as->rows, capacity * sizeof *rows);
        if (rows == NULL) {
            df_asm_out_of_memory(as);
            return;
        }
        as->rows = rows;
        as->row_capacity = capacity;
    }
    as->rows[as->row_count++] = (struct df_listing_row){
        .file = as->file, .line = line, .address = as->address, .words = as->list_word_count};
}

static void list_word(struct df_asm *as, uint32_t address, uint16_t word)
{
    if (!as->listing || as->row_count == 0) {
        return;
    }
    if (as->list_word_count == as->list_word_capacity) {
        uint32_t capacity = as->list_word_capacity == 0 ? 4096 : as->list_word_capacity * 2;
        uint16_t *words = realloc(as->list_words, capacity * sizeof *words);
        if (words == NULL) {
            df_asm_out_of_memory(as);
            return;
        }
        as->list_words = words;
        as->list_word_capacity = capacity;
    }
    struct df_listing_row *row = &as->rows[as->row_count - 1];
    if (row->count == 0) {
        row->address = address;
    }
    as->list_words[as->list_word_count++] = word;
    row->count++;
}

/* ---- words ---- */

/* Two programs in one place: the later one is at fault. */
static void put(struct df_asm *as, uint32_t address, uint16_t word)
{
    struct df_program *program = as->program;
    if (program->loaded[address / 2]) {
        uint32_t where = program->line[address / 2];
        if (!as->layout_broken) {
            df_asm_error(as, as->statement_column,
                         "the word at 0o%06o is already taken by %s:%u; expected free memory",
                         (unsigned)address, df_asm_name(as, where >> 24),
                         (unsigned)(where & 0xffffff));
        }
        return;
    }
    df_program_put(program, address, word);
    program->line[address / 2] = as->file << 24 | as->line;
    list_word(as, address, word);
}

void df_asm_emit(struct df_asm *as, uint16_t word)
{
    if (as->fatal || as->address_lost) {
        return;
    }
    if (as->address % 2 != 0) {
        df_asm_error(as, as->statement_column,
                     "a word at the odd address 0o%o; expected .even above", (unsigned)as->address);
        df_asm_even(as);
    }
    if (as->address >= DF_MEMORY_BYTES) {
        df_asm_error(as, as->statement_column, "no memory at 0o%o; expected addresses below 0o%o",
                     (unsigned)as->address, DF_MEMORY_BYTES);
        as->address_lost = true;
        as->layout_broken = true;
        return;
    }
    if (++as->emitted > DF_ASM_WORDS) {
        df_asm_error(as, as->statement_column, "too many words; expected at most %u", DF_ASM_WORDS);
        as->fatal = true;
        return;
    }
    if (as->pass == 2) {
        put(as, as->address, word);
    }
    as->address += 2;
}

void df_asm_emit_byte(struct df_asm *as, uint8_t byte)
{
    if (as->address % 2 == 0) {
        as->low_byte = byte;
        as->address += as->address < DF_MEMORY_BYTES;
        if (as->address % 2 == 0) {
            df_asm_emit(as, byte); /* reports that memory has ended */
        }
        return;
    }
    as->address--;
    df_asm_emit(as, (uint16_t)(as->low_byte | byte << 8));
}

void df_asm_even(struct df_asm *as)
{
    if (as->address % 2 != 0) {
        df_asm_emit_byte(as, 0);
    }
}

void df_asm_set_address(struct df_asm *as, uint32_t address)
{
    df_asm_even(as);
    as->address = address;
    as->address_lost = false;
}

/* ---- the listing ---- */

#define SOURCE_COLUMN 42
#define WORDS_A_ROW   3

/* Marks the rows whose line an earlier round or call has shown already. */
static bool mark_seen(struct df_asm *as)
{
    uint32_t lines = 0;
    uint32_t *first = calloc(as->source_count + 1, sizeof *first);
    for (uint32_t i = 0; first != NULL && i < as->source_count; i++) {
        first[i] = lines;
        lines += as->sources[i].line_count + 1;
    }
    uint8_t *seen = calloc(lines + 1, 1);
    bool ok = first != NULL && seen != NULL;
    for (uint32_t i = 0; ok && i < as->row_count; i++) {
        struct df_listing_row *row = &as->rows[i];
        row->seen = seen[first[row->file] + row->line];
        seen[first[row->file] + row->line] = 1;
    }
    free(first);
    free(seen);
    return ok;
}

static void list_words(const struct df_asm *as, const struct df_listing_row *row, uint32_t from,
                       struct df_text *text)
{
    df_text_add(text, "%06o ", (unsigned)(row->address + 2 * from));
    for (uint32_t i = from; i < row->count && i < from + WORDS_A_ROW; i++) {
        df_text_add(text, " %06o", (unsigned)as->list_words[row->words + i]);
    }
}

static void list_row(const struct df_asm *as, const struct df_listing_row *row,
                     struct df_text *text)
{
    const struct df_source_line *line = &as->sources[row->file].lines[row->line - 1];
    if (row->count > 0) {
        list_words(as, row, 0, text);
        df_text_column(text, 29);
    } else {
        df_text_add(text, "%29s", "");
    }
    df_text_add(text, "%6u%c", (unsigned)row->line, row->seen ? '+' : ' ');
    if (line->length > 0) {
        df_text_column(text, SOURCE_COLUMN - 4);
        df_text_bytes(text, line->text, line->length);
    }
    df_text_add(text, "\n");
    for (uint32_t from = WORDS_A_ROW; from < row->count; from += WORDS_A_ROW) {
        list_words(as, row, from, text);
        df_text_add(text, "\n");
    }
}

char *df_asm_listing(struct df_asm *as)
{
    struct df_text text = {0};
    uint32_t file = UINT32_MAX;
    if (!mark_seen(as)) {
        return NULL;
    }
    for (uint32_t i = 0; i < as->row_count; i++) {
        const struct df_listing_row *row = &as->rows[i];
        if (row->seen && row->count == 0) {
            continue;
        }
        if (row->file != file) {
            file = row->file;
            df_text_add(&text, "; %s\n", df_asm_name(as, file));
        }
        list_row(as, row, &text);
    }
    const struct df_program *p = as->program;
    uint32_t words = 0;
    for (uint32_t a = p->low; a < p->high; a += 2) {
        words += p->loaded[a / 2];
    }
    df_text_add(&text, "; %u words from %06o to %06o, start %06o\n", (unsigned)words,
                (unsigned)p->low, (unsigned)(p->high > 0 ? p->high - 2 : 0), (unsigned)p->entry);
    return df_text_take(&text);
}
