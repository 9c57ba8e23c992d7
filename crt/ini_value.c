#include "crt/ini_value.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_word(char c)
{
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

const char *crt_skip_blanks(const char *s)
{
    while (*s == ' ' || *s == '\t')
        s++;
    return s;
}

/* Length of the decimal number at s: sign, digits, one point, exponent; 0 when there is none. A
 * point followed by another is the ".." of a range. */
static size_t number_length(const char *s)
{
    const char *p = s;
    int digits = 0;
    if (*p == '+' || *p == '-')
        p++;
    for (; is_digit(*p); p++)
        digits++;
    if (*p == '.' && p[1] != '.')
        for (p++; is_digit(*p); p++)
            digits++;
    if (digits == 0)
        return 0;
    if (*p == 'e' || *p == 'E') {
        const char *e = p + 1;
        if (*e == '+' || *e == '-')
            e++;
        if (is_digit(*e)) {
            while (is_digit(*e))
                e++;
            p = e;
        }
    }
    return (size_t)(p - s);
}

const char *crt_read_number(const char *s, double *value)
{
    char text[64];
    s = crt_skip_blanks(s);
    size_t n = number_length(s);
    if (n == 0 || n >= sizeof text)
        return NULL;
    memcpy(text, s, n);
    text[n] = 0;
    char *end;
    *value = strtod(text, &end);
    if (*end || !isfinite(*value))
        return NULL;
    return s + n;
}

const char *crt_read_word(const char *s, const char *word)
{
    s = crt_skip_blanks(s);
    size_t n = strlen(word);
    if (strncmp(s, word, n) != 0 || is_word(s[n]))
        return NULL;
    return s + n;
}

const char *crt_read_time(const char *s, double *seconds)
{
    static const struct {
        const char *name;
        double seconds;
    } units[] = {{"ps", 1e-12}, {"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
    double value;
    s = crt_read_number(s, &value);
    if (!s)
        return NULL;
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        const char *end = crt_read_word(s, units[i].name);
        if (end) {
            *seconds = value * units[i].seconds;
            return end;
        }
    }
    return NULL;
}

const char *crt_read_range(const char *s, double *low, double *high)
{
    s = crt_skip_blanks(s);
    if (*s != '(' || !(s = crt_read_number(s + 1, low)))
        return NULL;
    s = crt_skip_blanks(s);
    if (s[0] != '.' || s[1] != '.' || !(s = crt_read_number(s + 2, high)))
        return NULL;
    s = crt_skip_blanks(s);
    return *s == ')' ? s + 1 : NULL;
}
