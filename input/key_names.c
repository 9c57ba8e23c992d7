/* Keys of a US keyboard: their names, and what they make. */
#include <string.h>

#include "input/keyboard.h"

/* ---- names ------------------------------------------------------------------------------------- */

static const char *const named[256] = {
    [' '] = "SPACE",
    [KEYCODE_ENTER] = "ENTER",
    [KEYCODE_TAB] = "TAB",
    [KEYCODE_BACKSPACE] = "BACKSPACE",
    [KEYCODE_ESCAPE] = "ESCAPE",
    [KEYCODE_UP] = "UP",
    [KEYCODE_DOWN] = "DOWN",
    [KEYCODE_LEFT] = "LEFT",
    [KEYCODE_RIGHT] = "RIGHT",
    [KEYCODE_HOME] = "HOME",
    [KEYCODE_END] = "END",
    [KEYCODE_INSERT] = "INSERT",
    [KEYCODE_DELETE] = "DELETE",
    [KEYCODE_PAGE_UP] = "PAGE_UP",
    [KEYCODE_PAGE_DOWN] = "PAGE_DOWN",
    [KEYCODE_SHIFT] = "SHIFT",
    [KEYCODE_CONTROL] = "CONTROL",
    [KEYCODE_ALT] = "ALT",
    [KEYCODE_CAPS_LOCK] = "CAPS_LOCK",
    [KEYCODE_SUPER] = "SUPER",
    [KEYCODE_MENU] = "MENU",
    [KEYCODE_F1] = "F1",
    [KEYCODE_F1 + 1] = "F2",
    [KEYCODE_F1 + 2] = "F3",
    [KEYCODE_F1 + 3] = "F4",
    [KEYCODE_F1 + 4] = "F5",
    [KEYCODE_F1 + 5] = "F6",
    [KEYCODE_F1 + 6] = "F7",
    [KEYCODE_F1 + 7] = "F8",
    [KEYCODE_F1 + 8] = "F9",
    [KEYCODE_F1 + 9] = "F10",
    [KEYCODE_F1 + 10] = "F11",
    [KEYCODE_F12] = "F12",
    [KEYCODE_PAD_0] = "PAD_0",
    [KEYCODE_PAD_0 + 1] = "PAD_1",
    [KEYCODE_PAD_0 + 2] = "PAD_2",
    [KEYCODE_PAD_0 + 3] = "PAD_3",
    [KEYCODE_PAD_0 + 4] = "PAD_4",
    [KEYCODE_PAD_0 + 5] = "PAD_5",
    [KEYCODE_PAD_0 + 6] = "PAD_6",
    [KEYCODE_PAD_0 + 7] = "PAD_7",
    [KEYCODE_PAD_0 + 8] = "PAD_8",
    [KEYCODE_PAD_9] = "PAD_9",
    [KEYCODE_PAD_POINT] = "PAD_POINT",
    [KEYCODE_PAD_DIVIDE] = "PAD_DIVIDE",
    [KEYCODE_PAD_TIMES] = "PAD_TIMES",
    [KEYCODE_PAD_MINUS] = "PAD_MINUS",
    [KEYCODE_PAD_PLUS] = "PAD_PLUS",
    [KEYCODE_PAD_ENTER] = "PAD_ENTER",
    [KEYCODE_PAD_EQUAL] = "PAD_EQUAL",
};

/* The printable keys without shift and with it, letters aside. */
static const char plain[] = "`1234567890-=[]\\;',./";
static const char shifted[] = "~!@#$%^&*()_+{}|:\"<>?";

/* Names of one character: of `plain` in its order, then letters. */
static const char single[][2] = {"`", "1", "2", "3",  "4", "5", "6", "7", "8", "9", "0", "-",
                                 "=", "[", "]", "\\", ";", "'", ",", ".", "/", "A", "B", "C",
                                 "D", "E", "F", "G",  "H", "I", "J", "K", "L", "M", "N", "O",
                                 "P", "Q", "R", "S",  "T", "U", "V", "W", "X", "Y", "Z"};
#define LETTERS (sizeof plain - 1) /* where they begin */

static bool letter(uint8_t code)
{
    return code >= 'A' && code <= 'Z';
}

