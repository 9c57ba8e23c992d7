#include "roms/lessons/flight_view.h"

#include <math.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/flight_camera.h"
#include "roms/raster/polygon_fill.h"

/* ---- sky and ground -------------------------------------------------------------------------- */

int flight_half_plane(const struct point2 *in, int count, float a, float b, float c,
                      struct point2 *out)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        struct point2 p = in[i], q = in[(i + 1) % count];
        float dp = a * p.x + b * p.y - c, dq = a * q.x + b * q.y - c;
        if (dp >= 0)
            out[kept++] = p;
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) {
            float t = dp / (dp - dq);
            out[kept++] = (struct point2){p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
        }
    }
    return kept;
}

/* Bands between slopes above the horizon, from straight down to straight up. */
static const struct {
    float above;
    uint8_t ramp;
    float shade;
} bands[] = {
    {-1e3f, RAMP_GREEN, 0.10f},  {-0.32f, RAMP_GREEN, 0.12f},  {-0.16f, RAMP_GREEN, 0.15f},
    {-0.07f, RAMP_GREEN, 0.18f}, {-0.025f, RAMP_GREEN, 0.22f}, {0, RAMP_BLUE, 0.86f},
    {0.03f, RAMP_BLUE, 0.76f},   {0.09f, RAMP_BLUE, 0.66f},    {0.18f, RAMP_BLUE, 0.56f},
    {0.32f, RAMP_BLUE, 0.46f},
};
enum { BANDS = sizeof bands / sizeof bands[0], HORIZON = 5 };

/* Places of the windscreen, −1…1, as the canvas has them. */
static struct point2 canvas_place(const struct stage *s, struct point2 p)
{
    return (struct point2){stage_canvas_x(s, STAGE_WIDTH / 2 * (1 + p.x)),
                           stage_canvas_y(s, SCREEN_BOTTOM + SCREEN_HEIGHT / 2 * (1 + p.y))};
}

/* The slope of a place's ray is a·x + b·y + ahead.y, about: the rays' lengths hardly differ. */
static void sky_and_ground(const struct flight_camera *c)
{
    struct stage *s = c->stage;
    float a = c->right.y * c->wide, b = c->up.y * c->high, level = c->ahead.y;
    static const struct point2 whole[4] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < BANDS; i++) {
        struct point2 above[8], both[8];
        float top = i + 1 < BANDS ? bands[i + 1].above : 1e3f;
        int count = flight_half_plane(whole, 4, a, b, bands[i].above - level, above);
        count = flight_half_plane(above, count, -a, -b, level - top, both);
        for (int k = 0; k < count; k++)
            both[k] = canvas_place(s, both[k]);
        canvas_polygon(&s->canvas, both, count, POLYGON_EVEN_ODD,
                       ink_shade((enum ink_ramp)bands[i].ramp, bands[i].shade));
    }
}

/* On the vector head. */
static void horizon(const struct flight_camera *c)
{
    enum { FAR = 15000, PIECES = 4 };
    struct vector3 ahead = vector3_direction((struct vector3){c->ahead.x, 0, c->ahead.z});
    struct vector3 side = {-ahead.z, 0, ahead.x};
    struct vector3 middle = vector3_sum(c->eye, vector3_times(ahead, FAR));
    stage_ink(c->stage, INK_GREEN);
    for (int i = -PIECES; i < PIECES; i++)
        flight_camera_line(c, vector3_sum(middle, vector3_times(side, (float)(i * FAR / 2))),
                           vector3_sum(middle, vector3_times(side, (float)((i + 1) * FAR / 2))));
}

/* ---- flat on the ground ---------------------------------------------------------------------- */

struct field {
    float x0, z0, x1, z1;
    uint8_t ramp;
    float shade;
};

