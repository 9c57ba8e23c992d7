/* Bytes of the console as keys (roms/interact/typed.h): characters, arrows, and what is neither. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "roms/interact/typed.c"

static struct typed t;
static uint64_t now;

/* Bytes so many ticks apart; a code for a key without a character. Returns how many keys. */
static int feed(const char *bytes, uint64_t apart, int keys[])
{
    int count = 0;
    for (; *bytes; bytes++) {
        struct key_event key;
        now += apart;
        if (typed_take(&t, (uint8_t)*bytes, now, &key))
            keys[count++] = key.character ? key.character : 0x100 + key.code;
    }
    return count;
}

static void arrows_come_as_sequences(void **state)
{
    (void)state;
    int keys[16];
    const int expected[] = {
        'a', 0x100 + KEYCODE_UP, 0x100 + KEYCODE_LEFT, 0x100 + KEYCODE_RIGHT, 'b', 'c'};
    memset(&t, 0, sizeof t);
    assert_int_equal(feed("a\033[A\033OD\033[1;5Cb\033xc", 10, keys), 6);
    assert_memory_equal(keys, expected, sizeof expected);
}

static void escape_by_itself_takes_no_key_with_it(void **state)
{
    (void)state;
    int keys[16];
    memset(&t, 0, sizeof t);
    assert_int_equal(feed("\033x[A", TIMER_HZ / 5, keys), 3);
    assert_int_equal(keys[0], 'x');
    assert_int_equal(keys[1], '[');
    assert_int_equal(keys[2], 'A');
}

static void enter_and_tab_have_codes(void **state)
{
    (void)state;
    struct key_event key;
    memset(&t, 0, sizeof t);
    assert_true(typed_take(&t, '\r', now, &key));
    assert_int_equal(key.code, KEYCODE_ENTER);
    assert_int_equal(key.character, '\r');
    assert_true(typed_take(&t, '\n', now, &key));
    assert_int_equal(key.code, KEYCODE_ENTER);
    assert_true(typed_take(&t, '\t', now, &key));
    assert_int_equal(key.code, KEYCODE_TAB);
    assert_false(key.up || key.repeat);
}

static void the_rest_of_refused_text_is_no_keys(void **state)
{
    (void)state;
    struct typed_rest rest = {0};
    assert_false(typed_rest_takes(&rest, 'a', now));
    typed_rest_begin(&rest, now);
    for (int i = 0; i < 1000; i++) {
        now += TYPED_REST / 3;
        assert_false(typed_rest_takes(&rest, -1, now));
        now += TYPED_REST / 3;
        assert_true(typed_rest_takes(&rest, 'q', now));
    }
    /* A byte that waited while nobody polled is of it, too. */
    now += 5 * TYPED_REST;
    assert_true(typed_rest_takes(&rest, 'q', now));
    now += TYPED_REST + 1;
    assert_false(typed_rest_takes(&rest, -1, now));
    assert_false(typed_rest_takes(&rest, 'q', now));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrows_come_as_sequences),
        cmocka_unit_test(escape_by_itself_takes_no_key_with_it),
        cmocka_unit_test(enter_and_tab_have_codes),
        cmocka_unit_test(the_rest_of_refused_text_is_no_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
