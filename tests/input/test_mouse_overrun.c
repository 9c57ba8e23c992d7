/* Counters that follow so many counts a second: against a model that goes from count to count, at the limit, and
 * with the moves that a window tells of. */
#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "tests/input/mouse_rig.h"

#define MS CRT_PS_PER_MS
#define S  CRT_PS_PER_S

static bool overrun(const struct mouse_rig *r, uint64_t t)
{
    return (mouse_rig_get(r, INPUT_MOUSE_STATUS, t) & MOUSE_OVERRUN) != 0;
}

/* ---- the limit --------------------------------------------------------------------------------- */

/* A metre, 4000 counts, at 4000 counts a second. */
static void at_the_limit_nothing_is_missing(void **state)
{
    (void)state;
    const struct {
        uint64_t duration;
        int counts;
    } cases[] = {{2 * S, 4000},      {S, 4000},     {S - 1, 4000}, {S - 3 * MS / 10, 3999},
                 {9 * S / 10, 3601}, {S / 2, 2001}, {1, 1}};
    for (int i = 0; i < 7; i++)
        for (int sign = -1; sign <= 1; sign += 2) {
            struct mouse_rig r;
            mouse_rig_open(&r, MOUSE_MECHANICAL);
            uint64_t start = S, end = start + cases[i].duration;
            mouse_rig_move(&r, start, cases[i].duration, sign * 1000000, 0);
            mouse_rig_run(&r, end - 1);
            assert_false(overrun(&r, end - 1));
            mouse_rig_run(&r, end);
            assert_int_equal(mouse_rig_x(&r, end), sign * cases[i].counts);
            assert_int_equal(overrun(&r, end), cases[i].counts < 4000);
            assert_int_equal(mouse_rig_y(&r, end), 0);
            mouse_rig_clear(&r, end);
            assert_false(overrun(&r, end));
        }
}

/* Each axis for itself; what is seen of the wheels is where they are. */
static void axes_are_limited_apart(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    unsigned phases = mouse_rig_get(&r, INPUT_MOUSE_PHASES, 0);
    mouse_rig_move(&r, 0, S, 2000000, 500000);
    mouse_rig_run(&r, S);
    assert_int_equal(mouse_rig_x(&r, S), 4001);
    assert_int_equal(mouse_rig_y(&r, S), 2000);
    assert_true(overrun(&r, S));
    assert_int_equal(mouse_rig_get(&r, INPUT_MOUSE_PHASES, S), phases);
}

/* ---- count by count ---------------------------------------------------------------------------- */

struct model {
    long double place;      /* counts from an edge */
    long double t0, t1, by; /* of the move: ps, counts */
    long double free, period;
    long base, done; /* counted before this move, in it */
};

/* Counts of the move that have come at t: one after the other. */
static long come(const struct model *m, long double t, long *crossed)
{
    long double speed = m->t1 > m->t0 ? fabsl(m->by) / (m->t1 - m->t0) : INFINITY, at = m->free;
    long n = 0, edge = lroundl(floorl(m->place)), up = m->by > 0;
    for (*crossed = 0;; ++*crossed) {
        long double way = fabsl((long double)(edge + up) - m->place);
        long double when = speed < INFINITY ? m->t0 + way / speed : m->t0;
        if (way > fabsl(m->by) || when > t)
            return n;
        if (speed * m->period <= 1 || fmaxl(when, at) <= t)
            n++;
        at += m->period;
        edge += up ? 1 : -1;
    }
}

static bool end_move(struct model *m, long double t)
{
    long crossed, n = come(m, fminl(t, m->t1), &crossed);
    long double part = t >= m->t1 ? 1 : (t - m->t0) / (m->t1 - m->t0);
    m->free = fminl(m->free + (long double)n * m->period, fminl(t, m->t1) + m->period);
    m->base += m->by > 0 ? n : -n;
    m->place += m->by * part;
    m->by = 0;
    return crossed > n;
}

static void counts_are_those_of_a_model(void **state)
{
    (void)state;
    uint64_t row = 0;
    int missing = 0;
    for (unsigned i = 0; i < 30; i++) {
        struct mouse_rig r;
        mouse_rig_setup(&r, 1 + i % 2);
        r.setup.fastest.value = i % 3 ? 4000 : mouse_rig_roll(&row, 100, 20000);
        mouse_rig_power(&r);
        long double um = r.setup.kind == MOUSE_OPTICAL ? 500 : 250;
        long double period = 1e15L / roundl(r.setup.fastest.value * 1000);
        struct model m = {.place = 0.5L, .period = period};
        uint64_t t = S;
        bool lost = false;
        for (int move = 0; move < 60; move++) {
            int32_t x = (int32_t)mouse_rig_roll(&row, -60000, 60000);
            uint64_t way = move % 4 == 0 ? 0 : (uint64_t)mouse_rig_roll(&row, 1e8, 1e11);
            if (move % 5 == 1)
                way = (uint64_t)mouse_rig_roll(&row, 1, 1e7);
            lost |= end_move(&m, (long double)t);
            mouse_rig_move(&r, t, way, x, 0);
            m.t0 = (long double)t;
            m.t1 = (long double)(t + way);
            m.by = x / um;
            m.free = fmaxl(m.free, m.t0 - (way == 0 ? 50e9L : 0));
            for (int look = 0; look < 3; look++) {
                t += (uint64_t)mouse_rig_roll(&row, 1, 3e10);
                mouse_rig_run(&r, t);
                long crossed, n = come(&m, fminl((long double)t, m.t1), &crossed);
                assert_int_equal(mouse_rig_x(&r, t), m.base + (x > 0 ? n : -n));
                if (lost || ((long double)t >= m.t1 && crossed > n))
                    lost = true;
                assert_int_equal(overrun(&r, t), lost);
            }
            if (move % 3 == 0) {
                mouse_rig_clear(&r, t);
                missing += lost;
                lost = false;
                if ((long double)t >= m.t1)
                    end_move(&m, (long double)t);
            }
        }
    }
    assert_true(missing > 30);
}

