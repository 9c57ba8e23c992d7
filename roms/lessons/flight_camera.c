#include "roms/lessons/flight_camera.h"

#include <math.h>
#include <stddef.h>

#include "roms/clip/volume.h"
#include "roms/lessons/flight_view.h"
#include "roms/raster/polygon_fill.h"

#define EYE_HEIGHT 2.2f
#define NEAR_PLANE 2.0f
#define FAR_PLANE  20000.0f
#define HALF_WIDE  0.70f /* tan 35 degrees */

/* The directions of the aircraft: nose up by θ, right wing down by μ. */
static void attitude(struct flight_camera *c, const struct flight *f)
{
    float sp = sinf(f->heading), cp = cosf(f->heading), st = sinf(f->pitch), ct = cosf(f->pitch);
    float sb = sinf(f->bank), cb = cosf(f->bank);
    struct vector3 level = {cp, 0, sp}, above = {-sp * st, ct, cp * st};
    c->ahead = (struct vector3){sp * ct, st, -cp * ct};
    c->right = vector3_difference(vector3_times(level, cb), vector3_times(above, sb));
    c->up = vector3_sum(vector3_times(above, cb), vector3_times(level, sb));
}

struct flight_camera flight_camera(struct stage *stage, const struct flight *f)
{
    struct flight_camera c = {.stage = stage,
                              .eye = {f->at.x, f->at.y + EYE_HEIGHT, f->at.z},
                              .wide = HALF_WIDE,
                              .high = HALF_WIDE * SCREEN_HEIGHT / STAGE_WIDTH};
    struct matrix4 volume, view;
    attitude(&c, f);
    const struct vector3 rows[3] = {c.right, c.up, vector3_times(c.ahead, -1)};
    for (int i = 0; i < 3; i++) {
        view.at[i][0] = rows[i].x;
        view.at[i][1] = rows[i].y;
        view.at[i][2] = rows[i].z;
        view.at[i][3] = -vector3_dot(rows[i], c.eye);
        view.at[3][i] = 0;
    }
    view.at[3][3] = 1;
    struct clip_window window = {-c.wide, -c.high, c.wide, c.high};
    volume_perspective((struct vector3){0, 0, 0}, -1, &window, -NEAR_PLANE, -FAR_PLANE, &volume);
    c.matrix = matrix4_product(&volume, &view);
    return c;
}

static struct point2 screen(struct vector4 v)
{
    float h = 1 / v.h;
    return (struct point2){STAGE_WIDTH / 2 * (1 + v.x * h),
                           SCREEN_BOTTOM + SCREEN_HEIGHT / 2 * (1 + v.y * h)};
}

void flight_camera_area(const struct flight_camera *c, const struct vector3 *corners, int count,
                        uint32_t colour)
{
    struct vector4 in[8], out[VOLUME_ROOM];
    struct point2 p[POLYGON_CORNERS];
    for (int i = 0; i < count; i++)
        in[i] = matrix4_homogeneous(&c->matrix, corners[i]);
    count = volume_clip_polygon(in, count, out);
    for (int i = 0; i < count && i < POLYGON_CORNERS; i++) {
        struct point2 at = screen(out[i]);
        p[i] = (struct point2){stage_canvas_x(c->stage, at.x), stage_canvas_y(c->stage, at.y)};
    }
    canvas_polygon(&c->stage->canvas, p, count, POLYGON_EVEN_ODD, colour);
}

/* What is in sight of the line between two places of the view volume. */
static void line(const struct flight_camera *c, struct vector4 from, struct vector4 to)
{
    if (!volume_clip_line(&from, &to, NULL))
        return;
    struct point2 p = screen(from), q = screen(to);
    stage_line(c->stage, p.x, p.y, q.x, q.y);
}

void flight_camera_line(const struct flight_camera *c, struct vector3 a, struct vector3 b)
{
    line(c, matrix4_homogeneous(&c->matrix, a), matrix4_homogeneous(&c->matrix, b));
}

bool flight_camera_sees(const struct flight_camera *c, const struct vector3 *corners, int count)
{
    unsigned all = ~0u;
    for (int i = 0; i < count && all != 0; i++) {
        struct vector4 at = matrix4_homogeneous(&c->matrix, corners[i]);
        all &= volume_code(&at);
    }
    return all == 0;
}

void flight_camera_outline(const struct flight_camera *c, const struct vector3 *corners, int count)
{
    struct vector4 at[8];
    unsigned all = ~0u;
    for (int i = 0; i < count; i++) {
        at[i] = matrix4_homogeneous(&c->matrix, corners[i]);
        all &= volume_code(&at[i]);
    }
    for (int i = 0; i < count && all == 0; i++)
        line(c, at[i], at[(i + 1) % count]);
}

void flight_camera_light(const struct flight_camera *c, struct vector3 at, enum ink ink)
{
    enum { CLOSE = 250 };
    struct vector4 v = matrix4_homogeneous(&c->matrix, at);
    if (volume_code(&v) != 0)
        return;
    struct point2 p = screen(v);
    struct stage *s = c->stage;
    stage_ink(s, ink);
    stage_dot(s, p.x, p.y);
    if (v.h < CLOSE)
        canvas_fill(&s->canvas, (int)stage_canvas_x(s, p.x), (int)stage_canvas_y(s, p.y), 2, 2,
                    ink);
}
