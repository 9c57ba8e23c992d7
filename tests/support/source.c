#include "tests/support/source.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/asm.h"

static bool assemble(const char *text, struct df_program *program, struct df_asm_report *report)
{
    return df_assemble_text("t.df", text, strlen(text), NULL, program, report);
}

void source_words(const char *text, const uint16_t *words, size_t count, const char *file, int line)
{
    struct df_program p;
    struct df_asm_report report;
    if (!assemble(text, &p, &report)) {
        print_error("%s:%d: does not assemble:\n%s", file, line, report.text);
        _fail(file, line);
    }
    size_t have = (p.high - p.low) / 2;
    for (size_t i = 0; i < count || i < have; i++) {
        size_t at = p.low / 2 + i;
        if (i >= count || i >= have || p.words[at] != words[i] || !p.loaded[at]) {
            print_error("%s:%d: word %zu of %zu (expected %zu) is %06o, expected %06o\n%s\n", file,
                        line, i, have, count, i < have ? (unsigned)p.words[at] : 0,
                        i < count ? (unsigned)words[i] : 0, text);
            _fail(file, line);
        }
    }
    df_asm_report_free(&report);
    df_program_free(&p);
}

static void failing(const char *text, struct df_asm_report *report, const char *file, int line)
{
    struct df_program p;
    if (assemble(text, &p, report)) {
        print_error("%s:%d: assembles, but should not:\n%s\n", file, line, text);
        _fail(file, line);
    }
    if (p.words != NULL || p.files != NULL) {
        print_error("%s:%d: the program is not empty after an error\n", file, line);
        _fail(file, line);
    }
}

void source_report(const char *text, const char *expected, const char *file, int line)
{
    struct df_asm_report report;
    failing(text, &report, file, line);
    if (strcmp(report.text, expected) != 0) {
        print_error("%s:%d: the report is\n%s\nexpected\n%s\n", file, line, report.text, expected);
        _fail(file, line);
    }
    df_asm_report_free(&report);
}

void source_error(const char *text, const char *part, const char *file, int line)
{
    struct df_asm_report report;
    failing(text, &report, file, line);
    if (report.errors != 1 || strstr(report.text, part) == NULL) {
        print_error("%s:%d: %zu errors:\n%s\nexpected one with\n%s\n", file, line, report.errors,
                    report.text, part);
        _fail(file, line);
    }
    df_asm_report_free(&report);
}

void source_program(const char *text, struct df_program *program)
{
    struct df_asm_report report;
    if (!assemble(text, program, &report)) {
        print_error("does not assemble:\n%s\n%s", text, report.text);
        fail();
    }
    df_asm_report_free(&report);
}

bool source_same(const struct df_program *a, const struct df_program *b)
{
    return a->low == b->low && a->high == b->high && a->entry == b->entry &&
           memcmp(a->words, b->words, DF_MEMORY_BYTES) == 0 &&
           memcmp(a->loaded, b->loaded, DF_MEMORY_BYTES / 2) == 0;
}
