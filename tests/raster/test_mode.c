/* Modes: rates against published ones to their last digit, periods to the picosecond, what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdio.h>
#include <string.h>

#include "raster/mode.h"

/* As printed in VESA DMT 1.0 rev. 13 (front page figures of each timing), for VGA text in IBM's VGA
 * manual, for television in SMPTE 170M and CTA-861; lengths of sync pulses in dots and lines of a
 * field. */
static const struct published {
    const char *name, *khz, *hz, *mhz, *polarity;
    uint32_t h_sync, v_sync;
} published[] = {
    {"640x350@85", "37.861", "85.080", "31.500", "+-", 64, 3},
    {"640x400@85", "37.861", "85.080", "31.500", "-+", 64, 3},
    {"720x400@85", "37.927", "85.039", "35.500", "-+", 72, 3},
    {"640x480@60", "31.469", "59.940", "25.175", "--", 96, 2},
    {"640x480@72", "37.861", "72.809", "31.500", "--", 40, 3},
    {"640x480@75", "37.500", "75.000", "31.500", "--", 64, 3},
    {"640x480@85", "43.269", "85.008", "36.000", "--", 56, 3},
    {"800x600@56", "35.156", "56.250", "36.000", "++", 72, 2},
    {"800x600@60", "37.879", "60.317", "40.000", "++", 128, 4},
    {"800x600@72", "48.077", "72.188", "50.000", "++", 120, 6},
    {"800x600@75", "46.875", "75.000", "49.500", "++", 80, 3},
    {"800x600@85", "53.674", "85.061", "56.250", "++", 64, 3},
    {"1024x768@43i", "35.522", "86.958", "44.900", "++", 176, 4},
    {"1024x768@60", "48.363", "60.004", "65.000", "--", 136, 6},
    {"1024x768@70", "56.476", "70.069", "75.000", "--", 136, 6},
    {"1024x768@75", "60.023", "75.029", "78.750", "++", 96, 3},
    {"1024x768@85", "68.677", "84.997", "94.500", "++", 96, 3},
    {"1152x864@75", "67.500", "75.000", "108.000", "++", 128, 3},
    {"1280x960@60", "60.000", "60.000", "108.000", "++", 112, 3},
    {"1280x960@85", "85.938", "85.002", "148.500", "++", 160, 3},
    {"1280x1024@60", "63.981", "60.020", "108.000", "++", 112, 3},
    {"1280x1024@75", "79.976", "75.025", "135.000", "++", 144, 3},
    {"1280x1024@85", "91.146", "85.024", "157.500", "++", 160, 3},
    {"1600x1200@60", "75.000", "60.000", "162.000", "++", 192, 3},
    {"1600x1200@65", "81.250", "65.000", "175.500", "++", 192, 3},
    {"1600x1200@70", "87.500", "70.000", "189.000", "++", 192, 3},
    {"1600x1200@75", "93.750", "75.000", "202.500", "++", 192, 3},
    {"1600x1200@85", "106.250", "85.000", "229.500", "++", 192, 3},
    {"720x400@70", "31.469", "70.087", "28.322", "-+", 108, 2},
    {"525/60i", "15.734", "59.940", "13.500", "--", 63, 3},
    {"525/60p", "31.469", "59.940", "27.000", "--", 62, 6},
};
#define PUBLISHED (sizeof published / sizeof published[0])

static void parse(const char *text, struct ras_timing *t)
{
    struct crt_error err;
    if (!ras_mode_parse(text, t, &err))
        fail_msg("%s: %s", text, err.text);
    if (!ras_timing_check(t, &err))
        fail_msg("%s: %s", text, err.text);
}

/* num / den / unit with three decimals, rounded half up, in whole numbers. */
static void decimal(char text[32], struct crt_rate rate, uint64_t unit)
{
    uint64_t den = rate.den * unit;
    uint64_t thousandths = (rate.num * 1000 + den / 2) / den;
    snprintf(text, 32, "%llu.%03llu", (unsigned long long)(thousandths / 1000),
             (unsigned long long)(thousandths % 1000));
}

