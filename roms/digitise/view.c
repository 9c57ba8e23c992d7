#include "roms/digitise/view.h"

#include <stddef.h>
#include <stdio.h>

/* What one does now. */
static void title(const struct session *s, struct stage *stage)
{
    static const char *const modes[MODES] = {"Placing the paper", "Points", "Lines", "Stream"};
    char text[64];
    if (s->mode == MODE_PLACE && s->touched < FIT_POINTS_MOST)
        snprintf(text, sizeof text, "Touch reference point %d", s->touched + 1);
    else
        snprintf(text, sizeof text, "Digitising: %s", modes[s->mode]);
    stage_title(stage, text);
}

/* Two lines of a caption: the first fills 80 columns, and 73 as well. */
static const char keys[] =
    "       r paper = x y a affine  p points l lines s stream  n new c close         "
    "x delete  h heights  t time  < > spacing  + - tolerance  w write  q end";

static void caption(const struct session *s, struct stage *stage)
{
    char text[96];
    if (s->facts.kind == TABLET_NONE)
        stage_caption(stage, "There is no tablet.");
    else if (s->typing) {
        snprintf(text, sizeof text, "x y of reference point %d, mm: %s_", s->touched + 1, s->typed);
        stage_caption(stage, text);
    } else if (s->message)
        stage_caption(stage, s->message);
    else
        stage_caption(stage, keys);
}

static void cursor(const struct session *s, const struct graph *paper, struct stage *stage)
{
    enum { INNER = 7, OUTER = 24 };
    const struct tablet_report *t = &s->reading.last.tablet;
    if (!s->reading.any || t->proximity == TABLET_FAR)
        return;
    struct point2 at = graph_place(paper, session_at(s));
    if (!(at.x > 0 && at.x < VIEW_WIDTH))
        return;
    stage_ink(stage, t->buttons & 1 ? INK_RED : INK_BRIGHT);
    for (int side = -1; side <= 1; side += 2) {
        float inner = (float)(side * INNER), outer = (float)(side * OUTER);
        stage_line(stage, at.x + inner, at.y, at.x + outer, at.y);
        stage_line(stage, at.x, at.y + inner, at.x, at.y + outer);
    }
    if (t->buttons & 1)
        stage_rectangle(stage, at.x - INNER, at.y - INNER, 2 * INNER, 2 * INNER);
}

void view_draw(const struct session *s, struct stage *stage)
{
    struct graph paper = view_paper(s, stage, s->heights ? VIEW_SIDE_HEIGHT : 0);
    if (s->heights)
        view_side(s, &paper, stage);
    view_panel(s, stage);
    cursor(s, &paper, stage);
    title(s, stage);
    caption(s, stage);
}
