/* A light pen on the vector head: when it fires, how long its pulse stands, and that asking changes
 * nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "input/pen_parts.h"
#include "tests/input/pen_scene.h"

#define US UINT64_C(1000000)

/* Glows for a hundred picoseconds: its light is the beam's power. */
static const struct crt_phosphor instant = {
    .name = "INSTANT", .colours = 1, .colour = {{.3, .5}}, .terms = 1, .term = {{1, 1e-10, 0}}};

static struct inp_pen_setup setup;
static struct inp_pen pen;

static void make(const char *tube, const struct crt_phosphor *phosphor)
{
    struct inp_pen_desc desc = {&setup, crt_tube_row_find(tube), phosphor, {0, 1, 0}, 1};
    inp_pen_init(&pen, &desc);
    inp_hand_move(&pen.hand, (struct inp_place){0, 0, 0}, 0, 0);
}

static struct crt_stroke level_line(uint64_t t0, double speed, double y)
{
    return (struct crt_stroke){.t0 = t0,
                               .t1 = t0 + (uint64_t)(20 / speed * 1e6),
                               .x0 = -10,
                               .y0 = (float)y,
                               .x1 = 10,
                               .y1 = (float)y,
                               .drive = 1};
}

static struct crt_stroke dot_at(uint64_t t0, uint64_t t1, double drive)
{
    return (struct crt_stroke){.t0 = t0, .t1 = t1, .drive = (float)drive};
}

/* ---- when --------------------------------------------------------------------------------------- */

/* A spot that is switched on: t_fixed + tau·ln(1/(1 − threshold/S)). */
static void a_step_has_the_delay_of_the_closed_form(void **state)
{
    struct crt_phosphor flash = instant;
    (void)state;
    flash.term[0].tau_s = 1e-13;
    setup = slow_still_setup();
    setup.couple.value = 1e5;
    for (int i = 1; i < 10; i++) {
        make("VR17", &flash);
        double sigma = crt_spot_at(pen.desc.row, &pen.knobs, 1).sigma_mm;
        double signal =
            crt_spot_at(pen.desc.row, &pen.knobs, 1).power / 0.5 * pen_share(1.5, sigma, 0);
        setup.threshold.value = signal * i / 10;
        make("VR17", &flash);
        struct crt_stroke dot = dot_at(3 * US, 13 * US, 1);
        double delay = 0.3 + 0.3 * log(1 / (1 - i / 10.0));
        double late = (double)(inp_pen_offer(&pen, &dot) - dot.t0) * 1e-6 - delay;
        assert_true(fabs(late) < 20e-6);
    }
}

/* The faster the beam, the further it gets until the pulse: by v times the delay. */
static void the_error_is_speed_times_delay(void **state)
{
    static const double speeds[] = {0.5, 1, 2, 4, 7, 10};
    (void)state;
    setup = slow_still_setup();
    setup.couple.value = 1e5;
    setup.response.value = 0.01;
    setup.delay.value = 0.7;
    make("VR17", &instant);
    setup.threshold.value =
        crt_spot_at(pen.desc.row, &pen.knobs, 1).power; /* half of what it gives */
    make("VR17", &instant);
    struct crt_stroke slow = level_line(US, 0.001, 0);
    double still = -10 + 0.001 * (double)(inp_pen_offer(&pen, &slow) - US) * 1e-6;
    assert_true(still > -3 && still < 0);
    for (unsigned i = 0; i < sizeof speeds / sizeof speeds[0]; i++) {
        struct crt_stroke line = level_line(US, speeds[i], 0);
        double x = -10 + speeds[i] * (double)(inp_pen_offer(&pen, &line) - US) * 1e-6;
        assert_true(fabs((x - still) / (speeds[i] * (0.7 + 0.01)) - 1) < 0.01);
    }
}

static void sees_what_is_under_it_only(void **state)
{
    (void)state;
    setup = slow_setup();
    make("VR17", crt_phosphor_find("P31"));
    for (double y = -6; y <= 6; y += 0.25) {
        struct crt_stroke line = level_line(US, 2.3, y);
        uint64_t when = inp_pen_offer(&pen, &line);
        if (fabs(y) < 1.6)
            assert_true(when < line.t1);
        if (fabs(y) > 2.6)
            assert_true(when == INP_NEVER);
    }
}

