/* session_points.c — what touching makes: reference points, points, streams. */
#include <math.h>
#include <stddef.h>

#include "roms/digitise/session.h"
#include "roms/digitise/thin.h"

static const char *const full = "The drawing is full.";

/* ---- the paper ----------------------------------------------------------------------------------- */

void session_refit(struct session *s)
{
    bool affine = s->affine && s->touched > 2;
    const char *trouble = fit_points(s->pair, s->touched, affine, &s->fit);
    s->placed = trouble == NULL;
    if (trouble)
        s->fit = fit_tablet(session_unit(s));
    s->message = s->touched > 1 ? trouble : NULL;
}

static void reference(struct session *s, const struct rest *hold)
{
    if (s->touched == FIT_POINTS_MOST) {
        s->message = "There are enough reference points.";
        return;
    }
    s->pair[s->touched].touched = (struct point2){hold->mean[0], hold->mean[1]};
    s->scatter[s->touched] = hypotf(rest_deviation(hold, 0), rest_deviation(hold, 1));
    s->touched++;
    session_refit(s);
}

/* ---- points -------------------------------------------------------------------------------------- */

static struct drawing_point point_of(const struct session *s, const float counts[3])
{
    struct point2 at = fit_place(&s->fit, (struct point2){counts[0], counts[1]});
    return (struct drawing_point){
        .x = at.x, .y = at.y, .z = counts[2] * session_unit(s), .samples = 1};
}

void session_enter(struct session *s, const struct rest *hold)
{
    if (s->mode == MODE_PLACE) {
        reference(s, hold);
        return;
    }
    struct drawing_point p = point_of(s, hold->mean);
    p.deviation = hypotf(rest_deviation(hold, 0), rest_deviation(hold, 1)) * fit_scale(&s->fit);
    p.samples = (uint16_t)hold->count;
    p.alone = s->mode == MODE_POINT;
    p.start = p.alone || s->new_line;
    s->message = drawing_add(&s->drawing, &p) ? NULL : full;
    s->new_line = p.alone;
}

/* ---- the stream ---------------------------------------------------------------------------------- */

static bool is_due(const struct session *s, const struct drawing_point *p, uint32_t us)
{
    const struct session_stream *t = &s->stream;
    const struct drawing_point *before = &t->point[t->count - 1];
    if (t->by_time)
        return us - t->us >= t->every_ms * 1000;
    return hypotf(p->x - before->x, p->y - before->y) >= t->every_mm;
}

/* What is thinned becomes part of the drawing. */
static void flush(struct session *s)
{
    struct session_stream *t = &s->stream;
    t->kept = thin_points(t->point, t->count, t->tolerance, t->keep);
    for (int i = 0; i < t->count; i++)
        if (t->keep[i] && !drawing_add(&s->drawing, &t->point[i])) {
            s->message = full;
            return;
        }
}

static void take(struct session *s, struct drawing_point *p, uint32_t us)
{
    struct session_stream *t = &s->stream;
    if (t->count == SESSION_STREAM_MOST) {
        s->message = "The stream is full: lift the stylus.";
        return; /* and the gap stays */
    }
    p->start = t->count == 0;
    p->gap = s->gap;
    s->gap = false;
    t->point[t->count++] = *p;
    t->us = us;
}

void session_stream_begin(struct session *s)
{
    s->stream.count = s->stream.kept = 0;
    s->message = NULL;
}

void session_stream_report(struct session *s, const struct report *report)
{
    const struct tablet_report *t = &report->tablet;
    const float counts[] = {(float)t->x, (float)t->y, (float)t->z};
    struct drawing_point p = point_of(s, counts);
    if (s->stream.count == 0 || s->gap || is_due(s, &p, report->us))
        take(s, &p, report->us);
}

void session_stream_end(struct session *s)
{
    flush(s);
    s->new_line = true;
    if (s->gap)
        s->message = "Reports were lost at the end of the line.";
}
