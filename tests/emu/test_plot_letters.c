/* Letters: each in its box and unlike all others, widths that are those of the ink, UTF-8. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/plot/letters.h"

#define SIDE 400

#define INK_W SIDE
#define INK_H SIDE
#include "tests/emu/ink_rig.h"

static void encode(uint32_t code, char text[5])
{
    unsigned char *p = (unsigned char *)text;
    if (code < 0x80) {
        *p++ = (unsigned char)code;
    } else if (code < 0x800) {
        *p++ = (unsigned char)(0xC0 | code >> 6);
        *p++ = (unsigned char)(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        *p++ = (unsigned char)(0xE0 | code >> 12);
        *p++ = (unsigned char)(0x80 | (code >> 6 & 0x3F));
        *p++ = (unsigned char)(0x80 | (code & 0x3F));
    } else {
        *p++ = (unsigned char)(0xF0 | code >> 18);
        *p++ = (unsigned char)(0x80 | (code >> 12 & 0x3F));
        *p++ = (unsigned char)(0x80 | (code >> 6 & 0x3F));
        *p++ = (unsigned char)(0x80 | (code & 0x3F));
    }
    *p = 0;
}

/* The ink's box by its pixels. */
static struct vm_rect seen(void)
{
    struct vm_rect r = {1e9, 1e9, -1, -1};
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            if (ink.coverage[y * SIDE + x] > 0.5f) {
                r.x0 = fmin(r.x0, x);
                r.y0 = fmin(r.y0, y);
                r.x1 = fmax(r.x1, x + 1);
                r.y1 = fmax(r.y1, y + 1);
            }
    return r;
}

static const struct vm_type type = {50, 1};

static void every_letter_stays_in_its_box(void **state)
{
    (void)state;
    double unit = type.size * VM_CAPITALS / VM_LETTER_HEIGHT;
    for (int i = 0; i < vm_letter_count; i++) {
        char text[5], framed[16];
        const struct vm_letter *l = &vm_letters[i];
        if (l->code == ' ' || l->code == 0xA0)
            continue;
        encode(l->code, text);
        vm_text_cover(&ink, type, 100, 200, false, text, 0);
        struct vm_rect r = seen(), e = vm_text_extent(type, text);
        vm_ink_forget(&ink);
        assert_true(fabs(r.x0 - 100) <= 1 && fabs(r.x1 - 100 - e.x1) <= 1);
        assert_true(fabs(r.y0 - 200 - e.y0) <= 1 && fabs(r.y1 - 200 - e.y1) <= 1);
        assert_true(r.y0 >= 200 - type.size && r.y1 <= 200 + VM_DESCENDER * type.size);
        /* Between two bars it touches neither: its ink stays within its advance. */
        snprintf(framed, sizeof framed, "|%s|", text);
        double all = vm_text_width(type, framed), bar = vm_text_width(type, "|");
        assert_true(fabs(all - bar - (l->width + 2 * VM_LETTER_GAP) * unit) < 1e-9);
        assert_true(e.x1 <= (l->width + VM_LETTER_GAP) * unit);
    }
}

/* Rendered in one cell each, as they stand on the line. */
#define CELL 64
static void every_letter_differs_from_every_other(void **state)
{
    (void)state;
    float *cell = calloc((size_t)vm_letter_count * CELL * CELL, sizeof *cell);
    assert_non_null(cell);
    for (int i = 0; i < vm_letter_count; i++) {
        char text[5];
        encode(vm_letters[i].code, text);
        vm_text_cover(&ink, type, 2, 48, false, text, 0);
        for (int y = 0; y < CELL; y++)
            memcpy(cell + (size_t)i * CELL * CELL + (size_t)y * CELL,
                   ink.coverage + (size_t)y * SIDE, CELL * sizeof *cell);
        vm_ink_forget(&ink);
    }
    for (int i = 0; i < vm_letter_count; i++)
        for (int k = 0; k < i; k++) {
            uint32_t a = vm_letters[k].code, b = vm_letters[i].code;
            if ((a == ' ' && b == 0xA0) || (a == 0xB5 && b == 0x3BC)) /* meant to look alike */
                continue;
            const float *p = cell + (size_t)i * CELL * CELL, *q = cell + (size_t)k * CELL * CELL;
            double differs = 0;
            for (int n = 0; n < CELL * CELL; n++)
                differs += fabs((double)p[n] - (double)q[n]);
            if (differs < 12)
                fail_msg("U+%04X and U+%04X look alike (%.1f)", a, b, differs);
        }
    free(cell);
}

static void ascii_is_complete_and_the_table_in_order(void **state)
{
    (void)state;
    for (uint32_t c = ' '; c < 127; c++)
        assert_int_equal(vm_letter_of(c)->code, c);
    const char *p = "µ²³°·×−–±τσλΔΣη≤≥½→…∞√πω⁰¹²³⁴⁵⁶⁷⁸⁹⁻§";
    for (uint32_t c; (c = vm_utf8_next(&p)) != 0;)
        assert_int_equal(vm_letter_of(c)->code, c);
    for (int i = 2; i < vm_letter_count; i++)
        assert_true(vm_letters[i].code > vm_letters[i - 1].code);
    assert_int_equal(vm_letter_of(0x4E00)->code, 0xFFFD);
}

