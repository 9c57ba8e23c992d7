/* What all tablets share: when they report, what is lost, proximity, buttons, moves, registers. */
#include "tests/input/tablet_rig.h"

#define KINDS 3 /* TABLET_ELECTRICAL … */

/* ---- time --------------------------------------------------------------------------------------- */

static void reports_come_at_the_ticks(void **state)
{
    (void)state;
    const struct {
        double hz;
        uint64_t num, den;
    } rates[] = {{60, 60, 1}, {30, 30, 1}, {59.94, 5994, 100}, {33.333, 33333, 1000}};
    for (unsigned i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        struct tablet_rig r;
        rig_open(&r, TABLET_ELECTRICAL);
        r.setup.rate.value = rates[i].hz;
        assert_true(inp_tablet_next(&r.tablet) == UINT64_MAX);
        r.now = 123456789012345;
        rig_on(&r, 0);
        rig_move(&r, 100, 100, 0, 0);
        assert_int_equal(rig_read(&r, INPUT_TABLET_RATE), rates[i].num * 1000 / rates[i].den);
        struct crt_rate rate = {rates[i].num, rates[i].den};
        uint64_t began = r.now;
        for (uint64_t n = 1; n <= 1000; n++) {
            uint64_t due = began + crt_tick_time(rate, n);
            assert_int_equal(inp_tablet_next(&r.tablet), due);
            assert_false(inp_tablet_event(&r.tablet, due - 1)); /* not yet */
            assert_int_equal(inp_tablet_next(&r.tablet), due);
            assert_true(rig_event(&r));
            assert_int_equal(rig_take(&r).serial, n);
        }
    }
}

static void switching_on_begins_a_period(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_SONIC);
    rig_move(&r, 100, 100, 5, 0);
    rig_on(&r, 0);
    for (int i = 0; i < 7; i++)
        assert_true(rig_event(&r));
    r.now += 3000;
    rig_on(&r, TABLET_LATEST); /* it is on already: nothing begins anew */
    assert_int_equal(inp_tablet_next(&r.tablet), crt_tick_time((struct crt_rate){60, 1}, 8));
    rig_write(&r, INPUT_TABLET_CONTROL, 0);
    assert_true(inp_tablet_next(&r.tablet) == UINT64_MAX);
    assert_false(inp_tablet_event(&r.tablet, r.now + CRT_PS_PER_S));
    r.now += 5 * CRT_PS_PER_S + 7;
    rig_on(&r, 0);
    assert_int_equal(inp_tablet_next(&r.tablet), r.now + CRT_PS_PER_S / 60);
    rig_act(&r, INP_AWAY, 0); /* it was there when the tablet was on before: that is forgotten */
    assert_false(rig_event(&r));
}

/* Whoever comes late finds the hand where it was when it was due. */
static void a_late_event_is_of_its_time(void **state)
{
    (void)state;
    struct tablet_rig r, late;
    for (int i = 0; i < 2; i++) {
        struct tablet_rig *one = i ? &late : &r;
        rig_open(one, TABLET_SONIC);
        rig_on(one, 0);
        rig_move(one, 0, 0, 2, 0);
        rig_move(one, 250, 250, 2, CRT_PS_PER_S / 10);
    }
    for (int n = 0; n < 6; n++) {
        assert_true(rig_event(&r));
        assert_true(inp_tablet_event(&late.tablet, r.now + CRT_PS_PER_MS));
        struct rig_seen a = rig_take(&r), b = rig_take(&late);
        assert_true(a.x == b.x && a.y == b.y && a.z == b.z);
        assert_int_equal(inp_tablet_next(&r.tablet), inp_tablet_next(&late.tablet));
    }
}

/* ---- one place for reports ---------------------------------------------------------------------- */

