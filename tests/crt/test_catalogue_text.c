/* The text tables: complete, within 100 columns, with the figures they are about. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/catalogue_text.h"

static struct crt_catalogue c;
static char *text;

static int begin(void **state)
{
    (void)state;
    struct crt_error err;
    return !crt_catalogue_init(&c, &err);
}

static int end(void **state)
{
    (void)state;
    crt_catalogue_free(&c);
    free(text);
    text = NULL;
    return 0;
}

static void capture(void (*list)(FILE *, const struct crt_catalogue *, bool), bool why)
{
    size_t size;
    FILE *f = open_memstream(&text, &size);
    assert_non_null(f);
    list(f, &c, why);
    assert_int_equal(fclose(f), 0);
    for (const char *line = text; *line;) {
        const char *newline = strchr(line, '\n');
        assert_non_null(newline);
        int columns = 0;
        for (const char *p = line; p < newline; p++)
            columns += ((unsigned char)*p & 0xc0) != 0x80;
        if (columns > 100 || (newline > line && newline[-1] == ' '))
            fail_msg("%d columns or blanks at the end: '%.*s'", columns, (int)(newline - line),
                     line);
        line = newline + 1;
    }
}

/* Whether `needle` occurs when runs of blanks and line ends count as one blank. */
static void must_say(const char *needle)
{
    for (const char *start = text; *start; start++) {
        const char *p = start, *n = needle;
        while (*n && *p) {
            if (*n == ' ' && (*p == ' ' || *p == '\n')) {
                p += strspn(p, " \n");
                n++;
            } else if (*n == *p) {
                n++;
                p++;
            } else {
                break;
            }
        }
        if (!*n)
            return;
    }
    fail_msg("does not say '%s'", needle);
}

static void tubes_briefly(void **state)
{
    (void)state;
    capture(crt_list_tubes, false);
    for (size_t i = 0; i < c.tube_count; i++) {
        must_say(c.tubes[i].name);
        must_say(c.tubes[i].description);
    }
    must_say("VR17 P39 234.9 x 234.9 1024 x 1024 0.508 100 DEC VR17");
    must_say("COLOR17 P22 320 x 240 delta 0.28 1024x768@60 30-70 0.445 100 17 inch colour");
    must_say("TV12M P4 244 x 183 none 525/60i 15-17 0.7 120 12 inch monochrome");
    /* Each kind in its own table. */
    const char *raster = strstr(text, "Raster tubes");
    assert_true(strstr(text, "\nTYPE30 ") < raster && strstr(text, "\nCOLOR17 ") > raster);
}

static void tubes_with_reasons(void **state)
{
    (void)state;
    capture(crt_list_tubes, true);
#define X(field, unit, meaning)                                                                    \
    must_say(#field " " meaning);                                                                  \
    for (size_t i = 0; i < c.tube_count; i++)                                                      \
        if (crt_tube_has_figure(&c.tubes[i], #field))                                              \
            must_say(c.tubes[i].field.source);
    CRT_TUBE_FIGURES(X)
#undef X
    must_say("spot 0.508 mm 0.4318..0.5588 DEC EK-VT11-TM-001");
    must_say("COLOR17 17 inch colour monitor with 16 inch to see, delta triads "
             "raster tube, three guns, delta mask, used in 1024x768@60 phosphor P22; film of");
    must_say("three guns, grille, used in 1280x1024@60");
    must_say("raster tube, one gun, used in 525/60i");
    must_say("vector_unit 0.1 us 0.05..0.2 estimate: no primary source at hand");
}

static void phosphors_briefly(void **state)
{
    (void)state;
    capture(crt_list_phosphors, false);
    for (size_t i = 0; i < c.phosphor_count; i++) {
        must_say(c.phosphors[i].name);
        must_say(c.phosphors[i].description);
    }
    must_say("P39 GR 0.223 0.698 150 ms 450 ms 0.081 JEDEC green");
}

static void phosphors_with_reasons(void **state)
{
    (void)state;
    capture(crt_list_phosphors, true);
    for (size_t i = 0; i < c.phosphor_count; i++) {
        const struct crt_phosphor *p = &c.phosphors[i];
        must_say(p->source);
        must_say(p->note);
        must_say(p->tektronix.source);
        must_say(p->jedec.source);
    }
    must_say("JEDEC 35 us..100 us - - JEDEC TEP116-C");
    must_say("Tektronix 340 us 4.5 ms 32 ms Tektronix phosphor decay table, 1966");
    must_say("this model 340 us 4.5 ms 32 ms made from Tektronix");
    must_say("Tektronix - - - not published");
    must_say("21.055 % of the light, time constant 108 us, colour 1");
    must_say("C1 = 1.188");
}

static void times_have_three_digits_and_a_unit(void **state)
{
    (void)state;
    static const struct {
        double seconds;
        const char *text;
    } want[] = {{0, "-"},           {-1, "-"},
                {5e-12, "5 ps"},    {22.7e-9, "22.7 ns"},
                {38e-6, "38 us"},   {999.4e-6, "999 us"},
                {999.6e-6, "1 ms"}, {0.1324, "132 ms"},
                {0.9999, "1 s"},    {2.2, "2.2 s"},
                {12345, "12345 s"}};
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        char got[32];
        crt_time_text(got, sizeof got, want[i].seconds);
        assert_string_equal(got, want[i].text);
    }
}

int main(void)
{
#define EACH(test) cmocka_unit_test_setup_teardown(test, begin, end)
    const struct CMUnitTest tests[] = {
        EACH(tubes_briefly),
        EACH(tubes_with_reasons),
        EACH(phosphors_briefly),
        EACH(phosphors_with_reasons),
        EACH(times_have_three_digits_and_a_unit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
