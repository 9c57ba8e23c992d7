/* Plots: curves go where the axes say, words never cover each other, hostile input draws or is refused in a sentence. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "crt/png_file.h"
#include "emu/plot/sheet.h"

static uint32_t seed = 1;
static double between(double low, double high)
{
    seed = seed * 1664525u + 1013904223u;
    return low + (high - low) * (seed >> 8) / 16777216.0;
}

static struct vm_words words;

static const uint16_t *pixel(const struct crt_image *image, double x, double y)
{
    return image->samples + 3 * ((size_t)y * (size_t)image->width + (size_t)x);
}

static bool is(const uint16_t *s, struct vm_rgb c)
{
    return s[0] == c.r && s[1] == c.g && s[2] == c.b;
}

static struct vm_plot one(const char *title, enum vm_plot_kind kind, const double *x,
                          const double *y, size_t count)
{
    struct vm_plot plot = {.title = title, .x = {.label = "time, ms"}, .panel_count = 1};
    plot.panel[0].y.label = "luminance, cd/m²";
    plot.panel[0].series[0] =
        (struct vm_plot_series){.kind = kind, .x = x, .y = y, .count = count, .colour = 0};
    plot.panel[0].series_count = 1;
    return plot;
}

static struct crt_image drawn(const struct vm_plot *plot, struct vm_size size,
                              enum vm_plot_style style)
{
    struct crt_image image;
    struct crt_error err;
    if (!vm_plot_draw_words(plot, size, style, &image, &words, &err))
        fail_msg("%s", err.text);
    return image;
}

/* ---- curves ------------------------------------------------------------------------------------------ */

static void a_curve_goes_through_its_points(void **state)
{
    (void)state;
    struct vm_rgb colour = vm_look_of(VM_PLOT_PROJECTOR, vm_plot_size).series[0];
    for (int log = 0; log < 4; log++) {
        double x[5] = {1, 3, 20, 50, 90}, y[5] = {0.02, 70, 5, 5, 0.5};
        struct vm_plot plot = one(NULL, VM_PLOT_LINE, x, y, 5);
        plot.x = (struct vm_plot_axis){"x", log & 1, 1, 100};
        plot.panel[0].y = (struct vm_plot_axis){"y", log & 2, 0.01, 100};
        struct crt_image image = drawn(&plot, vm_plot_size, VM_PLOT_PROJECTOR);
        struct vm_rect p = words.panel[0];
        for (int i = 0; i < 5; i++) {
            double u = log & 1 ? log10(x[i]) / 2 : (x[i] - 1) / 99;
            double v = log & 2 ? (log10(y[i]) + 2) / 4 : (y[i] - 0.01) / 99.99;
            double px = p.x0 + u * (p.x1 - p.x0), py = p.y1 - v * (p.y1 - p.y0);
            assert_true(is(pixel(&image, fmin(px, p.x1 - 1), fmin(py, p.y1 - 1)), colour));
        }
        crt_image_free(&image);
    }
}

static void not_a_number_leaves_a_gap(void **state)
{
    (void)state;
    double x[101], y[101];
    for (int i = 0; i <= 100; i++) {
        x[i] = i;
        y[i] = i > 40 && i < 60 ? (i % 2 ? (double)NAN : (double)INFINITY) : 5;
    }
    struct vm_plot plot = one(NULL, VM_PLOT_LINE, x, y, 101);
    plot.panel[0].y =
        (struct vm_plot_axis){"y", false, 0, 10.1}; /* no line of the grid near 5 + … */
    for (int i = 0; i <= 100; i++)
        y[i] += 0.77;
    struct crt_image image = drawn(&plot, vm_plot_size, VM_PLOT_PAPER);
    struct vm_rect p = words.panel[0];
    double py = p.y1 - 5.77 / 10.1 * (p.y1 - p.y0);
    struct vm_rgb colour = vm_look_of(VM_PLOT_PAPER, vm_plot_size).series[0],
                  white = {255, 255, 255};
    assert_true(is(pixel(&image, p.x0 + 0.35 * (p.x1 - p.x0), py), colour));
    assert_true(is(pixel(&image, p.x0 + 0.47 * (p.x1 - p.x0), py), white));
    assert_true(is(pixel(&image, p.x0 + 0.65 * (p.x1 - p.x0), py), colour));
    crt_image_free(&image);
}

