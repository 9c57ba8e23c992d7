/* show_keys.c — what keys and dropped files do, and the help that says so. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "emu/show.h"

#define SLOWEST 1e-6
#define FASTEST 10.0

static const char *const help[] = {
    "kinescope",
    "F1\tthis help",
    "F2\tvector head, raster head, both",
    "F4\tphotodiode and oscilloscope: a click places it; F4 puts it away",
    "F5\tpause, go on",
    "F6\tone refresh, then pause",
    "F7 F8\tslower, faster (Shift: by ten), down to a millionth: the beam on its way",
    "F9\twhat the mouse is: light pen, stylus, finger, mouse",
    "F11\tfull screen",
    "F12\tscreenshot",
    "Right Ctrl with",
    "click\twhy: what put the light there, with its share, word and line of the source",
    "A\twhat the photodiode sees: a point, a disc, the whole screen",
    "B C F\tchoose brightness, contrast or focus",
    "E\tchoose the shutter: auto, 1 us to 1 s",
    "G\tgain that follows the shutter, or as bright as it is",
    "Up Down\tturn what was chosen",
    "0\tall knobs neutral",
    "Left Right\tstep back, step forward, and pause",
    "W\tchoose what steps are: refresh, display word, instruction, beam stroke, scan line",
    "M\twhere the beam is, as text and mark: in slow motion, always, never",
    "L\tmean light of the last second: nothing flashes",
    "S\tskip the dark time to the next refresh (for slow motion)",
    "R\tload the file again (it is loaded when it changes, too)",
    "1\treal time again",
    "N P\tnext and previous program of the tour, page of the lesson",
    "T\tcaption of the lesson: shown, hidden",
    "Q\tquit",
    "Flicker as fast as this monitor's pictures cannot be seen here as on the tube: slow motion "
    "and the "
    "oscilloscope show it. Pictures that flash 3 to 30 times a second may harm people with "
    "photosensitive epilepsy: L, or run --no-flash, shows them without.",
    "A file dropped on the window is shown. All other keys belong to the program; the left Ctrl "
    "key "
    "with F1 to F12 is its F1 to F12.",
};

/* ---- time ---------------------------------------------------------------------------------------
 */

static void set_scale(struct vm_show *show, double scale)
{
    char text[64];
    show->scale = fmin(fmax(scale, SLOWEST), FASTEST);
    show->remainder_ps = 0;
    show->speed_since = 0;
    if (show->scale < 1)
        snprintf(text, sizeof text, "%.0f times slower than real time", 1 / show->scale);
    else
        snprintf(text, sizeof text, "%g x real time", show->scale);
    vm_show_say(show, text);
}

/* The next of 1, 2, 5, 10 … above or below, or ten times. */
static void change_scale(struct vm_show *show, int direction, bool by_ten)
{
    double decade = pow(10, floor(log10(show->scale) + 1e-9));
    double digit = round(show->scale / decade);
    if (by_ten)
        digit *= direction > 0 ? 10 : 0.1;
    else if (direction > 0)
        digit = digit < 2 ? 2 : digit < 5 ? 5 : 10;
    else
        digit = digit > 5 ? 5 : digit > 2 ? 2 : digit > 1 ? 1 : 0.5;
    set_scale(show, digit * decade);
}

static void toggle_pause(struct vm_show *show)
{
    show->paused = !show->paused;
    show->rom_since = vm_window_time();
    show->speed_since = 0;
    vm_show_say(show, show->paused ? "paused - F5 goes on, F6 shows one refresh" : "");
}

static void step(struct vm_show *show)
{
    show->paused = show->step = true;
}

/* ---- knobs --------------------------------------------------------------------------------------
 */

static double *knob_value(struct vm_show *show, const char **name)
{
    static const char *const names[] = {"brightness", "contrast", "focus"};
    double *const values[] = {&show->knobs.brightness, &show->knobs.contrast, &show->knobs.focus};
    *name = names[show->knob];
    return values[show->knob];
}

static void say_knob(struct vm_show *show)
{
    char text[96];
    const char *name;
    double value = *knob_value(show, &name);
    snprintf(text, sizeof text, "%s %.2f - Right Ctrl with Up, Down", name, value);
    vm_show_say(show, text);
}

/* The heads that are seen of any machine. */
static unsigned seen(const struct vm_show *show)
{
    unsigned heads = 0;
    for (int i = 0; i < show->sides; i++)
        heads |= (unsigned)show->side[i]->view_drawn;
    return heads;
}

/* Of the monitors that are looked at; they are turned together. */
static void set_knobs(struct vm_show *show)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (show->program->rig.tube[h] && (seen(show) & 1u << h))
            vm_show_turn(show, (enum vm_head)h);
}

static void turn_monitor(struct vm_show *show, int direction)
{
    static const double steps[] = {0.02, 0.05, 0.1}, low[] = {-1, 0, 0}, high[] = {1, 4, 4};
    const char *name;
    double *value = knob_value(show, &name);
    enum vm_knob k = show->knob;
    *value = round((*value + direction * steps[k]) / steps[k]) * steps[k];
    *value = fmin(fmax(*value, low[k]), high[k]);
    show->knobs_touched = true;
    set_knobs(show);
    vm_show_mark(show);
    say_knob(show);
}

static void turn_knob(struct vm_show *show, int direction)
{
    if (show->knob == VM_KNOB_SHUTTER)
        vm_show_turn_shutter(show, direction);
    else if (show->knob == VM_KNOB_GAIN)
        vm_show_turn_gain(show, direction);
    else
        turn_monitor(show, direction);
}

