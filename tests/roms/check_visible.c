/* check_visible — properties of solids and visible surfaces, in the machine itself: models against
 * Euler's formula, the guidelines and closed forms; the methods against one another; hidden lines
 * against the depth buffer. One line a property; the exit status is 1 if one does not hold. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/bsp/board.h"
#include "roms/solids/bracket.h"
#include "roms/solids/broken.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"
#include "roms/solids/object_check.h"
#include "roms/visible/depth_surface.h"
#include "roms/visible/hidden_lines.h"
#include "roms/visible/painter.h"
#include "roms/visible/scan_line.h"

enum { WIDTH = 160, HEIGHT = 120, BACKGROUND = 255 };

static struct {
    struct object object;
    struct object_check check;
    struct scene scene;
    struct scan_line scan_line;
    struct painter painter;
    struct hidden_lines hidden;
    _Alignas(4) uint8_t pixels[2][WIDTH * HEIGHT];
    float depth[WIDTH * HEIGHT];
    uint32_t random;
    bool failed;
} rig = {.random = 2026};

static float uniform(float low, float high)
{
    rig.random = rig.random * 1664525u + 1013904223u;
    return low + (high - low) * (float)(rig.random >> 8) / 16777216.0f;
}

static void property(bool holds, const char *text)
{
    printf("%s: %s\n", text, holds ? "yes" : "NO");
    rig.failed = rig.failed || !holds;
}

/* ---- models ---------------------------------------------------------------------------------- */

static float volume(void)
{
    const struct object *o = &rig.object;
    float sum = 0;
    for (int p = 0; p < o->polygons; p++)
        for (int k = 1; k + 1 < o->polygon[p].count; k++)
            sum += vector3_dot(o->vertex[object_corner(o, p, 0)],
                               vector3_cross(o->vertex[object_corner(o, p, k)],
                                             o->vertex[object_corner(o, p, k + 1)]));
    return sum / 6;
}

static bool is_model(bool made, int euler)
{
    struct object_fault fault;
    const struct object *o = &rig.object;
    object_check_begin(&rig.check, o);
    return made && !object_check_next(&rig.check, &fault) &&
           o->vertices - o->edges + o->polygons == euler &&
           object_normals(&rig.object, NORMALS_CREASE);
}

static bool near(float a, float b, float part)
{
    return fabsf(a - b) <= part * fabsf(b);
}

static void check_models(void)
{
    const float pi = 3.14159265f;
    const struct bracket bracket = {60, 62, 70, 12, 28, 24};
    struct object *o = &rig.object;
    object_clear(o);
    property(is_model(object_box(o, 2, 3, 4, 0), 2) && near(volume(), 24, 1e-5f),
             "box 2 3 4: V - E + S = 2, no faults, volume 24");
    object_clear(o);
    property(is_model(object_sphere(o, 1, 36, 24, 0), 2) && near(volume(), 4 * pi / 3, 0.012f),
             "sphere 1 36 24: V - E + S = 2, no faults, volume within 1.2 %");
    object_clear(o);
    property(is_model(object_cylinder(o, 1, 2, 48, 0), 2) && near(volume(), 2 * pi, 0.004f),
             "cylinder 1 2 48: V - E + S = 2, no faults, volume within 0.4 %");
    object_clear(o);
    property(is_model(object_torus(o, 1, 0.4f, 36, 24, 0), 0) &&
                 near(volume(), 2 * pi * pi * 0.16f, 0.017f),
             "torus 1 0.4 36 24: V - E + S = 0, no faults, volume within 1.7 %");
    object_clear(o);
    property(is_model(object_vessel(o, 1, 16, 0), 8), "vessel 16: V - E + S = 8, no faults");
    object_clear(o);
    property(is_model(object_bracket(o, &bracket, 0), -2), "bracket: V - E + S = -2, no faults");
}

static void check_broken(void)
{
    bool right = true;
    for (int i = 0; broken_names[i] != NULL; i++) {
        struct object_fault fault;
        int faults = 0;
        object_broken(&rig.object, i);
        object_check_begin(&rig.check, &rig.object);
        while (object_check_next(&rig.check, &fault)) {
            right = right && (int)fault.rule == i;
            faults++;
        }
        right = right && (faults > 0) == (i < OBJECT_RULES);
    }
    property(right, "broken tables: each fails its own guideline only");
}

/* ---- scenes ---------------------------------------------------------------------------------- */

static struct matrix4 turn_about(int axis, float angle)
{
    struct matrix4 m = matrix4_identity();
    int i = (axis + 1) % 3, k = (axis + 2) % 3;
    m.at[i][i] = m.at[k][k] = cosf(angle);
    m.at[i][k] = -sinf(angle);
    m.at[k][i] = sinf(angle);
    return m;
}

static struct matrix4 random_turn(void)
{
    struct matrix4 x = turn_about(0, uniform(-3, 3)), y = turn_about(1, uniform(-3, 3));
    return matrix4_product(&y, &x);
}

static void add_to_scene(unsigned flags)
{
    struct view view = {random_turn(), 0, 17, WIDTH / 2, HEIGHT / 2, -1};
    view.eye = uniform(0, 1) < 0.5f ? 0 : 12;
    scene_clear(&rig.scene);
    scene_add(&rig.scene, &rig.object, &view, flags, 0);
    for (int i = 0; i < rig.scene.surfaces; i++)
        rig.scene.surface[i].colour = (uint32_t)(i % BACKGROUND);
}