static void a_program_that_never_takes(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_RESISTIVE);
    r.setup.noise.value = r.setup.bow.value = 0;
    rig_on(&r, 0);
    rig_move(&r, 50, 60, 0, 0);
    assert_true(rig_event(&r));
    assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), TABLET_REPORT);
    for (int i = 0; i < 100; i++) {
        rig_move(&r, 70 + i, 80, 0, 0);
        assert_true(rig_event(&r));
        assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), TABLET_REPORT | TABLET_LOST);
        rig_within((int32_t)rig_read(&r, INPUT_TABLET_X) * 0.01, 49.95, 50.05);
        assert_int_equal(rig_read(&r, INPUT_TABLET_SERIAL), 1);
    }
    rig_take(&r);
    assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), TABLET_LOST);
    assert_false(inp_tablet_ready(&r.tablet));
    rig_event(&r);
    assert_true(inp_tablet_ready(&r.tablet));
    assert_int_equal(rig_take(&r).serial, 102); /* the gap tells how many: 100 */
    assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), TABLET_LOST);
    rig_write(&r, INPUT_TABLET_STATUS, TABLET_LOST);
    assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), 0);
}

/* A program that takes now and then: LOST exactly when there is a gap, and gaps count what is missing. */
static void gaps_are_losses(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_SONIC);
    rig_on(&r, 0);
    rig_move(&r, 50, 60, 0, 0);
    unsigned last = 0, untaken = 0, gaps = 0;
    for (int i = 0; i < 2000; i++) {
        assert_true(rig_event(&r));
        untaken++;
        if (rig_bits(&r) >> 40 & 1)
            continue;
        bool lost = rig_read(&r, INPUT_TABLET_STATUS) & TABLET_LOST;
        struct rig_seen seen = rig_take(&r);
        assert_int_equal(seen.serial, last + 1); /* the first of those that came */
        assert_int_equal(lost, untaken > 1);
        gaps += untaken > 1;
        last = seen.serial + untaken - 1;
        untaken = 0;
        rig_write(&r, INPUT_TABLET_STATUS, TABLET_LOST);
    }
    rig_within(gaps, 300, 700);
}

static void the_latest_replaces(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_RESISTIVE);
    r.setup.noise.value = r.setup.bow.value = 0;
    rig_on(&r, TABLET_LATEST);
    for (int i = 1; i <= 50; i++) {
        rig_move(&r, 20 + i, 80, 0, 0);
        assert_true(rig_event(&r));
        assert_int_equal(rig_read(&r, INPUT_TABLET_STATUS), TABLET_REPORT); /* no loss */
        rig_within((int32_t)rig_read(&r, INPUT_TABLET_X) * 0.01, 19.98 + i, 20.02 + i);
        assert_int_equal(rig_read(&r, INPUT_TABLET_SERIAL), i);
    }
}

/* ---- proximity ---------------------------------------------------------------------------------- */

static void far_is_said_once(void **state)
{
    (void)state;
    for (unsigned kind = 1; kind <= KINDS; kind++) {
        struct tablet_rig r;
        struct rig_seen near, far;
        rig_open(&r, kind);
        rig_on(&r, 0);
        for (int i = 0; i < 10; i++)
            assert_false(rig_event(&r)); /* away from the beginning: nothing at all */
        assert_int_equal(rig_read(&r, INPUT_TABLET_SERIAL), 0);
        for (int round = 1; round <= 20; round++) {
            assert_true(rig_measure(&r, 30 + round, 40, 5, &near));
            assert_int_equal(near.proximity, TABLET_NEAR);
            if (round % 2)
                rig_act(&r, INP_AWAY, 0);
            else
                rig_move(&r, 30, 40, 2000, 0);
            assert_true(rig_event(&r));
            far = rig_take(&r);
            assert_int_equal(far.proximity, TABLET_FAR);
            assert_true(far.x == near.x && far.y == near.y && far.z == near.z);
            assert_int_equal(far.serial, near.serial + 1);
            for (int i = 0; i < 5; i++)
                assert_false(rig_event(&r));
            assert_int_equal(far.serial, 2 * round);
        }
    }
}

