/* The keyboard: what presses store and send, repeats, what is lost, snapshots. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>

#include "input/keyboard.h"

#define MS UINT64_C(1000000000) /* ps */

/* ---- a keyboard and what it sends ---------------------------------------------------------------- */

struct rig {
    struct inp_keyboard_setup setup;
    struct inp_keyboard keyboard;
    char sent[4096];
    size_t length;
    uint64_t last; /* when it sent last */
    unsigned sendings;
};

static void sent(void *ctx, const char *bytes, size_t length, uint64_t t)
{
    struct rig *rig = ctx;
    assert_in_range(length, 1, 8);
    if (length <= sizeof rig->sent - rig->length) {
        memcpy(rig->sent + rig->length, bytes, length);
        rig->length += length;
    }
    rig->last = t;
    rig->sendings++;
}

static void rig_init(struct rig *rig, uint32_t control)
{
    memset(rig, 0, sizeof *rig);
#define X(field, unit, value, low, high, meaning, source)                                          \
    rig->setup.field = (struct crt_figure){value, low, high, source};
    INP_KEYBOARD_FIGURES(X)
#undef X
    struct inp_keyboard_desc desc = {&rig->setup, rig, sent};
    inp_keyboard_init(&rig->keyboard, &desc);
    assert_true(inp_keyboard_write(&rig->keyboard, INPUT_KEY_CONTROL, control, 0));
}

static void press_as(struct rig *rig, uint8_t code, uint8_t character, uint64_t t)
{
    struct inp_act act = {.t = t, .device = INP_KEYBOARD, .verb = INP_PRESS, .code = code};
    act.character = character;
    inp_keyboard_act(&rig->keyboard, &act, t);
}

static void release(struct rig *rig, uint8_t code, uint64_t t)
{
    struct inp_act act = {.t = t, .device = INP_KEYBOARD, .verb = INP_RELEASE, .code = code};
    inp_keyboard_act(&rig->keyboard, &act, t);
}

static uint32_t read_at(struct rig *rig, uint32_t offset)
{
    uint32_t value = 0xDEAD;
    assert_true(inp_keyboard_read(&rig->keyboard, offset, &value));
    return value;
}

static uint32_t event(struct rig *rig)
{
    return read_at(rig, INPUT_KEY_EVENT);
}

static void assert_sent(struct rig *rig, const char *bytes, size_t length)
{
    assert_int_equal(rig->length, length);
    assert_memory_equal(rig->sent, bytes, length);
    rig->length = 0;
}

/* ---- what goes to the console --------------------------------------------------------------------- */

struct sending {
    unsigned modifiers;
    uint8_t code, character;
    const char *bytes;
    size_t length;
};

#define SENDS(modifiers, code, character, bytes)                                                   \
    {                                                                                              \
        modifiers, code, character, bytes, sizeof bytes - 1                                        \
    }
#define C KEYMOD_CONTROL
#define A KEYMOD_ALT
#define S KEYMOD_SHIFT

