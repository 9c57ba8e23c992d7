/* Menus on the stage (roms/interact/choose.h): what pointer and keys choose, against a model of a person who
 * presses and lets go anywhere; and what is drawn of it on both heads. */
#include "tests/roms/stage_rig.h"

#include "roms/interact/choose.c"

static const struct choose_item items[] = {
    {"Antenna", 'A'}, {"Beacon", 'B'}, {"Camera of a very long name indeed", 'C'},
    {"Drive", '4'},   {"Engine", 0},
};
enum { ITEMS = sizeof items / sizeof *items };

static struct stage stage;
static struct choose menu;
static struct pointer p;

static void open_menu(bool across)
{
    rig_open(&stage, true, true);
    memset(&p, 0, sizeof p);
    if (across)
        choose_row(&menu, items, ITEMS, 20, 780, 1160);
    else
        choose_column(&menu, items, ITEMS, 20, 700, 300);
}

/* The middle of an item. */
static struct point2 middle(int item)
{
    struct point2 corner = choose_corner(&menu, item);
    return (struct point2){corner.x + menu.item_width / 2, corner.y - CHOOSE_HEIGHT / 2};
}

static int poll(struct point2 at, bool pressed)
{
    p.pressed_now = pressed && !p.pressed;
    p.released_now = !pressed && p.pressed;
    p.at = at;
    p.near = true;
    p.pressed = pressed;
    if (p.pressed_now)
        p.pressed_at = at;
    if (p.released_now)
        p.released_at = at;
    return choose_event(&menu, &p);
}

static int key(uint8_t character, uint8_t code)
{
    return choose_key(&menu, &(struct key_event){.character = character, .code = code});
}

/* ---- places ---------------------------------------------------------------------------------------- */

static void items_fill_the_menu(void **state)
{
    (void)state;
    for (int across = 0; across < 2; across++) {
        int inside = 0, all = 0;
        open_menu(across);
        for (int i = 0; i < ITEMS; i++)
            assert_int_equal(choose_at(&menu, middle(i)), i);
        for (int k = 0; k < 20000; k++) {
            struct point2 at = {random_between(0, 1200), random_between(0, 800)};
            bool within = at.x >= menu.left && at.x <= menu.left + menu.width &&
                          at.y >= menu.bottom && at.y <= menu.bottom + menu.height;
            all += within;
            inside += choose_at(&menu, at) != CHOOSE_NONE;
            assert_true(within || choose_at(&menu, at) == CHOOSE_NONE);
        }
        /* What is left are gaps of 8 between items of 48, or of 225. */
        double part = across ? 1 - 4 * 8.0 / 1160 : 5 * 48.0 / (5 * 48 + 4 * 8);
        assert_true(fabs((double)inside / all - part) < 0.03);
    }
}

/* ---- pointing --------------------------------------------------------------------------------------- */

static void released_where_pressed_is_chosen(void **state)
{
    (void)state;
    open_menu(false);
    for (int from = 0; from < ITEMS; from++)
        for (int to = 0; to < ITEMS; to++) {
            assert_int_equal(poll(middle(from), false), CHOOSE_NONE);
            assert_int_equal(poll(middle(from), true), CHOOSE_NONE);
            assert_int_equal(poll(middle(to), true), CHOOSE_NONE);
            assert_int_equal(menu.inside, from == to);
            assert_int_equal(poll(middle(to), false), from == to ? from : CHOOSE_NONE);
        }
    /* Pressed beside the menu, or let go there. */
    poll((struct point2){900, 100}, true);
    assert_int_equal(poll(middle(1), false), CHOOSE_NONE);
    poll(middle(1), true);
    assert_int_equal(poll((struct point2){900, 100}, false), CHOOSE_NONE);
    /* Out and back again. */
    poll(middle(1), true);
    poll((struct point2){900, 100}, true);
    poll(middle(1), true);
    assert_int_equal(poll(middle(1), false), 1);
}

/* Random moves, presses and releases, and disabled items: chosen is what the definition says. */
static void a_person_who_presses_anywhere(void **state)
{
    (void)state;
    int chosen = 0;
    open_menu(false);
    menu.disabled = 1u << 3;
    int armed = CHOOSE_NONE;
    bool down = false;
    for (int k = 0; k < 20000; k++) {
        struct point2 at = {random_between(0, 400), random_between(400, 720)};
        bool press = random_below(2) == 0;
        int over = choose_at(&menu, at), expect = CHOOSE_NONE;
        if (press && !down)
            armed = over;
        if (!press && down && armed == over && armed != 3)
            expect = armed;
        down = press;
        assert_int_equal(poll(at, press), expect);
        chosen += expect != CHOOSE_NONE;
    }
    assert_true(chosen > 200);
}

static void a_tap_between_two_polls(void **state)
{
    (void)state;
    open_menu(false);
    p = (struct pointer){
        .at = {1000, 100}, .near = true, .pressed_now = true, .released_now = true};
    p.pressed_at = p.released_at = middle(2);
    assert_int_equal(choose_event(&menu, &p), 2);
    p.released_at = middle(1);
    assert_int_equal(choose_event(&menu, &p), CHOOSE_NONE);
    p.pressed_now = p.released_now = false;
    assert_int_equal(choose_event(&menu, &p), CHOOSE_NONE);
}

