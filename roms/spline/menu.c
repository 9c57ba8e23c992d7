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

static void draw_items(const struct editor *e, struct stage *s, unsigned heads)
{
    stage_heads(s, heads);
    for (int i = 0; i < ITEMS; i++)
        draw_item(e, s, i);
    stage_heads(s, STAGE_BOTH);
}

/* ---- pixels that are kept ------------------------------------------------------------------------ */

/* All that the items show. */
static uint64_t state_of(const struct editor *e)
{
    uint64_t state = e->model.parameter;
    state = state * 4 + (e->chosen >= 0 ? (unsigned)e->model.point[e->chosen].joint : 3);
    for (int i = 0; i < ITEMS; i++)
        state = state * 4 + holds(e, items[i].key) * 2u + useful(e, items[i].key);
    return state;
}

static bool place_kept(const struct stage *s, struct menu_kept *kept)
{
    float right = stage_canvas_x(s, LEFT + WIDTH), low = stage_canvas_y(s, bottom_of(ITEMS - 1));
    kept->x = (int)stage_canvas_x(s, LEFT - 4) & ~3;
    kept->y = (int)stage_canvas_y(s, TOP) - 1;
    kept->width = ((int)right + 17 - kept->x) & ~15;
    kept->height = (int)low + 3 - kept->y;
    return s->canvas.bits == 8 && kept->x >= 0 && kept->y >= 0 &&
           kept->x + kept->width <= s->canvas.width && kept->y + kept->height <= s->canvas.height &&
           kept->width * kept->height <= MENU_PIXELS;
}

/* Four words at a time: memcpy of small libraries goes byte by byte. Rows of a canvas begin at multiples
 * of 4. */
static void copy_row(uint32_t *to, const uint32_t *from, int words)
{
    for (int i = 0; i < words; i += 4) {
        uint32_t a = from[i], b = from[i + 1], c = from[i + 2], d = from[i + 3];
        to[i] = a;
        to[i + 1] = b;
        to[i + 2] = c;
        to[i + 3] = d;
    }
}

/* From the canvas, or onto it. */
static void copy_kept(const struct stage *s, struct menu_kept *kept, bool onto)
{
    int words = kept->width / 4;
    for (int i = 0; i < kept->height; i++) {
        uint8_t *pixels =
            s->canvas.pixels + (uint32_t)(kept->y + i) * s->canvas.pitch + (uint32_t)kept->x;
        uint32_t *row = (uint32_t *)(void *)pixels, *own = kept->pixels + i * words;
        copy_row(onto ? row : own, onto ? own : row, words);
    }
}

void menu_draw(const struct editor *e, struct stage *s, struct menu_kept *kept)
{
    uint64_t state = state_of(e);
    if (kept->any && kept->state == state) {
        copy_kept(s, kept, true);
        draw_items(e, s, STAGE_VECTOR);
        return;
    }
    draw_items(e, s, STAGE_BOTH);
    kept->any = place_kept(s, kept);
    kept->state = state;
    if (kept->any)
        copy_kept(s, kept, false);
}