/* From DEC's and xterm's tables. */
static const struct sending sendings[] = {
    SENDS(0, 'Q', 'q', "q"),
    SENDS(S, 'Q', 'Q', "Q"),
    SENDS(0, '1', '1', "1"),
    SENDS(0, ' ', ' ', " "),
    SENDS(0, 'Q', 0, ""), /* a dead key of some layout */
    SENDS(0, 'Y', 'z', "z"),
    SENDS(0, 0, '~', "~"),
    SENDS(0, 0, 0, ""),
    SENDS(0, 'Q', 0xE9, ""),
    SENDS(0, KEYCODE_ENTER, 0, "\r"),
    SENDS(C, KEYCODE_ENTER, 0, "\r"),
    SENDS(0, KEYCODE_PAD_ENTER, 0, "\r"),
    SENDS(0, KEYCODE_TAB, 0, "\t"),
    SENDS(0, KEYCODE_BACKSPACE, 0, "\x7F"),
    SENDS(0, KEYCODE_ESCAPE, 0, "\x1B"),
    SENDS(0, KEYCODE_UP, 0, "\x1B[A"),
    SENDS(S, KEYCODE_DOWN, 0, "\x1B[B"),
    SENDS(C, KEYCODE_RIGHT, 0, "\x1B[C"),
    SENDS(A, KEYCODE_LEFT, 0, "\x1B[D"),
    SENDS(0, KEYCODE_HOME, 0, "\x1B[H"),
    SENDS(0, KEYCODE_END, 0, "\x1B[F"),
    SENDS(0, KEYCODE_INSERT, 0, "\x1B[2~"),
    SENDS(0, KEYCODE_DELETE, 0, "\x1B[3~"),
    SENDS(0, KEYCODE_PAGE_UP, 0, "\x1B[5~"),
    SENDS(0, KEYCODE_PAGE_DOWN, 0, "\x1B[6~"),
    SENDS(0, KEYCODE_MENU, 0, "\x1B[29~"),
    SENDS(0, KEYCODE_F1, 0, "\x1BOP"),
    SENDS(0, KEYCODE_F1 + 1, 0, "\x1BOQ"),
    SENDS(0, KEYCODE_F1 + 2, 0, "\x1BOR"),
    SENDS(0, KEYCODE_F1 + 3, 0, "\x1BOS"),
    SENDS(0, KEYCODE_F1 + 4, 0, "\x1B[15~"),
    SENDS(0, KEYCODE_F1 + 5, 0, "\x1B[17~"),
    SENDS(0, KEYCODE_F1 + 6, 0, "\x1B[18~"),
    SENDS(0, KEYCODE_F1 + 7, 0, "\x1B[19~"),
    SENDS(0, KEYCODE_F1 + 8, 0, "\x1B[20~"),
    SENDS(0, KEYCODE_F1 + 9, 0, "\x1B[21~"),
    SENDS(0, KEYCODE_F1 + 10, 0, "\x1B[23~"),
    SENDS(0, KEYCODE_F12, 0, "\x1B[24~"),
    SENDS(0, KEYCODE_PAD_0 + 5, '5', "5"),
    SENDS(0, KEYCODE_PAD_POINT, '.', "."),
    SENDS(0, KEYCODE_SHIFT, 0, ""),
    SENDS(0, KEYCODE_SUPER, 0, ""),
    SENDS(C, 'C', 0, "\x03"), /* a window tells no character with Ctrl */
    SENDS(C, 'C', 'c', "\x03"),
    SENDS(C, 'C', 3, "\x03"),
    SENDS(C | S, 'C', 'C', "\x03"),
    SENDS(C, 'A', 0, "\x01"),
    SENDS(C, 'Z', 0, "\x1A"),
    SENDS(C, '[', 0, "\x1B"),
    SENDS(C, '\\', 0, "\x1C"),
    SENDS(C, ']', 0, "\x1D"),
    SENDS(C, '`', 0, "\x1E"), /* a VT100's RS and US */
    SENDS(C, '/', 0, "\x1F"),
    SENDS(C | S, '6', 0, "\x1E"), /* ^ */
    SENDS(C | S, '-', 0, "\x1F"), /* _ */
    SENDS(C | S, '2', 0, "\0"),   /* @ */
    SENDS(C, ' ', 0, "\0"),
    SENDS(C, ' ', ' ', "\0"),
    SENDS(C, '5', 0, ""),
    SENDS(C, '5', '5', ""),
    SENDS(A, 'X', 'x', "\x1Bx"),
    SENDS(A | S, 'X', 'X', "\x1BX"),
    SENDS(A | C, 'X', 0, "\x1B\x18"),
    SENDS(A, KEYCODE_ENTER, 0, "\x1B\r"),
    SENDS(A, 'Q', '@', "@"), /* AltGr */
    SENDS(A | C, 'Q', '@', "@"),
    SENDS(A | C, '7', '{', "{"),
};

#undef C
#undef A
#undef S

static void presses_are_sent_as_a_terminal_does(void **state)
{
    (void)state;
    static struct rig rig;
    for (size_t i = 0; i < sizeof sendings / sizeof *sendings; i++) {
        const struct sending *s = &sendings[i];
        rig_init(&rig, KEY_CONSOLE);
        if (s->modifiers & KEYMOD_SHIFT)
            press_as(&rig, KEYCODE_SHIFT, 0, 1);
        if (s->modifiers & KEYMOD_CONTROL)
            press_as(&rig, KEYCODE_CONTROL, 0, 2);
        if (s->modifiers & KEYMOD_ALT)
            press_as(&rig, KEYCODE_ALT, 0, 3);
        assert_int_equal(rig.length, 0);
        press_as(&rig, s->code, s->character, 4);
        assert_sent(&rig, s->bytes, s->length);
        assert_true(s->length == 0 || rig.last == 4);
        release(&rig, s->code, 5);
        assert_int_equal(rig.length, 0);
        char bytes[8];
        assert_int_equal(inp_key_sent(s->code, s->character, s->modifiers, bytes), s->length);
        assert_memory_equal(bytes, s->bytes, s->length);
    }
}

