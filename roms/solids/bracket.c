#include "roms/solids/bracket.h"

#include "roms/geometry/scalar.h"

enum { ANGLES = 32, ROUND = 24 };

/* A plate with a hole: points on rays from the hole's middle, on both faces. */
struct plate {
    float angle[ANGLES]; /* of the rays, ascending, 0 … 2π */
    int count;
    int outer[2][ANGLES], inner[2][ANGLES]; /* vertices; [0] is the face toward +z or +y */
    int line_first, line_last;              /* rays between these end where the plates meet */
};

/* The strip of the base between its hole's plate and the upright. */
static float strip(const struct bracket *b)
{
    return 0.1f * (b->depth - b->thickness);
}

float bracket_lower_z(const struct bracket *b)
{
    return (b->thickness + strip(b) + b->depth) / 2;
}

bool bracket_fits(const struct bracket *b)
{
    float around = (b->depth - b->thickness - strip(b)) / 2;
    return b->thickness > 0 && b->upper_diameter > 0 && b->lower_diameter > 0 &&
           b->upper_diameter < 0.95f * b->width && b->lower_diameter < 0.95f * b->width &&
           b->upper_diameter < 1.9f * (b->height - b->thickness) &&
           b->lower_diameter < 1.9f * around;
}

/* Keeps the rays in order; one that is there already replaces its neighbour. Its place. */
static void add_ray(struct plate *p, float angle)
{
    int i = p->count;
    angle = angle < 0 ? angle + TURN : angle;
    while (i > 0 && p->angle[i - 1] > angle + 0.02f)
        i--;
    if (i > 0 && p->angle[i - 1] > angle - 0.02f) {
        p->angle[i - 1] = angle;
        return;
    }
    for (int k = p->count++; k > i; k--)
        p->angle[k] = p->angle[k - 1];
    p->angle[i] = angle;
}

static int ray_at(const struct plate *p, float angle)
{
    int i = 0;
    angle = angle < 0 ? angle + TURN : angle;
    while (i + 1 < p->count && p->angle[i] < angle - 0.001f)
        i++;
    return i;
}

/* How far along a ray a rectangle's side is. */
static float to_rectangle(float angle, float right, float up, float down)
{
    float c = fabsf(cosf(angle)), s = sinf(angle), vertical = s > 0 ? up : down;
    s = fabsf(s);
    return c * vertical > s * right ? right / c : vertical / s;
}

static void begin_rays(struct plate *p)
{
    p->count = 0;
    for (int i = 0; i < ROUND; i++)
        add_ray(p, TURN * (float)i / ROUND);
}

/* Front at z = thickness, back at z = 0; above the hole's middle it is round. */
static bool upright_vertices(struct object *o, const struct bracket *b, struct plate *p)
{
    float right = b->width / 2, down = b->height - b->thickness, r = b->upper_diameter / 2;
    float corner = atan2f(down, right);
    begin_rays(p);
    add_ray(p, PI + corner);
    add_ray(p, TURN - corner);
    p->line_first = ray_at(p, PI + corner);
    p->line_last = ray_at(p, TURN - corner);
    for (int face = 0; face < 2; face++) {
        float z = face == 0 ? b->thickness : 0;
        for (int i = 0; i < p->count; i++) {
            float c = cosf(p->angle[i]), s = sinf(p->angle[i]);
            float far = i <= ROUND / 2 ? right : to_rectangle(p->angle[i], right, right, down);
            bool on_line = i >= p->line_first && i <= p->line_last;
            p->outer[face][i] =
                object_vertex(o, far * c, on_line ? b->thickness : b->height + far * s, z);
            p->inner[face][i] = object_vertex(o, r * c, b->height + r * s, z);
        }
    }
    return o->vertices < OBJECT_VERTICES;
}

