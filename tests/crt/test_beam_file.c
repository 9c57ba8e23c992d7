/* The .beam format: exact round trips, numbers compared with strtof, and a sentence with file and
 * line for everything that is not one. */
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/beam_file.h"
#include "crt/number_text.h"

static uint32_t bits_of(float f)
{
    uint32_t bits;
    memcpy(&bits, &f, sizeof bits);
    return bits;
}

static float float_of(uint32_t bits)
{
    float f;
    memcpy(&f, &bits, sizeof f);
    return f;
}

static void floats_read_back_to_the_same_bits(void **state)
{
    (void)state;
    uint32_t seed = 1;
    for (int i = 0; i < 300000; i++) {
        seed = seed * 1664525u + 1013904223u;
        uint32_t bits = i < 4000 ? (uint32_t)i * 1073741u : seed ^ seed >> 15;
        float in = float_of(bits), out = -1.0f;
        if (!isfinite(in))
            continue;
        char text[CRT_FLOAT_TEXT], plain[64];
        crt_float_write(text, in);
        snprintf(plain, sizeof plain, "%.9g", (double)in);
        assert_string_equal(text, plain);
        assert_true(crt_float_read(text, &out));
        assert_int_equal(bits_of(out), bits_of(in));
    }
}

static void floats_are_read_as_strtof_reads_them(void **state)
{
    (void)state;
    const char *const good[] = {"0",
                                "-0",
                                "+1",
                                "1.",
                                ".5",
                                "-.5e1",
                                "1e5",
                                "1E-5",
                                "1e+05",
                                "00012.5",
                                "3.4028234e38",
                                "1e-45",
                                "1e-60",
                                "0e999999999",
                                "0.1",
                                "16777217",
                                "123456789012345678901234567890",
                                "0.000000000000000000000000000001",
                                "1e-99999",
                                "2.5e-7",
                                "9.99999999",
                                "100000000000000000000e-20"};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        float got = -1.0f, expected = strtof(good[i], NULL);
        assert_true(crt_float_read(good[i], &got));
        if (bits_of(got) != bits_of(expected))
            fail_msg("%s read as %.9g", good[i], (double)got);
    }
    const char *const bad[] = {"",
                               "-",
                               ".",
                               "e5",
                               "1e",
                               "1e+",
                               "1.2.3",
                               "nan",
                               "inf",
                               "-inf",
                               "0x10",
                               "1e39",
                               "1e99999999999999999999",
                               "1 ",
                               " 1",
                               "1,5",
                               "--1",
                               "1f",
                               "3.41e38",
                               "1e5.0",
                               "+-1"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        float got = 77.0f;
        if (crt_float_read(bad[i], &got))
            fail_msg("`%s` was taken for %.9g", bad[i], (double)got);
        assert_true(got == 77.0f);
    }
}

static void whole_numbers_are_read_whole(void **state)
{
    (void)state;
    uint64_t n = 5;
    assert_true(crt_decimal_read("18446744073709551615", &n) && n == UINT64_MAX);
    assert_false(crt_decimal_read("18446744073709551616", &n));
    assert_false(crt_decimal_read("-1", &n));
    assert_false(crt_decimal_read("", &n));
    assert_false(crt_decimal_read("1 ", &n));
    uint32_t o = 5;
    assert_true(crt_octal_read("37777777777", &o) && o == UINT32_MAX);
    assert_false(crt_octal_read("40000000000", &o));
    assert_false(crt_octal_read("8", &o));
    assert_false(crt_octal_read("", &o));
}

static struct crt_beam_reader *open_text(const char *text, struct crt_beam_header *header,
                                         struct crt_error *err)
{
    FILE *in = tmpfile();
    fwrite(text, 1, strlen(text), in);
    rewind(in);
    return crt_beam_open_stream(in, "f.beam", header, err);
}

