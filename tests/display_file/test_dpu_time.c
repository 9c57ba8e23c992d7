/* Beam time, compared with sums done by hand from the figures of RIG_TIMING. */
#include "tests/support/dpu_rig.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

static void word_forms_take_their_time(void **state)
{
    (void)state;
    static const struct {
        const char *what;
        uint16_t words[6];
        unsigned count;
        uint64_t ns; /* all words together, by hand */
    } cases[] = {
        {"set mode", {0110000}, 1, 1500},
        {"jump", {0160000, 4}, 2, 3000},
        {"nop", {0164000}, 1, 1500},
        {"status A", {0170060}, 1, 1500},
        {"status B", {0174177}, 1, 1500},
        /* 3 fetches + 2000 set-up + 300 · 100 */
        {"long vector", {0110000, DF_BEAM_ON | 300, 200}, 3, 4500 + 2000 + 30000},
        {"steep vector", {0110000, DF_BEAM_ON | 200, 300}, 3, 4500 + 2000 + 30000},
        /* 2 fetches + 2000 + 63 · 100 */
        {"short vector", {0104000, DF_BEAM_ON | 63 << 7 | 3}, 2, 3000 + 2000 + 6300},
        /* 1000 + 300 · 18 = 6400 */
        {"beam-off vector", {0110000, 300, 200}, 3, 4500 + 6400},
        /* 1000 + 1000 · 18 = 19000 > 18000 */
        {"far move", {0114000, 1000, 200}, 3, 4500 + 18000},
        /* 1000 + 100 · 18, then lit for 1000 */
        {"point", {0114000, DF_BEAM_ON | 100, 50}, 3, 4500 + 2800 + 1000},
        {"point in place", {0114000, DF_BEAM_ON, 0}, 3, 4500 + 1000 + 1000},
        {"relative point", {0130000, DF_BEAM_ON | 10 << 7}, 2, 3000 + 1180 + 1000},
        {"relative move", {0130000, 10 << 7}, 2, 3000 + 1180},
        {"graphplot", {0174105, 0120000, 100}, 3, 4500 + 2800 + 1000},
        {"two characters", {0100000, 'A' | 'b' << 8}, 2, 3000 + 30000},
        {"character and NUL", {0100000, 'A'}, 2, 3000 + 15000},
        {"two spaces", {0100000, ' ' | ' ' << 8}, 2, 3000 + 30000},
        /* BS: 1000 + 14 · 18; LF: 1000 + 24 · 18 */
        {"BS, LF", {0100000, 010 | 012 << 8}, 2, 3000 + 1252 + 1432},
        {"SO, SI", {0100000, 016 | 017 << 8}, 2, 3000},
    };
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        dpu_rig_init(r);
        dpu_rig_load(r, 0, cases[i].words, cases[i].count);
        df_dpu_write(&r->dpu, DF_DPC, 0, 0);
        for (unsigned n = 0; n < cases[i].count; n++)
            df_dpu_step(&r->dpu);
        if (r->dpu.t != cases[i].ns * NS)
            fail_msg("%s takes %llu ns, not %llu", cases[i].what,
                     (unsigned long long)(r->dpu.t / NS), (unsigned long long)cases[i].ns);
    }
}

static void strokes_lie_where_they_should(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0110000, DF_BEAM_ON | 300, 200, 0114000, DF_BEAM_ON | 100, 200);
    assert_int_equal(r->count, 2);
    /* 3 fetches 4.5, set-up 2: 6.5 µs; 30 µs of beam. */
    assert_int_equal(r->strokes[0].t0, 6500 * NS);
    assert_int_equal(r->strokes[0].t1, 36500 * NS);
    /* 3 fetches, 200 units to settle: 1 + 3.6; lit 1 µs. */
    assert_int_equal(r->strokes[1].t0, (36500 + 4500 + 4600) * NS);
    assert_int_equal(r->strokes[1].t1, (36500 + 4500 + 5600) * NS);
    assert_int_equal(r->dpu.usage.strokes, 2);
    assert_int_equal(r->dpu.usage.lit_ps, 31 * US);
    assert_int_equal(r->dpu.usage.vectors, 1);
    assert_int_equal(r->dpu.usage.points, 1);
}

static void off_screen_and_dark_items_take_the_same_time(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 1000, 0, 0110000, DF_BEAM_ON | 300, 0);
    assert_int_equal(r->count, 0);
    assert_int_equal(r->dpu.t, (7 * 1500 + 18000 + 2000 + 30000) * NS);
}

