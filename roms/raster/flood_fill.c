#include "roms/raster/flood_fill.h"

#include "roms/raster/pixel.h"

void flood_fill_begin(struct span_fill *f, const struct canvas *c, int x, int y, int connected,
                      uint32_t colour, struct span_seed *seeds, int room)
{
    uint32_t held = canvas_held(c, colour);
    *f = (struct span_fill){.canvas = c,
                            .of_limit = true,
                            .colour = held,
                            .corners = connected == 8,
                            .seeds = seeds,
                            .room = room};
    if (!canvas_holds(c, x, y))
        return;
    f->limit = canvas_pixel(c, x, y);
    if (f->limit == held)
        return;
    span_fill_push(f, x, y);
}

bool canvas_flood_fill(const struct canvas *c, int x, int y, int connected, uint32_t colour,
                       struct span_seed *seeds, int room)
{
    struct span_fill f;
    struct span_filled span;
    flood_fill_begin(&f, c, x, y, connected, colour, seeds, room);
    while (span_fill_next(&f, &span))
        ;
    return f.dropped == 0;
}
