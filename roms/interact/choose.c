#include "roms/interact/choose.h"

#include <ctype.h>
#include <stdio.h>

enum { INDENT = 14, KEY_ROOM = 30, LAMP = 9 /* half of its side */, LABEL = 40 };

/* ---- where items are --------------------------------------------------------------------------- */

static void open_items(struct choose *c, const struct choose_item *items, int count)
{
    *c = (struct choose){.items = items,
                         .count = count < CHOOSE_MOST ? count : CHOOSE_MOST,
                         .focus = true,
                         .marked = CHOOSE_NONE,
                         .over = CHOOSE_NONE,
                         .changed = true,
                         .pressed = CHOOSE_NONE};
}

void choose_column(struct choose *c, const struct choose_item *items, int count, float left,
                   float top, float width)
{
    open_items(c, items, count);
    c->left = left;
    c->width = c->item_width = width;
    c->height = (float)(c->count * (CHOOSE_HEIGHT + CHOOSE_GAP) - CHOOSE_GAP);
    c->bottom = top - c->height;
}

void choose_row(struct choose *c, const struct choose_item *items, int count, float left, float top,
                float width)
{
    open_items(c, items, count);
    c->across = true;
    c->left = left;
    c->width = width;
    c->height = CHOOSE_HEIGHT;
    c->bottom = top - c->height;
    c->item_width = (width + CHOOSE_GAP) / (float)(c->count > 0 ? c->count : 1) - CHOOSE_GAP;
}

struct point2 choose_corner(const struct choose *c, int item)
{
    float top = c->bottom + c->height, n = (float)item;
    if (c->across)
        return (struct point2){c->left + n * (c->item_width + CHOOSE_GAP), top};
    return (struct point2){c->left, top - n * (CHOOSE_HEIGHT + CHOOSE_GAP)};
}

int choose_at(const struct choose *c, struct point2 place)
{
    for (int i = 0; i < c->count; i++) {
        struct point2 corner = choose_corner(c, i);
        if (place.x >= corner.x && place.x <= corner.x + c->item_width && place.y <= corner.y &&
            place.y >= corner.y - CHOOSE_HEIGHT)
            return i;
    }
    return CHOOSE_NONE;
}

/* ---- what happens ------------------------------------------------------------------------------ */

static bool enabled(const struct choose *c, int item)
{
    return item >= 0 && item < c->count && (c->disabled >> item & 1) == 0;
}

static int enabled_at(const struct choose *c, struct point2 place)
{
    int item = choose_at(c, place);
    return enabled(c, item) ? item : CHOOSE_NONE;
}

static void look(struct choose *c, int marked, int pressed, bool inside)
{
    if (marked != c->marked || pressed != c->pressed || inside != c->inside)
        c->changed = true;
    c->marked = marked;
    c->pressed = pressed;
    c->inside = inside;
}

/* The mark goes where the pointer goes; while that stays, keys move it. */
static int marked_by(struct choose *c, const struct pointer *p)
{
    int over = p->near || p->pressed || p->released_now ? enabled_at(c, p->at) : CHOOSE_NONE;
    bool moved = over != c->over;
    c->over = over;
    return moved ? over : c->marked;
}

int choose_event(struct choose *c, const struct pointer *p)
{
    int pressed = c->pressed, chosen = CHOOSE_NONE;
    if (p->pressed_now)
        pressed = enabled_at(c, p->pressed_at);
    if (p->released_now) {
        if (pressed != CHOOSE_NONE && enabled_at(c, p->released_at) == pressed)
            chosen = pressed;
        pressed = CHOOSE_NONE;
    }
    if (!p->pressed)
        pressed = CHOOSE_NONE;
    look(c, marked_by(c, p), pressed, pressed != CHOOSE_NONE && enabled_at(c, p->at) == pressed);
    return chosen;
}

/* The next item that can be chosen, around the ends; the same when there is no other. */
static int beside(const struct choose *c, int way)
{
    int at = c->marked != CHOOSE_NONE ? c->marked : way > 0 ? -1 : 0;
    for (int i = 0; i < c->count; i++) {
        at = (at + way + c->count) % c->count;
        if (enabled(c, at))
            return at;
    }
    return c->marked;
}

static int with_key(const struct choose *c, int character)
{
    for (int i = 0; i < c->count; i++)
        if (c->items[i].key != '\0' && toupper(character) == c->items[i].key && enabled(c, i))
            return i;
    return CHOOSE_NONE;
}

static bool is_enter(const struct key_event *key)
{
    return key->character == '\r' || key->character == '\n' || key->code == KEYCODE_ENTER ||
           key->code == KEYCODE_PAD_ENTER;
}

static int moved_by(const struct choose *c, unsigned code)
{
    if (code == (c->across ? KEYCODE_LEFT : KEYCODE_UP))
        return beside(c, -1);
    if (code == (c->across ? KEYCODE_RIGHT : KEYCODE_DOWN))
        return beside(c, 1);
    return c->marked;
}