static const struct field fields[] = {
    {-420, 100, -120, 520, RAMP_GOLD, 0.20f},    {-800, 60, -450, 560, RAMP_GREEN, 0.24f},
    {140, 180, 520, 640, RAMP_GREEN, 0.26f},     {160, 700, 560, 1150, RAMP_GOLD, 0.16f},
    {-500, 600, -130, 1100, RAMP_GREEN, 0.08f},  {-950, 640, -560, 1200, RAMP_COPPER, 0.16f},
    {600, -600, 1100, 50, RAMP_GREEN, 0.25f},    {-700, -900, -250, -350, RAMP_GREEN, 0.25f},
    {-1150, -800, -760, -200, RAMP_GOLD, 0.18f}, {-600, -1700, -150, -1300, RAMP_COPPER, 0.14f},
    {200, -1900, 700, -1350, RAMP_GREEN, 0.08f}, {-450, 1300, -100, 1900, RAMP_GREEN, 0.25f},
    {150, 1400, 600, 2000, RAMP_GREEN, 0.08f},   {-1500, -2600, -900, -2000, RAMP_GREEN, 0.26f},
};
enum { FIELDS = sizeof fields / sizeof fields[0] };

/* The pilot's height decides how much of what lies flat can be told apart. */
static void rectangle(const struct flight_camera *c, float x0, float z0, float x1, float z1,
                      uint32_t colour)
{
    const struct vector3 corner[4] = {{x0, 0, z0}, {x1, 0, z0}, {x1, 0, z1}, {x0, 0, z1}};
    flight_camera_area(c, corner, 4, colour);
}

/* On the vector head only those that are near: afar they would be one bright line. */
static void draw_fields(const struct flight_camera *c)
{
    enum { OUTLINES_UNTIL = 1600 };
    static const struct vector3 lake[7] = {{700, 0, 300},  {1000, 0, 180}, {1400, 0, 260},
                                           {1600, 0, 520}, {1350, 0, 800}, {950, 0, 760},
                                           {720, 0, 560}};
    for (int i = 0; i < FIELDS; i++) {
        const struct field *f = &fields[i];
        rectangle(c, f->x0, f->z0, f->x1, f->z1, ink_shade((enum ink_ramp)f->ramp, f->shade));
    }
    flight_camera_area(c, lake, 7, ink_shade(RAMP_BLUE, 0.4f));
    stage_heads(c->stage, STAGE_VECTOR);
    stage_ink(c->stage, INK_GRID);
    for (int i = 0; i < FIELDS; i++) {
        const struct field *f = &fields[i];
        const struct vector3 corner[4] = {
            {f->x0, 0, f->z0}, {f->x1, 0, f->z0}, {f->x1, 0, f->z1}, {f->x0, 0, f->z1}};
        if (fabsf(f->x0 - c->eye.x) + fabsf(f->z0 - c->eye.z) < OUTLINES_UNTIL)
            flight_camera_outline(c, corner, 4);
    }
    flight_camera_outline(c, lake, 7);
    stage_heads(c->stage, STAGE_BOTH);
}

static void draw_markings(const struct flight_camera *c)
{
    enum { STRIPE = 30, STRIPES = 8 };
    const uint32_t white = ink_shade(RAMP_GREY, 0.7f);
    for (int z = 60; z < RUNWAY_LENGTH - 60; z += 2 * STRIPE) {
        rectangle(c, -0.6f, -(float)z, 0.6f, -(float)(z + STRIPE), white);
        stage_heads(c->stage, STAGE_VECTOR);
        stage_ink(c->stage, INK_TEXT);
        flight_camera_line(c, (struct vector3){0, 0, -(float)z},
                           (struct vector3){0, 0, -(float)(z + STRIPE)});
        stage_heads(c->stage, STAGE_BOTH);
    }
    for (int i = 0; i < STRIPES; i++) {
        float x = -12.6f + 3.4f * (float)i;
        rectangle(c, x, -6, x + 1.8f, -32, white);
        rectangle(c, x, -RUNWAY_LENGTH + 6, x + 1.8f, -RUNWAY_LENGTH + 32, white);
    }
    rectangle(c, -9, -140, -5, -180, white); /* where to touch down */
    rectangle(c, 5, -140, 9, -180, white);
}

