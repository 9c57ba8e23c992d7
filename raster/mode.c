#include "raster/mode.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "raster/mode_cvt.h"

#define MIN_DOTS  8
#define MAX_LINES 4096
#define MAX_TOTAL 16384 /* dots of a line, lines of a frame */

#define MIN_CLOCK  UINT64_C(100000)     /* Hz */
#define MAX_CLOCK  UINT64_C(1000000000) /* Hz */
#define MAX_CLOCKS UINT64_C(1000000000000000)
#define MAX_FIELDS 1000 /* a second */

/* ---- rates ------------------------------------------------------------------------------------ */

static struct crt_rate reduced(uint64_t num, uint64_t den)
{
    uint64_t a = num, b = den;
    while (b) {
        uint64_t r = a % b;
        a = b;
        b = r;
    }
    return (struct crt_rate){num / a, den / a};
}

uint64_t ras_field_dots(const struct ras_timing *t)
{
    uint64_t frame = (uint64_t)t->h.total * t->v.total;
    return t->interlaced ? frame / 2 : frame;
}

struct crt_rate ras_line_rate(const struct ras_timing *t)
{
    return reduced(t->clock.num, t->clock.den * t->h.total);
}

struct crt_rate ras_field_rate(const struct ras_timing *t)
{
    return reduced(t->clock.num, t->clock.den * ras_field_dots(t));
}

static double hz(struct crt_rate rate)
{
    return (double)rate.num / (double)rate.den;
}

/* ---- what makes sense ------------------------------------------------------------------------- */

static bool check_span(const struct ras_span *s, const char *what, uint32_t least, uint32_t most,
                       struct crt_error *err)
{
    if (s->visible < least || s->visible > most)
        return crt_fail(err, "%u visible %s are not possible; there may be %u to %u", s->visible,
                        what, least, most);
    if (s->sync_start < s->visible || s->sync_end <= s->sync_start || s->total < s->sync_end)
        return crt_fail(err,
                        "the parts of a timing must follow one another: %s visible to %u, sync "
                        "from %u to %u, total %u",
                        what, s->visible, s->sync_start, s->sync_end, s->total);
    if (s->total > MAX_TOTAL)
        return crt_fail(err, "%u %s in all are too many; there may be %u", s->total, what,
                        MAX_TOTAL);
    return true;
}

/* The half line before the sync pulse moves its end, too: see raster/head.h. */
static bool check_interlace(const struct ras_timing *t, struct crt_error *err)
{
    if (!t->interlaced)
        return true;
    if (t->v.total % 2 == 0)
        return crt_fail(err, "an interlaced frame has an odd number of lines, not %u", t->v.total);
    if (t->h.total % 2)
        return crt_fail(err, "a line of an interlaced frame has an even number of dots, not %u",
                        t->h.total);
    if (t->v.sync_end == t->v.total)
        return crt_fail(err, "an interlaced frame needs a line after its sync pulse");
    return true;
}

bool ras_timing_check(const struct ras_timing *t, struct crt_error *err)
{
    struct crt_rate clock = t->clock;
    if (clock.den == 0 || clock.num > MAX_CLOCKS || clock.den > MAX_CLOCKS / MAX_CLOCK ||
        clock.num < MIN_CLOCK * clock.den || clock.num > MAX_CLOCK * clock.den)
        return crt_fail(err, "a dot clock of %.6g MHz is not possible; it may be 0.1 to 1000 MHz",
                        clock.den ? hz(clock) / 1e6 : 0.0);
    if (!check_span(&t->h, "dots", MIN_DOTS, RAS_MAX_DOTS, err) ||
        !check_span(&t->v, "lines", 1, MAX_LINES, err) || !check_interlace(t, err))
        return false;
    struct crt_rate fields = ras_field_rate(t);
    if (fields.num > MAX_FIELDS * fields.den)
        return crt_fail(err, "%.6g fields a second are too many; there may be %d", hz(fields),
                        MAX_FIELDS);
    return true;
}

/* ---- names ------------------------------------------------------------------------------------ */

static bool same_span(struct ras_span a, struct ras_span b)
{
    return a.visible == b.visible && a.sync_start == b.sync_start && a.sync_end == b.sync_end &&
           a.total == b.total;
}

static bool same_timing(const struct ras_timing *a, const struct ras_timing *b)
{
    return a->clock.num * b->clock.den == b->clock.num * a->clock.den && same_span(a->h, b->h) &&
           same_span(a->v, b->v) && a->interlaced == b->interlaced;
}

void ras_timing_name(const struct ras_timing *timing, char *text, size_t size)
{
    size_t count;
    const struct ras_mode *modes = ras_modes(&count);
    for (size_t i = 0; i < count; i++)
        if (same_timing(timing, &modes[i].timing)) {
            snprintf(text, size, "%s", modes[i].name);
            return;
        }
    snprintf(text, size, "%ux%u@%.0f%s", timing->h.visible, timing->v.visible,
             floor(hz(ras_field_rate(timing)) + 0.5), timing->interlaced ? "i" : "");
}

