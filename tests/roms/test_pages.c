/* Pages of lessons (roms/lessons/pages.h): what follows what, by itself and by keys, on a clock that
 * goes in steps of a tenth of a second. The source is compiled for this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "roms/lessons/pages.c"

/* What was drawn last. */
static char drawn;
static float drawn_at;
static const char *title;

void stage_title(struct stage *stage, const char *text)
{
    (void)stage;
    title = text;
}

void stage_caption(struct stage *stage, const char *text)
{
    (void)stage;
    (void)text;
}

static void draw_a(struct stage *stage, float seconds)
{
    (void)stage;
    drawn = 'a';
    drawn_at = seconds;
}

static void draw_b(struct stage *stage, float seconds)
{
    (void)stage;
    drawn = 'b';
    drawn_at = seconds;
}

static const struct page table[] = {{"A", NULL, 4, draw_a}, {"B", NULL, 6, draw_b}};
static float clock_now;

static struct pages two_pages(void)
{
    struct pages p = {.page = table, .count = 2};
    clock_now = 0;
    pages_begin(&p);
    return p;
}

static void pass(struct pages *p, float seconds)
{
    for (int i = (int)(seconds * 10 + 0.5f); i > 0; i--) {
        clock_now += 0.1f;
        pages_draw(p, NULL, clock_now);
    }
}

static void at(char page, float seconds)
{
    assert_int_equal(drawn, page);
    if (fabsf(drawn_at - seconds) > 0.25f)
        fail_msg("%g seconds instead of %g", (double)drawn_at, (double)seconds);
}

static void pages_follow_one_another(void **state)
{
    (void)state;
    struct pages p = two_pages();
    pass(&p, 3);
    at('a', 3);
    assert_string_equal(title, "A");
    pass(&p, 3);
    at('b', 2);
    assert_string_equal(title, "B");
    pass(&p, 6);
    at('a', 2);
}

static void keys_turn_both_ways(void **state)
{
    (void)state;
    struct pages p = two_pages();
    pass(&p, 1);
    pages_key(&p, ' ');
    pass(&p, 1);
    at('b', 1);
    pages_key(&p, ' ');
    pass(&p, 1);
    at('a', 1);
    pages_key(&p, 'b');
    pass(&p, 2);
    at('b', 2);
}

static void a_pause_stops_time_until_a_page_is_turned(void **state)
{
    (void)state;
    struct pages p = two_pages();
    pass(&p, 2);
    pages_key(&p, 'p');
    pass(&p, 23);
    at('a', 2);
    pages_key(&p, 'p');
    pass(&p, 1);
    at('a', 3);
    pages_key(&p, 'p');
    pages_key(&p, ' ');
    pass(&p, 3);
    at('b', 3);
}

static void pace_is_a_factor_within_limits(void **state)
{
    (void)state;
    struct pages p = two_pages();
    pages_key(&p, '-');
    pass(&p, 4);
    at('a', 3.2f);
    for (int i = 0; i < 100; i++)
        pages_key(&p, '+');
    assert_true(p.pace >= 4 && p.pace < 5.1f);
    for (int i = 0; i < 100; i++)
        pages_key(&p, '-');
    assert_true(p.pace > 0.19f && p.pace <= 0.25f);
}

/* ---- a lesson with a state of its own -------------------------------------------------------- */

struct own {
    int turned_to, turns, begun, value;
};

static void begin(void *own)
{
    *(struct own *)own = (struct own){.begun = 1};
}

static void turn(void *own, int page)
{
    ((struct own *)own)->turned_to = page;
    ((struct own *)own)->turns++;
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    (void)own;
    (void)stage;
    drawn = (char)('0' + page);
    drawn_at = seconds;
    return 2;
}

static bool key(void *own, int k)
{
    if (k == '+')
        ((struct own *)own)->value++;
    return k == '+';
}

static void own_keys_come_first_and_hold_the_page(void **state)
{
    (void)state;
    struct own own = {.value = 7};
    struct pages p = {
        .count = 3, .own = &own, .begin = begin, .turn = turn, .draw = draw, .key = key};
    clock_now = 0;
    pages_begin(&p);
    assert_int_equal(own.begun, 1);
    assert_int_equal(own.turns, 1);
    pages_key(&p, 'b');
    assert_int_equal(own.turned_to, 2);
    pages_key(&p, '+');
    assert_int_equal(own.value, 1);
    pass(&p, 10);
    at('2', 10);
    pages_key(&p, ' ');
    assert_int_equal(own.turned_to, 0);
    pass(&p, 3);
    at('1', 1);
    assert_true(p.pace == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pages_follow_one_another),
        cmocka_unit_test(keys_turn_both_ways),
        cmocka_unit_test(a_pause_stops_time_until_a_page_is_turned),
        cmocka_unit_test(pace_is_a_factor_within_limits),
        cmocka_unit_test(own_keys_come_first_and_hold_the_page),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
