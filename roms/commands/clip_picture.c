#include "roms/commands/clip_picture.h"

#include "roms/clip/edge.h"
#include "roms/commands/flat_words.h"

struct graph clip_picture_fit(struct stage *stage, float left, float width,
                              const struct clip_window *w, const struct point2 *points, int count)
{
    struct point2 all[FLAT_POINTS + 2] = {{w->x_min, w->y_min}, {w->x_max, w->y_max}};
    count = count < FLAT_POINTS ? count : FLAT_POINTS;
    for (int i = 0; i < count; i++)
        all[i + 2] = points[i];
    return graph_fit(stage, left, 0, width, STAGE_HEIGHT, all, count + 2);
}

void clip_picture_window(const struct graph *g, const struct clip_window *w)
{
    const struct point2 corners[] = {
        {w->x_min, w->y_min}, {w->x_max, w->y_min}, {w->x_max, w->y_max}, {w->x_min, w->y_max}};
    stage_ink(g->stage, INK_CYAN);
    graph_polygon(g, corners, 4);
}

void clip_code_text(unsigned code, char text[5])
{
    for (int i = 0; i < 4; i++)
        text[i] = code & 8u >> i ? '1' : '0';
    text[4] = '\0';
}

const char *clip_edge_name(unsigned region)
{
    switch (region) {
    case REGION_LEFT:
        return "left";
    case REGION_RIGHT:
        return "right";
    case REGION_BELOW:
        return "below";
    case REGION_ABOVE:
        return "above";
    default:
        return "-";
    }
}

void clip_picture_regions(const struct graph *g, const struct clip_window *w)
{
    const float x[] = {g->x_min, w->x_min, w->x_max, g->x_max};
    const float y[] = {g->y_min, w->y_min, w->y_max, g->y_max};
    stage_ink(g->stage, INK_GRID);
    for (int i = 1; i < 3; i++) {
        graph_line(g, (struct point2){x[i], y[0]}, (struct point2){x[i], y[3]});
        graph_line(g, (struct point2){x[0], y[i]}, (struct point2){x[3], y[i]});
    }
    stage_ink(g->stage, INK_BLUE);
    for (int i = 0; i < 9; i++) {
        char code[5];
        int column = i % 3, row = i / 3;
        struct point2 middle = {(x[column] + x[column + 1]) / 2, (y[row] + y[row + 1]) / 2};
        struct point2 at = graph_place(g, middle);
        clip_code_text(clip_region(w, middle), code);
        stage_text_middle(g->stage, at.x, at.y - 8, code);
    }
}

void clip_picture_cut_away(const struct graph *g, struct point2 a, struct point2 b)
{
    struct stage *s = g->stage;
    unsigned heads = s->heads;
    stage_heads(s, heads & STAGE_RASTER);
    stage_ink(s, INK_RED);
    graph_line(g, a, b);
    stage_heads(s, heads & STAGE_VECTOR);
    stage_ink(s, INK_BROWN);
    stage_line_type(s, STAGE_SHORT_DASH);
    graph_line(g, a, b);
    stage_line_type(s, STAGE_SOLID);
    stage_heads(s, heads);
}