static void dots_lie_in_their_slots(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 100, 100, 0100000, 'H');
    assert_true(r->count >= 18);
    uint64_t cell = (5 * 1500 + 1000 + 1800) * NS;
    for (size_t i = 0; i < r->count; i++) {
        unsigned column = (unsigned)((rig_x0(&r->strokes[i]) - 100) / 2);
        unsigned row = (unsigned)((rig_y0(&r->strokes[i]) - 100) / 2);
        assert_true(column < 6 && row < 8);
        assert_int_equal(r->strokes[i].t0, cell + 15 * US * (column * 8 + row) / 48);
        assert_int_equal(r->strokes[i].t1 - r->strokes[i].t0, 250 * NS);
    }
    assert_int_equal(r->dpu.t, cell + 15 * US + FETCH);
}

static void long_dots_are_cut_to_their_slots(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing.dot_ps = 5 * US;
    dpu_rig_restart(r);
    RUN(r, 0114000, 100, 100, 0100000, 0177);
    assert_true(r->count > 30);
    for (size_t i = 1; i < r->count; i++)
        assert_true(r->strokes[i].t0 >= r->strokes[i - 1].t1);
}

static void average_charges_every_instruction_the_same(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing.average_ps = 20 * US + 1; /* odd: the halves differ */
    dpu_rig_restart(r);
    LOAD(r, 0, 0114000, DF_BEAM_ON | 500, 500, /* 2 instructions */
         0110000, DF_BEAM_ON | 300, 0,         /* 2 */
         0104000, DF_BEAM_ON | 1 << 7,         /* 2 */
         0100000, 'A' | 'B' << 8,              /* 2 */
         0174105, 0120000, 7, 9,               /* 4 */
         0130000, DF_BEAM_ON | 1,              /* 2 */
         0160000, 0100);                       /* 1 */
    LOAD(r, 0100, 0164000, DF_STOP);           /* 2 */
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    while (r->dpu.state == DF_RUNNING) {
        uint64_t before = r->dpu.t;
        df_dpu_step(&r->dpu);
        uint64_t took = r->dpu.t - before;
        assert_true(took == 20 * US + 1 || took == 10 * US || took == 10 * US + 1);
        assert_int_equal(r->dpu.t % (20 * US + 1),
                         r->dpu.phase ? 10 * US : 0); /* half-way or complete */
        if (r->count)
            assert_true(r->strokes[r->count - 1].t1 <= r->dpu.t);
    }
    assert_int_equal(r->dpu.instructions, 17);
    assert_int_equal(r->dpu.words, 20);
    assert_int_equal(r->dpu.t, 17 * (20 * US + 1));
    /* The long vector: its second word has 10 µs + 1 ps for what takes 33.5 µs, 3.5 of them dark.
     */
    uint64_t t0 = 3 * (20 * US + 1) + 10 * US, w = 10 * US + 1;
    assert_int_equal(r->strokes[1].t0, t0 + w * 35 / 335);
    assert_int_equal(r->strokes[1].t1, t0 + w);
}

/* What an interrupt leaves for RESUME takes its share of the instruction's time then. */
static void average_is_shared_with_resume(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing.average_ps = 20 * US;
    dpu_rig_restart(r);
    /* A bad code first: its half at once, the second character's half after RESUME. */
    LOAD(r, 0, 0100000, 016 << 8, 'A' | 1 << 8, DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->dpu.t, 50 * US);
    df_dpu_write(&r->dpu, DF_DPC, 1, 100 * US);
    assert_true(r->count > 0);
    assert_int_equal(r->dpu.t, 110 * US);
    dpu_rig_continue(r);
    assert_int_equal(r->dpu.t, 130 * US);
    /* The stop interrupt comes when the stop word's time is over. */
    LOAD(r, 0, 0173400);
    df_dpu_write(&r->dpu, DF_DPC, 0, 500 * US);
    dpu_rig_continue(r);
    assert_int_equal(r->events[r->event_count - 1].t, r->dpu.t);
    assert_int_equal(r->dpu.t, 520 * US);
    /* A pen hit half-way through a vector, without a spot: the other half is drawn after RESUME. */
    dpu_rig_init(r);
    r->desc.timing.average_ps = 20 * US;
    dpu_rig_restart(r);
    LOAD(r, 0, 0170300, 0104140, DF_BEAM_ON | 50 << 7, DF_STOP);
    /* 1.5 and 2 µs of 8.5 are dark. */
    uint64_t begin = 40 * US + 20 * US * 35 / 85, half = (60 * US - begin) / 2;
    r->pen_at = begin + half;
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_int_equal(r->dpu.t, begin + half);
    df_dpu_write(&r->dpu, DF_DPC, 1, 100 * US);
    assert_int_equal(r->dpu.t, 100 * US + (60 * US - begin - half));
    /* A hit as the word is fetched, were a pen to fire so early: still no word takes nothing. */
    dpu_rig_init(r);
    r->desc.timing.average_ps = 2;
    dpu_rig_restart(r);
    LOAD(r, 0, 0170300, 0104140, DF_BEAM_ON | 50 << 7, DF_STOP);
    r->pen_at = 4;
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    for (uint64_t before = 0; r->dpu.state == DF_RUNNING; before = r->dpu.t) {
        df_dpu_step(&r->dpu);
        assert_true(r->dpu.t > before);
    }
}

