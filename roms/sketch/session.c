#include "roms/sketch/session.h"

#include <stdio.h>
#include <string.h>

#include "roms/bsp/console.h"
#include "roms/bsp/timer.h"
#include "roms/geometry/scalar.h"

enum { PATIENCE = TIMER_HZ / 500, QUIET = TIMER_HZ / 1000, ROUND = TIMER_HZ / 4 };

/* ---- saving and loading ---------------------------------------------------------------------- */

static void print_line(void *ctx, const char *line)
{
    (void)ctx;
    console_write(line);
    console_put('\n');
}

static void save(struct session *s)
{
    view_say(&s->view, "Saving: the text goes to the console.");
    console_write("---- sketch: begin ----\n");
    text_write(&s->tools.drawing.now, print_line, NULL);
    console_write("---- sketch: end ----\n");
    tools_say(&s->tools, "The console has the drawing's text.");
}

static void begin_load(struct session *s)
{
    tools_command(&s->tools, COMMAND_ESCAPE);
    tools_say(&s->tools, "Load: lines from the console up to \"end\". Escape leaves off.");
    text_begin(&s->reader);
    s->loading = true;
    s->returned = false;
    s->length = 0;
    console_write("load: waiting for lines up to \"end\"\n");
}

static void end_load(struct session *s)
{
    struct text_reader *r = &s->reader;
    char sentence[TOOLS_MESSAGE + 30];
    s->loading = false;
    if (r->failed) {
        snprintf(sentence, sizeof sentence, "Line %d: %s", r->error_line, r->error);
    } else {
        tools_replace(&s->tools, &r->state);
        snprintf(sentence, sizeof sentence, "Loaded: %d points, %d figures.", r->points,
                 r->figures);
    }
    tools_say(&s->tools, sentence);
    console_write("load: ");
    console_write(sentence);
    console_write(r->failed ? "; the drawing is as it was\n" : "\n");
}

static void leave_off_load(struct session *s, const char *why)
{
    s->loading = false;
    typed_rest_begin(&s->rest, timer_now());
    tools_say(&s->tools, why);
    console_write("load: ");
    console_write(why);
    console_write(" The drawing is as it was.\n");
}

static void take_line(struct session *s)
{
    s->line[s->length] = '\0';
    if (s->length > TEXT_LINE)
        text_too_long(&s->reader);
    else
        text_line(&s->reader, s->line);
    s->length = 0;
    if (s->reader.done)
        end_load(s);
}

static void take_byte(struct session *s, int byte)
{
    bool returned = s->returned;
    s->returned = byte == '\r';
    if (byte == CONSOLE_EOF)
        leave_off_load(s, "The text ended before \"end\".");
    else if (byte == '\r' || (byte == '\n' && !returned))
        take_line(s);
    else if (byte != '\n' && s->length <= TEXT_LINE)
        s->line[s->length++] = byte == '\0' ? '?' : (char)byte;
}

/* What comes without a pause: nothing is drawn meanwhile. Of text without an end not all: somebody may
 * press Escape. */
static void load(struct session *s)
{
    uint64_t begin = timer_now(), last = begin;
    for (uint64_t now = begin; s->loading && now - last < QUIET && now - begin < ROUND;
         now = timer_now()) {
        int byte = console_poll();
        if (byte < 0)
            continue;
        take_byte(s, byte);
        last = now;
    }
}

/* ---- commands -------------------------------------------------------------------------------- */

static void command(struct session *s, enum command command)
{
    if (command == COMMAND_SAVE)
        save(s);
    else if (command == COMMAND_LOAD)
        begin_load(s);
    else if (command == COMMAND_HELP)
        s->helping = true;
    else if (command != COMMAND_NONE)
        tools_command(&s->tools, command);
    if (s->helping)
        view_help(&s->view);
}

static void end_help(struct session *s)
{
    s->helping = false;
    view_draw(&s->view, &s->tools);
}

/* A key; true: it was one that does something. */
static bool choose(struct session *s, enum command chosen)
{
    if (s->helping)
        end_help(s);
    else if (!s->loading)
        command(s, chosen);
    else if (chosen == COMMAND_ESCAPE)
        leave_off_load(s, "Loading was left off.");
    return chosen != COMMAND_NONE;
}

