/* check_light — light and shading in the machine: properties on random cases, and speeds. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/bsp/board.h"
#include "roms/bsp/csr.h"
#include "roms/bsp/timer.h"
#include "roms/bsp/video.h"
#include "roms/light/fast_phong.h"
#include "roms/light/fresnel.h"
#include "roms/light/mesh.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"

enum { WIDTH = 96, HEIGHT = 80, LEVELS = 200, FIRST = 16 };

static struct object object;
static struct mesh mesh;
static struct mesh_view view;
static struct power_table table;
static float depth[640 * 480];
static uint32_t pixels[640 * 480 / 4];
static uint8_t count[WIDTH * HEIGHT];
static uint32_t state = 1;

static float between(float low, float high)
{
    state = state * 1664525u + 1013904223u;
    return low + (high - low) * ((float)(state >> 8) / 16777216.0f);
}

static struct vector3 random_direction(void)
{
    struct vector3 v = {between(-1, 1), between(-1, 1), between(-1, 1)};
    return vector3_length(v) > 0.1f ? vector3_direction(v) : (struct vector3){0, 0, 1};
}

static int verdict(bool good, const char *what)
{
    printf("%s: %s\n", what, good ? "yes" : "NO");
    return good ? 0 : 1;
}

/* ---- illumination ---------------------------------------------------------------------------- */

/* By angles, in double precision. */
static double by_angles(const struct material *m, struct vector3 n, struct vector3 l,
                        struct vector3 v)
{
    double nl = (double)n.x * l.x + (double)n.y * l.y + (double)n.z * l.z;
    double nv = (double)n.x * v.x + (double)n.y * v.y + (double)n.z * v.z;
    double lv = (double)l.x * v.x + (double)l.y * v.y + (double)l.z * v.z;
    double rv = 2 * nl * nv - lv;
    if (nl <= 0)
        return 0;
    return m->kd * nl + (rv > 0 ? m->ks * exp(m->n * log(rv)) : 0);
}

static int check_illumination(void)
{
    bool good = true;
    for (int i = 0; i < 300; i++) {
        struct lighting g = lighting_dark(0.5f);
        struct material m = {0.2f, between(0, 1), between(0, 1), (float)(int)between(1, 100),
                             0,    false};
        struct vector3 n = random_direction();
        lighting_add(&g,
                     (struct light){.kind = LIGHT_FAR, .at = random_direction(), .intensity = 1});
        struct illumination got = illuminate(&g, &m, (struct vector3){0, 0, 0}, n);
        double right = 0.1 + by_angles(&m, n, g.light[0].at, g.eye);
        good = good && fabs((double)illumination_sum(got) - right) < 1e-4;
    }
    return verdict(good, "300 points: illumination within 0.0001 of double precision");
}

static int check_fresnel(void)
{
    bool good = true;
    for (float n = 1.05f; n < 4; n += 0.05f) {
        float r = (n - 1) / (n + 1);
        good = good && fabsf(fresnel(n, 1) - r * r) < 1e-6f && fresnel(n, 0) == 1;
    }
    return verdict(good, "59 indices: w is ((n-1)/(n+1))^2 straight on and 1 at 90 degrees");
}

/* ---- shading --------------------------------------------------------------------------------- */

