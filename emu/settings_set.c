/* settings_set.c — --set KEY=VALUE: memory, knobs, figures of the tubes, input devices. */
#include <string.h>

#include "emu/settings_parts.h"

static bool set_memory(struct vm_settings *s, const char *text, struct crt_error *err)
{
    uint32_t bytes;
    if (!vm_parse_bytes(text, &bytes, err))
        return false;
    if (bytes < 1024 || bytes > DF_MEMORY_BYTES || bytes % 2)
        return crt_fail(err, "%s is not a possible display memory; give 1K to 256K", text);
    s->memory_bytes = bytes;
    return true;
}

static bool set_average(struct vm_settings *s, const char *text, struct crt_error *err)
{
    struct vm_time time;
    if (!vm_parse_time(text, &time, err))
        return false;
    if (time.in_ticks || time.value == 0)
        return crt_fail(err, "'%s' must be a time above zero, such as 33.33us", text);
    s->average_ps = time.value;
    return true;
}

bool vm_figure_value(const char *text, const char *unit, double *value, struct crt_error *err)
{
    char number[40];
    size_t n = strlen(text), u = strlen(unit);
    struct vm_time time;
    if (strcmp(unit, "us") == 0 && n && text[n - 1] == 's') {
        if (!vm_parse_time(text, &time, err))
            return false;
        *value = (double)time.value / (double)CRT_PS_PER_US;
        return true;
    }
    if (n > u && strcmp(text + n - u, unit) == 0 && strcmp(unit, "1") != 0)
        n -= u;
    if (n >= sizeof number)
        return crt_fail(err, "'%.60s' is not a number", text);
    memcpy(number, text, n);
    number[n] = '\0';
    return vm_parse_real(number, -1e9, 1e9, value, err);
}

size_t vm_settings_keys(const char **names, size_t most)
{
#define X(field, unit, meaning) #field,
    static const char *const own[] = {CRT_TUBE_FIGURES(X) "memory", "dpu.average", "brightness",
                                      "contrast", "focus"};
#undef X
    size_t count = 0;
    for (size_t i = 0; i < sizeof own / sizeof *own && count < most; i++)
        names[count++] = own[i];
    for (unsigned i = 0; inp_setup_key(i) && count < most; i++)
        names[count++] = inp_setup_key(i);
    return count;
}

/* Without the head's name. */
static const char *bare(const char *key)
{
    bool head = strncmp(key, "vector.", 7) == 0 || strncmp(key, "raster.", 7) == 0;
    return head ? key + 7 : key;
}

bool vm_settings_is_key(const char *key, size_t length)
{
    const char *names[300];
    size_t count = vm_settings_keys(names, 300);
    const char *name = length > 7 ? bare(key) : key;
    length -= (size_t)(name - key);
    for (size_t i = 0; i < count; i++)
        if (strlen(names[i]) == length && strncmp(names[i], name, length) == 0)
            return true;
    return false;
}

static bool no_such_key(const char *name, struct crt_error *err)
{
    const char *names[300];
    size_t count = vm_settings_keys(names, 300);
    const char *near = vm_nearest(name, names, count);
    if (near)
        return crt_fail(err, "there is no '%.60s' to set; did you mean %s?", name, near);
    return crt_fail(err, "there is no '%.60s' to set; kinescope list tubes --why names the figures",
                    name);
}

static bool set_figure(struct vm_monitor *m, const char *name, const char *text,
                       struct crt_error *err)
{
    const char *unit = "";
    double value = 0;
    struct crt_figure *figure = crt_tube_figure(&m->row, name, &unit);
    if (!vm_figure_value(text, unit, &value, err))
        return false;
    *figure = (struct crt_figure){value, value, value, "set on the command line"};
    return crt_tube_check_figure(&m->row, name, err);
}

/* The knob called `name`, and its limits; NULL: there is none. */
static double *knob_of(struct crt_knobs *knobs, const char *name, double *low, double *high)
{
    *low = strcmp(name, "brightness") == 0 ? -1 : 0;
    *high = *low < 0 ? 1 : 4;
    if (strcmp(name, "brightness") == 0)
        return &knobs->brightness;
    if (strcmp(name, "contrast") == 0)
        return &knobs->contrast;
    return strcmp(name, "focus") == 0 ? &knobs->focus : NULL;
}

/* A knob is turned on every monitor that is meant. */
static bool set_knob(struct vm_settings *s, unsigned heads, const char *name, const char *text,
                     struct crt_error *err)
{
    for (int h = 0; h < VM_HEADS; h++) {
        double low, high, *knob = knob_of(&s->monitor[h].knobs, name, &low, &high);
        if (!(heads >> h & 1))
            continue;
        if (!vm_parse_real(text, low, high, knob, err))
            return false;
        s->monitor[h].turned = true;
    }
    return true;
}

/* The head whose figure is meant: the one named, the main one, or the only one that has it. */
static bool head_for(const struct vm_settings *s, unsigned named, const char *name,
                     enum vm_head *head, struct crt_error *err)
{
    struct crt_tube_row copy = s->monitor[s->main].row;
    if (!crt_tube_figure(&copy, name, NULL))
        return no_such_key(name, err);
    *head = named == VM_VIEW_RASTER ? VM_RASTER : named == VM_VIEW_VECTOR ? VM_VECTOR : s->main;
    enum vm_head other = *head == VM_RASTER ? VM_VECTOR : VM_RASTER;
    if (named == VM_VIEW_BOTH && !crt_tube_has_figure(&s->monitor[*head].row, name) &&
        crt_tube_has_figure(&s->monitor[other].row, name))
        *head = other;
    return true;
}

