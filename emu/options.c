#include "emu/options.h"

#include <stdio.h>
#include <string.h>

#define MAX_OPTIONS 128

static size_t smallest(size_t a, size_t b, size_t c)
{
    size_t m = a < b ? a : b;
    return m < c ? m : c;
}

/* Edits (insert, delete, replace) from a to b; words of 32 letters or more count as far away. */
static size_t edit_distance(const char *a, const char *b)
{
    size_t row[33], na = strlen(a), nb = strlen(b);
    if (na > 32 || nb > 32)
        return 99;
    for (size_t j = 0; j <= nb; j++)
        row[j] = j;
    for (size_t i = 1; i <= na; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= nb; j++) {
            size_t above = row[j];
            row[j] = smallest(above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1]));
            diagonal = above;
        }
    }
    return row[nb];
}

const char *vm_nearest(const char *word, const char *const *words, size_t count)
{
    const char *best = NULL;
    size_t limit = strlen(word) / 3 + 1, best_distance = limit + 1;
    for (size_t i = 0; i < count; i++) {
        size_t d = edit_distance(word, words[i]);
        if (d < best_distance) {
            best = words[i];
            best_distance = d;
        }
    }
    return best;
}

static bool named(const struct vm_option *o, const char *name, size_t length)
{
    return strlen(o->name) == length && strncmp(o->name, name, length) == 0;
}

/* The row called `name`, or with the letter name[0] when `short_form`; its target in *target. */
static const struct vm_option *find(const struct vm_option_table *tables, size_t table_count,
                                    const char *name, size_t length, bool short_form, void **target)
{
    for (size_t t = 0; t < table_count; t++)
        for (size_t i = 0; i < tables[t].count; i++) {
            const struct vm_option *o = &tables[t].rows[i];
            if (short_form ? o->letter && o->letter == name[0] : named(o, name, length)) {
                *target = tables[t].target;
                return o;
            }
        }
    return NULL;
}

static bool unknown(const struct vm_option_table *tables, size_t table_count, const char *arg,
                    struct crt_error *err)
{
    const char *names[MAX_OPTIONS];
    char word[40];
    size_t count = 0;
    for (size_t t = 0; t < table_count; t++)
        for (size_t i = 0; i < tables[t].count && count < MAX_OPTIONS; i++)
            names[count++] = tables[t].rows[i].name;
    size_t n = strcspn(arg, "=");
    if (n > 2 && n < sizeof word) {
        memcpy(word, arg + 2, n - 2);
        word[n - 2] = '\0';
        const char *near = vm_nearest(word, names, count);
        if (near)
            return crt_fail(err, "there is no option %.*s; did you mean --%s?", (int)n, arg, near);
    }
    return crt_fail(err, "there is no option %.*s; --help lists them", (int)(n < 60 ? n : 60), arg);
}

static bool chosen(const char *choices, const char *text)
{
    size_t n = strlen(text);
    for (const char *p = choices; *p;) {
        size_t length = strcspn(p, "|");
        if (length == n && strncmp(p, text, n) == 0)
            return true;
        p += length + (p[length] == '|');
    }
    return false;
}

static bool add_to_list(struct vm_list *list, const char *text, struct crt_error *err)
{
    if (list->count == VM_LIST_MAX)
        return crt_fail(err, "it may be given %d times at most", VM_LIST_MAX);
    list->item[list->count++] = text;
    return true;
}

static bool store(const struct vm_option *o, void *field, const char *text, struct crt_error *err)
{
    struct vm_octal *octal = field;
    switch (o->kind) {
    case VM_OPT_FLAG:
        *(bool *)field = true;
        return true;
    case VM_OPT_STRING:
        *(const char **)field = text;
        return *text ? true : crt_fail(err, "its value is empty");
    case VM_OPT_LIST:
        return add_to_list(field, text, err);
    case VM_OPT_TIME:
        return vm_parse_time(text, field, err);
    case VM_OPT_SIZE:
        return vm_parse_size(text, field, err);
    case VM_OPT_RATE:
        return vm_parse_rate(text, field, err);
    case VM_OPT_REAL:
        return vm_parse_real(text, o->low, o->high, field, err);
    case VM_OPT_INTEGER:
        return vm_parse_integer(text, (long)o->low, (long)o->high, field, err);
    case VM_OPT_OCTAL:
        octal->given = true;
        return vm_parse_octal(text, &octal->value, err);
    case VM_OPT_CHOICE:
        if (!chosen(o->value, text))
            return crt_fail(err, "'%s' is not one of %s", text, o->value);
        *(const char **)field = text;
        return true;
    }
    return false;
}

