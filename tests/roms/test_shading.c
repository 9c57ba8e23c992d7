/* Shading (roms/light): the four shadings against one that works pixel by pixel in double precision,
 * triangles that share edges, depth, meshes, and triangles that nobody should draw. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "tests/roms/light_model.h"

enum { WIDTH = 96, HEIGHT = 80, LEVELS = 200 };

static struct {
    uint32_t pixels[WIDTH * HEIGHT];
    float depth[WIDTH * HEIGHT];
    int count[WIDTH * HEIGHT];
    uint32_t colours[256];
} paper;

/* ---- shading --------------------------------------------------------------------------------- */

static struct shade canvas_for(unsigned bits)
{
    struct canvas c = {(uint8_t *)paper.pixels, canvas_pitch(WIDTH, bits), WIDTH, HEIGHT, bits, 1};
    struct depth_buffer d = {paper.depth, WIDTH, HEIGHT};
    memset(paper.pixels, 0, sizeof paper.pixels);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        paper.depth[i] = -1e30f;
    for (uint32_t i = 0; i < 256; i++)
        paper.colours[i] = 0x01000000u + 0x010203u * i;
    return bits == 8 ? shade_begin(&c, &d, 16, LEVELS)
                     : shade_begin_colours(&c, &d, paper.colours, LEVELS);
}

uint32_t canvas_pitch(int width, unsigned bits)
{
    return ((uint32_t)width * bits + 31) / 32 * 4;
}

/* The level of a pixel, or -1: nothing was drawn there. */
static int level_at(const struct shade *s, int x, int y)
{
    if (s->bits == 8) {
        int v = s->pixels[(uint32_t)y * s->pitch + (uint32_t)x];
        return v == 0 ? -1 : v - 16;
    }
    uint32_t v = paper.pixels[y * WIDTH + x];
    return v == 0 ? -1 : (int)((v - 0x01000000u) / 0x010203u);
}

/* Barycentric weights of a pixel; false: outside, or nearer to an edge than rounding can tell. */
static bool weights(const struct shade_vertex *v, double x, double y, double *w)
{
    double area = ((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                  ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y);
    for (int k = 0; k < 3; k++) {
        const struct shade_vertex *p = &v[(k + 1) % 3], *q = &v[(k + 2) % 3];
        double part = ((double)q->x - p->x) * (y - p->y) - ((double)q->y - p->y) * (x - p->x);
        double length = hypot((double)q->x - p->x, (double)q->y - p->y);
        w[k] = part / area;
        if (w[k] < 0 || fabs(part) < 0.002 * length)
            return false;
    }
    return true;
}

static bool outside(const struct shade_vertex *v, double x, double y)
{
    double area = ((double)v[1].x - v[0].x) * ((double)v[2].y - v[0].y) -
                  ((double)v[2].x - v[0].x) * ((double)v[1].y - v[0].y);
    for (int k = 0; k < 3; k++) {
        const struct shade_vertex *p = &v[(k + 1) % 3], *q = &v[(k + 2) % 3];
        double part = ((double)q->x - p->x) * (y - p->y) - ((double)q->y - p->y) * (x - p->x);
        double length = hypot((double)q->x - p->x, (double)q->y - p->y);
        if ((area > 0 ? part : -part) < -0.002 * length)
            return true;
    }
    return false;
}

static double right_intensity(const struct shade *s, enum shading shading,
                              const struct shade_vertex *v, const double *w)
{
    if (shading == SHADE_GOURAUD)
        return v[0].intensity * w[0] + v[1].intensity * w[1] + v[2].intensity * w[2];
    struct d3 place = mix(d3(v[0].place), d3(v[1].place), d3(v[2].place), w);
    struct d3 normal = mix(d3(v[0].normal), d3(v[1].normal), d3(v[2].normal), w);
    return model(s->lighting, s->material, place, normal);
}

static void draw(struct shade *s, enum shading shading, const struct shade_vertex *v)
{
    if (shading == SHADE_FLAT)
        shade_flat(s, v->intensity, &v[0], &v[1], &v[2]);
    else if (shading == SHADE_GOURAUD)
        shade_gouraud(s, &v[0], &v[1], &v[2]);
    else if (shading == SHADE_PHONG)
        shade_phong(s, &v[0], &v[1], &v[2]);
    else
        shade_fast_phong(s, &v[0], &v[1], &v[2]);
}

/* A light so nearly in the surface's plane that a small error lets it appear or go, and its
 * highlight with it. */
static bool at_terminator(const struct shade *s, const struct shade_vertex *v, const double *w)
{
    struct d3 n = unit(mix(d3(v[0].normal), d3(v[1].normal), d3(v[2].normal), w));
    for (int i = 0; i < s->lighting->count; i++)
        if (fabs(dot(n, unit(d3(s->lighting->light[i].at)))) < 0.02)
            return true;
    return false;
}

/* Every pixel inside has the value that the shading defines, within a level and `error`; depths are
 * those of the plane; nothing is drawn outside. The largest error in levels. */
static double compare_triangle(struct shade *s, enum shading shading, const struct shade_vertex *v,
                               double error)
{
    double most = 0;
    draw(s, shading, v);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            double w[3];
            int level = level_at(s, x, y);
            if (weights(v, x, y, w)) {
                double right = right_intensity(s, shading, v, w) * (LEVELS - 1);
                right = fmin(fmax(right, 0), LEVELS - 1);
                assert_int_not_equal(level, -1);
                if (shading == SHADE_FAST_PHONG && at_terminator(s, v, w))
                    continue;
                most = fmax(most, fabs(level - right));
                assert_true(fabs(level - right) <= 0.6 + error * LEVELS);
                double z = v[0].z * w[0] + v[1].z * w[1] + v[2].z * w[2];
                assert_true(fabs(paper.depth[y * WIDTH + x] - z) < 1e-3);
            } else if (outside(v, x, y)) {
                assert_int_equal(level, -1);
            }
        }
    }
    return most;
}

