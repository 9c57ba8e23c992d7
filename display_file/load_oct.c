/* .oct: one octal word a line. */
#include "display_file/loaders.h"

#include <string.h>

struct line {
    const char *text;
    size_t length;
    unsigned number;
};

struct reader {
    const char *name;
    struct df_program *program;
    struct crt_error *err;
    uint32_t address;
    bool entry_given;
    unsigned entry_line;
};

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

static void trim(struct line *line)
{
    const char *comment = memchr(line->text, ';', line->length);
    if (comment != NULL) {
        line->length = (size_t)(comment - line->text);
    }
    while (line->length > 0 && is_space(line->text[0])) {
        line->text++;
        line->length--;
    }
    while (line->length > 0 && is_space(line->text[line->length - 1])) {
        line->length--;
    }
}

/* An octal number of up to 6 digits and nothing else. */
static bool octal(const char *text, size_t length, uint32_t *value)
{
    *value = 0;
    if (length == 0 || length > 7) {
        return false;
    }
    for (size_t i = 0; i < length; i++) {
        if (text[i] < '0' || text[i] > '7') {
            return false;
        }
        *value = *value * 8 + (uint32_t)(text[i] - '0');
    }
    return true;
}

static bool malformed(const struct reader *r, const struct line *line, const char *expected)
{
    int length = line->length > 40 ? 40 : (int)line->length;
    char shown[41];
    for (int i = 0; i < length; i++) {
        shown[i] = line->text[i] < ' ' || line->text[i] > '~' ? '?' : line->text[i];
    }
    shown[length] = 0;
    return crt_fail(r->err, "%s:%u: '%s' is not %s.", r->name, line->number, shown, expected);
}

static bool place(struct reader *r, const struct line *line)
{
    uint32_t address;
    if (!octal(line->text + 1, line->length - 1, &address) || address % 2 != 0 ||
        address >= DF_MEMORY_BYTES) {
        return malformed(r, line, "@ and an even octal address below 1000000");
    }
    r->address = address;
    return true;
}

static bool entry(struct reader *r, const struct line *line)
{
    uint32_t address;
    if (!octal(line->text + 1, line->length - 1, &address) || address % 2 != 0 ||
        address >= DF_ADDRESS_SPACE) {
        return malformed(r, line, "= and an even octal address below 200000");
    }
    if (r->entry_given) {
        return crt_fail(r->err, "%s:%u: the entry is already given in line %u; keep one of them.",
                        r->name, line->number, r->entry_line);
    }
    r->program->entry = address;
    r->entry_given = true;
    r->entry_line = line->number;
    return true;
}

static bool word(struct reader *r, const struct line *line)
{
    uint32_t value;
    if (!octal(line->text, line->length, &value) || value > 0177777) {
        return malformed(r, line, "an octal word, at most 177777");
    }
    if (r->address >= DF_MEMORY_BYTES) {
        return crt_fail(r->err,
                        "%s:%u: the words go beyond address 777776, the last of display "
                        "memory; move them down with @.",
                        r->name, line->number);
    }
    if (r->program->loaded[r->address / 2]) {
        return crt_fail(r->err,
                        "%s:%u: address %06o already has a word, from line %u; move one of "
                        "them with @.",
                        r->name, line->number, (unsigned)r->address,
                        (unsigned)(r->program->line[r->address / 2] & 0xffffff));
    }
    df_program_put(r->program, r->address, (uint16_t)value);
    r->program->line[r->address / 2] = line->number <= 0xffffff ? line->number : 0;
    r->address += 2;
    return true;
}

static bool read_line(struct reader *r, struct line line)
{
    trim(&line);
    if (line.length == 0) {
        return true;
    }
    switch (line.text[0]) {
    case '@':
        return place(r, &line);
    case '=':
        return entry(r, &line);
    default:
        return word(r, &line);
    }
}

static bool settle_entry(struct reader *r)
{
    struct df_program *p = r->program;
    if (p->low == p->high) {
        return crt_fail(r->err, "%s: no words in it; write one octal word a line.", r->name);
    }
    if (!r->entry_given && p->low >= DF_ADDRESS_SPACE) {
        return crt_fail(r->err,
                        "%s: no words below address 200000, which is as far as the display "
                        "processor reaches; move some down with @.",
                        r->name);
    }
    if (!r->entry_given) {
        p->entry = p->low;
    } else if (!p->loaded[p->entry / 2]) {
        return crt_fail(r->err, "%s:%u: the entry %06o has no word; name an address that has one.",
                        r->name, r->entry_line, (unsigned)p->entry);
    }
    return true;
}

bool df_load_oct(const char *name, const char *text, size_t length, struct df_program *program,
                 struct crt_error *err)
{
    if (!df_program_init(program, err)) {
        return false;
    }
    struct reader r = {.name = name, .program = program, .err = err};
    const char *end = text + length;
    bool ok = df_program_name_file(program, name, err);
    for (unsigned number = 1; ok && text < end; number++) {
        const char *stop = memchr(text, '\n', (size_t)(end - text));
        stop = stop == NULL ? end : stop;
        ok = read_line(&r, (struct line){text, (size_t)(stop - text), number});
        text = stop < end ? stop + 1 : end;
    }
    ok = ok && settle_entry(&r);
    if (!ok) {
        df_program_free(program);
    }
    return ok;
}

void df_write_oct(FILE *out, const struct df_program *program)
{
    uint32_t expected = 0;
    if (program->low == program->high) {
        return;
    }
    fprintf(out, "=%06o\n", (unsigned)program->entry);
    for (uint32_t a = program->low; a < program->high; a += 2) {
        if (!program->loaded[a / 2]) {
            continue;
        }
        if (a != expected) {
            fprintf(out, "@%06o\n", (unsigned)a);
        }
        fprintf(out, "%06o\n", (unsigned)program->words[a / 2]);
        expected = a + 2;
    }
}
