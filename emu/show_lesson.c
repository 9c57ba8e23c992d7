/* show_lesson.c — a lesson in the window: pages one after the other, their captions, the warning before what
 * flashes. */
#include <stdio.h>

#include "emu/show.h"

#define KEYS "Right Ctrl N P: pages, T: caption"

static const struct vm_show_page *page_of(const struct vm_show *show)
{
    return &show->desc->lesson->page[show->page];
}

int vm_show_most_sides(const struct vm_show_desc *desc)
{
    int most = desc->options[1] ? 2 : 1;
    for (int i = 0; desc->lesson && i < desc->lesson->count; i++)
        if (desc->lesson->page[i].desc.options[1])
            most = 2;
    return most;
}

/* ---- what stands over the program -------------------------------------------------------------- */

static void title_of(const struct vm_show *show, char *text, size_t size)
{
    const struct vm_show_page *page = page_of(show);
    snprintf(text, size, "%.120s  %d of %d", page->title, show->page + 1,
             show->desc->lesson->count);
}

static void show_warning(struct vm_show *show)
{
    char text[1100];
    snprintf(text, sizeof text,
             "%.700s\n\nF5 or Right Ctrl N goes on. Right Ctrl L goes on with mean light, which "
             "does not flash. Right Ctrl P goes back, Q ends.",
             show->desc->lesson->warning);
    const struct vm_hud_slide slide = {
        .title = "Before the next page", .text = text, .whole = true};
    vm_hud_slide(show->hud, &slide);
}

static void show_slide(struct vm_show *show)
{
    const struct vm_show_page *page = page_of(show);
    char title[160];
    title_of(show, title, sizeof title);
    const struct vm_hud_slide slide = {.title = title,
                                       .hint = KEYS,
                                       .text = page->caption,
                                       .whole = page->still != NULL,
                                       .large = show->desc->lesson->projector,
                                       .picture = page->still};
    bool shown = show->captioned || page->still;
    if (show->warning)
        show_warning(show);
    else
        vm_hud_slide(show->hud, shown ? &slide : NULL);
}

void vm_show_caption(struct vm_show *show, bool shown)
{
    if (!show->desc->lesson)
        return;
    show->captioned = shown;
    show_slide(show);
}

/* ---- pages ------------------------------------------------------------------------------------- */

/* What the page's command says of how to look, and what nobody has touched on it. Mean light that was asked for by
 * hand stays. */
static void set_looks(struct vm_show *show, const struct vm_show_desc *before)
{
    const struct vm_show_desc *now = show->desc;
    show->no_flash = now->no_flash || (show->no_flash && !before->no_flash);
    show->scale = now->scale;
    show->shutter = now->shutter;
    show->gain = 0;
    show->gain_auto = show->paused = show->step = show->skip = false;
}

static void cover(struct vm_show *show)
{
    const struct vm_show_page *page = page_of(show);
    show->warning = page->flashes && !page->still && !show->no_flash && !show->warning_known;
    show->warning_known |= show->warning;
    show->covered = show->warning || page->still;
    show->warned |= page->flashes && show->warning_known; /* once is enough */
    vm_hud_message(show->hud, NULL, 0, 0);                /* of the page before */
    if (show->covered)
        vm_hud_status(show->hud, NULL);
    show_slide(show);
}

bool vm_show_page(struct vm_show *show, int page, struct crt_error *err)
{
    const struct vm_show_desc *before = show->desc;
    bool touched = show->knobs_touched;
    char title[160], name[200];
    vm_show_scope_close(show); /* while there are the sides it is of */
    show->desc = &before->lesson->page[page].desc;
    show->sides = show->desc->options[1] ? 2 : 1;
    show->knobs_touched = false;
    show->begins = true;
    if (!vm_show_open(show, show->desc->path, NULL, err)) {
        show->desc = before;
        show->sides = before->options[1] ? 2 : 1;
        show->knobs_touched = touched;
        show->begins = false;
        return false;
    }
    show->page = page;
    show->captioned = true;
    set_looks(show, before);
    cover(show);
    title_of(show, title, sizeof title);
    snprintf(name, sizeof name, "%s - kinescope", title);
    vm_window_set_title(show->window, name);
    return true;
}

bool vm_show_turn_page(struct vm_show *show, int step)
{
    struct crt_error err;
    char text[600];
    if (!show->desc->lesson)
        return false;
    int page = show->page + step;
    if (page < 0 || page >= show->desc->lesson->count)
        vm_show_say(show, page < 0 ? "this is the first page"
                                   : "this was the last page - Right Ctrl Q ends");
    else if (!vm_show_page(show, page, &err)) {
        snprintf(text, sizeof text, "page %d cannot be shown: %s", page + 1, err.text);
        vm_hud_message(show->hud, text, vm_window_time(), 20);
    }
    return true;
}

/* ---- while nothing runs ------------------------------------------------------------------------ */

static void go_on(struct vm_show *show, bool calm)
{
    show->no_flash |= calm;
    show->status_since = 0;
    show->warning = show->covered = false;
    show_slide(show);
}

static void warning_key(struct vm_show *show, enum vm_key key, bool chord)
{
    if (key == VM_KEY_F1 + 4 || (chord && key == 'N'))
        go_on(show, false);
    else if (chord && key == 'L')
        go_on(show, true);
    else if (chord && key == 'P' && show->page > 0) {
        show->warning_known = false; /* nobody has agreed */
        vm_show_turn_page(show, -1);
    }
}

bool vm_show_page_event(struct vm_show *show, const struct vm_event *event)
{
    if (!show->covered)
        return false;
    if (event->kind == VM_EVENT_CLOSE || event->kind == VM_EVENT_RESIZE ||
        event->kind == VM_EVENT_FOCUS)
        return false;
    if (event->kind != VM_EVENT_HOST_KEY || event->u.key.action != VM_PRESS)
        return true;
    enum vm_key key = event->u.key.key;
    bool chord = event->u.key.chord;
    if (key == VM_KEY_F1 || key == VM_KEY_F1 + 10 || (chord && key == 'Q'))
        return false;
    if (show->warning)
        warning_key(show, key, chord);
    else if (chord && (key == 'N' || key == 'P'))
        vm_show_turn_page(show, key == 'N' ? 1 : -1);
    return true;
}
