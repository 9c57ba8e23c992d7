/* view_panel.c — figures: the tablet, noise and resolution, the paper, the line. */
#include <math.h>
#include <stdio.h>

#include "roms/digitise/table.h"
#include "roms/digitise/view.h"
#include "roms/stage/panel.h"

enum { COLUMNS = 21, LINE = 48 };

static void head(struct panel *p, const char *text)
{
    panel_line(p, INK_CYAN, text);
}

/* ---- the tablet ---------------------------------------------------------------------------------- */

static void tablet(const struct session *s, struct panel *p)
{
    static const char *const near[] = {"far", "near", "touches"};
    const struct report *r = &s->reading.last;
    const struct tablet_report *t = &r->tablet;
    char text[LINE];
    snprintf(text, sizeof text, "%s tablet", table_kind(s->facts.kind));
    head(p, text);
    snprintf(text, sizeof text, "x %5ld y %5ld z%4ld", (long)t->x, (long)t->y, (long)t->z);
    panel_line(p, INK_BRIGHT, text);
    snprintf(text, sizeof text, "%-8s buttons %c%c%c%c", near[t->proximity % 3],
             t->buttons & 1 ? '1' : '.', t->buttons & 2 ? '2' : '.', t->buttons & 4 ? '3' : '.',
             t->buttons & 8 ? '4' : '.');
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "%.1f of %.1f a second", (double)session_rate(s),
             (double)((float)s->facts.millihertz / 1000));
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "%lu reports, lost %lu", (unsigned long)s->reading.reports,
             (unsigned long)s->reading.lost);
    panel_line(p, s->reading.lost ? INK_RED : INK_TEXT, text);
    for (int i = 0; i < 4; i += 2) {
        snprintf(text, sizeof text, "raw %8lu %8lu", (unsigned long)r->raw[i],
                 (unsigned long)r->raw[i + 1]);
        panel_line(p, INK_GRID, text);
    }
}

/* ---- noise --------------------------------------------------------------------------------------- */

/* A count alone scatters by its width over the root of 12. */
static void noise(const struct session *s, struct panel *p)
{
    const struct rest *r = &s->reading.rest;
    char text[LINE];
    float unit = session_unit(s), sx = rest_deviation(r, 0), sy = rest_deviation(r, 1);
    head(p, "Resolution and noise");
    snprintf(text, sizeof text, "count %.3f (s %.3f)", (double)unit, (double)(unit * 0.28868f));
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "rests: %d reports", r->count);
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "s %.2f %.2f counts", (double)sx, (double)sy);
    panel_line(p, INK_BRIGHT, text);
    snprintf(text, sizeof text, "= %.3f %.3f mm", (double)(sx * unit), (double)(sy * unit));
    panel_line(p, INK_BRIGHT, text);
    snprintf(text, sizeof text, "mean: s/root n %.3f",
             (double)(r->count > 0 ? hypotf(sx, sy) * unit / sqrtf((float)r->count) : 0));
    panel_line(p, INK_TEXT, text);
}

/* ---- the paper ----------------------------------------------------------------------------------- */

static void paper(const struct session *s, struct panel *p)
{
    char text[LINE];
    struct point2 at = session_at(s);
    head(p, s->placed ? "Paper" : "Paper not placed");
    snprintf(text, sizeof text, "%7.2f %7.2f mm", (double)at.x, (double)at.y);
    panel_line(p, INK_BRIGHT, text);
    if (s->mode == MODE_PLACE && s->touched < FIT_POINTS_MOST) {
        snprintf(text, sizeof text, "next mark: %g %g", (double)s->pair[s->touched].known.x,
                 (double)s->pair[s->touched].known.y);
        panel_line(p, INK_GREEN, text);
    }
    if (!s->placed)
        return;
    snprintf(text, sizeof text, "%s, %d points", s->fit.affine ? "affine" : "similarity",
             s->fit.points);
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "%.4f mm, %+.2f deg", (double)fit_scale(&s->fit),
             (double)fit_turn(&s->fit));
    panel_line(p, INK_TEXT, text);
    if (s->fit.checked)
        snprintf(text, sizeof text, "residual %.3f mm", (double)s->fit.residual);
    else
        snprintf(text, sizeof text, "residual 0: no check");
    panel_line(p, s->fit.checked ? INK_BRIGHT : INK_TEXT, text);
}

/* ---- lines --------------------------------------------------------------------------------------- */

static void stream(const struct session *s, struct panel *p)
{
    const struct session_stream *t = &s->stream;
    char text[LINE];
    if (t->by_time)
        snprintf(text, sizeof text, "Stream every %lu ms", (unsigned long)t->every_ms);
    else
        snprintf(text, sizeof text, "Stream every %.2g mm", (double)t->every_mm);
    head(p, text);
    snprintf(text, sizeof text, "tolerance %.1f mm", (double)t->tolerance);
    panel_line(p, INK_TEXT, text);
    if (s->held || t->count == 0)
        snprintf(text, sizeof text, "%d points", t->count);
    else
        snprintf(text, sizeof text, "thinned %d to %d", t->count, t->kept);
    panel_line(p, INK_BRIGHT, text);
}

static void line(const struct session *s, struct panel *p)
{
    struct drawing_line last = drawing_last_line(&s->drawing);
    struct drawing_measure m = drawing_measure(&s->drawing, &last);
    char text[LINE];
    if (last.count < 2)
        return;
    snprintf(text, sizeof text, "Line of %d, %s", last.count, last.closed ? "closed" : "open");
    head(p, text);
    snprintf(text, sizeof text, "length %.2f mm", (double)(s->heights ? m.space : m.length));
    panel_line(p, INK_BRIGHT, text);
    snprintf(text, sizeof text, "perimeter %.2f mm", (double)m.perimeter);
    panel_line(p, INK_TEXT, text);
    snprintf(text, sizeof text, "area %.2f cm2", (double)(fabsf(m.area) / 100));
    panel_line(p, last.closed ? INK_YELLOW : INK_TEXT, text);
    if (m.gaps == 0)
        return;
    snprintf(text, sizeof text, "%d gaps, %.1f mm", m.gaps, (double)m.bridged);
    panel_line(p, INK_RED, text);
}

void view_panel(const struct session *s, struct stage *stage)
{
    struct panel p = panel_open(stage, VIEW_PANEL_LEFT, STAGE_HEIGHT - 4, COLUMNS, 26, "");
    tablet(s, &p);
    noise(s, &p);
    paper(s, &p);
    if (s->mode == MODE_STREAM)
        stream(s, &p);
    line(s, &p);
}