static void rates_as_published(void **state)
{
    (void)state;
    size_t count;
    ras_modes(&count);
    assert_int_equal(count, PUBLISHED);
    for (size_t i = 0; i < PUBLISHED; i++) {
        const struct published *p = &published[i];
        struct ras_timing t;
        char text[32];
        parse(p->name, &t);
        decimal(text, ras_line_rate(&t), 1000);
        assert_string_equal(text, p->khz);
        decimal(text, ras_field_rate(&t), 1);
        assert_string_equal(text, p->hz);
        decimal(text, t.clock, 1000000);
        assert_string_equal(text, p->mhz);
        assert_int_equal(t.h.sync_end - t.h.sync_start, p->h_sync);
        assert_int_equal(t.v.sync_end - t.v.sync_start, p->v_sync * (t.interlaced ? 2 : 1));
        assert_int_equal(t.h_plus, p->polarity[0] == '+');
        assert_int_equal(t.v_plus, p->polarity[1] == '+');
        ras_timing_name(&t, text, sizeof text);
        assert_string_equal(text, p->name);
    }
}

/* The visible size is in the name; everything has a source. */
static void rows_are_whole(void **state)
{
    (void)state;
    size_t count;
    const struct ras_mode *modes = ras_modes(&count);
    for (size_t i = 0; i < count; i++) {
        struct crt_error err;
        unsigned width = 720, height = 480;
        sscanf(modes[i].name, "%ux%u", &width, &height);
        if (strncmp(modes[i].name, "525", 3) == 0)
            width = 720, height = 480;
        assert_int_equal(modes[i].timing.h.visible, width);
        assert_int_equal(modes[i].timing.v.visible, height);
        assert_true(strlen(modes[i].source) > 5 && strlen(modes[i].description) > 2);
        assert_true(ras_timing_check(&modes[i].timing, &err));
    }
}

/* Line and field periods, ps rounded down, from the definition. */
static void periods(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint64_t line, field; /* ps */
    } rows[] = {
        {"525/60i", 63555555, 16683333333}, /* 858 / 13.5 MHz = 63 5/9 us; 1001/60000 s */
        {"525/60p", 31777777, 16683333333},      {"640x480@60", 31777557, 16683217477},
        {"1024x768@60", 20676923, 16665600000},  {"1024x768@75", 16660317, 13328253968},
        {"1024x768@43i", 28151447, 11499866369}, {"1600x1200@75", 10666666, 13333333333},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct ras_timing t;
        parse(rows[i].name, &t);
        assert_int_equal(crt_tick_time(ras_line_rate(&t), 1), rows[i].line);
        assert_int_equal(crt_tick_time(ras_field_rate(&t), 1), rows[i].field);
        /* Fields and dots agree at every count. */
        for (uint64_t n = 1; n < 100000; n += 4999)
            assert_int_equal(crt_tick_time(ras_field_rate(&t), n),
                             crt_tick_time(t.clock, n * ras_field_dots(&t)));
    }
    struct ras_timing tv;
    parse("525/60i", &tv);
    struct crt_rate line = ras_line_rate(&tv), field = ras_field_rate(&tv);
    assert_true(line.num == 2250000 && line.den == 143); /* 4.5 MHz / 286 */
    assert_true(field.num == 60000 && field.den == 1001);
}

/* The course's approximation: line rate over visible lines, 5 % of it for the return of the beam. */
static void the_course_formula(void **state)
{
    (void)state;
    assert_int_equal(96000 * 95 / 100 / 1024, 89);
    assert_int_equal(96000 * 95 / 100 / 1200, 76);
    /* For real modes it is near: within 2 % where blanking is some 5 %. */
    struct ras_timing t;
    parse("1280x1024@75", &t);
    double f = 79976.0 / 1024 * 0.95;
    assert_true(f > 74.1 && f < 74.3);
    struct crt_rate exact = ras_field_rate(&t);
    assert_true((double)exact.num / (double)exact.den - f < 0.02 * f);
}

