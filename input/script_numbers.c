/* Numbers, times and texts of a script. */
#include <stdio.h>
#include <string.h>

#include "input/script_parts.h"

static bool digit(char c)
{
    return c >= '0' && c <= '9';
}

/* ---- numbers ----------------------------------------------------------------------------------- */

bool inp_word_is_number(const struct inp_reader *r)
{
    const struct inp_word *word = &r->word;
    return word->kind == INP_WORD &&
           (digit(*word->start) || (word->length > 1 && strchr("+-.", *word->start)));
}

static bool expected(struct inp_reader *r, const char *what)
{
    char shown[INP_WORD_SHOWN];
    const char *text = inp_word_shown(r, shown);
    return inp_word_error(r, r->word.place, "%s, where %s is expected", text, what);
}

/* Digits at p as a number, held to `most` + 1. */
static const char *read_digits(const char *p, const char *end, int64_t most, int64_t *value)
{
    for (; p < end && digit(*p); p++) {
        *value = *value * 10 + (*p - '0');
        if (*value > most)
            *value = most + 1;
    }
    return p;
}

/* [-+]digits[.digits] as thousandths, held to somewhat more than INP_FURTHEST. */
enum number { NUMBER, NO_NUMBER, TOO_FINE };
static enum number read_thousandths(const struct inp_word *word, int64_t *value)
{
    const char *p = word->start, *end = p + word->length;
    bool minus = *p == '-';
    int64_t whole = 0, parts = 0;
    p += *p == '-' || *p == '+';
    const char *digits = p;
    p = read_digits(p, end, INP_FURTHEST, &whole);
    ptrdiff_t count = p - digits, places = 0;
    if (p < end && *p == '.') {
        digits = p + 1;
        p = read_digits(digits, end, INP_FURTHEST, &parts);
        places = p - digits;
    }
    if (p < end || count + places == 0)
        return NO_NUMBER;
    if (places > 3)
        return TOO_FINE;
    for (; places < 3; places++)
        parts *= 10;
    *value = whole * 1000 + parts;
    if (minus)
        *value = -*value;
    return NUMBER;
}

bool inp_word_thousandths(struct inp_reader *r, const char *what, int32_t low, int32_t high,
                          int32_t *value)
{
    int64_t number = 0;
    char shown[INP_WORD_SHOWN];
    enum number kind = NO_NUMBER;
    if (r->word.kind == INP_WORD)
        kind = read_thousandths(&r->word, &number);
    if (kind == NO_NUMBER)
        return expected(r, what);
    const char *text = inp_word_shown(r, shown);
    if (kind == TOO_FINE)
        return inp_word_error(r, r->word.place, "%s has more than three places", text);
    if (number < low || number > high)
        return inp_word_error(r, r->word.place, "%s is out of range: %s is %g to %g", text, what,
                              low / 1000.0, high / 1000.0);
    *value = (int32_t)number;
    return inp_word_next(r);
}

bool inp_word_whole(struct inp_reader *r, const char *what, unsigned most, unsigned *value)
{
    int64_t number = 0;
    char shown[INP_WORD_SHOWN];
    if (r->word.kind != INP_WORD)
        return expected(r, what);
    const char *end = r->word.start + r->word.length;
    if (read_digits(r->word.start, end, most, &number) != end)
        return expected(r, what);
    if (number > most)
        return inp_word_error(r, r->word.place, "%s is out of range: %s is 0 to %u",
                              inp_word_shown(r, shown), what, most);
    *value = (unsigned)number;
    return inp_word_next(r);
}

/* ---- times ------------------------------------------------------------------------------------- */

static const struct {
    const char *name;
    uint64_t ps;
    int places; /* that a whole number of picoseconds can need */
} units[] = {{"s", UINT64_C(1000000000000), 12},
             {"ms", 1000000000, 9},
             {"us", 1000000, 6},
             {"ns", 1000, 3},
             {"ps", 1, 0}};

/* The unit of what follows the digits; 0: none. Nothing needs none. */
static uint64_t read_unit(const char *p, size_t length, bool zero)
{
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strlen(units[i].name) == length && memcmp(units[i].name, p, length) == 0)
            return units[i].ps;
    return length == 0 && zero ? 1 : 0;
}

/* Digits at p times a unit, of which each after the point is worth a tenth; false: it is too much. A part
 * of a picosecond is dropped. */
