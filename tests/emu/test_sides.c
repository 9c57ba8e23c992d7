/* Two sides of a capture, sequences and sheets: what --versus says and is told, which pictures are chosen and
 * overlap, that halves are exactly single pictures, that small pictures keep the light. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "crt/png_file.h"
#include "emu/command.h"
#include "emu/expose.h"
#include "emu/contact_sheet.h"
#include "emu/versus.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))

static uint64_t random_state = 1;

static uint64_t next_random(void)
{
    random_state = random_state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return random_state >> 33;
}

/* ---- --versus ----------------------------------------------------------------------------------- */

struct side {
    struct vm_settings_options options;
    struct vm_option_table table;
    struct vm_settings settings;
};

static void left_side(struct side *s)
{
    *s = (struct side){0};
    s->table = (struct vm_option_table)VM_OPTION_TABLE(vm_settings_rows, &s->options);
}

static bool parse(struct side *left, struct side *right, struct vm_versus *v, const char *text,
                  struct crt_error *err)
{
    *right = *left;
    right->table.target = &right->options;
    return vm_versus_parse(v, text, &right->table, 1, err);
}

static void what_is_said_replaces_the_left_sides(void **state)
{
    (void)state;
    struct side left, right;
    struct vm_versus v;
    struct crt_error err;
    left_side(&left);
    left.options.phosphor = "P39";
    left.options.tube = (struct vm_list){{"VR17"}, 1};
    left.options.set = (struct vm_list){{"spot=0.4"}, 1};
    assert_true(parse(&left, &right, &v,
                      " phosphor=P31; refresh=59.94 ;set.spot=0.5;brightness=0.25;"
                      "raster.spot_growth=0;tube=VR14;mode=640x480@60;",
                      &err));
    assert_string_equal(right.options.phosphor, "P31");
    assert_int_equal(right.options.refresh.num, 2997);
    assert_int_equal(right.options.refresh.den, 50);
    assert_int_equal(right.options.tube.count, 1);
    assert_string_equal(right.options.tube.item[0], "VR14");
    assert_string_equal(right.options.mode, "640x480@60");
    assert_int_equal(right.options.set.count, 4);
    assert_string_equal(right.options.set.item[0], "spot=0.4");
    assert_string_equal(right.options.set.item[1], "spot=0.5");
    assert_string_equal(right.options.set.item[2], "brightness=0.25");
    assert_string_equal(right.options.set.item[3], "raster.spot_growth=0");
    assert_string_equal(left.options.phosphor, "P39");
    assert_int_equal(left.options.set.count, 1);
    vm_versus_free(&v);
}

static void what_cannot_be_compared_is_told(void **state)
{
    (void)state;
    static const struct {
        const char *text, *says;
    } bad[] = {
        {"", "say what is different"},
        {" ; ;", "say what is different"},
        {"phosphr=P31", "did you mean phosphor?"},
        {"phosphor=P31;brightnes=1", "did you mean brightness?"},
        {"xyzzyplugh=1", "options without their dashes"},
        {"=3", "there is no ''"},
        {"phosphor", "--phosphor needs a value"},
        {"refresh=fast", "--refresh"},
        {"view=sideways", "'sideways' is not one of"},
        {"threads=1000", "--threads"},
        {"-phosphor=P31", "there is no '-phosphor'"},
        {"in=x;out=y", "there is no"},
    };
    for (size_t i = 0; i < COUNT(bad); i++) {
        struct side left, right;
        struct vm_versus v;
        struct crt_error err = {""};
        left_side(&left);
        assert_false(parse(&left, &right, &v, bad[i].text, &err));
        if (strncmp(err.text, "--versus: ", 10) != 0 || !strstr(err.text, bad[i].says))
            fail_msg("'%s' was told: %s", bad[i].text, err.text);
        vm_versus_free(&v);
    }
}

static void captions_of(const char *text, char captions[2][VM_VERSUS_CAPTION])
{
    struct side side[2];
    struct vm_versus v;
    struct crt_error err;
    left_side(&side[0]);
    assert_true(parse(&side[0], &side[1], &v, text, &err));
    struct vm_versus_side named[2];
    for (int k = 0; k < 2; k++) {
        if (vm_settings_resolve(&side[k].options, NULL, NULL, &side[k].settings, &err))
            fail_msg("%s", err.text);
        named[k] = (struct vm_versus_side){&side[k].table, 1, &side[k].settings, NULL,
                                           side[k].settings.view};
    }
    vm_versus_captions(&v, named, captions);
    for (int k = 0; k < 2; k++)
        vm_settings_free(&side[k].settings);
    vm_versus_free(&v);
}

