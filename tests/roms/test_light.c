/* Light and shading (roms/light): illumination against closed forms in double precision, the four shadings against
 * one that works pixel by pixel in double precision, triangles that share edges, the series of fast Phong against the
 * course's formulas and against what it approximates. The sources are compiled for this machine. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

#include "roms/geometry/matrix4.c"
#include "roms/light/fast_phong.c"
#include "roms/light/flat.c"
#include "roms/light/fresnel.c"
#include "roms/light/gouraud.c"
#include "roms/light/illumination.c"
#include "roms/light/mach.c"
#include "roms/light/mesh.c"
#include "roms/light/phong.c"
#include "roms/light/power.c"
#include "roms/light/shade.c"

enum { WIDTH = 96, HEIGHT = 80, LEVELS = 200 };

static struct {
    uint32_t state;
    uint32_t pixels[WIDTH * HEIGHT];
    float depth[WIDTH * HEIGHT];
    int count[WIDTH * HEIGHT];
    struct power_table power;
    uint32_t colours[256];
} rig;

static double random_unit(void)
{
    rig.state = rig.state * 1664525u + 1013904223u;
    return (rig.state >> 8) / 16777216.0;
}

static float between(double low, double high)
{
    return (float)(low + (high - low) * random_unit());
}

static struct vector3 random_direction(void)
{
    for (;;) {
        struct vector3 v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        float length = vector3_length(v);
        if (length > 0.1f && length <= 1)
            return vector3_times(v, 1 / length);
    }
}

/* ---- in double precision --------------------------------------------------------------------------- */

struct d3 {
    double x, y, z;
};

static struct d3 d3(struct vector3 v)
{
    return (struct d3){v.x, v.y, v.z};
}

static double dot(struct d3 a, struct d3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct d3 unit(struct d3 a)
{
    double k = 1 / sqrt(dot(a, a));
    return (struct d3){a.x * k, a.y * k, a.z * k};
}

static struct d3 mix(struct d3 a, struct d3 b, struct d3 c, const double *w)
{
    return (struct d3){a.x * w[0] + b.x * w[1] + c.x * w[2], a.y * w[0] + b.y * w[1] + c.y * w[2],
                       a.z * w[0] + b.z * w[1] + c.z * w[2]};
}

/* Of a point light in the direction L, as the model says it: angles, cosines, powers. */
static double model_light(const struct material *m, struct d3 n, struct d3 l, struct d3 v,
                          double intensity)
{
    double incidence = dot(n, l);
    if (incidence <= 0)
        return 0;
    double w = m->ks;
    if (m->index >
        0) { /* Fresnel's equations by the angles: sin and tan of their difference and sum */
        double in = acos(fmin(incidence, 1)), out = asin(sin(in) / m->index);
        double s = sin(in - out) / sin(in + out), t = tan(in - out) / tan(in + out);
        w = in < 1e-4 ? pow((m->index - 1) / (m->index + 1), 2) : (s * s + t * t) / 2;
    }
    struct d3 r = {2 * incidence * n.x - l.x, 2 * incidence * n.y - l.y, 2 * incidence * n.z - l.z};
    struct d3 h = unit((struct d3){l.x + v.x, l.y + v.y, l.z + v.z});
    double c = m->halfway ? dot(n, h) : dot(r, v);
    return intensity * (m->kd * incidence + (c > 0 ? w * pow(c, m->n) : 0));
}

static double model(const struct lighting *g, const struct material *m, struct d3 place,
                    struct d3 n)
{
    struct d3 v = d3(g->eye);
    if (!g->eye_far)
        v = unit((struct d3){g->eye.x - place.x, g->eye.y - place.y, g->eye.z - place.z});
    double sum = m->ka * g->ambient;
    n = unit(n);
    for (int i = 0; i < g->count; i++) {
        const struct light *s = &g->light[i];
        if (s->kind == LIGHT_FAR) {
            sum += model_light(m, n, unit(d3(s->at)), v, s->intensity);
            continue;
        }
        int across = s->kind == LIGHT_NEAR ? 1 : s->samples;
        int down = s->kind == LIGHT_RECTANGLE ? s->samples : 1;
        for (int k = 0; k < across * down; k++) {
            double p = 0, q = 0;
            if (s->kind != LIGHT_NEAR)
                p = (k % across + 0.5) / across;
            if (s->kind == LIGHT_RECTANGLE)
                q = (k / across + 0.5) / down;
            struct d3 to = {s->at.x + p * s->side.x + q * s->other.x - place.x,
                            s->at.y + p * s->side.y + q * s->other.y - place.y,
                            s->at.z + p * s->side.z + q * s->other.z - place.z};
            double d = sqrt(dot(to, to));
            double f = fmin(1, 1 / (g->a0 + g->a1 * d + g->a2 * d * d));
            sum += model_light(m, n, unit(to), v, s->intensity * f / (across * down));
        }
    }
    return sum;
}

/* ---- illumination ---------------------------------------------------------------------------------- */

static void powers_are_powers(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        float x = between(0, 1), n = (float)(int)between(256, 256 * 200) / 256;
        double right = pow(x, n);
        assert_true(fabs(power(x, n) - right) <= 2e-5 * right + 1e-37);
    }
    static const float exponents[] = {1, 2, 5.5f, 20, 100, 200};
    for (int k = 0; k < 6; k++) {
        float n = exponents[k];
        power_table(&rig.power, n);
        double most = 0;
        for (int i = 0; i <= 100000; i++)
            most = fmax(
                most, fabs(power_read(&rig.power, (float)i / 100000) - pow((float)i / 100000, n)));
        assert_true(most < (n / POWER_STEPS) * (n / POWER_STEPS) / 8 + 2e-6);
        assert_true(pow(rig.power.low, n) <= 1.0 / 512 &&
                    pow(rig.power.low + 1.001 / POWER_STEPS, n) >= 1.0 / 512);
    }
    assert_true(power(2, 3) == 1 && power(-1, 3) == 0 && power(0.5f, 1) == 0.5f);
}

