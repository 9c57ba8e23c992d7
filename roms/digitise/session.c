/* session.c — reports: what they say, and what buttons do. */
#include "roms/digitise/session.h"

#include <math.h>
#include <stddef.h>

#define REST_MM 0.8f /* farther from the mean than this is a move */

float session_unit(const struct session *s)
{
    return (float)s->facts.unit_nm / 1e6f;
}

struct point2 session_at(const struct session *s)
{
    const struct tablet_report *t = &s->reading.last.tablet;
    return fit_place(&s->fit, (struct point2){(float)t->x, (float)t->y});
}

float session_rate(const struct session *s)
{
    const struct session_reading *r = &s->reading;
    if (r->reports < SESSION_RATE)
        return 0;
    uint32_t first = r->us[r->reports % SESSION_RATE],
             last = r->us[(r->reports + SESSION_RATE - 1) % SESSION_RATE];
    return last - first > 0 ? (SESSION_RATE - 1) * 1e6f / (float)(last - first) : 0;
}

void session_begin(struct session *s, const struct tablet_facts *facts)
{
    static const struct point2 corners[FIT_POINTS_MOST] = {
        {0, 0},     {200, 0}, {0, 150}, /* of the sheet, as it is drawn for this */
        {200, 150}, {100, 0}, {0, 75},  {200, 75}, {100, 150}};
    *s = (struct session){.facts = *facts, .affine = true, .new_line = true};
    for (int i = 0; i < FIT_POINTS_MOST; i++)
        s->pair[i].known = corners[i];
    s->stream.every_mm = 1;
    s->stream.every_ms = 100;
    s->stream.tolerance = 0.3f;
    s->fit = fit_tablet(session_unit(s));
}

/* ---- what is measured ---------------------------------------------------------------------------- */

/* How many reports are missing before this one. */
static uint32_t missing(const struct session_reading *r, const struct tablet_report *t)
{
    uint32_t gap = t->serial - r->last.tablet.serial;
    if (!r->any)
        return 0;
    return gap > 1 && gap < 0x80000000u ? gap - 1 : t->lost;
}

static void read_report(struct session *s, const struct report *report)
{
    struct session_reading *r = &s->reading;
    const struct tablet_report *t = &report->tablet;
    const float place[] = {(float)t->x, (float)t->y, (float)t->z};
    uint32_t lost = missing(r, t);
    r->lost += lost;
    s->gap |= lost > 0;
    r->last = *report;
    r->any = true;
    r->us[r->reports % SESSION_RATE] = report->us;
    r->reports++;
    if (t->proximity == TABLET_FAR)
        rest_begin(&r->rest);
    else
        rest_take(&r->rest, place, REST_MM / session_unit(s));
}

/* ---- buttons ------------------------------------------------------------------------------------- */

static void hold(struct session *s, const struct report *report)
{
    const struct tablet_report *t = &report->tablet;
    const float place[] = {(float)t->x, (float)t->y, (float)t->z};
    if (s->ignored)
        return;
    if (!s->held)
        rest_begin(&s->hold);
    if (!s->held && s->mode == MODE_STREAM)
        session_stream_begin(s);
    s->held = true;
    rest_take(&s->hold, place, REST_MM / session_unit(s));
    if (s->mode == MODE_STREAM)
        session_stream_report(s, report);
}

static void let_go(struct session *s)
{
    if (s->held && s->mode == MODE_STREAM)
        session_stream_end(s);
    else if (s->held)
        session_enter(s, &s->hold);
    s->held = s->ignored = false;
    s->gap = false; /* what was lost before the next press is between lines */
}

/* The puck's: the same as these keys, also while coordinates are typed. */
static void functions(struct session *s, unsigned pressed)
{
    static const char keys[] = {0, 'n', 'x', 'c'};
    for (unsigned i = 1; i < sizeof keys; i++)
        if (pressed >> i & 1)
            session_function(s, keys[i]);
}

void session_report(struct session *s, const struct report *report)
{
    unsigned buttons = report->tablet.buttons;
    if (session_unit(s) <= 0)
        return; /* there is no tablet */
    read_report(s, report);
    if (buttons & 1)
        hold(s, report);
    else
        let_go(s);
    functions(s, buttons & ~s->buttons);
    s->buttons = buttons;
}