static void a_recording_survives_a_round_trip(void **state)
{
    (void)state;
    enum { COUNT = 2000 };
    static struct crt_stroke strokes[COUNT];
    uint64_t t = 0;
    srand(5);
    for (int i = 0; i < COUNT; i++) {
        struct crt_stroke *s = &strokes[i];
        s->t0 = t + (uint64_t)(rand() % 2 * (rand() % 1000000));
        s->t1 = t = s->t0 + 1 + (uint64_t)rand();
        float *const p[4] = {&s->x0, &s->y0, &s->x1, &s->y1};
        for (int k = 0; k < 4; k++)
            *p[k] = ((float)rand() / (float)RAND_MAX - 0.5f) * 300.0f;
        s->drive = (float)rand() / (float)RAND_MAX;
        s->source = (uint32_t)rand() & 0x3fffe;
        s->level = (uint32_t)i % (CRT_LEVEL_GREEN + 1);
    }
    struct crt_beam_header header = {"VR17", "P39", {60000, 1001}, 0}, got;
    FILE *file = tmpfile();
    crt_beam_write_header(file, &header);
    for (int i = 0; i < COUNT; i++)
        crt_beam_write_stroke(file, &strokes[i]);
    crt_beam_write_end(file, 516666666666);
    rewind(file);
    struct crt_error err = {""};
    struct crt_stroke s;
    struct crt_beam_reader *reader = crt_beam_open_stream(file, "f.beam", &got, &err);
    assert_non_null(reader);
    assert_string_equal(got.tube, "VR17");
    assert_string_equal(got.phosphor, "P39");
    assert_int_equal(got.tick.num, 60000);
    assert_int_equal(got.tick.den, 1001);
    assert_int_equal(got.end, 0);
    for (int i = 0; i < COUNT; i++) {
        assert_int_equal(crt_beam_next(reader, &s, &err), 1);
        assert_memory_equal(&s, &strokes[i], sizeof s);
    }
    assert_int_equal(crt_beam_end(reader), 0);
    assert_int_equal(crt_beam_next(reader, &s, &err), 0);
    assert_int_equal(crt_beam_next(reader, &s, &err), 0);
    assert_int_equal(crt_beam_end(reader), 516666666666);
    crt_beam_close(reader);
}

#define HEADER "beam 1\ntube VR17\ntick 60/1\n"

static void the_text_may_be_loosely_laid_out(void **state)
{
    (void)state;
    const char text[] = "# made by hand\r\n\n  beam\t1 # version\r\nphosphor P31\r\nend 99\r\n"
                        "tick 50\ntube  Type-30   \n\n"
                        "\ts 0 1 0 0 0 0 1\n#s 5 6 bad\n s 1 2 -1.5 2e1 .5 +3 0.25 177776 # last";
    struct crt_beam_header header;
    struct crt_error err = {""};
    struct crt_stroke s;
    struct crt_beam_reader *reader = open_text(text, &header, &err);
    if (!reader)
        fail_msg("%s", err.text);
    assert_string_equal(header.tube, "Type-30");
    assert_string_equal(header.phosphor, "P31");
    assert_int_equal(header.tick.num, 50);
    assert_int_equal(header.tick.den, 1);
    assert_int_equal(header.end, 99);
    assert_int_equal(crt_beam_end(reader), 99);
    assert_int_equal(crt_beam_next(reader, &s, &err), 1);
    assert_true(s.t0 == 0 && s.t1 == 1 && s.drive == 1.0f && s.source == 0);
    assert_int_equal(crt_beam_next(reader, &s, &err), 1);
    assert_true(s.x0 == -1.5f && s.y0 == 20.0f && s.x1 == 0.5f && s.y1 == 3.0f);
    assert_true(s.drive == 0.25f && s.source == 0177776);
    assert_int_equal(crt_beam_next(reader, &s, &err), 0);
    crt_beam_close(reader);
    /* No strokes at all is a recording too. */
    reader = open_text(HEADER, &header, &err);
    assert_non_null(reader);
    assert_string_equal(header.phosphor, "");
    assert_int_equal(crt_beam_next(reader, &s, &err), 0);
    crt_beam_close(reader);
}

/* Reads to the end; the sentence must begin with `place` and contain `what`. */
static void expect_refused(const char *text, const char *place, const char *what)
{
    struct crt_beam_header header;
    struct crt_error err = {""};
    struct crt_stroke s;
    struct crt_beam_reader *reader = open_text(text, &header, &err);
    int got = reader ? 1 : -1;
    while (got > 0)
        got = crt_beam_next(reader, &s, &err);
    if (got == 0)
        fail_msg("accepted: %s", text);
    if (strncmp(err.text, place, strlen(place)) != 0 || !strstr(err.text, what))
        fail_msg("%s gave: %s", text, err.text);
    if (reader) /* and it stays refused */
        assert_int_equal(crt_beam_next(reader, &s, &err), -1);
    crt_beam_close(reader);
}

