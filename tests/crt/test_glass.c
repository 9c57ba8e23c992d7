/* The glass, drawn offscreen, against crt_develop's picture, closed forms and itself on the other
 * GL library. Every test runs with OSMesa and with EGL; where one is missing it says so and is
 * skipped. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/gl_context.h"
#include "crt/glass.h"

#define EXPOSURE_PS UINT64_C(20000000000)
#define EXPOSURE_S  0.02
#define CELL_MM     0.25
#define GAIN        0.01 /* 100 cd/m² is white */

static const struct crt_phosphor white = {
    .name = "white", .colours = 1, .colour = {{0.3127, 0.3290}}};
static const struct crt_phosphor green = {.name = "P31", .colours = 1, .colour = {{0.226, 0.528}}};
static const struct crt_phosphor p7 = {
    .name = "P7", .colours = 2, .colour = {{0.151, 0.032}, {0.357, 0.537}}};

struct bench {
    struct crt_gl_context *context;
    struct crt_glass *glass;
};

static struct bench open_bench(enum crt_gl_backend backend)
{
    struct crt_error err = {""};
    struct bench b = {crt_gl_context_create(backend, &err), NULL};
    if (!b.context) {
        print_message("# SKIP %s\n", err.text);
        skip();
    }
    b.glass = crt_glass_create(crt_gl_context_loader(b.context), &err);
    if (!b.glass)
        fail_msg("%s", err.text);
    return b;
}

static void close_bench(struct bench *b)
{
    crt_glass_destroy(b->glass);
    crt_gl_context_destroy(b->context);
}

static enum crt_gl_backend backend_of(void **state)
{
    return *(const enum crt_gl_backend *)*state;
}

static struct crt_film new_film(int cols, int rows, int colours)
{
    struct crt_film f = {.grid = {cols, rows, CELL_MM, -cols * CELL_MM / 2, rows * CELL_MM / 2},
                         .colours = colours,
                         .t0 = EXPOSURE_PS,
                         .t1 = 2 * EXPOSURE_PS,
                         .complete = true};
    for (int i = 0; i < colours; i++) {
        f.light[i] = calloc((size_t)cols * (size_t)rows, sizeof(float));
        assert_non_null(f.light[i]);
    }
    return f;
}

static void free_film(struct crt_film *f)
{
    for (int i = 0; i < f->colours; i++)
        free(f->light[i]);
}

/* A Gaussian spot of `peak` cd/m² at continuous cell coordinates. */
static void add_spot(struct crt_film *f, int colour, double col, double row, double sigma,
                     double peak)
{
    for (int r = 0; r < f->grid.rows; r++)
        for (int c = 0; c < f->grid.cols; c++) {
            double d = (c - col) * (c - col) + (r - row) * (r - row);
            f->light[colour][(size_t)r * (size_t)f->grid.cols + (size_t)c] +=
                (float)(EXPOSURE_S * peak * exp(-d / (2 * sigma * sigma)));
        }
}

static struct crt_film spots_film(int cols, int rows, int colours)
{
    struct crt_film f = new_film(cols, rows, colours);
    for (int i = 0; i < 24; i++)
        add_spot(&f, i % colours, (i * 37) % cols, (i * 53) % rows, 1 + i * 0.25, 2.0 * i * i);
    return f;
}

static struct crt_image render(struct bench *b, const struct crt_glass_settings *s, int w, int h,
                               int depth)
{
    struct crt_error err = {""};
    struct crt_image image;
    if (!crt_glass_render(b->glass, s, w, h, depth, &image, &err))
        fail_msg("%s", err.text);
    return image;
}

