/* When a light pen fires is what a slow model of it says, which shares no formula with it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "crt/optics.h"
#include "crt/white.h"
#include "input/pen_parts.h"
#include "tests/input/pen_scene.h"

static void share_is_that_of_the_rings(void **state)
{
    (void)state;
    for (int i = 0; i < 100; i++) {
        double radius = even(1, 2.5), sigma = even(0.08, i % 4 ? 0.4 : 3);
        double d = even(0, radius + 4.5 * sigma), slow = slow_share(radius, sigma, d, 200, 160);
        double share = pen_share(radius, sigma, d);
        assert_true(fabs(share - slow) < 3e-4 + (sigma < 0.15 ? 1e-3 : 0));
        assert_true(fabs(share - slow) < 0.02 * slow + 1e-6);
    }
}

/* ---- strokes ------------------------------------------------------------------------------------ */

static struct slow_shares shares;

static void power_at(const struct scene *s, double part, double power[CRT_MAX_COLOURS])
{
    double x = (double)s->stroke.x0 + ((double)s->stroke.x1 - (double)s->stroke.x0) * part -
               s->pen.hand.to.x;
    double y = (double)s->stroke.y0 + ((double)s->stroke.y1 - (double)s->stroke.y0) * part -
               s->pen.hand.to.y;
    double share = slow_share_at(&shares, sqrt(x * x + y * y));
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        power[c] = s->power[c] * share;
}

/* Runs through the stroke; the first time in us that the signal is at `level` (below 0: never), and the
 * most it was. */
static double slow_crossing(const struct scene *s, double level, double *most)
{
    struct slow_pen pen = {s->phosphor, s->setup.response.value, s->setup.couple.value, {0}};
    double span = (double)(s->stroke.t1 - s->stroke.t0) * 1e-6;
    double fastest = 1e9;
    for (int k = 0; k < s->phosphor->terms; k++)
        fastest = fmin(fastest, s->phosphor->term[k].tau_s * 1e6);
    int steps = (int)(span / fmin(0.02, fastest / 3)) + 50;
    double h = span / steps, at = -1;
    *most = 0;
    for (int i = 0; i < steps; i++) {
        double power[3][CRT_MAX_COLOURS], before = slow_signal(&pen);
        for (int j = 0; j < 3; j++)
            power_at(s, (i + j / 2.0) / steps, power[j]);
        slow_step(&pen, power, h);
        double after = slow_signal(&pen);
        *most = fmax(*most, after);
        if (at < 0 && after >= level)
            at = h * (i + (level - before) / (after - before));
    }
    return at;
}

static void strokes_fire_when_the_slow_model_does(void **state)
{
    static struct scene s;
    double worst = 0;
    int fired = 0, not = 0;
    (void)state;
    for (int i = 0; i < 100; i++) {
        double most;
        draw_scene(&s);
        slow_shares_make(&shares, s.setup.aperture.value / 2, s.sigma);
        slow_crossing(&s, HUGE_VAL, &most);
        double level = most * pow(10, even(-2.5, 0.1));
        if (!(most > 1) || fabs(level - most) < 0.02 * most)
            continue;
        s.setup.threshold.value = level;
        inp_pen_set_knobs(&s.pen, s.pen.knobs);
        double at = slow_crossing(&s, level, &most) + s.setup.delay.value;
        uint64_t offer = inp_pen_offer(&s.pen, &s.stroke);
        double span = (double)(s.stroke.t1 - s.stroke.t0) * 1e-6;
        if (level > most || at > span + 0.03) {
            assert_true(offer == INP_NEVER);
            not ++;
        } else if (at < span - 0.03) {
            if (offer == INP_NEVER)
                print_message(
                    "%s %s level %g most %g at %g span %g  pen %g+%g of %g v %g focus %g\n",
                    s.row->name, s.phosphor->name, level, most, at, span,
                    s.stroke.x0 - s.pen.hand.to.x, s.stroke.y0 - s.pen.hand.to.y,
                    s.setup.aperture.value / 2,
                    hypot(s.stroke.x1 - s.stroke.x0, s.stroke.y1 - s.stroke.y0) / span,
                    s.pen.knobs.focus);
            assert_true(offer != INP_NEVER);
            double late = (double)(offer - s.stroke.t0) * 1e-6 - at;
            worst = fmax(worst, fabs(late));
            fired++;
            assert_true(fabs(late) < 0.03);
        }
    }
    print_message("%d fired, %d not; at most %.1f ns apart\n", fired, not, worst * 1e3);
    assert_true(fired > 50 && not > 3);
}

/* ---- scan lines --------------------------------------------------------------------------------- */

#define DOTS 1024

struct sweep {
    struct inp_pen_setup setup;
    struct inp_pen pen;
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    uint8_t dots[CRT_MAX_GUNS][DOTS];
    struct crt_scan_line line;
    struct slow_shares shares;
    double power[CRT_MAX_COLOURS], x[CRT_MAX_COLOURS], y[CRT_MAX_COLOURS];
    int gun[CRT_MAX_COLOURS];
};

/* Runs of dots of one colour, as pictures have. */
static void draw_dots(struct sweep *s)
{
    for (int gun = 0; gun < CRT_MAX_GUNS; gun++) {
        uint8_t drive = 0;
        unsigned left = 0;
        for (int i = 0; i < DOTS; i++, left--) {
            if (left == 0) {
                left = 1 + one_of(i % 2 ? 20 : 200);
                drive = one_of(3) ? (uint8_t)one_of(256) : 0;
            }
            s->dots[gun][i] = drive;
        }
        s->line.drive[gun] = s->dots[gun];
    }
}