/* "The last ones measured" are those of a report that was lost, too. */
static void far_has_the_last_place(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_RESISTIVE);
    r.setup.noise.value = r.setup.bow.value = 0;
    rig_on(&r, 0);
    rig_move(&r, 10, 10, 0, 0);
    rig_event(&r);
    rig_move(&r, 200, 150, 0, 0);
    rig_event(&r); /* lost */
    rig_take(&r);
    rig_act(&r, INP_AWAY, 0);
    rig_event(&r);
    struct rig_seen far = rig_take(&r);
    assert_int_equal(far.proximity, TABLET_FAR);
    rig_within(far.x, 199.98, 200.02);
    rig_within(far.y, 149.98, 150.02);
}

static void down_and_up(void **state)
{
    (void)state;
    for (unsigned kind = 1; kind <= KINDS; kind++) {
        struct tablet_rig r;
        struct rig_seen seen;
        rig_open(&r, kind);
        assert_false(rig_measure(&r, 100, 100, 1100, &seen));
        assert_true(rig_measure(&r, 100, 100, 5, &seen));
        assert_int_equal(seen.proximity, TABLET_NEAR);
        assert_int_equal(seen.buttons, 0);
        assert_true(rig_measure(&r, 100, 100, 0, &seen));
        assert_int_equal(seen.proximity, TABLET_TOUCH);
        assert_int_equal(seen.buttons, 1); /* the surface closes the tip switch */
        assert_true(rig_measure(&r, 100, 100, -2000, &seen));
        assert_int_equal(seen.proximity, TABLET_TOUCH);
        assert_true(seen.z < 0.5); /* nothing is below the surface */
        assert_true(rig_measure(&r, 100, 100, 5, &seen));
        assert_int_equal(seen.proximity, TABLET_NEAR);
        assert_int_equal(seen.buttons, 0);
        rig_act(&r, INP_PRESS, 0); /* against something that lies there */
        assert_true(rig_measure(&r, 100, 100, 5, &seen));
        assert_int_equal(seen.proximity, TABLET_TOUCH);
        assert_int_equal(seen.buttons, 1);
    }
}

static void how_near_is_near(void **state)
{
    (void)state;
    const struct {
        unsigned kind;
        double near, reach;
    } cases[] = {{TABLET_ELECTRICAL, 12.7, 300}, {TABLET_ELECTRICAL, 1, 300},
                 {TABLET_ELECTRICAL, 25, 300},   {TABLET_RESISTIVE, 12.7, 300},
                 {TABLET_SONIC, 12.7, 300},      {TABLET_SONIC, 1, 1000},
                 {TABLET_SONIC, 1, 10}};
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        rig_open(&r, cases[i].kind);
        r.setup.noise.value = 0;
        r.setup.near.value = cases[i].near;
        r.setup.reach.value = cases[i].reach;
        double limit = cases[i].kind == TABLET_SONIC ? cases[i].reach : cases[i].near;
        for (int n = 0; n < 50; n++) {
            double x = rig_between(&r, 0, 280), y = rig_between(&r, 0, 280);
            assert_true(rig_measure(&r, x, y, limit - 0.1, &seen));
            assert_int_equal(seen.proximity, TABLET_NEAR);
            assert_false(rig_measure(&r, x, y, limit + 0.1, &seen));
        }
    }
}

/* ---- buttons ------------------------------------------------------------------------------------ */

