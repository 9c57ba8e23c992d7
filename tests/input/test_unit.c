/* The input unit: registers, absent devices, the interrupt line, pens of two screens, hands, figures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/ticks.h"
#include "input/noise.h"
#include "input/unit.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define MS       CRT_PS_PER_MS

struct rig {
    struct crt_catalogue catalogue;
    struct inp_setup setup;
    struct inp_unit unit;
    bool level; /* of the wire, as told */
    uint64_t changes, level_t;
    uint32_t line, dot, field; /* where the beam is, if anybody asks */
    bool on;
    char sent[64];
    size_t sent_length;
};

static void interrupt(void *ctx, bool level, uint64_t t)
{
    struct rig *r = ctx;
    assert_true(level != r->level);
    r->level = level;
    r->level_t = t;
    r->changes++;
}

static bool beam(void *ctx, uint64_t t, uint32_t *line, uint32_t *dot, uint32_t *field)
{
    const struct rig *r = ctx;
    (void)t;
    *line = r->line;
    *dot = r->dot;
    *field = r->field;
    return r->on;
}

static bool send(void *ctx, const char *bytes, size_t length, uint64_t t)
{
    struct rig *r = ctx;
    (void)t;
    if (r->sent_length + length > sizeof r->sent)
        return false;
    memcpy(r->sent + r->sent_length, bytes, length);
    r->sent_length += length;
    return true;
}

/* Settings "KEY=VALUE" of kinds, NULL at the end. */
static struct rig *open_rig(const char *const *kinds)
{
    struct rig *r = calloc(1, sizeof *r);
    struct crt_error err;
    bool ours;
    assert_non_null(r);
    assert_true(crt_catalogue_init(&r->catalogue, &err));
    inp_setup_default(&r->setup);
    for (int i = 0; kinds && kinds[i]; i += 2)
        assert_true(inp_setup_set_kind(&r->setup, kinds[i], kinds[i + 1], &ours, &err) && ours);
    r->on = true;
    struct inp_unit_desc desc = {.setup = &r->setup, .wires = {r, interrupt, beam, send, NULL}};
    desc.screen[INP_VECTOR] = (struct inp_screen_desc){
        crt_catalogue_tube(&r->catalogue, "VR17"), crt_phosphor_find("P31"), {0, 1, 0}};
    desc.screen[INP_RASTER] = (struct inp_screen_desc){
        crt_catalogue_tube(&r->catalogue, "MONO12"), crt_phosphor_find("P4"), {0, 1, 0}};
    inp_unit_init(&r->unit, &desc);
    return r;
}

static void close_rig(struct rig *r)
{
    crt_catalogue_free(&r->catalogue);
    free(r);
}

static uint32_t get(struct rig *r, uint32_t offset, uint64_t t)
{
    uint32_t value = 0xDEADBEEF;
    assert_true(inp_unit_read(&r->unit, offset, t, &value));
    return value;
}

static void put(struct rig *r, uint32_t offset, uint32_t value, uint64_t t)
{
    assert_true(inp_unit_write(&r->unit, offset, value, t));
}

static void run_to(struct rig *r, uint64_t t)
{
    uint64_t before = 0;
    while (r->unit.next < t) {
        assert_true(r->unit.next >= before);
        before = r->unit.next;
        inp_unit_event(&r->unit, before);
    }
}

/* ---- registers ---------------------------------------------------------------------------------- */

/* Every offset of every block as the header has it. */
static bool exists(uint32_t o)
{
    if (o % 4)
        return false;
    if (o <= INPUT_PRESENT)
        return true;
    if (o >= INPUT_PEN_VECTOR && o <= INPUT_PEN_VECTOR + PEN_FIRINGS)
        return true;
    if (o >= INPUT_PEN_RASTER && o <= INPUT_PEN_RASTER + PEN_FIRINGS)
        return true;
    if ((o >= INPUT_TABLET_KIND && o <= INPUT_TABLET_SERIAL) ||
        (o >= INPUT_TABLET_UNIT && o <= INPUT_TABLET_RATE) ||
        (o >= INPUT_TABLET_RAW && o < INPUT_TABLET_RAW + 4 * TABLET_RAW_WORDS))
        return true;
    if ((o >= INPUT_TOUCH_KIND && o <= INPUT_TOUCH_SERIAL) ||
        (o >= INPUT_TOUCH_RAW && o < INPUT_TOUCH_RAW + 4 * TOUCH_RAW_WORDS))
        return true;
    return (o >= INPUT_KEY_STATUS && o <= INPUT_KEY_MISSED) ||
           (o >= INPUT_MOUSE_KIND && o <= INPUT_MOUSE_UNIT);
}