/* Boxes and columns, each within 0.9 of a place of its own, 2 apart. */
static void random_solids(void)
{
    object_clear(&rig.object);
    for (int i = 0; i < 8; i++) {
        int first = rig.object.vertices;
        struct matrix4 m = random_turn();
        if (uniform(0, 1) < 0.5f)
            object_box(&rig.object, 0.9f, uniform(0.3f, 1), 0.8f, 0);
        else
            object_cylinder(&rig.object, uniform(0.2f, 0.6f), 1.2f, 6, 0);
        for (int k = 0; k < 3; k++)
            m.at[k][3] = i >> k & 1 ? 1 : -1;
        object_transform(&rig.object, first, &m);
    }
    add_to_scene(SCENE_CULLED);
}

static void random_piercing(void)
{
    object_clear(&rig.object);
    for (int i = 0; i < 8; i++) {
        int corner[3];
        for (int k = 0; k < 3; k++) {
            float x = uniform(-3, 3), y = uniform(-3, 3);
            corner[k] = object_vertex(&rig.object, x, y, uniform(-3, 3));
        }
        object_polygon(&rig.object, corner, 3, 0);
    }
    add_to_scene(0);
}

/* ---- methods --------------------------------------------------------------------------------- */

static struct canvas canvas_of(int number)
{
    memset(rig.pixels[number], BACKGROUND, sizeof rig.pixels[number]);
    return (struct canvas){rig.pixels[number], WIDTH, WIDTH, HEIGHT, 8, 1.0f};
}

static void draw_by_depth(float far)
{
    struct canvas c = canvas_of(0);
    struct depth_buffer b = {rig.depth, WIDTH, HEIGHT};
    depth_clear(&b, far);
    depth_scene(&c, &b, &rig.scene);
}

static int differences(void)
{
    int count = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        count += rig.pixels[0][i] != rig.pixels[1][i];
    return count;
}

static void check_methods(void)
{
    int scan = 0, paint = 0, circles = 0, pierced = 0;
    for (int i = 0; i < 30; i++) {
        random_solids();
        draw_by_depth(-1e9f);
        struct canvas c = canvas_of(1);
        scan_line_scene(&rig.scan_line, &c, &rig.scene);
        scan += differences();
        c = canvas_of(1);
        painter_scene(&rig.painter, &c, &rig.scene);
        circles += rig.painter.circles;
        paint += differences();
    }
    for (int i = 0; i < 30; i++) {
        random_piercing();
        draw_by_depth(-1e9f);
        struct canvas c = canvas_of(1);
        scan_line_scene(&rig.scan_line, &c, &rig.scene);
        pierced += differences();
    }
    property(scan == 0, "30 scenes of 8 solids: depth buffer and scan line agree in every pixel");
    property(paint == 0 && circles == 0, "30 scenes of 8 solids: painter's agrees in every pixel");
    property(pierced == 0,
             "30 scenes that pierce: depth buffer and scan line agree in every pixel");
}

static void check_zero(void)
{
    bool right = true;
    for (int i = 0; i < 5; i++) {
        random_solids();
        draw_by_depth(-1e9f);
        memcpy(rig.pixels[1], rig.pixels[0], sizeof rig.pixels[0]);
        static float depth[WIDTH * HEIGHT];
        memcpy(depth, rig.depth, sizeof depth);
        draw_by_depth(0);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            right = right && rig.pixels[0][k] == (depth[k] > 0 ? rig.pixels[1][k] : BACKGROUND);
    }
    property(right, "a buffer that begins with 0 hides what has z <= 0, and only that");
}

/* Middles of parts of edges: seen ones are about as near as the buffer says, hidden ones
 * farther. */
static void check_lines(void)
{
    int judged = 0, wrong = 0;
    for (int i = 0; i < 20; i++) {
        random_solids();
        draw_by_depth(-1e9f);
        hidden_begin(&rig.hidden, &rig.scene, EDGES_ALL);
        struct hidden_part p;
        while (hidden_next(&rig.hidden, &p)) {
            if (hypotf(p.b.x - p.a.x, p.b.y - p.a.y) < 3)
                continue;
            struct vector3 m = vector3_times(vector3_sum(p.a, p.b), 0.5f);
            int x = (int)(m.x + 0.5f), y = (int)(m.y + 0.5f), before = 0, behind = 0;
            if (x < 1 || y < 1 || x >= WIDTH - 1 || y >= HEIGHT - 1)
                continue;
            for (int k = 0; k < 9; k++) {
                float z = rig.depth[(y + k / 3 - 1) * WIDTH + x + k % 3 - 1];
                before += z > m.z + 6;
                behind += z < m.z + 2;
            }
            judged += before == 9 || behind == 9;
            wrong += (before == 9 && p.seen) || (behind == 9 && !p.seen);
        }
    }
    property(wrong == 0 && judged > 500,
             "parts of edges: seen and hidden as the depth buffer says");
}

static void check_faces(void)
{
    bool right = true;
    for (int i = 0; i < 200; i++) {
        object_clear(&rig.object);
        object_box(&rig.object, uniform(0.5f, 3), uniform(0.5f, 3), uniform(0.5f, 3), 0);
        add_to_scene(SCENE_CULLED);
        right = right && rig.scene.surfaces >= 1 && rig.scene.surfaces <= 3;
        for (int p = 0; p < 6; p++)
            right = right && plane_of_polygon(&rig.object, p).d < 0;
    }
    property(right, "200 boxes: 1 to 3 faces seen, yet D < 0 for all 6");
}

int main(void)
{
    check_models();
    check_broken();
    check_methods();
    check_zero();
    check_lines();
    check_faces();
    board_exit(rig.failed);
}