static struct shade canvas_for(const struct lighting *g, const struct material *m)
{
    struct canvas c = {(uint8_t *)pixels, WIDTH, WIDTH, HEIGHT, 8, 1};
    struct depth_buffer d = {depth, WIDTH, HEIGHT};
    struct shade s = shade_begin(&c, &d, FIRST, LEVELS);
    canvas_clear(&c, 0);
    depth_clear(&d, -1e30f);
    s.lighting = g;
    s.material = m;
    s.power = &table;
    return s;
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

static struct shade_vertex random_vertex(void)
{
    struct shade_vertex v = {between(0, WIDTH), between(0, HEIGHT), between(0, 1),
                             {0, 0, 0},         {0, 0, 1},          between(0, 1)};
    return v;
}

static float cross_of(const struct shade_vertex *a, const struct shade_vertex *b, float x, float y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

static int check_gouraud(void)
{
    static const struct material plain = {0, 1, 0, 1, 0, false};
    struct lighting g = lighting_dark(0);
    float most = 0;
    for (int i = 0; i < 60; i++) {
        struct shade s = canvas_for(&g, &plain);
        struct shade_vertex v[3] = {random_vertex(), random_vertex(), random_vertex()};
        float area = cross_of(&v[0], &v[1], v[2].x, v[2].y);
        if (fabsf(area) < 200)
            continue;
        shade_gouraud(&s, &v[0], &v[1], &v[2]);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                if (s.pixels[y * WIDTH + x] == 0)
                    continue;
                float c = cross_of(&v[0], &v[1], (float)x, (float)y) / area;
                float a = cross_of(&v[1], &v[2], (float)x, (float)y) / area;
                float right =
                    a * v[0].intensity + (1 - a - c) * v[1].intensity + c * v[2].intensity;
                float error = (float)s.pixels[y * WIDTH + x] - FIRST - right * (LEVELS - 1);
                most = fmaxf(most, fabsf(error));
            }
        }
    }
    return verdict(most < 0.6f, "60 triangles: Gouraud intensities are linear, within a level");
}

/* Triangles of a shaken grid: each pixel belongs to one. */
static int check_edges(void)
{
    enum { SIDE = 7 };
    static const struct material plain = {0.3f, 0.5f, 0.2f, 12, 0, false};
    bool good = true;
    for (int round = 0; round < 8; round++) {
        struct shade_vertex v[SIDE][SIDE];
        struct lighting g = lighting_dark(0.3f);
        lighting_add(&g,
                     (struct light){.kind = LIGHT_FAR, .at = random_direction(), .intensity = 1});
        power_table(&table, plain.n);
        memset(count, 0, sizeof count);
        for (int k = 0; k < SIDE * SIDE; k++) {
            struct shade_vertex *p = &v[k / SIDE][k % SIDE];
            *p = random_vertex();
            p->x = (float)(k % SIDE - 1) * 24 + between(-6, 6);
            p->y = (float)(k / SIDE - 1) * 20 + between(-6, 6);
            p->normal = random_direction();
        }
        for (int k = 0; k < 2 * (SIDE - 1) * (SIDE - 1); k++) {
            int r = k / 2 / (SIDE - 1), c = k / 2 % (SIDE - 1);
            struct shade_vertex t[3] = {v[r][c + 1], v[r + 1][c],
                                        k % 2 ? v[r + 1][c + 1] : v[r][c]};
            struct shade s = canvas_for(&g, &plain);
            draw(&s, (enum shading)(round % SHADINGS), t);
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                count[i] = (uint8_t)(count[i] + (s.pixels[i] != 0));
        }
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            good = good && count[i] == 1;
    }
    return verdict(good, "8 grids of 72 triangles: each pixel belongs to exactly one");
}

static int check_series(void)
{
    bool good = true;
    for (int i = 0; i < 10000; i++) {
        struct vector3 n[3], middle = random_direction(), light = random_direction();
        float size = between(0, 0.5f), spread = 0;
        for (int k = 0; k < 3; k++)
            n[k] = vector3_direction(vector3_sum(middle, vector3_times(random_direction(), size)));
        for (int k = 0; k < 3; k++)
            spread = fmaxf(spread, vector3_length(vector3_difference(n[k], n[(k + 1) % 3])));
        spread = 2 * asinf(fminf(spread / 2, 1));
        /* Corners (0,0), (1,0), (0,1); the middle is (1/3, 1/3). */
        struct vector3 c = vector3_times(vector3_sum(vector3_sum(n[0], n[1]), n[2]), 1.0f / 3);
        struct fast_phong_normal f =
            fast_phong_normal(vector3_difference(n[1], n[0]), vector3_difference(n[2], n[0]), c);
        struct fast_phong_series s = fast_phong_series(&f, light);
        for (int k = 0; k < 6; k++) {
            float p = k < 3 ? (float)(k == 1) : between(0, 1);
            float q = k < 3 ? (float)(k == 2) : between(0, 1 - p);
            struct vector3 at =
                vector3_sum(n[0], vector3_sum(vector3_times(f.a, p), vector3_times(f.b, q)));
            float right = vector3_dot(light, vector3_direction(at));
            float error = fabsf(fast_phong_value(&s, p - 1.0f / 3, q - 1.0f / 3) - right);
            good = good && error < 0.25f * spread * spread * spread + 1e-5f;
        }
    }
    return verdict(good,
                   "10000 triangles: fast Phong within 0.25 d^3 of Phong, d the normals' spread");
}