/* A mode as typed: the rate is rate / scale, as many places as were given. */
struct typed {
    uint32_t width, height, rate, scale;
    bool interlaced;
};

/* At most six digits; NULL when there is none. */
static const char *read_digits(const char *p, uint32_t *value)
{
    const char *start = p;
    for (*value = 0; isdigit((unsigned char)*p) && p - start < 6; p++)
        *value = *value * 10 + (uint32_t)(*p - '0');
    return p == start || isdigit((unsigned char)*p) ? NULL : p;
}

static const char *read_rate(const char *p, struct typed *m)
{
    p = read_digits(p, &m->rate);
    if (!p || *p != '.')
        return p;
    const char *start = ++p;
    for (; isdigit((unsigned char)*p) && p - start < 3 && m->rate < 1000000; p++) {
        m->rate = m->rate * 10 + (uint32_t)(*p - '0');
        m->scale *= 10;
    }
    return p == start ? NULL : p;
}

static bool read_mode(const char *text, struct typed *m)
{
    *m = (struct typed){.rate = 60, .scale = 1};
    const char *p = read_digits(text, &m->width);
    if (!p || *p != 'x' || !(p = read_digits(p + 1, &m->height)))
        return false;
    if (*p == '@' && !(p = read_rate(p + 1, m)))
        return false;
    m->interlaced = *p == 'i';
    return p[m->interlaced] == '\0';
}

/* Of that size, with a rate that rounds to the figure typed. */
static bool is_meant(const struct ras_timing *t, const struct typed *m)
{
    return t->h.visible == m->width && t->v.visible == m->height &&
           t->interlaced == m->interlaced &&
           floor(hz(ras_field_rate(t)) * m->scale + 0.5) == (double)m->rate;
}

bool ras_mode_parse(const char *text, struct ras_timing *timing, struct crt_error *err)
{
    size_t count;
    struct typed m;
    const struct ras_mode *modes = ras_modes(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(text, modes[i].name) == 0) {
            *timing = modes[i].timing;
            return true;
        }
    if (!read_mode(text, &m))
        return crt_fail(
            err,
            "'%.60s' is not a video mode; write WIDTHxHEIGHT@RATE, such as 1024x768@60, "
            "with an i behind it for interlaced, or a name that kinescope list modes "
            "shows",
            text);
    for (size_t i = 0; i < count; i++)
        if (is_meant(&modes[i].timing, &m)) {
            *timing = modes[i].timing;
            return true;
        }
    if (m.width < MIN_DOTS || m.width > RAS_MAX_DOTS || m.height < 1 || m.height > MAX_LINES)
        return crt_fail(err,
                        "the mode %.60s is not possible; it may have %d to %d dots and 1 to %d "
                        "lines",
                        text, MIN_DOTS, RAS_MAX_DOTS, MAX_LINES);
    if (m.rate < m.scale || m.rate > MAX_FIELDS * m.scale)
        return crt_fail(err, "the mode %.60s is not possible; rates are 1 to %d Hz", text,
                        MAX_FIELDS);
    struct crt_error why;
    if (!ras_cvt(m.width, m.height, (double)m.rate / m.scale, m.interlaced, timing, &why) ||
        !ras_timing_check(timing, &why))
        return crt_fail(err, "the mode %.60s is not possible: %s", text, why.text);
    return true;
}

/* ---- monitors --------------------------------------------------------------------------------- */

struct ras_monitor ras_monitor_of(const struct crt_tube_row *row)
{
    return (struct ras_monitor){.h_min_khz = row->h_min.value,
                                .h_max_khz = row->h_max.value,
                                .v_min_hz = row->v_min.value,
                                .v_max_hz = row->v_max.value,
                                .clock_max_mhz = row->clock_max.value};
}

bool ras_monitor_follows(const struct ras_monitor *m, const struct ras_timing *timing,
                         const char *tube, struct crt_error *err)
{
    double khz = hz(ras_line_rate(timing)) / 1e3, v_hz = hz(ras_field_rate(timing)),
           mhz = hz(timing->clock) / 1e6;
    char name[48];
    ras_timing_name(timing, name, sizeof name);
    if (khz < m->h_min_khz || khz > m->h_max_khz || v_hz < m->v_min_hz || v_hz > m->v_max_hz)
        return crt_fail(
            err, "%s needs %.2f kHz and %.2f Hz; %s follows %g to %g kHz and %g to %g Hz", name,
            khz, v_hz, tube, m->h_min_khz, m->h_max_khz, m->v_min_hz, m->v_max_hz);
    if (mhz > m->clock_max_mhz)
        return crt_fail(err, "%s needs a dot clock of %.6g MHz; %s takes %g MHz at most", name, mhz,
                        tube, m->clock_max_mhz);
    return true;
}
