/* test_glyphs.c — the character generator's table: complete, distinct, inside its cell, on its
 * lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/glyphs.h"

#define GLYPHS 127

/* The table as one list: 96 ASCII characters, then 31 special ones. */
static const struct df_glyph *glyph_number(unsigned n)
{
    if (n < 96)
        return df_glyph_ascii(040 + n);
    unsigned code = n - 96;
    return df_glyph_special(code < 017 ? code : code + 1);
}

/* Dots of one row, bit 5 = left column; row 0 is the lowest drawn. */
static unsigned row_of(const struct df_glyph *glyph, unsigned row)
{
    unsigned bits = 0;
    for (unsigned c = 0; c < DF_GLYPH_COLUMNS; c++)
        bits |= ((unsigned)glyph->column[c] >> row & 1u) << (5 - c);
    return bits;
}

/* The lowest and highest lit dot as heights above the base line, in dots. */
static int lowest(const struct df_glyph *glyph)
{
    int row = 0;
    while (row < DF_GLYPH_ROWS && !row_of(glyph, (unsigned)row))
        row++;
    return row - (glyph->descends ? 2 : 0);
}

static int highest(const struct df_glyph *glyph)
{
    int row = DF_GLYPH_ROWS - 1;
    while (row >= 0 && !row_of(glyph, (unsigned)row))
        row--;
    return row - (glyph->descends ? 2 : 0);
}

static void every_code_has_a_glyph(void **state)
{
    (void)state;
    for (unsigned code = 0; code < 0400; code++) {
        assert_int_equal(df_glyph_ascii(code) != NULL, code >= 040 && code <= 0177);
        assert_int_equal(df_glyph_special(code) != NULL, code <= 037 && code != 017);
        assert_int_equal(df_glyph_special_name(code) != NULL, code <= 037 && code != 017);
    }
    assert_null(df_glyph_ascii(UINT32_MAX));
    assert_null(df_glyph_special(UINT32_MAX));
    assert_null(df_glyph_special_name(UINT32_MAX));
}

static void only_space_is_dark(void **state)
{
    (void)state;
    for (unsigned n = 0; n < GLYPHS; n++) {
        unsigned dots = 0;
        for (unsigned c = 0; c < DF_GLYPH_COLUMNS; c++)
            for (unsigned bit = 0; bit < 8; bit++)
                dots += (unsigned)glyph_number(n)->column[c] >> bit & 1u;
        if (n == 0)
            assert_int_equal(dots, 0);
        else
            assert_in_range(dots, 3, 48);
    }
}

/* As drawn, so that a glyph and the same one lowered count as two. */
static void all_are_distinct(void **state)
{
    (void)state;
    for (unsigned a = 0; a < GLYPHS; a++)
        for (unsigned b = 0; b < a; b++) {
            const struct df_glyph *ga = glyph_number(a), *gb = glyph_number(b);
            if (ga->descends == gb->descends && !memcmp(ga->column, gb->column, 6))
                fail_msg("glyphs %u and %u are the same", a, b);
        }
}

/* Pairs that readers confuse must differ in more than one dot. */
static void look_alikes_differ_clearly(void **state)
{
    (void)state;
    const char *pairs[] = {"0O", "1l", "1I", "lI", "5S", "2Z", "'`", "'\"", "8B", "|I", "|l",
                           "|1", "0D", "OD", "OQ", "uv", "({", ")}", "([",  ")]", ".,", ":;"};
    for (unsigned p = 0; p < sizeof pairs / sizeof pairs[0]; p++) {
        const struct df_glyph *a = df_glyph_ascii((unsigned char)pairs[p][0]);
        const struct df_glyph *b = df_glyph_ascii((unsigned char)pairs[p][1]);
        unsigned differ = 0;
        for (int y = -2; y < 8; y++) {
            int ya = y + (a->descends ? 2 : 0), yb = y + (b->descends ? 2 : 0);
            unsigned ra = ya >= 0 && ya < 8 ? row_of(a, (unsigned)ya) : 0;
            unsigned rb = yb >= 0 && yb < 8 ? row_of(b, (unsigned)yb) : 0;
            for (unsigned d = ra ^ rb; d; d &= d - 1)
                differ++;
        }
        if (differ < 2)
            fail_msg("%s differ in %u dots only", pairs[p], differ);
    }
}

static void descenders_are_marked(void **state)
{
    (void)state;
    for (unsigned code = 040; code <= 0177; code++)
        assert_int_equal(df_glyph_ascii(code)->descends, strchr("gjpqy,;_", (int)code) != NULL);
    for (unsigned code = 0; code <= 037; code++)
        if (code != 017) /* phi, gamma, psi, mu */
            assert_int_equal(df_glyph_special(code)->descends,
                             code == 02 || code == 07 || code == 011 || code == 015);
    for (unsigned n = 0; n < GLYPHS; n++) {
        const struct df_glyph *glyph = glyph_number(n);
        if (glyph->descends) /* else the mark has no use */
            assert_in_range(lowest(glyph) + 2, 0, 1);
    }
}