static void the_width_is_that_of_the_ink(void **state)
{
    (void)state;
    const char *const texts[] = {
        "luminance, cd/m²", "AVAILABLE", "time, µs", "10⁻³", "−0.25", "jWy", "P31 (½)", "|"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        for (double size = 12; size < 44; size += 5.3) {
            struct vm_type t = {size, 1};
            vm_text_cover(&ink, t, 10.25, 200, false, texts[i], 0);
            struct vm_rect r = seen();
            vm_ink_forget(&ink);
            assert_true(fabs(r.x1 - 10.25 - vm_text_width(t, texts[i])) < 1.01);
            assert_true(fabs(r.x0 - 10.25) < 1.01);
        }
    assert_true(vm_text_width(type, "") == 0 && vm_text_width(type, "   ") == 0);
}

static void turned_text_is_the_text_turned(void **state)
{
    (void)state;
    static float level[SIDE * SIDE];
    vm_text_cover(&ink, (struct vm_type){22, 1}, 40, 300, false, "luminance, cd/m²", 0);
    memcpy(level, ink.coverage, sizeof level);
    vm_ink_forget(&ink);
    /* (x, y) goes to (y, SIDE − x): a quarter turn that runs upwards. */
    vm_text_cover(&ink, (struct vm_type){22, 1}, 300, SIDE - 40, true, "luminance, cd/m²", 0);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++)
            assert_true(fabsf(level[y * SIDE + x] - ink.coverage[(SIDE - 1 - x) * SIDE + y]) <
                        1e-4f);
    vm_ink_forget(&ink);
}

static void utf8_is_read_and_wrong_bytes_are_boxes(void **state)
{
    (void)state;
    for (uint32_t code = 1; code < 0x110000; code += code < 0x3000 ? 1 : 97) {
        char text[5];
        if (code >= 0xD800 && code < 0xE000)
            continue;
        encode(code, text);
        const char *p = text;
        assert_int_equal(vm_utf8_next(&p), code);
        assert_int_equal(vm_utf8_next(&p), 0);
    }
    const char *const wrong[] = {
        "\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80",
        "\xC3", "\xE2\x82", "\xFF"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        const char *p = wrong[i], *end = p + strlen(p);
        assert_int_equal(vm_utf8_next(&p), 0xFFFD);
        while (vm_utf8_next(&p))
            ;
        assert_ptr_equal(p, end);
    }
    uint32_t seed = 7;
    for (int i = 0; i < 20000; i++) { /* never beyond the end */
        char bytes[8];
        for (int k = 0; k < 7; k++) {
            seed = seed * 1664525u + 1013904223u;
            bytes[k] = (char)(seed >> 24);
        }
        bytes[7] = '\0';
        const char *p = bytes;
        while (vm_utf8_next(&p))
            ;
        assert_true(p <= bytes + 7 && *p == '\0');
    }
}

static void cut_texts_fit_and_say_so(void **state)
{
    (void)state;
    const char *text = "réflexion: luminance of P31 ≥ 100 cd/m²";
    char cut[128];
    for (double width = 20; width < 1400; width += 7) {
        vm_text_cut(type, text, width, cut, sizeof cut);
        assert_true(vm_text_width(type, cut) <= width || strcmp(cut, "…") == 0);
        if (strcmp(cut, text) != 0) {
            size_t n = strlen(cut) - strlen("…");
            assert_string_equal(cut + n, "…");
            assert_memory_equal(cut, text, n);
            for (const char *p = cut; *p;)
                assert_int_not_equal(vm_utf8_next(&p), 0xFFFD);
        }
    }
    assert_string_equal(cut, text);
    char tiny[12];
    vm_text_cut(type, text, 1e9, tiny, sizeof tiny);
    assert_true(strlen(tiny) < sizeof tiny);
}

static void lines_break_between_words(void **state)
{
    (void)state;
    const char *text = "one two three";
    assert_int_equal(vm_text_fits(type, text, 1e9), strlen(text));
    assert_int_equal(vm_text_fits(type, text, vm_text_width(type, "one two") + 0.1), 7);
    assert_int_equal(vm_text_fits(type, text, vm_text_width(type, "one two") - 0.1), 3);
    assert_int_equal(vm_text_fits(type, text, 1), 3); /* a word at least */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_letter_stays_in_its_box),
        cmocka_unit_test(every_letter_differs_from_every_other),
        cmocka_unit_test(ascii_is_complete_and_the_table_in_order),
        cmocka_unit_test(the_width_is_that_of_the_ink),
        cmocka_unit_test(turned_text_is_the_text_turned),
        cmocka_unit_test(utf8_is_read_and_wrong_bytes_are_boxes),
        cmocka_unit_test(cut_texts_fit_and_say_so),
        cmocka_unit_test(lines_break_between_words),
    };
    return cmocka_run_group_tests(tests, open_sheet, close_sheet);
}