static void nothing_is_sent_while_the_console_is_off(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    press_as(&rig, 'Q', 'q', 1);
    while (inp_keyboard_next(&rig.keyboard) < 700 * MS)
        assert_true(inp_keyboard_event(&rig.keyboard, inp_keyboard_next(&rig.keyboard)));
    assert_int_equal(rig.sendings, 0);
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_CONTROL, KEY_CONSOLE, 700 * MS));
    assert_false(inp_keyboard_event(&rig.keyboard, inp_keyboard_next(&rig.keyboard)));
    assert_sent(&rig, "q", 1);
}

static void a_keyboard_without_a_console_is_no_trouble(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_CONSOLE | KEY_STORE);
    rig.keyboard.desc.send = NULL;
    press_as(&rig, 'Q', 'q', 1);
    assert_true(inp_keyboard_ready(&rig.keyboard));
    assert_int_equal(event(&rig), KEY_VALID | 'Q' << 8 | 'q');
    assert_false(inp_keyboard_ready(&rig.keyboard));
}

/* ---- events ------------------------------------------------------------------------------------ */

static void power_on_sends_and_stores_nothing(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_CONSOLE);
    inp_keyboard_reset(&rig.keyboard, 0);
    assert_int_equal(read_at(&rig, INPUT_KEY_CONTROL), KEY_CONSOLE);
    press_as(&rig, 'Q', 'q', 1);
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), 0);
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), 0);
    assert_int_equal(event(&rig), 0);
    assert_false(inp_keyboard_ready(&rig.keyboard));
    assert_sent(&rig, "q", 1);
}

static void events_come_in_order_with_their_modifiers(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    press_as(&rig, KEYCODE_SHIFT, 0, 1);
    press_as(&rig, 'Q', 'Q', 2);
    release(&rig, KEYCODE_SHIFT, 3);
    release(&rig, 'Q', 4);
    press_as(&rig, KEYCODE_CAPS_LOCK, 0, 5);
    release(&rig, KEYCODE_CAPS_LOCK, 6);
    press_as(&rig, KEYCODE_CONTROL, 0, 7);
    press_as(&rig, KEYCODE_ALT, 0, 8);
    press_as(&rig, KEYCODE_CAPS_LOCK, 0, 9);
    press_as(&rig, 0, 'x', 10);
    assert_true(inp_keyboard_ready(&rig.keyboard));
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), KEY_READY);
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), 10);
    assert_int_equal(event(&rig), 0x80019000);
    assert_int_equal(event(&rig), 0x80015151);
    assert_int_equal(event(&rig), 0x80109000);
    assert_int_equal(event(&rig), 0x80105100);
    assert_int_equal(event(&rig), 0x80089300);
    assert_int_equal(event(&rig), 0x80189300);
    assert_int_equal(event(&rig), 0x800A9100);
    assert_int_equal(event(&rig), 0x800E9200);
    assert_int_equal(event(&rig), 0x80069300);
    assert_int_equal(event(&rig), 0x80060078);
    assert_int_equal(event(&rig), 0);
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), 0);
}

static void what_does_not_change_is_no_event(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE | KEY_CONSOLE);
    release(&rig, 'Q', 1);
    press_as(&rig, 'Q', 'q', 2);
    press_as(&rig, 'Q', 'q', 3);
    release(&rig, 'Q', 4);
    release(&rig, 'Q', 5);
    press_as(&rig, 0, 0, 6); /* no key, no character */
    release(&rig, 0, 7);
    press_as(&rig, 0, 'a', 8);
    press_as(&rig, 0, 'a', 9); /* the key that is not known is not held */
    assert_int_equal(event(&rig), 0x80005171);
    assert_int_equal(event(&rig), 0x80105100);
    assert_int_equal(event(&rig), 0x80000061);
    assert_int_equal(event(&rig), 0x80000061);
    assert_int_equal(event(&rig), 0);
    assert_sent(&rig, "qaa", 3);
    /* Other verbs mean nothing to it. */
    for (unsigned verb = 0; verb < INP_VERBS; verb++) {
        struct inp_act act = {.device = INP_KEYBOARD, .verb = (uint8_t)verb, .code = 'Q'};
        if (verb != INP_PRESS && verb != INP_RELEASE)
            inp_keyboard_act(&rig.keyboard, &act, 10);
    }
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), 0);
}

