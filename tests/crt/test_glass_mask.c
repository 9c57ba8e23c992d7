/* The glass of colour tubes: films of three colours against crt_develop, and the mask against the one
 * that crt_mask_film draws. With OSMesa and with EGL; where one is missing it says so and is
 * skipped. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/gl_context.h"
#include "crt/glass.h"

static const char *const tubes[] = {"COLOR17", "SLOT14", "GRILLE17"};

struct bench {
    struct crt_gl_context *context;
    struct crt_glass *glass;
};

static struct bench open_bench(void **state)
{
    struct crt_error err = {""};
    struct bench b = {crt_gl_context_create(*(const enum crt_gl_backend *)*state, &err), NULL};
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

static struct crt_film new_film(struct crt_grid grid)
{
    struct crt_film f = {.grid = grid, .colours = 3, .t1 = CRT_PS_PER_S, .complete = true};
    for (int c = 0; c < 3; c++) {
        f.light[c] = calloc((size_t)grid.cols * (size_t)grid.rows, sizeof(float));
        assert_non_null(f.light[c]);
    }
    return f;
}

static void free_film(struct crt_film *f)
{
    for (int c = 0; c < 3; c++)
        free(f->light[c]);
}

/* White of `level` cd/m², the three colours in their shares. */
static void fill_white(struct crt_film *f, double level)
{
    double share[3];
    assert_true(crt_tube_row_find("COLOR17") != NULL);
    const struct crt_phosphor *p = crt_phosphor_find("P22");
    memset(share, 0, sizeof share);
    for (int k = 0; k < p->terms; k++)
        share[p->term[k].colour] += p->term[k].w;
    for (int c = 0; c < 3; c++)
        for (size_t i = 0; i < (size_t)f->grid.cols * (size_t)f->grid.rows; i++)
            f->light[c][i] = (float)(share[c] * level);
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

static double linear(const struct crt_image *image, int x, int y, int channel)
{
    double v =
        image->samples[((size_t)y * (size_t)image->width + (size_t)x) * 3 + (size_t)channel] /
        65535.0;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

/* Mean luminance of a 16-bit picture away from its edge. */
static double mean_luminance(const struct crt_image *image)
{
    double sum = 0;
    int n = 0, edge = image->width / 8;
    for (int y = edge; y < image->height - edge; y++)
        for (int x = edge; x < image->width - edge; x++, n++)
            sum += 0.2126 * linear(image, x, y, 0) + 0.7152 * linear(image, x, y, 1) +
                   0.0722 * linear(image, x, y, 2);
    return sum / n;
}

/* Steps by which two pictures differ at most, away from the edge. */
static int apart(const struct crt_image *a, const struct crt_image *b, int edge)
{
    int worst = 0;
    assert_true(a->width == b->width && a->height == b->height);
    for (int y = edge; y < a->height - edge; y++)
        for (int x = edge; x < a->width - edge; x++)
            for (int k = 0; k < 3; k++) {
                size_t at = ((size_t)y * (size_t)a->width + (size_t)x) * 3 + (size_t)k;
                int d = abs(a->samples[at] - b->samples[at]);
                worst = d > worst ? d : worst;
            }
    return worst;
}

static void three_colours_are_the_developed_picture(void **state)
{
    struct bench b = open_bench(state);
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    struct crt_film film = new_film(crt_grid_closeup(0, 0, 50, 200, 151));
    srand(3);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 200 * 151; i++)
            film.light[c][i] =
                (i / 8 + c) % 4 ? (float)(60 * pow(rand() / (double)RAND_MAX, 2)) : 0;
    const struct crt_glass_settings plain = {.gain = 0.01};
    crt_glass_film(b.glass, &film, p22);
    for (int depth = 8; depth <= 16; depth += 8) {
        struct crt_image developed, glass = render(&b, &plain, 200, 151, depth);
        struct crt_error err;
        assert_true(crt_develop(&film, p22, 0.01, depth, 1, &developed, &err));
        int d = apart(&glass, &developed, 0);
        print_message("# %d bit: at most %d steps apart\n", depth, d);
        assert_in_range(d, 0, depth == 8 ? 1 : 12);
        crt_image_free(&glass);
        crt_image_free(&developed);
    }
    free_film(&film);
    close_bench(&b);
}

/* The second and third colour scatter as a film of one colour does. */
static void halation_of_three_colours(void **state)
{
    struct bench b = open_bench(state);
    const struct crt_glass_settings s = {.gain = 0.01, .halation = 0.2};
    for (int c = 0; c < 3; c++) {
        struct crt_film film = new_film(crt_grid_closeup(0, 0, 80, 160, 120));
        struct crt_phosphor one = {.name = "one", .colours = 1};
        one.colour[0] = crt_phosphor_find("P22")->colour[c];
        for (int i = 0; i < 160 * 120; i++)
            film.light[c][i] = abs(i % 160 - 50) < 5 && abs(i / 160 - 70) < 9 ? 70.0f : 0.0f;
        crt_glass_film(b.glass, &film, crt_phosphor_find("P22"));
        struct crt_image three = render(&b, &s, 160, 120, 16);
        float *light = film.light[0];
        film.light[0] = film.light[c];
        film.colours = 1;
        crt_glass_film(b.glass, &film, &one);
        struct crt_image single = render(&b, &s, 160, 120, 16);
        film.light[0] = light;
        assert_in_range(apart(&three, &single, 0), 0, 2);
        assert_true(linear(&three, 80, 70, c) > 1e-4); /* there is a halo */
        crt_image_free(&three);
        crt_image_free(&single);
        free_film(&film);
    }
    close_bench(&b);
}

/* The field of one gun with the mask in the shader, and with the mask on film, cell for pixel; off by
 * what share of its peak at most. (Where colours mix, the way into sRGB's gamut would add to it.) */
static double off_from_microscope(struct bench *b, int tube, int gun, double pixels_per_pitch)
{
    struct crt_tube_row row = *crt_tube_row_find(tubes[tube]);
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    struct crt_glass_settings s = {.gain = 0.0003};
    struct crt_mask even;
    struct crt_error err;
    double worst = 0, peak = 0, pixel = row.mask_pitch.value / pixels_per_pitch;
    crt_mask_init(&s.mask, &row);
    even = s.mask;
    even.optics.landing = even.optics.landing_edge = 0;
    /* Off the centre; the grille's with a damper wire. */
    double y = tube == 2 ? row.height.value / 6 - 1.3 * pixel : 31.7;
    struct crt_film film = new_film(crt_grid_closeup(-23.1, y, 160 * pixel, 160, 120));
    fill_white(&film, 100);
    for (int c = 0; c < 3; c++)
        if (c != gun)
            memset(film.light[c], 0, 160 * 120 * sizeof(float));
    crt_glass_film(b->glass, &film, p22);
    struct crt_image developed, glass = render(b, &s, 160, 120, 16);
    crt_mask_film(&even, p22, &film, true, NULL);
    assert_true(crt_develop(&film, p22, s.gain, 16, 1, &developed, &err));
    for (int i = 0; i < 158 * 118; i++) {
        int px = 1 + i % 158, py = 1 + i / 158;
        double want = linear(&developed, px, py, gun);
        worst = fmax(worst, fabs(linear(&glass, px, py, gun) - want));
        peak = fmax(peak, want);
    }
    assert_true(peak > 0.01);
    crt_image_free(&glass);
    crt_image_free(&developed);
    free_film(&film);
    return worst / peak;
}

static void the_mask_is_that_of_the_microscope(void **state)
{
    struct bench b = open_bench(state);
    static const double pixels[] = {3.6, 5.3, 11.7, 40}; /* a pitch */
    for (int t = 0; t < 3; t++)
        for (int i = 0; i < 4; i++)
            for (int gun = 0; gun < 3; gun++) {
                double off = off_from_microscope(&b, t, gun, pixels[i]);
                if (off > 0.015) /* straight between texels */
                    fail_msg("%s, gun %d, %g pixels a pitch: off by %.4f of the peak", tubes[t],
                             gun, pixels[i], off);
            }
    close_bench(&b);
}

static void the_mask_keeps_the_light(void **state)
{
    struct bench b = open_bench(state);
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    for (int t = 0; t < 3; t++)
        for (int curved = 0; curved < 2; curved++) {
            const struct crt_tube_row *row = crt_tube_row_find(tubes[t]);
            struct crt_glass_settings plain = {.gain = 0.002, .face_radius_mm = curved ? 60 : 0};
            struct crt_glass_settings masked = plain;
            crt_mask_init(&masked.mask, row);
            struct crt_film film = new_film(crt_grid_closeup(0, 0, 24, 200, 150));
            fill_white(&film, 70);
            crt_glass_film(b.glass, &film, p22);
            const int widths[] = {400, 700};
            for (int i = 0; i < 2; i++) {
                struct crt_image without = render(&b, &plain, widths[i], widths[i] * 3 / 4, 16);
                struct crt_image with = render(&b, &masked, widths[i], widths[i] * 3 / 4, 16);
                double ratio = mean_luminance(&with) / mean_luminance(&without);
                if (fabs(ratio - 1) > 0.01)
                    fail_msg("%s, %d wide: %g of the light", tubes[t], widths[i], ratio);
                assert_true(apart(&with, &without, 50) > 2000); /* and shows */
                crt_image_free(&without);
                crt_image_free(&with);
            }
            free_film(&film);
        }
    close_bench(&b);
}

/* Patterns finer than the pixels would give moiré: they fade and are gone. */
static void fine_masks_fade(void **state)
{
    struct bench b = open_bench(state);
    const struct crt_phosphor *p22 = crt_phosphor_find("P22");
    for (int t = 0; t < 3; t++) {
        struct crt_glass_settings plain = {.gain = 0.002}, masked = plain;
        const struct crt_tube_row *row = crt_tube_row_find(tubes[t]);
        crt_mask_init(&masked.mask, row);
        static const double pixels[] = {1.2, 1.99, 2.6, 3.2};
        double shown = 0, period = row->mask_pitch.value * (t == 0 ? sqrt(0.75) : 1);
        for (int i = 0; i < 4; i++) {
            struct crt_film film =
                new_film(crt_grid_closeup(0, 10, 160 * period / pixels[i], 160, 120));
            fill_white(&film, 100);
            crt_glass_film(b.glass, &film, p22);
            struct crt_image without = render(&b, &plain, 160, 120, 16);
            struct crt_image with = render(&b, &masked, 160, 120, 16);
            int d = apart(&with, &without, 2);
            if (i < 2)
                assert_int_equal(d, 0);
            else
                assert_true(d > shown);
            shown = d;
            crt_image_free(&without);
            crt_image_free(&with);
            free_film(&film);
        }
    }
    close_bench(&b);
}

/* A film of one colour has no mask before it, whatever the settings say. */
static void one_colour_has_no_mask(void **state)
{
    struct bench b = open_bench(state);
    struct crt_glass_settings plain = {.gain = 0.002}, masked = plain;
    crt_mask_init(&masked.mask, crt_tube_row_find("COLOR17"));
    struct crt_film film = new_film(crt_grid_closeup(0, 0, 4, 96, 72));
    fill_white(&film, 100);
    film.colours = 1;
    crt_glass_film(b.glass, &film, crt_phosphor_find("P31"));
    struct crt_image without = render(&b, &plain, 160, 120, 8);
    struct crt_image with = render(&b, &masked, 160, 120, 8);
    assert_int_equal(apart(&with, &without, 0), 0);
    crt_image_free(&without);
    crt_image_free(&with);
    free_film(&film);
    close_bench(&b);
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
        ON_BOTH(three_colours_are_the_developed_picture),
        ON_BOTH(halation_of_three_colours),
        ON_BOTH(the_mask_is_that_of_the_microscope),
        ON_BOTH(the_mask_keeps_the_light),
        ON_BOTH(fine_masks_fade),
        ON_BOTH(one_colour_has_no_mask),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
