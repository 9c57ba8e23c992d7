#include "display_file/disasm.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/decode.h"
#include "display_file/df_regs.h"
#include "display_file/glyphs.h"
#include "display_file/text_buffer.h"

#define COMMENT_COLUMN 56
#define TEXT_WORDS     20 /* of one text statement */
#define LIST_WORDS     8  /* of one .word or value statement */

#define SHIFT_OUT 016
#define SHIFT_IN  017

enum { PLAIN = 0, TARGET = 1, BOUNDARY = 2 };

struct disassembly {
    const struct df_program *program;
    struct df_text text;
    uint8_t *marks; /* a word: jumped to, start of a statement */
    unsigned mode;  /* as the assembler will track it */
    bool shifted;   /* special characters follow, as far as the text above tells */
};

#define NO_MODE 16u

static bool loaded(const struct df_program *p, uint32_t address)
{
    return address < DF_MEMORY_BYTES && p->loaded[address / 2];
}

/* How many loaded words lie together from here, at most `most`, with no jump target among the
 * later. */
static uint32_t run_of(const struct disassembly *d, uint32_t address, uint32_t most)
{
    uint32_t count = 1;
    while (count < most && loaded(d->program, address + 2 * count) &&
           !(d->marks[address / 2 + count] & TARGET)) {
        count++;
    }
    return count;
}

/* The first pass marks, the second writes; both walk alike through this. */
static uint32_t statement(struct disassembly *d, uint32_t address, char *line, size_t size,
                          struct df_decoded *decoded)
{
    const uint16_t *words = d->program->words + address / 2;
    uint32_t most = d->mode == DF_MODE_CHAR ? TEXT_WORDS : LIST_WORDS;
    *decoded = df_decode(words, run_of(d, address, most), d->mode, line, size);
    if (decoded->sets_mode) {
        d->mode = decoded->mode;
    }
    return decoded->words;
}

/* ---- first pass: where statements start and where jumps go ---- */

static void mark_targets(struct disassembly *d)
{
    const struct df_program *p = d->program;
    for (uint32_t a = p->low; a < p->high; a += 2) {
        if (p->loaded[a / 2] && p->words[a / 2] == DF_JUMP && loaded(p, a + 2)) {
            uint16_t to = p->words[a / 2 + 1];
            d->marks[to / 2] |= to % 2 == 0 && p->loaded[to / 2] ? TARGET : PLAIN;
        }
    }
    if (loaded(p, p->entry)) {
        d->marks[p->entry / 2] |= TARGET;
    }
}

static void mark_boundaries(struct disassembly *d)
{
    const struct df_program *p = d->program;
    char line[512];
    d->mode = NO_MODE;
    for (uint32_t a = p->low; a < p->high;) {
        if (!p->loaded[a / 2]) {
            a += 2;
            continue;
        }
        struct df_decoded decoded;
        d->marks[a / 2] |= BOUNDARY;
        a += 2 * statement(d, a, line, sizeof line, &decoded);
    }
}

/* ---- second pass ---- */

static bool labelled(const struct disassembly *d, uint32_t address)
{
    uint8_t both = TARGET | BOUNDARY;
    return loaded(d->program, address) && (d->marks[address / 2] & both) == both;
}

static void add_place(struct disassembly *d, uint32_t address)
{
    df_text_add(&d->text, labelled(d, address) ? "L%06o" : "0o%06o", (unsigned)address);
}

/* The name of a code that draws a special character: no string shows which it is. */
static void add_special(struct disassembly *d, unsigned code)
{
    if (!d->shifted) {
        d->shifted = code == SHIFT_OUT;
        return;
    }
    const char *name = df_glyph_special_name(code);
    if (name != NULL) {
        df_text_add(&d->text, " %s", name);
    }
    d->shifted = code != SHIFT_IN;
}

static void add_comment(struct disassembly *d, uint32_t address, const struct df_decoded *decoded)
{
    df_text_column(&d->text, COMMENT_COLUMN);
    df_text_add(&d->text, "; %06o", (unsigned)address);
    if (decoded->sets_mode || decoded->jump) {
        d->shifted = false;
    } else if (d->mode == DF_MODE_CHAR && !(d->program->words[address / 2] & DF_CONTROL)) {
        for (uint32_t i = 0; i < decoded->words; i++) {
            uint16_t word = d->program->words[address / 2 + i];
            add_special(d, word & 0177);
            add_special(d, word >> 8 & 0177);
        }
    }
    df_text_add(&d->text, "\n");
}

static uint32_t write_statement(struct disassembly *d, uint32_t address)
{
    char line[512];
    struct df_decoded decoded;
    if (labelled(d, address)) {
        df_text_add(&d->text, "L%06o:", (unsigned)address);
    }
    uint32_t words = statement(d, address, line, sizeof line, &decoded);
    df_text_column(&d->text, 8);
    df_text_add(&d->text, "%s", line);
    if (decoded.jump) {
        add_place(d, d->program->words[address / 2 + 1]);
    }
    add_comment(d, address, &decoded);
    if (decoded.sets_mode && decoded.raw) {
        df_text_add(&d->text, "        .mode   %s\n", df_mode_name(decoded.mode));
    }
    return words;
}

static void write_all(struct disassembly *d)
{
    const struct df_program *p = d->program;
    uint32_t expected = 0;
    d->mode = NO_MODE;
    if (p->tube[0] != '\0') {
        df_text_add(&d->text, "        .tube   \"%s\"\n", p->tube);
    }
    if (p->firmware[0] != '\0') {
        df_text_add(&d->text, "        .firmware \"%s\"\n", p->firmware);
    }
    if (p->entry != p->low) {
        df_text_add(&d->text, "        .start  ");
        add_place(d, p->entry);
        df_text_add(&d->text, "\n");
    }
    for (uint32_t a = p->low; a < p->high;) {
        if (!p->loaded[a / 2]) {
            a += 2;
            continue;
        }
        if (a != expected) {
            df_text_add(&d->text, "        .org    0o%06o\n", (unsigned)a);
        }
        a += 2 * write_statement(d, a);
        expected = a;
    }
}

char *df_disassemble(const struct df_program *program)
{
    struct disassembly d = {.program = program};
    if (program->low == program->high) {
        df_text_add(&d.text, "; no words\n");
        return df_text_take(&d.text);
    }
    d.marks = calloc(DF_MEMORY_BYTES / 2, 1);
    if (d.marks == NULL) {
        return NULL;
    }
    mark_targets(&d);
    mark_boundaries(&d);
    write_all(&d);
    free(d.marks);
    return df_text_take(&d.text);
}
