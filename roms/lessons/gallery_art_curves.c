/* gallery_art_curves.c — a guilloche, as on banknotes: families of closed curves of three
 * circular motions. Frequencies that are equal modulo the number of petals make the curve that
 * often symmetric. */
#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/gallery_art.h"
#include "roms/raster/line_antialiased.h"

enum { POINTS = 150, CURVES = 12, VECTOR_CURVES = 6 };

/* One turn. */
struct circle {
    float cosine[POINTS], sine[POINTS];
};

/* Three circular motions: how large, how fast. */
struct motion {
    float size[3];
    int times[3];
};

static void turn(struct circle *c)
{
    for (int i = 0; i < POINTS; i++) {
        c->cosine[i] = cosf(TURN * (float)i / POINTS);
        c->sine[i] = sinf(TURN * (float)i / POINTS);
    }
}

static struct point2 at(const struct circle *c, const struct motion *m, int i)
{
    struct point2 p = {STAGE_WIDTH / 2, STAGE_HEIGHT / 2};
    for (int k = 0; k < 3; k++) {
        int where = (i * m->times[k] % POINTS + POINTS) % POINTS;
        p.x += m->size[k] * c->cosine[where];
        p.y += m->size[k] * c->sine[where];
    }
    return p;
}

static void curve(struct stage *s, const struct circle *c, const struct motion *m,
                  const uint32_t *ramp, bool vector)
{
    struct point2 a = at(c, m, 0);
    stage_heads(s, STAGE_VECTOR);
    for (int i = 1; i <= POINTS; i++) {
        struct point2 b = at(c, m, i);
        canvas_line_antialiased(&s->canvas, stage_canvas_x(s, a.x), stage_canvas_y(s, a.y),
                                stage_canvas_x(s, b.x), stage_canvas_y(s, b.y), ramp, INK_LEVELS);
        if (vector)
            stage_line(s, a.x, a.y, b.x, b.y);
        a = b;
    }
    stage_heads(s, STAGE_BOTH);
}

void art_guilloche(struct stage *s, float seconds)
{
    static const enum ink_ramp ramps[] = {RAMP_GOLD, RAMP_COPPER, RAMP_BLUE};
    static const enum ink inks[] = {INK_BRIGHT, INK_CYAN, INK_TEXT};
    static struct circle circle;
    int petals = 5 + 2 * ((int)(seconds / 10) % 2);
    turn(&circle);
    for (int i = 0; i < CURVES; i++) {
        float part = (float)i / (CURVES - 1), wave = seconds * 0.35f + 1.4f * part;
        struct motion m = {.size = {150 + 90 * part, 110 + 40 * sinf(wave), 75 * cosf(wave * 1.3f)},
                           .times = {1, 1 - petals, 1 + 2 * petals}};
        uint32_t ramp[INK_LEVELS];
        for (int k = 0; k < INK_LEVELS; k++)
            ramp[k] = ink_shade(ramps[i * 3 / CURVES], (float)k / (INK_LEVELS - 1) * 0.75f);
        stage_ink(s, inks[i * 3 / CURVES]);
        curve(s, &circle, &m, ramp, i % (CURVES / VECTOR_CURVES) == 1);
    }
}
