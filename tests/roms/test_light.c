/* Light (roms/light): illumination against closed forms and against the model in double precision,
 * the series of fast Phong against the terms of Taylor's series and against what it approximates,
 * what the eye makes of steps. */
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

#include "roms/light/mach.c"

enum { WIDTH = 96, HEIGHT = 80 };

/* ---- illumination ---------------------------------------------------------------------------- */

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
        /* By the angles, another form of the equations; and it falls no more than it does for one
         * polarization. */
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
        double brewster = atan(n), refracted = pi / 2 - brewster;
        double s = sin(brewster - refracted);
        assert_true(fabs(fresnel(n, (float)cos(brewster)) - s * s / 2) < 1e-5);
    }
    assert_true(fresnel(1 / 1.5f, 0.5f) == 1); /* total reflection */
    assert_true(fabs(fresnel(1.5f, 1) - 0.04) < 1e-7);
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
    /* What a Lambertian surface sends out of what a far light brings: the mean of max(0, N·L) over
     * the sphere is 1/4. */
    double sum = 0;
    rig.state = 5;
    g = lighting_dark(0);
    lighting_add(&g, (struct light){.kind = LIGHT_FAR, .at = {0, 0, 3}, .intensity = 1});
    for (int i = 0; i < 200000; i++)
        sum += illuminate(&g, &m, (struct vector3){0, 0, 0}, random_direction()).diffuse;
    assert_true(fabs(sum / 200000 - 0.25) < 0.003);
    /* A line of light of many samples nears the integral: ∫ of h²/(h² + x²)^(3/2)·h … over −1…1 at
     * height h. */
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

/* ---- fast Phong ------------------------------------------------------------------------------ */

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

/* T0…T5 of Taylor's series, term by term in double precision. */
static void terms_are_those_of_the_series(void **state)
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

/* ---- Mach bands ------------------------------------------------------------------------------ */

/* A step of height 1 is overdone by the inhibition times the part of the neighbourhood that lies
 * beyond it. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(powers_are_powers),
        cmocka_unit_test(fresnel_has_its_limits),
        cmocka_unit_test(illumination_is_the_models),
        cmocka_unit_test(light_falls_with_distance),
        cmocka_unit_test(series_is_near_the_quotient),
        cmocka_unit_test(terms_are_those_of_the_series),
        cmocka_unit_test(the_eye_overdoes_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