static void the_mark_follows_the_pointer(void **state)
{
    (void)state;
    open_menu(true);
    menu.changed = false;
    poll(middle(2), false);
    assert_true(menu.changed && menu.marked == 2);
    menu.changed = false;
    poll(middle(2), false);
    assert_false(menu.changed);
    poll((struct point2){600, 100}, false);
    assert_int_equal(menu.marked, CHOOSE_NONE);
    menu.disabled = 1u << 4;
    poll(middle(4), false);
    assert_int_equal(menu.marked, CHOOSE_NONE);
    /* A stylus that rests, and trembles, leaves the mark to the keys. */
    poll(middle(2), false);
    choose_key(&menu, &(struct key_event){.code = KEYCODE_RIGHT});
    assert_int_equal(menu.marked, 3);
    for (int i = 0; i < 5; i++) {
        struct point2 at = middle(2);
        at.x += (float)i;
        poll(at, false);
        assert_int_equal(menu.marked, 3);
    }
    poll(middle(1), false);
    assert_int_equal(menu.marked, 1);
}

/* ---- keys ------------------------------------------------------------------------------------------- */

static void letters_choose(void **state)
{
    (void)state;
    open_menu(false);
    assert_int_equal(key('a', 'A'), 0);
    assert_int_equal(key('B', 'B'), 1);
    assert_int_equal(key('4', '4'), 3);
    assert_int_equal(key('x', 'X'), CHOOSE_NONE);
    assert_int_equal(key(0, 'A'), CHOOSE_NONE); /* with Control, it makes no character */
    menu.disabled = 1u << 1;
    assert_int_equal(key('b', 'B'), CHOOSE_NONE);
    struct key_event up = {.character = 'a', .code = 'A', .up = true};
    assert_int_equal(choose_key(&menu, &up), CHOOSE_NONE);
    struct key_event held = {.character = 'a', .code = 'A', .repeat = true};
    assert_int_equal(choose_key(&menu, &held), CHOOSE_NONE);
}

static void cursor_keys_go_around_and_skip(void **state)
{
    (void)state;
    for (int across = 0; across < 2; across++) {
        uint8_t on = across ? KEYCODE_RIGHT : KEYCODE_DOWN,
                back = across ? KEYCODE_LEFT : KEYCODE_UP;
        open_menu(across);
        menu.disabled = 1u << 0 | 1u << 3;
        const int forward[] = {1, 2, 4, 1, 2};
        for (int i = 0; i < 5; i++) {
            assert_int_equal(key(0, on), CHOOSE_NONE);
            assert_int_equal(menu.marked, forward[i]);
            assert_int_equal(key('\r', KEYCODE_ENTER), forward[i]);
        }
        key(0, back);
        assert_int_equal(menu.marked, 1);
        key(0, back);
        assert_int_equal(menu.marked, 4);
        assert_int_equal(key(0, across ? KEYCODE_UP : KEYCODE_LEFT), CHOOSE_NONE);
        assert_int_equal(menu.marked, 4);
        menu.focus = false;
        key(0, on);
        assert_int_equal(menu.marked, 4);
        assert_int_equal(key('\r', KEYCODE_ENTER), CHOOSE_NONE);
        menu.focus = true;
        menu.disabled = 0x1F;
        key(0, on);
        assert_int_equal(key('\r', KEYCODE_ENTER), CHOOSE_NONE);
    }
}

/* ---- how it looks ------------------------------------------------------------------------------------- */

static uint8_t pixel(float x, float y)
{
    return stage.canvas
        .pixels[(uint32_t)scalar_nearest(stage_canvas_y(&stage, y)) * stage.canvas.pitch +
                (uint32_t)scalar_nearest(stage_canvas_x(&stage, x))];
}

static void draw(struct drawing *drawing)
{
    stage_begin(&stage);
    choose_draw(&menu, &stage);
    struct display end = stage.display;
    end.end += 4;
    display_jump(&end, 0);
    decode(STAGE_PART_LOW + (uint32_t)(1 - stage.part_shown) * STAGE_PART_BYTES, drawing);
}

/* A light pen sees items that can be chosen, wherever they are: no black but letters. */
static void items_are_not_black(void **state)
{
    (void)state;
    static struct drawing drawing, pressed;
    open_menu(false);
    menu.disabled = 1u << 1;
    draw(&drawing);
    for (int i = 0; i < ITEMS; i++)
        for (float x = 6; x < 295; x += 7) {
            float y = choose_corner(&menu, i).y - 10;
            assert_int_equal(pixel(menu.left + x, y) == INK_BLACK, i == 1);
        }
    assert_int_equal(drawing.count, 4 * ITEMS); /* frames */
    stage_end(&stage);
    poll(middle(2), true);
    draw(&pressed);
    assert_int_equal(pixel(menu.left + 8, choose_corner(&menu, 2).y - 10), INK_YELLOW);
    assert_int_equal(pressed.count, drawing.count + 4);
    assert_int_equal(pressed.characters, drawing.characters);
    stage_end(&stage);
}

/* A label that is too long does not reach into what is beside the menu. */
static void labels_are_cut(void **state)
{
    (void)state;
    static struct drawing drawing;
    open_menu(false);
    menu.lamps = 0x1F;
    menu.lit = 1;
    draw(&drawing);
    for (float x = 1; x < 600; x += 1.5f)
        for (float y = menu.bottom; y < menu.bottom + menu.height; y += 1.5f)
            assert_int_equal(pixel(menu.left + menu.width + x + 2, y), INK_BLACK);
    stage_end(&stage);
}

int main(void)
{
    (void)visible_part, (void)drawn_is; /* of the rig, not needed here */
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(items_fill_the_menu),
        cmocka_unit_test(released_where_pressed_is_chosen),
        cmocka_unit_test(a_person_who_presses_anywhere),
        cmocka_unit_test(a_tap_between_two_polls),
        cmocka_unit_test(the_mark_follows_the_pointer),
        cmocka_unit_test(letters_choose),
        cmocka_unit_test(cursor_keys_go_around_and_skip),
        cmocka_unit_test(items_are_not_black),
        cmocka_unit_test(labels_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