/* Top at y = thickness, bottom at y = 0. */
static bool base_vertices(struct object *o, const struct bracket *b, struct plate *p)
{
    float right = b->width / 2, middle = bracket_lower_z(b), r = b->lower_diameter / 2;
    float half = b->depth - middle, corner = atan2f(half, right);
    begin_rays(p);
    add_ray(p, corner);
    add_ray(p, PI - corner);
    add_ray(p, PI + corner);
    add_ray(p, TURN - corner);
    p->line_first = ray_at(p, corner);
    p->line_last = ray_at(p, PI - corner);
    for (int face = 0; face < 2; face++) {
        float y = face == 0 ? b->thickness : 0;
        for (int i = 0; i < p->count; i++) {
            float c = cosf(p->angle[i]), s = sinf(p->angle[i]);
            float far = to_rectangle(p->angle[i], right, half, half);
            p->outer[face][i] = object_vertex(o, far * c, y, middle - far * s);
            p->inner[face][i] = object_vertex(o, r * c, y, middle - r * s);
        }
    }
    return o->vertices < OBJECT_VERTICES;
}

static bool four_corners(struct object *o, int a, int b, int c, int d, int attribute)
{
    int corner[] = {a, b, c, d};
    return object_polygon(o, corner, 4, attribute) >= 0;
}

/* Both faces, the hole's wall, and the walls outside but where the plates meet. */
static bool plate_polygons(struct object *o, const struct plate *p, int attribute)
{
    for (int i = 0; i < p->count; i++) {
        int k = (i + 1) % p->count;
        const int *f = p->outer[0], *b = p->outer[1], *fi = p->inner[0], *bi = p->inner[1];
        if (!four_corners(o, f[i], f[k], fi[k], fi[i], attribute) ||
            !four_corners(o, b[k], b[i], bi[i], bi[k], attribute) ||
            !four_corners(o, fi[i], fi[k], bi[k], bi[i], attribute))
            return false;
        if ((i < p->line_first || i >= p->line_last) &&
            !four_corners(o, f[i], b[i], b[k], f[k], attribute))
            return false;
    }
    return true;
}

/* Vertices of a plate's line in its order, or back. */
static int take_line(const struct plate *p, int face, bool back, int *corner)
{
    int count = p->line_last - p->line_first + 1;
    for (int i = 0; i < count; i++)
        corner[i] = p->outer[face][back ? p->line_last - i : p->line_first + i];
    return count;
}

/* What joins the plates: the strip above, the strip below, the base's back, two sides. */
static bool joint_polygons(struct object *o, const struct bracket *b, const struct plate *up,
                           const struct plate *base, int attribute)
{
    int corner[2 * ANGLES], count;
    int left = object_vertex(o, -b->width / 2, 0, 0), right = object_vertex(o, b->width / 2, 0, 0);
    if (right < 0)
        return false;
    count = take_line(base, 0, true, corner);
    count += take_line(up, 0, true, corner + count);
    if (object_polygon(o, corner, count, attribute) < 0)
        return false;
    corner[0] = left;
    corner[1] = right;
    count = 2 + take_line(base, 1, false, corner + 2);
    if (object_polygon(o, corner, count, attribute) < 0)
        return false;
    corner[0] = right;
    corner[1] = left;
    count = 2 + take_line(up, 1, false, corner + 2);
    if (object_polygon(o, corner, count, attribute) < 0)
        return false;
    int on_left[] = {left, base->outer[1][base->line_last], base->outer[0][base->line_last],
                     up->outer[0][up->line_first], up->outer[1][up->line_first]};
    int on_right[] = {right, up->outer[1][up->line_last], up->outer[0][up->line_last],
                      base->outer[0][base->line_first], base->outer[1][base->line_first]};
    return object_polygon(o, on_left, 5, attribute) >= 0 &&
           object_polygon(o, on_right, 5, attribute) >= 0;
}

bool object_bracket(struct object *o, const struct bracket *b, int attribute)
{
    struct plate up, base;
    return bracket_fits(b) && upright_vertices(o, b, &up) && base_vertices(o, b, &base) &&
           plate_polygons(o, &up, attribute) && plate_polygons(o, &base, attribute) &&
           joint_polygons(o, b, &up, &base, attribute);
}
