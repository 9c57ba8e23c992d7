#include "roms/lessons/curve_pen.h"

#include "roms/curves/bezier.h"
#include "roms/raster/font.h"

void pen_spline(struct stage *s, const struct spline *spline, enum ink ink)
{
    for (int i = 0; i < spline->pieces; i++) {
        struct cubic q = cubic_by_matrix(&spline->piece[i]);
        brush_cubic(s, &q, ink);
    }
}

void pen_arrow(struct stage *s, struct vector3 from, struct vector3 along, enum ink ink)
{
    enum { HEAD = 22 };
    struct vector3 tip = vector3_sum(from, along),
                   d = vector3_times(vector3_direction(along), HEAD);
    brush_line(s, from, tip, ink);
    brush_line(s, tip, (struct vector3){tip.x - d.x - d.y * 0.4f, tip.y - d.y + d.x * 0.4f, 0},
               ink);
    brush_line(s, tip, (struct vector3){tip.x - d.x + d.y * 0.4f, tip.y - d.y - d.x * 0.4f, 0},
               ink);
}

void pen_words(struct stage *s, float x, float y, enum ink ink, const char *text)
{
    enum { BIG = 2 };
    unsigned heads = s->heads;
    stage_ink(s, ink);
    if (heads & STAGE_RASTER)
        canvas_text_middle(&s->canvas, (int)stage_canvas_x(s, x),
                           (int)stage_canvas_y(s, y) - FONT_HEIGHT * BIG, BIG, BIG, ink, text);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_text_middle(s, x, y, text);
    stage_heads(s, heads);
}

int pen_collect(const struct vector3 bezier[4], int steps, struct point2 *out, int count, int most)
{
    for (int i = count > 0; i <= steps && count < most; i++) {
        struct vector3 p = bezier_point(bezier, 4, (float)i / (float)steps);
        out[count++] = (struct point2){p.x, p.y};
    }
    return count;
}