static void captions_say_what_differs(void **state)
{
    (void)state;
    char c[2][VM_VERSUS_CAPTION];
    captions_of("phosphor=p31;refresh=30", c);
    assert_string_equal(c[0], "P39 \xC2\xB7 60 Hz");
    assert_string_equal(c[1], "P31 \xC2\xB7 30 Hz");
    captions_of("refresh=60;tube=VR14", c); /* one of them the same */
    assert_string_equal(c[0], "both 60 Hz \xC2\xB7 VR17 P39");
    assert_string_equal(c[1], "both 60 Hz \xC2\xB7 VR14 P39");
    captions_of("spot=0.5;brightness=-0.25;memory=16K;on-stop=halt", c);
    assert_string_equal(c[1], "spot 0.5 mm \xC2\xB7 brightness -0.25 \xC2\xB7 memory 16 K \xC2\xB7 "
                              "on-stop halt");
    assert_true(strstr(c[0], "brightness 0 \xC2\xB7 memory 64 K \xC2\xB7 on-stop by default"));
    captions_of("raster.spot=0.6;view=raster;mode=800x600@60", c);
    assert_true(strstr(c[1], "raster.spot 0.6 mm \xC2\xB7 raster \xC2\xB7 800x600@60"));
    captions_of("refresh=60", c); /* nothing differs: still something is said */
    assert_string_equal(c[0], "both 60 Hz");
    assert_string_equal(c[1], "both 60 Hz");
}

/* ---- shots -------------------------------------------------------------------------------------- */

static void instants_do_not_drift(void **state)
{
    (void)state;
    struct vm_shots s;
    struct crt_error err;
    const struct crt_rate film = {24000, 1001};
    assert_true(vm_shots_init(&s, 100000, &err));
    vm_shots_at_rate(&s, 777, film);
    for (uint64_t n = 0; n < s.count; n += 999) {
        long double exact = 777 + n * 1e12L * 1001 / 24000;
        assert_int_equal(s.shot[n].at, (uint64_t)floorl(exact));
    }
    vm_shots_free(&s);
}

static void chosen_pictures_are_evenly_spread(void **state)
{
    (void)state;
    for (int round = 0; round < 500; round++) {
        uint64_t count = 1 + next_random() % 200, most = 1 + next_random() % 40, before = 0;
        struct vm_shots s;
        struct crt_error err;
        assert_true(vm_shots_init(&s, count, &err));
        for (uint64_t n = 0; n < count; n++)
            s.shot[n] = (struct vm_shot){n, n};
        vm_shots_choose(&s, most);
        assert_int_equal(s.count, count < most ? count : most);
        assert_int_equal(s.shot[0].at, 0);
        for (uint64_t n = 1; n < s.count; n++) {
            double ideal = (double)n * (double)(count - 1) / (double)(s.count - 1);
            assert_true(s.shot[n].at > before && fabs((double)s.shot[n].at - ideal) <= 1);
            before = s.shot[n].at;
        }
        if (s.count > 1)
            assert_int_equal(s.shot[s.count - 1].at, count - 1);
        vm_shots_free(&s);
    }
}

/* How many exposures a moment lies in, at most, with those that begin before the present one is handed out. */
static void overlap_counts_open_exposures(void **state)
{
    (void)state;
    for (int round = 0; round < 300; round++) {
        uint64_t count = 1 + next_random() % 60, exposure = next_random() % 500, t = 600;
        struct vm_shots s;
        struct crt_error err;
        assert_true(vm_shots_init(&s, count, &err));
        for (uint64_t n = 0; n < count; n++) {
            uint64_t begin = t;
            t += 1 + next_random() % 40;
            s.shot[n] = (struct vm_shot){begin, t};
        }
        uint64_t most = 0;
        for (uint64_t n = 0; n < count; n++) {
            uint64_t open = 0;
            for (uint64_t k = n; k < count; k++) {
                uint64_t from = exposure ? s.shot[k].at - exposure : s.shot[k].begin;
                open += from < s.shot[n].at;
            }
            most = open > most ? open : most;
        }
        assert_int_equal(vm_shots_overlap(&s, exposure), most);
        vm_shots_free(&s);
    }
}

/* ---- sheets ------------------------------------------------------------------------------------- */