static void gouraud_is_linear(void **state)
{
    (void)state;
    rig.state = 11;
    for (int i = 0; i < 1000; i++) {
        struct shade s = canvas_for(i % 2 ? 8 : 32);
        struct shade_vertex v[3];
        do
            for (int k = 0; k < 3; k++)
                v[k] = random_vertex(-40, 130);
        while (area_of(v) < 100);
        compare_triangle(&s, SHADE_GOURAUD, v, 0.02);
    }
}

static void phong_is_the_light_of_each_pixel(void **state)
{
    (void)state;
    rig.state = 12;
    double most = 0;
    for (int i = 0; i < 600; i++) {
        struct shade s = canvas_for(i % 2 ? 8 : 32);
        struct material m = plain;
        struct lighting g = lighting_dark(0.3f);
        struct shade_vertex v[3];
        m.halfway = i % 3 == 0;
        m.index = i % 5 == 0 ? 1.5f : 0;
        for (int k = i % 4; k > 0; k--)
            lighting_add(&g, random_light(i % 7 == 0 ? LIGHT_NEAR : LIGHT_FAR));
        for (int k = 0; k < g.count; k++)
            g.light[k].intensity *= 0.5f;
        s.lighting = &g, s.material = &m, s.power = &rig.power;
        power_table(&rig.power, m.n);
        do
            for (int k = 0; k < 3; k++)
                v[k] = random_vertex(-20, 110);
        while (area_of(v) < 400);
        spread_normals(v, 1.5);
        most = fmax(most, compare_triangle(&s, SHADE_PHONG, v, 0.01));
    }
    print_message("# Phong: at most %.2f levels of %d from double precision, rounding included\n",
                  most, LEVELS);
}

static void fast_phong_is_near_phong(void **state)
{
    (void)state;
    rig.state = 15;
    double most = 0;
    for (int i = 0; i < 600; i++) {
        struct shade s = canvas_for(i % 2 ? 8 : 32);
        struct material m = plain;
        struct lighting g = lighting_dark(0.3f);
        struct shade_vertex v[3];
        m.halfway = true;
        for (int k = 1 + i % 2; k > 0; k--)
            lighting_add(&g, random_light(LIGHT_FAR));
        for (int k = 0; k < g.count; k++)
            g.light[k].intensity *= 0.5f;
        s.lighting = &g, s.material = &m, s.power = &rig.power;
        power_table(&rig.power, m.n);
        do
            for (int k = 0; k < 3; k++)
                v[k] = random_vertex(-20, 110);
        while (area_of(v) < 400);
        spread_normals(v, 0.3);
        most = fmax(most, compare_triangle(&s, SHADE_FAST_PHONG, v, 0.04));
    }
    print_message("# fast Phong, normals spread by up to 0.3: at most %.2f levels of %d\n", most,
                  LEVELS);
}

