#include "roms/monitor/menu.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

int menu_count(void)
{
    int count = 0;
    while (lessons[count] != NULL)
        count++;
    return count;
}

static bool of_gallery(int i)
{
    return strncmp(lessons[i]->title, "Gallery: ", 9) == 0;
}

/* The first of the gallery: the second column begins with it. */
static int chapters(void)
{
    int i = 0;
    while (lessons[i] != NULL && !of_gallery(i))
        i++;
    return i;
}

/* What the menu calls it: of the gallery without "Gallery: ", with a capital. */
static void label(char *text, size_t size, int i)
{
    const char *title = lessons[i]->title;
    const char *own = of_gallery(i) ? strchr(title, ' ') + 1 : title;
    snprintf(text, size, "%2d %c%s", i + 1, toupper((unsigned char)own[0]), own + 1);
}

static void entry(struct stage *s, const struct menu *menu, int i, float x, float y)
{
    char text[64];
    bool marked = i == menu->marked;
    label(text, sizeof text, i);
    stage_ink(s, marked ? INK_BRIGHT : of_gallery(i) ? INK_CYAN : INK_TEXT);
    stage_text(s, x, y, text);
    if (marked) {
        stage_ink(s, INK_ORANGE);
        stage_rectangle(s, x - 12, y - 14, 570, 42);
    }
}

static void column(struct stage *s, const struct menu *menu, int first, int end, float x,
                   const char *head)
{
    enum { TOP = 740, PITCH = 56 };
    stage_ink(s, INK_ORANGE);
    stage_text(s, x, TOP, head);
    for (int i = first; i < end; i++)
        entry(s, menu, i, x, (float)(TOP - PITCH * (i - first + 1)));
}

void menu_draw(const struct menu *menu, struct stage *s)
{
    int middle = chapters();
    stage_title(s, "kinescope");
    column(s, menu, 0, middle, 24, "LESSONS");
    column(s, menu, middle, menu_count(), 624, "GALLERY");
    stage_caption(s, "Cursor keys and Enter run a lesson, a number and Enter, too. Or type a "
                     "command: help lists them; Tab shows what was printed.");
}

static int moved(const struct menu *menu, int key)
{
    int middle = chapters(), count = menu_count(), at = menu->marked;
    switch (key) {
    case KEY_UP:
        return at > 0 ? at - 1 : count - 1;
    case KEY_DOWN:
        return at < count - 1 ? at + 1 : 0;
    case KEY_RIGHT:
        return at < middle && middle < count ? (at + middle < count ? at + middle : count - 1) : at;
    case KEY_LEFT:
        return at >= middle ? (at - middle < middle ? at - middle : middle - 1) : at;
    default:
        return -1;
    }
}

bool menu_key(struct menu *menu, int key)
{
    int to = moved(menu, key);
    if (to < 0)
        return false;
    menu->marked = to;
    return true;
}