static void reset_knobs(struct vm_show *show)
{
    show->knobs = (struct crt_knobs){0, 1, 0};
    show->shutter = 0;
    show->gain = 0;
    show->gain_auto = false;
    show->knobs_touched = true;
    set_knobs(show);
    vm_show_mark(show);
    vm_show_say(show, "all knobs neutral");
}

/* ---- pictures -----------------------------------------------------------------------------------
 */

static void screenshot(struct vm_show *show)
{
    char name[64], text[192];
    struct crt_image image;
    struct crt_error err;
    if (!show->film_ready) {
        vm_show_say(show, "nothing has been shown yet");
        return;
    }
    do
        snprintf(name, sizeof name, "kinescope-%03d.png", ++show->shots);
    while (show->shots < 999 && access(name, F_OK) == 0);
    bool ok = vm_show_scope_save(show, name, &err) && vm_show_picture(show, &image, &err);
    if (ok) {
        ok = vm_picture_write(name, &image, show->program->input.name, &show->program->settings,
                              show->program->view_drawn, vm_show_frame(show, show->program), &err);
        crt_image_free(&image);
    }
    snprintf(text, sizeof text, "screenshot %s", name);
    vm_show_say(show, ok ? text : err.text);
}

/* ---- events -------------------------------------------------------------------------------------
 */

static void tour(struct vm_show *show, int direction)
{
    struct crt_error err;
    if (vm_show_turn_page(show, direction))
        return;
    if (!vm_show_tour(show, direction, &err))
        vm_show_say(show, err.text);
}

static void chord(struct vm_show *show, enum vm_key key)
{
    switch ((int)key) {
    case 'A':
        vm_show_scope_area(show);
        break;
    case 'B':
    case 'C':
    case 'F':
        show->knob = key == 'B'   ? VM_KNOB_BRIGHTNESS
                     : key == 'C' ? VM_KNOB_CONTRAST
                                  : VM_KNOB_FOCUS;
        say_knob(show);
        break;
    case 'E':
        show->knob = VM_KNOB_SHUTTER;
        vm_show_say_shutter(show);
        break;
    case 'G':
        show->knob = VM_KNOB_GAIN;
        vm_show_toggle_gain(show);
        break;
    case 'M':
        vm_show_next_where(show);
        break;
    case 'L':
        vm_show_toggle_flash(show);
        break;
    case VM_KEY_UP:
    case VM_KEY_DOWN:
        turn_knob(show, key == VM_KEY_UP ? 1 : -1);
        break;
    case VM_KEY_LEFT:
    case VM_KEY_RIGHT:
        vm_show_step(show, key == VM_KEY_RIGHT ? 1 : -1);
        break;
    case 'W':
        vm_show_next_unit(show);
        break;
    case '0':
        reset_knobs(show);
        break;
    case '1':
        set_scale(show, 1);
        break;
    case 'R':
        vm_show_reload(show, true);
        break;
    case 'S':
        show->skip = true;
        break;
    case 'N':
    case 'P':
        tour(show, key == 'N' ? 1 : -1);
        break;
    case 'T':
        vm_show_caption(show, !show->captioned);
        break;
    case 'Q':
        show->quit = true;
        break;
    default:
        break;
    }
}

static void function_key(struct vm_show *show, int f, unsigned modifiers)
{
    switch (f) {
    case 1:
        vm_hud_help(show->hud, !vm_hud_help_shown(show->hud), help, sizeof help / sizeof *help);
        break;
    case 2:
        vm_show_next_view(show);
        break;
    case 4:
        vm_show_scope_key(show);
        break;
    case 5:
        toggle_pause(show);
        break;
    case 6:
        step(show);
        break;
    case 7:
    case 8:
        change_scale(show, f == 8 ? 1 : -1, modifiers & VM_MOD_SHIFT);
        break;
    case 9:
        vm_show_next_hand(show);
        break;
    case 11:
        vm_window_set_full_screen(show->window, !vm_window_is_full_screen(show->window));
        break;
    case 12:
        screenshot(show);
        break;
    default:
        break;
    }
}

static void drop(struct vm_show *show, const char *path)
{
    struct crt_error err;
    if (vm_show_open(show, path, NULL, &err)) {
        show->touring = false;
        vm_show_caption(show, false);
    } else
        vm_hud_message(show->hud, err.text, vm_window_time(), 20);
}

/* A function key with the left Ctrl key is the program's, and its release whenever that comes. */
static bool is_guests(const struct vm_show *show, const struct vm_event *event)
{
    int f = (int)event->u.key.key - VM_KEY_F1;
    if (event->u.key.chord || f < 0 || f >= 12)
        return false;
    return event->u.key.action == VM_RELEASE ? show->held[KEYCODE_F1 + f]
                                             : (event->u.key.modifiers & VM_MOD_CONTROL) != 0;
}

void vm_show_event(struct vm_show *show, const struct vm_event *event)
{
    if (vm_show_page_event(show, event) || vm_show_why_event(show, event))
        return;
    switch (event->kind) {
    case VM_EVENT_CLOSE:
        show->quit = true;
        break;
    case VM_EVENT_DROP:
        drop(show, event->u.drop.path);
        break;
    case VM_EVENT_HOST_KEY:
        if (is_guests(show, event)) {
            vm_show_hand_event(show, event);
            break;
        }
        if (event->u.key.action == VM_RELEASE)
            break;
        if (event->u.key.key >= VM_KEY_F1 && event->u.key.key <= VM_KEY_F12)
            function_key(show, (int)event->u.key.key - VM_KEY_F1 + 1, event->u.key.modifiers);
        else if (event->u.key.chord)
            chord(show, event->u.key.key);
        break;
    default:
        vm_show_hand_event(show, event);
        break;
    }
}
