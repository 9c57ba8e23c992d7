#include "roms/raster/line_antialiased.h"

#include <math.h>

#include "roms/clip/liang_barsky.h"
#include "roms/raster/pixel.h"

/* 255 times the volume of a cone of radius 1 and volume 1 over a band one wide, by the distance of
 * their middles: the integral from d - 1/2 to d + 1/2 of
 * 3/pi (sqrt(1 - t²) - t² ln((1 + sqrt(1 - t²)) / |t|)). */
const uint8_t antialiased_coverage[ANTIALIASED_ENTRIES] = {
    199, 199, 199, 198, 198, 197, 196, 195, 194, 193, 191, 190, 188, 186, 184, 182, 179, 177, 174,
    172, 169, 166, 163, 160, 156, 153, 150, 146, 142, 139, 135, 131, 128, 124, 120, 116, 112, 109,
    105, 101, 98,  94,  90,  87,  84,  80,  77,  74,  70,  67,  64,  61,  58,  55,  52,  50,  47,
    44,  42,  39,  37,  35,  32,  30,  28,  26,  24,  22,  21,  19,  17,  16,  14,  13,  12,  10,
    9,   8,   7,   6,   5,   5,   4,   3,   3,   2,   2,   1,   1,   1,   0,   0,   0,
};

static const float reach = 30000;

static bool within(float v)
{
    return v >= -reach && v <= reach; /* false for what is not a number */
}

bool line_antialiased_begin(struct line_antialiased *l, float x0, float y0, float x1, float y1)
{
    if (!within(x0) || !within(y0) || !within(x1) || !within(y1))
        return false;
    l->steep = fabsf(y1 - y0) > fabsf(x1 - x0);
    /* a along the line, b across it. */
    float a0 = l->steep ? y0 : x0, b0 = l->steep ? x0 : y0;
    float a1 = l->steep ? y1 : x1, b1 = l->steep ? x1 : y1;
    if (a0 > a1) {
        float a = a0, b = b0;
        a0 = a1, b0 = b1;
        a1 = a, b1 = b;
    }
    float slope = a1 > a0 ? (b1 - b0) / (a1 - a0) : 0;
    l->along = (int)floorf(a0);
    l->last = (int)ceilf(a1);
    l->part_first = (int32_t)(256 * (1 - (a0 - (float)l->along)));
    l->part_last = (int32_t)(256 * (1 - ((float)l->last - a1)));
    l->slope = (int32_t)(slope * 65536.0f + (slope < 0 ? -0.5f : 0.5f));
    float b = b0 - (a0 - (float)l->along) * slope, whole = floorf(b);
    l->minor = (int32_t)whole * 65536 + (int32_t)((b - whole) * 65536.0f);
    l->cosine = (int32_t)(4096.0f / sqrtf(1 + slope * slope));
    l->first = true;
    return true;
}

/* Leaves out what is far outside: the ends that this cuts are not seen. */
static bool begin_on(const struct canvas *c, struct line_antialiased *l, float x0, float y0,
                     float x1, float y1)
{
    enum { BEYOND = 4 };
    const struct clip_window w = {-BEYOND, -BEYOND, (float)(c->width + BEYOND),
                                  (float)(c->height + BEYOND)};
    struct point2 a = {x0, y0}, b = {x1, y1};
    if (!within(x0) || !within(y0) || !within(x1) || !within(y1))
        return false;
    return c->width > 0 && clip_liang_barsky(&w, &a, &b) &&
           line_antialiased_begin(l, a.x, a.y, b.x, b.y);
}

/* ---- into a ramp ---------------------------------------------------------------------------------- */

struct shades {
    const uint32_t *ramp;
    uint32_t lowest, span; /* of its values, when they ascend */
    int levels;
};

static inline uint32_t shade(const struct shades *s, int coverage)
{
    return s->ramp[(coverage * (s->levels - 1) + 127) / 255];
}

