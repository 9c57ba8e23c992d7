/* Expressions, names, blocks, files and listings of the .df language. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sys/stat.h>
#include <cmocka.h>

#include "display_file/asm.h"
#include "tests/support/source.h"

static void precedence_is_that_of_c(void **state)
{
    (void)state;
    assert_words(".word 2+3*4, (2+3)*4, 10-4-3, 100/10/5, 1|2^3&2, 6&3==3", 14, 20, 3, 2,
                 1 | (2 ^ (3 & 2)), 6 & (3 == 3));
    assert_words(".word 1<<3+1, 1+1<<3, 256>>4>>1, 5<6, 6<=5, 5>=5, 3!=3, 1 < 2 & 2 < 3", 16, 16, 8,
                 1, 0, 1, 0, 1);
    assert_words(".word -3+5, ~0 & 0xff, -(-3), --3, - 7 % 5, 7 % -5, 7.5 % 2 * 2, +4", 2, 255, 3,
                 3, 3, (uint16_t)-3, 3, 4);
    assert_words(".word 0o777, 0xFf, 0b11, 'a', '\\n', '\\'', 12.75", 0777, 255, 3, 'a', '\n', '\'',
                 13);
}

static void functions(void **state)
{
    (void)state;
    assert_words(".word sin(30)*1000, cos(60)*1000, sin(90), cos(180)*-1, sin(-30)*-2, cos(0), "
                 "sin(45)*10000, cos(45)*10000, sin(3600), cos(90)",
                 500, 500, 1, 1, 1, 1, 7071, 7071, 0, 0);
    assert_words(".word sqrt(2)*10000, round(2.5), floor(-2.5)+10, ceil(2.1), abs(-7), min(3,1,2), "
                 "max(3, 9, 2), min(4), pi*10000",
                 14142, 3, 7, 3, 7, 1, 9, 4, 31416);
}

static void sines_agree_with_known_values(void **state)
{
    (void)state;
    /* 10^4 sin of 1°, 10°, 80°, 89°, 200°, 350°. */
    assert_words(".equ K = 10000\n.word K*sin(1), K*sin(10), K*sin(80), K*sin(89), -K*sin(200), "
                 "-K*sin(350), K*cos(1), K*cos(-80)",
                 175, 1736, 9848, 9998, 3420, 1736, 9998, 1736);
}

static void names(void **state)
{
    (void)state;
    assert_words(".equ Later = there - here\nhere: .word LATER, x\n.word 0\nthere: .equ x = 3", 6,
                 3, 0);
    assert_words(".set n = 1\n.word n\n.set n = n * 10\n.word n\n.set n=n*10\n.word n", 1, 10, 100);
    assert_words("a: b: _c$1: .word a, b, _c$1", 0, 0, 0);
    assert_words("draw: jump draw", 0160000, 0);
}

static void repeats(void **state)
{
    (void)state;
    assert_words(".repeat 3, i\n.word i\n.endr\n.repeat 0\n.word 9\n.endr", 0, 1, 2);
    assert_words(".repeat 2, i\n.repeat 2, j\n.word i*10+j, k\n.endr\n.endr\n.equ k = 7", 0, 7, 1,
                 7, 10, 7, 11, 7);
    assert_words(".repeat 2\n@l: jump @l\n.endr", 0160000, 0, 0160000, 4);
    assert_words(".set s = 0\n.repeat 4, i\n.set s = s + i\n.endr\n.word s", 6);
    assert_words(".equ i = 5\n.repeat 1, i\n.word i\n.endr\n.word i", 0, 5);
}

static void macros(void **state)
{
    (void)state;
    assert_words(".macro two a, b\n.word a, b\n.endm\ntwo 1, 2\nTWO 3+4, -1", 1, 2, 7, 0177777);
    assert_words(".macro say s\ntext s, 13\n.endm\nchar\nsay \"HEY\"", 0100000, 042510, 06531);
    assert_words(".macro lbl\n@a: jump @a\n.endm\nlbl\nlbl\n@a: jump @a", 0160000, 0, 0160000, 4,
                 0160000, 010);
    /* A macro sees its own parameters, not those of its caller. */
    assert_words(".equ x = 9\n.macro in\n.word x\n.endm\n.macro out x\nin\n.word x\n.endm\nout 1",
                 9, 1);
    assert_words(".macro m\n.word 1\n.endm\nl: m ; comment\nm", 1, 1);
    assert_words(".macro f n\n.if n > 0\n.word n\nf n - 1\n.endif\n.endm\nf 3", 3, 2, 1);
    /* A forward label may be passed as long as it does not decide how many words there are. */
    assert_words(".macro go where\njump where\n.endm\ngo end\nend: nop", 0160000, 4, 0164000);
}

