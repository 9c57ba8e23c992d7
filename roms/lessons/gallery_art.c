/* gallery_art.c — art: four works that move. */
#include "roms/lessons/gallery_art.h"

#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/raster/polygon_fill.h"

void art_area(struct stage *s, const struct point2 *p, int count, uint32_t colour, enum ink vector)
{
    enum { MOST = 16 };
    struct point2 q[MOST];
    count = count < MOST ? count : MOST;
    for (int i = 0; i < count; i++)
        q[i] = (struct point2){stage_canvas_x(s, p[i].x), stage_canvas_y(s, p[i].y)};
    canvas_polygon(&s->canvas, q, count, POLYGON_NON_ZERO, colour);
    if (vector == INK_BLACK)
        return;
    stage_heads(s, STAGE_VECTOR);
    stage_ink(s, vector);
    stage_polygon(s, p, count);
    stage_heads(s, STAGE_BOTH);
}

static const struct page table[] = {
    {"Guilloche", "Three circular motions, added; each curve a little further on than the last.",
     20, art_guilloche},
    {"Whirls", "Triangles in triangles: every corner a little further along the next one's edge.",
     20, art_whirls},
    {"Kaleidoscope", "Ten shards drift between two mirrors, 30 degrees apart.", 20,
     art_kaleidoscope},
    {"Lettering", "The dots of the font, on a cloth that waves, in perspective.", 20,
     art_lettering},
};

static struct pages pages = {
    .page = table, .count = sizeof table / sizeof table[0], .again = 0.02f};

extern const struct lesson lesson_gallery_art;
const struct lesson lesson_gallery_art = {"art",       "Gallery: art", PAGES_KEYS, &pages,
                                          pages_begin, pages_key,      pages_draw};
