/* Tubes and phosphors from INI files: what is read, and one sentence for everything wrong. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "crt/tube_ini.h"

static char path[64];
static struct crt_catalogue c;
static struct crt_error err;

static void write_bytes(const char *bytes, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, n, f), n);
    assert_int_equal(fclose(f), 0);
}

static bool load(const char *text)
{
    write_bytes(text, strlen(text));
    err.text[0] = 0;
    return crt_catalogue_load(&c, path, &err);
}

static void must_load(const char *text)
{
    if (!load(text))
        fail_msg("%s", err.text);
}

/* Refused at `line`, saying `word`; nothing added. */
static void must_refuse(const char *text, int line, const char *word)
{
    size_t tubes = c.tube_count, phosphors = c.phosphor_count, strings = c.string_count;
    char place[128];
    snprintf(place, sizeof place, "%s:%d: ", path, line);
    if (load(text))
        fail_msg("accepted: %s", text);
    if (strncmp(err.text, place, strlen(place)) != 0 || !strstr(err.text, word) ||
        strchr(err.text, '\n'))
        fail_msg("expected '%s...%s...', got '%s'", place, word, err.text);
    assert_int_equal(c.tube_count, tubes);
    assert_int_equal(c.phosphor_count, phosphors);
    assert_int_equal(c.string_count, strings);
}

static int begin(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/test_tube_ini_XXXXXX");
    int fd = mkstemp(path);
    return fd < 0 || close(fd) != 0 || !crt_catalogue_init(&c, &err);
}

static int end(void **state)
{
    (void)state;
    crt_catalogue_free(&c);
    return remove(path);
}

static void built_in_rows_are_in_the_catalogue(void **state)
{
    (void)state;
    size_t tubes, phosphors;
    crt_tube_rows(&tubes);
    crt_phosphors(&phosphors);
    assert_int_equal(c.tube_count, tubes);
    assert_int_equal(c.phosphor_count, phosphors);
    assert_string_equal(crt_catalogue_tube(&c, "vr14")->name, "VR14");
    assert_string_equal(crt_catalogue_phosphor(&c, "p7")->name, "P7");
    assert_null(crt_catalogue_tube(&c, "P7"));
    assert_null(crt_catalogue_phosphor(&c, ""));
}

static void a_tube_like_another(void **state)
{
    (void)state;
    must_load("; mine\n[tube SHARP]\nlike = VR17\ndescription = sharper\nphosphor = p31\n"
              "spot = 0.4 (0.3..0.5) measured with a microscope,\n   twice ; comment\n"
              "settle = .5\nfetch=1e0 counted\n");
    const struct crt_tube_row *t = crt_catalogue_tube(&c, "sharp"), *v = crt_tube_row_find("VR17");
    assert_non_null(t);
    assert_string_equal(t->name, "SHARP");
    assert_string_equal(t->description, "sharper");
    assert_string_equal(t->phosphor, "p31");
    assert_true(t->spot.value == 0.4 && t->spot.low == 0.3 && t->spot.high == 0.5);
    assert_string_equal(t->spot.source, "measured with a microscope, twice");
    assert_true(t->settle.value == 0.5 && t->settle.low == 0.5 && t->settle.high == 0.5);
    char place[80];
    snprintf(place, sizeof place, "%s:8", path);
    assert_string_equal(t->settle.source, place);
    assert_true(t->fetch.value == 1);
    assert_string_equal(t->fetch.source, "counted");
    assert_true(t->width.value == v->width.value && t->dot.source == v->dot.source);
    /* A second file may build on the first. */
    must_load("[tube SHARPER]\nlike = SHARP\nspot = 0.3\n");
    assert_string_equal(crt_catalogue_tube(&c, "SHARPER")->description, "sharper");
    assert_true(crt_catalogue_tube(&c, "SHARP")->spot.value == 0.4);
}

