#include "crt/number_text.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

bool crt_decimal_read(const char *text, uint64_t *value)
{
    uint64_t n = 0;
    if (!*text)
        return false;
    for (; *text; text++) {
        if (*text < '0' || *text > '9')
            return false;
        unsigned digit = (unsigned)(*text - '0');
        if (n > (UINT64_MAX - digit) / 10)
            return false;
        n = n * 10 + digit;
    }
    *value = n;
    return true;
}

bool crt_octal_read(const char *text, uint32_t *value)
{
    uint32_t n = 0;
    if (!*text)
        return false;
    for (; *text; text++) {
        if (*text < '0' || *text > '7' || n >> 29)
            return false;
        n = n << 3 | (uint32_t)(*text - '0');
    }
    *value = n;
    return true;
}

/* value·10^power, each step rounded once; 10^22 is the last power of ten that a double holds. */
static double scaled(double value, int power)
{
    int left = power < 0 ? -power : power;
    while (left > 0) {
        double ten = 1.0;
        int step = left < 22 ? left : 22;
        for (int i = 0; i < step; i++)
            ten *= 10.0;
        value = power < 0 ? value / ten : value * ten;
        left -= step;
    }
    return value;
}

/* The digits of a float so far: value = digits·10^power. */
struct mantissa {
    uint64_t digits;
    int power;
    bool any;
};

static const char *read_digits(const char *text, struct mantissa *m, int power_per_digit)
{
    for (; *text >= '0' && *text <= '9'; text++) {
        m->any = true;
        if (m->digits < UINT64_C(100000000000000000)) { /* 17 digits decide; the rest only count */
            m->digits = m->digits * 10 + (uint64_t)(*text - '0');
            m->power += power_per_digit;
        } else {
            m->power += power_per_digit + 1;
        }
    }
    return text;
}

/* [-+]digits to the end of the text; held to ±9999, far outside what a float reaches. */
static bool read_exponent(const char *text, int *exponent)
{
    bool negative = *text == '-';
    if (*text == '-' || *text == '+')
        text++;
    uint64_t n;
    if (!crt_decimal_read(text, &n))
        return false;
    int held = n > 9999 ? 9999 : (int)n;
    *exponent = negative ? -held : held;
    return true;
}

bool crt_float_read(const char *text, float *value)
{
    bool negative = *text == '-';
    if (*text == '-' || *text == '+')
        text++;
    struct mantissa m = {0, 0, false};
    text = read_digits(text, &m, 0);
    if (*text == '.')
        text = read_digits(text + 1, &m, -1);
    int exponent = 0;
    if (!m.any)
        return false;
    if (*text == 'e' || *text == 'E') {
        if (!read_exponent(text + 1, &exponent))
            return false;
    } else if (*text) {
        return false;
    }
    double magnitude = m.digits == 0 ? 0.0 : scaled((double)m.digits, m.power + exponent);
    if (!(magnitude <= 3.4028234663852886e38)) /* FLT_MAX */
        return false;
    *value = (float)(negative ? -magnitude : magnitude);
    return true;
}

void crt_float_write(char text[CRT_FLOAT_TEXT], float value)
{
    assert(isfinite(value));
    char local[CRT_FLOAT_TEXT + 8];
    snprintf(local, sizeof local, "%.9g", (double)value);
    /* Whatever stands for the decimal point in this locale, of one byte or more, becomes '.'. */
    size_t used = 0;
    for (const char *c = local; *c; c++) {
        bool plain = (*c >= '0' && *c <= '9') || *c == '-' || *c == '+' || *c == 'e';
        if (plain)
            text[used++] = *c;
        else if (used == 0 || text[used - 1] != '.')
            text[used++] = '.';
        assert(used < CRT_FLOAT_TEXT);
    }
    text[used] = '\0';
}
