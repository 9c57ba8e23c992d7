#include "emu/lesson/lesson_figures.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST   4096
#define LEVELS 16
#define NAME   256

/* ---- reading JSON ---------------------------------------------------------------------------- */

struct reader {
    const char *p;
    char name[NAME]; /* of what is being read */
    size_t length;
    int level;
    struct vm_figures *figures;
    struct crt_error *err;
};

static bool read_value(struct reader *r);

static bool wrong(struct reader *r, const char *what)
{
    return crt_fail(r->err, "what it printed is not JSON: %s at '%.20s'", what, r->p);
}

static void skip(struct reader *r)
{
    r->p += strspn(r->p, " \t\r\n");
}

static bool take(struct reader *r, char c)
{
    skip(r);
    if (*r->p != c)
        return false;
    r->p++;
    return true;
}

static bool keep(struct reader *r, enum vm_figure_kind kind, double number, const char *text)
{
    struct vm_figures *f = r->figures;
    if (f->count == MOST)
        return crt_fail(r->err, "it printed more than %d figures", MOST);
    if (f->count == f->room) {
        size_t room = f->room ? 2 * f->room : 32;
        struct vm_figure *item = realloc(f->item, room * sizeof *item);
        if (!item)
            return crt_fail(r->err, "out of memory");
        f->item = item;
        f->room = room;
    }
    struct vm_figure figure = {strdup(r->name), kind, number, text ? strdup(text) : NULL};
    f->item[f->count++] = figure;
    return (figure.name && (figure.text || !text)) || crt_fail(r->err, "out of memory");
}

/* Four hex digits as UTF-8; surrogates become '?'. */
static bool take_code(struct reader *r, char *out, size_t *n)
{
    unsigned code = 0;
    for (int i = 0; i < 4; i++, r->p++) {
        const char *digits = "0123456789abcdef", *d = strchr(digits, *r->p | 0x20);
        if (!*r->p || !d || !*d)
            return false;
        code = code * 16 + (unsigned)(d - digits);
    }
    if (code < 0x80)
        out[(*n)++] = (char)(code < ' ' ? ' ' : code);
    else if (code < 0x800) {
        out[(*n)++] = (char)(0xc0 | code >> 6);
        out[(*n)++] = (char)(0x80 | (code & 0x3f));
    } else if (code >= 0xd800 && code < 0xe000)
        out[(*n)++] = '?';
    else {
        out[(*n)++] = (char)(0xe0 | code >> 12);
        out[(*n)++] = (char)(0x80 | (code >> 6 & 0x3f));
        out[(*n)++] = (char)(0x80 | (code & 0x3f));
    }
    return true;
}

/* Cuts a text to `n` bytes, and leaves out a character of several bytes there, of which some may be missing. */
static void cut_text(char *text, size_t n)
{
    while (n > 0 && (text[n - 1] & 0xc0) == 0x80)
        n--;
    if (n > 0 && (text[n - 1] & 0x80))
        n--;
    text[n] = '\0';
}

/* After the first quotation mark. Longer texts are cut. */
static bool take_text(struct reader *r, char *text)
{
    size_t n = 0;
    bool cut = false;
    while (*r->p && *r->p != '"') {
        char c = *r->p++;
        if (n > NAME - 5) {
            n = NAME - 5;
            cut = true;
        }
        if (c != '\\') {
            text[n++] = c;
            continue;
        }
        c = *r->p;
        if (!c)
            break;
        r->p++;
        if (c == 'u') {
            if (!take_code(r, text, &n))
                return wrong(r, "a wrong \\u");
        } else
            text[n++] = c == 'n' || c == 't' || c == 'r' ? ' ' : c;
    }
    text[n] = '\0';
    if (cut)
        cut_text(text, NAME - 5);
    if (*r->p != '"')
        return wrong(r, "a text without end");
    r->p++;
    return true;
}

/* Reads what is called `part` within the current name. */
static bool read_part(struct reader *r, const char *part)
{
    size_t before = r->length, n = strlen(part);
    if (before + n + 2 > NAME)
        return wrong(r, "a name too long");
    if (before)
        r->name[r->length++] = '.';
    memcpy(r->name + r->length, part, n + 1);
    r->length += n;
    bool ok = read_value(r);
    r->length = before;
    r->name[before] = '\0';
    return ok;
}

static bool read_object(struct reader *r)
{
    char part[NAME];
    if (take(r, '}'))
        return true;
    do {
        if (!take(r, '"'))
            return wrong(r, "a name is missing");
        if (!take_text(r, part))
            return false;
        if (!take(r, ':'))
            return wrong(r, "a colon is missing");
        if (!read_part(r, part))
            return false;
    } while (take(r, ','));
    return take(r, '}') || wrong(r, "a brace is missing");
}

static bool read_list(struct reader *r)
{
    char part[24];
    if (take(r, ']'))
        return true;
    int i = 0;
    do {
        snprintf(part, sizeof part, "%d", i++);
        if (!read_part(r, part))
            return false;
    } while (take(r, ','));
    return take(r, ']') || wrong(r, "a bracket is missing");
}

static bool take_literal(struct reader *r, const char *word)
{
    size_t n = strlen(word);
    if (strncmp(r->p, word, n) != 0)
        return false;
    r->p += n;
    return true;
}

static bool read_number(struct reader *r)
{
    size_t n = strspn(r->p, "+-0123456789.eE");
    char number[64], *end;
    if (n == 0 || n >= sizeof number)
        return wrong(r, "a value is missing");
    memcpy(number, r->p, n);
    number[n] = '\0';
    double v = strtod(number, &end);
    if (*end || !isfinite(v))
        return wrong(r, "a wrong number");
    r->p += n;
    return keep(r, VM_FIGURE_NUMBER, v, NULL);
}

