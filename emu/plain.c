#include "emu/plain.h"

#include <string.h>

#define LONGEST 5 /* bytes that a character becomes, and a NUL */

static const struct {
    const char *from, *to;
} plain[] = {{"²", "2"},    {"³", "3"},  {"µ", "u"},  {"μ", "u"},   {"×", "x"},  {"÷", "/"},
             {"°", " deg"}, {"·", "-"},  {"–", "-"},  {"—", "-"},   {"−", "-"},  {"…", "..."},
             {"≥", ">="},   {"≤", "<="}, {"±", "+-"}, {"≈", "~"},   {"“", "\""}, {"”", "\""},
             {"‘", "'"},    {"’", "'"},  {"→", "->"}, {"½", "1/2"}, {"ä", "ae"}, {"ö", "oe"},
             {"ü", "ue"},   {"ß", "ss"}, {"é", "e"},  {"è", "e"}};

static size_t find(const char *text)
{
    size_t i = 0;
    while (i < sizeof plain / sizeof *plain &&
           strncmp(text, plain[i].from, strlen(plain[i].from)) != 0)
        i++;
    return i;
}

/* A character that has no spelling; its further bytes are 10xxxxxx. */
static const char *skip(const char *text)
{
    text++;
    while (((unsigned char)*text & 0xC0) == 0x80)
        text++;
    return text;
}

void vm_plain(const char *text, char *out, size_t size)
{
    size_t n = 0;
    while (*text && n + LONGEST < size) {
        size_t i = find(text);
        if (i < sizeof plain / sizeof *plain) {
            memcpy(out + n, plain[i].to, strlen(plain[i].to));
            n += strlen(plain[i].to);
            text += strlen(plain[i].from);
        } else if ((unsigned char)*text < 0x80) {
            out[n++] = *text++;
        } else {
            out[n++] = '?';
            text = skip(text);
        }
    }
    out[n] = '\0';
}