int choose_key(struct choose *c, const struct key_event *key)
{
    if (key->up || c->count == 0)
        return CHOOSE_NONE;
    if (c->focus && is_enter(key) && !key->repeat)
        return enabled(c, c->marked) ? c->marked : CHOOSE_NONE;
    int own = key->character != 0 && !key->repeat ? with_key(c, key->character) : CHOOSE_NONE;
    int marked = own != CHOOSE_NONE ? own : c->focus ? moved_by(c, key->code) : c->marked;
    look(c, marked, c->pressed, c->inside);
    return own;
}

/* ---- how it looks ------------------------------------------------------------------------------ */

static void box(struct stage *s, float x, float y, float width, float height, enum ink ink,
                unsigned heads)
{
    const struct point2 corners[] = {
        {x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    unsigned before = s->heads;
    stage_heads(s, heads);
    stage_ink(s, ink);
    stage_area(s, corners, 4);
    stage_heads(s, before);
}

static void lamp(struct stage *s, float x, float y, bool on)
{
    stage_ink(s, on ? INK_GREEN : INK_GRID);
    stage_rectangle(s, x - LAMP, y - LAMP, 2 * LAMP, 2 * LAMP);
    if (!on)
        return;
    box(s, x - LAMP, y - LAMP, 2 * LAMP, 2 * LAMP, INK_GREEN, STAGE_RASTER);
    stage_line(s, x - LAMP, y - LAMP, x + LAMP, y + LAMP);
    stage_line(s, x - LAMP, y + LAMP, x + LAMP, y - LAMP);
}

/* Areas are the raster head's; the vector head has a frame, and a second one in it when pressed. */
static void ground(const struct choose *c, struct stage *s, int i, struct point2 corner, bool down)
{
    float y = corner.y - CHOOSE_HEIGHT, width = c->item_width;
    bool marked = i == c->marked && (c->focus || c->pressed == i), on = c->lit >> i & 1;
    if (enabled(c, i))
        box(s, corner.x, y, width, CHOOSE_HEIGHT,
            down     ? INK_YELLOW
            : marked ? (enum ink)ink_shade(RAMP_BLUE, 0.5f)
                     : (enum ink)ink_shade(RAMP_BLUE, on ? 0.36f : 0.2f),
            STAGE_RASTER);
    stage_ink(s, !enabled(c, i) ? INK_GRID : marked || down ? INK_BRIGHT : INK_BLUE);
    stage_rectangle(s, corner.x, y, width, CHOOSE_HEIGHT);
    unsigned heads = s->heads;
    stage_heads(s, down ? heads : heads & STAGE_RASTER);
    if (marked || down)
        stage_rectangle(s, corner.x + 4, y + 4, width - 8, CHOOSE_HEIGHT - 8);
    stage_heads(s, heads);
}

/* On the bright ground of a pressed item black; the vector head has no ground. */
static void words(struct stage *s, float x, float y, enum ink ink, bool down, const char *text)
{
    unsigned heads = s->heads;
    stage_heads(s, down ? heads & STAGE_RASTER : heads);
    stage_ink(s, down ? INK_BLACK : ink);
    stage_text(s, x, y, text);
    stage_heads(s, down ? heads & STAGE_VECTOR : 0);
    stage_ink(s, INK_BRIGHT);
    stage_text(s, x, y, text);
    stage_heads(s, heads);
}

static void item(const struct choose *c, struct stage *s, int i)
{
    char text[LABEL];
    struct point2 corner = choose_corner(c, i);
    bool down = i == c->pressed && c->inside, on = enabled(c, i), bulb = c->lamps >> i & 1;
    float y = corner.y - CHOOSE_HEIGHT / 2 - 8, x = corner.x + INDENT;
    float end = corner.x + c->item_width - (bulb ? 4 * LAMP : INDENT / 2);
    ground(c, s, i, corner, down);
    if (c->items[i].key != '\0') {
        snprintf(text, sizeof text, "%c", c->items[i].key);
        words(s, x, y, on ? INK_ORANGE : INK_GRID, down, text);
        x += KEY_ROOM;
    }
    int room = (int)((end - x) / STAGE_CHARACTER);
    snprintf(text, sizeof text, "%.*s", room > 0 ? room : 0, c->items[i].label);
    words(s, x, y, !on ? INK_GRID : c->lit >> i & 1 ? INK_BRIGHT : INK_TEXT, down, text);
    if (bulb && on)
        lamp(s, corner.x + c->item_width - 2 * LAMP - 4, corner.y - CHOOSE_HEIGHT / 2,
             c->lit >> i & 1);
}

void choose_draw(const struct choose *c, struct stage *s)
{
    for (int i = 0; i < c->count; i++)
        item(c, s, i);
}