static bool read_ps(const char *p, const char *end, uint64_t unit, uint64_t *ps)
{
    uint64_t n = 0;
    for (; p < end && *p != '.'; p++) {
        if (n > INP_SCRIPT_LATEST / 10)
            return false;
        n = n * 10 + (uint64_t)(*p - '0');
        if (n > INP_SCRIPT_LATEST / unit)
            return false;
    }
    *ps = n * unit;
    for (p += p < end; p < end && unit >= 10; p++) {
        unit /= 10;
        *ps += (uint64_t)(*p - '0') * unit;
    }
    return *ps < INP_SCRIPT_LATEST;
}

static bool only_zeros(const char *p, const char *end)
{
    while (p < end && (*p == '0' || *p == '.'))
        p++;
    return p == end;
}

bool inp_word_time(struct inp_reader *r, const char *text, size_t length, uint64_t *ps)
{
    const char *p = text, *end = text + length;
    int points = 0, digits = 0;
    for (; p < end && (digit(*p) || (*p == '.' && points == 0)); p++) {
        points += *p == '.';
        digits += digit(*p) && digits < 1;
    }
    uint64_t unit = r->word.kind == INP_WORD && digits
                        ? read_unit(p, (size_t)(end - p), only_zeros(text, p))
                        : 0;
    if (!unit)
        return expected(r, "a time such as 0.5s, 20ms, 3us, 5ns, 7ps");
    if (!read_ps(text, p, unit, ps))
        return inp_word_error(r, text, "'%.*s' is too late: times are below 2^63 ps, 106 days",
                              length > 32 ? 32 : (int)length, text);
    return inp_word_next(r);
}

/* With the unit, without zeros at its end. */
static size_t write_time(uint64_t ps, size_t unit, char text[INP_TIME_TEXT])
{
    uint64_t whole = ps / units[unit].ps, rest = ps % units[unit].ps;
    int places = units[unit].places;
    while (places > 0 && rest % 10 == 0) {
        rest /= 10;
        places--;
    }
    int length = places ? snprintf(text, INP_TIME_TEXT, "%llu.%0*llu%s", (unsigned long long)whole,
                                   places, (unsigned long long)rest, units[unit].name)
                        : snprintf(text, INP_TIME_TEXT, "%llu%s", (unsigned long long)whole,
                                   units[unit].name);
    return (size_t)length;
}

size_t inp_time_write(uint64_t ps, char text[INP_TIME_TEXT])
{
    size_t best = 0, length = write_time(ps, 0, text);
    for (size_t i = 1; i < sizeof units / sizeof *units; i++) {
        char other[INP_TIME_TEXT];
        size_t n = write_time(ps, i, other);
        if (n < length) {
            best = i;
            length = n;
        }
    }
    return write_time(ps, best, text);
}

/* ---- texts ------------------------------------------------------------------------------------- */

static int hexadecimal(char c)
{
    if (digit(c))
        return c - '0';
    c = (char)(c | 0x20);
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* After the backslash. */
static bool escape(struct inp_reader *r, const char **at, const char *end, uint8_t *character)
{
    static const char names[] = "nrtbe\\\"", bytes[] = "\n\r\t\b\033\\\"";
    const char *p = *at;
    const char *name = p < end && *p ? strchr(names, *p) : NULL;
    if (name) {
        *character = (uint8_t)bytes[name - names];
        *at = p + 1;
        return true;
    }
    int high = end - p >= 3 && *p == 'x' ? hexadecimal(p[1]) : -1;
    int low = high >= 0 ? hexadecimal(p[2]) : -1;
    if (low < 0)
        return inp_word_error(
            r, p - 1, "this is no escape; there are \\n \\r \\t \\b \\e \\\\ \\\" and \\xHH");
    *character = (uint8_t)(high * 16 + low);
    *at = p + 3;
    return true;
}

bool inp_text_next(struct inp_reader *r, const char **at, const char *end, uint8_t *character)
{
    const char *start = *at;
    *character = (uint8_t)*start;
    (*at)++;
    if (*start == '\\' && !escape(r, at, end, character))
        return false;
    if (*character >= 0x80)
        return inp_word_error(r, start, "character 0x%02x is not ASCII: no key makes it",
                              *character);
    return true;
}