/* The cursor over argv. */
struct cursor {
    int argc, next;
    char **argv;
};

static bool parse_one(const struct vm_option_table *tables, size_t table_count, struct cursor *c,
                      struct crt_error *err)
{
    const char *arg = c->argv[c->next++];
    bool short_form = arg[1] != '-';
    const char *name = arg + (short_form ? 1 : 2);
    size_t length = short_form ? 1 : strcspn(name, "=");
    void *target = NULL;
    const struct vm_option *o = find(tables, table_count, name, length, short_form, &target);
    if (!o)
        return unknown(tables, table_count, arg, err);
    const char *text = name[length] == '=' ? name + length + 1 : NULL;
    if (short_form && name[1] != '\0' && name[1] != '=')
        text = name + 1;
    if (o->kind == VM_OPT_FLAG && text)
        return crt_fail(err, "--%s takes no value", o->name);
    if (o->kind != VM_OPT_FLAG && !text) {
        if (c->next == c->argc)
            return crt_fail(err, "--%s needs a value: --%s %s", o->name, o->name, o->value);
        text = c->argv[c->next++];
    }
    struct crt_error why;
    if (store(o, (char *)target + o->offset, text, &why))
        return true;
    return crt_fail(err, "--%s: %.400s", o->name, why.text);
}

enum vm_parsed vm_options_parse(const struct vm_option_table *tables, size_t table_count, int argc,
                                char **argv, struct vm_args *args, struct crt_error *err)
{
    struct cursor c = {argc, 0, argv};
    bool only_files = false;
    args->count = 0;
    while (c.next < argc) {
        const char *arg = argv[c.next];
        if (!only_files && strcmp(arg, "--") == 0) {
            only_files = true;
            c.next++;
        } else if (!only_files && (strcmp(arg, "--help") == 0 || strcmp(arg, "-h") == 0)) {
            return VM_PARSED_HELP;
        } else if (!only_files && arg[0] == '-' && arg[1] != '\0') {
            if (!parse_one(tables, table_count, &c, err))
                return VM_PARSED_ERROR;
        } else {
            if (args->count == VM_ARGS_MAX) {
                crt_fail(err, "there are more than %d arguments", VM_ARGS_MAX);
                return VM_PARSED_ERROR;
            }
            args->item[args->count++] = argv[c.next++];
        }
    }
    return VM_PARSED;
}

void vm_print_wrapped(FILE *out, const char *text, int indent)
{
    int column = indent;
    while (*text) {
        int word = (int)strcspn(text, " ");
        if (column > indent && column + 1 + word > 100) {
            fprintf(out, "\n%*s", indent, "");
            column = indent;
        } else if (column > indent) {
            fputc(' ', out);
            column++;
        }
        fprintf(out, "%.*s", word, text);
        column += word;
        text += word;
        text += strspn(text, " ");
    }
    fputc('\n', out);
}

void vm_options_help(FILE *out, const struct vm_option_table *tables, size_t table_count)
{
    for (size_t t = 0; t < table_count; t++)
        for (size_t i = 0; i < tables[t].count; i++) {
            const struct vm_option *o = &tables[t].rows[i];
            char head[80];
            int n = o->letter ? snprintf(head, sizeof head, "-%c, --%s", o->letter, o->name)
                              : snprintf(head, sizeof head, "--%s", o->name);
            if (o->kind != VM_OPT_FLAG)
                snprintf(head + n, sizeof head - (size_t)n, " %s", o->value);
            fprintf(out, "  %-26s ", head);
            if (strlen(head) > 26)
                fprintf(out, "\n%29s", "");
            vm_print_wrapped(out, o->help, 29);
        }
    fprintf(out, "  %-26s %s\n", "-h, --help", "this text");
}