static void fresnel_has_its_limits(void **state)
{
    (void)state;
    for (float n = 1.05f; n < 4; n += 0.05f) {
        double straight = pow((n - 1) / (n + 1), 2), before = straight;
        assert_true(fabs(fresnel(n, 1) - straight) < 1e-6);
        assert_true(fabs(fresnel_schlick(n, 1) - straight) < 1e-6);
        assert_true(fresnel(n, 0) == 1 && fresnel_schlick(n, 0) == 1);
        /* By the angles, another form of the equations; and it falls no more than it does for one polarization. */
        for (double in = 0.01; in < 1.57; in += 0.01) {
            double out = asin(sin(in) / n);
            double s = sin(in - out) / sin(in + out), t = tan(in - out) / tan(in + out);
            double w = fresnel(n, (float)cos(in));
            assert_true(fabs(w - (s * s + t * t) / 2) < 2e-5);
            if (n > 1.4f && n < 2.2f)
                assert_true(fabs(w - fresnel_schlick(n, (float)cos(in))) < 0.06);
            assert_true(w > 0 && w <= 1 && w >= before - 0.02);
            before = w;
        }
        /* At Brewster's angle only one polarization comes back. */
        double brewster = atan(n), refracted = M_PI / 2 - brewster;
        double s = sin(brewster - refracted);
        assert_true(fabs(fresnel(n, (float)cos(brewster)) - s * s / 2) < 1e-5);
    }
    assert_true(fresnel(1 / 1.5f, 0.5f) == 1); /* total reflection */
    assert_true(fabs(fresnel(1.5f, 1) - 0.04) < 1e-7);
}

static struct material random_material(void)
{
    return (struct material){between(0, 1),
                             between(0, 1),
                             between(0, 1),
                             (float)(int)between(1, 60),
                             random_unit() < 0.3 ? between(1.1, 3) : 0,
                             random_unit() < 0.5};
}

