#include "emu/plot/ticks.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "crt/maths.h"

/* A share of a step by which an end of the axis may miss its tick. */
#define NEAR 1e-9

/* 10^k, exact up to 22. */
static double power_of_ten(int k)
{
    double power = 1, square = 10;
    for (; k > 0; k >>= 1) {
        power *= k & 1 ? square : 1;
        square *= square;
    }
    return power;
}

/* value · 10^k, correctly rounded while 10^|k| is exact. Two factors, for powers beyond the range of a double. */
static double scaled(double value, int k)
{
    int n = k < 0 ? -k : k, first = n > 150 ? 150 : n;
    double a = power_of_ten(first), b = n > first ? power_of_ten(n - first) : 1;
    return k < 0 ? value / a / b : value * a * b;
}

/* The greatest k with 10^k <= v. */
static int decade_of(double v)
{
    int k = (int)floor(crt_log(v) / crt_log(10.0));
    while (scaled(1, k + 1) <= v)
        k++;
    while (scaled(1, k) > v)
        k--;
    return k;
}

/* ---- labels ------------------------------------------------------------------------------------- */

/* Room for "⁻³²⁴", the least exponent of a double. */
#define RAISED 16

static void raised(int exponent, char *text, size_t size)
{
    static const char *const digit[10] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    snprintf(plain, sizeof plain, "%d", exponent);
    text[0] = '\0';
    for (const char *p = plain; *p; p++) {
        size_t n = strlen(text);
        snprintf(text + n, size - n, "%s", *p == '-' ? "⁻" : digit[*p - '0']);
    }
}

void vm_exponent_text(int exponent, char text[40])
{
    char power[RAISED];
    raised(exponent, power, sizeof power);
    snprintf(text, 40, "×10%s", power);
}

/* n · 10^k in decimals. */
static void decimal(int64_t n, int k, char *text, size_t size)
{
    char digits[32];
    bool minus = n < 0;
    if (n == 0) {
        snprintf(text, size, "0");
        return;
    }
    int count = snprintf(digits, sizeof digits, "%0*lld", k < 0 ? (k > -20 ? 1 - k : 20) : 1,
                         (long long)(minus ? -n : n));
    k = k < -count ? -count : k > 5 ? 5 : k;
    if (k < 0)
        snprintf(text, size, "%s%.*s.%s", minus ? "−" : "", count + k, digits, digits + count + k);
    else
        snprintf(text, size, "%s%s%.*s", minus ? "−" : "", digits, k, "00000");
}

/* ---- linear axes -------------------------------------------------------------------------------- */

struct steps {
    int m, k;           /* step: m · 10^k, m 1, 2 or 5 */
    double first, last; /* multiples of the step */
};

static struct steps steps_of(double low, double high, int m, int k)
{
    double step = scaled(m, k);
    return (struct steps){m, k, ceil(low / step - NEAR), floor(high / step + NEAR)};
}

static struct steps next_step(double low, double high, struct steps s)
{
    int m = s.m == 1 ? 2 : s.m == 2 ? 5 : 1;
    return steps_of(low, high, m, s.k + (m == 1));
}

static void linear(struct vm_ticks *ticks, double low, double high, int most)
{
    struct steps s = steps_of(low, high, 1, decade_of((high - low) / most));
    while (s.last - s.first + 1 > most)
        s = next_step(low, high, s);
    double far = fmax(fabs(s.first), fabs(s.last)) * s.m;
    int top = far > 0 ? decade_of(far) + s.k : s.k;
    /* Up to 99999 and down to four decimals numbers are easier to read as they are. */
    if (top > 4 || s.k < -4)
        ticks->exponent = 3 * (int)floor(top / 3.0);
    for (double n = s.first; n <= s.last && ticks->count < VM_TICKS; n++) {
        struct vm_tick *tick = &ticks->major[ticks->count++];
        tick->at = scaled(n * s.m, s.k);
        decimal((int64_t)(n * s.m), s.k - ticks->exponent, tick->label, sizeof tick->label);
    }
    int parts = s.m == 2 ? 4 : 5;
    double fine = scaled(s.m, s.k) / parts;
    double from = ceil(low / fine - NEAR), to = floor(high / fine + NEAR);
    for (double n = from; n <= to && ticks->minor_count < VM_TICKS_MINOR; n++)
        if (n - parts * floor(n / parts) != 0)
            ticks->minor[ticks->minor_count++] = n * fine;
}

/* ---- logarithmic axes ----------------------------------------------------------------------------- */

static void put(struct vm_ticks *ticks, int m, int k, bool plain)
{
    if (ticks->count == VM_TICKS)
        return;
    struct vm_tick *tick = &ticks->major[ticks->count++];
    tick->at = scaled(m, k);
    char power[RAISED];
    raised(k, power, sizeof power);
    if (plain)
        decimal(m, k, tick->label, sizeof tick->label);
    else if (m == 1)
        snprintf(tick->label, sizeof tick->label, "10%s", power);
    else
        snprintf(tick->label, sizeof tick->label, "%d×10%s", m, power);
}

static void put_minor(struct vm_ticks *ticks, double at)
{
    if (ticks->minor_count < VM_TICKS_MINOR)
        ticks->minor[ticks->minor_count++] = at;
}

static bool within(double v, double low, double high)
{
    return v >= low * (1 - NEAR) && v <= high * (1 + NEAR);
}

static int count_of(double low, double high, const int *digits, int n)
{
    int count = 0;
    for (int k = decade_of(low) - 1; k <= decade_of(high) + 1; k++)
        for (int i = 0; i < n; i++)
            count += within(scaled(digits[i], k), low, high);
    return count;
}

static void logarithmic(struct vm_ticks *ticks, double low, double high, int most)
{
    static const int digits[] = {1, 2, 5};
    int first = decade_of(low) - 1, last = decade_of(high) + 1;
    int decades = count_of(low, high, digits, 1), fives = count_of(low, high, digits, 3);
    bool plain = low >= 0.9e-3 && high <= 1.1e4;
    if (fives < 3) {
        linear(ticks, low, high, most);
        return;
    }
    bool dense = decades < 3 && fives <= most;
    static const int strides[] = {1, 2, 3, 5, 10, 20, 50, 100, 200};
    int i = 0;
    while (i < 8 && (decades + strides[i] - 1) / strides[i] > most)
        i++;
    for (int k = first; k <= last; k++)
        for (int m = 1; m <= (decades <= 12 ? 9 : 1); m++) {
            double at = scaled(m, k);
            if (!within(at, low, high))
                continue;
            bool whole = m == 1 && ((k % strides[i]) + strides[i]) % strides[i] == 0;
            if (dense ? m == 1 || m == 2 || m == 5 : whole)
                put(ticks, m, k, plain);
            else
                put_minor(ticks, at);
        }
}

void vm_ticks_find(struct vm_ticks *ticks, bool log, double low, double high, int most)
{
    ticks->count = ticks->minor_count = ticks->exponent = 0;
    most = most < 2 ? 2 : most > 12 ? 12 : most;
    if (log)
        logarithmic(ticks, low, high, most);
    else
        linear(ticks, low, high, most);
}
