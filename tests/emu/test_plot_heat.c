/* Heat maps: colours in order, letters that stand out, words that stay apart, sizes that are refused with one that does. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "emu/plot/sheet.h"

static struct vm_words words;
static struct vm_heat_cell cells[30 * 8];
static const char *const names[30] = {
    "P1",  "P2 and more", "P3",  "P4",  "P5",  "P6",  "P7",  "P8",  "P9",  "P10",
    "P11", "P12",         "P13", "P14", "P15", "P16", "P17", "P18", "P19", "P20",
    "P21", "P22",         "P23", "P24", "P25", "P26", "P27", "P28", "P29", "P30"};

static struct vm_heat table(int rows, int columns)
{
    for (int i = 0; i < rows * columns; i++)
        cells[i] = (struct vm_heat_cell){(double)i / (rows * columns - 1), "55.5 Hz"};
    return (struct vm_heat){.title = "Flicker",
                            .note = "A note",
                            .x_label = "refresh rate, Hz",
                            .y_label = "phosphor",
                            .columns = names,
                            .rows = names,
                            .column_count = columns,
                            .row_count = rows,
                            .cells = cells,
                            .low = "steady",
                            .high = "flickers"};
}

static double light(const uint16_t *s)
{
    double sum = 0;
    static const double share[3] = {0.2126, 0.7152, 0.0722};
    for (int i = 0; i < 3; i++) {
        double v = s[i] / 255.0;
        sum += share[i] * (v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4));
    }
    return sum;
}

static void check_words(const struct crt_image *image)
{
    for (int i = 0; i < words.count; i++) {
        struct vm_rect a = words.word[i].box;
        assert_true(a.x0 >= -0.5 && a.y0 >= -0.5 && a.x1 <= image->width + 0.5 &&
                    a.y1 <= image->height + 0.5);
        for (int k = 0; k < i; k++)
            assert_false(vm_rects_meet(a, words.word[k].box));
    }
}

/* Light only falls from calm to alarming, so that grey print keeps the order; letters have a contrast of 4.5 (WCAG). */
static void colours_are_in_order_and_letters_stand_out(void **state)
{
    (void)state;
    struct vm_heat heat = table(6, 8);
    struct crt_image image;
    struct crt_error err;
    assert_true(vm_heat_draw_words(&heat, vm_plot_size, VM_PLOT_PAPER, &image, &words, &err));
    double before = 2;
    int seen = 0;
    for (int i = 0; i < words.count; i++) {
        struct vm_rect r = words.word[i].box;
        if (words.word[i].kind != VM_WORD_CELL)
            continue;
        seen++;
        double cell = light(image.samples +
                            3 * ((size_t)(r.y0 - 4) * (size_t)image.width + (size_t)r.x0)),
               far = 0;
        assert_true(cell < before);
        before = cell;
        for (int y = (int)r.y0; y < (int)r.y1; y++)
            for (int x = (int)r.x0; x < (int)r.x1; x++) {
                double l = light(image.samples + 3 * ((size_t)y * (size_t)image.width + (size_t)x));
                double contrast = (fmax(l, cell) + 0.05) / (fmin(l, cell) + 0.05);
                far = fmax(far, contrast);
            }
        assert_true(far >= 4.5);
    }
    assert_int_equal(seen, 48);
    check_words(&image);
    crt_image_free(&image);
}

static void many_rows_can_be_read_at_the_usual_size(void **state)
{
    (void)state;
    struct vm_heat heat = table(30, 6);
    for (enum vm_plot_style style = VM_PLOT_PAPER; style <= VM_PLOT_SCOPE; style++) {
        struct crt_image image;
        struct crt_error err;
        assert_true(vm_heat_draw_words(&heat, vm_plot_size, style, &image, &words, &err));
        check_words(&image);
        for (int i = 0; i < words.count; i++) /* figures at least 0.72 of 11 pixels high */
            assert_true(words.word[i].kind != VM_WORD_CELL ||
                        words.word[i].box.y1 - words.word[i].box.y0 >= 7.9);
        crt_image_free(&image);
    }
}

static void too_small_names_a_size_that_does(void **state)
{
    (void)state;
    struct crt_image image;
    struct crt_error err;
    for (int rows = 2; rows <= 30; rows += 7)
        for (int w = 40; w < 500; w += 150) {
            struct vm_heat heat = table(rows, 5);
            if (vm_heat_draw_words(&heat, (struct vm_size){w, w / 2}, VM_PLOT_PAPER, &image, &words,
                                   &err)) {
                check_words(&image);
            } else {
                struct vm_size size;
                const char *would = strstr(err.text, "read; ");
                assert_non_null(would);
                assert_int_equal(sscanf(would, "read; %dx%d", &size.width, &size.height), 2);
                assert_true(vm_heat_draw_words(&heat, size, VM_PLOT_PAPER, &image, &words, &err));
                check_words(&image);
            }
            crt_image_free(&image);
        }
}

static void an_empty_table_is_refused(void **state)
{
    (void)state;
    struct vm_heat heat = table(0, 5);
    struct crt_image image;
    struct crt_error err;
    assert_false(vm_heat_draw(&heat, vm_plot_size, VM_PLOT_PAPER, &image, &err));
    assert_non_null(strstr(err.text, "Flicker"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_are_in_order_and_letters_stand_out),
        cmocka_unit_test(many_rows_can_be_read_at_the_usual_size),
        cmocka_unit_test(too_small_names_a_size_that_does),
        cmocka_unit_test(an_empty_table_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