/* Keys that are held: steps go on, but nothing is switched on and off. */
static bool repeats(enum command chosen)
{
    return chosen >= COMMAND_TURN_LEFT && chosen <= COMMAND_REDO;
}

static bool take_keys(struct session *s)
{
    struct key_event key;
    bool any = false;
    while (key_take(&key)) {
        s->shift = key.code == KEYCODE_SHIFT ? !key.up : (key.modifiers & KEYMOD_SHIFT) != 0;
        any = true;
        bool modifier = key.code >= KEYCODE_SHIFT && key.code <= KEYCODE_SUPER;
        enum command chosen = menu_key(&key);
        if (!key.up && !modifier && (!key.repeat || repeats(chosen)))
            choose(s, chosen);
    }
    if (!key_lost())
        return any;
    s->shift = false; /* it may have been let go */
    tools_say(&s->tools, "Keys came faster than they could be taken: some are lost.");
    return true;
}

static bool take_console(struct session *s)
{
    if (s->loading) {
        load(s);
        return !s->loading;
    }
    int byte = console_poll();
    if (typed_rest_takes(&s->rest, byte, timer_now()))
        return false;
    return byte >= 0 && choose(s, menu_letter((unsigned)byte));
}

/* ---- pointing -------------------------------------------------------------------------------- */

static struct pointing pointing_at(const struct session *s, struct point2 p)
{
    float x = scalar_clamp(p.x, 0, AREA_RIGHT), y = scalar_clamp(p.y, AREA_BOTTOM, AREA_TOP);
    return (struct pointing){.at = place_of_units(x, y),
                             .inside = x == p.x && y == p.y,
                             .pressed = s->pointer.pressed,
                             .upright = s->shift};
}

static void press(struct session *s)
{
    struct point2 at = s->pointer.pressed_at;
    struct pointing pointing = pointing_at(s, at);
    enum command chosen = menu_at(at);
    pointing.pressed = pointing.pressed_now = true;
    if (s->helping)
        end_help(s);
    else if (s->loading)
        leave_off_load(s, "Loading was left off.");
    else if (chosen != COMMAND_NONE)
        command(s, chosen);
    else
        tools_point(&s->tools, &pointing);
}

static void release(struct session *s)
{
    struct pointing pointing = pointing_at(s, s->pointer.released_at);
    pointing.pressed = false;
    pointing.released_now = true;
    tools_point(&s->tools, &pointing);
}

static bool take_pointer(struct session *s)
{
    struct pointer *p = &s->pointer;
    if (light_pen_poll(&s->view.light_pen, p) && !s->helping)
        view_draw(&s->view, &s->tools);
    if (!pointer_poll(p))
        return false;
    if (p->pressed_now)
        press(s);
    if (p->released_now)
        release(s);
    if (!p->pressed_now && !p->released_now) {
        struct pointing pointing = pointing_at(s, p->at);
        tools_point(&s->tools, &pointing);
    }
    /* Other buttons, as Escape: they end a polyline. */
    if (p->buttons != 0 && s->tools.phase != PHASE_IDLE)
        tools_command(&s->tools, COMMAND_ESCAPE);
    return true;
}

/* ---- rounds ---------------------------------------------------------------------------------- */

_Noreturn void session_run(struct session *s)
{
    view_open(&s->view);
    tools_begin(&s->tools);
    pointer_open(&s->pointer, &s->view.stage);
    if (input_present() & INPUT_BIT_PEN_RASTER)
        pointer_pen_field(&s->pointer, true);
    keyboard_on(false);
    view_draw(&s->view, &s->tools);
    for (;;) {
        bool changed = take_pointer(s);
        changed |= take_keys(s);
        changed |= take_console(s);
        if (changed && !s->helping && !s->loading)
            view_show(&s->view, &s->tools, s->pointer.at, s->pointer.near);
        else if (s->loading)
            view_say(&s->view, s->tools.message);
        else
            timer_sleep(PATIENCE);
    }
}