static void buttons_of_a_puck(void **state)
{
    (void)state;
    for (unsigned count = 1; count <= 4; count++) {
        struct tablet_rig r;
        rig_open(&r, TABLET_ELECTRICAL);
        r.setup.buttons.value = count;
        rig_on(&r, 0);
        rig_move(&r, 100, 100, 0, 0);
        bool held[256] = {false};
        for (int i = 0; i < 500; i++) {
            unsigned code = (unsigned)(rig_bits(&r) >> 40) % (i % 10 ? 5 : 256);
            bool press = rig_bits(&r) >> 50 & 1;
            rig_act(&r, press ? INP_PRESS : INP_RELEASE, code);
            held[code] = press;
            unsigned wanted = 0;
            for (unsigned b = 0; b < count; b++)
                wanted |= held[b] ? 1u << b : 0;
            assert_true(rig_event(&r));
            struct rig_seen seen = rig_take(&r);
            /* A stylus that lies there has its tip switch closed; a puck does not press by itself. */
            assert_int_equal(seen.buttons, count == 1 ? 1 : wanted);
            assert_int_equal(seen.proximity, TABLET_TOUCH);
        }
        for (unsigned b = 0; b < count; b++)
            rig_act(&r, INP_PRESS, b);
        rig_act(&r, INP_AWAY, 0);
        rig_move(&r, 100, 100, 5, 0);
        rig_event(&r);
        assert_int_equal(rig_take(&r).buttons, 0); /* the hand had let go */
        rig_act(&r, INP_PRESS, 0);
        rig_event(&r); /* a button says nothing of the surface; a tip switch does */
        struct rig_seen seen = rig_take(&r);
        assert_int_equal(seen.proximity, count == 1 ? TABLET_TOUCH : TABLET_NEAR);
        assert_int_equal(seen.buttons, 1);
    }
}

/* ---- moves -------------------------------------------------------------------------------------- */

static void a_move_is_sampled(void **state)
{
    (void)state;
    for (unsigned kind = 1; kind <= KINDS; kind++) {
        struct tablet_rig r;
        rig_open(&r, kind);
        r.setup.noise.value = r.setup.bow.value = 0;
        rig_on(&r, 0);
        rig_move(&r, 20, 250, 2, 0);
        r.now = 1;
        rig_move(&r, 260, 30, 2, CRT_PS_PER_S);
        for (int n = 1; n <= 70; n++) {
            assert_true(rig_event(&r));
            struct rig_seen seen = rig_take(&r);
            double part = n < 60 ? n / 60.0 : 1;
            rig_within(seen.x - (20 + 240 * part), -0.05, 0.05);
            rig_within(seen.y - (250 - 220 * part), -0.05, 0.05);
        }
    }
}

/* However much the hand does between two reports: nothing but its place at the instant counts. */
static void a_flood_between_reports(void **state)
{
    (void)state;
    for (unsigned kind = 1; kind <= KINDS; kind++) {
        struct tablet_rig flooded, calm;
        rig_open(&flooded, kind);
        rig_open(&calm, kind);
        rig_on(&flooded, 0);
        rig_on(&calm, 0);
        for (int n = 0; n < 20; n++) {
            uint64_t due = inp_tablet_next(&flooded.tablet);
            for (int i = 0; i < 2000; i++) {
                flooded.now += (due - flooded.now) / 1000;
                rig_move(&flooded, rig_between(&flooded, -9000, 9000),
                         rig_between(&flooded, -500, 500), rig_between(&flooded, -50, 900),
                         rig_bits(&flooded) % CRT_PS_PER_S);
                rig_act(&flooded, i % 3 ? INP_PRESS : i % 2 ? INP_RELEASE : INP_AWAY, 0);
            }
            rig_act(&flooded, INP_AWAY, 0);
            rig_move(&flooded, 10 * n, 100, 4, 0);
            rig_move(&calm, 10 * n, 100, 4, 0);
            assert_true(rig_event(&flooded) && rig_event(&calm));
            struct rig_seen a = rig_take(&flooded), b = rig_take(&calm);
            assert_true(a.x == b.x && a.y == b.y && a.z == b.z && a.serial == b.serial);
            assert_true(a.proximity == b.proximity && a.buttons == b.buttons);
        }
    }
}

/* ---- registers ---------------------------------------------------------------------------------- */

static bool documented(uint32_t offset)
{
    bool head = offset >= INPUT_TABLET_KIND && offset <= INPUT_TABLET_SERIAL;
    bool what = offset >= INPUT_TABLET_UNIT && offset <= INPUT_TABLET_RATE;
    bool raw = offset >= INPUT_TABLET_RAW && offset < INPUT_TABLET_RAW + 4 * TABLET_RAW_WORDS;
    return offset % 4 == 0 && (head || what || raw);
}

