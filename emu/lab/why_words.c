#include "emu/lab/why_words.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "display_file/decode.h"
#include "display_file/df_regs.h"
#include "emu/cpu/rv_disasm.h"

/* ---- display words --------------------------------------------------------------------------- */

struct vm_why_names vm_why_names_of(const struct vm_input *input,
                                    const struct vm_source_lines *lines)
{
    const struct df_program *p = &input->program;
    const char *dot = p->words && p->file_count ? strrchr(p->files[0], '.') : NULL;
    /* Octal words and tapes have lines, but are no source. */
    bool source = dot && strcasecmp(dot, ".df") == 0;
    return (struct vm_why_names){.program = source ? p : NULL, .elf = &input->elf, .lines = lines};
}

bool vm_why_as_loaded(const struct df_program *p, const struct vm_why_deposit *d)
{
    uint32_t at = d->word.address / 2;
    if (!p || !p->words || !d->named || d->store.known || d->word.words == 0 ||
        at + 1 >= DF_MEMORY_BYTES / 2)
        return false;
    for (uint32_t i = 0; i < (uint32_t)d->word.words; i++)
        if (!p->loaded[at + i] || p->words[at + i] != d->word.word[i])
            return false;
    return true;
}

bool vm_why_source_line(const struct vm_why_names *names, const struct vm_why_deposit *d,
                        const char **file, uint32_t *line)
{
    const struct df_program *p = names->program;
    if (!vm_why_as_loaded(p, d))
        return false;
    uint32_t where = p->line[d->word.address / 2];
    if (!where || where >> 24 >= p->file_count)
        return false;
    *file = p->files[where >> 24];
    *line = where & 0xFFFFFF;
    return true;
}

void vm_why_say_word(const struct vm_why_deposit *d, char *text, size_t size)
{
    df_decode(d->word.word, (uint32_t)d->word.words, d->word.mode, text, size);
}

static void say_words(const struct vm_why_deposit *d, char *text, size_t size)
{
    char statement[80], second[8] = "";
    vm_why_say_word(d, statement, sizeof statement);
    if (d->word.words == 2)
        snprintf(second, sizeof second, " %06o", d->word.word[1]);
    snprintf(text, size, "%06o: %06o%s  %s", (unsigned)d->word.address, d->word.word[0], second,
             statement);
}

/* ---- dots ------------------------------------------------------------------------------------ */

static void say_dots(const struct vm_why_deposit *d, char *text, size_t size)
{
    const struct vm_why_row *row = &d->row;
    char dots[64], byte[64];
    bool one = row->first == row->last;
    snprintf(byte, sizeof byte, "byte 0x%06x of the buffer", (unsigned)row->address);
    if (one)
        snprintf(dots, sizeof dots, "dot %d, ", (int)row->dot);
    else if (row->overscan)
        snprintf(dots, sizeof dots, "dots %d-%d, ", (int)row->first, (int)row->last);
    else
        snprintf(dots, sizeof dots, "dots %d-%d; dot %d is ", (int)row->first, (int)row->last,
                 (int)row->dot);
    snprintf(text, size, "scan line %d, %s%s", (int)row->row, dots,
             row->overscan ? "overscan" : byte);
}

/* ---- both ------------------------------------------------------------------------------------ */

void vm_why_say_source(const struct vm_why *why, const struct vm_why_names *names,
                       const struct vm_why_deposit *d, char *text, size_t size)
{
    const char *file;
    uint32_t line;
    if (why->place.head == VM_RASTER)
        snprintf(text, size, "scan line %d", (int)(int32_t)d->source);
    else if (why->recording)
        snprintf(text, size, "word %06o of the recording", (unsigned)d->source);
    else if (vm_why_source_line(names, d, &file, &line))
        snprintf(text, size, "line %u of %s", (unsigned)line, file);
    else
        snprintf(text, size, "display word %06o", (unsigned)d->source);
}

void vm_why_say_what(const struct vm_why *why, const struct vm_why_deposit *d, char *text,
                     size_t size)
{
    if (!d->named && why->place.head == VM_RASTER)
        snprintf(text, size, "scan line %d", (int)(int32_t)d->source);
    else if (!d->named)
        snprintf(text, size, "%06o", (unsigned)d->source);
    else if (why->place.head == VM_RASTER)
        say_dots(d, text, size);
    else
        say_words(d, text, size);
}

/* ---- stores ---------------------------------------------------------------------------------- */

void vm_why_say_code(const struct vm_why_names *names, uint32_t pc, char *text, size_t size)
{
    uint32_t offset = 0;
    int line = 0;
    const char *symbol = names->elf ? vm_elf_symbol(names->elf, pc, &offset) : NULL;
    const char *file = vm_source_line(names->lines, pc, &line);
    char where[96] = "";
    if (file)
        snprintf(where, sizeof where, ", %.80s:%d", file, line);
    if (symbol)
        snprintf(text, size, "%.60s+0x%x%s", symbol, (unsigned)offset, where);
    else
        snprintf(text, size, "%08x%s", (unsigned)pc, where);
}

void vm_why_say_store(const struct vm_why *why, const struct vm_why_names *names,
                      const struct vm_why_deposit *d, bool same, char *text, size_t size)
{
    char code[180], when[32], instruction[RV_DISASM_MAX];
    const struct vm_why_store *s = &d->store;
    text[0] = '\0';
    if (!s->known)
        return;
    vm_format_time(why->t > s->t ? why->t - s->t : 0, when, sizeof when);
    if (same) {
        snprintf(text, size, "stored %s ago by the same", when);
        return;
    }
    vm_why_say_code(names, s->pc, code, sizeof code);
    rv_disasm(s->pc, s->word, instruction, sizeof instruction);
    snprintf(text, size, "stored %s ago by %s: %08x %s", when, code, (unsigned)s->pc, instruction);
}

void vm_why_say_caller(const struct vm_why_names *names, const struct vm_why_store *s, char *text,
                       size_t size)
{
    uint32_t in = 0, from = 0;
    text[0] = '\0';
    if (!s->known || !names->elf || s->returns_to < 4)
        return;
    const char *here = vm_elf_symbol(names->elf, s->pc, &in);
    const char *caller = vm_elf_symbol(names->elf, s->returns_to - 4, &from);
    if (here && caller && strcmp(here, caller) != 0)
        vm_why_say_code(names, s->returns_to - 4, text, size);
}