/* Whether the old value is a lighter one of the ramp. */
static inline bool lighter(const struct shades *s, uint32_t old, uint32_t value)
{
    return old - s->lowest <= s->span && old > value;
}

static void ramp_pixel(const struct canvas *c, const struct shades *s, int x, int y, int coverage)
{
    if (coverage == 0 || !canvas_holds(c, x, y))
        return;
    uint32_t value = shade(s, coverage);
    if (!lighter(s, canvas_pixel(c, x, y), value))
        canvas_dot(c, x, y, value);
}

/* Pixels of bytes, one `step` bytes after the other. */
static void ramp_bytes(uint8_t *at, uint32_t step, const struct shades *s,
                       const struct antialiased_column *k)
{
    for (int i = 0; i < ANTIALIASED_PIXELS; i++, at += step) {
        uint32_t value = shade(s, k->coverage[i]);
        if (k->coverage[i] != 0 && !lighter(s, *at, value))
            *at = (uint8_t)value;
    }
}

static bool column_inside(const struct canvas *c, const struct antialiased_column *k)
{
    int width = k->steep ? c->height : c->width, height = k->steep ? c->width : c->height;
    return k->along >= 0 && k->along < width && k->across >= 0 &&
           k->across + ANTIALIASED_PIXELS <= height;
}

void canvas_line_antialiased(const struct canvas *c, float x0, float y0, float x1, float y1,
                             const uint32_t *ramp, int levels)
{
    struct line_antialiased line;
    struct antialiased_column k;
    if (levels < 2 || !begin_on(c, &line, x0, y0, x1, y1))
        return;
    struct shades s = {ramp, ramp[0], ramp[levels - 1] - ramp[0], levels};
    if (ramp[levels - 1] < ramp[0])
        s.span = 0;
    while (line_antialiased_next(&line, &k)) {
        int x = k.steep ? k.across : k.along, y = k.steep ? k.along : k.across;
        if (c->bits == 8 && column_inside(c, &k)) {
            ramp_bytes(c->pixels + (uint32_t)y * c->pitch + x, k.steep ? 1 : c->pitch, &s, &k);
            continue;
        }
        for (int i = 0; i < ANTIALIASED_PIXELS; i++)
            ramp_pixel(c, &s, k.steep ? x + i : x, k.steep ? y : y + i, k.coverage[i]);
    }
}

/* ---- blended -------------------------------------------------------------------------------------- */

/* Old and new mixed in the bits of `mask`, above which there is room for `bits` more. */
static inline uint32_t mixed(uint32_t old, uint32_t new, uint32_t mask, uint32_t part, int bits)
{
    return ((old & mask) * ((1u << bits) - part) + (new &mask) * part) >> bits & mask;
}

static inline uint32_t blend(unsigned bits, uint32_t old, uint32_t new, int coverage)
{
    uint32_t part = (uint32_t)(coverage + (coverage >> 7)); /* 256 is all */
    if (bits == 32)
        return mixed(old, new, 0x00FF00FF, part, 8) | mixed(old >> 8, new >> 8, 0x00FF00FF, part, 8)
                                                          << 8;
    part = (part + 4) / 8;
    return mixed(old, new, 0xF81F, part, 5) | mixed(old, new, 0x07E0, part, 5);
}

void canvas_line_blended(const struct canvas *c, float x0, float y0, float x1, float y1,
                         uint32_t colour)
{
    struct line_antialiased line;
    struct antialiased_column k;
    if (c->bits < 16 || !begin_on(c, &line, x0, y0, x1, y1))
        return;
    while (line_antialiased_next(&line, &k)) {
        for (int i = 0; i < ANTIALIASED_PIXELS; i++) {
            int x = k.steep ? k.across + i : k.along, y = k.steep ? k.along : k.across + i;
            if (k.coverage[i] != 0 && canvas_holds(c, x, y))
                canvas_dot(c, x, y, blend(c->bits, canvas_pixel(c, x, y), colour, k.coverage[i]));
        }
    }
}
