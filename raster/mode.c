#include "raster/mode.h"

#include <math.h>
#include <stdio.h>

#include "raster/mode_parts.h"

#define MAX_TOTAL 16384 /* dots of a line, lines of a frame */

#define MIN_CLOCK UINT64_C(100000)     /* Hz */
#define MAX_CLOCK UINT64_C(1000000000) /* Hz */
#define MAX_CLOCKS                                                                                 \
    UINT64_C(1000000000000000) /* in the ratio: products with it fit 64 and 128 bits */

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
                        clock.den ? crt_rate_hz(clock) / 1e6 : 0.0);
    if (!check_span(&t->h, "dots", RAS_MIN_DOTS, RAS_MAX_DOTS, err) ||
        !check_span(&t->v, "lines", 1, RAS_MAX_LINES, err) || !check_interlace(t, err))
        return false;
    struct crt_rate fields = ras_field_rate(t);
    if (fields.num > RAS_MAX_FIELDS * fields.den)
        return crt_fail(err, "%.6g fields a second are too many; there may be %d",
                        crt_rate_hz(fields), RAS_MAX_FIELDS);
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
             floor(crt_rate_hz(ras_field_rate(timing)) + 0.5), timing->interlaced ? "i" : "");
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
    double khz = crt_rate_hz(ras_line_rate(timing)) / 1e3,
           v_hz = crt_rate_hz(ras_field_rate(timing)), mhz = crt_rate_hz(timing->clock) / 1e6;
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