/* ---- names ------------------------------------------------------------------------------------ */

static void names_find_modes(void **state)
{
    (void)state;
    static const struct {
        const char *typed, *name;
    } rows[] = {
        {"1024x768", "1024x768@60"},      {"640x480@59.94", "640x480@60"},
        {"640x480@59.9", "640x480@60"},   {"640x480@59.940", "640x480@60"},
        {"1024x768@87i", "1024x768@43i"}, {"1024x768@86.96i", "1024x768@43i"},
        {"720x480@60i", "525/60i"},       {"720x480@60", "525/60p"},
        {"0800x0600@060", "800x600@60"},  {"1400x1050@60", "1400x1050@60"},
        {"1024x768@60i", "1024x768@60i"}, {"640x480@60i", "640x480@59i"},
        {"800x600@60.3", "800x600@60"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct ras_timing t;
        char name[32];
        parse(rows[i].typed, &t);
        ras_timing_name(&t, name, sizeof name);
        assert_string_equal(name, rows[i].name);
    }
    /* Not the table's 60.317 Hz, so CVT's. */
    struct ras_timing t;
    parse("800x600@60.0", &t);
    assert_int_equal(t.clock.num, 38250000);
}

static void what_is_no_mode(void **state)
{
    (void)state;
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"", "not a video mode"},
        {"vga", "not a video mode"},
        {"1024", "not a video mode"},
        {"1024x", "not a video mode"},
        {"1024x768@", "not a video mode"},
        {"1024x768@60p", "not a video mode"},
        {"1024x768@60ii", "not a video"},
        {"1024x768@6e1", "not a video mode"},
        {"-8x-8@60", "not a video mode"},
        {" 640x480", "not a video mode"},
        {"640x480@60 ", "not a video"},
        {"640x480@60.", "not a video mode"},
        {"640x480@.5", "not a video mode"},
        {"640x480@60.0001", "not a video mode"},
        {"4294967936x480", "not a video"},
        {"525/50i", "not a video mode"},
        {"7x480@60", "8 to 4096"},
        {"4097x480@60", "8 to 4096"},
        {"640x0@60", "1 to 4096"},
        {"640x4097@60", "1 to 4096"},
        {"640x480@0", "1 to 1000"},
        {"640x480@0.999", "1 to 1000"},
        {"640x480@1001", "1 to 1000"},
        {"1366x768@60", "1360 or 1368"},
        {"640x481@60i", "even number"},
        {"4096x4096@300", "1000 MHz"},
        {"8x1@60", "dot clock"},
        {"640x480@999999", "1 to 1000"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct ras_timing t;
        struct crt_error err = {""};
        if (ras_mode_parse(rows[i].text, &t, &err) || !strstr(err.text, rows[i].says))
            fail_msg("'%s' says: %s", rows[i].text, err.text);
    }
}

/* ---- CVT -------------------------------------------------------------------------------------- */

/* DMT 1.0 rev. 13 has modes made by CVT 1.1: dot clock kHz and parts as printed there. */
static void cvt_as_published(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint64_t khz;
        struct ras_span h, v;
    } rows[] = {
        {"1280x768@60", 79500, {1280, 1344, 1472, 1664}, {768, 771, 778, 798}},
        {"1280x768@75", 102250, {1280, 1360, 1488, 1696}, {768, 771, 778, 805}},
        {"1280x800@60", 83500, {1280, 1352, 1480, 1680}, {800, 803, 809, 831}},
        {"1400x1050@60", 121750, {1400, 1488, 1632, 1864}, {1050, 1053, 1057, 1089}},
        {"1400x1050@85", 179500, {1400, 1504, 1656, 1912}, {1050, 1053, 1057, 1105}},
        {"1440x900@75", 136750, {1440, 1536, 1688, 1936}, {900, 903, 909, 942}},
        {"1680x1050@60", 146250, {1680, 1784, 1960, 2240}, {1050, 1053, 1059, 1089}},
        {"1920x1200@60", 193250, {1920, 2056, 2256, 2592}, {1200, 1203, 1209, 1245}},
        {"2560x1600@60", 348500, {2560, 2752, 3032, 3504}, {1600, 1603, 1609, 1658}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct ras_timing t;
        parse(rows[i].name, &t);
        assert_int_equal(t.clock.num, rows[i].khz * 1000 * t.clock.den);
        assert_memory_equal(&t.h, &rows[i].h, sizeof t.h);
        assert_memory_equal(&t.v, &rows[i].v, sizeof t.v);
        assert_true(!t.h_plus && t.v_plus && !t.interlaced);
    }
}

