/* gallery_interface.c — a desktop of windows: picking, moving, opening, menus. */
#include "roms/lessons/gallery_interface.h"

#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"

const char *const desk_titles[DESK_WINDOWS] = {"Clock", "Graph", "Notes", "Picture"};
const char *const desk_menus[DESK_MENUS] = {"Open", "Window"};
const char *const desk_items[DESK_MENUS][DESK_ITEMS] = {{"Clock", "Graph", "Notes", "Picture"},
                                                        {"Next", "Tile", "Cascade", "Close"}};

/* ---- where things are ------------------------------------------------------------------------ */

struct clip_window desk_window_area(const struct desk *d, int window)
{
    const struct desk_window *w = &d->window[window];
    return (struct clip_window){w->x, w->y, w->x + w->width, w->y + w->height};
}

struct clip_window desk_icon_area(int icon)
{
    float top = STAGE_HEIGHT - DESK_BAR - 30 - (float)icon * (DESK_ICON + 75);
    return (struct clip_window){30, top - DESK_ICON, 30 + DESK_ICON, top};
}

struct clip_window desk_menu_area(int menu)
{
    float left = 20 + (float)menu * DESK_MENU_WIDTH * 0.6f;
    return (struct clip_window){left, STAGE_HEIGHT - DESK_BAR, left + DESK_MENU_WIDTH * 0.55f,
                                STAGE_HEIGHT};
}

struct clip_window desk_item_area(int menu, int item)
{
    struct clip_window m = desk_menu_area(menu);
    float top = m.y_min - (float)item * DESK_BAR;
    return (struct clip_window){m.x_min, top - DESK_BAR, m.x_min + DESK_MENU_WIDTH, top};
}

int desk_focus(const struct desk *d)
{
    for (int i = DESK_WINDOWS - 1; i >= 0; i--)
        if (d->window[d->order[i]].open)
            return d->order[i];
    return DESK_NONE;
}

/* ---- what can be done ------------------------------------------------------------------------ */

/* Puts a window in front of all (or behind them). */
static void reorder(struct desk *d, int window, bool front)
{
    int rest[DESK_WINDOWS], count = 0;
    for (int i = 0; i < DESK_WINDOWS; i++)
        if (d->order[i] != window)
            rest[count++] = d->order[i];
    for (int i = 0; i < count; i++)
        d->order[front ? i : i + 1] = rest[i];
    d->order[front ? DESK_WINDOWS - 1 : 0] = window;
}

static void open_window(struct desk *d, int window)
{
    d->window[window].open = true;
    reorder(d, window, true);
}

static void cascade(struct desk *d)
{
    for (int i = 0; i < DESK_WINDOWS; i++) {
        struct desk_window *w = &d->window[d->order[i]];
        *w = (struct desk_window){180 + (float)i * 150, 330 - (float)i * 100, 500, 390, w->open};
    }
}

static void tile(struct desk *d)
{
    enum { LEFT = 170, WIDE = 500, HIGH = 360, GAP = 14 };
    for (int i = 0; i < DESK_WINDOWS; i++)
        d->window[i] = (struct desk_window){LEFT + (float)(i % 2) * (WIDE + GAP),
                                            HIGH + 2 * GAP - (float)(i / 2) * (HIGH + GAP), WIDE,
                                            HIGH, d->window[i].open};
}

static void choose(struct desk *d, int menu, int item)
{
    int focus = desk_focus(d);
    if (menu == 0)
        open_window(d, item);
    else if (item == 1)
        tile(d);
    else if (item == 2)
        cascade(d);
    else if (focus != DESK_NONE && item == 0)
        reorder(d, focus, false);
    else if (focus != DESK_NONE)
        d->window[focus].open = false;
}

/* The window, from the front, that the pointer is in. */
static int picked(const struct desk *d)
{
    for (int i = DESK_WINDOWS - 1; i >= 0; i--) {
        struct clip_window area = desk_window_area(d, d->order[i]);
        if (d->window[d->order[i]].open && clip_point(&area, d->pointer))
            return d->order[i];
    }
    return DESK_NONE;
}

static void click_window(struct desk *d, int window)
{
    const struct desk_window *w = &d->window[window];
    reorder(d, window, true);
    if (d->pointer.y < w->y + w->height - DESK_BAR)
        return;
    if (d->pointer.x < w->x + DESK_BAR)
        d->window[window].open = false;
    else
        d->dragged = window;
}

static void click_menu(struct desk *d)
{
    for (int i = 0; i < DESK_ITEMS; i++) {
        struct clip_window area = desk_item_area(d->menu, i);
        if (clip_point(&area, d->pointer)) {
            choose(d, d->menu, i);
            break;
        }
    }
    d->menu = DESK_NONE;
}

