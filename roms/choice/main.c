/* choice — a control room: menus, lamps and sliders for pen, finger, stylus, mouse and keys alike.
 *
 *      kinescope run roms/choice.elf --view both
 *      kinescope run roms/choice.elf --view both --input roms/choice.script
 *
 * Keys: 1, 2, 3 or left and right with Enter: pages; A to F or up and down with Enter: the menu; Tab takes
 * the next slider, + and - move it; q ends. Every choice is told on the console, with the device that made
 * it and what that reported.
 *
 * Marks: n when n choices have been made, and are on the screen.
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/timer.h"
#include "roms/bsp/video.h"
#include "roms/choice/choice.h"
#include "roms/geometry/scalar.h"

/* A pen needs a phosphor that flashes when the beam comes: P39 hardly does. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

static const struct choose_item tab_items[PAGES] = {
    {"ORBIT", '1'}, {"PROBE", '2'}, {"SIGNALS", '3'}};
enum { SIGNAL_CLEAR, SIGNAL_FIELD, SIGNALS };
static const struct choose_item signal_items[SIGNALS] = {{"Forget all", 'A'}, {"Blue field", 'B'}};

static const char *const captions[PAGES] = {
    "Choose with pen, finger, stylus or mouse: press, and let go inside. Or letters; cursor keys "
    "and "
    "Enter. Tab, + and - move sliders.",
    "The engine needs power: unfold the panels, and turn them to the sun. Parts that cannot be "
    "chosen "
    "are dark.",
    "A light pen sees no black. With the blue field on, a press there shows one blue field, and "
    "the pen "
    "is found.",
};

/* ---- pages ------------------------------------------------------------------------------------------ */

static void open_page(struct choice *c, int page)
{
    static const struct choose_item *const items[PAGES] = {orbit_items, probe_items, signal_items};
    const int counts[PAGES] = {orbit_count, PARTS, SIGNALS};
    static const uint32_t lamps[PAGES] = {0x38, 0x3F, 0x02};
    c->page = page;
    c->slider = 0;
    choose_column(&c->side, items[page], counts[page], SIDE_LEFT, SIDE_TOP, SIDE_WIDTH);
    c->side.lamps = lamps[page];
    c->side.focus = false;
    c->tabs.lit = 1u << page;
}

static int sliders(struct choice *c, struct slider **first)
{
    *first = c->page == PAGE_ORBIT ? c->orbit.slider : &c->probe.slider;
    return c->page == PAGE_ORBIT ? 3 : c->page == PAGE_PROBE ? 1 : 0;
}

static void choose_item(struct choice *c, int item)
{
    if (c->page == PAGE_ORBIT) {
        orbit_item(&c->orbit, item);
    } else if (c->page == PAGE_PROBE) {
        probe_item(&c->probe, item);
    } else if (item == SIGNAL_CLEAR) {
        c->sources = (struct sources){0};
    } else {
        c->pen_field = !c->pen_field;
        pointer_pen_field(&c->pointer, c->pen_field);
    }
}

/* ---- what happens ------------------------------------------------------------------------------------- */

static void focus(struct choice *c, bool tabs)
{
    c->tabs.focus = tabs;
    c->side.focus = !tabs;
}

static void pointed(struct choice *c)
{
    struct slider *slider;
    int count = sliders(c, &slider), tab = choose_event(&c->tabs, &c->pointer),
        item = choose_event(&c->side, &c->pointer);
    if (choose_at(&c->tabs, c->pointer.at) != CHOOSE_NONE)
        focus(c, true);
    if (choose_at(&c->side, c->pointer.at) != CHOOSE_NONE)
        focus(c, false);
    if (tab != CHOOSE_NONE) {
        source_pointed(&c->sources, &c->pointer, tab_items[tab].label);
        open_page(c, tab);
        return;
    }
    if (item != CHOOSE_NONE) {
        source_pointed(&c->sources, &c->pointer, c->side.items[item].label);
        choose_item(c, item);
    }
    if (c->page == PAGE_SIGNALS && c->pointer.pressed_now &&
        choose_at(&c->tabs, c->pointer.pressed_at) == CHOOSE_NONE &&
        choose_at(&c->side, c->pointer.pressed_at) == CHOOSE_NONE)
        source_pointed(&c->sources, &c->pointer, "Place");
    for (int i = 0; i < count; i++) {
        bool done;
        if (slider_event(&slider[i], &c->pointer, &done))
            c->slider = i;
        if (done)
            source_pointed(&c->sources, &c->pointer, slider[i].label);
    }
}

static void move_slider(struct choice *c, const struct key_event *key)
{
    struct slider *slider;
    int count = sliders(c, &slider);
    if (count == 0)
        return;
    if (key->code == KEYCODE_TAB) {
        c->slider = (c->slider + 1) % count;
        return;
    }
    slider += c->slider;
    float step = (slider->high - slider->low) / 16;
    slider_set(slider, slider->value + (key->character == '-' ? -step : step));
    source_typed(&c->sources, key, slider->label);
}