/* What the header promises of the figures as they are. */
static void fires_as_promised(void **state)
{
    (void)state;
    setup = slow_setup();
    for (int level = 0; level < 8; level++) {
        struct crt_stroke line = level_line(US, 9.25 * 25.4 / 1024 / 0.1, 0);
        line.drive = 0.4F + 0.6F * (float)level / 7;
        make("VR17", crt_phosphor_find("P31"));
        uint64_t when = inp_pen_offer(&pen, &line), middle = line.t0 + (line.t1 - line.t0) / 2;
        assert_true(when > middle - US && when < middle + US / 2);
        make("VR17", crt_phosphor_find("P39"));
        when = inp_pen_offer(&pen, &line);
        if (level < 3)
            assert_true(when == INP_NEVER);
        if (level > 5)
            assert_true(when > middle && when < middle + US);
        setup.infrared.value = 0.001; /* doped for a pen */
        make("VR17", crt_phosphor_find("P39"));
        when = inp_pen_offer(&pen, &line);
        assert_true(when > middle - US && when < middle + US / 2);
        setup.infrared.value = 0;
    }
    /* A dot of a character: the pulse comes after it and stands for the next one. */
    make("LAB31", crt_phosphor_find("P31"));
    uint64_t when = 0;
    struct crt_stroke dot = dot_at(US, US + US / 4, 1), next = dot_at(2 * US, 2 * US + US / 4, 0.7);
    assert_true(!inp_pen_stroke(&pen, &dot, &when));
    assert_true(inp_pen_offer(&pen, &next) == next.t0);
}

static void black_gives_nothing(void **state)
{
    (void)state;
    setup = slow_setup();
    make("LAB31", crt_phosphor_find("P31"));
    struct crt_stroke line = level_line(US, 2, 0);
    line.drive = 0;
    assert_true(inp_pen_offer(&pen, &line) == INP_NEVER);
    pen.knobs.brightness = 0.6; /* a bright knob makes black glow */
    inp_pen_set_knobs(&pen, pen.knobs);
    assert_true(inp_pen_offer(&pen, &line) < line.t1);
    inp_pen_set_knobs(&pen, (struct crt_knobs){-1, 1, 0});
    line.drive = 1;
    assert_true(inp_pen_offer(&pen, &line) == INP_NEVER);
}

/* Both layers of a penetration tube are seen, and its red lies a little off. */
static void sees_all_colours_of_a_penetration_tube(void **state)
{
    size_t count;
    const struct crt_tube_row *rows = crt_tube_rows(&count);
    int seen = 0;
    (void)state;
    setup = slow_setup();
    for (size_t i = 0; i < count; i++) {
        if (!rows[i].penetration)
            continue;
        make(rows[i].name, crt_phosphor_find(rows[i].phosphor));
        for (uint32_t level = CRT_LEVEL_RED; level <= CRT_LEVEL_GREEN; level++) {
            struct crt_stroke line = level_line(US, 0.5, 0);
            line.level = level;
            assert_true(inp_pen_offer(&pen, &line) < line.t1);
            seen++;
        }
    }
    assert_true(seen > 0);
}

/* ---- the pulse ---------------------------------------------------------------------------------- */

/* A pulse that comes when the beam is off is seen by what is drawn while it stands, and no later. */
static void a_pulse_stands_for_hold(void **state)
{
    (void)state;
    setup = slow_setup();
    for (int i = 0; i < 60; i++) {
        uint64_t when = 0;
        make("LAB31", crt_phosphor_find("P31"));
        struct crt_stroke dot = dot_at(US, US + US / 4, 1);
        assert_true(!inp_pen_stroke(&pen, &dot, &when));
        uint64_t pulse = pen.sight.pulse, t0 = dot.t1 + (uint64_t)i * 50000;
        assert_true(pulse > dot.t1 && pulse < dot.t1 + US);
        struct crt_stroke next = level_line(t0, 2, 60);
        next.t1 = t0 + US;
        uint64_t offer = inp_pen_offer(&pen, &next);
        if (t0 > pulse + 2 * US || next.t1 + 2000 < pulse)
            assert_true(offer == INP_NEVER);
        else
            assert_true(offer == (t0 > pulse ? t0 : pulse));
        assert_true(inp_pen_stroke(&pen, &next, &when) == (offer != INP_NEVER));
        next.t0 = next.t1;
        next.t1 += US;
        if (offer != INP_NEVER) /* it is spent */
            assert_true(inp_pen_offer(&pen, &next) == INP_NEVER);
    }
}