/* Interlaced CVT: the half line is there, porch and pulse are CVT's 3 and n lines of a field, the rate is
 * the one asked for but for the rounding of the clock (0.25 MHz). */
static void cvt_interlaced(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint32_t sync; /* lines of a field: 4 for 4:3, 7 for 5:4 */
        double hz, error;
    } rows[] = {{"1024x768@60i", 4, 60, 0.5},
                {"1280x1024@87i", 7, 87, 0.5},
                {"640x480@60i", 4, 60, 1.2},
                {"800x600@85.5i", 4, 85.5, 0.8}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        struct ras_timing t;
        parse(rows[i].name, &t);
        struct crt_rate rate = ras_field_rate(&t);
        double hz = (double)rate.num / (double)rate.den;
        assert_true(t.interlaced && t.v.total % 2 == 1 && !t.h_plus && t.v_plus);
        assert_int_equal(t.v.sync_start, t.v.visible + 6);
        assert_int_equal(t.v.sync_end, t.v.sync_start + 2 * rows[i].sync);
        assert_true(hz <= rows[i].hz + 0.02 && hz > rows[i].hz - rows[i].error);
    }
}

/* ---- monitors --------------------------------------------------------------------------------- */

static void monitors(void **state)
{
    (void)state;
    const struct ras_monitor m = {30, 66, 50, 90, 110};
    struct crt_error err;
    struct ras_timing t;
    parse("1024x768@75", &t);
    assert_true(ras_monitor_follows(&m, &t, "COLOR15", &err));
    parse("1280x1024@75", &t);
    assert_false(ras_monitor_follows(&m, &t, "COLOR15", &err));
    assert_string_equal(err.text,
                        "1280x1024@75 needs 79.98 kHz and 75.02 Hz; COLOR15 follows 30 to "
                        "66 kHz and 50 to 90 Hz");
    parse("525/60i", &t);
    assert_false(ras_monitor_follows(&m, &t, "COLOR15", &err));
    parse("1280x1024@60", &t);
    assert_true(ras_monitor_follows(&m, &t, "COLOR15", &err));
    t.clock.num *= 2;
    t.h.total *= 2; /* the same rates, twice the dots */
    assert_false(ras_monitor_follows(&m, &t, "COLOR15", &err));
    assert_string_equal(err.text,
                        "1280x1024@60 needs a dot clock of 216 MHz; COLOR15 takes 110 MHz at most");
    struct crt_tube_row row = {.h_min = {.value = 15},
                               .h_max = {.value = 16},
                               .v_min = {.value = 47},
                               .v_max = {.value = 62},
                               .clock_max = {.value = 14}};
    struct ras_monitor tv = ras_monitor_of(&row);
    parse("525/60i", &t);
    assert_true(ras_monitor_follows(&tv, &t, "TV", &err));
    parse("525/60p", &t);
    assert_false(ras_monitor_follows(&tv, &t, "TV", &err));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rates_as_published),
        cmocka_unit_test(rows_are_whole),
        cmocka_unit_test(periods),
        cmocka_unit_test(the_course_formula),
        cmocka_unit_test(names_find_modes),
        cmocka_unit_test(what_is_no_mode),
        cmocka_unit_test(cvt_as_published),
        cmocka_unit_test(cvt_interlaced),
        cmocka_unit_test(monitors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