static void registers_are_where_the_header_has_them(void **state)
{
    (void)state;
    static const char *const none[] = {"pen",   "none", "tablet",   "none", "touch", "none",
                                       "mouse", "none", "keyboard", "none", NULL};
    struct rig *r = open_rig(NULL), *bare = open_rig(none);
    for (uint32_t offset = 0; offset < 0x1000; offset++) {
        uint32_t value = 1, nothing = 1;
        assert_int_equal(inp_unit_read(&r->unit, offset, 0, &value), exists(offset));
        assert_int_equal(inp_unit_read(&bare->unit, offset, 0, &nothing), exists(offset));
        if (exists(offset))
            assert_int_equal(nothing, 0);
        assert_int_equal(inp_unit_write(&bare->unit, offset, ~0u, 0), exists(offset));
        assert_int_equal(inp_unit_write(&r->unit, offset, 0, 0), exists(offset));
    }
    assert_int_equal(get(r, INPUT_PRESENT, 0), INPUT_BITS);
    assert_int_equal(bare->unit.next, INP_NEVER); /* nothing was switched on by those writes */
    close_rig(r);
    close_rig(bare);
}

static void acts_for_absent_devices_do_nothing(void **state)
{
    (void)state;
    static const char *const kinds[] = {"pen", "none", "mouse", "none", NULL};
    struct rig *r = open_rig(kinds);
    struct inp_act pen = {.device = INP_PEN, .verb = INP_MOVE}, mouse = {.device = INP_MOUSE};
    struct inp_act finger = {.device = INP_TOUCH,
                             .screen = INP_VECTOR}; /* the panel is elsewhere */
    struct inp_act button = {.device = INP_TABLET, .verb = INP_PRESS, .code = 3};
    assert_false(inp_unit_has(&r->unit, &pen));
    assert_false(inp_unit_has(&r->unit, &mouse));
    assert_false(inp_unit_has(&r->unit, &finger));
    assert_false(inp_unit_has(&r->unit, &button)); /* a stylus has one */
    inp_unit_act(&r->unit, &pen);
    inp_unit_act(&r->unit, &mouse);
    inp_unit_act(&r->unit, &finger);
    inp_unit_act(&r->unit, &button);
    assert_int_equal(r->unit.next, INP_NEVER);
    assert_int_equal(get(r, INPUT_STATUS, 0), 0);
    close_rig(r);
}

/* ---- the interrupt ------------------------------------------------------------------------------ */

static void the_line_follows_what_is_enabled_and_taken(void **state)
{
    (void)state;
    struct rig *r = open_rig(NULL);
    const struct inp_act down = {
        .t = 5 * MS, .device = INP_KEYBOARD, .verb = INP_PRESS, .code = 'A', .character = 'a'};
    const struct inp_act click = {.t = 6 * MS, .device = INP_MOUSE, .verb = INP_PRESS, .code = 0};
    put(r, INPUT_KEY_CONTROL, KEY_STORE | KEY_CONSOLE, 0);
    inp_unit_act(&r->unit, &down);
    assert_int_equal(get(r, INPUT_STATUS, 5 * MS), INPUT_BIT_KEYBOARD);
    assert_false(r->level); /* not enabled */
    put(r, INPUT_IRQ_ENABLE, ~0u, 5 * MS + 1);
    assert_int_equal(get(r, INPUT_IRQ_ENABLE, 5 * MS + 1), INPUT_BITS);
    assert_true(r->level);
    assert_int_equal(r->level_t, 5 * MS + 1);
    inp_unit_act(&r->unit, &click);
    assert_int_equal(get(r, INPUT_STATUS, 6 * MS), INPUT_BIT_KEYBOARD | INPUT_BIT_MOUSE);
    assert_int_equal(get(r, INPUT_KEY_EVENT, 6 * MS) & (KEY_ASCII | KEY_CODE), 'A' << 8 | 'a');
    assert_true(r->level);
    put(r, INPUT_MOUSE_STATUS, MOUSE_MOVED, 7 * MS);
    assert_false(r->level);
    assert_int_equal(r->level_t, 7 * MS);
    assert_int_equal(r->changes, 2);
    assert_int_equal(r->sent_length, 1);
    assert_int_equal(r->sent[0], 'a');
    close_rig(r);
}

