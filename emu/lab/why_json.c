/* why_json.c — an answer as one JSON object. */
#include "emu/cpu/rv_disasm.h"
#include "emu/json_out.h"
#include "emu/lab/why_entries.h"
#include "emu/lab/why_words.h"

static double seconds(uint64_t ps)
{
    return (double)ps / (double)CRT_PS_PER_S;
}

static void code(FILE *out, const struct vm_why_names *names, uint32_t pc)
{
    uint32_t offset = 0;
    int line = 0;
    const char *symbol = names->elf ? vm_elf_symbol(names->elf, pc, &offset) : NULL;
    const char *file = vm_source_line(names->lines, pc, &line);
    fprintf(out, "\"pc\": \"%08x\"", (unsigned)pc);
    if (symbol) {
        fprintf(out, ", \"symbol\": ");
        vm_json_text(out, symbol);
        fprintf(out, ", \"offset\": %u", (unsigned)offset);
    }
    if (file) {
        fprintf(out, ", \"file\": ");
        vm_json_text(out, file);
        fprintf(out, ", \"line\": %d", line);
    }
}

static void store(FILE *out, const struct vm_why_names *names, const struct vm_why_store *s)
{
    char text[200];
    if (!s->known) {
        fprintf(out, ", \"store\": null");
        return;
    }
    fprintf(out, ", \"store\": {");
    code(out, names, s->pc);
    rv_disasm(s->pc, s->word, text, sizeof text);
    fprintf(out, ", \"instruction\": ");
    vm_json_text(out, text);
    fprintf(out, ", \"t_s\": %.12f, \"cycle\": %llu", seconds(s->t), (unsigned long long)s->cycle);
    vm_why_say_caller(names, s, text, sizeof text);
    if (text[0]) {
        fprintf(out, ", \"caller\": {");
        code(out, names, s->returns_to - 4);
        fputc('}', out);
    }
    fputc('}', out);
}

static void word(FILE *out, const struct vm_why_names *names, const struct vm_why_deposit *d)
{
    char text[80];
    const char *file;
    uint32_t line;
    vm_why_say_word(d, text, sizeof text);
    fprintf(out, ", \"address\": \"%06o\", \"words\": [", (unsigned)d->word.address);
    for (int i = 0; i < d->word.words; i++)
        fprintf(out, "%s\"%06o\"", i ? ", " : "", d->word.word[i]);
    fprintf(out, "], \"statement\": ");
    vm_json_text(out, text);
    if (vm_why_source_line(names, d, &file, &line)) {
        fprintf(out, ", \"file\": ");
        vm_json_text(out, file);
        fprintf(out, ", \"line\": %u", (unsigned)line);
    }
}

static void row(FILE *out, const struct vm_why_row *r)
{
    fprintf(out, ", \"dot\": %d, \"dots\": [%d, %d]", (int)r->dot, (int)r->first, (int)r->last);
    if (r->overscan)
        fprintf(out, ", \"overscan\": true");
    else
        fprintf(out, ", \"byte\": %u, \"bits\": %u", (unsigned)r->address, (unsigned)r->bits);
}

static void deposit(FILE *out, const struct vm_why *why, const struct vm_why_names *names,
                    const struct vm_why_deposit *d)
{
    fprintf(out, "\"t0_s\": %.12f, \"t1_s\": %.12f, \"ago_s\": %.12f", seconds(d->t0),
            seconds(d->t1), seconds(why->t) - seconds(d->t0));
    if (why->place.head == VM_RASTER)
        fprintf(out, ", \"scan_line\": %d", (int)(int32_t)d->source);
    else if (!d->named)
        fprintf(out, ", \"address\": \"%06o\"", (unsigned)d->source);
    if (!d->named)
        return;
    if (why->place.head == VM_RASTER)
        row(out, &d->row);
    else
        word(out, names, d);
    if (why->stores)
        store(out, names, &d->store);
}

static void entry(FILE *out, const struct vm_why *why, const struct vm_why_names *names,
                  const struct vm_why_entry *e)
{
    double part = why->luminance > 0 ? e->share / why->luminance : 0;
    fprintf(out, "{\"pieces\": %zu, \"share\": %.9g, \"cd_m2\": %.12g, \"fluence_cd_s_m2\": %.9g, ",
            e->pieces, part, e->share, e->fluence);
    deposit(out, why, names, e->last);
    fputc('}', out);
}

void vm_why_json(FILE *out, const struct vm_why *why, const struct vm_why_text *text)
{
    struct vm_why_entries entries;
    bool made = vm_why_entries_make(&entries, why, text, text->all);
    fprintf(out,
            "{\"head\": \"%s\", \"at\": [%.9g, %.9g], \"at_mm\": [%.9g, %.9g], \"t_s\": %.12f, "
            "\"cd_m2\": %.12g, \"older_cd_m2\": %.12g, \"from_s\": %.12f, \"deposits\": [",
            why->place.head == VM_RASTER ? "raster" : "vector", why->place.x, why->place.y,
            why->place.x_mm, why->place.y_mm, seconds(why->t), why->luminance, why->older,
            seconds(why->from));
    for (size_t i = 0; made && i < entries.count; i++) {
        fputs(i ? ",\n  " : "\n  ", out);
        entry(out, why, &text->names, &entries.at[i]);
    }
    fprintf(out, "], \"hidden\": {\"pieces\": %zu, \"cd_m2\": %.12g}", entries.hidden,
            entries.hidden_share);
    if (why->near) {
        fprintf(out, ", \"nearest\": {\"mm\": %.6g, ", why->nearest_mm);
        deposit(out, why, &text->names, &why->nearest);
        fputc('}', out);
    }
    if (why->passed) {
        fprintf(out, ", \"passed\": {");
        deposit(out, why, &text->names, &why->at_place);
        fputc('}', out);
    }
    fputs("}\n", out);
    vm_why_entries_free(&entries);
}
