#include "emu/versus.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- parsing ------------------------------------------------------------------------------------
 */

static const struct vm_option *row_of(const struct vm_option_table *tables, size_t table_count,
                                      const char *name, size_t length, void **target)
{
    for (size_t t = 0; t < table_count; t++)
        for (size_t i = 0; i < tables[t].count; i++) {
            const struct vm_option *row = &tables[t].rows[i];
            if (strlen(row->name) == length && strncmp(row->name, name, length) == 0) {
                *target = tables[t].target;
                return row;
            }
        }
    return NULL;
}

static bool unknown(const char *name, size_t length, const struct vm_option_table *tables,
                    size_t table_count, struct crt_error *err)
{
    const char *names[400];
    char word[64];
    size_t count = vm_settings_keys(names, 300);
    for (size_t t = 0; t < table_count; t++)
        for (size_t i = 0; i < tables[t].count && count < 400; i++)
            names[count++] = tables[t].rows[i].name;
    snprintf(word, sizeof word, "%.*s", (int)(length < 60 ? length : 60), name);
    const char *near = vm_nearest(word, names, count);
    if (near)
        return crt_fail(err, "--versus: there is no '%s' to compare; did you mean %s?", word, near);
    return crt_fail(err,
                    "--versus: there is no '%s' to compare; give options without their dashes, "
                    "such as phosphor=P31;refresh=30;set.spot=0.5",
                    word);
}

/* "name=value" or "name" to the argument that says it. */
static bool add(struct vm_versus *v, const char *item, size_t length,
                const struct vm_option_table *tables, size_t table_count, struct crt_error *err)
{
    void *target;
    const char *equals = memchr(item, '=', length);
    size_t n = equals ? (size_t)(equals - item) : length;
    bool set = n > 4 && strncmp(item, "set.", 4) == 0;
    const struct vm_option *row = row_of(tables, table_count, item, n, &target);
    const char *prefix = "--";
    if (set) {
        item += 4;
        length -= 4;
    }
    if (set || (!row && vm_settings_is_key(item, n)))
        prefix = "--set=";
    else if (!row)
        return unknown(item, n, tables, table_count, err);
    if (v->count == VM_VERSUS_MOST)
        return crt_fail(err, "--versus: at most %d things may differ", VM_VERSUS_MOST);
    /* A tube replaces those of the left side. */
    if (row && strcmp(row->name, "tube") == 0)
        ((struct vm_list *)(void *)((char *)target + row->offset))->count = 0;
    char *argument = malloc(strlen(prefix) + length + 1);
    if (!argument)
        return crt_fail(err, "not enough memory for --versus");
    memcpy(argument, prefix, strlen(prefix));
    memcpy(argument + strlen(prefix), item, length);
    argument[strlen(prefix) + length] = '\0';
    v->item[v->count++] = argument;
    return true;
}

static bool split(struct vm_versus *v, const char *text, const struct vm_option_table *tables,
                  size_t table_count, struct crt_error *err)
{
    for (const char *p = text; *p;) {
        p += strspn(p, " ;");
        size_t length = strcspn(p, ";"), n = length;
        while (n > 0 && p[n - 1] == ' ')
            n--;
        if (n > 0 && !add(v, p, n, tables, table_count, err))
            return false;
        p += length;
    }
    return v->count > 0 ||
           crt_fail(err, "--versus: say what is different, such as phosphor=P31;refresh=30");
}

bool vm_versus_parse(struct vm_versus *v, const char *text, const struct vm_option_table *tables,
                     size_t table_count, struct crt_error *err)
{
    struct vm_args args;
    struct crt_error why;
    *v = (struct vm_versus){0};
    if (!split(v, text, tables, table_count, err))
        return false;
    return vm_options_parse(tables, table_count, v->count, v->item, &args, &why) == VM_PARSED ||
           crt_fail(err, "--versus: %.400s", why.text);
}

void vm_versus_free(struct vm_versus *v)
{
    while (v->count > 0)
        free(v->item[--v->count]);
}

/* ---- captions -----------------------------------------------------------------------------------
 */

