#include "emu/lesson/lesson_expect.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *sign;
    enum vm_expect_kind kind;
    const char *words;
} signs[] = {
    {"<", VM_EXPECT_LESS, "less than"}, {"<=", VM_EXPECT_AT_MOST, "at most"},
    {">", VM_EXPECT_MORE, "more than"}, {">=", VM_EXPECT_AT_LEAST, "at least"},
    {"=", VM_EXPECT_EQUAL, "exactly"},  {"true", VM_EXPECT_TRUE, "yes"},
    {"false", VM_EXPECT_FALSE, "no"},   {"none", VM_EXPECT_NONE, "not applicable"},
};
#define SIGNS (sizeof signs / sizeof *signs)

static const struct {
    const char *suffix, *power;
    double factor;
} suffixes[] = {{"ns", "e-9", 1e-9}, {"us", "e-6", 1e-6}, {"ms", "e-3", 1e-3},
                {"s", "e0", 1},      {"k", "e3", 1e3},    {"%", "e-2", 0.01}};

/* "340us": its value; `suffix` is where the letters begin. */
static bool read_number(const char *text, double *value, double *factor, const char **suffix)
{
    char *end;
    if (!*text || strspn(text, "+-.0123456789eE") == 0)
        return false;
    *value = strtod(text, &end);
    if (end == text || !isfinite(*value))
        return false;
    *suffix = end;
    *factor = 1;
    if (!*end)
        return true;
    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++)
        if (strcmp(end, suffixes[i].suffix) == 0) {
            /* 340us is the number 340e-6, which 340 times 1e-6 is not. */
            char exact[VM_QUOTE_KEY + 8];
            snprintf(exact, sizeof exact, "%.*s%s", (int)(end - text), text, suffixes[i].power);
            *factor = suffixes[i].factor;
            *value = strtod(exact, NULL);
            return strcspn(exact, "eE") == (size_t)(end - text);
        }
    return false;
}

static bool is_number(const char *text)
{
    double value, factor;
    const char *suffix;
    return read_number(text, &value, &factor, &suffix);
}

/* Copies the next word and steps over it and the space. */
static bool take(const char **p, char *word, const char *what, struct crt_error *err)
{
    size_t n = strcspn(*p, " ");
    if (n == 0)
        return crt_fail(err, "%s is missing; write for example: expect c1 0.43..0.46", what);
    if (n >= VM_QUOTE_KEY)
        return crt_fail(err, "'%.40s…' is too long for %s", *p, what);
    memcpy(word, *p, n);
    word[n] = '\0';
    *p += n;
    *p += strspn(*p, " ");
    return true;
}

/* LOW..HIGH */
static bool read_range(struct vm_expect *e, const char *word, struct crt_error *err)
{
    const char *dots = strstr(word, "..");
    double low, high, factor;
    const char *suffix;
    if (!dots)
        return crt_fail(
            err,
            "'%s' is neither a range such as 0.43..0.46, in one word, nor <, <=, >, >=, =, "
            "true, false, none",
            word);
    snprintf(e->low, sizeof e->low, "%.*s", (int)(dots - word), word);
    snprintf(e->high, sizeof e->high, "%s", dots + 2);
    if (!read_number(e->low, &low, &factor, &suffix) ||
        !read_number(e->high, &high, &factor, &suffix))
        return crt_fail(
            err, "'%s' is not a range of two numbers; they may end in ns, us, ms, s, k or %%",
            word);
    e->kind = VM_EXPECT_RANGE;
    return low <= high ||
           crt_fail(err,
                    "the range '%s' is empty; each end has its own unit, as in 10ms..20ms or "
                    "5%%..10%%",
                    word);
}

/* What stands after a sign: a number, {a figure}, or after = also a word. */
static bool read_limit(struct vm_expect *e, const char **p, struct crt_error *err)
{
    if (!take(p, e->low, "what it is compared with", err))
        return false;
    size_t n = strlen(e->low);
    e->other = e->low[0] == '{';
    if (e->other) {
        if (n < 3 || e->low[n - 1] != '}' || strcspn(e->low + 1, "{}:") != n - 2)
            return crt_fail(err, "'%s' is not {NAME} of a figure", e->low);
        memmove(e->low, e->low + 1, n - 2);
        e->low[n - 2] = '\0';
        return true;
    }
    return e->kind == VM_EXPECT_EQUAL || is_number(e->low) ||
           crt_fail(err, "'%s' is neither a number nor {NAME} of a figure", e->low);
}

bool vm_expect_read(struct vm_expect *e, const char *text, struct crt_error *err)
{
    char word[VM_QUOTE_KEY];
    const char *p = text;
    *e = (struct vm_expect){.label = ""};
    if (!take(&p, e->key, "the name of a figure", err) || !take(&p, word, "what is expected", err))
        return false;
    if (strpbrk(e->key, "{}:"))
        return crt_fail(err, "'%s' is written without braces: expect c1 0.43..0.46", e->key);
    size_t i = 0;
    while (i < SIGNS && strcmp(signs[i].sign, word) != 0)
        i++;
    bool ok;
    if (i == SIGNS)
        ok = read_range(e, word, err);
    else {
        e->kind = signs[i].kind;
        ok = e->kind >= VM_EXPECT_TRUE || read_limit(e, &p, err);
    }
    e->label = p;
    return ok;
}