/* Each column shows its samples' least and greatest, by a count that knows nothing of the drawing's. */
static void a_million_samples_show_their_extremes(void **state)
{
    (void)state;
    enum { COUNT = 300000 };
    double *x = malloc(COUNT * sizeof *x), *y = malloc(COUNT * sizeof *y);
    static double low[2000], high[2000];
    assert_true(x && y);
    struct vm_size size = {640, 400};
    struct vm_plot plot = one(NULL, VM_PLOT_LINE, x, y, COUNT);
    plot.x = (struct vm_plot_axis){"x", false, 0, COUNT - 1};
    plot.panel[0].y = (struct vm_plot_axis){"y", false, -1.5, 1.5};
    for (int i = 0; i < COUNT; i++) {
        x[i] = i;
        y[i] = sin(i * 2e-5) + 0.3 * sin(i * 0.7) * cos(i * 3e-4) + (i % 977 == 0 ? 0.2 : 0);
    }
    struct crt_image image = drawn(&plot, size, VM_PLOT_PROJECTOR);
    struct vm_rect p = words.panel[0];
    struct vm_rgb colour = vm_look_of(VM_PLOT_PROJECTOR, size).series[0];
    for (int c = 0; c < 2000; c++) {
        low[c] = 1e9;
        high[c] = -1e9;
    }
    for (int i = 0; i < COUNT; i++) {
        int c = (int)(p.x0 + x[i] / (COUNT - 1) * (p.x1 - p.x0));
        double py = p.y1 - (y[i] + 1.5) / 3 * (p.y1 - p.y0);
        low[c] = fmin(low[c], py);
        high[c] = fmax(high[c], py);
    }
    for (int c = (int)p.x0 + 2; c < (int)p.x1 - 2; c++) {
        int top = -1, bottom = -1;
        for (int r = (int)p.y0; r < (int)p.y1; r++)
            if (is(pixel(&image, c, r), colour)) {
                top = top < 0 ? r : top;
                bottom = r;
            }
        /* Within the pen and its neighbours' pens. */
        double above = fmin(low[c], fmin(low[c - 1], low[c + 1])),
               below = fmax(high[c], fmax(high[c - 1], high[c + 1]));
        assert_true(top >= above - 4 && top <= low[c] + 1.5);
        assert_true(bottom <= below + 4 && bottom >= high[c] - 2.5);
        for (int r = top; r <= bottom; r++)
            assert_true(is(pixel(&image, c, r), colour));
    }
    crt_image_free(&image);
    free(x);
    free(y);
}