/* To and fro over an edge, slowly but often: nothing is missing, and soon after counts come as ever. */
static void an_edge_crossed_often_blocks_nothing(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    mouse_rig_move(&r, 0, MS, 125, 0);
    uint64_t t = 2 * MS, step = 4 * CRT_PS_PER_US;
    for (int i = 0; i < 1000; i++, t += step) {
        mouse_rig_run(&r, t);
        mouse_rig_move(&r, t, step, i % 2 ? 1 : -1, 0);
    }
    mouse_rig_run(&r, t);
    assert_int_equal(mouse_rig_x(&r, t), 1);
    mouse_rig_move(&r, t + MS, 0, 750, 0);
    assert_int_equal(mouse_rig_x(&r, t + MS), 4);
    assert_false(overrun(&r, t + MS));
}

/* ---- a window ---------------------------------------------------------------------------------- */

/* Tells of moves 60 times a second, after they were made. */
static int window(struct mouse_rig *r, uint64_t from, int frames, int32_t um)
{
    int32_t before = mouse_rig_x(r, from);
    for (int i = 0; i < frames; i++)
        mouse_rig_move(r, from + crt_tick_time((struct crt_rate){60, 1}, (uint64_t)i), 0, um, -um);
    return abs(mouse_rig_x(r, from + (uint64_t)frames * 17 * MS) - before);
}

static void hands_are_slow_enough_for_windows(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_open(&r, MOUSE_MECHANICAL);
    assert_int_equal(window(&r, S, 600, 16500), 600 * 66); /* 0.99 m/s */
    assert_false(overrun(&r, 20 * S));
    assert_int_equal(window(&r, 20 * S, 1, 50000), 200); /* a start after a rest */
    assert_int_equal(window(&r, 21 * S, 1, -50000), 200);
    assert_false(overrun(&r, 22 * S));
    /* 3 m/s, 10 s: 4000 counts a second and what the 50 ms before it give. */
    int counts = window(&r, 30 * S, 600, 50000);
    assert_true(overrun(&r, 50 * S));
    assert_true(counts >= 599 * 4000 / 60 && counts <= 599 * 4000 / 60 + 202);
    /* Twice in a frame is half as much each. */
    mouse_rig_clear(&r, 50 * S);
    for (uint64_t t = 50 * S; t < 51 * S; t += 17 * MS)
        for (int i = 0; i < 2; i++)
            mouse_rig_move(&r, t, 0, 8000, 8000);
    assert_false(overrun(&r, 51 * S));
}

/* ---- floods ------------------------------------------------------------------------------------ */

static void floods_are_cheap(void **state)
{
    (void)state;
    struct mouse_rig r;
    mouse_rig_setup(&r, MOUSE_MECHANICAL);
    r.setup.slot.value = r.setup.slot.low;
    r.setup.fastest.value = r.setup.fastest.high;
    mouse_rig_power(&r);
    clock_t begin = clock();
    uint64_t t = 0;
    int32_t far = 10000000;
    for (int i = 0; i < 100000; i++, t += 2) {
        mouse_rig_move(&r, t, 1, i % 2 ? far : -far, far);
        mouse_rig_run(&r, t + 1);
        mouse_rig_move(&r, t + 1, 0, far, i % 3 ? far : -far);
    }
    assert_true(clock() - begin < CLOCKS_PER_SEC); /* 2·10^10 counts crossed on each axis */
    assert_true(overrun(&r, t));
    assert_true(labs(mouse_rig_x(&r, t)) <= 50001 && labs(mouse_rig_y(&r, t)) <= 50001);

    /* At the latest times and longest moves that there are. */
    mouse_rig_move(&r, CRT_STATE_LATEST - 5, UINT64_MAX, INT32_MIN, INT32_MAX);
    assert_true(inp_mouse_next(&r.mouse) < CRT_STATE_LATEST);
    mouse_rig_run(&r, CRT_STATE_LATEST);
    mouse_rig_power(&r);
    mouse_rig_move(&r, 0, UINT64_MAX, far, 0);
    mouse_rig_run(&r, 1000 * S);
    double mm = 1e4 * 1e15 / 9223372036854775807.0;
    assert_int_equal(mouse_rig_x(&r, 1000 * S), (int)(mm / 0.0125 + 0.5));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(at_the_limit_nothing_is_missing),
        cmocka_unit_test(axes_are_limited_apart),
        cmocka_unit_test(counts_are_those_of_a_model),
        cmocka_unit_test(an_edge_crossed_often_blocks_nothing),
        cmocka_unit_test(hands_are_slow_enough_for_windows),
        cmocka_unit_test(floods_are_cheap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