static struct light random_light(enum light_kind kind)
{
    struct light s = {
        .kind = kind, .intensity = between(0.2, 1), .samples = 1 + (int)between(0, 5)};
    s.at = vector3_times(random_direction(), between(2, 8));
    s.side = vector3_times(random_direction(), between(0.1, 1));
    s.other = vector3_times(random_direction(), between(0.1, 1));
    return s;
}

static void illumination_is_the_models(void **state)
{
    (void)state;
    rig.state = 1;
    for (int i = 0; i < 20000; i++) {
        struct lighting g = lighting_dark(between(0, 1));
        struct material m = random_material();
        g.a0 = between(0, 1), g.a1 = between(0, 0.3), g.a2 = between(0, 0.1);
        g.eye = random_direction();
        g.eye_far = random_unit() < 0.5;
        if (!g.eye_far)
            g.eye = vector3_times(g.eye, 6);
        int count = (int)between(0, LIGHTS_MOST + 1);
        for (int k = 0; k < count; k++)
            assert_true(lighting_add(&g, random_light((enum light_kind)between(0, LIGHT_KINDS))));
        struct vector3 place = random_direction();
        struct vector3 normal = vector3_times(random_direction(), between(0.5, 3));
        double right = model(&g, &m, d3(place), d3(normal));
        struct illumination got = illuminate(&g, &m, place, normal);
        assert_true(fabs(illumination_sum(got) - right) < 2e-4);
        /* The terms of the table are those of the sum. */
        double terms = got.ambient;
        for (int k = 0; k < g.count; k++) {
            struct light_term t = illumination_term(&g, &m, place, normal, k);
            assert_true(t.diffuse >= 0 && t.specular >= 0 && t.incidence >= 0 && t.reflection >= 0);
            terms += (double)t.diffuse + (double)t.specular;
        }
        assert_true(fabs(terms - right) < 2e-4);
    }
    struct lighting full = lighting_dark(0);
    for (int k = 0; k < LIGHTS_MOST; k++)
        assert_true(lighting_add(&full, random_light(LIGHT_FAR)));
    assert_false(lighting_add(&full, random_light(LIGHT_FAR)));
}

static void light_falls_with_distance(void **state)
{
    (void)state;
    struct material m = {0, 1, 0, 1, 0, false};
    struct lighting g = lighting_dark(0);
    lighting_add(&g, (struct light){.kind = LIGHT_NEAR, .intensity = 1});
    struct vector3 up = {0, 0, 1};
    g.a0 = 0, g.a1 = 0, g.a2 = 1;
    for (float d = 1; d < 50; d *= 1.1f) { /* the law of squares */
        g.light[0].at = (struct vector3){0, 0, d};
        assert_true(fabs(illuminate(&g, &m, (struct vector3){0, 0, 0}, up).diffuse * d * d - 1) <
                    1e-5);
    }
    g.light[0].at = (struct vector3){0, 0, 0.5f}; /* no more than the light has */
    assert_true(illuminate(&g, &m, (struct vector3){0, 0, 0}, up).diffuse == 1);
    g.light[0].at = (struct vector3){0, 0, 0};
    assert_true(illuminate(&g, &m, (struct vector3){0, 0, 0}, up).diffuse == 1);
    g.light[0].at = (struct vector3){0, 0, -1}; /* behind the surface */
    assert_true(illumination_sum(illuminate(&g, &m, (struct vector3){0, 0, 0}, up)) == 0);
    /* What a Lambertian surface sends out of what a far light brings: the mean of max(0, N·L) over the sphere is 1/4. */
    double sum = 0;
    rig.state = 5;
    g = lighting_dark(0);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {0, 0, 3}, .intensity = 1});
    for (int i = 0; i < 200000; i++)
        sum += illuminate(&g, &m, (struct vector3){0, 0, 0}, random_direction()).diffuse;
    assert_true(fabs(sum / 200000 - 0.25) < 0.003);
    /* A line of light of many samples nears the integral: ∫ of h²/(h² + x²)^(3/2)·h … over −1…1 at height h. */
    g = lighting_dark(0);
    g.a0 = 0, g.a2 = 1;
    lighting_add(&g, (struct light){.kind = LIGHT_LINE,
                                    .at = {-1, 0, 2},
                                    .side = {2, 0, 0},
                                    .samples = 16,
                                    .intensity = 1});
    /* ∫ h / (h² + x²)^(3/2) dx / 2 = (1/h) · 1/√(h² + 1) for x = −1…1 */
    double integral = 1 / (2 * sqrt(5));
    assert_true(fabs(illuminate(&g, &m, (struct vector3){0, 0, 0}, up).diffuse - integral) < 2e-4);
}

