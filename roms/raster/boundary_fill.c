#include "roms/raster/boundary_fill.h"

/* As pixels hold it. */
static uint32_t held(const struct canvas *c, uint32_t colour)
{
    return c->bits < 32 ? colour & ((1u << c->bits) - 1) : colour;
}

void boundary_fill_begin(struct span_fill *f, const struct canvas *c, int x, int y, int connected,
                         uint32_t boundary, uint32_t colour, struct span_seed *seeds, int room)
{
    *f = (struct span_fill){.canvas = c,
                            .of_limit = false,
                            .limit = held(c, boundary),
                            .colour = held(c, colour),
                            .corners = connected == 8,
                            .seeds = seeds,
                            .room = room};
    if (x < 0 || y < 0 || x >= c->width || y >= c->height)
        return;
    span_fill_push(f, x, y);
}

bool canvas_boundary_fill(const struct canvas *c, int x, int y, int connected, uint32_t boundary,
                          uint32_t colour, struct span_seed *seeds, int room)
{
    struct span_fill f;
    struct span_filled span;
    boundary_fill_begin(&f, c, x, y, connected, boundary, colour, seeds, room);
    while (span_fill_next(&f, &span))
        ;
    return f.dropped == 0;
}