/* ---- edges ----------------------------------------------------------------------------------- */

/* A triangulated grid of shaken corners that reaches beyond the canvas: every pixel belongs to one
 * triangle. */
static void shared_edges_share_no_pixel(void **state)
{
    (void)state;
    enum { SIDE = 9 };
    rig.state = 16;
    static const struct shade_vertex nothing;
    for (int round = 0; round < 200; round++) {
        for (enum shading shading = 0; shading < SHADINGS; shading++) {
            struct shade_vertex v[SIDE][SIDE];
            struct lighting g = lighting_dark(0.3f);
            lighting_add(&g, random_light(LIGHT_FAR));
            power_table(&rig.power, plain.n);
            memset(paper.count, 0, sizeof paper.count);
            for (int r = 0; r < SIDE; r++)
                for (int c = 0; c < SIDE; c++) {
                    v[r][c] = nothing;
                    v[r][c].x = (float)(c - 1) * 15 + between(-4, 4);
                    v[r][c].y = (float)(r - 1) * 13 + between(-4, 4);
                    if (round % 4 == 0) { /* corners in middles of pixels: ties */
                        v[r][c].x = floorf(v[r][c].x);
                        v[r][c].y = floorf(v[r][c].y);
                    }
                    v[r][c].normal = random_direction();
                    v[r][c].intensity = between(0, 1);
                }
            for (int k = 0; k < 2 * (SIDE - 1) * (SIDE - 1); k++) {
                int r = k / 2 / (SIDE - 1), c = k / 2 % (SIDE - 1);
                struct shade_vertex t[3] = {v[r][c + 1], v[r + 1][c], v[r][c]};
                if (k % 2)
                    t[2] = v[r + 1][c + 1];
                struct shade s = canvas_for(8);
                s.lighting = &g, s.material = &plain, s.power = &rig.power;
                draw(&s, shading, t);
                uint32_t covered = 0;
                for (int i = 0; i < WIDTH * HEIGHT; i++) {
                    paper.count[i] += paper.depth[i] > -1e29f;
                    covered += paper.depth[i] > -1e29f;
                    assert_true((paper.depth[i] > -1e29f) == (s.pixels[i] != 0));
                    assert_true(s.pixels[i] == 0 ||
                                (s.pixels[i] >= 16 && s.pixels[i] < 16 + LEVELS));
                }
                assert_int_equal(covered, s.covered);
            }
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                assert_int_equal(paper.count[i], 1);
        }
    }
}

/* Whatever the corners are: no pixel outside the ramp, nothing outside the canvas, nothing
 * undefined. */
static void nothing_leaves_the_ramp(void **state)
{
    (void)state;
    rig.state = 17;
    static const float strange[] = {0,        -0.0f, 8192,   -8192, 8193, 1e30f,
                                    INFINITY, NAN,   1e-30f, 40,    40.5f};
    struct lighting g = lighting_dark(0.3f);
    lighting_add(&g, random_light(LIGHT_FAR));
    power_table(&rig.power, plain.n);
    for (int i = 0; i < 40000; i++) {
        struct shade s = canvas_for(8);
        struct shade_vertex v[3];
        s.lighting = &g, s.material = &plain, s.power = &rig.power;
        for (int k = 0; k < 3; k++) {
            v[k] = random_vertex(-20, 110);
            v[k].normal = random_direction();
            if (i % 2)
                continue;
            if (random_unit() < 0.2)
                v[k].x = strange[(int)between(0, 11)];
            if (random_unit() < 0.2)
                v[k].y = strange[(int)between(0, 11)];
        }
        if (i % 2) { /* a sliver */
            float along = between(-0.2, 1.2),
                  off = between(-1, 1) * between(0, 0.5) * between(0, 1);
            v[2].x = v[0].x + (v[1].x - v[0].x) * along + off;
            v[2].y = v[0].y + (v[1].y - v[0].y) * along - off;
            for (int k = 0; k < 3; k++)
                v[k].intensity = random_unit() < 0.5 ? 0 : 1;
        }
        if (i % 10 == 0)
            v[0].intensity = strange[(int)between(0, 11)];
        draw(&s, (enum shading)(i / 2 % SHADINGS), v);
        for (int k = 0; k < WIDTH * HEIGHT; k++)
            assert_true(s.pixels[k] == 0 || (s.pixels[k] >= 16 && s.pixels[k] < 16 + LEVELS));
    }
}