/* ---- shading --------------------------------------------------------------------------------------- */

static struct shade canvas_for(unsigned bits)
{
    struct canvas c = {(uint8_t *)rig.pixels, canvas_pitch(WIDTH, bits), WIDTH, HEIGHT, bits, 1};
    struct depth_buffer d = {rig.depth, WIDTH, HEIGHT};
    memset(rig.pixels, 0, sizeof rig.pixels);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        rig.depth[i] = -1e30f;
    for (uint32_t i = 0; i < 256; i++)
        rig.colours[i] = 0x01000000u + 0x010203u * i;
    return bits == 8 ? shade_begin(&c, &d, 16, LEVELS)
                     : shade_begin_colours(&c, &d, rig.colours, LEVELS);
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
    uint32_t v = rig.pixels[y * WIDTH + x];
    return v == 0 ? -1 : (int)((v - 0x01000000u) / 0x010203u);
}

static const struct material plain = {0.3f, 0.5f, 0.2f, 12, 0, false};

static struct shade_vertex random_vertex(float low, float high)
{
    struct shade_vertex v = {.x = between(low, high), .y = between(low, high), .z = between(0, 1)};
    v.place = (struct vector3){v.x / 40, v.y / 40, v.z};
    v.intensity = between(0, 1);
    return v;
}

/* Normals within `spread` of each other, facing the viewer. */
static void spread_normals(struct shade_vertex *v, double spread)
{
    struct vector3 middle = random_direction();
    middle.z = fabsf(middle.z) + 0.3f;
    for (int k = 0; k < 3; k++)
        v[k].normal = vector3_direction(vector3_sum(
            vector3_direction(middle), vector3_times(random_direction(), (float)(spread / 2))));
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

/* A light so nearly in the surface's plane that a small error lets it appear or go, and its highlight with it. */
static bool at_terminator(const struct shade *s, const struct shade_vertex *v, const double *w)
{
    struct d3 n = unit(mix(d3(v[0].normal), d3(v[1].normal), d3(v[2].normal), w));
    for (int i = 0; i < s->lighting->count; i++)
        if (fabs(dot(n, unit(d3(s->lighting->light[i].at)))) < 0.02)
            return true;
    return false;
}

/* Every pixel inside has the value that the shading defines, within a level and `error`; depths are those of the
 * plane; nothing is drawn outside. The largest error in levels. */
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
                assert_true(fabs(rig.depth[y * WIDTH + x] - z) < 1e-3);
            } else if (outside(v, x, y)) {
                assert_int_equal(level, -1);
            }
        }
    }
    return most;
}

static double area_of(const struct shade_vertex *v)
{
    return fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y)) / 2;
}

