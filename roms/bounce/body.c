#include <math.h>

#include "roms/bounce/bounce.h"

#define GRAVITY     2.2f
#define FLOOR_SPEED 2.35f /* up, after each bounce from the floor */
#define GOLDEN      1.6180340f

static struct vector scaled(struct vector a, float k)
{
    return (struct vector){a.x * k, a.y * k, a.z * k};
}

static float dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector unit(struct vector a)
{
    return scaled(a, 1.0f / sqrtf(dot(a, a)));
}

static struct vector cross(struct vector a, struct vector b)
{
    return (struct vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

void body_init(struct body *body)
{
    *body = (struct body){
        .place = {-0.45f, -0.1f, -0.2f},
        .velocity = {0.83f, 1.2f, 0.61f},
        .axis = unit((struct vector){0.4f, 1.0f, 0.25f}),
        .turn_rate = 1.9f,
        .row = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    };
}

/* v turned about the axis (Rodrigues' formula). */
static struct vector turned(struct vector v, struct vector axis, float s, float c)
{
    struct vector w = cross(axis, v);
    float along = dot(axis, v) * (1.0f - c);
    return (struct vector){v.x * c + w.x * s + axis.x * along, v.y * c + w.y * s + axis.y * along,
                           v.z * c + w.z * s + axis.z * along};
}

static void turn(struct body *body, float angle)
{
    float s = sinf(angle), c = cosf(angle);
    for (int i = 0; i < 3; i++)
        body->row[i] = turned(body->row[i], body->axis, s, c);
    /* Rounding must not let it shrink or shear. */
    body->row[0] = unit(body->row[0]);
    body->row[2] = unit(cross(body->row[0], body->row[1]));
    body->row[1] = cross(body->row[2], body->row[0]);
}

/* One direction: back from the walls at ±1; true when it hit one. */
static bool reflect(float *place, float *velocity)
{
    float limit = 1.0f - BODY_RADIUS;
    if (fabsf(*place) <= limit || (*place > 0) != (*velocity > 0))
        return false;
    *place = copysignf(2 * limit - fabsf(*place), *place);
    *velocity = -*velocity;
    return true;
}

bool body_move(struct body *body, float dt)
{
    struct vector *p = &body->place, *v = &body->velocity;
    v->y -= GRAVITY * dt;
    p->x += v->x * dt;
    p->y += v->y * dt;
    p->z += v->z * dt;
    bool side = reflect(&p->x, &v->x), depth = reflect(&p->z, &v->z);
    bool height = reflect(&p->y, &v->y);
    if (height && p->y < 0)
        v->y = FLOOR_SPEED;
    turn(body, body->turn_rate * dt);
    if (!side && !depth && !height)
        return false;
    body->bounces++;
    body->axis = unit((struct vector){body->axis.y - 0.3f * v->z, body->axis.z + 0.2f * v->y,
                                      body->axis.x + 0.3f * v->x});
    return true;
}

/* An icosahedron: three golden rectangles across each other. */
void body_corners(const struct body *body, struct vector corners[BODY_VERTICES])
{
    static const float size = 0.52573111f * BODY_RADIUS; /* of the half short side */
    for (int i = 0; i < BODY_VERTICES; i++) {
        float a = i & 1 ? size : -size, b = (i & 2 ? GOLDEN : -GOLDEN) * size;
        struct vector v = i < 4   ? (struct vector){0, a, b}
                          : i < 8 ? (struct vector){a, b, 0}
                                  : (struct vector){b, 0, a};
        corners[i] = (struct vector){body->place.x + dot(body->row[0], v),
                                     body->place.y + dot(body->row[1], v),
                                     body->place.z + dot(body->row[2], v)};
    }
}
