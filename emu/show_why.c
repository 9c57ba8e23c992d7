/* show_why.c — Right Ctrl with a click: what put the light there, as a panel over the picture at rest. */
#include <stdlib.h>
#include <string.h>

#include "emu/lab/why_text.h"
#include "emu/plain.h"
#include "emu/show.h"

#define COLUMNS 56
#define LINES   24
#define MARK    6.0  /* pixels */
#define LEAST   0.01 /* smaller shares are summed up */

struct lines {
    char *line[LINES];
    size_t count;
};

static void keep(void *ctx, const char *line)
{
    struct lines *l = ctx;
    char text[200];
    if (l->count == LINES)
        return;
    vm_plain(line, text, sizeof text);
    l->line[l->count] = strdup(text);
    l->count += l->line[l->count] != NULL;
}

static void show_answer(struct vm_show *show, const struct vm_shown *p, const struct vm_why *why,
                        bool lower)
{
    struct lines lines = {.count = 0};
    struct vm_source_lines *source = NULL;
    if (p->input.has_firmware)
        source = vm_source_lines_open((const uint8_t *)p->input.image, p->input.image_size);
    const struct vm_why_text text = {.names = vm_why_names_of(&p->input, source),
                                     .columns = COLUMNS,
                                     .most = LINES - 2,
                                     .least = LEAST};
    vm_why_lines(why, &text, keep, &lines);
    keep(&lines, "");
    keep(&lines, "Any key closes this; F5 goes on.");
    vm_hud_help_side(show->hud, lower ? VM_HUD_TOP : VM_HUD_BOTTOM);
    vm_hud_help(show->hud, true, (const char *const *)lines.line, lines.count);
    show->why_shown = true;
    for (size_t i = 0; i < lines.count; i++)
        free(lines.line[i]);
    vm_source_lines_free(source);
}

static void ask(struct vm_show *show, double x, double y)
{
    struct vm_spot spot = vm_show_spot(show, x, y);
    struct vm_shown *p = show->side[spot.side];
    struct vm_why why;
    struct crt_error err;
    int width, height;
    if (!spot.on) {
        vm_show_say(show, "there is no screen");
        return;
    }
    show->paused = true;
    show->speed_since = 0;
    if (!p->history) {
        vm_show_say(show, p->input.is_recording ? "a recording has no program that put light there"
                                                : "there is no memory to remember the run");
        return;
    }
    const struct vm_why_desc desc = {
        .settings = &p->settings,
        .input = &p->input,
        .place = vm_why_at_mm(p->rig.machine, spot.head, spot.x_mm, spot.y_mm)};
    if (!vm_why_past(&why, &desc, &p->rig, p->history, &err)) {
        vm_show_say(show, err.text);
        return;
    }
    vm_window_size(show->window, &width, &height);
    show_answer(show, p, &why, y > height / 2.0);
    show->why_side = spot.side;
    show->why_head = spot.head;
    show->why_x_mm = spot.x_mm;
    show->why_y_mm = spot.y_mm;
    vm_why_free(&why);
}

void vm_show_why_close(struct vm_show *show)
{
    if (!show->why_shown)
        return;
    show->why_shown = false;
    vm_hud_help(show->hud, false, NULL, 0);
    vm_hud_help_side(show->hud, VM_HUD_MIDDLE);
}

bool vm_show_why_event(struct vm_show *show, const struct vm_event *event)
{
    bool key = event->kind == VM_EVENT_HOST_KEY || event->kind == VM_EVENT_GUEST_KEY;
    bool pressed = key ? event->u.key.action == VM_PRESS
                       : event->kind == VM_EVENT_BUTTON && event->u.button.pressed;
    bool asks = event->kind == VM_EVENT_BUTTON && event->u.button.chord;
    if (!asks && !(show->why_shown && pressed))
        return false;
    if (pressed)
        vm_show_why_close(show);
    if (asks && pressed)
        ask(show, event->x, event->y);
    return asks || event->kind == VM_EVENT_GUEST_KEY;
}

void vm_show_mark_asked(struct vm_show *show)
{
    double x = 0, y = 0, pitch;
    bool there =
        show->why_shown && vm_show_window_place(show, show->why_side, (int)show->why_head,
                                                show->why_x_mm, show->why_y_mm, &x, &y, &pitch);
    vm_hud_mark(show->hud, VM_MARK_ASKED, x, y, there ? MARK : 0);
}
