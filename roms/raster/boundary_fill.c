#include "roms/raster/boundary_fill.h"

#include "roms/raster/pixel.h"

void boundary_fill_begin(struct span_fill *f, const struct canvas *c, int x, int y, int connected,
                         uint32_t boundary, uint32_t colour, struct span_seed *seeds, int room)
{
    *f = (struct span_fill){.canvas = c,
                            .of_limit = false,
                            .limit = canvas_held(c, boundary),
                            .colour = canvas_held(c, colour),
                            .corners = connected == 8,
                            .seeds = seeds,
                            .room = room};
    if (!canvas_holds(c, x, y))
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