static void the_newest_is_lost_when_the_store_is_full(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    for (unsigned i = 0; i < 100; i++) { /* so that the ring turns */
        press_as(&rig, 0, 'x', i);
        assert_int_equal(event(&rig), KEY_VALID | 'x');
    }
    for (unsigned i = 0; i < KEY_EVENTS_MOST + 7; i++)
        press_as(&rig, 0, (uint8_t)(1 + i % 100), i);
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), KEY_READY | KEY_LOST);
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), KEY_EVENTS_MOST);
    assert_int_equal(read_at(&rig, INPUT_KEY_MISSED), 7);
    for (unsigned i = 0; i < KEY_EVENTS_MOST; i++)
        assert_int_equal(event(&rig), KEY_VALID | (1 + i % 100));
    assert_int_equal(event(&rig), 0);
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), KEY_LOST);
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_STATUS, KEY_READY, 1));
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), KEY_LOST);
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_STATUS, KEY_LOST, 1));
    assert_int_equal(read_at(&rig, INPUT_KEY_STATUS), 0);
    assert_int_equal(read_at(&rig, INPUT_KEY_MISSED), 7);
}

static void a_repeat_that_is_lost_is_no_event_stored(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    for (unsigned i = 0; i < KEY_EVENTS_MOST - 1; i++)
        press_as(&rig, 0, 'x', i);
    press_as(&rig, 'Q', 'q', 1);
    assert_false(inp_keyboard_event(&rig.keyboard, inp_keyboard_next(&rig.keyboard)));
    assert_int_equal(read_at(&rig, INPUT_KEY_MISSED), 1);
    event(&rig);
    assert_true(inp_keyboard_event(&rig.keyboard, inp_keyboard_next(&rig.keyboard)));
    assert_int_equal(read_at(&rig, INPUT_KEY_MISSED), 1);
}

static void registers_are_those_of_its_block(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, ~UINT32_C(0));
    assert_int_equal(read_at(&rig, INPUT_KEY_CONTROL), KEY_CONSOLE | KEY_STORE);
    for (uint32_t offset = 0; offset < INPUT_REGISTERS_END; offset++) {
        uint32_t value;
        bool own = offset >= INPUT_KEY_STATUS && offset <= INPUT_KEY_MISSED && offset % 4 == 0;
        assert_int_equal(inp_keyboard_read(&rig.keyboard, offset, &value), own);
        if (offset != INPUT_KEY_CONTROL)
            assert_int_equal(inp_keyboard_write(&rig.keyboard, offset, 0, 0), own);
    }
    press_as(&rig, 'Q', 'q', 1);
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_EVENT, ~UINT32_C(0), 2));
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_WAITING, 0, 2));
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_MISSED, 9, 2));
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), 1);
    assert_int_equal(read_at(&rig, INPUT_KEY_MISSED), 0);
}

static void reset_keeps_the_hands_where_they_are(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    press_as(&rig, KEYCODE_SHIFT, 0, 1);
    press_as(&rig, KEYCODE_CAPS_LOCK, 0, 1);
    press_as(&rig, 'Q', 'Q', 2);
    inp_keyboard_reset(&rig.keyboard, 3);
    assert_int_equal(read_at(&rig, INPUT_KEY_CONTROL), KEY_CONSOLE);
    assert_int_equal(read_at(&rig, INPUT_KEY_WAITING), 0);
    assert_true(inp_keyboard_next(&rig.keyboard) == UINT64_MAX);
    assert_true(inp_keyboard_write(&rig.keyboard, INPUT_KEY_CONTROL, KEY_STORE, 4));
    press_as(&rig, 'Q', 'Q', 5); /* still held */
    assert_int_equal(event(&rig), 0);
    release(&rig, 'Q', 6);
    assert_int_equal(event(&rig), 0x80115100); /* with shift, caps lock off */
}

/* ---- repeat ------------------------------------------------------------------------------------ */

static void a_held_key_repeats_at_exact_times(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE | KEY_CONSOLE);
    const uint64_t pressed = 123456789;
    press_as(&rig, 'Q', 'q', pressed);
    assert_int_equal(event(&rig), 0x80005171);
    assert_sent(&rig, "q", 1);
    for (uint64_t n = 0; n < 1000; n++) {
        /* half a second, then n thirtieths */
        uint64_t due = pressed + 500 * MS + n * 1000 * MS / 30;
        assert_int_equal(inp_keyboard_next(&rig.keyboard), due);
        assert_false(inp_keyboard_event(&rig.keyboard, due - 1));
        assert_true(inp_keyboard_event(&rig.keyboard, due));
        assert_int_equal(event(&rig), 0x80205171);
        assert_int_equal(rig.last, due);
        assert_sent(&rig, "q", 1);
    }
    release(&rig, 'Q', pressed + 40000 * MS);
    assert_true(inp_keyboard_next(&rig.keyboard) == UINT64_MAX);
    assert_false(inp_keyboard_event(&rig.keyboard, 50000 * MS));
}

