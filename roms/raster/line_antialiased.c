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

static const float farthest = 30000;

static bool reachable(float v)
{
    return v >= -farthest && v <= farthest; /* false for what is not a number */
}

bool line_antialiased_begin(struct line_antialiased *l, float x0, float y0, float x1, float y1)
{
    if (!reachable(x0) || !reachable(y0) || !reachable(x1) || !reachable(y1))
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
    if (!reachable(x0) || !reachable(y0) || !reachable(x1) || !reachable(y1))
        return false;
    return c->width > 0 && clip_liang_barsky(&w, &a, &b) &&
           line_antialiased_begin(l, a.x, a.y, b.x, b.y);
}

/* Whether all pixels of the column are on the canvas. */
static inline bool column_inside(const struct canvas *c, const struct antialiased_column *k)
{
    int width = k->steep ? c->height : c->width, height = k->steep ? c->width : c->height;
    return (unsigned)k->along < (unsigned)width && k->across >= 0 &&
           k->across + ANTIALIASED_PIXELS <= height;
}

/* ---- into a ramp ----------------------------------------------------------------------------- */

struct shades {
    const uint32_t *ramp;
    uint32_t lowest, span; /* of its values, when they ascend */
    uint32_t scale;        /* coverage to its entries, 16 bits behind the point */
};

static inline uint32_t shade(const struct shades *s, uint32_t coverage)
{
    return s->ramp[(coverage * s->scale + 32768) >> 16];
}

/* Whether the old value is a lighter one of the ramp. */
static inline bool lighter(const struct shades *s, uint32_t old, uint32_t value)
{
    return old > value && old - s->lowest <= s->span;
}

static void ramp_pixel(const struct canvas *c, const struct shades *s, int x, int y,
                       uint32_t coverage)
{
    if (coverage == 0 || !canvas_holds(c, x, y))
        return;
    uint32_t value = shade(s, coverage);
    if (!lighter(s, canvas_pixel(c, x, y), value))
        canvas_dot(c, x, y, value);
}

static inline void ramp_byte(uint8_t *at, const struct shades *s, uint32_t coverage)
{
    uint32_t value = shade(s, coverage);
    if (coverage != 0 && !lighter(s, *at, value))
        *at = (uint8_t)value;
}

/* Pixels of bytes, one `step` bytes after the other. */
static inline void ramp_bytes(uint8_t *at, uint32_t step, const struct shades *s,
                              const struct antialiased_column *k)
{
    ramp_byte(at, s, k->coverage[0]);
    ramp_byte(at + step, s, k->coverage[1]);
    ramp_byte(at + 2 * step, s, k->coverage[2]);
    ramp_byte(at + 3 * step, s, k->coverage[3]);
}

void canvas_line_antialiased(const struct canvas *c, float x0, float y0, float x1, float y1,
                             const uint32_t *ramp, int levels)
{
    struct line_antialiased line;
    struct antialiased_column k;
    if (levels < 2 || levels > 256 || !begin_on(c, &line, x0, y0, x1, y1))
        return;
    uint32_t last = (uint32_t)levels - 1;
    struct shades s = {ramp, ramp[0], ramp[last] >= ramp[0] ? ramp[last] - ramp[0] : 0,
                       (last * 65536 + 127) / 255};
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

/* ---- blended --------------------------------------------------------------------------------- */

/* Old and new mixed in the bits of `mask`, above which there is room for `bits` more. */
static inline uint32_t mixed(uint32_t old, uint32_t new, uint32_t mask, uint32_t part, int bits)
{
    return ((old & mask) * ((1u << bits) - part) + (new &mask) * part) >> bits & mask;
}

static inline uint32_t blend_32(uint32_t old, uint32_t new, uint32_t coverage)
{
    uint32_t part = coverage + (coverage >> 7); /* 256 is all */
    return mixed(old, new, 0x00FF00FF, part, 8) | mixed(old >> 8, new >> 8, 0x00FF00FF, part, 8)
                                                      << 8;
}

static inline uint32_t blend_16(uint32_t old, uint32_t new, uint32_t coverage)
{
    uint32_t part = (coverage + (coverage >> 7) + 4) / 8; /* 32 is all */
    return mixed(old, new, 0xF81F, part, 5) | mixed(old, new, 0x07E0, part, 5);
}

static void blend_pixel(const struct canvas *c, int x, int y, uint32_t colour, uint32_t coverage)
{
    if (coverage == 0 || !canvas_holds(c, x, y))
        return;
    uint8_t *at = c->pixels + (uint32_t)y * c->pitch + (uint32_t)x * (c->bits / 8);
    if (c->bits == 32)
        *(uint32_t *)(void *)at = blend_32(*(uint32_t *)(void *)at, colour, coverage);
    else
        *(uint16_t *)(void *)at = (uint16_t)blend_16(*(uint16_t *)(void *)at, colour, coverage);
}

static inline void blend_word(uint8_t *at, uint32_t colour, uint32_t coverage)
{
    if (coverage != 0)
        *(uint32_t *)(void *)at = blend_32(*(uint32_t *)(void *)at, colour, coverage);
}

/* Pixels of words, one `step` bytes after the other. */
static inline void blend_words(uint8_t *at, uint32_t step, uint32_t colour,
                               const struct antialiased_column *k)
{
    blend_word(at, colour, k->coverage[0]);
    blend_word(at + step, colour, k->coverage[1]);
    blend_word(at + 2 * step, colour, k->coverage[2]);
    blend_word(at + 3 * step, colour, k->coverage[3]);
}

void canvas_line_blended(const struct canvas *c, float x0, float y0, float x1, float y1,
                         uint32_t colour)
{
    struct line_antialiased line;
    struct antialiased_column k;
    if (c->bits < 16 || !begin_on(c, &line, x0, y0, x1, y1))
        return;
    while (line_antialiased_next(&line, &k)) {
        int x = k.steep ? k.across : k.along, y = k.steep ? k.along : k.across;
        if (c->bits == 32 && column_inside(c, &k)) {
            blend_words(c->pixels + (uint32_t)y * c->pitch + 4 * (uint32_t)x,
                        k.steep ? 4 : c->pitch, colour, &k);
            continue;
        }
        for (int i = 0; i < ANTIALIASED_PIXELS; i++)
            blend_pixel(c, k.steep ? x + i : x, k.steep ? y : y + i, colour, k.coverage[i]);
    }
}
