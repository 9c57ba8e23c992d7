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

bool words_bounded(struct words *w, float low, float high, float *out)
{
    float value;
    const char *word = words_peek(w);
    if (!words_number(w, &value))
        return false;
    if (value < low || value > high) {
        w->next--;
        return words_refuse(w, "%.40s is not within %.7g and %.7g", word, (double)low,
                            (double)high);
    }
    *out = value;
    return true;
}

bool words_amount(struct words *w, float *out)
{
    return words_bounded(w, -WORDS_FARTHEST, WORDS_FARTHEST, out);
}

bool words_amounts(struct words *w, float *out, int count)
{
    for (int i = 0; i < count; i++)
        if (!words_amount(w, &out[i]))
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

/* ---- points ---------------------------------------------------------------------------------- */

bool words_point(struct words *w, float limit, struct point2 *out)
{
    return words_bounded(w, -limit, limit, &out->x) && words_bounded(w, -limit, limit, &out->y);
}

bool words_vector(struct words *w, float limit, struct vector3 *out)
{
    return words_bounded(w, -limit, limit, &out->x) && words_bounded(w, -limit, limit, &out->y) &&
           words_bounded(w, -limit, limit, &out->z);
}

bool words_direction(struct words *w, int dimensions, float limit, struct vector3 *out)
{
    float v[3] = {0, 0, 0};
    for (int i = 0; i < dimensions; i++)
        if (!words_bounded(w, -limit, limit, &v[i]))
            return false;
    float largest = fmaxf(fmaxf(fabsf(v[0]), fabsf(v[1])), fabsf(v[2]));
    if (largest == 0)
        return words_refuse(w, "a vector of length 0 has no direction");
    int exponent = 0;
    if (largest < 0x1p-10f)
        frexpf(largest, &exponent);
    *out =
        (struct vector3){ldexpf(v[0], -exponent), ldexpf(v[1], -exponent), ldexpf(v[2], -exponent)};
    return true;
}

/* Does the next word begin as numbers do? It may be too large to be one, which is to be said. */
static bool numeric(const struct words *w)
{
    const char *c = words_peek(w);
    c += *c == '-' || *c == '+';
    c += *c == '.';
    return *c >= '0' && *c <= '9';
}

/* Another point in v, after `count` of them. False: there is none, or trouble. */
static bool another(struct words *w, int dimensions, struct words_wanted wanted, int count,
                    float *v)
{
    bool enough = count >= wanted.least;
    if (!numeric(w) && enough)
        return false;
    if (words_left(w) == 0)
        return words_refuse(
            w, wanted.least == 1 ? "at least %d point is needed" : "at least %d points are needed",
            wanted.least);
    if (count == wanted.most)
        return words_refuse(w, wanted.most == 1 ? "at most %d point" : "at most %d points",
                            wanted.most);
    for (int i = 0; i < dimensions; i++) {
        if (i > 0 && words_left(w) == 0)
            return words_refuse(w, "the last point has no %c", "xyz"[i]);
        if (!words_bounded(w, -wanted.limit, wanted.limit, &v[i]))
            return false;
    }
    return true;
}

bool words_points2(struct words *w, struct words_wanted wanted, struct point2 *out, int *count)
{
    float v[2];
    for (*count = 0; another(w, 2, wanted, *count, v); ++*count)
        out[*count] = (struct point2){v[0], v[1]};
    return w->trouble[0] == '\0';
}

bool words_points(struct words *w, int dimensions, struct words_wanted wanted, struct vector3 *out,
                  int *count)
{
    float v[3] = {0, 0, 0};
    for (*count = 0; another(w, dimensions, wanted, *count, v); ++*count)
        out[*count] = (struct vector3){v[0], v[1], v[2]};
    return w->trouble[0] == '\0';
}

/* ---- other words ----------------------------------------------------------------------------- */

bool words_rest(struct words *w, char *text, size_t room)
{
    size_t length = 0;
    if (words_left(w) == 0)
        return missing(w, "a text");
    for (; words_left(w) > 0; w->next++) {
        const char *word = words_peek(w);
        size_t more = strlen(word) + (length > 0);
        if (length + more >= room)
            return words_refuse(w, "the text has more than %d characters", (int)room - 1);
        snprintf(text + length, room - length, "%s%s", length > 0 ? " " : "", word);
        length += more;
    }
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