/* From afar only the strip itself can be told from the grass. */
static void draw_runway(const struct flight_camera *c)
{
    enum { MARKINGS_FROM = 2500 };
    const float half = RUNWAY_WIDTH / 2, length = RUNWAY_LENGTH;
    const struct vector3 corner[4] = {
        {-half, 0, 0}, {half, 0, 0}, {half, 0, -length}, {-half, 0, -length}};
    rectangle(c, -half - 12, 60, half + 12, -length - 60, ink_shade(RAMP_GREEN, 0.3f));
    rectangle(c, half, -560, 150, -600, ink_shade(RAMP_GREY, 0.12f)); /* the taxiway */
    flight_camera_area(c, corner, 4, ink_shade(RAMP_GREY, 0.10f));
    if (fabsf(c->eye.z + length / 2) < MARKINGS_FROM)
        draw_markings(c);
    stage_heads(c->stage, STAGE_VECTOR);
    stage_ink(c->stage, INK_BRIGHT);
    flight_camera_outline(c, corner, 4);
    stage_heads(c->stage, STAGE_BOTH);
}

static void draw_lights(const struct flight_camera *c)
{
    enum { APART = 60 };
    const float half = RUNWAY_WIDTH / 2 + 1;
    for (int z = 0; z <= RUNWAY_LENGTH; z += APART) {
        enum ink ink = z == 0 ? INK_GREEN : z == RUNWAY_LENGTH ? INK_RED : INK_YELLOW;
        flight_camera_light(c, (struct vector3){-half, 0.3f, -(float)z}, ink);
        flight_camera_light(c, (struct vector3){half, 0.3f, -(float)z}, ink);
    }
    for (int z = APART; z <= 5 * APART; z += APART)
        for (int side = -1; side <= 1; side++)
            flight_camera_light(c, (struct vector3){4.0f * (float)side, 0.3f, (float)z},
                                INK_BRIGHT);
}

/* Lights of the glide path beside the aiming point: each is white from above its angle, red below.
 * */
static void draw_glide_path(const struct flight_camera *c)
{
    static const float angles[4] = {3.5f, 3.17f, 2.83f, 2.5f};
    for (int i = 0; i < 4; i++) {
        struct vector3 at = {-38 + 5 * (float)i, 0.5f, -150};
        float seen = atan2f(c->eye.y - at.y, c->eye.z - at.z) / DEGREE;
        if (c->eye.z > at.z)
            flight_camera_light(c, at, seen > angles[i] ? INK_BRIGHT : INK_RED);
    }
}

/* ---- what stands up -------------------------------------------------------------------------- */

/* A hill is a pyramid, a building a box. */
struct thing {
    float x, z, wide, deep, high;
    uint8_t ramp;
    bool hill;
};

static const struct thing things[] = {
    {-2600, -4200, 1900, 1500, 420, RAMP_GREEN, true},
    {-900, -5600, 2300, 1600, 560, RAMP_GREY, true},
    {1100, -5200, 2000, 1500, 430, RAMP_GREEN, true},
    {3000, -4300, 2200, 1900, 610, RAMP_GREY, true},
    {4200, -1200, 1900, 2300, 480, RAMP_GREEN, true},
    {3600, 2600, 2000, 1800, 380, RAMP_GREEN, true},
    {-3800, -600, 1700, 2400, 500, RAMP_GREY, true},
    {-3500, 3000, 2000, 2200, 420, RAMP_GREEN, true},
    {700, 5400, 2600, 1500, 520, RAMP_GREEN, true},
    {-1900, 5600, 2000, 1500, 430, RAMP_GREY, true},
    {165, -500, 40, 60, 14, RAMP_COPPER, false},
    {165, -420, 40, 50, 12, RAMP_GREY, false},
    {150, -640, 12, 12, 30, RAMP_GOLD, false},
    {-210, 120, 14, 18, 8, RAMP_COPPER, false},
    {-240, 160, 12, 14, 7, RAMP_GOLD, false},
    {230, 420, 16, 12, 8, RAMP_COPPER, false},
};
enum { THINGS = sizeof things / sizeof things[0] };

