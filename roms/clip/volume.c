#include "roms/clip/volume.h"

#include <stddef.h>

static bool empty(const struct clip_window *w, float near, float far)
{
    return !(w->x_max > w->x_min && w->y_max > w->y_min && near > far);
}

bool volume_parallel(const struct clip_window *w, float near, float far, struct matrix4 *out)
{
    if (empty(w, near, far))
        return false;
    float across = w->x_max - w->x_min, up = w->y_max - w->y_min, deep = near - far;
    *out = (struct matrix4){{{2 / across, 0, 0, -(w->x_max + w->x_min) / across},
                             {0, 2 / up, 0, -(w->y_max + w->y_min) / up},
                             {0, 0, 2 / deep, -(near + far) / deep},
                             {0, 0, 0, 1}}};
    return true;
}

/* h = zprp − z, the distance from the eye; x/h and y/h run from −1 to 1 across the window, z/h from
 * −1 at the far plane to 1 at the near one. */
bool volume_perspective(struct vector3 prp, float zvp, const struct clip_window *w, float near,
                        float far, struct matrix4 *out)
{
    if (empty(w, near, far) || !(prp.z > near) || !(prp.z > zvp))
        return false;
    float across = w->x_max - w->x_min, up = w->y_max - w->y_min, dp = prp.z - zvp;
    float dn = prp.z - near, df = prp.z - far;
    /* Where the window's middle is, seen from the reference point. */
    float x = (w->x_max + w->x_min - 2 * prp.x) / across;
    float y = (w->y_max + w->y_min - 2 * prp.y) / up;
    float slope = (df + dn) / (df - dn), level = 2 * dn * df / (df - dn);
    *out = (struct matrix4){{{2 * dp / across, 0, x, -2 * dp * prp.x / across - x * prp.z},
                             {0, 2 * dp / up, y, -2 * dp * prp.y / up - y * prp.z},
                             {0, 0, slope, level - slope * prp.z},
                             {0, 0, -1, prp.z}}};
    return true;
}

float volume_boundary(const struct vector4 *p, enum volume_plane plane)
{
    switch (plane) {
    case VOLUME_LEFT:
        return p->h + p->x;
    case VOLUME_RIGHT:
        return p->h - p->x;
    case VOLUME_BELOW:
        return p->h + p->y;
    case VOLUME_ABOVE:
        return p->h - p->y;
    case VOLUME_FAR:
        return p->h + p->z;
    default:
        return p->h - p->z;
    }
}

unsigned volume_code(const struct vector4 *p)
{
    return (unsigned)(p->h + p->x < 0) << VOLUME_LEFT |
           (unsigned)(p->h - p->x < 0) << VOLUME_RIGHT |
           (unsigned)(p->h + p->y < 0) << VOLUME_BELOW |
           (unsigned)(p->h - p->y < 0) << VOLUME_ABOVE | (unsigned)(p->h + p->z < 0) << VOLUME_FAR |
           (unsigned)(p->h - p->z < 0) << VOLUME_NEAR;
}

/* The part t of the way from a to b. */
static struct vector4 between(const struct vector4 *a, const struct vector4 *b, float t)
{
    return (struct vector4){a->x + t * (b->x - a->x), a->y + t * (b->y - a->y),
                            a->z + t * (b->z - a->z), a->h + t * (b->h - a->h)};
}

/* Narrows t1…t2 by each plane that one end is outside of. */
static void narrow(struct volume_line *k)
{
    for (int i = 0; i < VOLUME_PLANES; i++) {
        if (k->a[i] >= 0 && k->b[i] >= 0)
            continue;
        float t = k->a[i] / (k->a[i] - k->b[i]);
        if (k->a[i] < 0)
            k->t1 = t > k->t1 ? t : k->t1;
        else
            k->t2 = t < k->t2 ? t : k->t2;
    }
}

bool volume_clip_line(struct vector4 *a, struct vector4 *b, struct volume_line *working)
{
    struct volume_line local, *k = working != NULL ? working : &local;
    *k = (struct volume_line){.code_a = volume_code(a), .code_b = volume_code(b), .t2 = 1};
    if (working == NULL && (k->code_a | k->code_b) == 0)
        return true;
    for (int i = 0; i < VOLUME_PLANES; i++) {
        k->a[i] = volume_boundary(a, (enum volume_plane)i);
        k->b[i] = volume_boundary(b, (enum volume_plane)i);
    }
    if ((k->code_a & k->code_b) != 0) {
        k->t1 = 1; /* wholly outside of one plane */
        k->t2 = 0;
        return false;
    }
    narrow(k);
    if (k->t1 > k->t2)
        return false;
    struct vector4 from = *a, to = *b;
    if (k->t1 > 0)
        *a = between(&from, &to, k->t1);
    if (k->t2 < 1)
        *b = between(&from, &to, k->t2);
    return true;
}

int volume_clip_plane(const struct vector4 *in, int count, enum volume_plane plane,
                      struct vector4 *out)
{
    int kept = 0;
    if (count == 0)
        return 0;
    const struct vector4 *last = &in[count - 1];
    float before = volume_boundary(last, plane);
    for (int i = 0; i < count; i++) {
        float now = volume_boundary(&in[i], plane);
        /* From the inside point on, so that an edge shared by two polygons is cut in one place. */
        if (before > 0 && now < 0)
            out[kept++] = between(last, &in[i], before / (before - now));
        else if (before < 0 && now > 0)
            out[kept++] = between(&in[i], last, now / (now - before));
        if (now >= 0)
            out[kept++] = in[i];
        last = &in[i];
        before = now;
    }
    return kept;
}

int volume_clip_polygon(const struct vector4 *in, int count, struct vector4 out[VOLUME_ROOM])
{
    struct vector4 other[VOLUME_ROOM], *now = out, *next = other;
    unsigned all = ~0u, any = 0;
    if (count < 3 || count > VOLUME_CORNERS)
        return 0;
    for (int i = 0; i < count; i++) {
        unsigned code = volume_code(&in[i]);
        all &= code;
        any |= code;
    }
    if (all != 0)
        return 0;
    for (int plane = 0; plane < VOLUME_PLANES; plane++) {
        if ((any & 1u << plane) == 0)
            continue;
        count = volume_clip_plane(in, count, (enum volume_plane)plane, now);
        struct vector4 *full = now;
        in = full;
        now = next;
        next = full;
    }
    for (int i = 0; i < count && in != out; i++)
        out[i] = in[i];
    return count >= 3 ? count : 0;
}