static void figures_set_when_it_repeats(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    rig.setup.repeat_after.value = 10000;
    rig.setup.repeat_rate.value = 0.1;
    press_as(&rig, 'Q', 'q', 5);
    for (uint64_t n = 0; n < 5; n++) {
        assert_int_equal(inp_keyboard_next(&rig.keyboard), 5 + 10 * MS + n * 10000 * MS);
        assert_true(inp_keyboard_event(&rig.keyboard, inp_keyboard_next(&rig.keyboard)));
    }
}

static bool repeats_now(const struct rig *rig)
{
    return inp_keyboard_next(&rig->keyboard) != UINT64_MAX;
}

static void a_vt100s_keys_repeat(void **state)
{
    (void)state;
    static struct rig rig;
    static const uint8_t never[] = {KEYCODE_ESCAPE,    KEYCODE_TAB,       KEYCODE_ENTER,
                                    KEYCODE_PAD_ENTER, KEYCODE_SHIFT,     KEYCODE_CONTROL,
                                    KEYCODE_ALT,       KEYCODE_CAPS_LOCK, KEYCODE_SUPER};
    for (unsigned code = 0; code < 256; code++) {
        bool expected = code != 0 && !memchr(never, (int)code, sizeof never);
        rig_init(&rig, KEY_STORE);
        press_as(&rig, (uint8_t)code, 'x', 1);
        assert_int_equal(repeats_now(&rig), expected);
        rig_init(&rig, KEY_STORE);
        press_as(&rig, KEYCODE_CONTROL, 0, 1);
        press_as(&rig, (uint8_t)code, 'x', 2);
        assert_false(repeats_now(&rig));
    }
}

static void the_key_pressed_last_repeats(void **state)
{
    (void)state;
    static struct rig rig;
    rig_init(&rig, KEY_STORE);
    press_as(&rig, 'Q', 'q', 0);
    press_as(&rig, 'W', 'w', 100 * MS);
    assert_int_equal(inp_keyboard_next(&rig.keyboard), 600 * MS);
    release(&rig, 'Q', 200 * MS); /* another: it goes on */
    press_as(&rig, KEYCODE_SHIFT, 0, 300 * MS);
    assert_int_equal(inp_keyboard_next(&rig.keyboard), 600 * MS);
    for (int i = 0; i < 4; i++)
        event(&rig);
    assert_true(inp_keyboard_event(&rig.keyboard, 600 * MS));
    assert_int_equal(event(&rig), 0x80215777); /* what the press made, with shift */
    press_as(&rig, KEYCODE_CONTROL, 0, 610 * MS);
    assert_false(repeats_now(&rig));
    release(&rig, KEYCODE_CONTROL, 620 * MS);
    assert_false(repeats_now(&rig));
    press_as(&rig, 'E', 'e', 630 * MS);
    assert_true(repeats_now(&rig));
    press_as(&rig, 'E', 'e', 640 * MS); /* it is held: nothing happens */
    assert_int_equal(inp_keyboard_next(&rig.keyboard), 1130 * MS);
    release(&rig, 'E', 650 * MS);
    assert_false(repeats_now(&rig)); /* though W is held */
}

/* ---- a US keyboard ------------------------------------------------------------------------------- */