static void kinds_differ_as_they_should(void **state)
{
    (void)state;
    double x[3] = {0, 1, 2}, y[3] = {2, 6, 4};
    struct vm_rgb colour = vm_look_of(VM_PLOT_PAPER, vm_plot_size).series[0];
    /* Just left of x = 1: a line is near 6, steps are at 2, an area has ink below, impulses and dots have none. */
    for (enum vm_plot_kind kind = VM_PLOT_LINE; kind <= VM_PLOT_AREA; kind++) {
        struct vm_plot plot = one(NULL, kind, x, y, 3);
        plot.x = (struct vm_plot_axis){"x", false, -0.13, 2.13};
        plot.panel[0].y = (struct vm_plot_axis){"y", false, -0.3, 7.7};
        struct crt_image image = drawn(&plot, vm_plot_size, VM_PLOT_PAPER);
        struct vm_rect p = words.panel[0];
        double px = p.x0 + (0.93 + 0.13) / 2.26 * (p.x1 - p.x0),
               at1 = p.x0 + 1.13 / 2.26 * (p.x1 - p.x0);
        double scale = (p.y1 - p.y0) / 8, y5_72 = p.y1 - 6.02 * scale, y2 = p.y1 - 2.3 * scale,
               y3 = p.y1 - 3.7 * scale;
        assert_int_equal(is(pixel(&image, px, y5_72), colour),
                         kind == VM_PLOT_LINE || kind == VM_PLOT_AREA);
        assert_int_equal(is(pixel(&image, px, y2), colour), kind == VM_PLOT_STEPS);
        assert_int_equal(is(pixel(&image, px, y3), (struct vm_rgb){255, 255, 255}),
                         kind != VM_PLOT_AREA);
        assert_int_equal(is(pixel(&image, at1, y3), colour),
                         kind == VM_PLOT_STEPS || kind == VM_PLOT_IMPULSES);
        assert_true(is(pixel(&image, at1, p.y1 - 6.3 * scale), colour));
        crt_image_free(&image);
    }
}

/* ---- words ------------------------------------------------------------------------------------------- */

static void words_are_apart_and_in_the_picture(int width, int height)
{
    for (int i = 0; i < words.count; i++) {
        struct vm_rect a = words.word[i].box;
        if (a.x0 < -0.5 || a.y0 < -0.5 || a.x1 > width + 0.5 || a.y1 > height + 0.5)
            fail_msg("word of kind %d outside the picture of %dx%d: %.1f,%.1f–%.1f,%.1f",
                     (int)words.word[i].kind, width, height, a.x0, a.y0, a.x1, a.y1);
        for (int k = 0; k < i; k++)
            if (vm_rects_meet(a, words.word[k].box))
                fail_msg("words of kinds %d and %d meet in a picture of %dx%d",
                         (int)words.word[i].kind, (int)words.word[k].kind, width, height);
    }
}

static const char *some(const char *const *of, int count)
{
    return of[(int)between(0, count)];
}

static double some_number(void)
{
    static const double odd[] = {0, -0.0, 1e300, -1e300, DBL_MAX, DBL_MIN, 1e-320, 1, -1};
    double pick = between(0, 1);
    if (pick < 0.1)
        return odd[(int)between(0, 9)];
    if (pick < 0.15)
        return pick < 0.12 ? (double)NAN : (pick < 0.13 ? (double)INFINITY : -(double)INFINITY);
    return between(-1, 1) * pow(10, pick < 0.3 ? between(-300, 300) : between(-3, 3));
}

static double tame(void)
{
    return between(-0.3, 1) * pow(10, between(-2, 2));
}

#define SAMPLES 60
static double xs[VM_PLOT_PANELS * VM_PLOT_SERIES][SAMPLES],
    ys[VM_PLOT_PANELS * VM_PLOT_SERIES][SAMPLES];

