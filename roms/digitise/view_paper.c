/* view_paper.c — the paper with its reference points and what is drawn on it. */
#include <stdio.h>

#include "roms/digitise/view.h"
#include "roms/geometry/scalar.h"

static void include(struct point2 box[2], float x, float y)
{
    box[0] = (struct point2){scalar_min(box[0].x, x), scalar_min(box[0].y, y)};
    box[1] = (struct point2){scalar_max(box[1].x, x), scalar_max(box[1].y, y)};
}

/* The reference points and the drawing; the whole tablet as long as there is no paper. */
static struct graph graph_of(const struct session *s, struct stage *stage, float bottom)
{
    struct point2 box[2] = {{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (int i = 0; s->placed && i < s->touched; i++)
        include(box, s->pair[i].known.x, s->pair[i].known.y);
    if (!s->placed) {
        include(box, 0, 0);
        include(box, (float)s->facts.width * session_unit(s),
                (float)s->facts.height * session_unit(s));
    }
    for (int i = 0; i < s->drawing.count; i++)
        include(box, s->drawing.point[i].x, s->drawing.point[i].y);
    return graph_fit(stage, 0, bottom, VIEW_WIDTH, STAGE_HEIGHT - bottom, box, 2);
}

/* ---- reference points ---------------------------------------------------------------------------- */

/* As given, a ring; as touched, a cross: what the fit leaves between them. */
static void draw_references(const struct session *s, const struct graph *g)
{
    enum { RING = 11 };
    char text[4];
    for (int i = 0; i < s->touched; i++) {
        struct point2 touched = graph_place(g, fit_place(&s->fit, s->pair[i].touched));
        struct point2 known = graph_place(g, s->pair[i].known);
        stage_ink(g->stage, INK_GREEN);
        if (s->placed)
            stage_rectangle(g->stage, known.x - RING, known.y - RING, 2 * RING, 2 * RING);
        snprintf(text, sizeof text, "%d", i + 1);
        stage_text(g->stage, touched.x + 16, touched.y + 14, text);
        stage_ink(g->stage, INK_BRIGHT);
        stage_marker(g->stage, touched.x, touched.y);
    }
}

/* ---- lines --------------------------------------------------------------------------------------- */

/* Two dots wide on the raster head. */
static void draw_segment(const struct graph *g, const struct drawing_point *a,
                         const struct drawing_point *b, bool gap)
{
    struct stage *stage = g->stage;
    struct point2 p = graph_place(g, (struct point2){a->x, a->y});
    struct point2 q = graph_place(g, (struct point2){b->x, b->y});
    stage_ink(stage, gap ? INK_RED : INK_YELLOW);
    stage_line_type(stage, gap ? STAGE_SHORT_DASH : STAGE_SOLID);
    stage_line(stage, p.x, p.y, q.x, q.y);
    stage_line_type(stage, STAGE_SOLID);
    if (gap || stage->dots <= 0)
        return;
    bool flat = fabsf(q.x - p.x) > fabsf(q.y - p.y);
    float x = flat ? 0 : 1 / stage->dots, y = flat ? 1 / stage->dots : 0;
    stage_heads(stage, STAGE_RASTER);
    stage_line(stage, p.x + x, p.y + y, q.x + x, q.y + y);
    stage_heads(stage, STAGE_BOTH);
}

static void draw_inside(const struct session *s, const struct drawing_line *line,
                        const struct graph *g)
{
    struct point2 corner[STAGE_AREA_CORNERS];
    if (!line->closed || line->count > STAGE_AREA_CORNERS)
        return;
    for (int i = 0; i < line->count; i++) {
        const struct drawing_point *p = &s->drawing.point[line->first + i];
        corner[i] = graph_place(g, (struct point2){p->x, p->y});
    }
    stage_heads(g->stage, STAGE_RASTER);
    stage_ink(g->stage, (enum ink)ink_shade(RAMP_GREEN, 0.06f));
    stage_area(g->stage, corner, line->count);
    stage_heads(g->stage, STAGE_BOTH);
}

static void draw_line(const struct session *s, const struct drawing_line *line,
                      const struct graph *g)
{
    const struct drawing_point *p = s->drawing.point + line->first;
    draw_inside(s, line, g);
    for (int i = 1; i < line->count; i++)
        draw_segment(g, &p[i - 1], &p[i], p[i].gap);
    if (line->closed)
        draw_segment(g, &p[line->count - 1], &p[0], false);
    stage_ink(g->stage, INK_CYAN);
    for (int i = 0; i < line->count; i++) {
        struct point2 at = graph_place(g, (struct point2){p[i].x, p[i].y});
        stage_rectangle(g->stage, at.x - 3, at.y - 3, 6, 6);
    }
}

/* Before thinning; while the line is being drawn, the line. */
static void draw_stream(const struct session *s, const struct graph *g)
{
    const struct session_stream *t = &s->stream;
    stage_ink(g->stage, INK_BRIGHT);
    for (int i = 0; i < t->count && s->held; i++) {
        struct point2 at = graph_place(g, (struct point2){t->point[i].x, t->point[i].y});
        stage_dot(g->stage, at.x, at.y);
    }
    for (int i = 1; i < t->count && s->held; i++)
        draw_segment(g, &t->point[i - 1], &t->point[i], t->point[i].gap);
}

struct graph view_paper(const struct session *s, struct stage *stage, float bottom)
{
    struct graph g = graph_of(s, stage, bottom);
    struct drawing_line line = {0};
    stage_ink(stage, INK_GRID);
    graph_axes(&g);
    while (drawing_next_line(&s->drawing, &line))
        draw_line(s, &line, &g);
    if (s->mode == MODE_STREAM)
        draw_stream(s, &g);
    draw_references(s, &g);
    return g;
}
