/* view_side.c — heights: the drawing from the front, z upwards. */
#include <stdio.h>

#include "roms/digitise/view.h"
#include "roms/geometry/scalar.h"

enum { LOW = 30, HIGH = VIEW_SIDE_HEIGHT - 24 };

static float most_of(const struct session *s)
{
    float most = 20; /* mm */
    for (int i = 0; i < s->drawing.count; i++)
        most = scalar_max(most, s->drawing.point[i].z);
    return most;
}

static struct point2 place(const struct graph *paper, const struct drawing_point *p, float most)
{
    struct point2 at = graph_place(paper, (struct point2){p->x, p->y});
    return (struct point2){at.x, LOW + (HIGH - LOW) * scalar_max(p->z, 0) / most};
}

/* Each point stands on the surface. */
static void draw_points(const struct session *s, const struct graph *paper, float most)
{
    const struct drawing_point *p = s->drawing.point;
    for (int i = 0; i < s->drawing.count; i++) {
        struct point2 at = place(paper, &p[i], most);
        stage_ink(paper->stage, INK_GRID);
        stage_line(paper->stage, at.x, LOW, at.x, at.y);
        stage_ink(paper->stage, INK_CYAN);
        stage_rectangle(paper->stage, at.x - 3, at.y - 3, 6, 6);
        if (i == 0 || p[i].start || p[i].gap)
            continue;
        struct point2 before = place(paper, &p[i - 1], most);
        stage_ink(paper->stage, INK_YELLOW);
        stage_line(paper->stage, before.x, before.y, at.x, at.y);
    }
}

/* The stylus itself. */
static void draw_stylus(const struct session *s, const struct graph *paper, float most)
{
    const struct tablet_report *t = &s->reading.last.tablet;
    if (!s->reading.any || t->proximity == TABLET_FAR)
        return;
    struct point2 on = session_at(s);
    struct drawing_point p = {.x = on.x, .y = on.y, .z = (float)t->z * session_unit(s)};
    struct point2 at = place(paper, &p, most);
    stage_ink(paper->stage, t->buttons & 1 ? INK_RED : INK_BRIGHT);
    stage_line(paper->stage, at.x, at.y, at.x - 10, at.y + 22);
    stage_line(paper->stage, at.x, at.y, at.x + 10, at.y + 22);
}

void view_side(const struct session *s, const struct graph *paper, struct stage *stage)
{
    char text[24];
    float most = most_of(s);
    stage_ink(stage, INK_GRID);
    stage_line(stage, 0, LOW, VIEW_WIDTH, LOW);
    stage_line(stage, 0, HIGH, VIEW_WIDTH, HIGH);
    stage_ink(stage, INK_TEXT);
    snprintf(text, sizeof text, "z %.0f mm", (double)most);
    stage_text(stage, 6, HIGH - 24, text);
    stage_text(stage, 6, LOW + 6, "0");
    draw_points(s, paper, most);
    draw_stylus(s, paper, most);
}
