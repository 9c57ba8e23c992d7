/* What a terminal sends for keys. */
#include <string.h>

#include "input/keyboard.h"

/* Keys that make no character. */
static const struct {
    uint8_t code;
    const char *sent;
} sequences[] = {
    {KEYCODE_UP, "\x1B[A"},         {KEYCODE_DOWN, "\x1B[B"},      {KEYCODE_RIGHT, "\x1B[C"},
    {KEYCODE_LEFT, "\x1B[D"},       {KEYCODE_HOME, "\x1B[H"},      {KEYCODE_END, "\x1B[F"},
    {KEYCODE_INSERT, "\x1B[2~"},    {KEYCODE_DELETE, "\x1B[3~"},   {KEYCODE_PAGE_UP, "\x1B[5~"},
    {KEYCODE_PAGE_DOWN, "\x1B[6~"}, {KEYCODE_MENU, "\x1B[29~"},    {KEYCODE_F1, "\x1BOP"},
    {KEYCODE_F1 + 1, "\x1BOQ"},     {KEYCODE_F1 + 2, "\x1BOR"},    {KEYCODE_F1 + 3, "\x1BOS"},
    {KEYCODE_F1 + 4, "\x1B[15~"},   {KEYCODE_F1 + 5, "\x1B[17~"},  {KEYCODE_F1 + 6, "\x1B[18~"},
    {KEYCODE_F1 + 7, "\x1B[19~"},   {KEYCODE_F1 + 8, "\x1B[20~"},  {KEYCODE_F1 + 9, "\x1B[21~"},
    {KEYCODE_F1 + 10, "\x1B[23~"},  {KEYCODE_F1 + 11, "\x1B[24~"},
};

/* Ctrl with space or @ is NUL, which is no character of an event. */
static bool is_nul(uint8_t code, uint8_t character, unsigned modifiers)
{
    if (!(modifiers & KEYMOD_CONTROL))
        return false;
    if (!character)
        character = inp_key_us(code, modifiers & ~(unsigned)KEYMOD_CONTROL);
    return character == ' ' || character == '@';
}

size_t inp_key_sent(uint8_t code, uint8_t character, unsigned modifiers, char bytes[8])
{
    for (size_t i = 0; i < sizeof sequences / sizeof *sequences; i++)
        if (sequences[i].code == code) {
            size_t length = strlen(sequences[i].sent);
            memcpy(bytes, sequences[i].sent, length);
            return length;
        }
    uint8_t made = inp_key_makes(code, character, modifiers);
    if (!made && !is_nul(code, character, modifiers))
        return 0;
    /* Alt puts ESC before what the key makes without it; what it makes only with it goes alone (AltGr
     * of some layouts). */
    size_t length = 0;
    if (modifiers & KEYMOD_ALT && made == inp_key_us(code, modifiers))
        bytes[length++] = 0x1B;
    bytes[length++] = (char)made;
    return length;
}