static double angle(struct vector3 a, struct vector3 b)
{
    return acos(fmin(1, dot(unit(d3(a)), unit(d3(b)))));
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

/* Without rounding to levels: the series against what it approximates. */
static void series_is_near_the_quotient(void **state)
{
    (void)state;
    rig.state = 13;
    double most[16] = {0}, ratio = 0;
    for (int i = 0; i < 10000; i++) {
        struct shade_vertex v[3];
        do
            for (int k = 0; k < 3; k++)
                v[k] = random_vertex(0, 75);
        while (area_of(v) < 50);
        spread_normals(v, 1.5 * random_unit());
        double spread = fmax(fmax(angle(v[0].normal, v[1].normal), angle(v[1].normal, v[2].normal)),
                             angle(v[2].normal, v[0].normal));
        struct triangle t;
        assert_true(triangle_begin(&t, WIDTH, HEIGHT, &v[0], &v[1], &v[2]));
        struct fast_phong_normal n = fast_normal(&t);
        struct vector3 light = random_direction();
        struct fast_phong_series series = fast_phong_series(&n, light);
        double x0 = (v[0].x + v[1].x + v[2].x) / 3, y0 = (v[0].y + v[1].y + v[2].y) / 3;
        for (int k = 0; k < 100; k++) {
            double p = sqrt(random_unit()), q = random_unit();
            double w[3] = {1 - p, p * (1 - q), p * q};
            if (k < 3)
                w[0] = k == 0, w[1] = k == 1, w[2] = k == 2;
            double x = v[0].x * w[0] + v[1].x * w[1] + v[2].x * w[2];
            double y = v[0].y * w[0] + v[1].y * w[1] + v[2].y * w[2];
            double right =
                dot(unit(mix(d3(v[0].normal), d3(v[1].normal), d3(v[2].normal), w)), d3(light));
            double error =
                fabs(fast_phong_value(&series, (float)(x - x0), (float)(y - y0)) - right);
            if (spread < 1.6)
                most[(int)(spread * 10)] = fmax(most[(int)(spread * 10)], error);
            ratio = fmax(ratio, error / (pow(spread, 3) + 1e-5));
            assert_true(error < 0.25 * pow(spread, 3) + 1e-5);
        }
    }
    print_message("# fast Phong: largest error by the normals' spread in tenths of a radian:");
    for (int k = 0; k < 16; k++)
        print_message(" %.4f", most[k]);
    print_message("; %.3f times its third power\n", ratio);
}

/* T0…T5 as the course has them (its errors corrected), term by term in double precision. */
static void terms_are_the_courses(void **state)
{
    (void)state;
    rig.state = 14;
    for (int k = 0; k < 1000; k++) {
        struct vector3 A = vector3_times(random_direction(), 0.05f), C = random_direction();
        struct vector3 B = vector3_times(random_direction(), 0.05f), L = random_direction();
        double a = dot(d3(L), d3(A)), b = dot(d3(L), d3(B)), c = dot(d3(L), d3(C));
        double d = dot(d3(A), d3(A)), e = 2 * dot(d3(A), d3(B)), f = dot(d3(B), d3(B));
        double g = 2 * dot(d3(A), d3(C)), h = 2 * dot(d3(B), d3(C)), i = dot(d3(C), d3(C));
        double t[6] = {c / sqrt(i),
                       b / sqrt(i) - c * h / (2 * pow(i, 1.5)),
                       a / sqrt(i) - c * g / (2 * pow(i, 1.5)),
                       -(b * h + c * f) / (2 * pow(i, 1.5)) + 3 * c * h * h / (8 * pow(i, 2.5)),
                       -(a * h + b * g + c * e) / (2 * pow(i, 1.5)) +
                           3 * c * g * h / (4 * pow(i, 2.5)),
                       -(a * g + c * d) / (2 * pow(i, 1.5)) + 3 * c * g * g / (8 * pow(i, 2.5))};
        struct fast_phong_normal n = fast_phong_normal(A, B, C);
        struct fast_phong_series s = fast_phong_series(&n, L);
        for (int m = 0; m < 6; m++)
            assert_true(fabs(s.t[m] - t[m]) < 2e-6);
    }
    struct vector3 nothing = {0, 0, 0};
    struct fast_phong_normal n = fast_phong_normal(nothing, nothing, nothing);
    struct fast_phong_series s = fast_phong_series(&n, (struct vector3){0, 0, 1});
    for (int m = 0; m < 6; m++)
        assert_true(s.t[m] == 0);
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

/* ---- edges ----------------------------------------------------------------------------------------- */

/* A triangulated grid of shaken corners that reaches beyond the canvas: every pixel belongs to one triangle. */
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
            memset(rig.count, 0, sizeof rig.count);
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
                    rig.count[i] += rig.depth[i] > -1e29f;
                    covered += rig.depth[i] > -1e29f;
                    assert_true((rig.depth[i] > -1e29f) == (s.pixels[i] != 0));
                    assert_true(s.pixels[i] == 0 ||
                                (s.pixels[i] >= 16 && s.pixels[i] < 16 + LEVELS));
                }
                assert_int_equal(covered, s.covered);
            }
            for (int i = 0; i < WIDTH * HEIGHT; i++)
                assert_int_equal(rig.count[i], 1);
        }
    }
}