/* ---- what came out --------------------------------------------------------------------------- */

static const char *unit_text(const char *suffix)
{
    return strcmp(suffix, "us") == 0 ? "µs" : suffix;
}

/* As written, with a space before the unit. */
static void say_limit(const char *written, char *text, size_t size)
{
    double value, factor;
    const char *suffix = "";
    int n = (int)strlen(written);
    if (read_number(written, &value, &factor, &suffix))
        n = (int)(suffix - written);
    snprintf(text, size, "%.*s%s%s", n, written, *suffix ? " " : "", unit_text(suffix));
}

static bool ends_with(const char *text, const char *ending)
{
    size_t n = strlen(text), m = strlen(ending);
    return n > m && strcmp(text + n - m, ending) == 0;
}

/* In the unit of the limit, so that both can be compared by eye; else in that which its name ends with. */
static void say_number(double v, const char *like, const char *key, int digits, char *text,
                       size_t size)
{
    char format[8];
    double value, factor = 1;
    const char *suffix = "";
    struct crt_error err;
    if (!read_number(like, &value, &factor, &suffix) && ends_with(key, "_s")) {
        struct vm_figure figure = {NULL, VM_FIGURE_NUMBER, v, NULL};
        snprintf(format, sizeof format, "%ds", digits);
        vm_figure_format(&figure, format, text, size, &err);
        return;
    }
    snprintf(text, size, "%.*g%s%s", digits, v / factor, *suffix ? " " : "", unit_text(suffix));
}

static bool within(const struct vm_expect *e, double v, double limit)
{
    double high = 0, factor;
    const char *suffix;
    switch (e->kind) {
    case VM_EXPECT_RANGE:
        return read_number(e->high, &high, &factor, &suffix) && v >= limit && v <= high;
    case VM_EXPECT_LESS:
        return v < limit;
    case VM_EXPECT_AT_MOST:
        return v <= limit;
    case VM_EXPECT_MORE:
        return v > limit;
    case VM_EXPECT_AT_LEAST:
        return v >= limit;
    default:
        return v == limit;
    }
}

static const char *sign_words(enum vm_expect_kind kind)
{
    for (size_t i = 0; i < SIGNS; i++)
        if (signs[i].kind == kind)
            return signs[i].words;
    return "";
}

static bool compare_numbers(const struct vm_expect *e, double v, double limit, const char *like,
                            struct vm_expect_outcome *o)
{
    char other[64] = "", low[VM_QUOTE_KEY + 8], high[VM_QUOTE_KEY + 8];
    o->holds = within(e, v, limit);
    /* Rounded it might look as if it held. */
    say_number(v, like, e->key, o->holds ? 4 : 7, o->measured, sizeof o->measured);
    say_limit(e->low, low, sizeof low);
    say_limit(e->high, high, sizeof high);
    if (e->other)
        say_number(limit, "", e->low, 4, other, sizeof other);
    if (e->kind == VM_EXPECT_RANGE)
        snprintf(o->expected, sizeof o->expected, "%s to %s", low, high);
    else if (e->other)
        snprintf(o->expected, sizeof o->expected, "%s %s, which is %s", sign_words(e->kind), e->low,
                 other);
    else
        snprintf(o->expected, sizeof o->expected, "%s %s", sign_words(e->kind), low);
    return true;
}

static bool compare_kind(const struct vm_expect *e, const struct vm_figure *f,
                         struct vm_expect_outcome *o)
{
    o->holds = e->kind == VM_EXPECT_NONE
                   ? f->kind == VM_FIGURE_NONE
                   : f->kind == VM_FIGURE_TRUTH && (f->number != 0) == (e->kind == VM_EXPECT_TRUE);
    snprintf(o->expected, sizeof o->expected, "%s", sign_words(e->kind));
    return true;
}

static bool compare_text(const struct vm_figure *f, const char *with, struct vm_expect_outcome *o)
{
    o->holds = f->kind == VM_FIGURE_TEXT && strcmp(f->text, with) == 0;
    snprintf(o->expected, sizeof o->expected, "%s", with);
    return true;
}

bool vm_expect_check(const struct vm_expect *e, vm_quote_find *find, void *context,
                     struct vm_expect_outcome *o, struct crt_error *err)
{
    const struct vm_figure *f = find(context, e->key, err), *other = NULL;
    double limit = 0, factor = 1;
    const char *suffix;
    if (!f || !vm_figure_format(f, "", o->measured, sizeof o->measured, err))
        return false;
    if (e->kind >= VM_EXPECT_TRUE)
        return compare_kind(e, f, o);
    if (e->other) {
        other = find(context, e->low, err);
        if (!other)
            return false;
        if (e->kind == VM_EXPECT_EQUAL && other->kind == VM_FIGURE_TEXT)
            return compare_text(f, other->text, o);
        if (other->kind != VM_FIGURE_NUMBER)
            return crt_fail(err, "'%s' is no number", e->low);
        limit = other->number;
    } else if (!read_number(e->low, &limit, &factor, &suffix))
        return compare_text(f, e->low, o);
    if (f->kind != VM_FIGURE_NUMBER) {
        o->holds = false;
        snprintf(o->expected, sizeof o->expected, "a number");
        return true;
    }
    return compare_numbers(e, f->number, limit, e->other ? "" : e->low, o);
}
