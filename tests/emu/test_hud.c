/* Text over the glass: where it lies, when it is drawn again, how it wraps, that letters are the
 * glyphs. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/glyphs.h"
#include "emu/canvas.h"
#include "emu/hud.h"
#include "emu/show.h"

static struct vm_hud *new_hud(void)
{
    struct crt_error err = {""};
    struct vm_hud *hud = vm_hud_create(&err);
    assert_non_null(hud);
    return hud;
}

/* Rows and columns of a picture that are not all transparent. */
static struct vm_box extent(const uint8_t *rgba, int width, int height)
{
    int left = width, right = 0, top = height, bottom = 0;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            if (rgba[((size_t)y * (size_t)width + (size_t)x) * 4 + 3]) {
                left = x < left ? x : left;
                right = x + 1 > right ? x + 1 : right;
                top = y < top ? y : top;
                bottom = y + 1;
            }
    return (struct vm_box){left, top, right - left, bottom - top};
}

static void a_letter_is_its_glyph(void **state)
{
    (void)state;
    struct vm_canvas c = {0};
    assert_true(vm_canvas_resize(&c, 40, 40));
    const struct vm_colour ink = {1, 2, 3, 255};
    vm_canvas_text(&c, 5, 4, 3, ink, "Fg", 2);
    const char *text = "Fg";
    for (int i = 0; i < 2; i++) {
        const struct df_glyph *glyph = df_glyph_ascii((unsigned char)text[i]);
        for (int column = 0; column < 6; column++)
            for (int row = 0; row < 8; row++) {
                int x = 5 + (i * 6 + column) * 3 + 1, y = 4 + row * 3 + 1;
                y += glyph->descends ? 6 : 0;
                const uint8_t *p = c.rgba + (y * 40 + x) * 4;
                assert_int_equal(p[3], glyph->column[column] >> (7 - row) & 1 ? 255 : 0);
            }
    }
    vm_canvas_free(&c);
}

static void text_past_the_edges_is_cut_off(void **state)
{
    (void)state;
    struct vm_canvas c = {0};
    assert_true(vm_canvas_resize(&c, 16, 16));
    const struct vm_colour ink = {9, 9, 9, 255};
    vm_canvas_text(&c, -7, -3, 4, ink, "WWWW", 4);
    vm_canvas_text(&c, 12, 12, 4, ink, "\x7f\xff", 2);
    vm_canvas_fill(&c, (struct vm_box){-100, -100, 50, 50}, ink);
    vm_canvas_free(&c);
}

static void assert_lines(const char *text, size_t columns, size_t max, const char *const *want,
                         size_t count, bool cut)
{
    struct vm_line lines[8];
    assert_int_equal(vm_wrap(text, columns, lines, max), count);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(lines[i].length, strlen(want[i]));
        assert_memory_equal(lines[i].text, want[i], lines[i].length);
        assert_int_equal(lines[i].cut, cut && i + 1 == count);
    }
}

static void text_wraps_between_words(void **state)
{
    (void)state;
    const char *const plain[] = {"one two", "three"};
    assert_lines("one two three", 8, 8, plain, 2, false);
    assert_lines("one two  three", 7, 8, plain, 2, false);
    const char *const broken[] = {"a", "", "b"};
    assert_lines("a\n\nb", 8, 8, broken, 3, false);
    const char *const hard[] = {"abcdefgh", "ij"};
    assert_lines("abcdefghij", 8, 8, hard, 2, false);
    const char *const shortened[] = {"one two", "three"};
    assert_lines("one two three four", 8, 2, shortened, 2, true);
    assert_lines("", 8, 8, NULL, 0, false);
    assert_lines("abc", 0, 8, NULL, 0, false);
}

static void nothing_to_say_is_no_overlay(void **state)
{
    (void)state;
    struct vm_hud *hud = new_hud();
    bool changed;
    assert_null(vm_hud_draw(hud, 800, 800, 0, &changed));
    vm_hud_status(hud, "up");
    assert_non_null(vm_hud_draw(hud, 800, 800, 0, &changed));
    assert_true(changed);
    vm_hud_status(hud, NULL);
    assert_null(vm_hud_draw(hud, 800, 800, 0, &changed));
    assert_true(changed);
    assert_null(vm_hud_draw(hud, 0, 0, 0, &changed));
    vm_hud_destroy(hud);
}

static void is_drawn_again_only_when_it_changes(void **state)
{
    (void)state;
    struct vm_hud *hud = new_hud();
    bool changed;
    vm_hud_status(hud, "P39  60 Hz");
    vm_hud_draw(hud, 800, 600, 1, &changed);
    assert_true(changed);
    vm_hud_status(hud, "P39  60 Hz");
    vm_hud_draw(hud, 800, 600, 2, &changed);
    assert_false(changed);
    vm_hud_draw(hud, 801, 600, 3, &changed);
    assert_true(changed);
    vm_hud_status(hud, "P31  60 Hz");
    vm_hud_draw(hud, 801, 600, 4, &changed);
    assert_true(changed);
    vm_hud_destroy(hud);
}