const char *inp_key_name(uint8_t code)
{
    const char *at = code ? strchr(plain, code) : NULL;
    if (letter(code))
        return single[LETTERS + (size_t)(code - 'A')];
    return at ? single[at - plain] : named[code];
}

static char upper(char c)
{
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

static bool same(const char *name, const char *text, size_t length)
{
    size_t i = 0;
    while (i < length && name[i] && name[i] == upper(text[i]))
        i++;
    return i == length && name[i] == '\0';
}

uint8_t inp_key_named(const char *name, size_t length)
{
    uint8_t code = length == 1 ? (uint8_t)upper(*name) : 0;
    if (code > ' ' && code < 0x80 && inp_key_name(code))
        return code;
    for (unsigned i = 0; i < 256; i++)
        if (named[i] && same(named[i], name, length))
            return (uint8_t)i;
    return 0;
}

/* ---- what they make --------------------------------------------------------------------------- */

static uint8_t pad(uint8_t code)
{
    static const char rest[] = "./*-+\r=";
    if (code <= KEYCODE_PAD_9)
        return (uint8_t)('0' + (code - KEYCODE_PAD_0));
    return (uint8_t)rest[code - KEYCODE_PAD_POINT];
}

/* The printable character, with shift and caps lock. */
static uint8_t printable(uint8_t code, unsigned modifiers)
{
    bool shift = modifiers & KEYMOD_SHIFT;
    if (letter(code))
        return (uint8_t)(shift != ((modifiers & KEYMOD_CAPS) != 0) ? code : code + ('a' - 'A'));
    const char *at = code ? strchr(plain, code) : NULL;
    if (!at)
        return code == ' ' ? ' ' : 0;
    return (uint8_t)(shift ? shifted[at - plain] : code);
}

/* The control character of a printable one; 0: NUL, or none. */
static uint8_t control(uint8_t character)
{
    uint8_t c = (uint8_t)upper((char)character);
    if (c == '~' || c == '`') /* a VT100's RS and US */
        return 0x1E;
    if (c == '?' || c == '/')
        return 0x1F;
    return c >= '@' && c <= '_' ? c & 0x1F : 0;
}

uint8_t inp_key_us(uint8_t code, unsigned modifiers)
{
    switch (code) {
    case KEYCODE_ENTER:
        return '\r';
    case KEYCODE_TAB:
        return '\t';
    case KEYCODE_BACKSPACE:
        return 0x7F;
    case KEYCODE_ESCAPE:
        return 0x1B;
    default:
        break;
    }
    if (code >= KEYCODE_PAD_0 && code <= KEYCODE_PAD_EQUAL)
        return pad(code);
    uint8_t c = printable(code, modifiers);
    return modifiers & KEYMOD_CONTROL ? control(c) : c;
}

uint8_t inp_key_of(uint8_t character, bool *shift)
{
    static const struct {
        uint8_t character, code;
    } own[] = {{'\r', KEYCODE_ENTER},     {'\n', KEYCODE_ENTER},     {'\t', KEYCODE_TAB},
               {'\b', KEYCODE_BACKSPACE}, {0x7F, KEYCODE_BACKSPACE}, {0x1B, KEYCODE_ESCAPE}};
    *shift = false;
    for (size_t i = 0; i < sizeof own / sizeof *own; i++)
        if (own[i].character == character)
            return own[i].code;
    uint8_t code = (uint8_t)upper((char)character);
    const char *at = character ? strchr(shifted, character) : NULL;
    *shift = at || letter(character);
    if (at)
        return (uint8_t)plain[at - shifted];
    return letter(code) || printable(code, 0) ? code : 0;
}

uint8_t inp_key_makes(uint8_t code, uint8_t character, unsigned modifiers)
{
    bool own = code == KEYCODE_ENTER || code == KEYCODE_TAB || code == KEYCODE_BACKSPACE ||
               code == KEYCODE_ESCAPE || code == KEYCODE_PAD_ENTER;
    if (character >= 0x80)
        character = 0;
    if (own && !character)
        return inp_key_us(code, 0);
    if (own || !(modifiers & KEYMOD_CONTROL) || (character && modifiers & KEYMOD_ALT))
        return character;
    if (!character)
        return inp_key_us(code, modifiers);
    return character < ' ' || character == 0x7F ? character : control(character);
}