/* Hostile or tame numbers; any words, axes, marks. */
static struct vm_plot random_plot(double (*number)(void))
{
    static const char *const titles[] = {
        NULL, "", "Decay", "Luminance of P31 against time at sixty refreshes a second, point probe",
        "\xff\xfe µ 字"};
    static const char *const labels[] = {
        NULL, "", "t, ms", "luminance, cd/m²",
        "share of the light of the whole screen that comes from here, of the mean"};
    struct vm_plot plot = {.title = some(titles, 5), .note = some(titles, 5)};
    plot.x = (struct vm_plot_axis){some(labels, 5), between(0, 1) < 0.3, number(), number()};
    plot.panel_count = 1 + (int)between(0, between(1, VM_PLOT_PANELS));
    for (int p = 0; p < plot.panel_count; p++) {
        struct vm_plot_panel *panel = &plot.panel[p];
        panel->y = (struct vm_plot_axis){some(labels, 5), between(0, 1) < 0.3, number(),
                                         between(0, 1) < 0.5 ? -1e308 : number()};
        panel->series_count = (int)between(0, between(1, VM_PLOT_SERIES + 1));
        panel->mark_count = (int)between(0, between(1, VM_PLOT_MARKS + 1));
        for (int s = 0; s < panel->series_count; s++) {
            double *x = xs[p * VM_PLOT_SERIES + s], *y = ys[p * VM_PLOT_SERIES + s];
            for (int i = 0; i < SAMPLES; i++) {
                x[i] = between(0, 1) < 0.9 ? i : number();
                y[i] = number();
            }
            panel->series[s] = (struct vm_plot_series){some(labels, 5),
                                                       (enum vm_plot_kind)between(0, 5),
                                                       x,
                                                       y,
                                                       (size_t)between(0, SAMPLES + 1),
                                                       (int)between(-1.9, 8),
                                                       between(0, 1) < 0.3};
        }
        for (int m = 0; m < panel->mark_count; m++)
            panel->mark[m] = (struct vm_plot_mark){
                between(0, 1) < 0.6, between(0, 1) < 0.7 ? between(0, SAMPLES) : number(),
                some(labels, 5)};
    }
    return plot;
}

static void any_input_is_drawn_or_refused_and_words_stay_apart(void **state)
{
    (void)state;
    int drawings = 0, refusals = 0;
    for (int i = 0; i < 48; i++) {
        struct vm_plot plot = random_plot(i % 2 ? some_number : tame);
        struct vm_size size = {(int)between(60, 500), (int)between(40, 420)};
        if (i % 16 == 0)
            size = vm_plot_size;
        enum vm_plot_style style = (enum vm_plot_style)(i % 3);
        struct crt_image image;
        struct crt_error err = {""};
        if (!vm_plot_draw_words(&plot, size, style, &image, &words, &err)) {
            int w, h;
            const char *would = strstr(err.text, "read; ");
            assert_true(would || strstr(err.text, "nothing to plot"));
            assert_null(image.samples);
            refusals++;
            if (!would || i % 4)
                continue;
            /* The size it names does. */
            assert_int_equal(sscanf(would, "read; %dx%d would do", &w, &h), 2);
            if (w < size.width || h < size.height)
                fail_msg("%s", err.text);
            if (w * h > 2000000)
                continue;
            size = (struct vm_size){w, h};
            image = drawn(&plot, size, style);
        }
        words_are_apart_and_in_the_picture(size.width, size.height);
        for (size_t k = 0; k < 3u * (size_t)size.width * (size_t)size.height; k++)
            assert_true(image.samples[k] <= 255);
        crt_image_free(&image);
        drawings++;
    }
    assert_true(drawings > 15 && refusals > 8);
}

static void the_same_plot_is_the_same_bytes(void **state)
{
    (void)state;
    struct vm_plot plot = random_plot(tame);
    char first[65], second[65];
    struct crt_image a = drawn(&plot, vm_plot_size, VM_PLOT_PROJECTOR);
    crt_image_hash(&a, first);
    struct crt_image b = drawn(&plot, vm_plot_size, VM_PLOT_PROJECTOR);
    crt_image_hash(&b, second);
    assert_string_equal(first, second);
    crt_image_free(&a);
    crt_image_free(&b);
}

static void letters_are_large_enough_for_the_style(void **state)
{
    (void)state;
    for (int h = 480; h <= 2160; h += 120) {
        struct vm_size size = {h * 16 / 9, h};
        assert_true(vm_look_of(VM_PLOT_PAPER, size).type.size >= h / 45.0);
        assert_true(vm_look_of(VM_PLOT_PROJECTOR, size).type.size >= h / 28.0);
        assert_true(vm_look_of(VM_PLOT_PROJECTOR, size).curve >
                    1.3 * vm_look_of(VM_PLOT_PAPER, size).curve);
    }
}