static double light_of(double sample)
{
    double v = sample / 255;
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

/* Sums exact areas, pixel by pixel. */
static double area_mean(const struct crt_image *p, int x, int y, int c, int width, int height)
{
    double sx = (double)p->width / width, sy = (double)p->height / height, sum = 0;
    for (int v = 0; v < p->height; v++)
        for (int u = 0; u < p->width; u++) {
            double w = fmin(u + 1, (x + 1) * sx) - fmax(u, x * sx);
            double h = fmin(v + 1, (y + 1) * sy) - fmax(v, y * sy);
            if (w > 0 && h > 0)
                sum += w * h * light_of(p->samples[(v * p->width + u) * 3 + c]);
        }
    return sum / (sx * sy);
}

static void small_pictures_keep_the_light(void **state)
{
    (void)state;
    for (int round = 0; round < 12; round++) {
        int width = 300 + (int)(next_random() % 90), height = 5 + (int)(next_random() % 40);
        struct crt_image p, small;
        struct vm_contact_sheet sheet;
        struct crt_error err;
        assert_true(crt_image_init(&p, width, height, 8, &err));
        for (int i = 0; i < width * height * 3; i++)
            p.samples[i] = (uint16_t)(next_random() % 256);
        assert_true(
            vm_contact_sheet_open(&sheet, 9, 9, (struct vm_size){width, height}, false, "x", &err));
        assert_true(sheet.cell.width < width);
        assert_true(crt_image_init(&small, sheet.cell.width, sheet.cell.height, 8, &err));
        vm_contact_sheet_reduce(&sheet, &p, &small);
        for (int i = 0; i < 60; i++) {
            int x = (int)(next_random() % (unsigned)small.width);
            int y = (int)(next_random() % (unsigned)small.height), c = i % 3;
            double mean = area_mean(&p, x, y, c, small.width, small.height);
            double sample = small.samples[(y * small.width + x) * 3 + c];
            assert_true(light_of(sample - 0.51) <= mean && mean <= light_of(sample + 0.51));
        }
        assert_true(sheet.image.width <= VM_SHEET_WIDTH);
        vm_contact_sheet_close(&sheet);
        crt_image_free(&small);
        crt_image_free(&p);
    }
}

static void sheets_have_places(void **state)
{
    (void)state;
    static const char *const bad[] = {"",      "8",    "8x",   "x4",        "0x4",   "8x0",
                                      "8x4x2", "-1x3", "8 x4", "9999x9999", "65x64", "8*4"};
    struct vm_size places;
    struct crt_error err;
    assert_true(vm_contact_sheet_places("8x4", &places, &err));
    assert_int_equal(places.width, 8);
    assert_int_equal(places.height, 4);
    assert_true(vm_contact_sheet_places("1x1", &places, &err));
    assert_true(vm_contact_sheet_places("64x64", &places, &err));
    for (size_t i = 0; i < COUNT(bad); i++)
        assert_false(vm_contact_sheet_places(bad[i], &places, &err));
}

/* ---- pictures ----------------------------------------------------------------------------------- */

static void capture(const char *path, const char *const *options, struct crt_image *image)
{
    char *argv[16];
    int argc = 0;
    struct crt_error err;
    argv[argc++] = (char *)(uintptr_t) "tests/programs/star.df";
    argv[argc++] = (char *)(uintptr_t) "-o";
    argv[argc++] = (char *)(uintptr_t)path;
    while (*options)
        argv[argc++] = (char *)(uintptr_t)*options++;
    assert_int_equal(vm_command_capture.run(argc, argv), 0);
    if (!crt_png_read(path, image, &err))
        fail_msg("%s", err.text);
}

static void has(const struct crt_image *whole, const struct crt_image *part, int x, int y)
{
    for (int row = 0; row < part->height; row++)
        assert_memory_equal(whole->samples +
                                ((size_t)(y + row) * (size_t)whole->width + (size_t)x) * 3,
                            part->samples + (size_t)row * (size_t)part->width * 3,
                            (size_t)part->width * 3 * sizeof *part->samples);
}

static void halves_are_single_pictures(void **state)
{
    (void)state;
    const char *folder = getenv("TEST_OUT");
    char path[4096];
    snprintf(path, sizeof path, "%s/halves.png", folder ? folder : "/tmp");
    struct crt_image both, left, right;
    capture(path,
            (const char *[]){"--film", "--at", "0.5s", "--exposure", "2ms", "--depth", "16",
                             "--versus", "phosphor=P31;refresh=45;brightness=0.1", "--captions",
                             NULL},
            &both);
    capture(path,
            (const char *[]){"--film", "--at", "0.5s", "--exposure", "2ms", "--depth", "16", NULL},
            &left);
    capture(path,
            (const char *[]){"--film", "--at", "0.5s", "--exposure", "2ms", "--depth", "16",
                             "--phosphor", "P31", "--refresh", "45", "--set", "brightness=0.1",
                             NULL},
            &right);
    assert_true(both.width > left.width + right.width && both.height > left.height);
    int y = 0, strip = 0;
    /* The strip with the names is above, of a height that follows from the pictures'. */
    for (y = 0; y < both.height - left.height; y++)
        if (memcmp(both.samples + (size_t)(y + left.height / 2) * (size_t)both.width * 3,
                   left.samples + (size_t)(left.height / 2) * (size_t)left.width * 3,
                   (size_t)left.width * 3 * sizeof *left.samples) == 0)
            strip = y;
    assert_true(strip > 0 && strip + left.height < both.height);
    has(&both, &left, 0, strip);
    has(&both, &right, both.width - right.width, strip);
    crt_image_free(&both);
    crt_image_free(&left);
    crt_image_free(&right);
    remove(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_said_replaces_the_left_sides),
        cmocka_unit_test(what_cannot_be_compared_is_told),
        cmocka_unit_test(captions_say_what_differs),
        cmocka_unit_test(instants_do_not_drift),
        cmocka_unit_test(chosen_pictures_are_evenly_spread),
        cmocka_unit_test(overlap_counts_open_exposures),
        cmocka_unit_test(small_pictures_keep_the_light),
        cmocka_unit_test(sheets_have_places),
        cmocka_unit_test(halves_are_single_pictures),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