static void a_tube_of_its_own_needs_every_figure(void **state)
{
    (void)state;
    struct crt_tube_row row = *crt_tube_row_find("LAB31");
    char text[8192];
    int n = snprintf(text, sizeof text, "[tube WHOLE]\nphosphor = MINE\n");
    const char *last = "";
#define X(field, unit, meaning)                                                                    \
    if (crt_tube_has_figure(&row, #field)) {                                                       \
        last = #field;                                                                             \
        n += snprintf(text + n, sizeof text - (size_t)n, "%s = %.17g (%.17g..%.17g) copied\n",     \
                      #field, row.field.value, row.field.low, row.field.high);                     \
    }
    CRT_TUBE_FIGURES(X)
#undef X
    char *cut = strstr(text, last); /* the first mention of the last figure is its own line */
    assert_non_null(cut);
    char without[8192];
    snprintf(without, sizeof without, "%.*s", (int)(cut - text), text);
    must_refuse(without, 1, last);
    n += snprintf(text + n, sizeof text - (size_t)n,
                  "[phosphor MINE]\ncolour1 = 0.2 0.5\nt10 = 1ms\n");
    must_load(text);
    const struct crt_tube_row *t = crt_catalogue_tube(&c, "WHOLE");
#define X(field, unit, meaning)                                                                    \
    assert_true(t->field.value == row.field.value && t->field.low == row.field.low &&              \
                t->field.high == row.field.high);
    CRT_TUBE_FIGURES(X)
#undef X
}

static void a_phosphor_by_rates(void **state)
{
    (void)state;
    must_load(
        "[phosphor GREEN]\nlike = P31\ndescription = green, faster\nletters = XX\npeak = 527\n"
        "luminance = 90\nrate = 0.9 100us\nrate = 0.1 2 ms colour 1\n"
        "tektronix = 0.3ms 4ms 28ms my bench\njedec = 35us..100us TEP116-C\n"
        "source = my bench,\n 2024\nnote = hm\n");
    const struct crt_phosphor *p = crt_catalogue_phosphor(&c, "GREEN");
    assert_non_null(p);
    assert_int_equal(p->terms, 2);
    assert_true(fabs(p->term[0].w - 0.09 / 0.29) < 1e-12);
    assert_true(fabs(p->term[1].w - 0.20 / 0.29) < 1e-12);
    assert_true(fabs(p->term[0].tau_s - 100e-6) < 1e-18 && fabs(p->term[1].tau_s - 2e-3) < 1e-17);
    assert_int_equal(p->made_from, CRT_FROM_USER);
    assert_true(p->peak_nm == 527 && p->relative_luminance == 90 && p->colour[0].x == 0.226);
    assert_true(p->tektronix.t10_s == 0.3e-3 && p->tektronix.t1_s == 4e-3);
    assert_true(p->tektronix.t01_s == 28e-3);
    assert_string_equal(p->tektronix.source, "my bench");
    assert_true(p->jedec.t10_s == 35 * 1e-6 && p->jedec.t10_high_s == 100 * 1e-6);
    assert_true(p->jedec.t1_s == 0);
    assert_string_equal(p->jedec.source, "TEP116-C");
    assert_string_equal(p->source, "my bench, 2024");
    assert_string_equal(p->note, "hm");
}

static void a_phosphor_by_shares_and_colours(void **state)
{
    (void)state;
    must_load("\xef\xbb\xbf[phosphor TWO]\r\ncolour1 = 0.15 0.06\r\ncolour2 = 0.4 0.5\r\n"
              "term = 1 50us colour 1\r\nterm = 3 2s colour 2\r\n"
              "[phosphor ONE]\nlike = P7\nt10 = 2302.585092994046ms\n"
              "[tube ROUND]\nlike = RADAR7\nphosphor = TWO\n");
    const struct crt_phosphor *p = crt_catalogue_phosphor(&c, "two");
    assert_non_null(p);
    assert_true(p->colours == 2 && p->terms == 2);
    assert_true(p->term[0].w == 0.25 && p->term[1].w == 0.75 && p->term[1].colour == 1);
    assert_true(p->source[0] && p->note && !p->note[0] && p->tektronix.source && p->jedec.source);
    p = crt_catalogue_phosphor(&c, "ONE");
    assert_true(p->colours == 1 && p->terms == 1 && fabs(p->term[0].tau_s - 1) < 1e-12);
    assert_string_equal(crt_catalogue_tube(&c, "ROUND")->phosphor, "TWO");
}

static void a_phosphor_of_three_colours(void **state)
{
    (void)state;
    must_load("[phosphor RGB]\ncolour1 = 0.64 0.33\ncolour2 = 0.30 0.60\ncolour3 = 0.15 0.06\n"
              "rate = 7 1ms colour 1\nrate = 9 60us colour 2\nrate = 1 20us colour 3\n"
              "rate = 1 2ms colour 3\n");
    const struct crt_phosphor *p = crt_catalogue_phosphor(&c, "RGB");
    assert_int_equal(p->colours, 3);
    /* The luminance of the sRGB primaries. */
    assert_true(fabs(p->term[0].w - 0.2126390) < 1e-6);
    assert_true(fabs(p->term[1].w - 0.7151687) < 1e-6);
    assert_true(fabs(p->term[2].w / 0.0721923 - 20. / 2020) < 1e-6);
    assert_true(fabs(p->term[3].w / 0.0721923 - 2000. / 2020) < 1e-6);
    /* Fewer colours than `like` when no term has them. */
    must_load("[phosphor RED]\nlike = P22\nt10 = 1ms\n[tube RT]\nlike = MONO12\nphosphor = RED\n");
    assert_int_equal(crt_catalogue_phosphor(&c, "RED")->colours, 1);
}

static void tubes_of_other_kinds(void **state)
{
    (void)state;
    must_load("[tube MYMONITOR]\nlike = COLOR17\nmask = grille\nmode = 800x600@75\n"
              "mask_pitch = 0.26\n"
              "[tube PLAIN]\nlike = COLOR17\nmask = none\nphosphor = P31\nspot = 0.4\n"
              "[tube STRANGE]\nlike = PLAIN\nkind = vector\nphosphor = P31\nunits_x = 1024\n"
              "units_y = 768\ndrive_low = 0.4\nline_luminance = 100\nline_speed = 3\n"
              "line_refresh = 60\nsync = 60\nfetch = 1\nvector_setup = 1\nvector_unit = 0.1\n"
              "vector_rest = 0\nsettle = 1\nsettle_unit = 0\nsettle_max = 9\npoint = 1\n"
              "character = 9\ndot = .1\nintensify = 20\n");
    const struct crt_tube_row *t = crt_catalogue_tube(&c, "MYMONITOR");
    assert_true(t->kind == CRT_RASTER_TUBE && t->mask == CRT_MASK_GRILLE);
    assert_true(t->mask_pitch.value == 0.26 && t->mask_transmission.value == 0.2);
    assert_string_equal(t->mode, "800x600@75");
    t = crt_catalogue_tube(&c, "PLAIN");
    assert_true(t->mask == CRT_MASK_NONE && !t->mask_pitch.source && t->mask_pitch.value == 0);
    assert_true(t->spot_edge.value == 1.25 && t->spot_edge.source);
    t = crt_catalogue_tube(&c, "STRANGE");
    assert_true(t->kind == CRT_VECTOR_TUBE && !t->mode[0] && !t->bandwidth.source);
    assert_true(t->units_x.value == 1024 && t->spot.value == 0.4);
}

/* The example of crt/tube_ini.h, literally. */
static void the_example_of_the_header(void **state)
{
    (void)state;
    must_load(
        "; a comment, alone or after a blank at the end of a line\n"
        "[phosphor MYGREEN]\n"
        "like = P31                        ; first key; optional: start from a row that exists\n"
        "description = green, faster\n"
        "letters = GH                      ; world-wide designation\n"
        "peak = 525                        ; nm\n"
        "luminance = 90                    ; relative, P31 = 100\n"
        "colour1 = 0.226 0.528             ; CIE 1931 x y; colour2, colour3 for more\n"
        "rate = 0.949 0.1ms                ; amplitude of the light, time constant: a line a term\n"
        "rate = 0.051 2ms\n"
        "tektronix = 0.3ms 4ms 28ms my bench, 2024     ; published times to 10, 1, 0.1 %, source\n"
        "jedec = 35us..100us TEP116-C                  ; to 10 % as a range\n"
        "source = my bench, 2024                       ; of colour and terms\n"
        "note = anything worth knowing,\n"
        "    continued on a line that begins with a blank\n"
        "\n"
        "[tube MYTUBE]\n"
        "like = VR17\n"
        "description = a sharper VR17 with my phosphor\n"
        "phosphor = MYGREEN\n"
        "spot = 0.4 (0.3..0.5) measured with a microscope\n"
        "settle = 0.5\n"
        "\n"
        "[tube MYMONITOR]\n"
        "like = COLOR17\n"
        "mask = grille                     ; before any figure, as it says which figures there "
        "are\n"
        "mode = 800x600@75\n"
        "mask_pitch = 0.26\n");
    assert_true(crt_catalogue_tube(&c, "MYMONITOR")->mask == CRT_MASK_GRILLE);
    const struct crt_tube_row *t = crt_catalogue_tube(&c, "MYTUBE");
    const struct crt_phosphor *p = crt_catalogue_phosphor(&c, t->phosphor);
    assert_true(t->spot.value == 0.4 && t->settle.value == 0.5);
    assert_true(p->terms == 2 && p->peak_nm == 525 && p->relative_luminance == 90);
    assert_string_equal(p->description, "green, faster");
    assert_string_equal(p->jedec.source, "TEP116-C");
    assert_string_equal(p->note,
                        "anything worth knowing, continued on a line that begins with a blank");
}

static void wrong_tubes(void **state)
{
    (void)state;
#define T "[tube A]\nlike = VR17\n"
    must_refuse("", 0, "no section");
    must_refuse("; nothing\n\n", 2, "no section");
    must_refuse("spot = 1\n", 1, "before any section");
    must_refuse("[tub A]\nlike = VR17\n", 1, "[tube NAME]");
    must_refuse("[tube]\nlike = VR17\n", 1, "[tube NAME]");
    must_refuse("[tube A B]\nlike = VR17\n", 1, "[tube NAME]");
    must_refuse("[tube a234567890123456789012345]\nlike = VR17\n", 1, "[tube NAME]");
    must_refuse("[tube vr17]\nlike = VR14\n", 1, "already");
    must_refuse(T "[tube A]\nlike = VR14\n", 3, "already");
    must_refuse("[tube A]\nlike = VR99\n", 2, "VR99");
    must_refuse("[tube A]\nlike = A\n", 2, "no tube");
    must_refuse("[tube A]\nspot = 1\nlike = VR17\n", 3, "first key");
    must_refuse("[tube A]\nspot = 1\n", 1, "lacks width");
    must_refuse("[tube A]\n", 1, "empty");
    must_refuse("[tube A]\n[tube B]\nlike = VR17\n", 2, "empty");
    must_refuse("[tube A\nlike = VR17\n", 1, "not understood");
    must_refuse(T "spot\n", 3, "not understood");
    must_refuse(T "spot =\n", 3, "no value");
    must_refuse(T "spots = 1\n", 3, "spots");
    must_refuse(T "spot = 0.4\nspot = 0.4\n", 4, "twice");
    must_refuse(T "spot = nan\n", 3, "expected a number");
    must_refuse(T "spot = inf\n", 3, "expected a number");
    must_refuse(T "spot = 1e999\n", 3, "expected a number");
    must_refuse(T "spot = 0x10\n", 3, "expected a number");
    must_refuse(T "spot = 0.4mm\n", 3, "expected a number");
    must_refuse(T "spot = -0.4\n", 3, "between");
    must_refuse(T "spot = 0\n", 3, "between");
    must_refuse(T "spot = 0.4 (0.5..0.6)\n", 3, "contain");
    must_refuse(T "spot = 0.4 (0.3-0.6)\n", 3, "range");
    must_refuse(T "spot = 0.4 (0.3..0.6\n", 3, "range");
    must_refuse(T "spot = 0.002\n", 1, "cells");
    must_refuse(T "width = 1e300\n", 3, "between");
    must_refuse(T "units_x = 1000.5\n", 1, "whole");
    must_refuse(T "fetch = 0\n", 3, "between");
    must_refuse(T "phosphor = P99\n", 3, "P99");
    must_refuse(T "phosphor = P999999999999999\n", 3, "at most 15");
    must_refuse(T "field_luminance = 100\n", 3, "another kind of tube");
    must_refuse(T "mask = delta\n", 3, "no mask");
    must_refuse(T "mode = 640x480@60\n", 3, "no mode");
    must_refuse(T "kind = rastr\n", 3, "vector or raster");
    must_refuse(T "penetration = maybe\n", 3, "yes or no");
    must_refuse(T "spot = 0.4\nkind = raster\n", 4, "before any figure");
    must_refuse(T "kind = raster\n", 1, "lacks field_luminance");
    must_refuse(T "penetration = yes\n", 1, "lacks kv_red");
    must_refuse("[tube A]\nlike = MONO12\nline_luminance = 100\n", 3, "another kind of tube");
    must_refuse("[tube A]\nlike = MONO12\nmask_pitch = 0.3\n", 3, "another kind of tube");
    must_refuse("[tube A]\nlike = MONO12\nmask = dots\n", 3, "delta, slot or grille");
    must_refuse("[tube A]\nlike = MONO12\npenetration = yes\n", 3, "kind = vector");
    must_refuse("[tube A]\nlike = MONO12\nmask = slot\n", 1, "lacks mask_pitch");
    must_refuse("[tube A]\nlike = COLOR17\nh_max = 20\n", 1, "h_max must be the higher");
    must_refuse("[tube A]\nlike = COLOR17\nmask_pitch = 2\n", 1, "half as wide");
    must_refuse("[tube A]\nlike = COLOR17\nphosphor = P4\n", 3, "three colours");
    must_refuse("[tube A]\nlike = COLOR17\nmode = 1234567890123456789012345\n", 3, "at most 23");
    must_refuse(T "  spot = 0.4\n", 3, "first column");
    must_refuse(T "spot = 0.4 text\n  halation = 0.1\n", 4, "first column");
    must_refuse(T " [tube B]\nlike = VR17\n", 3, "first column");
    must_refuse(T "spot = 0.4 \x1b[2J\n", 3, "control");
#undef T
}

static void wrong_phosphors(void **state)
{
    (void)state;
#define P "[phosphor A]\nlike = P31\n"
    must_refuse("[phosphor P31]\nlike = P1\n", 1, "already");
    must_refuse("[phosphor a23456789012345678]\nlike = P1\n", 1, "[phosphor NAME]");
    must_refuse("[phosphor A]\nnote = x\n", 1, "no colour");
    must_refuse("[phosphor A]\ncolour1 = 0.3 0.3\n", 1, "does not fade");
    must_refuse("[phosphor A]\nrate = 1 1ms\ncolour2 = 0.3 0.3\n", 1, "colour 1");
    must_refuse(P "colour1 = 0.3\n", 3, "CIE");
    must_refuse(P "colour1 = 0.3 0.3 0.4\n", 3, "CIE");
    must_refuse(P "colour1 = 0.8 0.3\n", 3, "x + y");
    must_refuse(P "colour1 = 0.3 0\n", 3, "x + y");
    must_refuse(P "colour4 = 0.3 0.3\n", 3, "colour4");
    must_refuse(P "colour3 = 0.3 0.3\n", 1, "no term has colour 2");
    must_refuse("[phosphor A]\ncolour1 = .6 .3\ncolour2 = .5 .4\ncolour3 = .4 .5\nrate = 1 1ms\n"
                "rate = 1 1ms colour 2\nrate = 1 1ms colour 3\n",
                1, "do not mix to white");
    must_refuse(P "colour2 = 0.3 0.3\n", 1, "no term has colour 2");
    must_refuse(P "rate = 1\n", 3, "unit");
    must_refuse(P "rate = 1 2\n", 3, "unit");
    must_refuse(P "rate = 1 2 mm\n", 3, "unit");
    must_refuse(P "rate = 1 2ms red\n", 3, "colour");
    must_refuse(P "rate = -1 2ms\n", 3, "positive");
    must_refuse(P "rate = 1 0ms\n", 3, "positive");
    must_refuse(P "rate = 1 1e9s\n", 3, "10000 s");
    must_refuse(P "rate = 1 2ms colour 4\n", 3, "1, 2 or 3");
    must_refuse(P "rate = 1 2ms colour 1.5\n", 3, "1, 2 or 3");
    must_refuse(P "rate = 1 2ms\nrate = 1 2ms colour 3\n", 1, "colour3 = x y");
    must_refuse(P "rate = 1 2ms colour 2\n", 1, "no term has colour 1");
    must_refuse(P "rate = 1 2ms\nterm = 1 2ms\n", 4, "two ways");
    must_refuse(P "rate = 1 2ms\nt10 = 2ms\n", 4, "beside");
    must_refuse(P "t10 = 2ms\nrate = 1 2ms\n", 4, "beside");
    must_refuse(P "rate = 1e12 2ms\nrate = 1e-9 1us\n", 1, "1e-12");
    must_refuse(P "t10 = 150\n", 3, "unit");
    must_refuse(P "jedec = soon\n", 3, "times");
    must_refuse(P "tektronix = 3ms 2ms 4ms\n", 3, "longer");
    must_refuse(P "jedec = 3ms..2ms\n", 3, "longer");
    must_refuse(P "peak = 20\n", 3, "300");
    must_refuse(P "letters = ABCDEFGHI\n", 3, "at most 7");
    char many[1024] = P;
    for (int i = 0; i <= CRT_MAX_TERMS; i++)
        strcat(many, "rate = 1 1ms\n");
    must_refuse(many, 3 + CRT_MAX_TERMS, "one term too many");
#undef P
    must_refuse("[tube GOOD]\nlike = VR17\n[phosphor BAD]\nlike = P77\n", 4, "P77");
    assert_null(crt_catalogue_tube(&c, "GOOD"));
}

static void hostile_files(void **state)
{
    (void)state;
    char line[400] = "[tube A]\nlike = VR17\ndescription = ";
    memset(line + strlen(line), 'x', 300);
    must_refuse(line, 3, "bytes long");
    static char note[4000] = "[phosphor A]\nlike = P1\nnote = a\n";
    for (int i = 0; i < 40; i++)
        strcat(note, " 0123456789 0123456789 0123456789 0123456789\n");
    must_refuse(note, 26, "too long");
    write_bytes("[tube A]\nlike\0 = VR17\n", 22);
    assert_false(crt_catalogue_load(&c, path, &err));
    assert_non_null(strstr(err.text, ":2: "));
    char *big = calloc(1, 3 << 20);
    assert_non_null(big);
    memset(big, '\n', 3 << 20);
    write_bytes(big, 3 << 20);
    free(big);
    assert_false(crt_catalogue_load(&c, path, &err));
    assert_non_null(strstr(err.text, "1 MiB"));
    assert_false(crt_catalogue_load(&c, "/nonexistent/tubes.ini", &err));
    assert_non_null(strstr(err.text, "/nonexistent/tubes.ini"));
    assert_false(crt_catalogue_load(&c, "/", &err));
    assert_true(strlen(err.text) > 10);
}

/* Random damage to a good file: loads or refuses with a sentence, never more than that. */
static void damaged_files(void **state)
{
    (void)state;
    static const char good[] =
        "[phosphor Q]\nlike = P4\nrate = 0.9 100us colour 1\nrate = 0.1 2ms "
        "colour 2\njedec = 35us..100us x\nnote = a\n b\n[tube Z]\nlike = "
        "VR17\nphosphor = Q\nspot = 0.4 (0.3..0.5) m\n n\nfetch = 1\n[tube M]\n"
        "like = COLOR17\nmask = slot\nmode = 525/60i\nspot_edge = 1.2\n";
    uint64_t s = 9;
    int loaded = 0, refused = 0;
    for (int i = 0; i < 1000; i++) {
        char text[sizeof good];
        memcpy(text, good, sizeof good);
        for (int k = 0; k < 1 + i % 3; k++) {
            s = s * UINT64_C(6364136223846793005) + 1442695040888963407u;
            text[(s >> 33) % (sizeof good - 1)] =
                (s >> 20 & 3) ? " =[].0;\n"[s >> 40 & 7] : (char)(s >> 48);
        }
        struct crt_catalogue fresh;
        assert_true(crt_catalogue_init(&fresh, &err));
        write_bytes(text, sizeof good - 1);
        err.text[0] = 0;
        if (crt_catalogue_load(&fresh, path, &err)) {
            loaded++;
            for (size_t t = 0; t < fresh.tube_count; t++)
                assert_true(crt_tube_check(&fresh.tubes[t], &err));
        } else {
            refused++;
            assert_true(strncmp(err.text, path, strlen(path)) == 0);
        }
        crt_catalogue_free(&fresh);
    }
    assert_true(loaded > 20 && refused > 20);
}

int main(void)
{
#define EACH(test) cmocka_unit_test_setup_teardown(test, begin, end)
    const struct CMUnitTest tests[] = {
        EACH(built_in_rows_are_in_the_catalogue),
        EACH(a_tube_like_another),
        EACH(a_tube_of_its_own_needs_every_figure),
        EACH(a_phosphor_by_rates),
        EACH(a_phosphor_by_shares_and_colours),
        EACH(a_phosphor_of_three_colours),
        EACH(tubes_of_other_kinds),
        EACH(the_example_of_the_header),
        EACH(wrong_tubes),
        EACH(wrong_phosphors),
        EACH(hostile_files),
        EACH(damaged_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
