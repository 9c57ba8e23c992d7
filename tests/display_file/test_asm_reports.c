/* What the assembler says to faulty sources: word for word, place, line and caret included. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/asm.h"
#include "tests/support/source.h"

/* ---- the cases of asm_reports.txt ---- */

#define SOURCE "--- source\n"
#define REPORT "--- report\n"

static char *read_cases(void)
{
    FILE *in = fopen("tests/display_file/asm_reports.txt", "rb");
    if (in == NULL) {
        print_error("run the tests from the project's top folder\n");
        fail();
    }
    char *text = calloc(1, 1 << 18);
    assert_non_null(text);
    size_t length = fread(text, 1, (1 << 18) - 1, in);
    assert_true(length > 1000);
    fclose(in);
    return text;
}

static void every_report_is_as_written(void **state)
{
    (void)state;
    char *text = read_cases();
    unsigned cases = 0, different = 0;
    for (char *at = strstr(text, SOURCE); at != NULL; cases++) {
        char *source = at + strlen(SOURCE), *report = strstr(source, REPORT);
        assert_non_null(report);
        *report = 0;
        report += strlen(REPORT);
        at = strstr(report, SOURCE);
        char *end = at != NULL ? at : report + strlen(report);
        char kept = *end;
        *end = 0;
        struct df_program p;
        struct df_asm_report got;
        bool ok = df_assemble_text("t.df", source, strlen(source), NULL, &p, &got);
        if (ok || strcmp(got.text, report) != 0) {
            print_error("source\n%sreport\n%sexpected\n%s\n", source, got.text, report);
            different++;
        }
        df_asm_report_free(&got);
        *end = kept;
    }
    free(text);
    assert_int_equal(different, 0);
    assert_true(cases > 130);
}

/* ---- cases that are no text ---- */

static void faults_of_whole_files(void **state)
{
    (void)state;
    struct df_program p;
    struct df_asm_report report;
    assert_false(df_assemble_text("t.df", "nop\0nop", 7, NULL, &p, &report));
    assert_string_equal(report.text,
                        "t.df: byte 3 is NUL: this is not text; expected .df source\n");
    df_asm_report_free(&report);

    assert_false(df_assemble_text("t.df", "", 0, NULL, &p, &report));
    assert_string_equal(report.text,
                        "t.df: no words in this program; expected at least one statement\n");
    df_asm_report_free(&report);

    size_t huge = (12u << 20) + 1;
    char *text = malloc(huge);
    assert_non_null(text);
    memset(text, '\n', huge);
    assert_false(df_assemble_text("t.df", text, huge, NULL, &p, &report));
    assert_string_equal(report.text, "t.df: the file is larger than 12 MiB; expected .df source\n");
    assert_int_equal(report.errors, 1);
    df_asm_report_free(&report);
    assert_false(df_assemble_text("t.df", text, huge - 1, NULL, &p, &report));
    assert_string_equal(report.text,
                        "t.df: the file has more than 1000000 lines; expected .df source\n");
    df_asm_report_free(&report);
    /* As many lines as there may be, all empty. */
    assert_false(df_assemble_text("t.df", text, 999999, NULL, &p, &report));
    assert_string_equal(report.text,
                        "t.df: no words in this program; expected at least one statement\n");
    df_asm_report_free(&report);
    free(text);
}

static void bytes_that_are_not_ascii(void **state)
{
    (void)state;
    assert_report("nop \x01\nchar\ntext \"\xc3\xa4\" ; \xc3\xa4\n.word '\x7f'\n",
                  "t.df:1:5: byte 0x01 is not part of the language; expected printable ASCII\n"
                  "    nop ?\n"
                  "        ^\n"
                  "t.df:3:7: a character that is not printable ASCII; expected an escape such as "
                  "\\x07\n"
                  "    text \"\xc3\xa4\" ; \xc3\xa4\n"
                  "          ^\n"
                  "t.df:4:8: a character that is not printable ASCII; expected an escape such as "
                  "\\x07\n"
                  "    .word '?'\n"
                  "           ^\n");
    /* The caret counts characters, not bytes. */
    assert_report(".word \xc3\xa4\n", "t.df:1:7: byte 0xc3 is not part of the language; expected "
                                      "printable ASCII\n    .word \xc3\xa4\n          ^\n");
}

static void runaway_programs_end(void **state)
{
    (void)state;
    const char *part = "the program does not come to an end; expected at most 2000000 lines";
    assert_error(".repeat 1000000000\n.set x = 1\n.endr", part);
    assert_error(".macro m n\n.if n\nm n - 1\nm n - 1\n.endif\n.endm\n.repeat 1000\nm 13\n.endr",
                 part);
    assert_error(".repeat 200000\nnop\n.endr",
                 "t.df:2:1: no memory at 0o1000000; expected addresses below 0o1000000");
}

static void errors_are_kept_up_to_a_thousand(void **state)
{
    (void)state;
    static char text[1 << 16];
    for (int i = 0; i < 1500; i++) {
        strcat(text, "char i=8\n");
    }
    struct df_program p;
    struct df_asm_report report;
    assert_false(df_assemble_text("t.df", text, strlen(text), NULL, &p, &report));
    assert_true(report.errors > 1000);
    assert_non_null(strstr(report.text, "t.df:1:8: i is 8"));
    assert_non_null(strstr(report.text, "t.df:1000:8: i is 8"));
    assert_null(strstr(report.text, "t.df:1001:8: i is 8"));
    assert_non_null(strstr(report.text, "More than 1000 errors: the rest is not shown.\n"));
    df_asm_report_free(&report);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_report_is_as_written),       cmocka_unit_test(faults_of_whole_files),
        cmocka_unit_test(bytes_that_are_not_ascii),         cmocka_unit_test(runaway_programs_end),
        cmocka_unit_test(errors_are_kept_up_to_a_thousand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
