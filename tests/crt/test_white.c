/* White balance: shares of three primaries against an equation solver and published luminances, and
 * equal guns through crt_develop against D65 in CIELAB. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "crt/develop.h"
#include "crt/white.h"

static struct crt_phosphor of(double rx, double ry, double gx, double gy, double bx, double by)
{
    struct crt_phosphor p = {.colours = 3, .colour = {{rx, ry}, {gx, gy}, {bx, by}}};
    return p;
}

/* Luminances of the primaries for white D65: IEC 61966-2-1 and ITU-R BT.2020 as published; SMPTE C
 * and EBU from their standards' matrices. */
static void published_luminances(void **state)
{
    (void)state;
    static const struct {
        double xy[6], share[3];
    } want[] = {
        {{.64, .33, .30, .60, .15, .06}, {0.2126, 0.7152, 0.0722}},
        {{.708, .292, .170, .797, .131, .046}, {0.2627, 0.6780, 0.0593}},
        {{.630, .340, .310, .595, .155, .070}, {0.2124, 0.7011, 0.0866}},
        {{.64, .33, .29, .60, .15, .06}, {0.2220, 0.7067, 0.0713}},
    };
    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        const double *c = want[i].xy;
        struct crt_phosphor p = of(c[0], c[1], c[2], c[3], c[4], c[5]);
        double share[3];
        assert_true(crt_white_shares(&p, share));
        for (int k = 0; k < 3; k++)
            if (fabs(share[k] - want[i].share[k]) > 1e-4)
                fail_msg("set %zu, colour %d: %.5f, published %.4f", i, k, share[k],
                         want[i].share[k]);
    }
}

static void mixture_is_white(void **state)
{
    (void)state;
    const struct crt_phosphor *p = crt_phosphor_find("P22");
    double share[3], X = 0, Y = 0, Z = 0;
    assert_true(crt_white_shares(p, share));
    for (int c = 0; c < 3; c++) {
        X += share[c] * p->colour[c].x / p->colour[c].y;
        Y += share[c];
        Z += share[c] * (1 - p->colour[c].x - p->colour[c].y) / p->colour[c].y;
    }
    assert_true(fabs(Y - 1) < 1e-12);
    assert_true(fabs(X / (X + Y + Z) - CRT_D65_X) < 1e-12);
    assert_true(fabs(Y / (X + Y + Z) - CRT_D65_Y) < 1e-12);
}

static void what_cannot_be_white_is_refused(void **state)
{
    (void)state;
    double share[3];
    struct crt_phosphor warm = of(.6, .35, .5, .4, .4, .5), line = of(.6, .3, .5, .3, .4, .3);
    struct crt_phosphor same = of(.6, .3, .6, .3, .6, .3);
    assert_false(crt_white_shares(&warm, share));
    assert_false(crt_white_shares(&line, share));
    assert_false(crt_white_shares(&same, share));
    assert_false(crt_white_shares(crt_phosphor_find("P4"), share));
    assert_false(crt_white_shares(crt_phosphor_find("P31"), share));
}

static double linear(double v)
{
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static double lab_f(double t)
{
    return t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

/* CIELAB of an sRGB sample (IEC 61966-2-1 matrix, white D65). */
static void lab_of(const uint16_t *s, double lab[3])
{
    double r = linear(s[0] / 65535.0), g = linear(s[1] / 65535.0), b = linear(s[2] / 65535.0);
    double x = lab_f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    double y = lab_f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    double z = lab_f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890);
    lab[0] = 116 * y - 16;
    lab[1] = 500 * (x - y);
    lab[2] = 200 * (y - z);
}

/* Light of three guns at equal drive, from black to full: grey, of its own lightness; full white is
 * 0.8 of white under the automatic gain. */
static void equal_guns_are_grey(void **state)
{
    (void)state;
    const struct crt_phosphor *p = crt_phosphor_find("P22");
    const struct crt_tube_row *row = crt_tube_row_find("COLOR17");
    enum { N = 64 };
    static float light[3][N];
    double share[3] = {0};
    for (int k = 0; k < p->terms; k++)
        share[p->term[k].colour] += p->term[k].w;
    struct crt_film film = {.grid = {.cols = N, .rows = 1, .cell_mm = 1},
                            .colours = 3,
                            .light = {light[0], light[1], light[2]},
                            .t1 = CRT_PS_PER_S,
                            .complete = true};
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < N; i++)
            light[c][i] = (float)(share[c] * row->field_luminance.value * i / (N - 1));
    struct crt_image image;
    struct crt_error err;
    assert_true(crt_develop(&film, p, crt_auto_gain(row), 16, 1, &image, &err));
    double worst = 0;
    for (int i = 0; i < N; i++) {
        double lab[3], want = 116 * lab_f(0.8 * i / (N - 1)) - 16;
        lab_of(image.samples + 3 * i, lab);
        double off = sqrt(pow(lab[0] - want, 2) + lab[1] * lab[1] + lab[2] * lab[2]);
        worst = fmax(worst, off);
        if (off >= 2)
            fail_msg("step %d: L* %.2f a* %.2f b* %.2f, wanted L* %.2f", i, lab[0], lab[1], lab[2],
                     want);
    }
    print_message("# largest difference from grey: %.3f (CIELAB 1976)\n", worst);
    crt_image_free(&image);
}

/* The primaries keep their hue, if not all of their chroma. */
static void primaries_keep_their_hue(void **state)
{
    (void)state;
    const struct crt_phosphor *p = crt_phosphor_find("P22");
    double share[3];
    assert_true(crt_white_shares(p, share));
    for (int c = 0; c < 3; c++) {
        static float light[3][8];
        memset(light, 0, sizeof light);
        for (int i = 0; i < 8; i++)
            light[c][i] = (float)share[c];
        struct crt_film film = {.grid = {.cols = 8, .rows = 1, .cell_mm = 1},
                                .colours = 3,
                                .light = {light[0], light[1], light[2]},
                                .t1 = CRT_PS_PER_S,
                                .complete = true};
        struct crt_image image;
        struct crt_error err;
        assert_true(crt_develop(&film, p, 0.8, 16, 1, &image, &err));
        const uint16_t *s = image.samples;
        for (int k = 0; k < 3; k++)
            assert_true(k == c || s[c] > 2 * s[k]);
        double y = 0.2126 * linear(s[0] / 65535.0) + 0.7152 * linear(s[1] / 65535.0) +
                   0.0722 * linear(s[2] / 65535.0);
        assert_true(fabs(y - 0.8 * share[c]) < 1e-3);
        crt_image_free(&image);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(published_luminances),
        cmocka_unit_test(mixture_is_white),
        cmocka_unit_test(what_cannot_be_white_is_refused),
        cmocka_unit_test(equal_guns_are_grey),
        cmocka_unit_test(primaries_keep_their_hue),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