static void status_text_leaves_out_what_changes_least(void **state)
{
    const struct vm_status s = {.name = "growing.df",
                                .tube = "VR17",
                                .phosphor = "P31",
                                .time = "4.70 s",
                                .scale = "x0.45 of x1",
                                .state = "",
                                .rate_hz = 59.96,
                                .words = 2345};
    char text[200];
    (void)state;
    assert_true(vm_status_text(&s, 80, text, sizeof text));
    assert_string_equal(text, "growing.df  VR17/P31  4.70 s  60.0 Hz  2345 words  x0.45 of x1");
    assert_true(vm_status_text(&s, vm_hud_columns(800, 800), text, sizeof text));
    assert_string_equal(text, "growing.df  VR17/P31  4.70 s  60.0 Hz  2345 words  x0.45 of x1");
    assert_true(vm_status_text(&s, vm_hud_columns(740, 740), text, sizeof text));
    assert_string_equal(text, "growing.df  VR17/P31  4.70 s  60.0 Hz  x0.45 of x1");
    assert_true(vm_status_text(&s, 46, text, sizeof text));
    assert_string_equal(text, "growing.df  VR17  4.70 s  60.0 Hz  x0.45 of x1");
    assert_true(vm_status_text(&s, 40, text, sizeof text));
    assert_string_equal(text, "growing.df  4.70 s  60.0 Hz  x0.45 of x1");
    assert_false(vm_status_text(&s, 39, text, sizeof text));
}

static void status_lies_at_the_bottom_in_dots_that_suit_the_window(void **state)
{
    (void)state;
    const struct {
        int width, height, dot;
    } windows[] = {{480, 480, 1}, {800, 800, 2}, {1920, 1080, 2}, {3840, 2160, 4}};
    for (size_t i = 0; i < 4; i++) {
        struct vm_hud *hud = new_hud();
        bool changed;
        int w = windows[i].width, h = windows[i].height, dot = windows[i].dot;
        vm_hud_status(hud, "status");
        struct vm_box box = extent(vm_hud_draw(hud, w, h, 0, &changed), w, h);
        assert_int_equal(box.y + box.h, h - 4 * dot);
        assert_int_equal(box.h, 20 * dot);
        assert_int_equal(box.w, (6 * 6 + 9) * dot);
        vm_hud_destroy(hud);
    }
}

static void a_message_fades_and_goes(void **state)
{
    (void)state;
    struct vm_hud *hud = new_hud();
    bool changed;
    int before = 256, redraws = 0;
    vm_hud_message(hud, "saved", 10, 4);
    for (double t = 10; t < 15; t += 0.01) {
        const uint8_t *rgba = vm_hud_draw(hud, 320, 240, t, &changed);
        int alpha = 0;
        for (int i = 0; rgba && i < 320 * 240; i++)
            alpha = rgba[4 * i + 3] > alpha ? rgba[4 * i + 3] : alpha;
        assert_true(alpha <= before);
        assert_true(t > 13.3 || alpha == 255);
        assert_true(t < 14.01 || !rgba);
        before = alpha;
        redraws += changed;
    }
    assert_in_range(redraws, 8, 24);
    vm_hud_destroy(hud);
}

static void help_fits_any_window(void **state)
{
    (void)state;
    static const char *const lines[] = {
        "kinescope", "F1\tthis help", "F7 F8\tslower, faster, down to single strokes of the beam",
        "A long line that says that a file dropped on the window is shown, and more besides."};
    const int sizes[][2] = {{3000, 2000}, {800, 800}, {320, 200}, {90, 60}, {8, 8}, {1, 1}};
    struct vm_hud *hud = new_hud();
    vm_hud_status(hud, "a status line that is far too long for the smallest of these windows");
    vm_hud_message(hud, "and a message", 0, 100);
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        bool changed;
        vm_hud_help(hud, true, lines, 4);
        assert_true(vm_hud_help_shown(hud));
        assert_non_null(vm_hud_draw(hud, sizes[i][0], sizes[i][1], 1, &changed));
    }
    vm_hud_help(hud, false, NULL, 0);
    assert_false(vm_hud_help_shown(hud));
    vm_hud_destroy(hud);
}

