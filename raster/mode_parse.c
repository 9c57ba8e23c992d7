/* Modes as people type them: the table's, else by formula. */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "raster/mode_cvt.h"
#include "raster/mode_parts.h"

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
           floor(crt_rate_hz(ras_field_rate(t)) * m->scale + 0.5) == (double)m->rate;
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
    if (m.width < RAS_MIN_DOTS || m.width > RAS_MAX_DOTS || m.height < 1 ||
        m.height > RAS_MAX_LINES)
        return crt_fail(err,
                        "the mode %.60s is not possible; it may have %d to %d dots and 1 to %d "
                        "lines",
                        text, RAS_MIN_DOTS, RAS_MAX_DOTS, RAS_MAX_LINES);
    if (m.rate < m.scale || m.rate > RAS_MAX_FIELDS * m.scale)
        return crt_fail(err, "the mode %.60s is not possible; rates are 1 to %d Hz", text,
                        RAS_MAX_FIELDS);
    struct crt_error why;
    if (!ras_cvt(m.width, m.height, (double)m.rate / m.scale, m.interlaced, timing, &why) ||
        !ras_timing_check(timing, &why))
        return crt_fail(err, "the mode %.60s is not possible: %s", text, why.text);
    return true;
}