static void bad_headers_are_refused(void **state)
{
    (void)state;
    expect_refused("", "f.beam:1: ", "is empty");
    expect_refused("# only this\n", "f.beam:2: ", "is empty");
    expect_refused("s 0 1 0 0 0 0 1\n", "f.beam:1: ", "first line must be `beam 1`");
    expect_refused("tube VR17\nbeam 1\n", "f.beam:1: ", "first line");
    expect_refused("beam 2\n", "f.beam:1: ", "version `2`");
    expect_refused("beam\n", "f.beam:1: ", "first line");
    expect_refused("beam 1\ntick 60\n", "f.beam:3: ", "no `tube` line");
    expect_refused("beam 1\ntube A\ns 0 1 0 0 0 0 1\n", "f.beam:3: ", "no `tick` line");
    expect_refused("beam 1\ntube A B\n", "f.beam:2: ", "one name");
    expect_refused("beam 1\ntube A\ntube B\n", "f.beam:3: ", "second `tube`");
    expect_refused("beam 1\ntube ABCDEFGHIJKLMNOPQRSTUVWX\n", "f.beam:2: ", "too long");
    expect_refused("beam 1\nphosphor ABCDEFGHIJKLMNOP\n", "f.beam:2: ", "too long");
    expect_refused("beam 1\nphosphor P1\nphosphor P1\n", "f.beam:3: ", "second `phosphor`");
    expect_refused("beam 1\nbeam 1\n", "f.beam:2: ", "`beam` is not known");
    expect_refused("beam 1\ncolour 7\n", "f.beam:2: ", "`colour` is not known");
    const char *const ticks[] = {"",       "0",   "60/0", "-60",        "60/",    "/1",
                                 "60/1/1", "1e3", "60 1", "1000000001", "1/9999", "1000000000/1",
                                 "6O"};
    for (size_t i = 0; i < sizeof ticks / sizeof ticks[0]; i++) {
        char text[100];
        snprintf(text, sizeof text, "beam 1\ntick %s\n", ticks[i]);
        expect_refused(text, "f.beam:2: ", "`tick`");
    }
    expect_refused("beam 1\ntick 60\ntick 60\n", "f.beam:3: ", "second `tick`");
    expect_refused("beam 1\nend 0\n", "f.beam:2: ", "whole picoseconds");
    expect_refused("beam 1\nend -5\n", "f.beam:2: ", "whole picoseconds");
    expect_refused("beam 1\nend\n", "f.beam:2: ", "whole picoseconds");
    expect_refused(HEADER "end 5\nend 6\n", "f.beam:5: ", "second `end`");
    expect_refused(HEADER "end 5\ns 0 1 0 0 0 0 1\nend 6\n", "f.beam:6: ", "second `end`");
}