/* Whatever the corners are: no pixel outside the ramp, nothing outside the canvas, nothing undefined. */
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
        int order[2] = {0, 0};
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
            order[pass] = 1;
        }
        assert_true(order[0] && order[1]);
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
            double p = M_PI * r / RINGS, q = 2 * M_PI * k / AROUND;
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
    mesh_mean_normals(&mesh);
    for (int i = AROUND; i < RINGS * AROUND; i++)
        assert_true(vector3_dot(mesh.normal[i], mesh.place[i]) > 0.999f);
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
            double radius = far ? 30 : 30 * 5 / sqrt(24), covered = M_PI * radius * radius;
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

/* A step of height 1 is overdone by the inhibition times the part of the neighbourhood that lies beyond it. */
static void the_eye_overdoes_steps(void **state)
{
    (void)state;
    enum { COUNT = 200 };
    float step[COUNT], seen[COUNT], even[COUNT], profile[MACH_SAMPLES];
    for (int i = 0; i < COUNT; i++) {
        step[i] = i < COUNT / 2 ? 0 : 1;
        even[i] = 0.7f;
    }
    mach_seen(step, seen, COUNT);
    double over = MACH_INHIBITION * (double)MACH_REACH / (2 * MACH_REACH + 1);
    assert_true(fabs(seen[COUNT / 2] - 1 - over) < 1e-5);
    assert_true(fabs(seen[COUNT / 2 - 1] + over) < 1e-5);
    assert_true(fabsf(seen[COUNT / 2 + MACH_REACH] - 1) < 1e-5f && fabsf(seen[0]) < 1e-5f);
    mach_seen(even, seen, COUNT);
    for (int i = 0; i < COUNT; i++)
        assert_true(fabsf(seen[i] - 0.7f) < 1e-5f);
    for (int facets = 2; facets <= MACH_FACETS; facets++) {
        mach_profile(facets, false, profile, MACH_SAMPLES);
        int steps = 0;
        for (int i = 1; i < MACH_SAMPLES; i++)
            steps += profile[i] != profile[i - 1];
        assert_int_equal(steps, facets - 1);
        for (int k = 0; k < facets; k++) { /* interpolated: no steps */
            float edge = (float)k / (float)facets;
            assert_true(fabsf(mach_intensity(facets, true, edge) -
                              mach_intensity(facets, true, edge + 1e-5f)) < 1e-3f);
        }
    }
}

static void other_canvases_keep_nothing(void **state)
{
    (void)state;
    struct canvas none = {0}, small = {(uint8_t *)rig.pixels, 100, 100, 50, 8, 1};
    struct depth_buffer d = {rig.depth, WIDTH, HEIGHT};
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(powers_are_powers),
        cmocka_unit_test(fresnel_has_its_limits),
        cmocka_unit_test(illumination_is_the_models),
        cmocka_unit_test(light_falls_with_distance),
        cmocka_unit_test(gouraud_is_linear),
        cmocka_unit_test(phong_is_the_light_of_each_pixel),
        cmocka_unit_test(terms_are_the_courses),
        cmocka_unit_test(series_is_near_the_quotient),
        cmocka_unit_test(fast_phong_is_near_phong),
        cmocka_unit_test(shared_edges_share_no_pixel),
        cmocka_unit_test(nothing_leaves_the_ramp),
        cmocka_unit_test(nearer_hides_farther),
        cmocka_unit_test(the_first_of_equals_stays),
        cmocka_unit_test(meshes_are_projected),
        cmocka_unit_test(the_eye_overdoes_steps),
        cmocka_unit_test(other_canvases_keep_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
