#include "roms/monitor/shell.h"

#include <stdio.h>

#include "roms/monitor/command.h"
#include "roms/monitor/editor.h"
#include "roms/monitor/keys.h"
#include "roms/monitor/lesson_run.h"
#include "roms/monitor/menu.h"
#include "roms/monitor/transcript.h"

enum page { PAGE_MENU, PAGE_PICTURE, PAGE_TRANSCRIPT };

struct shell {
    struct monitor *monitor;
    struct editor editor;
    struct menu menu;
    enum page page, under; /* shown; the one that Tab comes back to */
    unsigned back;         /* pages of the transcript before the last */
};

static void draw_menu(struct shell *s)
{
    stage_begin(&s->monitor->stage);
    menu_draw(&s->menu, &s->monitor->stage);
    stage_end(&s->monitor->stage);
    s->page = PAGE_MENU;
}

/* The page under it stays in store, where stage_flip finds it, until one turns pages here. */
static void draw_transcript(struct shell *s, unsigned back)
{
    struct stage *stage = &s->monitor->stage;
    char caption[80];
    stage_begin(stage);
    unsigned pages = transcript_draw(stage, back);
    s->back = back < pages ? back : pages;
    snprintf(caption, sizeof caption, "Page %u of %u. Page Up and Page Down turn, Tab goes back.",
             pages - s->back + 1, pages + 1);
    stage_title(stage, "What was printed");
    stage_caption(stage, pages > 0 ? caption : "Tab goes back.");
    stage_end(stage);
    if (s->page != PAGE_TRANSCRIPT)
        s->under = s->page;
    else
        s->under = PAGE_MENU; /* the other store holds a page of this */
    s->page = PAGE_TRANSCRIPT;
}

/* Page Up and Page Down: true when the key was one of them. */
static bool turn_page(struct shell *s, int key)
{
    unsigned now = s->page == PAGE_TRANSCRIPT ? s->back : 0;
    if (key == KEY_PAGE_UP)
        draw_transcript(s, now + 1);
    else if (key == KEY_PAGE_DOWN)
        draw_transcript(s, now > 0 ? now - 1 : 0);
    return key == KEY_PAGE_UP || key == KEY_PAGE_DOWN;
}

static void toggle(struct shell *s)
{
    if (s->page != PAGE_TRANSCRIPT) {
        draw_transcript(s, 0);
        return;
    }
    if (s->under == PAGE_MENU) {
        draw_menu(s);
        return;
    }
    stage_flip(&s->monitor->stage);
    s->page = s->under;
}

static void run_lesson(struct shell *s, int number)
{
    s->menu.marked = number;
    lesson_run(s->monitor, lessons[number]);
    draw_menu(s);
}

/* The number of a lesson, from 1, and nothing else; 0: something else. */
static int lesson_number(const char *line)
{
    int number = 0;
    for (; *line >= '0' && *line <= '9' && number <= menu_count(); line++)
        number = 10 * number + *line - '0';
    return *line == '\0' && number <= menu_count() ? number : 0;
}

static void run_command(struct shell *s)
{
    struct stage *stage = &s->monitor->stage;
    unsigned pictures = stage->pictures, lines = transcript_count();
    s->monitor->left_lesson = false;
    command_line(s->monitor, s->editor.line);
    if (s->monitor->left_lesson)
        draw_menu(s);
    else if (stage->pictures != pictures)
        s->page = PAGE_PICTURE;
    else if (transcript_count() != lines)
        draw_transcript(s, 0);
}

static void enter(struct shell *s, int key)
{
    int number = lesson_number(s->editor.line);
    if (number > 0)
        run_lesson(s, number - 1);
    else if (s->editor.length > 0)
        run_command(s);
    else if (s->page != PAGE_MENU)
        draw_menu(s);
    else if (key == KEYS_ENTER)
        run_lesson(s, s->menu.marked);
    editor_begin(&s->editor, &s->monitor->stage);
}

/* A key that moves the mark of the menu while nothing is typed. */
static bool menu_takes(struct shell *s, int key)
{
    if (s->page != PAGE_MENU || s->editor.length > 0 || !menu_key(&s->menu, key))
        return false;
    draw_menu(s);
    return true;
}

void shell_run(struct monitor *monitor)
{
    static struct shell shell;
    shell = (struct shell){.monitor = monitor};
    draw_menu(&shell);
    editor_begin(&shell.editor, &monitor->stage);
    for (;;) {
        int key = keys_next(KEYS_FOREVER);
        if (menu_takes(&shell, key))
            continue;
        enum editor_event event = editor_key(&shell.editor, &monitor->stage, key);
        if (event == EDITOR_ENTERED)
            enter(&shell, key);
        else if (event == EDITOR_OTHER && key == KEYS_INPUT_END)
            return;
        else if (event == EDITOR_OTHER && key == '\t')
            toggle(&shell);
        else if (event == EDITOR_OTHER && turn_page(&shell, key))
            continue;
        else if (event == EDITOR_OTHER && key == KEYS_ESCAPE)
            draw_menu(&shell);
    }
}