static void bad_strokes_are_refused(void **state)
{
    (void)state;
    const struct {
        const char *line, *what;
    } cases[] = {
        {"s", "a stroke is `s T0"},
        {"s 0 1 0 0 0 0", "a stroke is"},
        {"s 0 1 0 0 0 0 1 0 0", "`0` is not a level"},
        {"s 0 1 0 0 0 0 1 0 blue", "`blue` is not a level"},
        {"s 0 1 0 0 0 0 1 0 only", "`only` is not a level"},
        {"s 0 1 0 0 0 0 1 red", "octal"},
        {"s 0 1 0 0 0 0 1 0 red 0", "too many fields"},
        {"s 0 1 0 0 0 0 1 0 0 0 0", "too many fields"},
        {"s -1 1 0 0 0 0 1", "whole picoseconds"},
        {"s 0 1.5 0 0 0 0 1", "whole picoseconds"},
        {"s 0 18446744073709551616 0 0 0 0 1", "whole picoseconds"},
        {"s 5 5 0 0 0 0 1", "not after it begins at 5"},
        {"s 9 5 0 0 0 0 1", "the stroke ends at 5"},
        {"s 0 1 nan 0 0 0 1", "`nan` is not a position"},
        {"s 0 1 0 inf 0 0 1", "`inf` is not a position"},
        {"s 0 1 0 0 1e39 0 1", "`1e39` is not a position"},
        {"s 0 1 0 0 0 -10001 1", "within 10000 mm"},
        {"s 0 1 0 0 0 0x5 1", "not a position"},
        {"s 0 1 0 0 0 0 1.001", "drive from 0 to 1"},
        {"s 0 1 0 0 0 0 -0.1", "drive from 0 to 1"},
        {"s 0 1 0 0 0 0 full", "drive from 0 to 1"},
        {"s 0 1 0 0 0 0 1 8", "octal"},
        {"s 0 1 0 0 0 0 1 77777777777", "octal"},
        {"tube VR17", "expected s or end"},
        {"S 0 1 0 0 0 0 1", "`S`"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[300];
        snprintf(text, sizeof text, HEADER "s 0 0 0 0 0 0 1\n"); /* a stroke of no length */
        expect_refused(text, "f.beam:4: ", "not after");
        snprintf(text, sizeof text, HEADER "# next\n%s\n", cases[i].line);
        if (strchr("tS", cases[i].line[0])) /* a header word needs a stroke before it to be wrong */
            snprintf(text, sizeof text, HEADER "s 0 1 0 0 0 0 1\n%s\n", cases[i].line);
        expect_refused(text, "f.beam:5: ", cases[i].what);
    }
    expect_refused(HEADER "s 0 9 0 0 0 0 1\ns 8 10 0 0 0 0 1\n",
                   "f.beam:5: ", "before the one above");
    expect_refused(HEADER "s 5 9 0 0 0 0 1\ns 0 1 0 0 0 0 1\n",
                   "f.beam:5: ", "before the one above");
}

static void bad_bytes_are_refused(void **state)
{
    (void)state;
    char text[600] = HEADER "#";
    memset(text + strlen(text), 'x', 254);
    strcat(text, "\n");
    struct crt_beam_header header;
    struct crt_error err = {""};
    struct crt_beam_reader *reader = open_text(text, &header, &err); /* 255 characters will do */
    assert_non_null(reader);
    crt_beam_close(reader);
    strcpy(text + strlen(text) - 1, "x\n");
    expect_refused(text, "f.beam:4: ", "more than 255 characters");
    expect_refused(HEADER "s 0 1 0 0\001 0 0 1\n", "f.beam:4: ", "control character 1");
    expect_refused("beam 1\ntube A\r\r\n", "f.beam:2: ", "control character 13");
    FILE *in = tmpfile();
    fwrite("beam 1\0\n", 1, 8, in);
    rewind(in);
    assert_null(crt_beam_open_stream(in, "f.beam", &header, &err));
    assert_string_equal(err.text,
                        "f.beam:1: control character 0 in the line; is this a .beam file?");
    assert_null(crt_beam_open("/nonexistent.beam", &header, &err));
    assert_string_equal(err.text, "/nonexistent.beam: cannot open it: No such file or directory");
    assert_null(crt_beam_open("/", &header, &err));
    assert_non_null(strstr(err.text, "Is a directory"));
}

/* With a decimal comma where the host has such a locale, else in whatever it has. */
static void the_locale_does_not_matter(void **state)
{
    (void)state;
    const char *const names[] = {"de_DE.UTF-8", "fr_FR.UTF-8", "sv_SE.UTF-8", "de_DE", ""};
    const char *set = NULL;
    for (size_t i = 0; i < sizeof names / sizeof names[0] && !set; i++)
        set = setlocale(LC_NUMERIC, names[i]);
    char text[CRT_FLOAT_TEXT];
    float got = 0.0f;
    crt_float_write(text, -1.5f);
    bool ok = crt_float_read("-1.5", &got);
    setlocale(LC_NUMERIC, "C");
    assert_string_equal(text, "-1.5");
    assert_true(ok && got == -1.5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floats_read_back_to_the_same_bits),
        cmocka_unit_test(floats_are_read_as_strtof_reads_them),
        cmocka_unit_test(whole_numbers_are_read_whole),
        cmocka_unit_test(a_recording_survives_a_round_trip),
        cmocka_unit_test(the_text_may_be_loosely_laid_out),
        cmocka_unit_test(bad_headers_are_refused),
        cmocka_unit_test(bad_strokes_are_refused),
        cmocka_unit_test(bad_bytes_are_refused),
        cmocka_unit_test(the_locale_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