static void click(struct desk *d)
{
    int window = picked(d);
    if (d->dragged != DESK_NONE) {
        d->dragged = DESK_NONE;
        return;
    }
    if (d->menu != DESK_NONE) {
        click_menu(d);
        return;
    }
    for (int i = 0; i < DESK_MENUS; i++) {
        struct clip_window area = desk_menu_area(i);
        if (clip_point(&area, d->pointer)) {
            d->menu = i;
            return;
        }
    }
    if (window != DESK_NONE) {
        click_window(d, window);
        return;
    }
    for (int i = 0; i < DESK_WINDOWS; i++) {
        struct clip_window area = desk_icon_area(i);
        if (clip_point(&area, d->pointer))
            open_window(d, i);
    }
}

/* Moves the pointer, and what is dragged with it. */
static void move(struct desk *d, float x, float y)
{
    float dx, dy;
    x = scalar_clamp(x, 0, STAGE_WIDTH - 10);
    y = scalar_clamp(y, 10, STAGE_HEIGHT - 4);
    dx = x - d->pointer.x;
    dy = y - d->pointer.y;
    d->pointer = (struct point2){x, y};
    if (d->dragged == DESK_NONE)
        return;
    struct desk_window *w = &d->window[d->dragged];
    w->x = scalar_clamp(w->x + dx, 0, STAGE_WIDTH - w->width);
    w->y = scalar_clamp(w->y + dy, 0, STAGE_HEIGHT - DESK_BAR - w->height);
}

/* ---- by itself ------------------------------------------------------------------------------- */

/* Where the pointer goes when nobody steers it; it clicks there. */
static struct point2 goal_place(const struct desk *d, int goal)
{
    static const struct point2 places[] = {{80, 780},  {80, 590},  {250, 620}, {0, 0}, {880, 560},
                                           {80, 250},  {250, 780}, {250, 645}, {0, 0}, {560, 300},
                                           {250, 780}, {250, 690}, {1180, 400}};
    enum { PLACES = sizeof places / sizeof places[0] };
    int focus = desk_focus(d);
    struct point2 p = places[goal % PLACES];
    if (p.x == 0 && focus != DESK_NONE) { /* the title bar in front */
        struct clip_window area = desk_window_area(d, focus);
        p = (struct point2){(area.x_min + area.x_max) / 2, area.y_max - DESK_BAR / 2};
    }
    return p;
}

static void wander(struct desk *d, float seconds)
{
    const float speed = 420; /* a second */
    struct point2 goal = goal_place(d, d->goal);
    float dx = goal.x - d->pointer.x, dy = goal.y - d->pointer.y, far = sqrtf(dx * dx + dy * dy);
    float step = speed * seconds;
    if (far > step) {
        move(d, d->pointer.x + dx * step / far, d->pointer.y + dy * step / far);
        return;
    }
    move(d, goal.x, goal.y);
    click(d);
    d->goal++;
}

/* ---- the program ----------------------------------------------------------------------------- */

static void begin(void *state)
{
    struct desk *d = (struct desk *)state;
    *d = (struct desk){
        .pointer = {700, 300}, .dragged = DESK_NONE, .menu = DESK_NONE, .alone = true};
    for (int i = 0; i < DESK_WINDOWS; i++) {
        d->order[i] = i;
        d->window[i].open = i != DESK_NOTES;
    }
    cascade(d);
}

static void key(void *state, int k)
{
    enum { STEP = 30 };
    struct desk *d = (struct desk *)state;
    d->alone = false;
    d->touched = d->now;
    switch (k) {
    case KEY_LEFT:
        move(d, d->pointer.x - STEP, d->pointer.y);
        break;
    case KEY_RIGHT:
        move(d, d->pointer.x + STEP, d->pointer.y);
        break;
    case KEY_UP:
        move(d, d->pointer.x, d->pointer.y + STEP);
        break;
    case KEY_DOWN:
        move(d, d->pointer.x, d->pointer.y - STEP);
        break;
    case ' ':
        click(d);
        break;
    case 'n':
        choose(d, 1, 0);
        break;
    case 't':
        choose(d, 1, 1);
        break;
    default:
        break;
    }
}

static float draw(void *state, struct stage *s, float seconds)
{
    enum { PATIENCE = 15 };
    struct desk *d = (struct desk *)state;
    float passed = fminf(seconds - d->now, 0.1f);
    d->now = seconds;
    if (seconds - d->touched > PATIENCE)
        d->alone = true;
    if (d->alone)
        wander(d, passed);
    desk_draw(d, s);
    stage_title(s, "User interface");
    stage_caption(
        s, "Windows overlap, the pointer picks what is in front: title bar (drag), close box, "
           "icon, menu.");
    return 0.03f;
}

static struct desk lesson_state;

extern const struct lesson lesson_gallery_interface;
const struct lesson lesson_gallery_interface = {"interface",
                                                "Gallery: user interface",
                                                "arrows point  space click, drop  n next  t tile",
                                                &lesson_state,
                                                begin,
                                                key,
                                                draw};