static void typed(struct choice *c, const struct key_event *key)
{
    if (key->code == KEYCODE_LEFT || key->code == KEYCODE_RIGHT)
        focus(c, true);
    if (key->code == KEYCODE_UP || key->code == KEYCODE_DOWN)
        focus(c, false);
    if (key->code == KEYCODE_TAB || key->character == '+' || key->character == '-') {
        move_slider(c, key);
        return;
    }
    int tab = choose_key(&c->tabs, key), item = choose_key(&c->side, key);
    if (tab != CHOOSE_NONE) {
        source_typed(&c->sources, key, tab_items[tab].label);
        open_page(c, tab);
    } else if (item != CHOOSE_NONE) {
        source_typed(&c->sources, key, c->side.items[item].label);
        choose_item(c, item);
    }
}

/* ---- pictures ----------------------------------------------------------------------------------------- */

/* A cross that leaves its middle free, and a ring when pressed. */
static void cursor(const struct pointer *p, struct stage *s)
{
    enum { GAP = 6, ARM = 20, RING = 13 };
    float x = p->at.x, y = p->at.y;
    if (!p->near)
        return;
    if (p->report.tracked) /* there the tracking cross is */
        stage_heads(s, STAGE_RASTER);
    stage_ink(s, p->pressed ? INK_BRIGHT : source_ink((int)p->device));
    for (int k = -1; k <= 1; k += 2) {
        float near = (float)(k * GAP), far = (float)(k * ARM);
        stage_line(s, x + near, y, x + far, y);
        stage_line(s, x, y + near, x, y + far);
    }
    if (p->pressed) {
        const struct point2 ring[] = {{x - RING, y}, {x, y - RING}, {x + RING, y}, {x, y + RING}};
        stage_polygon(s, ring, 4);
    }
}

static void draw(struct choice *c)
{
    struct stage *s = &c->stage;
    stage_begin(s);
    stage_title(s, "MISSION CONTROL");
    choose_draw(&c->tabs, s);
    choose_draw(&c->side, s);
    if (c->page == PAGE_ORBIT)
        orbit_draw(&c->orbit, s, c->slider);
    else if (c->page == PAGE_PROBE)
        probe_draw(&c->probe, s, c->slider == 0);
    else
        signals_draw(&c->sources, &c->pointer, s);
    sources_draw(&c->sources, s);
    cursor(&c->pointer, s);
    stage_heads(s, STAGE_BOTH);
    stage_caption(s, captions[c->page]);
    if (c->tracks)
        stage_chain(s, c->tracking.low);
    stage_end(s);
}

static void step(struct choice *c, float seconds)
{
    orbit_step(&c->orbit, seconds);
    probe_step(&c->probe, seconds);
    c->side.disabled = c->page == PAGE_PROBE ? probe_disabled(&c->probe) : 0;
    c->side.lit = c->page == PAGE_ORBIT   ? orbit_lamps(&c->orbit)
                  : c->page == PAGE_PROBE ? c->probe.on
                                          : (uint32_t)c->pen_field << SIGNAL_FIELD;
}

static uint32_t choices(const struct sources *s)
{
    uint32_t sum = 0;
    for (int i = 0; i < SOURCES; i++)
        sum += s->count[i];
    return sum;
}

/* As fast as pictures can be drawn, and no faster than retraces come. */
static bool turn(struct choice *c, uint64_t *before)
{
    struct key_event key;
    uint32_t made = choices(&c->sources);
    uint64_t now = timer_now();
    if (c->tracks)
        tracking_frame(&c->tracking);
    while (pointer_poll(&c->pointer))
        pointed(c);
    while (keys_take(&c->typed, &key)) {
        if (key.character == 'q')
            return false;
        typed(c, &key);
    }
    step(c, scalar_min((float)(now - *before) / TIMER_HZ, 0.1f));
    *before = now;
    draw(c);
    if (choices(&c->sources) != made)
        board_mark(choices(&c->sources));
    return true;
}

/* The cross waits for the pen where it is in nobody's way. */
static void track(struct choice *c)
{
    static const struct point2 corner = {980, 290}; /* head units */
    c->tracks = input_present() & INPUT_BIT_PEN_VECTOR;
    if (!c->tracks)
        return;
    tracking_begin(&c->tracking, STAGE_FREE_LOW, 0);
    tracking_put(&c->tracking, corner);
    pointer_follow(&c->pointer, &c->tracking);
}

int main(void)
{
    static struct choice c;
    stage_open(&c.stage);
    pointer_open(&c.pointer, &c.stage);
    track(&c);
    keyboard_on(false);
    orbit_begin(&c.orbit);
    probe_begin(&c.probe);
    choose_row(&c.tabs, tab_items, PAGES, SIDE_LEFT, 792, 1160);
    open_page(&c, PAGE_ORBIT);
    printf("choice: pages 1 to 3, menu A to F, Tab + - sliders, q ends\n");
    uint64_t before = timer_now();
    while (turn(&c, &before))
        if (!video_present())
            timer_sleep(TIMER_HZ / 60);
    return 0;
}