/* The question of the textbook: instructions of 33.33 µs, 30 refreshes a second. */
static void a_thousand_instructions_at_thirty_refreshes(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing.average_ps = 33330 * NS;
    dpu_rig_restart(r);
    /* Mode, point (two words), 997 long and short vectors, and the jump back: 1000 instructions. */
    uint16_t at = 0;
    LOAD(r, at, 0114000, 100, 100);
    at = 6;
    unsigned instructions = 2;
    LOAD(r, at, 0110000);
    at += 2, instructions++;
    for (int i = 0; i < 500; i++, at += 4, instructions++)
        LOAD(r, at, (uint16_t)(DF_BEAM_ON | (i & 1 ? DF_SIGN_X : 0) | 100), 0);
    LOAD(r, at, 0104000);
    at += 2, instructions++;
    for (; instructions < 999; at += 2, instructions++)
        LOAD(r, at, (uint16_t)(DF_BEAM_ON | 5 << 7 | (instructions & 1 ? DF_SIGN_X : 0)));
    LOAD(r, at, 0160000, 0);
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    uint64_t refreshes = 0;
    while (r->dpu.t < 1000 * 1000 * US) {
        df_dpu_step(&r->dpu);
        r->count = 0;
        if (r->dpu.dpc == 0 && r->dpu.phase == 0) {
            refreshes++;
            assert_int_equal(r->dpu.instructions, 1000 * refreshes);
            assert_int_equal(r->dpu.t, refreshes * 33330 * US); /* 33.33 ms each */
        }
    }
    assert_int_equal(refreshes, 30); /* 1 / 33.33 ms = 30.003 */
}

static void time_does_not_drift(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing.vector_unit_ps = 99991; /* prime */
    dpu_rig_restart(r);
    LOAD(r, 0, 0110000, DF_BEAM_ON | 997, 0, DF_BEAM_ON | DF_SIGN_X | 997, 0, 0160000, 0);
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    for (int i = 0; i < 7 * 1000; i++) {
        df_dpu_step(&r->dpu);
        r->count = 0;
    }
    assert_int_equal(r->dpu.t, 1000 * (7 * FETCH + 2 * (2 * US + UINT64_C(997) * 99991)));
}

static void absurd_times_are_limited(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.timing = (struct df_timing){0};
    dpu_rig_restart(r);
    RUN(r, 0114000, DF_BEAM_ON | 5, 5, 0110000, DF_BEAM_ON | 9, 9, 0100000, 'A' | 'B' << 8);
    assert_int_equal(r->dpu.t, 9 + 1 + 9); /* a ps a word, a point, a unit */
    r->desc.timing = (struct df_timing){UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX,
                                        UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX,
                                        UINT64_MAX, UINT64_MAX, UINT64_MAX};
    dpu_rig_restart(r);
    RUN(r, 0114000, DF_BEAM_ON | 5, 5, 0110000, DF_BEAM_ON | 9, 9, 0100000, 'A' | 'B' << 8);
    assert_int_equal(r->dpu.t, 7 * 1000000 * US); /* instructions of a second */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(word_forms_take_their_time),
        cmocka_unit_test(strokes_lie_where_they_should),
        cmocka_unit_test(off_screen_and_dark_items_take_the_same_time),
        cmocka_unit_test(dots_lie_in_their_slots),
        cmocka_unit_test(long_dots_are_cut_to_their_slots),
        cmocka_unit_test(average_charges_every_instruction_the_same),
        cmocka_unit_test(average_is_shared_with_resume),
        cmocka_unit_test(a_thousand_instructions_at_thirty_refreshes),
        cmocka_unit_test(time_does_not_drift),
        cmocka_unit_test(absurd_times_are_limited),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