static void nearer_hides_farther(void **state)
{
    (void)state;
    rig.state = 18;
    for (int i = 0; i < 300; i++) {
        struct shade_vertex v[12];
        for (int pass = 0; pass < 2; pass++) {
            static uint8_t kept[WIDTH * HEIGHT];
            struct shade s = canvas_for(8);
            for (int k = 0; k < 12 && pass == 0; k++)
                v[k] = random_vertex(0, 90);
            for (int k = 0; k < 4; k++) {
                int n = pass == 0 ? k : 3 - k;
                shade_flat(&s, (float)n / 4, &v[3 * n], &v[3 * n + 1], &v[3 * n + 2]);
            }
            if (pass == 1)
                assert_memory_equal(kept, s.pixels, sizeof kept);
            memcpy(kept, s.pixels, sizeof kept);
        }
    }
}

/* Of equal depths the first stays, in every shading. */
static void the_first_of_equals_stays(void **state)
{
    (void)state;
    struct lighting g = lighting_dark(0.3f);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {0, 0, 1}, .intensity = 1});
    power_table(&rig.power, plain.n);
    for (enum shading shading = 0; shading < SHADINGS; shading++) {
        static uint8_t kept[WIDTH * HEIGHT];
        struct shade s = canvas_for(8);
        struct shade_vertex v[3] = {{.x = 5, .y = 5}, {.x = 90, .y = 20}, {.x = 30, .y = 75}};
        s.lighting = &g, s.material = &plain, s.power = &rig.power;
        for (int k = 0; k < 3; k++)
            v[k].normal = (struct vector3){0, 0, 1};
        draw(&s, shading, v);
        memcpy(kept, s.pixels, sizeof kept);
        for (int k = 0; k < 3; k++) {
            v[k].intensity = 1;
            v[k].normal = (struct vector3){1, 0, 0};
        }
        draw(&s, shading, v);
        assert_memory_equal(kept, s.pixels, sizeof kept);
    }
}

/* A mesh: mean normals of a finely divided sphere are its radii; the front is what is drawn. */
static void meshes_are_projected(void **state)
{
    (void)state;
    enum { AROUND = 40, RINGS = 20 };
    static struct mesh mesh;
    static struct mesh_view view;
    mesh.vertices = mesh.triangles = 0;
    for (int r = 0; r <= RINGS; r++)
        for (int k = 0; k < AROUND; k++) {
            double p = pi * r / RINGS, q = 2 * pi * k / AROUND;
            mesh.place[mesh.vertices++] = (struct vector3){(float)(sin(p) * cos(q)), (float)cos(p),
                                                           (float)(-sin(p) * sin(q))};
        }
    for (int r = 0; r < RINGS; r++)
        for (int k = 0; k < AROUND; k++) {
            int a = r * AROUND + k, b = r * AROUND + (k + 1) % AROUND;
            uint16_t corners[2][3] = {{(uint16_t)a, (uint16_t)(a + AROUND), (uint16_t)(b + AROUND)},
                                      {(uint16_t)a, (uint16_t)(b + AROUND), (uint16_t)b}};
            memcpy(mesh.corner[mesh.triangles], corners, sizeof corners);
            mesh.triangles += 2;
        }
    for (int i = 0; i < mesh.vertices; i++)
        mesh.normal[i] = mesh.place[i];
    struct lighting g = lighting_dark(0.3f);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {0, 0, 1}, .intensity = 0.6f});
    struct material m = {0.5f, 1, 0, 1, 0, false};
    power_table(&rig.power, 1);
    for (enum shading shading = 0; shading < SHADINGS; shading++) {
        for (int far = 0; far < 2; far++) {
            struct shade s = canvas_for(8);
            s.lighting = &g, s.material = &m, s.power = &rig.power;
            view.model = matrix4_identity();
            view.distance = far ? 0 : 5;
            view.x = 48, view.y = 40, view.dots_x = 30, view.dots_y = 30;
            mesh_project(&mesh, &view);
            mesh_shade(&mesh, &view, &s, shading);
            double radius = far ? 30 : 30 * 5 / sqrt(24), covered = pi * radius * radius;
            assert_true(fabs(s.covered - covered) < 0.03 * covered); /* each pixel once: no backs */
            for (int y = 0; y < HEIGHT; y++)
                for (int x = 0; x < WIDTH && far; x++) {
                    double dx = (x - 48) / 30.0, dy = (y - 40) / 30.0, rr = dx * dx + dy * dy;
                    if (rr > 0.9)
                        continue;
                    double right = (0.15 + 0.6 * sqrt(1 - rr)) * (LEVELS - 1);
                    double limit = shading == SHADE_FLAT ? 25 : 6;
                    assert_true(fabs(level_at(&s, x, y) - right) < limit);
                }
        }
    }
}