/* Relative luminance of a sample, by the standard's formula. */
static double linear(const struct crt_image *image, int x, int y, int channel)
{
    double max = image->depth == 8 ? 255 : 65535;
    double v =
        image->samples[((size_t)y * (size_t)image->width + (size_t)x) * 3 + (size_t)channel] / max;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static void is_the_developed_picture(void **state)
{
    struct bench b = open_bench(backend_of(state));
    const struct crt_phosphor *phosphors[] = {&white, &green, &p7};
    for (int i = 0; i < 3; i++) {
        struct crt_film film = spots_film(200, 151, phosphors[i]->colours);
        struct crt_image developed;
        struct crt_error err = {""};
        const struct crt_glass_settings plain = {.gain = GAIN};
        crt_glass_film(b.glass, &film, phosphors[i]);
        for (int depth = 8; depth <= 16; depth += 8) {
            struct crt_image glass = render(&b, &plain, 200, 151, depth);
            assert_true(crt_develop(&film, phosphors[i], GAIN, depth, 1, &developed, &err));
            struct crt_image_difference d = crt_image_compare(&glass, &developed, 0);
            print_message("# %s %s %d bit: at most %d steps apart\n",
                          crt_gl_context_name(b.context), phosphors[i]->name, depth,
                          d.max_difference);
            assert_true(d.same_shape);
            assert_in_range(d.max_difference, 0, depth == 8 ? 1 : 8);
            crt_image_free(&glass);
            crt_image_free(&developed);
        }
        free_film(&film);
    }
    close_bench(&b);
}

/* Room light that lies between two steps of 8 bits: any 8 × 8 pixels have it as their mean. */
static void light_between_two_steps_is_dithered(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = new_film(104, 104, 1);
    crt_glass_film(b.glass, &film, &white);
    for (int i = 0; i < 9; i++) {
        /* Linear light of 12.1, 12.2 … 12.9 steps of sRGB, by the standard's formula. */
        double steps = 12.1 + 0.1 * i, light = pow((steps / 255 + 0.055) / 1.055, 2.4);
        const struct crt_glass_settings lit = {.gain = 1, .room_cd_m2 = light};
        struct crt_image image = render(&b, &lit, 104, 104, 8);
        for (int y = 8; y < 96; y += 3)
            for (int x = 8; x < 96; x += 5) {
                double sum = 0;
                for (int k = 0; k < 64; k++) {
                    size_t at = (size_t)(y + k / 8) * 104 + (size_t)(x + k % 8);
                    double v = image.samples[at * 3 + 1];
                    assert_true(fabs(v - steps) < 1);
                    sum += v / 64;
                }
                assert_true(fabs(sum - steps) < 0.03);
            }
        crt_image_free(&image);
    }
    free_film(&film);
    close_bench(&b);
}

/* One cell a pixel in a window that is too large: the same copy, black bars around it. */
static void bars_fill_a_window_of_another_shape(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = spots_film(104, 104, 1);
    const struct crt_glass_settings plain = {.gain = GAIN};
    crt_glass_film(b.glass, &film, &green);
    struct crt_image same = render(&b, &plain, 104, 104, 8);
    struct crt_image wide = render(&b, &plain, 201, 104, 8);
    for (int y = 0; y < 104; y++)
        for (int x = 0; x < 201; x++)
            for (int k = 0; k < 3; k++) {
                int inside = x - 48;
                double want = inside >= 0 && inside < 104 ? linear(&same, inside, y, k) : 0;
                assert_true(linear(&wide, x, y, k) == want);
            }
    struct crt_image tall = render(&b, &plain, 52, 152, 8);
    for (int x = 0; x < 52; x++)
        for (int k = 0; k < 3; k++) {
            assert_true(linear(&tall, x, 49, k) == 0);
            assert_true(linear(&tall, x, 102, k) == 0);
        }
    crt_image_free(&same);
    crt_image_free(&wide);
    crt_image_free(&tall);
    free_film(&film);
    close_bench(&b);
}

static void enlarged_spots_keep_their_shape(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = new_film(64, 64, 1);
    const struct crt_glass_settings plain = {.gain = GAIN};
    add_spot(&film, 0, 20.3, 10.6, 1.0, 70);
    add_spot(&film, 0, 45.0, 50.0, 2.0, 70);
    crt_glass_film(b.glass, &film, &white);
    /* 2240 pixels are more than one tile. */
    struct crt_image image = render(&b, &plain, 2240, 2240, 16);
    double worst[2] = {0, 0}, zoom = 2240 / 64.0;
    for (int y = 0; y < 2240; y += 3)
        for (int x = 0; x < 2240; x += 3) {
            double c = (x + 0.5) / zoom - 0.5, r = (y + 0.5) / zoom - 0.5;
            double d0 = (c - 20.3) * (c - 20.3) + (r - 10.6) * (r - 10.6);
            double d1 = (c - 45) * (c - 45) + (r - 50) * (r - 50);
            double want = 0.7 * exp(-d0 / 2) + 0.7 * exp(-d1 / 8);
            double *w = &worst[r > 32];
            *w = fmax(*w, fabs(linear(&image, x, y, 1) - want) / 0.7);
        }
    print_message("# of the peak: %.4f at sigma 1, %.4f at sigma 2\n", worst[0], worst[1]);
    assert_true(worst[0] < 0.055 && worst[1] < 0.015);
    crt_image_free(&image);
    free_film(&film);
    close_bench(&b);
}

static void reduced_pictures_keep_their_light(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = new_film(256, 256, 1);
    const struct crt_glass_settings plain = {.gain = GAIN};
    add_spot(&film, 0, 99.2, 141.7, 1.0, 70);
    crt_glass_film(b.glass, &film, &white);
    const int sizes[] = {200, 128, 100, 37};
    for (int i = 0; i < 4; i++) {
        int n = sizes[i];
        struct crt_image image = render(&b, &plain, n, n, 16);
        double sum = 0, want = 0.7 * 2 * 3.14159265358979 * n * n / (256.0 * 256.0);
        for (int y = 0; y < n; y++)
            for (int x = 0; x < n; x++)
                sum += linear(&image, x, y, 1);
        print_message("# %d pixels for 256 cells: %.4f of the light\n", n, sum / want);
        assert_true(fabs(sum / want - 1) < 0.02);
        crt_image_free(&image);
    }
    free_film(&film);
    close_bench(&b);
}

/* Twice the light is twice the luminance with every linear pass on (below the shoulder). */
static void is_linear_below_the_shoulder(void **state)
{
    struct bench b = open_bench(backend_of(state));
    const struct crt_glass_settings s = {.gain = GAIN, .halation = 0.1, .face_radius_mm = 90};
    struct crt_film film = new_film(128, 128, 1);
    add_spot(&film, 0, 40, 60, 3, 30);
    add_spot(&film, 0, 90, 20, 2, 20);
    crt_glass_film(b.glass, &film, &white);
    struct crt_image once = render(&b, &s, 150, 150, 16);
    for (size_t i = 0; i < 128 * 128; i++)
        film.light[0][i] *= 2;
    crt_glass_film(b.glass, &film, &white);
    struct crt_image twice = render(&b, &s, 150, 150, 16);
    for (int y = 0; y < 150; y++)
        for (int x = 0; x < 150; x++) {
            double a = linear(&once, x, y, 1), c = linear(&twice, x, y, 1);
            assert_true(fabs(c - 2 * a) < 2e-4);
        }
    crt_image_free(&once);
    crt_image_free(&twice);
    free_film(&film);
    close_bench(&b);
}

static void top_is_top_and_left_is_left(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = new_film(64, 48, 1);
    add_spot(&film, 0, 8, 5, 2, 80);
    crt_glass_film(b.glass, &film, &white);
    const struct crt_glass_settings settings[] = {
        {.gain = GAIN}, {.gain = GAIN, .halation = 0.05, .face_radius_mm = 60, .room_cd_m2 = 1}};
    const int widths[] = {64, 100, 40};
    for (int s = 0; s < 2; s++)
        for (int i = 0; i < 3; i++) {
            int w = widths[i], h = w * 3 / 4, best_x = 0, best_y = 0;
            struct crt_image image = render(&b, &settings[s], w, h, 16);
            for (int y = 0; y < h; y++)
                for (int x = 0; x < w; x++)
                    if (linear(&image, x, y, 1) > linear(&image, best_x, best_y, 1)) {
                        best_x = x;
                        best_y = y;
                    }
            assert_in_range(best_x, w * 7 / 64, w * 11 / 64);
            assert_in_range(best_y, h * 4 / 48, h * 8 / 48);
            crt_image_free(&image);
        }
    free_film(&film);
    close_bench(&b);
}

/* A spot s millimetres from the centre along a sphere of radius R is seen R·sin(s/R) from it. */
static void the_face_is_a_sphere_and_picking_undoes_it(void **state)
{
    struct bench b = open_bench(backend_of(state));
    const double radius = 50, col = 110, row = 100; /* of 128 */
    const struct crt_glass_settings s = {.gain = GAIN, .face_radius_mm = radius};
    struct crt_film film = new_film(128, 128, 1);
    add_spot(&film, 0, col, row, 2, 70);
    crt_glass_film(b.glass, &film, &white);
    struct crt_image image = render(&b, &s, 512, 512, 16);
    double sum = 0, sx = 0, sy = 0;
    for (int y = 0; y < 512; y++)
        for (int x = 0; x < 512; x++) {
            double v = linear(&image, x, y, 1);
            sum += v;
            sx += v * (x + 0.5);
            sy += v * (y + 0.5);
        }
    sx /= sum;
    sy /= sum;
    double mm_x = (col + 0.5 - 64) * CELL_MM, mm_y = (64 - row - 0.5) * CELL_MM;
    double along = hypot(mm_x, mm_y), seen = radius * sin(along / radius) / along;
    double pixels = 4 / CELL_MM; /* a millimetre at the centre */
    assert_true(fabs(sx - (256 + mm_x * seen * pixels)) < 0.3);
    assert_true(fabs(sy - (256 - mm_y * seen * pixels)) < 0.3);
    double x_mm, y_mm;
    assert_true(crt_glass_pick(b.glass, &s, 512, 512, sx, sy, &x_mm, &y_mm));
    assert_true(hypot(x_mm - mm_x, y_mm - mm_y) < 0.02);
    assert_false(crt_glass_pick(b.glass, &s, 600, 512, 5, 256, &x_mm, &y_mm));
    crt_image_free(&image);
    free_film(&film);
    close_bench(&b);
}

/* Scattering moves a share of the light and loses none; its second moment is the ring's. */
static void halation_moves_a_share_of_the_light(void **state)
{
    struct bench b = open_bench(backend_of(state));
    const double share = 0.3;
    const struct crt_glass_settings s = {.gain = GAIN, .halation = share};
    struct crt_film film = new_film(400, 400, 1);
    add_spot(&film, 0, 199.5, 199.5, 12, 70);
    crt_glass_film(b.glass, &film, &white);
    struct crt_image image = render(&b, &s, 400, 400, 16);
    double sum = 0, moment = 0;
    for (int y = 0; y < 400; y++)
        for (int x = 0; x < 400; x++) {
            double v = linear(&image, x, y, 1);
            double dx = (x - 199.5) * CELL_MM, dy = (y - 199.5) * CELL_MM;
            sum += v;
            moment += v * (dx * dx + dy * dy);
        }
    double want = 0.7 * 2 * 3.14159265358979 * 144;
    double spot = 2 * 144 * CELL_MM * CELL_MM; /* mean r² of the spot, mm² */
    double ring = 2 * 8 * tan(asin(1 / 1.52));
    print_message("# %.4f of the light; r² %.2f mm², expected %.2f\n", sum / want, moment / sum,
                  spot + share * ring * ring);
    assert_true(fabs(sum / want - 1) < 0.01);
    assert_true(fabs(moment / sum / (spot + share * ring * ring) - 1) < 0.05);
    crt_image_free(&image);
    free_film(&film);
    close_bench(&b);
}

static void room_light_is_what_was_asked_for(void **state)
{
    struct bench b = open_bench(backend_of(state));
    const struct crt_glass_settings s = {.gain = GAIN, .room_cd_m2 = 5};
    struct crt_film film = new_film(64, 64, 1);
    crt_glass_film(b.glass, &film, &green);
    struct crt_image image = render(&b, &s, 64, 64, 16);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(linear(&image, 10, 50, k) - 0.05) < 1e-4);
    crt_image_free(&image);
    free_film(&film);
    close_bench(&b);
}

