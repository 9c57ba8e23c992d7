/* An icosahedron, each face of one shade: the more it faces the light, the brighter. */
#include <math.h>

#include "roms/pageflip/pageflip.h"

struct point {
    float x, y, z;
};

/* Corners are at distance 1; the faces' corners are in order around them, seen from outside. */
#define A 0.52573111f
#define B 0.85065081f
static const struct point corners[12] = {{-A, B, 0}, {A, B, 0}, {-A, -B, 0}, {A, -B, 0},
                                         {0, -A, B}, {0, A, B}, {0, -A, -B}, {0, A, -B},
                                         {B, 0, -A}, {B, 0, A}, {-B, 0, -A}, {-B, 0, A}};
static const uint8_t faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

/* About the upright axis, then leaning. */
static struct point turned(struct point p, float angle)
{
    float s = sinf(angle), c = cosf(angle), ls = sinf(angle * 0.37f + 0.4f),
          lc = cosf(angle * 0.37f + 0.4f);
    struct point q = {c * p.x + s * p.z, p.y, c * p.z - s * p.x};
    return (struct point){q.x, lc * q.y - ls * q.z, ls * q.y + lc * q.z};
}

static struct point cross(struct point a, struct point b)
{
    return (struct point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static struct point minus(struct point a, struct point b)
{
    return (struct point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static void swap(struct point *a, struct point *b)
{
    struct point c = *a;
    *a = *b;
    *b = c;
}

/* An edge, followed row by row. */
struct edge {
    float x, step;
};

static struct edge edge(struct point a, struct point b, int row)
{
    float step = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0f;
    return (struct edge){a.x + ((float)row + 0.5f - a.y) * step, step};
}

/* Rows from `row` to the one whose middle is at `end` or below. */
static int rows(const struct canvas *canvas, int row, float end, struct edge *one,
                struct edge *other, uint32_t colour)
{
    for (; (float)row + 0.5f < end; row++) {
        int from = (int)(fminf(one->x, other->x) + 0.5f);
        int to = (int)(fmaxf(one->x, other->x) + 0.5f);
        canvas_fill(canvas, from, row, to - from, 1, colour);
        one->x += one->step;
        other->x += other->step;
    }
    return row;
}

/* Pixels whose middle is within; all of it lies at positive places. */
static void triangle(const struct canvas *canvas, struct point a, struct point b, struct point c,
                     uint32_t colour)
{
    if (b.y < a.y)
        swap(&a, &b);
    if (c.y < a.y)
        swap(&a, &c);
    if (c.y < b.y)
        swap(&b, &c);
    int row = (int)(a.y + 0.5f);
    struct edge whole = edge(a, c, row), part = edge(a, b, row);
    row = rows(canvas, row, b.y, &whole, &part, colour);
    part = edge(b, c, row);
    rows(canvas, row, c.y, &whole, &part, colour);
}

void pageflip_solid(const struct pageflip_page *page, float angle)
{
    const struct pageflip_rect *r = &page->solid;
    const struct point light = {-0.48f, -0.60f, 0.64f};
    int size = r->width < r->height ? r->width : r->height;
    int left = r->x + (r->width - size) / 2, top = r->y + (r->height - size) / 2;
    struct point seen[12], shown[12];
    for (int i = 0; i < 12; i++) {
        seen[i] = turned(corners[i], angle);
        shown[i].x = (float)left + (float)size * (0.5f + 0.48f * seen[i].x);
        shown[i].y = (float)top + (float)size * (0.5f + 0.48f * seen[i].y);
    }
    canvas_fill(&page->canvas, left, top, size, size, PAGEFLIP_GROUND);
    for (int i = 0; i < 20; i++) {
        const uint8_t *f = faces[i];
        struct point n = cross(minus(seen[f[1]], seen[f[0]]), minus(seen[f[2]], seen[f[0]]));
        if (n.z <= 0)
            continue; /* on the far side */
        float facing = (n.x * light.x + n.y * light.y + n.z * light.z) /
                       sqrtf(n.x * n.x + n.y * n.y + n.z * n.z);
        int shade = facing > 0 ? (int)(facing * (PAGEFLIP_SHADES - 1)) : 0;
        triangle(&page->canvas, shown[f[0]], shown[f[1]], shown[f[2]],
                 PAGEFLIP_SHADE + (uint32_t)shade);
    }
}