/* ---- speed ----------------------------------------------------------------------------------- */

struct frame {
    uint32_t all, shade, covered;
};

static struct frame draw_frame(const struct canvas *c, const struct lighting *g,
                               const struct material *m, enum shading shading, float angle)
{
    struct depth_buffer d = {depth, 640, 480};
    uint32_t start = csr_read_minstret();
    canvas_clear(c, 0);
    depth_clear_part(&d, 100, 20, 440, 440, 0);
    view.model = matrix4_identity();
    view.model.at[0][0] = view.model.at[2][2] = cosf(angle);
    view.model.at[0][2] = sinf(angle);
    view.model.at[2][0] = -sinf(angle);
    mesh_project(&mesh, &view);
    struct shade s = shade_begin(c, &d, FIRST, 48);
    s.lighting = g;
    s.material = m;
    s.power = &table;
    uint32_t placed = csr_read_minstret();
    mesh_shade(&mesh, &view, &s, shading);
    uint32_t end = csr_read_minstret();
    return (struct frame){end - start, end - placed, s.covered};
}

/* A torus of 1024 triangles turns about its height; pages are flipped at retrace. */
static int check_speed(void)
{
    enum { FRAMES = 4 };
    static const float limits[SHADINGS] = {30, 25, 10, 10};
    /* VESA DMT 04h: 640 by 480, 60 Hz. */
    static const struct video_timing vga = {25175000, 640, 656, 752, 800, 480, 490, 492, 525, 0};
    video_set_timing(&vga);
    struct canvas page = video_open(8);
    struct lighting g = lighting_dark(0.2f);
    struct material m = {0.5f, 0.6f, 0.4f, 20, 0, false};
    int bad = 0;
    if (!board_is_knsc() || page.width != 640 || page.height != 480)
        return 0;
    object_clear(&object);
    object_torus(&object, 1, 0.45f, 32, 16, 0);
    object_normals(&object, NORMALS_ROUND);
    mesh_of_object(&mesh, &object);
    power_table(&table, m.n);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {-1, 1, 1.4f}, .intensity = 1});
    view.distance = 6;
    view.x = 320;
    view.y = 240;
    view.dots_x = view.dots_y = 140;
    video_on();
    for (enum shading shading = 0; shading < SHADINGS; shading++) {
        struct frame sum = {0, 0, 0};
        video_wait_retrace();
        uint64_t start = timer_now();
        for (int i = 0; i < FRAMES; i++) {
            struct canvas c = video_page(&page, (unsigned)i % 2);
            struct frame f = draw_frame(&c, &g, &m, shading, 0.3f * (float)i);
            sum.all += f.all, sum.shade += f.shade, sum.covered += f.covered;
            video_show(&c);
            video_wait_retrace();
        }
        double ms = (double)(timer_now() - start) * 1000 / TIMER_HZ / FRAMES;
        double own = (double)sum.all / FRAMES / 50000;
        printf("%-10s %lu pixels, %.1f instructions each; %.2f ms a frame; flipped %.1f a second\n",
               shading_names[shading], (unsigned long)(sum.covered / FRAMES),
               (double)sum.shade / sum.covered, own, 1000 / ms);
        bad += 1000 / own < (double)limits[shading];
    }
    return verdict(bad == 0,
                   "1024 triangles turn at 30 (flat), 25 (Gouraud), 10 (Phong) frames a second");
}

int main(void)
{
    return check_illumination() + check_fresnel() + check_gouraud() + check_edges() +
                       check_series() + check_speed() ==
                   0
               ? 0
               : 1;
}
