/* shade — a turning torus, shaded: floats, and a depth buffer in memory.
 *
 * Each frame turns the model, projects its corners in perspective, and fills its triangles row by row;
 * depth and normal are interpolated to every dot, the normal is made one long again there, and the
 * light of a dot is ambient, diffuse and a specular power (B. T. Phong, "Illumination for computer
 * generated pictures", CACM 18, 1975; with J. F. Blinn's half-way vector, 1977).
 */
#include "roms/bench/kernel.h"

enum {
    SIZE = 256,
    AROUND = 36, /* corners around the torus … */
    RING = 16,   /* … and around its tube: 1152 triangles */
    CORNERS = AROUND * RING,
    FRAMES = 40,
};

const char kernel_name[] = "shade";

struct vector {
    float x, y, z;
};

/* A corner on the screen: place, 1/distance, normal. */
struct corner {
    float x, y, depth;
    struct vector normal;
};

static uint8_t picture[SIZE * SIZE];
static float nearest[SIZE * SIZE]; /* 1/distance of what is drawn there; 0: nothing */
static struct vector model[CORNERS], model_normal[CORNERS];
static struct corner corners[CORNERS];

/* Cosine and sine of 2π/n and multiples by turning step by step: no library is needed. */
struct turn {
    float c, s;
};

static struct turn turned(struct turn a, struct turn by)
{
    return (struct turn){a.c * by.c - a.s * by.s, a.s * by.c + a.c * by.s};
}

static void make_torus(void)
{
    static const struct turn step_around = {0.98480775f, 0.17364818f}; /* 10° */
    static const struct turn step_ring = {0.92387953f, 0.38268343f};   /* 22.5° */
    static const float radius = 1.0f, tube = 0.45f;
    struct turn around = {1, 0};
    int n = 0;
    for (int i = 0; i < AROUND; i++) {
        struct turn ring = {1, 0};
        for (int k = 0; k < RING; k++) {
            struct vector normal = {around.c * ring.c, around.s * ring.c, ring.s};
            model_normal[n] = normal;
            model[n] = (struct vector){around.c * radius + normal.x * tube,
                                       around.s * radius + normal.y * tube, normal.z * tube};
            n++;
            ring = turned(ring, step_ring);
        }
        around = turned(around, step_around);
    }
}

static struct vector rotated(struct vector v, struct turn about_x, struct turn about_y)
{
    float y = v.y * about_x.c - v.z * about_x.s, z = v.y * about_x.s + v.z * about_x.c;
    return (struct vector){v.x * about_y.c + z * about_y.s, y, z * about_y.c - v.x * about_y.s};
}

static void project(struct turn about_x, struct turn about_y)
{
    static const float away = 4.0f, scale = 1.15f * SIZE;
    for (int i = 0; i < CORNERS; i++) {
        struct vector v = rotated(model[i], about_x, about_y);
        float depth = 1.0f / (v.z + away);
        corners[i].x = SIZE / 2 + v.x * depth * scale;
        corners[i].y = SIZE / 2 - v.y * depth * scale;
        corners[i].depth = depth;
        corners[i].normal = rotated(model_normal[i], about_x, about_y);
    }
}

/* The light of a dot, 0…255. The light comes from above, left of the viewer, who is at -z. */
static uint8_t lit(float x, float y, float z)
{
    float inverse = 1.0f / __builtin_sqrtf(x * x + y * y + z * z);
    float diffuse = (x * -0.45f + y * 0.6f + z * -0.6614378f) * inverse;
    if (diffuse < 0)
        return 20;
    float shine = (x * -0.2468f + y * 0.3291f + z * -0.9115f) * inverse;
    if (shine < 0)
        shine = 0;
    shine *= shine; /* to the 32nd power */
    shine *= shine;
    shine *= shine;
    shine *= shine;
    shine *= shine;
    return (uint8_t)(20.0f + 140.0f * diffuse + 90.0f * shine);
}

/* What changes along a row, or down an edge. */
struct values {
    float depth, x, y, z;
};