static void overlay_lies_on_top_where_it_was_put(void **state)
{
    struct bench b = open_bench(backend_of(state));
    struct crt_film film = spots_film(64, 64, 1);
    const struct crt_glass_settings plain = {.gain = GAIN};
    crt_glass_film(b.glass, &film, &green);
    struct crt_image bare = render(&b, &plain, 64, 64, 8);
    static uint8_t rgba[64 * 64 * 4];
    memset(rgba, 0, sizeof rgba);
    const struct {
        int x, y;
        uint8_t rgba[4];
    } dots[] = {{3, 2, {255, 10, 20, 255}}, {40, 50, {0, 200, 100, 128}}, {63, 63, {9, 8, 7, 255}}};
    for (int i = 0; i < 3; i++)
        memcpy(rgba + (dots[i].y * 64 + dots[i].x) * 4, dots[i].rgba, 4);
    crt_glass_overlay(b.glass, rgba, 64, 64);
    struct crt_image laid = render(&b, &plain, 64, 64, 8);
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++)
            for (int k = 0; k < 3; k++) {
                const uint8_t *o = rgba + (y * 64 + x) * 4;
                int under = bare.samples[(y * 64 + x) * 3 + k];
                double want = (o[k] * o[3] + under * (255 - o[3])) / 255.0;
                assert_true(fabs(laid.samples[(y * 64 + x) * 3 + k] - want) <= 1);
            }
    crt_glass_overlay(b.glass, NULL, 0, 0);
    struct crt_image again = render(&b, &plain, 64, 64, 8);
    assert_int_equal(crt_image_compare(&bare, &again, 0).max_difference, 0);
    crt_image_free(&bare);
    crt_image_free(&laid);
    crt_image_free(&again);
    free_film(&film);
    close_bench(&b);
}

