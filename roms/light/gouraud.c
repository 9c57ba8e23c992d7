/* gouraud.c — an intensity a corner, interpolated.
 *
 * A pixel: as flat, and the value shifted to its whole part and stepped. Values are fixed point
 * with 16 binary digits. A triangle so thin that rounding could carry the value beyond those of its
 * corners has their mean.
 */
#include "roms/geometry/scalar.h"
#include "roms/light/run.h"

/* Twice the area is less than half a pixel times the longest side. */
RUN_LOOP bool is_thin(const struct triangle *t)
{
    float bcx = t->acx - t->abx, bcy = t->acy - t->aby;
    float longest = scalar_max(scalar_max(t->abx * t->abx + t->aby * t->aby, bcx * bcx + bcy * bcy),
                               t->acx * t->acx + t->acy * t->acy);
    return t->inverse * t->inverse * longest > 4;
}

RUN_LOOP float value_at(const struct shade *s, const struct shade_vertex *v)
{
    float value = fmaf(v->intensity, s->scale, s->first);
    return scalar_clamp(value, s->first, s->first + s->scale) * 65536;
}

RUN_LOOP void gouraud_rows(struct shade *s, struct triangle *t, unsigned bits)
{
    struct gradient z = triangle_gradient(t, t->a->z, t->b->z, t->c->z);
    float a = value_at(s, t->a), b = value_at(s, t->b), c = value_at(s, t->c);
    struct gradient value = triangle_gradient(t, a, b, c);
    if (is_thin(t))
        value = (struct gradient){(a + b + c) / 3, 0, 0};
    int step = (int)value.dx;
    struct run_target to = run_target(s);
    while (triangle_next(t)) {
        struct run r = run_of(&to, t, &z, bits);
        int v = (int)triangle_value(t, &value);
#define PIXEL(k)                                                                                   \
    if (r.z > r.near[k]) {                                                                         \
        r.near[k] = r.z;                                                                           \
        run_put(r.at, k, bits, to.colours, v >> 16);                                               \
    }                                                                                              \
    r.z += r.dz;                                                                                   \
    v += step
        RUN_EACH(r, bits, PIXEL);
#undef PIXEL
    }
    s->covered += (uint32_t)t->covered;
}

void shade_gouraud(struct shade *s, const struct shade_vertex *a, const struct shade_vertex *b,
                   const struct shade_vertex *c)
{
    struct triangle t;
    if (!triangle_begin(&t, s->width, s->height, a, b, c))
        return;
    s->triangles++;
    if (s->bits == 8)
        gouraud_rows(s, &t, 8);
    else
        gouraud_rows(s, &t, 32);
}