/* It fires again only after the signal has fallen below half the threshold. */
static void is_armed_again_below_half(void **state)
{
    (void)state;
    setup = slow_still_setup();
    setup.couple.value = 1e5;
    setup.delay.value = 0;
    for (int i = 0; i < 20; i++) {
        double low = 0.05 * i;
        uint64_t when = 0;
        setup.threshold.value = 1;
        make("VR17", &instant);
        double full = crt_spot_at(pen.desc.row, &pen.knobs, 1).power / 0.5;
        setup.threshold.value = full * 0.8;
        make("VR17", &instant);
        struct crt_stroke on = dot_at(US, 10 * US, 1), again = dot_at(20 * US, 30 * US, 1);
        struct crt_stroke dim = dot_at(10 * US, 20 * US, pow(low, 1 / 2.5));
        assert_true(inp_pen_stroke(&pen, &on, &when));
        assert_true(!inp_pen_stroke(&pen, &dim, &when));
        if (fabs(low - 0.4) > 0.01)
            assert_true((inp_pen_offer(&pen, &again) != INP_NEVER) == (low < 0.4));
    }
}

/* ---- offers and cuts ---------------------------------------------------------------------------- */

static void offers_change_nothing(void **state)
{
    static struct scene s;
    static struct inp_pen before;
    (void)state;
    for (int i = 0; i < 100; i++) {
        draw_scene(&s);
        memcpy(&before, &s.pen, sizeof before);
        (void)inp_pen_offer(&s.pen, &s.stroke);
        assert_memory_equal(&before, &s.pen, sizeof before);
        uint64_t when = 0, offer = inp_pen_offer(&s.pen, &s.stroke);
        assert_true(inp_pen_stroke(&s.pen, &s.stroke, &when) == (offer != INP_NEVER));
        if (offer != INP_NEVER)
            assert_true(when == offer);
    }
}

/* As the display processor cuts it (display_file/beam.c), in head units first. */
static void cut(struct crt_stroke *s, uint64_t at)
{
    double part = (double)(at - s->t0) / (double)(s->t1 - s->t0);
    s->x1 = s->x0 + (float)(((double)s->x1 - (double)s->x0) * part);
    s->y1 = s->y0 + (float)(((double)s->y1 - (double)s->y0) * part);
    s->t1 = at;
}

/* The part until the pulse spends it, however late it is recognised. */
static void a_stroke_cut_at_the_pulse_spends_it(void **state)
{
    static struct scene s;
    int cuts = 0, slow = 0;
    (void)state;
    for (int i = 0; i < 600; i++) {
        uint64_t when = 0;
        draw_scene(&s);
        s.setup.delay.value = i % 2 ? 0 : s.setup.delay.value;
        s.setup.threshold.value = pow(10, even(-1, 4));
        s.setup.noise.value = i % 3 ? 0 : s.setup.threshold.value / 6;
        inp_pen_set_knobs(&s.pen, s.pen.knobs);
        if (i % 5 == 0) { /* very slow */
            s.stroke.t1 = s.stroke.t0 + (s.stroke.t1 - s.stroke.t0) * 3000;
            slow++;
        }
        uint64_t offer = inp_pen_offer(&s.pen, &s.stroke);
        if (offer == INP_NEVER || offer == s.stroke.t0)
            continue;
        struct crt_stroke part = s.stroke;
        cut(&part, offer);
        assert_true(inp_pen_stroke(&s.pen, &part, &when));
        assert_true(when <= offer && offer - when < 2000 + (s.stroke.t1 - s.stroke.t0) / 10000);
        assert_true(s.pen.sight.pulse == INP_NEVER && !s.pen.sight.armed);
        cuts++;
    }
    assert_true(cuts > 200 && slow > 50);
}