/* Corners below, anticlockwise from above, then those above. */
static int corners(const struct thing *t, struct vector3 out[8])
{
    float x = t->wide / 2, z = t->deep / 2;
    const float at[4][2] = {{-x, z}, {x, z}, {x, -z}, {-x, -z}};
    for (int i = 0; i < 4; i++) {
        out[i] = (struct vector3){t->x + at[i][0], 0, t->z + at[i][1]};
        out[i + 4] = out[i];
        out[i + 4].y = t->high;
    }
    if (t->hill)
        out[4] = (struct vector3){t->x, t->high, t->z};
    return t->hill ? 5 : 8;
}

static void draw_face(const struct flight_camera *c, const struct thing *t, const struct vector3 *p,
                      int count)
{
    const struct vector3 light = {-0.6f, 0.6f, 0.53f};
    struct vector3 n = vector3_direction(
        vector3_cross(vector3_difference(p[1], p[0]), vector3_difference(p[2], p[0])));
    if (vector3_dot(n, vector3_difference(c->eye, p[0])) <= 0)
        return;
    float lit = vector3_dot(n, light);
    float shade = (t->hill ? 0.07f : 0.16f) + (lit > 0 ? (t->hill ? 0.16f : 0.3f) * lit : 0);
    flight_camera_area(c, p, count, ink_shade((enum ink_ramp)t->ramp, shade));
    stage_heads(c->stage, STAGE_VECTOR);
    flight_camera_outline(c, p, count);
    stage_heads(c->stage, STAGE_BOTH);
}

static void draw_thing(const struct flight_camera *c, const struct thing *t)
{
    struct vector3 p[8];
    int count = corners(t, p);
    if (!flight_camera_sees(c, p, count))
        return;
    stage_ink(c->stage, t->hill ? INK_BROWN : INK_TEXT);
    for (int i = 0; i < 4; i++) {
        const struct vector3 a = p[i], b = p[(i + 1) % 4];
        const struct vector3 face[4] = {a, b, p[t->hill ? 4 : 4 + (i + 1) % 4], p[4 + i % 4]};
        draw_face(c, t, face, t->hill ? 3 : 4);
    }
    if (count == 8)
        draw_face(c, t, p + 4, 4);
}

/* From far to near. */
static void draw_things(const struct flight_camera *c)
{
    int order[THINGS];
    float away[THINGS];
    for (int i = 0; i < THINGS; i++) {
        float dx = things[i].x - c->eye.x, dz = things[i].z - c->eye.z;
        int k = i;
        away[i] = dx * dx + dz * dz;
        for (; k > 0 && away[order[k - 1]] < away[i]; k--)
            order[k] = order[k - 1];
        order[k] = i;
    }
    for (int i = 0; i < THINGS; i++)
        draw_thing(c, &things[order[i]]);
}

bool flight_view_hit(const struct flight *f)
{
    for (int i = 0; i < THINGS; i++) {
        const struct thing *t = &things[i];
        float x = fabsf(f->at.x - t->x) / (t->wide / 2), z = fabsf(f->at.z - t->z) / (t->deep / 2);
        float side = x > z ? x : z;
        if (side < 1 && f->at.y < t->high * (t->hill ? 1 - side : 1))
            return true;
    }
    return false;
}

void flight_view(struct stage *stage, const struct flight *f)
{
    struct flight_camera c = flight_camera(stage, f);
    sky_and_ground(&c);
    draw_fields(&c);
    draw_runway(&c);
    stage_heads(stage, STAGE_VECTOR);
    horizon(&c);
    stage_heads(stage, STAGE_BOTH);
    draw_lights(&c);
    draw_glide_path(&c);
    draw_things(&c);
}