static void other_canvases_keep_nothing(void **state)
{
    (void)state;
    struct canvas none = {0}, small = {(uint8_t *)paper.pixels, 100, 100, 50, 8, 1};
    struct depth_buffer d = {paper.depth, WIDTH, HEIGHT};
    struct shade_vertex v[3] = {{.x = 1, .y = 1}, {.x = 40, .y = 5}, {.x = 10, .y = 40}};
    const struct canvas *canvases[] = {&none, &small};
    for (int i = 0; i < 2; i++) {
        canvas_for(8);
        struct shade s = shade_begin(canvases[i], &d, 16, 48);
        struct lighting g = lighting_dark(0.3f);
        s.lighting = &g, s.material = &plain, s.power = &rig.power;
        for (enum shading shading = 0; shading < SHADINGS; shading++)
            draw(&s, shading, v);
        assert_int_equal(s.covered, 0);
    }
}

/* Slopes beyond floats: nothing is drawn but in the row that the edges cross, and within it. */
static void edges_of_denormal_height_are_upright(void **state)
{
    (void)state;
    static const float low[] = {0, -0.0f, -1e-40f, -1e-45f},
                       high[] = {1e-45f, 1e-40f, 1e-38f, 1e-31f};
    struct lighting g = lighting_dark(0.3f);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {0, 0, 1}, .intensity = 0.6f});
    struct material m = {0.5f, 1, 0.3f, 10, 0, false};
    power_table(&rig.power, 10);
    rig.state = 17;
    for (int i = 0; i < 4 * 16 * SHADINGS; i++) {
        struct shade s = canvas_for(i % 2 ? 8 : 32);
        struct shade_vertex v[3];
        s.lighting = &g, s.material = &m, s.power = &rig.power;
        for (int k = 0; k < 3; k++)
            v[k] = random_vertex(0, 60);
        spread_normals(v, 1.5);
        v[0].y = low[i % 4];
        v[1].y = high[i / 4 % 4];
        v[2].y = i / 16 % 4 == 0   ? 40
                 : i / 16 % 4 == 1 ? high[i % 4]
                 : i / 16 % 4 == 2 ? -40
                                   : v[0].y;
        draw(&s, (enum shading)(i / 64), v);
        for (int x = 0; x < WIDTH; x++)
            assert_true(level_at(&s, x, 0) == -1 || (x >= 0 && x <= 60));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gouraud_is_linear),
        cmocka_unit_test(phong_is_the_light_of_each_pixel),
        cmocka_unit_test(fast_phong_is_near_phong),
        cmocka_unit_test(shared_edges_share_no_pixel),
        cmocka_unit_test(nothing_leaves_the_ramp),
        cmocka_unit_test(nearer_hides_farther),
        cmocka_unit_test(the_first_of_equals_stays),
        cmocka_unit_test(meshes_are_projected),
        cmocka_unit_test(other_canvases_keep_nothing),
        cmocka_unit_test(edges_of_denormal_height_are_upright),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