/* A cross with an open middle, where it was asked for and nowhere else. */
/* A panel at an edge lies where status and messages would: they come back after it. */
static void a_panel_at_the_edge_is_alone(void **state)
{
    (void)state;
    static const char *const lines[] = {"one", "two"};
    struct vm_hud *hud = new_hud();
    bool changed;
    vm_hud_status(hud, "a status line that is a good deal wider than the panel");
    struct vm_box status = extent(vm_hud_draw(hud, 800, 800, 0, &changed), 800, 800);
    vm_hud_message(hud, "a message", 0, 4);
    vm_hud_help_side(hud, VM_HUD_BOTTOM);
    vm_hud_help(hud, true, lines, 2);
    struct vm_box panel = extent(vm_hud_draw(hud, 800, 800, 0, &changed), 800, 800);
    assert_true(panel.w < 200 && panel.h < 100 && panel.y > 650);
    vm_hud_help(hud, false, NULL, 0);
    vm_hud_message(hud, "", 0, 0);
    struct vm_box again = extent(vm_hud_draw(hud, 800, 800, 0, &changed), 800, 800);
    assert_memory_equal(&again, &status, sizeof status);
    vm_hud_destroy(hud);
}

static void the_beams_mark_leaves_its_place_free(void **state)
{
    (void)state;
    struct vm_hud *hud = new_hud();
    bool changed;
    vm_hud_mark(hud, VM_MARK_BEAM, 100.5, 60.5, 7);
    const uint8_t *rgba = vm_hud_draw(hud, 300, 200, 0, &changed);
    struct vm_box box = extent(rgba, 300, 200);
    assert_true(changed && box.x > 80 && box.x + box.w < 121 && box.y > 40 && box.y + box.h < 81);
    for (int y = 56; y <= 64; y++)
        for (int x = 96; x <= 104; x++)
            assert_int_equal(rgba[(y * 300 + x) * 4 + 3], 0);
    assert_true(rgba[(60 * 300 + 110) * 4 + 3] > 100);
    vm_hud_draw(hud, 300, 200, 1, &changed);
    assert_false(changed);
    vm_hud_mark(hud, VM_MARK_BEAM, 0, 0, 0);
    assert_null(vm_hud_draw(hud, 300, 200, 2, &changed));
    assert_true(changed);
    vm_hud_destroy(hud);
}

/* At the rim of the window, and far outside. */
static void marks_are_cut_off_at_the_rim(void **state)
{
    (void)state;
    static const double places[] = {-1e9, -20, -3, 0, 299, 303, 1e9};
    struct vm_hud *hud = new_hud();
    bool changed;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        for (int which = 0; which < VM_HUD_MARKS; which++) {
            vm_hud_mark(hud, (enum vm_hud_mark)which, places[i], places[i], 5);
            vm_hud_draw(hud, 300, 200, 0, &changed);
        }
    vm_hud_destroy(hud);
}

/* In the corner, its samples as they are, with the text beneath; not where there is no room. */
static void a_picture_lies_in_the_corner(void **state)
{
    (void)state;
    struct crt_image image;
    struct crt_error err;
    bool changed;
    struct vm_hud *hud = new_hud();
    assert_true(crt_image_init(&image, 120, 50, 8, &err));
    for (int i = 0; i < 120 * 50 * 3; i++)
        image.samples[i] = (uint16_t)(i % 251);
    vm_hud_picture(hud, &image, "60.0 Hz\nsteady");
    crt_image_free(&image);
    const uint8_t *rgba = vm_hud_draw(hud, 300, 200, 0, &changed);
    struct vm_box box = extent(rgba, 300, 200);
    assert_true(box.x >= 150 && box.y >= 0 && box.y < 20 && box.x + box.w <= 300);
    assert_true(box.h > 50 + 2 * VM_TALL_DOTS && box.h < 100);
    for (int y = 0; y < 50; y++)
        for (int x = 0; x < 120 * 3; x++)
            assert_int_equal(rgba[((box.y + y) * 300 + box.x + x / 3) * 4 + x % 3],
                             (y * 360 + x) % 251);
    assert_null(vm_hud_draw(hud, 100, 200, 0, &changed));
    vm_hud_picture(hud, NULL, NULL);
    assert_null(vm_hud_draw(hud, 300, 200, 0, &changed));
    vm_hud_destroy(hud);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_letter_is_its_glyph),
        cmocka_unit_test(text_past_the_edges_is_cut_off),
        cmocka_unit_test(text_wraps_between_words),
        cmocka_unit_test(nothing_to_say_is_no_overlay),
        cmocka_unit_test(is_drawn_again_only_when_it_changes),
        cmocka_unit_test(status_text_leaves_out_what_changes_least),
        cmocka_unit_test(status_lies_at_the_bottom_in_dots_that_suit_the_window),
        cmocka_unit_test(a_message_fades_and_goes),
        cmocka_unit_test(help_fits_any_window),
        cmocka_unit_test(a_panel_at_the_edge_is_alone),
        cmocka_unit_test(the_beams_mark_leaves_its_place_free),
        cmocka_unit_test(marks_are_cut_off_at_the_rim),
        cmocka_unit_test(a_picture_lies_in_the_corner),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