static void reports_interrupt_at_their_times(void **state)
{
    (void)state;
    struct rig *r = open_rig(NULL);
    const struct inp_act near = {
        .device = INP_TABLET, .verb = INP_MOVE, .x = 100000, .y = 80000, .z = 3000};
    put(r, INPUT_IRQ_ENABLE, INPUT_BIT_TABLET, 0);
    put(r, INPUT_TABLET_CONTROL, TABLET_ON, 0);
    inp_unit_act(&r->unit, &near);
    for (uint64_t n = 1; n < 50; n++) {
        uint64_t due = crt_tick_time((struct crt_rate){60, 1}, n);
        run_to(r, due);
        assert_false(r->level);
        run_to(r, due + 1);
        assert_true(r->level);
        assert_int_equal(r->level_t, due);
        assert_int_equal(get(r, INPUT_TABLET_PROXIMITY, due), TABLET_NEAR);
        put(r, INPUT_TABLET_STATUS, TABLET_REPORT, due + 1);
        assert_false(r->level);
    }
    close_rig(r);
}

/* ---- floods ------------------------------------------------------------------------------------- */

/* A hundred thousand acts in a tenth of a second, and nobody takes anything: what is missing is said to be. */
static void a_flood_is_counted_or_flagged(void **state)
{
    (void)state;
    enum { ACTS = 100000 };
    struct rig *r = open_rig(NULL);
    uint32_t keys = 0;
    put(r, INPUT_KEY_CONTROL, KEY_STORE, 0);
    put(r, INPUT_TABLET_CONTROL, TABLET_ON, 0);
    put(r, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
    for (uint64_t i = 0; i < ACTS; i++) {
        uint64_t t = MS + i * CRT_PS_PER_US;
        struct inp_act act = {.t = t, .device = (uint8_t)(i % 5), .verb = INP_MOVE};
        act.screen = act.device == INP_TOUCH ? INP_RASTER : INP_VECTOR;
        act.x = (int32_t)(inp_noise_bits(5, i) % 90000);
        act.y = (int32_t)(inp_noise_bits(6, i) % 90000);
        if (act.device == INP_MOUSE)
            act = (struct inp_act){.t = t, .device = INP_MOUSE, .x = 25}; /* a tenth of a count */
        if (act.device == INP_KEYBOARD) {
            act = (struct inp_act){.t = t, .device = INP_KEYBOARD, .code = 'A', .character = 'a'};
            act.verb = i % 10 < 5 ? INP_PRESS : INP_RELEASE;
            keys++;
        }
        run_to(r, t);
        inp_unit_act(&r->unit, &act);
    }
    uint64_t end = MS + ACTS * CRT_PS_PER_US;
    run_to(r, end);
    assert_int_equal(get(r, INPUT_KEY_WAITING, end), KEY_EVENTS_MOST);
    assert_int_equal(get(r, INPUT_KEY_MISSED, end), keys - KEY_EVENTS_MOST);
    assert_int_equal(get(r, INPUT_KEY_STATUS, end), KEY_READY | KEY_LOST);
    /* 20000 moves of 25 um are 2000 counts in 0.1 s, five times as many as the counters follow. */
    uint32_t counts = get(r, INPUT_MOUSE_X, end);
    assert_in_range(counts, 300, 700);
    assert_int_equal(get(r, INPUT_MOUSE_STATUS, end), MOUSE_MOVED | MOUSE_OVERRUN);
    assert_int_equal(get(r, INPUT_TABLET_STATUS, end), TABLET_REPORT | TABLET_LOST);
    assert_int_equal(get(r, INPUT_TABLET_SERIAL, end), 1); /* the first stays */
    assert_true(get(r, INPUT_TOUCH_STATUS, end) & TOUCH_LOST);
    close_rig(r);
}

/* ---- pens --------------------------------------------------------------------------------------- */

static void one_pen_is_at_one_screen(void **state)
{
    (void)state;
    struct rig *r = open_rig(NULL);
    struct inp_act act = {.device = INP_PEN, .verb = INP_MOVE, .screen = INP_VECTOR};
    inp_unit_act(&r->unit, &act);
    assert_true(inp_unit_looks(&r->unit, INP_VECTOR));
    act.verb = INP_PRESS;
    inp_unit_act(&r->unit, &act);
    assert_int_equal(get(r, INPUT_PEN_VECTOR + PEN_STATUS, 0), PEN_TIP | PEN_TIP_MOVED);
    put(r, INPUT_PEN_VECTOR + PEN_STATUS, PEN_TIP_MOVED, 0);
    act = (struct inp_act){.device = INP_PEN, .verb = INP_MOVE, .screen = INP_RASTER};
    inp_unit_act(&r->unit, &act);
    assert_false(inp_unit_looks(&r->unit, INP_VECTOR));
    assert_true(inp_unit_looks(&r->unit, INP_RASTER));
    assert_int_equal(get(r, INPUT_PEN_VECTOR + PEN_STATUS, 0), PEN_TIP_MOVED); /* it came off */
    act.verb = INP_AWAY;
    inp_unit_act(&r->unit, &act);
    assert_false(inp_unit_looks(&r->unit, INP_RASTER));
    close_rig(r);
}

/* A white line under the pen: it fires once, and is latched where the beam is said to be. */
static void scan(struct rig *r, uint64_t t, double y)
{
    static uint8_t white[640];
    memset(white, 255, sizeof white);
    struct crt_scan_line line = {.t0 = t,
                                 .t1 = t + 25 * CRT_PS_PER_US,
                                 .x0 = -100,
                                 .x1 = 100,
                                 .y0 = (float)y,
                                 .y1 = (float)y,
                                 .dots = 640,
                                 .guns = 1,
                                 .drive = {white}};
    inp_unit_line(&r->unit, &line);
}

static void the_raster_pen_latches_where_the_beam_is(void **state)
{
    (void)state;
    struct rig *r = open_rig(NULL);
    const struct inp_act at = {.device = INP_PEN, .verb = INP_MOVE, .screen = INP_RASTER};
    const uint32_t base = INPUT_PEN_RASTER;
    r->line = 17;
    r->dot = 320;
    r->field = 9;
    inp_unit_act(&r->unit, &at);
    scan(r, MS, 0);
    run_to(r, 2 * MS);
    assert_int_equal(get(r, base + PEN_FIRINGS, 2 * MS), 1); /* counted, not latched: not enabled */
    assert_int_equal(get(r, base + PEN_STATUS, 2 * MS), 0);
    put(r, base + PEN_CONTROL, PEN_ENABLE | PEN_TIP_ENABLE, 2 * MS);
    scan(r, 3 * MS, 0);
    run_to(r, 4 * MS);
    assert_int_equal(get(r, base + PEN_STATUS, 4 * MS), 0); /* the tip is not pressed */
    put(r, base + PEN_CONTROL, PEN_ENABLE, 4 * MS);
    put(r, INPUT_IRQ_ENABLE, INPUT_BIT_PEN_RASTER, 4 * MS);
    scan(r, 5 * MS, 0);
    run_to(r, 6 * MS);
    assert_int_equal(get(r, base + PEN_STATUS, 6 * MS), PEN_HIT);
    assert_int_equal(get(r, base + PEN_LINE, 6 * MS), 17);
    assert_int_equal(get(r, base + PEN_DOT, 6 * MS), 320);
    assert_int_equal(get(r, base + PEN_FIELD, 6 * MS), 9);
    assert_true(r->level);
    /* The middle of the line is scanned 12.5 us after its beginning; the pulse comes while the beam is in
     * the aperture, or a microsecond or two later. */
    assert_in_range(r->level_t, 5 * MS + 12 * CRT_PS_PER_US, 5 * MS + 16 * CRT_PS_PER_US);
    r->line = 18;
    scan(r, 7 * MS, 0);
    run_to(r, 8 * MS);
    assert_int_equal(get(r, base + PEN_STATUS, 8 * MS), PEN_HIT | PEN_LOST);
    assert_int_equal(get(r, base + PEN_LINE, 8 * MS), 17); /* the first stays */
    put(r, base + PEN_STATUS, PEN_HIT | PEN_LOST, 8 * MS);
    assert_false(r->level);
    r->on = false; /* the head is off: there is no beam to latch */
    scan(r, 9 * MS, 0);
    run_to(r, 10 * MS);
    assert_int_equal(get(r, base + PEN_STATUS, 10 * MS), 0);
    close_rig(r);
}

/* ---- hands -------------------------------------------------------------------------------------- */

static void a_hand_goes_straight_and_rests(void **state)
{
    (void)state;
    struct inp_hand hand = {.there = false};
    inp_hand_move(&hand, (struct inp_place){10, 20, 5}, 100, 1000); /* it was away: at once */
    assert_true(inp_hand_at(&hand, 100).x == 10 && inp_hand_at(&hand, 100).z == 5);
    inp_hand_move(&hand, (struct inp_place){20, 40, 0}, 1000, 1000);
    struct inp_place half = inp_hand_at(&hand, 1500);
    assert_true(half.x == 15 && half.y == 30 && half.z == 2.5);
    inp_hand_move(&hand, (struct inp_place){15, 0, 0}, 1500, 100); /* from where it has come to */
    assert_true(inp_hand_at(&hand, 1550).x == 15 && inp_hand_at(&hand, 1550).y == 15);
    assert_true(inp_hand_at(&hand, 99999).y == 0);
}

/* ---- noise -------------------------------------------------------------------------------------- */

static void noise_is_normal_and_even(void **state)
{
    (void)state;
    enum { N = 200000 };
    double sum = 0, squares = 0, fourth = 0, even = 0, most = 0;
    int beyond = 0;
    for (uint64_t i = 0; i < N; i++) {
        double v = inp_noise_normal(42, i), e = inp_noise_even(43, i);
        assert_true(e > 0 && e < 1);
        sum += v;
        squares += v * v;
        fourth += v * v * v * v;
        even += e;
        beyond += v > 2;
        most = fabs(v) > most ? fabs(v) : most;
    }
    assert_true(fabs(sum / N) < 5 / sqrt((double)N));
    assert_true(fabs(squares / N - 1) < 5 * sqrt(2.0 / N));
    assert_true(fabs(fourth / N - 3) < 5 * sqrt(96.0 / N));
    assert_true(fabs(even / N - 0.5) < 5 * sqrt(1 / 12.0 / N));
    assert_true(fabs(beyond / (double)N - 0.0227501) < 5 * sqrt(0.0227 / N));
    assert_true(most < INP_NOISE_MOST);
    assert_true(inp_noise_normal(42, 7) == inp_noise_normal(42, 7));
    assert_true(inp_noise_normal(42, 7) != inp_noise_normal(41, 7));
}

/* ---- figures ------------------------------------------------------------------------------------ */

static void figures_have_names_ranges_and_sources(void **state)
{
    (void)state;
    struct inp_setup setup;
    struct crt_error err;
    bool ours;
    inp_setup_default(&setup);
    int figures = 0;
    for (unsigned i = 0; inp_setup_key(i); i++) {
        const char *key = inp_setup_key(i), *unit = NULL, *meaning = NULL;
        struct crt_figure *f = inp_setup_figure(&setup, key, &unit, &meaning);
        if (!f) {
            assert_non_null(inp_setup_kinds(i));
            continue;
        }
        figures++;
        assert_true(f->low <= f->value && f->value <= f->high);
        assert_true(unit[0] && meaning[0] && f->source[0]);
        assert_true(inp_setup_check(&setup, key, &err));
        double value = f->value;
        f->value = f->high + fabs(f->high) * 0.01 + 1e-6;
        assert_false(inp_setup_check(&setup, key, &err));
        f->value = (double)NAN;
        assert_false(inp_setup_check(&setup, key, &err));
        f->value = value;
    }
    assert_true(figures > 20);
    assert_null(inp_setup_figure(&setup, "tablet.frob", NULL, NULL));
    assert_false(inp_setup_set_kind(&setup, "frob", "none", &ours, &err));
    assert_false(ours);
    assert_false(inp_setup_set_kind(&setup, "tablet", "stone", &ours, &err));
    assert_true(ours);
    assert_string_equal(err.text, "tablet=stone: there is no such kind; give none, electrical, "
                                  "sonic or resistive");
}

/* ---- snapshots ---------------------------------------------------------------------------------- */

static void save(struct rig *r, struct crt_state *s)
{
    crt_state_save(s);
    inp_unit_state(&r->unit, s);
    assert_false(s->failed);
}

static void snapshots_hold_all_and_hostile_ones_are_safe(void **state)
{
    (void)state;
    struct rig *a = open_rig(NULL), *b = open_rig(NULL);
    const struct inp_act acts[] = {
        {.t = 0, .device = INP_PEN, .verb = INP_MOVE, .screen = INP_RASTER, .x = 1000},
        {.t = 1, .device = INP_TABLET, .verb = INP_MOVE, .x = 50000, .y = 60000},
        {.t = 2,
         .device = INP_TABLET,
         .verb = INP_MOVE,
         .x = 90000,
         .y = 10000,
         .duration = 900 * MS},
        {.t = 3, .device = INP_TOUCH, .verb = INP_MOVE, .screen = INP_RASTER, .x = 20000},
        {.t = 4, .device = INP_KEYBOARD, .verb = INP_PRESS, .code = 'Q', .character = 'q'},
        {.t = 5, .device = INP_MOUSE, .verb = INP_MOVE, .x = 30000, .duration = 500 * MS}};
    put(a, INPUT_TABLET_CONTROL, TABLET_ON, 0);
    put(a, INPUT_TOUCH_CONTROL, TOUCH_ON, 0);
    put(a, INPUT_KEY_CONTROL, KEY_STORE, 0);
    put(a, INPUT_IRQ_ENABLE, INPUT_BITS, 0);
    for (size_t i = 0; i < COUNT(acts); i++)
        inp_unit_act(&a->unit, &acts[i]);
    run_to(a, 210 * MS);
    struct crt_state s, load, again;
    save(a, &s);
    crt_state_load(&load, s.out, s.size);
    inp_unit_state(&b->unit, &load);
    assert_false(load.failed);
    b->level = a->level;
    run_to(a, 800 * MS);
    run_to(b, 800 * MS);
    struct crt_state one;
    save(a, &one);
    save(b, &again);
    assert_int_equal(one.size, again.size);
    assert_memory_equal(one.out, again.out, one.size);
    /* Bits turned at random: refused, or harmless. */
    uint64_t n = 0;
    uint8_t *bytes = malloc(s.size);
    assert_non_null(bytes);
    for (int i = 0; i < 3000; i++) {
        memcpy(bytes, s.out, s.size);
        for (uint64_t k = 0; k <= inp_noise_bits(1, n) % 3; k++, n++)
            bytes[inp_noise_bits(2, n) % s.size] = (uint8_t)inp_noise_bits(3, n);
        crt_state_load(&load, bytes, s.size);
        inp_unit_state(&b->unit, &load);
        if (load.failed)
            continue;
        b->level = b->unit.level;
        for (int events = 0; events < 20 && b->unit.next < CRT_STATE_LATEST; events++)
            inp_unit_event(&b->unit, b->unit.next);
    }
    free(bytes);
    crt_state_free(&s);
    crt_state_free(&one);
    crt_state_free(&again);
    close_rig(a);
    close_rig(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(registers_are_where_the_header_has_them),
        cmocka_unit_test(acts_for_absent_devices_do_nothing),
        cmocka_unit_test(the_line_follows_what_is_enabled_and_taken),
        cmocka_unit_test(reports_interrupt_at_their_times),
        cmocka_unit_test(a_flood_is_counted_or_flagged),
        cmocka_unit_test(one_pen_is_at_one_screen),
        cmocka_unit_test(the_raster_pen_latches_where_the_beam_is),
        cmocka_unit_test(a_hand_goes_straight_and_rests),
        cmocka_unit_test(noise_is_normal_and_even),
        cmocka_unit_test(figures_have_names_ranges_and_sources),
        cmocka_unit_test(snapshots_hold_all_and_hostile_ones_are_safe),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
