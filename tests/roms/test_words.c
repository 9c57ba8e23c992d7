/* Words of a typed line (roms/monitor/words.h): numbers as strtod has them, bounds, points, texts, and
 * the sentence that each trouble has; then lines at random against a reader of its own. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "roms/monitor/words.c"

enum { MOST = 6, ROOM = 2000 };

static struct {
    char line[ROOM];
    struct words words;
    uint32_t state;
} rig;

static struct words *cut(const char *line)
{
    assert_in_range(strlen(line), 0, ROOM - 1);
    strcpy(rig.line, line);
    assert_true(words_cut(&rig.words, rig.line));
    return &rig.words;
}

static uint32_t random_below(uint32_t limit)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) % limit;
}

static void lines_are_cut(void **state)
{
    (void)state;
    struct words *w = cut("  line\tdda 0  4 ");
    assert_int_equal(words_left(w), 4);
    assert_true(words_take(w, "line"));
    assert_false(words_take(w, "line"));
    assert_string_equal(words_peek(w), "dda");
    assert_false(words_end(w));
    assert_string_equal(w->trouble, "\"dda\" is too much");
    assert_int_equal(words_left(cut("")), 0);
    assert_string_equal(words_peek(&rig.words), "");
    for (int i = 0; i <= WORDS_MOST; i++)
        memcpy(rig.line + 2 * i, "a ", 3);
    assert_false(words_cut(&rig.words, rig.line));
    assert_string_equal(rig.words.trouble, "a command has at most 200 words");
}

static void the_first_trouble_stays(void **state)
{
    (void)state;
    struct words *w = cut("a");
    assert_false(words_refuse(w, "%d", 1));
    assert_false(words_refuse(w, "%d", 2));
    assert_string_equal(w->trouble, "1");
}

static void numbers_are_those_of_strtod(void **state)
{
    static const char *const right[] = {"0", "-0", "+7", ".5", "-12.25", "1e3", "2.5e-3", "5."};
    static const char *const wrong[] = {"",     "x",     "1x",   "0x10", "nan", "inf", "1/0",
                                        "1e99", "-1e99", "1/-2", "--1",  ".",   "-",   "1/"};
    (void)state;
    for (size_t i = 0; i < sizeof right / sizeof right[0]; i++) {
        float got;
        assert_true(words_next_is_number(cut(right[i])));
        assert_true(words_number(&rig.words, &got));
        assert_true(got == (float)strtod(right[i], NULL));
        assert_true(words_end(&rig.words));
    }
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        float got = 3;
        assert_false(words_next_is_number(cut(wrong[i])));
        assert_false(words_number(&rig.words, &got));
    }
    float quarter;
    assert_true(words_number(cut("-1/4"), &quarter));
    assert_true(quarter == -0.25f);
    assert_false(words_number(cut("left"), &quarter));
    assert_string_equal(rig.words.trouble, "\"left\" is not a number");
    assert_false(words_number(cut(""), &quarter));
    assert_string_equal(rig.words.trouble, "a number is missing");
}

static void bounds_are_kept_and_told(void **state)
{
    (void)state;
    float got = 3, all[2];
    int whole = 3;
    assert_true(words_bounded(cut("-2"), -2, 2, &got) && got == -2);
    assert_true(words_bounded(cut("2"), -2, 2, &got) && got == 2);
    assert_false(words_bounded(cut("2000000 1"), -WORDS_FARTHEST, WORDS_FARTHEST, &got));
    assert_string_equal(rig.words.trouble, "2000000 is not within -1000000 and 1000000");
    assert_true(got == 2);
    assert_int_equal(words_left(&rig.words), 2);
    assert_false(words_bounded(cut("0"), 0.001f, 1000, &got));
    assert_string_equal(rig.words.trouble, "0 is not within 0.001 and 1000");
    assert_false(words_amounts(cut("1 3e38"), all, 2));
    assert_string_equal(rig.words.trouble, "3e38 is not within -1000000 and 1000000");
    assert_true(words_whole(cut("4/2"), 0, 2, &whole) && whole == 2);
    assert_false(words_whole(cut("3"), 0, 2, &whole));
    assert_string_equal(rig.words.trouble, "3 is not within 0 and 2");
    assert_false(words_whole(cut("1.5"), 0, 2, &whole));
    assert_string_equal(rig.words.trouble, "\"1.5\" is not a whole number");
    assert_false(words_whole(cut("99999999999"), 0, INT32_MAX, &whole));
}

static bool direction(const char *line, struct vector3 *v)
{
    return words_direction(cut(line), 3, WORDS_FARTHEST, v);
}

static void directions_may_be_small(void **state)
{
    struct vector3 v;
    (void)state;
    assert_true(direction("3 -4 0", &v) && v.x == 3 && v.y == -4 && v.z == 0);
    assert_true(direction("1e-30 -2e-30 0", &v));
    assert_true(v.y < -0.25f && v.y >= -1 && v.x / v.y == -0.5f && v.z == 0);
    assert_true(direction("0 0 1e-45", &v) && v.z >= 0.5f);
    assert_false(direction("0 -0 0", &v));
    assert_string_equal(rig.words.trouble, "a vector of length 0 has no direction");
    assert_false(direction("3e38 0 0", &v));
    assert_true(words_direction(cut("0 1e-20 x"), 2, 1, &v) && v.y >= 0.5f && v.z == 0);
}

static void points_refused(int dimensions, const char *line, const char *trouble)
{
    const struct words_wanted wanted = {3, MOST, 100};
    struct vector3 p[MOST];
    int count;
    assert_false(words_points(cut(line), dimensions, wanted, p, &count));
    assert_string_equal(rig.words.trouble, trouble);
}

static void points_have_their_sentences(void **state)
{
    (void)state;
    points_refused(2, "", "at least 3 points are needed");
    points_refused(2, "1 2 3 4", "at least 3 points are needed");
    points_refused(2, "1 2 3 4 5", "the last point has no y");
    points_refused(3, "1 2 3 1 2 3 1 2", "the last point has no z");
    points_refused(2, "1 2 3 4 at 6", "\"at\" is not a number");
    points_refused(2, "1 2 3 4 5 at", "\"at\" is not a number");
    points_refused(2, "1 2 3 4 5 6 7 -101", "-101 is not within -100 and 100");
    points_refused(2, "1 2 3 4 5 6 1e99 8", "\"1e99\" is not a number");
    points_refused(2, "0 0 0 0 0 0 0 0 0 0 0 0 0 0", "at most 6 points");
    struct point2 p[1];
    int count;
    assert_false(words_points2(cut("at"), (struct words_wanted){1, 1, 9}, p, &count));
    assert_false(words_points2(cut(""), (struct words_wanted){1, 1, 9}, p, &count));
    assert_string_equal(rig.words.trouble, "at least 1 point is needed");
    assert_false(words_points2(cut("1 2 3"), (struct words_wanted){1, 1, 9}, p, &count));
    assert_string_equal(rig.words.trouble, "at most 1 point");
    assert_true(words_points2(cut("at"), (struct words_wanted){0, 1, 9}, p, &count));
    assert_int_equal(count, 0);
    assert_true(words_next_is(&rig.words, "at"));
}

/* Lines of whole numbers and, at times, a word behind them. */
static void points_at_random(void **state)
{
    (void)state;
    for (int round = 0; round < 20000; round++) {
        int numbers = (int)random_below(3 * MOST + 4), dimensions = 2 + (int)random_below(2);
        int least = (int)random_below(4), value[3 * MOST + 4], length = 0, count;
        bool word = random_below(4) == 0, beyond = false;
        char line[ROOM] = "";
        for (int i = 0; i < numbers; i++) {
            value[i] = (int)random_below(209) - 104;
            beyond |= value[i] < -102 || value[i] > 102;
            length += sprintf(line + length, "%d ", value[i]);
        }
        sprintf(line + length, "%s", word ? "to" : "");
        bool right = !beyond && numbers % dimensions == 0 && numbers / dimensions >= least &&
                     numbers / dimensions <= MOST;
        struct vector3 p[MOST];
        bool got =
            words_points(cut(line), dimensions, (struct words_wanted){least, MOST, 102}, p, &count);
        assert_int_equal(got, right);
        assert_int_equal(rig.words.trouble[0] == '\0', right);
        if (!right)
            continue;
        assert_int_equal(count, numbers / dimensions);
        assert_int_equal(words_left(&rig.words), word);
        for (int i = 0; i < count; i++) {
            const int *v = &value[i * dimensions];
            assert_true(p[i].x == (float)v[0] && p[i].y == (float)v[1]);
            assert_true(p[i].z == (dimensions == 3 ? (float)v[2] : 0));
        }
    }
}

