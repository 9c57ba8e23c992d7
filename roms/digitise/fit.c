#include "roms/digitise/fit.h"

#include <stddef.h>

#include "roms/geometry/scalar.h"

#define DEGENERATE 1e-4f /* of a product of lengths: a triangle flatter than this has no area */

/* Sums about the centroids. */
struct fit_sums {
    struct point2 touched, known; /* the centroids */
    float uu, uv, vv, ux, vx, uy, vy;
};

static struct fit_sums sums_of(const struct fit_pair *p, int count)
{
    struct fit_sums s = {0};
    float part = 1 / (float)count;
    for (int i = 0; i < count; i++) {
        s.touched.x += p[i].touched.x * part;
        s.touched.y += p[i].touched.y * part;
        s.known.x += p[i].known.x * part;
        s.known.y += p[i].known.y * part;
    }
    for (int i = 0; i < count; i++) {
        float u = p[i].touched.x - s.touched.x, v = p[i].touched.y - s.touched.y;
        float x = p[i].known.x - s.known.x, y = p[i].known.y - s.known.y;
        s.uu += u * u;
        s.uv += u * v;
        s.vv += v * v;
        s.ux += u * x;
        s.vx += v * x;
        s.uy += u * y;
        s.vy += v * y;
    }
    return s;
}

static const char *similarity(const struct fit_sums *s, struct fit *f)
{
    float size = s->uu + s->vv;
    if (!(size > 1))
        return "The points touched coincide.";
    f->a = f->e = (s->ux + s->vy) / size;
    f->d = (s->uy - s->vx) / size;
    f->b = -f->d;
    return fabsf(f->a) + fabsf(f->d) > 0 ? NULL : "The coordinates given coincide.";
}

static const char *affine_of(const struct fit_sums *s, struct fit *f)
{
    float under = s->uu * s->vv - s->uv * s->uv;
    if (!(under > DEGENERATE * s->uu * s->vv) || !(s->uu + s->vv > 1))
        return "The points touched lie on a line.";
    f->a = (s->ux * s->vv - s->vx * s->uv) / under;
    f->b = (s->vx * s->uu - s->ux * s->uv) / under;
    f->d = (s->uy * s->vv - s->vy * s->uv) / under;
    f->e = (s->vy * s->uu - s->uy * s->uv) / under;
    return NULL;
}

static float residual_of(const struct fit *f, const struct fit_pair *p, int count)
{
    float sum = 0;
    for (int i = 0; i < count; i++) {
        struct point2 at = fit_place(f, p[i].touched);
        float dx = at.x - p[i].known.x, dy = at.y - p[i].known.y;
        sum += dx * dx + dy * dy;
    }
    return sqrtf(sum / (float)count);
}

struct fit fit_tablet(float mm_a_count)
{
    return (struct fit){.a = mm_a_count, .e = mm_a_count};
}

const char *fit_points(const struct fit_pair *pair, int count, bool affine, struct fit *out)
{
    struct fit f = {.affine = affine, .points = count, .checked = count > (affine ? 3 : 2)};
    if (count < (affine ? 3 : 2))
        return affine ? "An affine transformation takes three points." : "It takes two points.";
    struct fit_sums s = sums_of(pair, count);
    const char *trouble = affine ? affine_of(&s, &f) : similarity(&s, &f);
    if (trouble)
        return trouble;
    f.origin = s.touched;
    f.c = s.known.x;
    f.f = s.known.y;
    f.residual = residual_of(&f, pair, count);
    *out = f;
    return NULL;
}

struct point2 fit_place(const struct fit *f, struct point2 counts)
{
    float u = counts.x - f->origin.x, v = counts.y - f->origin.y;
    return (struct point2){f->a * u + f->b * v + f->c, f->d * u + f->e * v + f->f};
}

float fit_scale(const struct fit *f)
{
    return sqrtf(fabsf(f->a * f->e - f->b * f->d));
}

/* The paper's x axis on the tablet is opposite to how the tablet's is turned on the paper. */
float fit_turn(const struct fit *f)
{
    return -atan2f(f->d, f->a) / DEGREE;
}
