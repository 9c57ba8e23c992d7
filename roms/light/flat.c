/* flat.c — one intensity a triangle.
 *
 * A pixel: depth read, compared, and where it is nearer depth and pixel written; depth stepped.
 */
#include "roms/light/run.h"

RUN_LOOP void flat_rows(struct shade *s, struct triangle *t, unsigned bits, uint32_t value)
{
    struct gradient z = triangle_gradient(t, t->a->z, t->b->z, t->c->z);
    struct run_target to = run_target(s);
    while (triangle_next(t)) {
        struct run r = run_of(&to, t, &z, bits);
#define PIXEL(k)                                                                                   \
    if (r.z > r.near[k]) {                                                                         \
        r.near[k] = r.z;                                                                           \
        if (bits == 8)                                                                             \
            r.at[k] = (uint8_t)value;                                                              \
        else                                                                                       \
            ((uint32_t *)(void *)r.at)[k] = value;                                                 \
    }                                                                                              \
    r.z += r.dz
        RUN_EACH(r, bits, PIXEL);
#undef PIXEL
    }
    s->covered += (uint32_t)t->covered;
}

void shade_flat(struct shade *s, float intensity, const struct shade_vertex *a,
                const struct shade_vertex *b, const struct shade_vertex *c)
{
    struct triangle t;
    if (!triangle_begin(&t, s->width, s->height, a, b, c))
        return;
    s->triangles++;
    if (s->bits == 8)
        flat_rows(s, &t, 8, shade_pixel(s, intensity));
    else
        flat_rows(s, &t, 32, shade_pixel(s, intensity));
}