static void the_rest_is_text(void **state)
{
    char text[8];
    (void)state;
    assert_true(words_rest(cut(" ab   c d "), text, sizeof text));
    assert_string_equal(text, "ab c d");
    assert_true(words_rest(cut("abc def"), text, sizeof text));
    assert_string_equal(text, "abc def");
    assert_true(words_end(&rig.words));
    assert_false(words_rest(cut("abc defg"), text, sizeof text));
    assert_string_equal(rig.words.trouble, "the text has more than 7 characters");
    assert_false(words_rest(cut(""), text, sizeof text));
    assert_string_equal(rig.words.trouble, "a text is missing");
}

static void choices_are_by_name(void **state)
{
    static const char *const names[] = {"x", "y", NULL};
    int which;
    (void)state;
    assert_true(words_choice(cut("y"), names, &which) && which == 1);
    assert_false(words_choice(cut("z"), names, &which));
    assert_string_equal(rig.words.trouble, "\"z\" is not known here");
    assert_false(words_choice(cut(""), names, &which));
    assert_string_equal(rig.words.trouble, "a word is missing");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_are_cut),
        cmocka_unit_test(the_first_trouble_stays),
        cmocka_unit_test(numbers_are_those_of_strtod),
        cmocka_unit_test(bounds_are_kept_and_told),
        cmocka_unit_test(directions_may_be_small),
        cmocka_unit_test(points_have_their_sentences),
        cmocka_unit_test(points_at_random),
        cmocka_unit_test(the_rest_is_text),
        cmocka_unit_test(choices_are_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