static void letters_stand_on_the_base_line(void **state)
{
    (void)state;
    for (const char *c = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"; *c; c++) {
        assert_int_equal(lowest(df_glyph_ascii((unsigned char)*c)), 0);
        assert_int_equal(highest(df_glyph_ascii((unsigned char)*c)), 7);
    }
    for (const char *c = "acemnorsuvwxz"; *c; c++) {
        assert_int_equal(lowest(df_glyph_ascii((unsigned char)*c)), 0);
        assert_int_equal(highest(df_glyph_ascii((unsigned char)*c)), 4);
    }
    for (const char *c = "bdfhkl"; *c; c++) {
        assert_int_equal(lowest(df_glyph_ascii((unsigned char)*c)), 0);
        assert_int_equal(highest(df_glyph_ascii((unsigned char)*c)), 7);
    }
    for (const char *c = "gpqy"; *c; c++) {
        assert_int_equal(lowest(df_glyph_ascii((unsigned char)*c)), -2);
        assert_int_equal(highest(df_glyph_ascii((unsigned char)*c)), 4);
    }
    assert_int_equal(lowest(df_glyph_ascii('j')), -2);
    assert_int_equal(lowest(df_glyph_ascii('i')), 0);
    assert_int_equal(lowest(df_glyph_ascii('t')), 0);
}

/* The sixth column is kept dark, so that neighbours stay apart, except where its use is meant. */
static void five_columns_suffice(void **state)
{
    (void)state;
    for (unsigned code = 040; code <= 0177; code++)
        if (code != '_' && code != 0177)
            assert_int_equal(df_glyph_ascii(code)->column[5], 0);
    for (unsigned code = 0; code <= 037; code++)
        if (code != 014 && code != 017 && code != 037)
            assert_int_equal(df_glyph_special(code)->column[5], 0);
}

/* Letters, figures and operators that read the same in a mirror are drawn so. */
static void symmetrical_signs_are_symmetrical(void **state)
{
    (void)state;
    for (const char *c = "AHIMOTUVWXY8!\"*+-:=^_|vwx"; *c; c++) {
        const struct df_glyph *glyph = df_glyph_ascii((unsigned char)*c);
        unsigned first = 0, last = 5;
        while (!glyph->column[first])
            first++;
        while (!glyph->column[last])
            last--;
        for (unsigned a = first, b = last; a < b; a++, b--)
            assert_int_equal(glyph->column[a], glyph->column[b]);
    }
    const char *pairs[] = {"()", "[]", "{}", "<>", "/\\", "pq"};
    for (unsigned p = 0; p < sizeof pairs / sizeof pairs[0]; p++)
        for (unsigned c = 0; c < 5; c++)
            assert_int_equal(df_glyph_ascii((unsigned char)pairs[p][0])->column[c],
                             df_glyph_ascii((unsigned char)pairs[p][1])->column[4 - c]);
}

/* Pictures are packed right way round: F has its stem at the left and its bars at the top. */
static void pictures_are_upright(void **state)
{
    (void)state;
    const uint8_t f[6] = {0xff, 0x90, 0x90, 0x90, 0x80, 0x00};
    assert_memory_equal(df_glyph_ascii('F')->column, f, 6);
    const uint8_t up[6] = {0x20, 0x40, 0xff, 0x40, 0x20, 0x00};
    assert_memory_equal(df_glyph_special(030)->column, up, 6);
    for (unsigned c = 0; c < 6; c++)
        assert_int_equal(df_glyph_ascii(0177)->column[c], 0xff);
}

/* Code assignment of the 31 special characters. */
static void special_characters_have_names(void **state)
{
    (void)state;
    const char *names[32] = {
        "lambda",     "alpha",   "phi",           "Sigma",        "delta",
        "Delta",      "iota",    "gamma",         "intersection", "psi",
        "divide",     "degree",  "therefore",     "mu",           "pound",
        NULL,         "pi",      "parallel",      "Omega",        "sigma",
        "Upsilon",    "epsilon", "left arrow",    "right arrow",  "up arrow",
        "down arrow", "Gamma",   "perpendicular", "not equal",    "nearly equal",
        "or",         "box",
    };
    for (unsigned code = 0; code <= 037; code++)
        if (names[code])
            assert_string_equal(df_glyph_special_name(code), names[code]);
        else
            assert_null(df_glyph_special_name(code));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_code_has_a_glyph),
        cmocka_unit_test(only_space_is_dark),
        cmocka_unit_test(all_are_distinct),
        cmocka_unit_test(look_alikes_differ_clearly),
        cmocka_unit_test(descenders_are_marked),
        cmocka_unit_test(letters_stand_on_the_base_line),
        cmocka_unit_test(five_columns_suffice),
        cmocka_unit_test(symmetrical_signs_are_symmetrical),
        cmocka_unit_test(pictures_are_upright),
        cmocka_unit_test(special_characters_have_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