static void mode_and_position_flow_through_macros(void **state)
{
    (void)state;
    assert_words(".macro tri s\nlongv\ndraw s, 0, 0, s, -s, -s\n.endm\npoint\nat 5, 5\ntri 2\n"
                 "draw 1, 1\nlineto 5, 5",
                 0114000, 5, 5, 0110000, 040002, 0, 040000, 2, 060002, 020002, 040001, 1, 060001,
                 020001);
}

static void conditions(void **state)
{
    (void)state;
    assert_words(".if 1 > 2\n.word 1\n.else\n.word 2\n.endif\n.if 3\n.word 3\n.endif", 2, 3);
    assert_words(".if 0\nthis is $ not even read: \"\n.if 1\n.else\n.endif\n.endif\n.word 1", 1);
    assert_words(".if 1\n.if 0\n.word 1\n.else\n.word 2\n.endif\n.else\n.word 3\n.endif", 2);
    assert_words(".assert 1, \"never\"\n.word 1\n.assert . == 2, \"length\"", 1);
}

static void places(void **state)
{
    (void)state;
    struct df_program p;
    source_program(".org 0o2000\n.word 1\n.org 0o1000\nhere: .word 2\n.start here", &p);
    assert_int_equal(p.low, 01000);
    assert_int_equal(p.high, 02002);
    assert_int_equal(p.entry, 01000);
    assert_int_equal(p.words[02000 / 2], 1);
    assert_int_equal(p.words[01000 / 2], 2);
    assert_int_equal(p.loaded[01002 / 2], 0);
    df_program_free(&p);
    source_program(".org 0o777776\n.word 1\n.org 2\n.word 3", &p);
    assert_int_equal(p.entry, 2);
    assert_int_equal(p.high, 01000000);
    df_program_free(&p);
}

static void labels_do_not_hide_the_position_unless_used(void **state)
{
    (void)state;
    assert_words("point\nat 1,1\nunused: longv\nlineto 2,2", 0114000, 1, 1, 0110000, 040001, 1);
    assert_error("point\nat 1,1\nused: longv\nlineto 2,2\njump used",
                 "t.df:4:1: 'lineto' from an unknown place");
    assert_words("point\nat 1,1\nused: longv\n.pos 1,1\nlineto 2,2\njump used", 0114000, 1, 1,
                 0110000, 040001, 1, 0160000, 6);
}

static void bytes_of_all_kinds_of_files(void **state)
{
    (void)state;
    assert_words("\xef\xbb\xbf.word 1 ; \xc3\xa4\r\n.word 2\r\n", 1, 2);
    assert_words("\t.word\t1\n\n\n;\n.word 2", 1, 2);
}

/* ---- files ---- */

static const char *folder(void)
{
    static char path[256];
    const char *out = getenv("TEST_OUT");
    snprintf(path, sizeof path, "%s/asm_language", out != NULL ? out : "/tmp");
    mkdir(path, 0777);
    return path;
}

static void write_file(const char *name, const char *text)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder(), name);
    FILE *out = fopen(path, "wb");
    assert_non_null(out);
    assert_int_equal(fwrite(text, 1, strlen(text), out), strlen(text));
    fclose(out);
}

static bool assemble_file(const char *name, struct df_program *p, struct df_asm_report *report)
{
    char path[512];
    snprintf(path, sizeof path, "%s/%s", folder(), name);
    return df_assemble_file(path, NULL, p, report);
}

static void includes(void **state)
{
    (void)state;
    struct df_program p;
    struct df_asm_report report;
    char sub[300];
    snprintf(sub, sizeof sub, "%s/sub", folder());
    mkdir(sub, 0777);
    write_file("main.df", ".include \"sub/a.df\"\nmine: .word two\n");
    write_file("sub/a.df", ".dialect dec\n10\n.include \"b.df\"\n20\n");
    write_file("sub/b.df", ".word 10\n.equ two = 2\n");
    assert_true(assemble_file("main.df", &p, &report));
    assert_string_equal(report.text, "");
    const uint16_t expected[] = {010, 10, 020, 2};
    assert_memory_equal(p.words, expected, sizeof expected);
    /* Where each word came from. */
    assert_int_equal(p.file_count, 3);
    assert_int_equal(p.line[1] & 0xffffff, 1);
    assert_non_null(strstr(p.files[p.line[1] >> 24], "sub/b.df"));
    assert_int_equal(p.line[3] & 0xffffff, 2);
    assert_non_null(strstr(p.files[p.line[3] >> 24], "main.df"));
    df_asm_report_free(&report);
    df_program_free(&p);
}