static bool read_nested(struct reader *r, bool object)
{
    if (++r->level > LEVELS)
        return wrong(r, "too many levels");
    bool ok = object ? read_object(r) : read_list(r);
    r->level--;
    return ok;
}

static bool read_value(struct reader *r)
{
    char text[NAME];
    skip(r);
    if (take(r, '{'))
        return read_nested(r, true);
    if (take(r, '['))
        return read_nested(r, false);
    if (take(r, '"'))
        return take_text(r, text) && keep(r, VM_FIGURE_TEXT, 0, text);
    if (take_literal(r, "true"))
        return keep(r, VM_FIGURE_TRUTH, 1, NULL);
    if (take_literal(r, "false"))
        return keep(r, VM_FIGURE_TRUTH, 0, NULL);
    if (take_literal(r, "null"))
        return keep(r, VM_FIGURE_NONE, 0, NULL);
    return read_number(r);
}

bool vm_figures_read(struct vm_figures *figures, const char *json, struct crt_error *err)
{
    struct reader r = {.p = json, .figures = figures, .err = err};
    *figures = (struct vm_figures){0};
    skip(&r);
    if (*r.p != '{')
        return wrong(&r, "no object");
    if (!read_value(&r))
        return false;
    skip(&r);
    return !*r.p || wrong(&r, "more than one value");
}

void vm_figures_free(struct vm_figures *figures)
{
    for (size_t i = 0; i < figures->count; i++) {
        free(figures->item[i].name);
        free(figures->item[i].text);
    }
    free(figures->item);
    *figures = (struct vm_figures){0};
}

const struct vm_figure *vm_figures_find(const struct vm_figures *figures, const char *name)
{
    for (size_t i = 0; i < figures->count; i++)
        if (strcmp(figures->item[i].name, name) == 0)
            return &figures->item[i];
    return NULL;
}

/* ---- to text --------------------------------------------------------------------------------- */

struct format {
    bool given, decimals;
    int digits;
    const char *unit;
};

static bool read_format(const char *text, struct format *f, struct crt_error *err)
{
    const char *p = text;
    *f = (struct format){.digits = 3, .unit = ""};
    f->given = *p != '\0';
    f->decimals = *p == '.';
    p += f->decimals;
    if (*p >= '0' && *p <= '9')
        f->digits = *p++ - '0';
    else if (f->decimals)
        return crt_fail(err, "':%s' needs a digit after the dot, as in {c1:.2}", text);
    if (*p && strcmp(p, "%") != 0 && strcmp(p, "s") != 0 && strcmp(p, "Hz") != 0)
        return crt_fail(
            err, "':%s' is no format; there are .2 (decimals), 3 (digits), %%, s and Hz", text);
    f->unit = p;
    return f->decimals || f->digits > 0 || crt_fail(err, "':%s' would show no digit", text);
}

bool vm_figure_format_check(const char *format, struct crt_error *err)
{
    struct format f;
    return read_format(format, &f, err);
}

/* The prefix that leaves 1 … 1000 before the unit. */
static const char *scale_to_prefix(double *v)
{
    static const char *const prefix[] = {"n", "µ", "m", "", "k", "M"};
    double size = fabs(*v);
    int i = 3;
    if (size == 0)
        return "";
    while (i > 0 && size < 0.9995) {
        size *= 1000;
        *v *= 1000;
        i--;
    }
    while (i < 5 && size >= 999.5) {
        size /= 1000;
        *v /= 1000;
        i++;
    }
    return prefix[i];
}

/* Of ten, of the first digit when rounded to so many. */
static int power_of(double v, int digits)
{
    char text[64];
    snprintf(text, sizeof text, "%.*e", digits - 1, v);
    const char *e = strchr(text, 'e');
    return e ? atoi(e + 1) : 0;
}

static void print_digits(double v, const struct format *f, char *text, size_t size)
{
    int decimals = f->digits;
    if (!f->decimals) {
        decimals = f->digits - 1 - power_of(v, f->digits);
        decimals = decimals < 0 ? 0 : decimals > 12 ? 12 : decimals;
        if (!f->given && v == floor(v) && fabs(v) < 1e9)
            decimals = 0;
    }
    snprintf(text, size, "%.*f", decimals, v);
}

static void print_number(double v, const struct format *f, char *text, size_t size)
{
    const char *prefix = "";
    char digits[128];
    if (strcmp(f->unit, "%") == 0)
        v *= 100;
    else if (*f->unit)
        prefix = scale_to_prefix(&v);
    print_digits(v, f, digits, sizeof digits);
    if (*f->unit)
        snprintf(text, size, "%s %s%s", digits, prefix, f->unit);
    else
        snprintf(text, size, "%s", digits);
}

bool vm_figure_format(const struct vm_figure *figure, const char *format, char *text, size_t size,
                      struct crt_error *err)
{
    struct format f;
    if (!read_format(format, &f, err))
        return false;
    switch (figure->kind) {
    case VM_FIGURE_NUMBER:
        print_number(figure->number, &f, text, size);
        return true;
    case VM_FIGURE_TRUTH:
        snprintf(text, size, "%s", figure->number != 0 ? "yes" : "no");
        break;
    case VM_FIGURE_NONE:
        snprintf(text, size, "not applicable");
        return true;
    case VM_FIGURE_TEXT:
        snprintf(text, size, "%s", figure->text);
        break;
    }
    return !f.given || crt_fail(err, "'%s' is no number, which ':%s' needs", figure->name, format);
}