static void every_character_has_its_key(void **state)
{
    (void)state;
    /* Row by row as it is printed on the keys. */
    static const char plain[] = "`1234567890-=qwertyuiop[]\\asdfghjkl;'zxcvbnm,./ ";
    static const char shifted[] = "~!@#$%^&*()_+QWERTYUIOP{}|ASDFGHJKL:\"ZXCVBNM<>? ";
    bool shift;
    unsigned count = 0;
    for (size_t i = 0; plain[i]; i++) {
        uint8_t code = inp_key_of((uint8_t)plain[i], &shift);
        assert_false(shift);
        assert_int_equal(code, plain[i] >= 'a' && plain[i] <= 'z' ? plain[i] - 32 : plain[i]);
        assert_int_equal(inp_key_us(code, 0), plain[i]);
        assert_int_equal(inp_key_us(code, KEYMOD_SHIFT), shifted[i]);
        assert_int_equal(inp_key_us(code, KEYMOD_ALT), plain[i]);
        bool letter = code >= 'A' && code <= 'Z';
        assert_int_equal(inp_key_us(code, KEYMOD_CAPS), letter ? shifted[i] : plain[i]);
        assert_int_equal(inp_key_us(code, KEYMOD_CAPS | KEYMOD_SHIFT),
                         letter ? plain[i] : shifted[i]);
        assert_int_equal(inp_key_of((uint8_t)shifted[i], &shift), code);
        assert_int_equal(shift, shifted[i] != ' ');
        count++;
    }
    assert_int_equal(count, 48);
    for (unsigned c = 0; c < 256; c++)
        if ((c < ' ' && !strchr("\r\n\t\b\033", (int)c)) || c > 0x7F || c == 0)
            assert_int_equal(inp_key_of((uint8_t)c, &shift), 0);
    assert_int_equal(inp_key_of('\n', &shift), KEYCODE_ENTER);
    assert_int_equal(inp_key_of('\r', &shift), KEYCODE_ENTER);
    assert_int_equal(inp_key_of('\t', &shift), KEYCODE_TAB);
    assert_int_equal(inp_key_of('\b', &shift), KEYCODE_BACKSPACE);
    assert_int_equal(inp_key_of(0x7F, &shift), KEYCODE_BACKSPACE);
    assert_int_equal(inp_key_of(0x1B, &shift), KEYCODE_ESCAPE);
}

static void keys_without_shift_make_the_same_always(void **state)
{
    (void)state;
    static const char pad[] = "0123456789./*-+\r=";
    for (unsigned modifiers = 0; modifiers < 16; modifiers++) {
        for (unsigned i = 0; pad[i]; i++)
            assert_int_equal(inp_key_us((uint8_t)(KEYCODE_PAD_0 + i), modifiers), pad[i]);
        assert_int_equal(inp_key_us(KEYCODE_ENTER, modifiers), '\r');
        assert_int_equal(inp_key_us(KEYCODE_TAB, modifiers), '\t');
        assert_int_equal(inp_key_us(KEYCODE_BACKSPACE, modifiers), 0x7F);
        assert_int_equal(inp_key_us(KEYCODE_ESCAPE, modifiers), 0x1B);
        for (uint8_t code = KEYCODE_UP; code <= KEYCODE_F12; code++)
            assert_int_equal(inp_key_us(code, modifiers), 0);
        assert_int_equal(inp_key_us(0, modifiers), 0);
    }
}

static void names_are_found_again(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint8_t code;
    } some[] = {{"A", 'A'},
                {"z", 'Z'},
                {"`", '`'},
                {"\\", '\\'},
                {"/", '/'},
                {"space", ' '},
                {"F1", KEYCODE_F1},
                {"f10", KEYCODE_F1 + 9},
                {"F12", KEYCODE_F12},
                {"Page_Up", KEYCODE_PAGE_UP},
                {"CAPS_LOCK", KEYCODE_CAPS_LOCK},
                {"PAD_0", KEYCODE_PAD_0},
                {"PAD_EQUAL", KEYCODE_PAD_EQUAL},
                {"MENU", KEYCODE_MENU}};
    static const char *const none[] = {"", " ", "!", "FF", "F13", "F0", "ENTE", "ENTERS", "\x80"};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++)
        assert_int_equal(inp_key_named(some[i].name, strlen(some[i].name)), some[i].code);
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_int_equal(inp_key_named(none[i], strlen(none[i])), 0);
    assert_int_equal(inp_key_named("F12", 2), KEYCODE_F1);
    char name_of[8];
    for (unsigned i = 0; i < 12; i++) {
        snprintf(name_of, sizeof name_of, "F%u", i + 1);
        assert_string_equal(inp_key_name((uint8_t)(KEYCODE_F1 + i)), name_of);
    }
    for (unsigned i = 0; i < 10; i++) {
        snprintf(name_of, sizeof name_of, "PAD_%u", i);
        assert_string_equal(inp_key_name((uint8_t)(KEYCODE_PAD_0 + i)), name_of);
    }
    unsigned named = 0;
    for (unsigned code = 0; code < 256; code++) {
        const char *name = inp_key_name((uint8_t)code);
        if (!name)
            continue;
        assert_int_equal(inp_key_named(name, strlen(name)), code);
        named++;
    }
    assert_int_equal(named, 48 + 14 + 6 + 12 + 17);
}

/* ---- snapshots --------------------------------------------------------------------------------- */

