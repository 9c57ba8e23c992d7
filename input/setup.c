#include "input/setup.h"

#include <stddef.h>
#include <string.h>

struct row {
    const char *key, *unit;
    size_t offset; /* of the figure in struct inp_setup */
    struct crt_figure figure;
    const char *meaning;
};

#define ROW(device, field, unit, value, low, high, meaning, source)                                \
    {#device "." #field,                                                                           \
     unit,                                                                                         \
     offsetof(struct inp_setup, device.field),                                                     \
     {value, low, high, source},                                                                   \
     meaning},

#define PEN_ROW(...)      ROW(pen, __VA_ARGS__)
#define TABLET_ROW(...)   ROW(tablet, __VA_ARGS__)
#define TOUCH_ROW(...)    ROW(touch, __VA_ARGS__)
#define MOUSE_ROW(...)    ROW(mouse, __VA_ARGS__)
#define KEYBOARD_ROW(...) ROW(keyboard, __VA_ARGS__)

/* clang-format off */
static const struct row rows[] = {
    INP_PEN_FIGURES(PEN_ROW)
    INP_TABLET_FIGURES(TABLET_ROW)
    INP_TOUCH_FIGURES(TOUCH_ROW)
    INP_MOUSE_FIGURES(MOUSE_ROW)
    INP_KEYBOARD_FIGURES(KEYBOARD_ROW)
};
/* clang-format on */

enum { ROWS = sizeof rows / sizeof *rows };

static struct crt_figure *figure_at(struct inp_setup *setup, size_t offset)
{
    return (struct crt_figure *)(void *)((char *)setup + offset);
}

void inp_setup_default(struct inp_setup *setup)
{
    memset(setup, 0, sizeof *setup);
    setup->has_pen = setup->has_keyboard = 1;
    setup->tablet.kind = TABLET_ELECTRICAL;
    setup->touch.kind = TOUCH_OPTICAL;
    setup->touch.screen = INP_RASTER;
    setup->mouse.kind = MOUSE_MECHANICAL;
    for (int i = 0; i < ROWS; i++)
        *figure_at(setup, rows[i].offset) = rows[i].figure;
}

/* ---- doped screens ------------------------------------------------------------------------------
 */

static const struct {
    const char *tube, *phosphor;
    struct crt_figure infrared;
} doped[] = {
    {"VR17",
     "P39",
     {0.001, 0.0003, 0.01,
      "DEC EK-VT11-TM-001: the screen is doped for the pen; how strong: estimate"}},
};

void inp_setup_screen(struct inp_setup *setup, const char *tube, const char *phosphor)
{
    for (size_t i = 0; i < sizeof doped / sizeof *doped; i++)
        if (strcmp(doped[i].tube, tube) == 0 && strcmp(doped[i].phosphor, phosphor) == 0)
            setup->pen.infrared = doped[i].infrared;
}

/* ---- kinds --------------------------------------------------------------------------------------
 */

static const char *const connected[] = {"none", "connected", NULL};
static const char *const tablets[] = {"none", "electrical", "sonic", "resistive", NULL};
static const char *const panels[] = {"none", "optical", "sonic", "electrical", NULL};
static const char *const mice[] = {"none", "mechanical", "optical", NULL};
static const char *const screens[] = {"vector", "raster", NULL};

static const struct {
    const char *key;
    const char *const *names;
    size_t offset; /* of the number of the kind, unsigned, in struct inp_setup */
} kinds[] = {{"pen", connected, offsetof(struct inp_setup, has_pen)},
             {"keyboard", connected, offsetof(struct inp_setup, has_keyboard)},
             {"tablet", tablets, offsetof(struct inp_setup, tablet.kind)},
             {"touch", panels, offsetof(struct inp_setup, touch.kind)},
             {"mouse", mice, offsetof(struct inp_setup, mouse.kind)},
             {"touch.screen", screens, offsetof(struct inp_setup, touch.screen)}};

enum { KINDS = sizeof kinds / sizeof *kinds };

static bool no_such_kind(const char *key, const char *value, const char *const *names,
                         struct crt_error *err)
{
    char list[80] = "";
    size_t n = 0;
    for (int i = 0; names[i]; i++) {
        const char *between = i == 0 ? "" : names[i + 1] ? ", " : " or ";
        n += strlen(between) + strlen(names[i]);
        if (n < sizeof list)
            strcat(strcat(list, between), names[i]);
    }
    return crt_fail(err, "%s=%.40s: there is no such kind; give %s", key, value, list);
}

bool inp_setup_set_kind(struct inp_setup *setup, const char *key, const char *value, bool *ours,
                        struct crt_error *err)
{
    *ours = true;
    for (int k = 0; k < KINDS; k++) {
        if (strcmp(kinds[k].key, key) != 0)
            continue;
        for (unsigned i = 0; kinds[k].names[i]; i++)
            if (strcmp(kinds[k].names[i], value) == 0) {
                memcpy((char *)setup + kinds[k].offset, &i, sizeof i);
                return true;
            }
        return no_such_kind(key, value, kinds[k].names, err);
    }
    *ours = false;
    return false;
}

/* ---- figures ------------------------------------------------------------------------------------
 */

static const struct row *row_of(const char *key)
{
    for (int i = 0; i < ROWS; i++)
        if (strcmp(rows[i].key, key) == 0)
            return &rows[i];
    return NULL;
}

struct crt_figure *inp_setup_figure(struct inp_setup *setup, const char *key, const char **unit,
                                    const char **meaning)
{
    const struct row *row = row_of(key);
    if (!row)
        return NULL;
    if (unit)
        *unit = row->unit;
    if (meaning)
        *meaning = row->meaning;
    return figure_at(setup, row->offset);
}

const char *inp_setup_key(unsigned index)
{
    if (index < KINDS)
        return kinds[index].key;
    index -= KINDS;
    return index < ROWS ? rows[index].key : NULL;
}

const char *const *inp_setup_kinds(unsigned index)
{
    return index < KINDS ? kinds[index].names : NULL;
}

bool inp_setup_check(const struct inp_setup *setup, const char *key, struct crt_error *err)
{
    const struct row *row = row_of(key);
    struct inp_setup copy = *setup;
    double value = figure_at(&copy, row->offset)->value;
    if (value >= row->figure.low && value <= row->figure.high)
        return true;
    return crt_fail(err, "%s=%g is out of range: %s, %g to %g %s", key, value, row->meaning,
                    row->figure.low, row->figure.high,
                    strcmp(row->unit, "1") == 0 ? "" : row->unit);
}

/* ---- what is there ------------------------------------------------------------------------------
 */

bool inp_setup_has(const struct inp_setup *setup, unsigned heads, const struct inp_act *act)
{
    bool button = act->verb == INP_PRESS || act->verb == INP_RELEASE;
    bool head = heads >> act->screen & 1;
    switch (act->device) {
    case INP_PEN:
        return setup->has_pen && head;
    case INP_TABLET:
        return setup->tablet.kind != TABLET_NONE &&
               !(button && act->code >= setup->tablet.buttons.value);
    case INP_TOUCH:
        return setup->touch.kind != TOUCH_NONE && head && act->screen == setup->touch.screen;
    case INP_KEYBOARD:
        return setup->has_keyboard;
    case INP_MOUSE:
        return setup->mouse.kind != MOUSE_NONE;
    case INP_KNOB:
        return head;
    default:
        return false;
    }
}