static void only_documented_registers(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind <= KINDS; kind++) {
        struct tablet_rig r;
        rig_open(&r, kind);
        for (uint32_t offset = 0; offset < 2048; offset++) {
            uint32_t value;
            assert_int_equal(inp_tablet_read(&r.tablet, offset, &value), documented(offset));
            struct inp_tablet was = r.tablet;
            assert_int_equal(inp_tablet_write(&r.tablet, offset, UINT32_MAX, 9),
                             documented(offset));
            if (offset != INPUT_TABLET_CONTROL)
                assert_memory_equal(&was, &r.tablet, sizeof was);
        }
        uint32_t on = kind ? TABLET_ON | TABLET_LATEST : 0;
        assert_int_equal(rig_read(&r, INPUT_TABLET_CONTROL), on);
    }
}

static void none_reads_zero(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_NONE);
    rig_move(&r, 100, 100, 0, 0);
    rig_on(&r, 0);
    assert_true(inp_tablet_next(&r.tablet) == UINT64_MAX);
    assert_false(inp_tablet_event(&r.tablet, CRT_PS_PER_S));
    for (uint32_t offset = INPUT_TABLET_KIND; offset < 0x260; offset += 4)
        if (documented(offset))
            assert_int_equal(rig_read(&r, offset), 0);
}

static void what_it_is(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_SONIC);
    r.setup.resolution.value = 0.0127;
    r.setup.width.value = 1828.8;
    r.setup.height.value = 1219.2;
    assert_int_equal(rig_read(&r, INPUT_TABLET_KIND), TABLET_SONIC);
    assert_int_equal(rig_read(&r, INPUT_TABLET_UNIT), 12700);
    assert_int_equal(rig_read(&r, INPUT_TABLET_WIDTH), 144000);
    assert_int_equal(rig_read(&r, INPUT_TABLET_HEIGHT), 96000);
    assert_int_equal(rig_read(&r, INPUT_TABLET_RATE), 60000);
}

/* Counts, not fractions of them: a place and the one half a count from it differ by one count or none. */
static void places_are_whole_counts(void **state)
{
    (void)state;
    struct tablet_rig r;
    struct rig_seen seen;
    rig_open(&r, TABLET_ELECTRICAL);
    r.setup.noise.value = 0;
    r.setup.resolution.value = 5;
    for (int i = 0; i < 500; i++) {
        double x = rig_between(&r, 0, 280), y = rig_between(&r, 0, 280);
        assert_true(rig_measure(&r, x, y, 0, &seen));
        rig_within(seen.x - x, -2.52, 2.52);
        rig_within(seen.y - y, -2.52, 2.52);
    }
}

/* Any figure anywhere in its range, often at an end of it. */
static void any_figures(struct tablet_rig *r, int i)
{
    rig_open(r, 1 + (unsigned)i % KINDS);
    r->seed += (uint64_t)i * 15485863;
    struct crt_figure *all[] = {
#define X(field, unit, is, least, most, meaning, from) &r->setup.field,
        INP_TABLET_FIGURES(X)
#undef X
    };
    for (unsigned f = 0; f < sizeof all / sizeof all[0]; f++) {
        uint64_t how = rig_bits(r) >> 40 & 3;
        double between = rig_between(r, all[f]->low, all[f]->high);
        all[f]->value = how == 0 ? all[f]->low : how == 1 ? all[f]->high : between;
    }
    r->setup.buttons.value = floor(r->setup.buttons.value);
}

static void figures_are_in_order(void **state)
{
    (void)state;
#define X(field, unit, is, least, most, meaning, from)                                             \
    assert_true((is) >= (least) && (is) <= (most) && strlen(meaning) && strlen(from));
    INP_TABLET_FIGURES(X)
#undef X
}

