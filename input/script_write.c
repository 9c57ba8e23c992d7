/* One act as a statement. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "input/keyboard.h"
#include "input/script_parts.h"

/* A statement being written. */
struct line {
    char *text;
    size_t length;
    bool possible; /* so far there is a statement for the act */
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
add(struct line *line, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    int n = vsnprintf(line->text + line->length, INP_STATEMENT_MOST - line->length, format, args);
    va_end(args);
    if (n >= 0 && (size_t)n < INP_STATEMENT_MOST - line->length)
        line->length += (size_t)n;
    else
        line->possible = false;
}

static void impossible(struct line *line)
{
    line->possible = false;
}

static void add_time(struct line *line, const char *before, uint64_t ps)
{
    char text[INP_TIME_TEXT];
    inp_time_write(ps, text);
    add(line, "%s%s", before, text);
}

static bool within(int32_t value, int32_t low, int32_t high)
{
    return value >= low && value <= high;
}

/* " 12.5" */
static void add_thousandths(struct line *line, int32_t value, int32_t low, int32_t high)
{
    if (!within(value, low, high)) {
        impossible(line);
        return;
    }
    unsigned magnitude = (unsigned)(value < 0 ? -value : value);
    unsigned rest = magnitude % 1000;
    int places = 3;
    for (; places > 0 && rest % 10 == 0; places--)
        rest /= 10;
    add(line, " %s%u", value < 0 ? "-" : "", magnitude / 1000);
    if (places)
        add(line, ".%0*u", places, rest);
}

static void add_coordinate(struct line *line, int32_t value)
{
    add_thousandths(line, value, -INP_FURTHEST, INP_FURTHEST);
}

static void add_name(struct line *line, const char *const *names, unsigned index)
{
    for (unsigned i = 0; i < index && *names; i++)
        names++;
    if (*names)
        add(line, " %s", *names);
    else
        impossible(line);
}

static void add_space(struct line *line, const struct inp_act *act)
{
    if (act->space == INP_MM)
        add(line, " mm");
    else if (act->space != INP_UNITS)
        impossible(line);
}

static void add_in(struct line *line, const struct inp_act *act)
{
    if (act->duration)
        add_time(line, " in ", act->duration);
}

/* ---- devices ----------------------------------------------------------------------------------- */

static void write_pen(struct line *line, const struct inp_act *act)
{
    add(line, " pen");
    add_name(line, inp_screen_names, act->screen);
    switch (act->verb) {
    case INP_MOVE:
        add(line, " move");
        add_coordinate(line, act->x);
        add_coordinate(line, act->y);
        add_space(line, act);
        add_in(line, act);
        break;
    case INP_PRESS:
        add(line, " down");
        break;
    case INP_RELEASE:
        add(line, " up");
        break;
    case INP_AWAY:
        add(line, " away");
        break;
    default:
        impossible(line);
    }
}

static void write_tablet(struct line *line, const struct inp_act *act)
{
    switch (act->verb) {
    case INP_MOVE:
        add(line, " tablet move");
        add_coordinate(line, act->x);
        add_coordinate(line, act->y);
        add_coordinate(line, act->z);
        add_in(line, act);
        break;
    case INP_PRESS:
    case INP_RELEASE:
        add(line, " tablet %s %u", act->verb == INP_PRESS ? "press" : "release", act->code);
        if (act->code >= INP_TABLET_BUTTONS)
            impossible(line);
        break;
    case INP_AWAY:
        add(line, " tablet away");
        break;
    default:
        impossible(line);
    }
}

static void write_touch(struct line *line, const struct inp_act *act)
{
    add(line, " touch");
    add_name(line, inp_screen_names, act->screen);
    if (act->verb == INP_AWAY) {
        add(line, " up");
        return;
    }
    if (act->verb != INP_MOVE)
        impossible(line);
    add_coordinate(line, act->x);
    add_coordinate(line, act->y);
    add_space(line, act);
    if (act->z != 0) {
        add(line, " force");
        add_thousandths(line, act->z, 1, INP_FORCE_MOST);
    }
    add_in(line, act);
}

static void write_mouse(struct line *line, const struct inp_act *act)
{
    add(line, " mouse");
    switch (act->verb) {
    case INP_MOVE:
        add(line, " move");
        add_coordinate(line, act->x);
        add_coordinate(line, act->y);
        add_in(line, act);
        break;
    case INP_PRESS:
    case INP_RELEASE:
        add(line, act->verb == INP_PRESS ? " press" : " release");
        add_name(line, inp_mouse_names, act->code);
        break;
    case INP_AWAY:
        add(line, " lift");
        break;
    case INP_BACK:
        add(line, " drop");
        break;
    default:
        impossible(line);
    }
}

/* ` as "q"`, unless the key makes this whatever is held. */
static void add_as(struct line *line, const struct inp_act *act)
{
    uint8_t c = act->character;
    bool always = inp_key_us(act->code, 0) == c;
    for (unsigned modifiers = 1; modifiers < 16; modifiers++)
        always = always && inp_key_us(act->code, modifiers) == c;
    if (always)
        return;
    if (c == 0)
        add(line, " as none");
    else if (c >= ' ' && c < 0x7F)
        add(line, c == '"' || c == '\\' ? " as \"\\%c\"" : " as \"%c\"", c);
    else if (c < 0x80)
        add(line, " as \"\\x%02x\"", c);
    else
        impossible(line);
}

static void write_key(struct line *line, const struct inp_act *act)
{
    const char *name = act->code ? inp_key_name(act->code) : INP_UNKNOWN_KEY;
    if (!name || (act->verb != INP_PRESS && act->verb != INP_RELEASE)) {
        impossible(line);
        return;
    }
    add(line, " key %s %s", act->verb == INP_PRESS ? "down" : "up", name);
    if (act->verb == INP_PRESS)
        add_as(line, act);
}

static void write_knob(struct line *line, const struct inp_act *act)
{
    int32_t low, high;
    add(line, " knob");
    add_name(line, inp_screen_names, act->screen);
    add_name(line, inp_knob_names, act->code);
    inp_knob_range(act->code, &low, &high);
    add_thousandths(line, act->x, low, high);
    if (act->verb != INP_TURN)
        impossible(line);
}

size_t inp_script_write(const struct inp_act *act, char text[INP_STATEMENT_MOST])
{
    static void (*const write[INP_DEVICES])(struct line *, const struct inp_act *) = {
        [INP_PEN] = write_pen,      [INP_TABLET] = write_tablet, [INP_TOUCH] = write_touch,
        [INP_KEYBOARD] = write_key, [INP_MOUSE] = write_mouse,   [INP_KNOB] = write_knob};
    struct line line = {text, 0, true};
    text[0] = '\0';
    add_time(&line, "at ", act->t);
    if (act->device < INP_DEVICES)
        write[act->device](&line, act);
    add(&line, "\n");
    if (act->device >= INP_DEVICES || act->t >= INP_SCRIPT_LATEST ||
        act->duration >= INP_SCRIPT_LATEST - act->t)
        line.possible = false;
    if (!line.possible)
        text[0] = '\0';
    return line.possible ? line.length : 0;
}
