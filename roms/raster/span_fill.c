#include "roms/raster/span_fill.h"

#include "roms/raster/pixel.h"

static inline bool is_inside(const struct span_fill *f, uint32_t value)
{
    return f->of_limit ? value == f->limit : value != f->limit && value != f->colour;
}

static inline bool inside(const struct span_fill *f, int x, int y)
{
    return is_inside(f, canvas_pixel(f->canvas, x, y));
}

/* Stretches of equal pixels are passed a word at a time: only their first one is looked at. */
static int look_bytes(const struct span_fill *f, const uint8_t *row, int x, int end, bool wanted)
{
    while (x < end) {
        uint32_t value = row[x], word = value * 0x01010101;
        if (is_inside(f, value) == wanted)
            return x;
        while (x < end && row[x] == value) {
            x++;
            while (((uintptr_t)(row + x) & 3) == 0 && x + 4 <= end &&
                   *(const uint32_t *)(const void *)(row + x) == word)
                x += 4;
        }
    }
    return end;
}

static int look_words(const struct span_fill *f, const uint32_t *row, int x, int end, bool wanted)
{
    while (x < end) {
        uint32_t value = row[x];
        if (is_inside(f, value) == wanted)
            return x;
        while (x < end && row[x] == value)
            x++;
    }
    return end;
}

/* The first pixel from x on, of those before `end`, that is inside or is not. */
static int look(const struct span_fill *f, int x, int end, int y, bool wanted)
{
    const struct canvas *c = f->canvas;
    const uint8_t *row = c->pixels + (uint32_t)y * c->pitch;
    if (c->bits == 8)
        return look_bytes(f, row, x, end, wanted);
    if (c->bits == 32)
        return look_words(f, (const uint32_t *)(const void *)row, x, end, wanted);
    while (x < end && inside(f, x, y) != wanted)
        x++;
    return x;
}

void span_fill_push(struct span_fill *f, int x, int y)
{
    if (f->count == f->room) {
        f->dropped++;
        return;
    }
    f->seeds[f->count++] = (struct span_seed){(int16_t)x, (int16_t)y};
    f->deepest = f->count > f->deepest ? f->count : f->deepest;
}

/* A seed for each inside stretch of pixels x0…x1 of the row. */
static void push_row(struct span_fill *f, int x0, int x1, int y)
{
    if (y < 0 || y >= f->canvas->height)
        return;
    x0 = x0 > 0 ? x0 : 0;
    int end = x1 < f->canvas->width ? x1 + 1 : f->canvas->width;
    for (int x = look(f, x0, end, y, true); x < end; x = look(f, x, end, y, true)) {
        span_fill_push(f, x, y);
        x = look(f, x, end, y, false);
    }
}

bool span_fill_next(struct span_fill *f, struct span_filled *out)
{
    const struct canvas *c = f->canvas;
    while (f->count > 0) {
        struct span_seed s = f->seeds[--f->count];
        int x0 = s.x, y = s.y;
        if (!canvas_holds(c, x0, y) || !inside(f, x0, y))
            continue;
        while (x0 > 0 && inside(f, x0 - 1, y))
            x0--;
        int end = look(f, s.x, c->width, y, false);
        canvas_fill(c, x0, y, end - x0, 1, f->colour);
        int before = f->count;
        push_row(f, x0 - f->corners, end - 1 + f->corners, y - 1);
        push_row(f, x0 - f->corners, end - 1 + f->corners, y + 1);
        *out = (struct span_filled){s.x, y, x0, end - 1, f->count - before};
        return true;
    }
    return false;
}