static void both_libraries_agree(void **state)
{
    (void)state;
    const enum crt_gl_backend backends[] = {CRT_GL_OSMESA, CRT_GL_EGL};
    const struct crt_glass_settings full = {
        .gain = GAIN, .room_cd_m2 = 2, .halation = 0.05, .face_radius_mm = 120};
    struct crt_film film = spots_film(160, 120, 2);
    struct crt_image image[2];
    for (int i = 0; i < 2; i++) {
        struct bench b = open_bench(backends[i]);
        crt_glass_film(b.glass, &film, &p7);
        image[i] = render(&b, &full, 333, 250, 8);
        close_bench(&b);
    }
    struct crt_image_difference d = crt_image_compare(&image[0], &image[1], 0);
    print_message("# OSMesa and EGL: at most %d steps apart\n", d.max_difference);
    assert_in_range(d.max_difference, 0, 2);
    crt_image_free(&image[0]);
    crt_image_free(&image[1]);
    free_film(&film);
}

static crt_gl_function finds_nothing(const char *name)
{
    (void)name;
    return NULL;
}

static void a_driver_without_gl_33_is_named(void **state)
{
    (void)state;
    struct crt_error err = {""};
    assert_null(crt_glass_create(finds_nothing, &err));
    assert_non_null(strstr(err.text, "glGetString"));
    assert_non_null(strstr(err.text, "3.3"));
}

int main(void)
{
    static enum crt_gl_backend osmesa = CRT_GL_OSMESA, egl = CRT_GL_EGL;
#define ON_BOTH(f)                                                                                 \
    {"osmesa: " #f, f, NULL, NULL, &osmesa},                                                       \
    {                                                                                              \
        "egl: " #f, f, NULL, NULL, &egl                                                            \
    }
    const struct CMUnitTest tests[] = {
        ON_BOTH(is_the_developed_picture),
        ON_BOTH(light_between_two_steps_is_dithered),
        ON_BOTH(bars_fill_a_window_of_another_shape),
        ON_BOTH(enlarged_spots_keep_their_shape),
        ON_BOTH(reduced_pictures_keep_their_light),
        ON_BOTH(is_linear_below_the_shoulder),
        ON_BOTH(top_is_top_and_left_is_left),
        ON_BOTH(the_face_is_a_sphere_and_picking_undoes_it),
        ON_BOTH(halation_moves_a_share_of_the_light),
        ON_BOTH(room_light_is_what_was_asked_for),
        ON_BOTH(overlay_lies_on_top_where_it_was_put),
        cmocka_unit_test(both_libraries_agree),
        cmocka_unit_test(a_driver_without_gl_33_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
