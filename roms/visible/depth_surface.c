#include "roms/visible/depth_surface.h"

#include "roms/visible/surface_scan.h"

/* Pixels of 8 bits, one after the other. */
static void depth_run(uint8_t *pixel, float *depth, int count, float z, float step, uint8_t colour)
{
    for (float *end = depth + count; depth < end; depth++, pixel++, z += step) {
        if (z > *depth) {
            *depth = z;
            *pixel = colour;
        }
    }
}

static void depth_run_any(const struct canvas *c, const struct surface_scan *row, float *depth,
                          float z, float step, uint32_t colour)
{
    for (int x = row->x0; x < row->x1; x++, depth++, z += step) {
        if (z > *depth) {
            *depth = z;
            canvas_dot(c, x, row->y, colour);
        }
    }
}

void depth_surface(const struct canvas *c, const struct depth_buffer *b, const struct scene *scene,
                   const struct surface *s)
{
    struct surface_scan row;
    if (s->plane.c == 0)
        return;
    float step = -s->plane.a / s->plane.c;
    surface_scan_begin(&row, scene, s, b->width, b->height);
    while (surface_scan_next(&row)) {
        float *depth = b->depth + row.y * b->width + row.x0;
        float z = surface_depth(s, (float)row.x0, (float)row.y);
        if (row.x0 >= row.x1)
            continue;
        if (c->bits == 8)
            depth_run(c->pixels + (uint32_t)row.y * c->pitch + row.x0, depth, row.x1 - row.x0, z,
                      step, (uint8_t)s->colour);
        else
            depth_run_any(c, &row, depth, z, step, s->colour);
    }
}

void depth_scene(const struct canvas *c, const struct depth_buffer *b, const struct scene *scene)
{
    for (int i = 0; i < scene->surfaces; i++)
        depth_surface(c, b, scene, &scene->surface[i]);
}
