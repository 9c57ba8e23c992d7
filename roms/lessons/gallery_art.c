/* gallery_art.c — art: four works that move. */
#include "roms/lessons/gallery_art.h"

#include "roms/lessons/lesson.h"
#include "roms/lessons/scenes.h"
#include "roms/raster/polygon_fill.h"

enum { SCENES = 4, SECONDS = 20 };

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

static void begin(void *state)
{
    scenes_begin((struct scenes *)state, SCENES);
}

static void key(void *state, int k)
{
    scenes_key((struct scenes *)state, k);
}

static float draw(void *state, struct stage *s, float seconds)
{
    static void (*const works[SCENES])(struct stage *, float) = {art_guilloche, art_whirls,
                                                                 art_kaleidoscope, art_lettering};
    struct scenes *scenes = (struct scenes *)state;
    float t = scenes_since(scenes, seconds);
    works[scenes->scene](s, t);
    scenes_end_after(scenes, SECONDS);
    return 0.02f;
}

static struct scenes lesson_state;

extern const struct lesson lesson_gallery_art;
const struct lesson lesson_gallery_art = {
    "art", "Gallery: art", SCENES_KEYS, &lesson_state, begin, key, draw};
