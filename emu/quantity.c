#include "emu/quantity.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/image.h"

__extension__ typedef unsigned __int128 u128;

/* A non-negative decimal number as digits / 10^places. */
struct decimal {
    uint64_t digits;
    unsigned places;
};

#define MAX_PLACES 18 /* 10^18 times any unit fits into 128 bits */

/* Reads digits[.digits]; returns the first character after it, or NULL when there is no number, or
 * it has more than 18 digits (leading zeros aside) or places. */
static const char *read_decimal(const char *text, struct decimal *d)
{
    unsigned count = 0;
    bool point = false;
    *d = (struct decimal){0, 0};
    const char *p = text;
    for (; isdigit((unsigned char)*p) || (*p == '.' && !point); p++) {
        if (*p == '.') {
            point = true;
            continue;
        }
        if (d->digits > UINT64_C(99999999999999999) || (point && d->places == MAX_PLACES))
            return NULL;
        d->digits = d->digits * 10 + (uint64_t)(*p - '0');
        d->places += point;
        count++;
    }
    return count ? p : NULL;
}

static u128 power_of_ten(unsigned n)
{
    u128 v = 1;
    while (n--)
        v *= 10;
    return v;
}

bool vm_parse_time(const char *text, struct vm_time *time, struct crt_error *err)
{
    static const struct {
        const char *name;
        uint64_t ps;
    } units[] = {
        {"ps", 1}, {"ns", 1000}, {"us", CRT_PS_PER_US}, {"ms", CRT_PS_PER_MS}, {"s", CRT_PS_PER_S}};
    struct decimal d;
    if (*text == '-')
        return crt_fail(err, "the time '%s' is negative; give a time such as 16.7ms", text);
    const char *unit = read_decimal(text, &d);
    if (!unit)
        return crt_fail(err, "'%s' is not a time; write a number with a unit, such as 16.7ms or 3f",
                        text);
    if (strcmp(unit, "f") == 0) {
        if (d.places)
            return crt_fail(err, "'%s' is not a whole number of ticks", text);
        *time = (struct vm_time){true, true, d.digits};
        return true;
    }
    if (*unit == '\0' && d.digits == 0)
        unit = "s";
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(unit, units[i].name) == 0) {
            u128 ps = (u128)d.digits * units[i].ps / power_of_ten(d.places);
            if (ps > VM_TIME_MAX_PS)
                return crt_fail(err, "the time '%s' is longer than one hour (3600s)", text);
            *time = (struct vm_time){true, false, (uint64_t)ps};
            return true;
        }
    if (*unit == '\0')
        return crt_fail(err, "the time '%s' needs a unit: ps, ns, us, ms, s, or f for sync ticks",
                        text);
    return crt_fail(err, "'%s' is not a unit of time; use ps, ns, us, ms, s, or f for sync ticks",
                    unit);
}

bool vm_time_ps(const struct vm_time *time, struct crt_rate tick, uint64_t *ps,
                struct crt_error *err)
{
    *ps = time->value;
    if (!time->in_ticks)
        return true;
    if (time->value > crt_tick_at(tick, VM_TIME_MAX_PS))
        return crt_fail(err, "%llu ticks are longer than one hour",
                        (unsigned long long)time->value);
    *ps = crt_tick_time(tick, time->value);
    return true;
}

bool vm_parse_size(const char *text, struct vm_size *size, struct crt_error *err)
{
    int width = 0, height = 0, used = 0;
    bool digits = strspn(text, "0123456789x") == strlen(text) && strlen(text) < 16;
    if (!digits || sscanf(text, "%5dx%5d%n", &width, &height, &used) != 2 || text[used] != '\0')
        return crt_fail(err, "'%s' is not a size; write WIDTHxHEIGHT, such as 1024x768", text);
    if (width < 16 || height < 16 || width > CRT_IMAGE_MAX_SIDE || height > CRT_IMAGE_MAX_SIDE)
        return crt_fail(err, "the size %s is not possible; each side must be 16 to %d pixels", text,
                        CRT_IMAGE_MAX_SIDE);
    *size = (struct vm_size){width, height};
    return true;
}

bool vm_parse_bytes(const char *text, uint32_t *bytes, struct crt_error *err)
{
    struct decimal d;
    const char *unit = read_decimal(text, &d);
    uint64_t scale = unit && (*unit == 'K' || *unit == 'k') ? 1024 : 1;
    if (!unit || d.places || unit[scale == 1024] != '\0' || d.digits > UINT32_MAX / 1024)
        return crt_fail(err, "'%s' is not a number of bytes; write a number, or one with K: 16K",
                        text);
    *bytes = (uint32_t)(d.digits * scale);
    return true;
}

static uint64_t common_divisor(uint64_t a, uint64_t b)
{
    while (b) {
        uint64_t r = a % b;
        a = b;
        b = r;
    }
    return a;
}