/* a + (b - a) t */
static struct values mix(const struct values *a, const struct values *b, float t)
{
    return (struct values){a->depth + (b->depth - a->depth) * t, a->x + (b->x - a->x) * t,
                           a->y + (b->y - a->y) * t, a->z + (b->z - a->z) * t};
}

static void row(int y, float left, float right, const struct values *from, const struct values *to)
{
    int first = (int)(left + 0.5f), last = (int)(right + 0.5f); /* last is not drawn */
    if (first < 0)
        first = 0;
    if (last > SIZE)
        last = SIZE;
    if (first >= last)
        return;
    float per_dot = 1.0f / (right - left);
    struct values v = mix(from, to, ((float)first + 0.5f - left) * per_dot);
    float depth = (to->depth - from->depth) * per_dot, nx = (to->x - from->x) * per_dot;
    float ny = (to->y - from->y) * per_dot, nz = (to->z - from->z) * per_dot;
    float *near = &nearest[y * SIZE];
    uint8_t *dots = &picture[y * SIZE];
    for (int x = first; x < last; x++) {
        if (v.depth > near[x]) {
            near[x] = v.depth;
            dots[x] = lit(v.x, v.y, v.z);
        }
        v.depth += depth;
        v.x += nx;
        v.y += ny;
        v.z += nz;
    }
}

static struct values values_of(const struct corner *c)
{
    return (struct values){c->depth, c->normal.x, c->normal.y, c->normal.z};
}

/* Where an edge crosses the middle of a row. */
static float edge(const struct corner *top, const struct corner *bottom, float y,
                  struct values *values)
{
    float t = (y - top->y) / (bottom->y - top->y);
    struct values a = values_of(top), b = values_of(bottom);
    *values = mix(&a, &b, t);
    return top->x + (bottom->x - top->x) * t;
}

static void triangle(const struct corner *a, const struct corner *b, const struct corner *c)
{
    const struct corner *kept;
    if (a->y > b->y)
        kept = a, a = b, b = kept;
    if (b->y > c->y)
        kept = b, b = c, c = kept;
    if (a->y > b->y)
        kept = a, a = b, b = kept;
    int first = (int)(a->y + 0.5f), last = (int)(c->y + 0.5f);
    for (int y = first < 0 ? 0 : first; y < last && y < SIZE; y++) {
        float middle = (float)y + 0.5f;
        struct values whole, part;
        float x = edge(a, c, middle, &whole);
        float other = middle < b->y ? edge(a, b, middle, &part) : edge(b, c, middle, &part);
        if (x < other)
            row(y, x, other, &whole, &part);
        else
            row(y, other, x, &part, &whole);
    }
}

/* Triangles that turn their backs are left out. */
static void front(const struct corner *a, const struct corner *b, const struct corner *c)
{
    float area = (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
    if (area > 0)
        triangle(a, b, c);
}

static void fill(void)
{
    for (int i = 0; i < AROUND; i++) {
        const struct corner *here = &corners[i * RING], *next = &corners[(i + 1) % AROUND * RING];
        for (int k = 0; k < RING; k++) {
            int m = (k + 1) % RING;
            front(&here[k], &next[k], &next[m]);
            front(&here[k], &next[m], &here[m]);
        }
    }
}

static void clear(void)
{
    for (int i = 0; i < SIZE * SIZE; i++) {
        picture[i] = 0;
        nearest[i] = 0;
    }
}

uint32_t kernel_run(void)
{
    static const struct turn step_x = {0.99619470f, 0.08715574f}; /* 5° */
    static const struct turn step_y = {0.99254615f, 0.12186934f}; /* 7° */
    struct turn about_x = {0.8660254f, 0.5f}, about_y = {1, 0};
    uint32_t sum = KERNEL_SUM_START;
    make_torus();
    for (int frame = 0; frame < FRAMES; frame++) {
        clear();
        project(about_x, about_y);
        fill();
        about_x = turned(about_x, step_x);
        about_y = turned(about_y, step_y);
        for (int i = 0; i < SIZE * SIZE; i++)
            sum = kernel_sum(sum, picture[i]);
    }
    return sum;
}