static void include_trouble(void **state)
{
    (void)state;
    struct df_program p;
    struct df_asm_report report;
    write_file("cycle.df", ".include \"cycle2.df\"\n");
    write_file("cycle2.df", "nop\n  .include \"cycle.df\"\n");
    assert_false(assemble_file("cycle.df", &p, &report));
    assert_int_equal(report.errors, 1);
    assert_non_null(strstr(report.text, "cycle2.df:2:12: '"));
    assert_non_null(strstr(report.text, "cycle.df' includes itself; expected no cycle"));
    df_asm_report_free(&report);

    /* What a missing file may define is not complained about. */
    write_file("lost.df", ".include \"none.df\"\n.word a, b\nfrob 1\n");
    assert_false(assemble_file("lost.df", &p, &report));
    assert_int_equal(report.errors, 1);
    assert_non_null(strstr(report.text, "lost.df:1:10: cannot read '"));
    assert_non_null(strstr(report.text, "none.df' (No such file or directory)"));
    df_asm_report_free(&report);

    assert_false(assemble_file("no such.df", &p, &report));
    assert_int_equal(report.errors, 1);
    assert_non_null(strstr(report.text, "no such.df: cannot be read (No such file or directory); "
                                        "expected a .df source file\n"));
    df_asm_report_free(&report);

    assert_false(df_assemble_file(folder(), NULL, &p, &report));
    assert_non_null(strstr(report.text, "it is a directory"));
    df_asm_report_free(&report);
}

static void listing(void **state)
{
    (void)state;
    const char *text = "; two points\n"
                       "        .macro dot x\n"
                       "        plot x, x\n"
                       "        .endm\n"
                       "go:     point i=7\n"
                       "        .repeat 2, K\n"
                       "        dot 10 * K\n"
                       "        .endr\n"
                       "        .word 1, 2, 3, 4\n"
                       "        .if 0\n"
                       "        nop\n"
                       "        .endif\n"
                       "        jump go\n";
    const char *expected = "; t.df\n"
                           "                                  1   ; two points\n"
                           "                                  2           .macro dot x\n"
                           "                                  3           plot x, x\n"
                           "                                  4           .endm\n"
                           "000000  117600                    5   go:     point i=7\n"
                           "                                  6           .repeat 2, K\n"
                           "                                  7           dot 10 * K\n"
                           "000002  040000 000000             3+          plot x, x\n"
                           "000006  040012 000012             3+          plot x, x\n"
                           "                                  8           .endr\n"
                           "000012  000001 000002 000003      9           .word 1, 2, 3, 4\n"
                           "000020  000004\n"
                           "                                 10           .if 0\n"
                           "                                 11           nop\n"
                           "                                 12           .endif\n"
                           "000022  160000 000000            13           jump go\n"
                           "; 11 words from 000000 to 000024, start 000000\n";
    struct df_asm_options options = {.listing = true};
    struct df_program p;
    struct df_asm_report report;
    assert_true(df_assemble_text("t.df", text, strlen(text), &options, &p, &report));
    assert_string_equal(report.listing, expected);
    df_asm_report_free(&report);
    df_program_free(&p);
}

/* The complete example in LANGUAGE.md: what the page promises is what the assembler does. */
static void the_page_holds(void **state)
{
    (void)state;
    FILE *in = fopen("display_file/LANGUAGE.md", "rb");
    if (in == NULL) {
        skip();
    }
    static char page[1 << 16];
    size_t length = fread(page, 1, sizeof page - 1, in);
    fclose(in);
    page[length] = 0;
    unsigned examples = 0;
    for (char *open = strstr(page, "\n```\n"); open != NULL; examples++) {
        char *start = open + 5, *close = strstr(start, "\n```\n");
        assert_non_null(close);
        close[1] = 0;
        struct df_program p;
        source_program(start, &p);
        df_program_free(&p);
        open = strstr(close + 2, "\n```\n");
    }
    assert_int_equal(examples, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(precedence_is_that_of_c),
        cmocka_unit_test(functions),
        cmocka_unit_test(sines_agree_with_known_values),
        cmocka_unit_test(names),
        cmocka_unit_test(repeats),
        cmocka_unit_test(macros),
        cmocka_unit_test(mode_and_position_flow_through_macros),
        cmocka_unit_test(conditions),
        cmocka_unit_test(places),
        cmocka_unit_test(labels_do_not_hide_the_position_unless_used),
        cmocka_unit_test(bytes_of_all_kinds_of_files),
        cmocka_unit_test(includes),
        cmocka_unit_test(include_trouble),
        cmocka_unit_test(listing),
        cmocka_unit_test(the_page_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
