#include "roms/lessons/map_relief.h"

#include <math.h>

/* Bilinear: f across and g up, in 256ths. */
static inline int between(const int16_t grid[MAP_ROWS][MAP_COLUMNS], int column, int row, int f,
                          int g)
{
    const int16_t *low = &grid[row][column], *high = &grid[row + 1][column];
    int a = low[0] * (256 - f) + low[1] * f, b = high[0] * (256 - f) + high[1] * f;
    return ((a >> 8) * (256 - g) + (b >> 8) * g) >> 8;
}

/* Heights have tints from contour to contour, light makes them lighter and darker. */
static inline uint8_t shade(int height, int light)
{
    static const uint8_t ramps[] = {RAMP_GREEN,  RAMP_GREEN,  RAMP_GOLD, RAMP_GOLD,
                                    RAMP_COPPER, RAMP_COPPER, RAMP_GREY};
    static const int step = (int)(MAP_LEVEL_STEP * 4096);
    if (height < 0) {
        int level = 13 + height / 96;
        return (uint8_t)(16 + RAMP_BLUE * INK_LEVELS + (level < 4 ? 4 : level));
    }
    int band = height / step, level = 2 + (light * (band < 2 ? 18 : 24) >> 12);
    band = band > 6 ? 6 : band;
    return (uint8_t)(16 + ramps[band] * INK_LEVELS + level);
}

/* What is at a place, in cells of the grid · 65536: the deep sea beyond it. */
struct spot {
    int height, light;
};

static inline struct spot spot_at(const struct map_terrain *t, int32_t u, int32_t v)
{
    static const struct spot deep = {-480, 0};
    int column = u >> 16, line = v >> 16;
    if (column < 0 || column >= MAP_COLUMNS - 1 || line < 0 || line >= MAP_ROWS - 1)
        return deep;
    int f = u >> 8 & 255, g = v >> 8 & 255;
    return (struct spot){between(t->fixed, column, line, f, g),
                         between(t->light, column, line, f, g)};
}

/* Pairs from one spot to another, those between in equal steps; `bits`: how many, as a power of 2.
 */
static inline void blend(uint8_t *row, uint32_t pitch, int pairs, struct spot a, struct spot b,
                         int bits)
{
    enum { FRACTION = 8 };
    int height = a.height << FRACTION, light = a.light << FRACTION;
    int up = (b.height << FRACTION) - height, brighter = (b.light << FRACTION) - light;
    up >>= bits;
    brighter >>= bits;
    for (int i = 0; i < pairs; i++, row += 2, height += up, light += brighter) {
        unsigned ink = shade(height >> FRACTION, light >> FRACTION);
        uint16_t *first = (uint16_t *)(void *)row, *second = (uint16_t *)(void *)(row + pitch);
        *first = *second = (uint16_t)(ink | ink << 8); /* left and pitch are even */
    }
}

/* How many pairs, as a power of 2, are at most a cell's side. */
static int pairs_a_cell(int32_t du, int32_t dv)
{
    enum { MOST = 4 };
    uint32_t x = (uint32_t)(du < 0 ? -du : du), y = (uint32_t)(dv < 0 ? -dv : dv);
    int bits = 0;
    while (bits < MOST && (x > y ? x : y) << (bits + 1) <= 65536)
        bits++;
    return bits;
}

/* Pairs of pixels of two rows; u, v: the place in cells of the grid · 65536, du, dv: a pair
 * further. Within a cell heights and light are straight along the row. */
static void row_pair(uint8_t *row, uint32_t pitch, int pairs, const struct map_terrain *t,
                     int32_t u, int32_t v, int32_t du, int32_t dv)
{
    int bits = pairs_a_cell(du, dv), apart = 1 << bits;
    struct spot a = spot_at(t, u, v);
    for (int i = 0; i < pairs; i += apart) {
        u += du * apart;
        v += dv * apart;
        struct spot b = spot_at(t, u, v);
        blend(row + 2 * i, pitch, pairs - i < apart ? pairs - i : apart, a, b, bits);
        a = b;
    }
}

static int32_t cells(float km)
{
    return (int32_t)(km / MAP_CELL * 65536);
}

void map_relief(struct stage *s, const struct map_terrain *t, const struct clip_window *viewport,
                const struct matrix3 *back)
{
    const struct canvas *c = &s->canvas;
    if (c->width == 0)
        return;
    int left = (int)stage_canvas_x(s, viewport->x_min) & ~1;
    int right = (int)stage_canvas_x(s, viewport->x_max) & ~1;
    int top = (int)stage_canvas_y(s, viewport->y_max) & ~1;
    int bottom = (int)stage_canvas_y(s, viewport->y_min) & ~1;
    float unit = 1 / (stage_canvas_x(s, 1) - stage_canvas_x(s, 0)); /* stage units a pixel */
    for (int y = top; y < bottom; y += 2) {
        struct point2 at = {((float)left + 0.5f - stage_canvas_x(s, 0)) * unit,
                            (stage_canvas_y(s, 0) - (float)y - 0.5f) * unit};
        struct point2 from = matrix3_apply(back, at), next;
        at.x += 2 * unit;
        next = matrix3_apply(back, at);
        row_pair(c->pixels + (uint32_t)y * c->pitch + left, c->pitch, (right - left) / 2, t,
                 cells(from.x), cells(from.y), cells(next.x - from.x), cells(next.y - from.y));
    }
}