/* xorshift64*: the same numbers everywhere. */
static uint64_t random_bits(uint64_t *seed)
{
    *seed ^= *seed >> 12;
    *seed ^= *seed << 25;
    *seed ^= *seed >> 27;
    return *seed * UINT64_C(2685821657736338717);
}

/* Something that can happen, the same of the same seed; everything seen is mixed into `hash`. */
static void happen(struct rig *rig, uint64_t *seed, uint64_t *t, uint64_t *hash)
{
    static const uint8_t codes[] = {
        0,   'A', 'B', KEYCODE_SHIFT, KEYCODE_CONTROL, KEYCODE_CAPS_LOCK,
        'C', 'D', '1', KEYCODE_ALT,   KEYCODE_ENTER,   KEYCODE_UP};
    uint64_t n = random_bits(seed);
    uint8_t code = codes[(n >> 8) % sizeof codes];
    uint64_t next = inp_keyboard_next(&rig->keyboard), seen = 0;
    *t += (n >> 16) % (300 * MS);
    while (next <= *t) {
        seen += inp_keyboard_event(&rig->keyboard, next);
        next = inp_keyboard_next(&rig->keyboard);
    }
    switch (n % 8) {
    case 0:
    case 1:
    case 2:
        press_as(rig, code, (uint8_t)('a' + (n >> 60)), *t);
        break;
    case 3:
    case 4:
        release(rig, code, *t);
        break;
    case 5:
        seen += event(rig);
        break;
    case 6:
        seen += read_at(rig, INPUT_KEY_STATUS) + read_at(rig, INPUT_KEY_MISSED) * 4u;
        break;
    default:
        if ((n >> 40) % 8 == 0)
            assert_true(
                inp_keyboard_write(&rig->keyboard, INPUT_KEY_CONTROL, (n >> 50 & 1) | 2, *t));
        break;
    }
    *hash = (*hash ^ seen ^ next ^ rig->sendings ^ rig->last) * UINT64_C(0x100000001b3);
    for (; rig->length > 0; rig->length--)
        *hash = (*hash ^ (uint8_t)rig->sent[rig->length - 1]) * UINT64_C(0x100000001b3);
}

static void a_loaded_keyboard_goes_on_alike(void **state)
{
    (void)state;
    static struct rig rig, other;
    for (uint64_t run = 1; run <= 60; run++) {
        uint64_t seed = run * UINT64_C(0x9E3779B97F4A7C15), t = 0, hash = 0;
        rig_init(&rig, KEY_STORE | KEY_CONSOLE);
        for (uint64_t i = 0; i < run * 40; i++)
            happen(&rig, &seed, &t, &hash);
        struct crt_state s;
        crt_state_save(&s);
        inp_keyboard_state(&rig.keyboard, &s);
        assert_false(s.failed);
        rig_init(&other, 0);
        press_as(&other, 'Z', 'z', 1);
        other.sendings = rig.sendings;
        other.last = rig.last;
        struct crt_state load;
        crt_state_load(&load, s.out, s.size);
        inp_keyboard_state(&other.keyboard, &load);
        assert_false(load.failed);
        assert_int_equal(load.at, s.size);
        crt_state_free(&s);
        uint64_t seed_other = seed, t_other = t, hash_other = hash;
        for (int i = 0; i < 400; i++) {
            happen(&rig, &seed, &t, &hash);
            happen(&other, &seed_other, &t_other, &hash_other);
            assert_true(hash == hash_other);
        }
    }
}

/* A small snapshot: status, control, missed, 8 words held, caps, repeating, character, from, repeats,
 * waiting, events; behind 16 bytes of tag, version and length. */
#define HEAD 16
enum { STATUS = HEAD, CONTROL = HEAD + 4, HELD = HEAD + 12, CAPS = HELD + 32 };
enum { REPEATING = CAPS + 1, MADE, FROM, REPEATS = FROM + 8, WAITING = REPEATS + 8 };
enum { EVENTS = WAITING + 4 };

static bool loads(const uint8_t *bytes, size_t size)
{
    static struct rig rig;
    struct crt_state s;
    rig_init(&rig, 0);
    crt_state_load(&s, bytes, size);
    inp_keyboard_state(&rig.keyboard, &s);
    if (s.failed) /* whatever it holds now is not used, but must not be wild */
        assert_true(rig.keyboard.waiting <= KEY_EVENTS_MOST);
    return !s.failed;
}

static void refused_with(uint8_t *bytes, size_t size, size_t at, uint8_t value)
{
    uint8_t was = bytes[at];
    bytes[at] = value;
    assert_false(loads(bytes, size));
    bytes[at] = was;
}

