#include "roms/spline/menu.h"

#include <stddef.h>
#include <string.h>

enum { LEFT = 968, WIDTH = 226, TOP = 790, PITCH = 39, HEIGHT = 34, GAP = 12 };

/* `gaps`: groups before it. */
static const struct item {
    char key;
    int gaps;
    const char *label;
} items[] = {
    {'b', 0, "Bezier"},  {'p', 0, "pieces"}, {'n', 0, "natural"},   {'s', 0, "B-spline"},
    {'c', 1, "closed"},  {'k', 1, NULL},     {'j', 1, NULL},        {'f', 1, "free handle"},
    {'g', 2, "polygon"}, {'h', 2, "hull"},   {'t', 2, "at t"},      {'m', 2, "comb"},
    {'a', 3, "add"},     {'x', 3, "delete"}, {'e', 3, "erase all"}, {'u', 3, "undo"},
    {'r', 3, "redo"},    {'w', 3, "write"},  {'l', 3, "load"},
};
enum { ITEMS = sizeof items / sizeof *items };

static float bottom_of(int item)
{
    return (float)(TOP - HEIGHT - item * PITCH - items[item].gaps * GAP);
}

int menu_item_at(struct vector3 at)
{
    for (int i = 0; i < ITEMS; i++)
        if (at.x >= LEFT && at.x <= LEFT + WIDTH && at.y >= bottom_of(i) &&
            at.y <= bottom_of(i) + HEIGHT)
            return i;
    return -1;
}

int menu_key(int item)
{
    return items[item].key;
}

/* ---- what it shows ------------------------------------------------------------------------------- */

static const char *label_of(const struct editor *e, const struct item *item)
{
    static const char *const knots[] = {"knots equal", "knots chord", "knots root"};
    static const char *const joints[] = {"joint C1", "joint G1", "corner"};
    if (item->key == 'k')
        return knots[e->model.parameter];
    if (item->key == 'j')
        return e->chosen >= 0 ? joints[e->model.point[e->chosen].joint] : "joint";
    return item->label;
}

static bool holds(const struct editor *e, char key)
{
    static const char kinds[] = "bpns";
    switch (key) {
    case 'c':
        return e->model.closed;
    case 'g':
        return e->polygon;
    case 'h':
        return e->hull;
    case 't':
        return e->construction;
    case 'm':
        return e->comb;
    default:
        return kinds[e->model.kind] == key;
    }
}

/* Whether it would change anything. */
static bool useful(const struct editor *e, char key)
{
    switch (key) {
    case 'k':
        return e->model.kind == MODEL_NATURAL;
    case 'j':
    case 'f':
        return e->model.kind == MODEL_PIECES && e->chosen >= 0;
    case 'x':
        return e->chosen >= 0;
    case 'u':
        return e->history.back > 0;
    case 'r':
        return e->history.forth > 0;
    default:
        return true;
    }
}

static void draw_item(const struct editor *e, struct stage *s, int i)
{
    char key[2] = {items[i].key, '\0'};
    float y = bottom_of(i);
    bool on = holds(e, items[i].key), use = useful(e, items[i].key);
    enum ink ink = !use ? INK_GRID : on ? INK_YELLOW : INK_TEXT;
    stage_ink(s, on ? INK_YELLOW : INK_GRID);
    stage_rectangle(s, LEFT, y, WIDTH, HEIGHT);
    stage_ink(s, use ? INK_CYAN : INK_GRID);
    stage_text(s, LEFT + 9, y + 9, key);
    stage_ink(s, ink);
    stage_text(s, LEFT + 36, y + 9, label_of(e, &items[i]));
}

void menu_draw(const struct editor *e, struct stage *s)
{
    for (int i = 0; i < ITEMS; i++)
        draw_item(e, s, i);
}