static void draw_powers(struct sweep *s, int guns, double px, double py)
{
    double share[3] = {1, 1, 1}, terms[3] = {0};
    struct crt_optics optics;
    crt_optics_init(&optics, s->row);
    if (guns == 3)
        crt_white_shares(s->phosphor, share);
    for (int k = 0; k < s->phosphor->terms; k++)
        terms[s->phosphor->term[k].colour] += s->phosphor->term[k].w;
    for (int c = 0; c < s->phosphor->colours; c++) {
        s->gun[c] = guns == 3 ? c : 0;
        struct crt_beam_place at = crt_optics_at(&optics, s->gun[c], px, py);
        s->power[c] = s->row->field_luminance.value * s->row->width.value * s->row->height.value /
                      s->row->field_duty.value * (guns == 3 ? share[c] / terms[c] : 1);
        s->x[c] = at.dx - px;
        s->y[c] = at.dy - py;
        struct crt_knobs neutral = {0, 1, s->pen.knobs.focus};
        slow_shares_make(&s->shares, s->setup.aperture.value / 2,
                         crt_spot_at(s->row, &neutral, 1).sigma_mm * at.spread);
    }
}

static void draw_sweep(struct sweep *s)
{
    static const char *const tubes[] = {"COLOR17", "SLOT14", "MONO12", "GRILLE17"};
    s->row = crt_tube_row_find(tubes[one_of(4)]);
    s->phosphor = crt_phosphor_find(s->row->phosphor);
    s->setup = slow_still_setup();
    s->setup.aperture.value = even(2, 5);
    s->setup.response.value = even(0.05, 0.6);
    double half = s->row->width.value / 2, px = even(-0.9, 0.9) * half, py = even(-60, 60);
    struct inp_pen_desc desc = {&s->setup, s->row, s->phosphor, {0, 1, 0}, 3};
    inp_pen_init(&s->pen, &desc);
    inp_hand_move(&s->pen.hand, (struct inp_place){px, py, 0}, 0, 0);
    draw_dots(s);
    s->line.t0 = 7000000;
    s->line.t1 = s->line.t0 + 12000000 + one_of(20000000);
    s->line.x0 = (float)-half;
    s->line.x1 = (float)half;
    s->line.y0 = s->line.y1 = (float)(py + even(-1.5, 1.5));
    s->line.dots = DOTS;
    s->line.guns = crt_tube_guns(s->row);
    draw_powers(s, s->line.guns, px, py);
}

static void sweep_power(const struct sweep *s, double part, double power[CRT_MAX_COLOURS])
{
    double x = (double)s->line.x0 + ((double)s->line.x1 - (double)s->line.x0) * part;
    int dot = (int)fmin(part * DOTS, DOTS - 1);
    for (int c = 0; c < s->phosphor->colours; c++) {
        double dx = x + s->x[c], dy = (double)s->line.y0 + s->y[c];
        double current = pow(s->line.drive[s->gun[c]][dot] / 255.0, s->row->gun_exponent.value);
        power[c] = s->power[c] * current * slow_share_at(&s->shares, sqrt(dx * dx + dy * dy));
    }
}

/* From shortly before the pen until 3 us after it, in steps of 1.5 ns. */
static double sweep_crossing(const struct sweep *s, double level, double *most)
{
    struct slow_pen pen = {s->phosphor, s->setup.response.value, s->setup.couple.value, {0}};
    double span = (double)(s->line.t1 - s->line.t0) * 1e-6, width = s->row->width.value;
    double middle = (s->pen.hand.to.x / width + 0.5) * span, before = 8 / width * span;
    double from = fmax(middle - before, 0), to = fmin(middle + before + 3, span), at = -1;
    int steps = (int)((to - from) / 0.0015);
    double h = (to - from) / steps;
    *most = 0;
    for (int i = 0; i < steps; i++) {
        double power[3][CRT_MAX_COLOURS] = {{0}}, last = slow_signal(&pen);
        for (int j = 0; j < 3; j++)
            sweep_power(s, (from + h * (i + j / 2.0)) / span, power[j]);
        slow_step(&pen, power, h);
        double now = slow_signal(&pen);
        *most = fmax(*most, now);
        if (at < 0 && now >= level)
            at = from + h * (i + (level - last) / (now - last));
    }
    return at;
}

static void lines_fire_when_the_slow_model_does(void **state)
{
    static struct sweep s;
    double worst = 0;
    int fired = 0, not = 0;
    (void)state;
    for (int i = 0; i < 16; i++) {
        double most;
        draw_sweep(&s);
        sweep_crossing(&s, HUGE_VAL, &most);
        double level = most * pow(10, even(-2, 0.4));
        if (!(most > 1) || fabs(level - most) < 0.03 * most)
            continue;
        s.setup.threshold.value = level;
        inp_pen_set_knobs(&s.pen, s.pen.knobs);
        double at = sweep_crossing(&s, level, &most) + s.setup.delay.value;
        inp_pen_line(&s.pen, &s.line);
        uint64_t next = inp_pen_next(&s.pen);
        if (level > most) {
            assert_true(next == INP_NEVER);
            not ++;
            continue;
        }
        assert_true(next != INP_NEVER);
        worst = fmax(worst, fabs((double)(next - s.line.t0) * 1e-6 - at));
        assert_true(!inp_pen_event(&s.pen, next - 1));
        assert_true(inp_pen_event(&s.pen, next));
        fired++;
    }
    print_message("%d fired, %d not; at most %.1f ns apart\n", fired, not, worst * 1e3);
    assert_true(fired > 6 && not > 0 && worst < 0.01);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(share_is_that_of_the_rings),
        cmocka_unit_test(strokes_fire_when_the_slow_model_does),
        cmocka_unit_test(lines_fire_when_the_slow_model_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