static void hostile_snapshots_are_refused(void **state)
{
    (void)state;
    static struct rig rig;
    struct crt_state s;
    rig_init(&rig, KEY_STORE);
    press_as(&rig, 'Q', 'q', 1000);
    crt_state_save(&s);
    inp_keyboard_state(&rig.keyboard, &s);
    assert_int_equal(s.size, EVENTS + 4);
    uint8_t *b = s.out;
    assert_true(loads(b, s.size));
    refused_with(b, s.size, STATUS, KEY_READY);
    refused_with(b, s.size, CONTROL, 4);
    refused_with(b, s.size, HELD, 1);           /* the key that is not known */
    refused_with(b, s.size, HELD + 'Q' / 8, 0); /* it repeats and is not held */
    refused_with(b, s.size, HELD + KEYCODE_CONTROL / 8, 1 << KEYCODE_CONTROL % 8);
    refused_with(b, s.size, CAPS, 2);
    refused_with(b, s.size, REPEATING, 'R');
    refused_with(b, s.size, REPEATING, 0);
    refused_with(b, s.size, FROM + 7, 0x80);
    refused_with(b, s.size, REPEATS + 7, 0x7F); /* its time would be beyond 64 bits */
    refused_with(b, s.size, WAITING + 1, 2);
    refused_with(b, s.size, EVENTS, 0x80);
    refused_with(b, s.size, EVENTS + 2, 0x40);
    refused_with(b, s.size, EVENTS + 3, 0);
    for (size_t size = 0; size < s.size; size++)
        assert_false(loads(b, size));
    crt_state_free(&s);
}

/* Whatever loads can be used. */
static void what_loads_is_sane(void **state)
{
    (void)state;
    static struct rig rig;
    uint64_t seed = 77;
    unsigned loaded = 0;
    for (int run = 0; run < 3000; run++) {
        struct crt_state s, load;
        rig_init(&rig, KEY_STORE);
        press_as(&rig, 'Q', 'q', 1000);
        crt_state_save(&s);
        inp_keyboard_state(&rig.keyboard, &s);
        for (int i = 0; i < 1 + run % 3; i++) {
            uint64_t n = random_bits(&seed);
            s.out[HEAD + (n >> 8) % (s.size - HEAD)] = (uint8_t)n;
        }
        crt_state_load(&load, s.out, s.size);
        inp_keyboard_state(&rig.keyboard, &load);
        if (!load.failed) {
            loaded++;
            for (int i = 0; i < 10; i++) {
                uint64_t next = inp_keyboard_next(&rig.keyboard);
                if (next == UINT64_MAX)
                    break;
                inp_keyboard_event(&rig.keyboard, next);
                assert_true(inp_keyboard_next(&rig.keyboard) > next);
            }
            uint64_t t = 0, hash = 0;
            for (int i = 0; i < 20; i++)
                happen(&rig, &seed, &t, &hash);
            assert_true(rig.keyboard.waiting <= KEY_EVENTS_MOST);
        }
        crt_state_free(&s);
    }
    assert_in_range(loaded, 100, 2900);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(presses_are_sent_as_a_terminal_does),
        cmocka_unit_test(nothing_is_sent_while_the_console_is_off),
        cmocka_unit_test(a_keyboard_without_a_console_is_no_trouble),
        cmocka_unit_test(power_on_sends_and_stores_nothing),
        cmocka_unit_test(events_come_in_order_with_their_modifiers),
        cmocka_unit_test(what_does_not_change_is_no_event),
        cmocka_unit_test(the_newest_is_lost_when_the_store_is_full),
        cmocka_unit_test(a_repeat_that_is_lost_is_no_event_stored),
        cmocka_unit_test(registers_are_those_of_its_block),
        cmocka_unit_test(reset_keeps_the_hands_where_they_are),
        cmocka_unit_test(a_held_key_repeats_at_exact_times),
        cmocka_unit_test(figures_set_when_it_repeats),
        cmocka_unit_test(a_vt100s_keys_repeat),
        cmocka_unit_test(the_key_pressed_last_repeats),
        cmocka_unit_test(every_character_has_its_key),
        cmocka_unit_test(keys_without_shift_make_the_same_always),
        cmocka_unit_test(names_are_found_again),
        cmocka_unit_test(a_loaded_keyboard_goes_on_alike),
        cmocka_unit_test(hostile_snapshots_are_refused),
        cmocka_unit_test(what_loads_is_sane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