/* A stroke and its two parts leave the same behind. */
static void parts_add_up(void **state)
{
    static struct scene s;
    static struct inp_pen other;
    (void)state;
    for (int i = 0; i < 100; i++) {
        uint64_t when = 0;
        draw_scene(&s);
        memcpy(&other, &s.pen, sizeof other);
        struct crt_stroke a = s.stroke, b = s.stroke;
        cut(&a, a.t0 + (a.t1 - a.t0) / 1000 * (1 + one_of(998)));
        b.t0 = a.t1;
        b.x0 = a.x1;
        b.y0 = a.y1;
        inp_pen_stroke(&s.pen, &s.stroke, &when);
        inp_pen_stroke(&other, &a, &when);
        inp_pen_stroke(&other, &b, &when);
        pen_run(&s.pen, &s.pen.sight, (struct pen_input){{0}, {0}}, b.t1, false);
        pen_run(&other, &other.sight, (struct pen_input){{0}, {0}}, b.t1, false);
        assert_true(s.pen.sight.t == other.sight.t);
        double most = fabs(s.pen.sight.fast) + fabs(s.pen.sight.slow) + 1e-3;
        assert_true(fabs(s.pen.sight.fast - other.sight.fast) < 1e-3 * most);
        assert_true(fabs(s.pen.sight.slow - other.sight.slow) < 1e-3 * most);
    }
}

/* ---- where -------------------------------------------------------------------------------------- */

static void looks_at_the_glass_only(void **state)
{
    (void)state;
    setup = slow_setup();
    make("VR17", crt_phosphor_find("P31"));
    double edge = 9.25 * 25.4 / 2 + 6 + 1.5;
    assert_true(inp_pen_looks(&pen));
    inp_hand_move(&pen.hand, (struct inp_place){edge + 0.1, 0, 0}, 0, 0);
    assert_true(!inp_pen_looks(&pen) || pen.hand.from.x < edge);
    inp_hand_away(&pen.hand);
    assert_true(!inp_pen_looks(&pen));
    inp_hand_move(&pen.hand, (struct inp_place){0, edge + 0.1, 0}, 0, 0);
    assert_true(!inp_pen_looks(&pen));
    inp_hand_move(&pen.hand, (struct inp_place){0, -edge - 5, 0}, 0, US); /* across */
    assert_true(inp_pen_looks(&pen));
}

/* The aperture is where the hand is when the stroke begins. */
static void follows_the_hand(void **state)
{
    (void)state;
    setup = slow_setup();
    make("VR17", crt_phosphor_find("P31"));
    inp_hand_move(&pen.hand, (struct inp_place){0, 10, 0}, 0, 1000 * US);
    struct crt_stroke early = level_line(US, 2, 0), late = level_line(900 * US, 2, 0);
    assert_true(inp_pen_offer(&pen, &early) < early.t1);
    assert_true(inp_pen_offer(&pen, &late) == INP_NEVER);
    late.y0 = late.y1 = 9;
    assert_true(inp_pen_offer(&pen, &late) < late.t1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_has_the_delay_of_the_closed_form),
        cmocka_unit_test(the_error_is_speed_times_delay),
        cmocka_unit_test(sees_what_is_under_it_only),
        cmocka_unit_test(fires_as_promised),
        cmocka_unit_test(black_gives_nothing),
        cmocka_unit_test(sees_all_colours_of_a_penetration_tube),
        cmocka_unit_test(a_pulse_stands_for_hold),
        cmocka_unit_test(is_armed_again_below_half),
        cmocka_unit_test(offers_change_nothing),
        cmocka_unit_test(a_stroke_cut_at_the_pulse_spends_it),
        cmocka_unit_test(parts_add_up),
        cmocka_unit_test(looks_at_the_glass_only),
        cmocka_unit_test(follows_the_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
