#include "roms/monitor/words.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool words_refuse(struct words *w, const char *format, ...)
{
    va_list list;
    if (w->trouble[0] != '\0')
        return false;
    va_start(list, format);
    vsnprintf(w->trouble, sizeof w->trouble, format, list);
    va_end(list);
    return false;
}

bool words_cut(struct words *w, char *line)
{
    *w = (struct words){0};
    while (*line != '\0') {
        line += strspn(line, " \t");
        if (*line == '\0')
            break;
        if (w->count == WORDS_MOST)
            return words_refuse(w, "a command has at most %d words", WORDS_MOST);
        w->at[w->count++] = line;
        line += strcspn(line, " \t");
        if (*line != '\0')
            *line++ = '\0';
    }
    return true;
}

int words_left(const struct words *w)
{
    return w->count - w->next;
}

const char *words_peek(const struct words *w)
{
    return w->next < w->count ? w->at[w->next] : "";
}

bool words_next_is(const struct words *w, const char *word)
{
    return strcmp(words_peek(w), word) == 0;
}

bool words_take(struct words *w, const char *word)
{
    bool is = words_next_is(w, word);
    w->next += is;
    return is;
}

/* A number, or a fraction of two; false: something else, or not finite. */
static bool parse(const char *text, float *out)
{
    char *end;
    if (strchr("+-.0123456789", *text) == NULL || *text == '\0' || strpbrk(text, "xXpPnN") != NULL)
        return false;
    float value = strtof(text, &end);
    if (*end == '/' && end[1] >= '0' && end[1] <= '9')
        value /= strtof(end + 1, &end);
    *out = value;
    return *end == '\0' && end != text && isfinite(value);
}

bool words_next_is_number(const struct words *w)
{
    float ignored;
    return parse(words_peek(w), &ignored);
}

static bool missing(struct words *w, const char *what)
{
    return words_refuse(w, "%s is missing", what);
}

bool words_number(struct words *w, float *out)
{
    if (words_left(w) == 0)
        return missing(w, "a number");
    if (!parse(words_peek(w), out))
        return words_refuse(w, "\"%.40s\" is not a number", words_peek(w));
    w->next++;
    return true;
}

bool words_numbers(struct words *w, float *out, int count)
{
    for (int i = 0; i < count; i++)
        if (!words_number(w, &out[i]))
            return false;
    return true;
}

bool words_whole(struct words *w, int low, int high, int *out)
{
    float value;
    if (words_left(w) == 0)
        return missing(w, "a whole number");
    if (!parse(words_peek(w), &value) || value != floorf(value))
        return words_refuse(w, "\"%.40s\" is not a whole number", words_peek(w));
    if (value < (float)low || value > (float)high)
        return words_refuse(w, "%.40s is not within %d and %d", words_peek(w), low, high);
    *out = (int)value;
    w->next++;
    return true;
}

bool words_choice(struct words *w, const char *const *names, int *out)
{
    if (words_left(w) == 0)
        return missing(w, "a word");
    for (int i = 0; names[i] != NULL; i++) {
        if (words_take(w, names[i])) {
            *out = i;
            return true;
        }
    }
    return words_refuse(w, "\"%.40s\" is not known here", words_peek(w));
}

bool words_end(struct words *w)
{
    if (words_left(w) == 0)
        return true;
    return words_refuse(w, "\"%.40s\" is too much", words_peek(w));
}