/* A stylus on the surface is found, near the place: half a count, what bends, counts and drowns added. */
static void every_figure_works(void **state)
{
    (void)state;
    for (int i = 0; i < 6000; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        any_figures(&r, i);
        struct inp_tablet_setup *setup = &r.setup;
        setup->temperature.value = setup->assumed.value;
        setup->radius.value = 0;
        double x = rig_between(&r, 0, setup->width.value);
        double y = rig_between(&r, 0, setup->height.value);
        double z = i % 2 ? 0 : fmax(0, fmin(5, setup->near.value - 3)); /* heights are noisy, too */
        double most = setup->resolution.value / 2 + 0.05;
        if (setup->kind == TABLET_ELECTRICAL)
            most += 0.12 + setup->noise.value * (z > 0 ? 30 : 8);
        if (setup->kind == TABLET_SONIC)
            most += 8 * (setup->noise.value + 0.35 / setup->clock.value) *
                    fmax(setup->width.value / setup->height.value,
                         setup->height.value / setup->width.value);
        if (setup->kind == TABLET_RESISTIVE)
            most += setup->bow.value + setup->noise.value * (z > 0 ? 20 : 8);
        assert_true(rig_measure(&r, x, y, z, &seen));
        rig_within(seen.x - x, -most, most);
        rig_within(seen.y - y, -most, most);
        assert_true(z > 0 || seen.proximity == TABLET_TOUCH);
        rig_within((int32_t)rig_read(&r, INPUT_TABLET_Z), 0, 200000);
        assert_true(rig_read(&r, INPUT_TABLET_WIDTH) * setup->resolution.value > 147);
    }
}

/* The hand anywhere at all, the air at any temperature: whatever is reported is a number. */
static void anywhere_at_all(void **state)
{
    (void)state;
    unsigned found = 0;
    for (int i = 0; i < 20000; i++) {
        struct tablet_rig r;
        struct rig_seen seen;
        any_figures(&r, i);
        double most = i % 4 ? 2000 : 2000000;
        if (!rig_measure(&r, rig_between(&r, -most, most), rig_between(&r, -most, most),
                         rig_between(&r, -most, most / 3), &seen))
            continue;
        found++;
        rig_within(seen.x, -2600, 2600 + r.setup.width.value);
        rig_within(seen.y, -2600, 2600 + r.setup.height.value);
        rig_within(seen.z, 0, 1600);
    }
    assert_true(found > 1000);
}

static void power_on_leaves_the_hand(void **state)
{
    (void)state;
    struct tablet_rig r;
    rig_open(&r, TABLET_ELECTRICAL);
    rig_on(&r, TABLET_LATEST);
    rig_move(&r, 100, 120, 3, 0);
    rig_act(&r, INP_PRESS, 0);
    for (int i = 0; i < 5; i++)
        rig_event(&r);
    inp_tablet_reset(&r.tablet, r.now += 77);
    assert_true(inp_tablet_next(&r.tablet) == UINT64_MAX);
    for (uint32_t offset = INPUT_TABLET_STATUS; offset <= INPUT_TABLET_SERIAL; offset += 4)
        assert_int_equal(rig_read(&r, offset), 0);
    rig_on(&r, 0);
    assert_true(rig_event(&r));
    struct rig_seen seen = rig_take(&r);
    assert_int_equal(seen.serial, 1);
    assert_int_equal(seen.buttons, 1);
    rig_within(seen.x, 99, 101);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reports_come_at_the_ticks),
        cmocka_unit_test(switching_on_begins_a_period),
        cmocka_unit_test(a_late_event_is_of_its_time),
        cmocka_unit_test(a_program_that_never_takes),
        cmocka_unit_test(gaps_are_losses),
        cmocka_unit_test(the_latest_replaces),
        cmocka_unit_test(far_is_said_once),
        cmocka_unit_test(far_has_the_last_place),
        cmocka_unit_test(down_and_up),
        cmocka_unit_test(how_near_is_near),
        cmocka_unit_test(buttons_of_a_puck),
        cmocka_unit_test(a_move_is_sampled),
        cmocka_unit_test(a_flood_between_reports),
        cmocka_unit_test(only_documented_registers),
        cmocka_unit_test(none_reads_zero),
        cmocka_unit_test(what_it_is),
        cmocka_unit_test(places_are_whole_counts),
        cmocka_unit_test(figures_are_in_order),
        cmocka_unit_test(every_figure_works),
        cmocka_unit_test(anywhere_at_all),
        cmocka_unit_test(power_on_leaves_the_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