static void the_legend_covers_no_curve(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        double x[200], y[200], level = between(0, 1), slope = between(-1, 1);
        for (int i = 0; i < 200; i++) {
            x[i] = i;
            y[i] = level + slope * i / 200 + 0.2 * sin(i * between(0.049, 0.05));
        }
        struct vm_plot plot = one("A title", VM_PLOT_LINE, x, y, 200);
        plot.panel[0].series[0].label = "a curve with a label";
        plot.x = (struct vm_plot_axis){"x", false, 0, 199};
        plot.panel[0].y = (struct vm_plot_axis){"y", false, -1, 2};
        struct crt_image image = drawn(&plot, (struct vm_size){500, 300}, VM_PLOT_PAPER);
        struct vm_rect p = words.panel[0];
        int legends = 0;
        for (int k = 0; k < words.count; k++) {
            struct vm_rect box = words.word[k].box;
            if (words.word[k].kind != VM_WORD_LEGEND)
                continue;
            legends++;
            for (int i = 0; i < 200; i++) {
                double px = p.x0 + x[i] / 199 * (p.x1 - p.x0),
                       py = p.y1 - (y[i] + 1) / 3 * (p.y1 - p.y0);
                assert_false(px > box.x0 && px < box.x1 && py > box.y0 && py < box.y1);
            }
        }
        assert_int_equal(legends, 1);
        crt_image_free(&image);
    }
}

static void nothing_to_plot_is_said(void **state)
{
    (void)state;
    struct crt_image image;
    struct crt_error err;
    double nan[2] = {(double)NAN, (double)NAN}, x[2] = {0, 1};
    struct vm_plot plot = one("the probe", VM_PLOT_LINE, x, nan, 2);
    assert_false(vm_plot_draw(&plot, vm_plot_size, VM_PLOT_PAPER, &image, &err));
    assert_non_null(strstr(err.text, "the probe"));
    plot.panel_count = 0;
    assert_false(vm_plot_draw(&plot, vm_plot_size, VM_PLOT_PAPER, &image, &err));
    plot = one("darkness", VM_PLOT_LINE, x, (double[2]){0, 0}, 2); /* is something */
    assert_true(vm_plot_draw(&plot, vm_plot_size, VM_PLOT_SCOPE, &image, &err));
    crt_image_free(&image);
}

/* ---- files ------------------------------------------------------------------------------------------- */

static void a_file_holds_the_picture(void **state)
{
    (void)state;
    char path[] = "/tmp/test_plot_XXXXXX";
    int fd = mkstemp(path);
    assert_true(fd >= 0);
    close(fd);
    double x[2] = {0, 1}, y[2] = {1, 2};
    struct vm_plot plot = one("µ²: a title — in UTF-8", VM_PLOT_LINE, x, y, 2);
    struct crt_image image = drawn(&plot, (struct vm_size){320, 200}, VM_PLOT_PAPER), back;
    struct crt_error err;
    assert_true(vm_plot_write(path, &image, plot.title, &err));
    assert_true(crt_png_read(path, &back, &err));
    assert_int_equal(crt_image_compare(&image, &back, 0).max_difference, 0);
    assert_true(crt_image_compare(&image, &back, 0).same_shape);
    assert_false(vm_plot_write("/nowhere/plot.png", &image, NULL, &err));
    assert_non_null(strstr(err.text, "/nowhere/plot.png"));
    crt_image_free(&image);
    crt_image_free(&back);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_curve_goes_through_its_points),
        cmocka_unit_test(not_a_number_leaves_a_gap),
        cmocka_unit_test(a_million_samples_show_their_extremes),
        cmocka_unit_test(kinds_differ_as_they_should),
        cmocka_unit_test(any_input_is_drawn_or_refused_and_words_stay_apart),
        cmocka_unit_test(the_same_plot_is_the_same_bytes),
        cmocka_unit_test(letters_are_large_enough_for_the_style),
        cmocka_unit_test(the_legend_covers_no_curve),
        cmocka_unit_test(nothing_to_plot_is_said),
        cmocka_unit_test(a_file_holds_the_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
