#include "roms/light/shade.h"

#include <stddef.h>

const char *const shading_names[] = {"flat", "gouraud", "phong", "fast-phong", NULL};

static struct shade shade_of(const struct canvas *c, const struct depth_buffer *d, unsigned bits,
                             uint32_t first, int levels)
{
    struct shade s = {.bits = bits};
    if (c->bits != bits || d->width != c->width || d->height != c->height || levels < 1 ||
        levels > SHADE_LEVELS)
        return s;
    s.pixels = c->pixels;
    s.pitch = c->pitch;
    s.depth = d->depth;
    s.width = c->width;
    s.height = c->height;
    s.first = (float)first + 0.5f;
    s.scale = (float)(levels - 1);
    s.top = (float)first + (float)levels - 0.25f;
    return s;
}

struct shade shade_begin(const struct canvas *c, const struct depth_buffer *d, uint32_t first,
                         int levels)
{
    return shade_of(c, d, 8, first, levels);
}

struct shade shade_begin_colours(const struct canvas *c, const struct depth_buffer *d,
                                 const uint32_t *colours, int levels)
{
    struct shade s = shade_of(c, d, 32, 0, levels);
    s.colours = colours;
    return s;
}