/* What an option's field holds, as it would be typed. */
static void field_text(const struct vm_option *row, const void *field, char *text, size_t size)
{
    const struct vm_time *time = field;
    const char *const *string = field;
    char value[64] = "by default";
    if (row->kind == VM_OPT_TIME && time->given && time->in_ticks)
        snprintf(value, sizeof value, "%llu ticks", (unsigned long long)time->value);
    else if (row->kind == VM_OPT_TIME && time->given)
        vm_format_time(time->value, value, sizeof value);
    else if ((row->kind == VM_OPT_STRING || row->kind == VM_OPT_CHOICE) && *string)
        snprintf(value, sizeof value, "%.60s", *string);
    else if (row->kind == VM_OPT_REAL && *(const double *)field >= row->low)
        snprintf(value, sizeof value, "%g", *(const double *)field);
    else if (row->kind == VM_OPT_FLAG)
        snprintf(value, sizeof value, "%s", *(const bool *)field ? "yes" : "no");
    else if (row->kind == VM_OPT_INTEGER && *(const long *)field)
        snprintf(value, sizeof value, "%ld", *(const long *)field);
    snprintf(text, size, "%s %s", row->name, value);
}

/* What --set KEY has led to. */
static void set_text(const char *item, const struct vm_settings *s, char *text, size_t size)
{
    char key[48];
    struct vm_setting value;
    snprintf(key, sizeof key, "%.*s", (int)strcspn(item, "="), item);
    if (!vm_settings_value(s, key, &value))
        snprintf(text, size, "%s", key);
    else if (value.name)
        snprintf(text, size, "%s %s", key, value.name);
    else
        snprintf(text, size, "%s %.4g%s%s", key, value.number, value.unit[0] ? " " : "",
                 value.unit);
}

/* Names with figures that everybody knows need no word before them. `head`: what the right side's tube and
 * phosphor are of. */
static void item_text(const char *item, const struct vm_versus_side *side, enum vm_head head,
                      char *text, size_t size)
{
    const struct vm_settings *s = side->settings;
    void *target;
    size_t length = strcspn(item, "=");
    const struct vm_option *row = row_of(side->tables, side->table_count, item, length, &target);
    const char *name = row ? row->name : "";
    if (strcmp(name, "tube") == 0)
        snprintf(text, size, "%s %s", s->monitor[head].row.name, s->monitor[head].phosphor.name);
    else if (strcmp(name, "phosphor") == 0)
        snprintf(text, size, "%s", s->monitor[head].phosphor.name);
    else if (strcmp(name, "refresh") == 0)
        snprintf(text, size, "%.4g Hz", crt_rate_hz(s->tick));
    else if (strcmp(name, "mode") == 0)
        ras_timing_name(side->timing ? side->timing : &s->timing, text, size);
    else if (strcmp(name, "personality") == 0)
        snprintf(text, size, "%s", s->personality == DF_VS60 ? "VS60" : "VT11");
    else if (strcmp(name, "view") == 0)
        snprintf(text, size, "%s", vm_view_name(side->view));
    else if (strcmp(name, "set") == 0)
        set_text(item + length + 1, s, text, size);
    else if (row)
        field_text(row, (const char *)target + row->offset, text, size);
    else
        text[0] = '\0';
}

static void join(char *text, const char *part)
{
    size_t n = strlen(text);
    /* "·" is two bytes, which must not be cut. */
    if (n + strlen(part) + 5 <= VM_VERSUS_CAPTION)
        snprintf(text + n, VM_VERSUS_CAPTION - n, "%s%s", n ? " \xC2\xB7 " : "", part);
}

/* What was asked to differ and does not is said as such. */
static void join_all(const struct vm_versus *v, const struct vm_versus_side side[VM_SIDES],
                     char text[VM_SIDES][VM_VERSUS_CAPTION])
{
    for (int i = 0; i < v->count; i++) {
        char part[2][96], both[104];
        for (int k = 0; k < 2; k++)
            item_text(v->item[i] + 2, &side[k], side[1].settings->main, part[k], sizeof part[k]);
        bool same = strcmp(part[0], part[1]) == 0;
        snprintf(both, sizeof both, "both %s", part[0]);
        for (int k = 0; k < 2; k++)
            join(text[k], same ? both : part[k]);
    }
}

void vm_versus_captions(const struct vm_versus *v, const struct vm_versus_side side[VM_SIDES],
                        char text[VM_SIDES][VM_VERSUS_CAPTION])
{
    text[0][0] = text[1][0] = '\0';
    join_all(v, side, text);
}