/* Kinds and figures of input devices; *ours is false when the key is none of them. */
static bool set_input(struct inp_setup *setup, const char *name, const char *text, bool *ours,
                      struct crt_error *err)
{
    const char *unit;
    double value;
    bool ok = inp_setup_set_kind(setup, name, text, ours, err);
    if (*ours)
        return ok;
    struct crt_figure *figure = inp_setup_figure(setup, name, &unit, NULL);
    *ours = figure != NULL;
    if (!figure || !vm_figure_value(text, unit, &value, err))
        return false;
    *figure = (struct crt_figure){value, value, value, "set on the command line"};
    return inp_setup_check(setup, name, err);
}

static bool is_input(struct inp_setup *setup, const char *name)
{
    for (unsigned i = 0; inp_setup_key(i); i++)
        if (strcmp(inp_setup_key(i), name) == 0)
            return true;
    return inp_setup_figure(setup, name, NULL, NULL) != NULL;
}

/* KEY=VALUE, HEAD.KEY=VALUE. */
static bool set_one(struct vm_settings *s, const char *item, struct crt_error *err)
{
    char key[48];
    size_t n = strcspn(item, "=");
    if (item[n] != '=' || n == 0 || n >= sizeof key)
        return crt_fail(err, "'%.60s' is not KEY=VALUE, such as memory=16K", item);
    memcpy(key, item, n);
    key[n] = '\0';
    const char *text = item + n + 1, *name = key;
    unsigned heads = VM_VIEW_BOTH;
    double low, high;
    enum vm_head head = VM_VECTOR;
    struct crt_knobs knobs;
    if (strcmp(name, "memory") == 0)
        return set_memory(s, text, err);
    if (strcmp(name, "dpu.average") == 0)
        return set_average(s, text, err);
    if (strncmp(name, "vector.", 7) == 0 || strncmp(name, "raster.", 7) == 0) {
        heads = name[0] == 'v' ? VM_VIEW_VECTOR : VM_VIEW_RASTER;
        s->raster_asked |= heads == VM_VIEW_RASTER;
        name += 7;
        if (strcmp(name, "memory") == 0 || strcmp(name, "dpu.average") == 0 ||
            is_input(&s->setup, name))
            return crt_fail(err, "%s belongs to no head; leave out '%.7s'", name, key);
    }
    bool ours, ok = set_input(&s->setup, key, text, &ours, err);
    if (ours)
        return ok;
    if (knob_of(&knobs, name, &low, &high))
        return set_knob(s, heads, name, text, err);
    return head_for(s, heads, name, &head, err) && set_figure(&s->monitor[head], name, text, err);
}

bool vm_settings_set(struct vm_settings *s, const struct vm_list *set, struct crt_error *err)
{
    struct crt_error why;
    for (int i = 0; i < set->count; i++)
        if (!set_one(s, set->item[i], &why))
            return crt_fail(err, "--set: %.400s", why.text);
    for (int h = 0; h < VM_HEADS; h++)
        if (!crt_tube_check(&s->monitor[h].row, &why))
            return crt_fail(err, "--set: %.400s", why.text);
    return true;
}

/* ---- what is set --------------------------------------------------------------------------------
 */

/* The head whose monitor shows what a key stands at: as set_one() chooses it. */
static enum vm_head head_shown(const struct vm_settings *s, const char *key)
{
    enum vm_head head;
    struct crt_error err;
    const char *name = bare(key);
    unsigned named = name == key ? VM_VIEW_BOTH : key[0] == 'v' ? VM_VIEW_VECTOR : VM_VIEW_RASTER;
    return head_for(s, named, name, &head, &err) ? head
           : named == VM_VIEW_BOTH               ? s->main
           : named == VM_VIEW_RASTER             ? VM_RASTER
                                                 : VM_VECTOR;
}

bool vm_settings_value(const struct vm_settings *s, const char *key, struct vm_setting *value)
{
    double low, high;
    struct vm_monitor monitor = s->monitor[head_shown(s, key)];
    struct inp_setup setup = s->setup;
    const char *name = bare(key);
    *value = (struct vm_setting){0, "", NULL};
    const double *knob = knob_of(&monitor.knobs, name, &low, &high);
    const struct crt_figure *figure =
        knob ? NULL : crt_tube_figure(&monitor.row, name, &value->unit);
    if (!knob && !figure)
        figure = inp_setup_figure(&setup, key, &value->unit, NULL);
    if (strcmp(key, "memory") == 0)
        *value = (struct vm_setting){s->memory_bytes / 1024.0, "K", NULL};
    else if (strcmp(key, "dpu.average") == 0)
        *value = (struct vm_setting){(double)s->average_ps / (double)CRT_PS_PER_US, "us", NULL};
    else if (knob)
        value->number = *knob;
    else if (figure)
        value->number = figure->value;
    else
        return false;
    if (strcmp(value->unit, "1") == 0)
        value->unit = "";
    return true;
}