static struct crt_rate reduced(uint64_t num, uint64_t den)
{
    uint64_t d = common_divisor(num, den);
    return (struct crt_rate){num / d, den / d};
}

bool vm_parse_rate(const char *text, struct crt_rate *rate, struct crt_error *err)
{
    struct decimal num, den = {1, 0};
    const char *p = read_decimal(text, &num);
    if (p && *p == '/')
        p = read_decimal(p + 1, &den);
    if (!p || *p != '\0' || num.places > 6 || den.places || den.digits > 1000000 ||
        num.digits > UINT64_C(1000000000000))
        return crt_fail(err, "'%s' is not a rate in hertz; write 60, 59.94 or 60000/1001", text);
    if (num.digits == 0 || den.digits == 0)
        return crt_fail(err, "the rate '%s' must be above zero", text);
    *rate = reduced(num.digits, den.digits * (uint64_t)power_of_ten(num.places));
    double hz = (double)rate->num / (double)rate->den;
    if (hz < 0.1 || hz > 1e5)
        return crt_fail(err, "the rate '%s' is out of range; give 0.1 to 100000 Hz", text);
    return true;
}

struct crt_rate vm_rate_of_hz(double hz)
{
    return reduced((uint64_t)llround(hz * 1e6), 1000000);
}

bool vm_parse_real(const char *text, double low, double high, double *value, struct crt_error *err)
{
    /* strtod also takes hexadecimal, infinity and nan; those are not meant here. */
    char *end = NULL;
    bool plain = *text && strspn(text, "0123456789+-.eE") == strlen(text);
    double v = plain ? strtod(text, &end) : 0;
    if (!plain || end == text || *end != '\0')
        return crt_fail(err, "'%s' is not a number", text);
    if (!isfinite(v) || v < low || v > high)
        return crt_fail(err, "%s is out of range; give %g to %g", text, low, high);
    *value = v;
    return true;
}

bool vm_parse_place(const char *text, double *x, double *y, struct crt_error *err)
{
    const char *comma = strchr(text, ',');
    char first[64];
    if (!comma || (size_t)(comma - text) >= sizeof first)
        return crt_fail(err, "'%.60s' is not X,Y, such as 512,300", text);
    memcpy(first, text, (size_t)(comma - text));
    first[comma - text] = '\0';
    return vm_parse_real(first, -1e5, 1e5, x, err) && vm_parse_real(comma + 1, -1e5, 1e5, y, err);
}

bool vm_parse_integer(const char *text, long low, long high, long *value, struct crt_error *err)
{
    char *end = NULL;
    errno = 0;
    long v = strtol(text, &end, 10);
    if (end == text || *end != '\0' || isspace((unsigned char)*text))
        return crt_fail(err, "'%s' is not a whole number", text);
    if (errno || v < low || v > high)
        return crt_fail(err, "%s is out of range; give %ld to %ld", text, low, high);
    *value = v;
    return true;
}

bool vm_parse_octal(const char *text, uint32_t *value, struct crt_error *err)
{
    size_t n = strlen(text);
    if (n == 0 || n > 7 || strspn(text, "01234567") != n)
        return crt_fail(err, "'%s' is not an octal address, such as 1000", text);
    *value = (uint32_t)strtoul(text, NULL, 8);
    if (*value >= 1u << 18)
        return crt_fail(err, "the address %s lies beyond display memory (777776)", text);
    return true;
}

void vm_format_time(uint64_t ps, char *text, size_t size)
{
    static const char *const units[] = {"ps", "ns", "us", "ms", "s"};
    double v = (double)ps;
    unsigned unit = 0;
    /* 999.95 would print as 1000.0. */
    while (unit < 4 && v >= 999.95) {
        v /= 1000;
        unit++;
    }
    int places = v < 10 ? 3 : v < 100 ? 2 : 1;
    if (unit == 0)
        places = 0;
    snprintf(text, size, "%.*f %s", places, v, units[unit]);
}

void vm_plain_seconds(uint64_t ps, char *text, size_t size)
{
    char fraction[16];
    snprintf(fraction, sizeof fraction, "%012llu", (unsigned long long)(ps % CRT_PS_PER_S));
    size_t n = 12;
    while (n > 1 && fraction[n - 1] == '0')
        fraction[--n] = '\0';
    snprintf(text, size, "%llu.%s", (unsigned long long)(ps / CRT_PS_PER_S), fraction);
}

void vm_format_seconds(uint64_t ps, char *text, size_t size)
{
    char plain[40];
    vm_plain_seconds(ps, plain, sizeof plain);
    snprintf(text, size, "%s s", plain);
}

void vm_format_clock(uint64_t ps, int digits, char *text, size_t size)
{
    char fraction[16];
    snprintf(fraction, sizeof fraction, "%012llu", (unsigned long long)(ps % CRT_PS_PER_S));
    snprintf(text, size, "%llu.%.*s s", (unsigned long long)(ps / CRT_PS_PER_S), digits, fraction);
}
