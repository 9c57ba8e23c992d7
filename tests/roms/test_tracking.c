/* The tracking cross (roms/interact/tracking.h) with the display processor as it is and a pen that is
 * reckoned exactly: a disc that fires a certain time after the lit beam has come into it, and is ready
 * again some time after the light has gone. The pen's path is known, so errors and the greatest speed
 * are. */
#include "tests/support/dpu_rig.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube_table.h"

#include "roms/interact/tracking.c"
#include "roms/interact/tracking_words.c"

#define NEVER   UINT64_MAX
#define US_REAL 1e6                  /* ps */
#define MM      (9.25 * 25.4 / 1024) /* a unit of a VR17 */

static struct tracking tracking;
static struct dpu_rig machine;

/* ---- the pen --------------------------------------------------------------------------------- */

static struct {
    bool there;
    double radius;               /* units */
    uint64_t delay, ready, hold; /* ps */
    double (*x)(double), (*y)(double);
    uint64_t blind_until, pulse;
    unsigned fired;
} pen;

/* The part of the stroke within the disc: times of coming in and going out. */
static bool passes(const struct crt_stroke *s, double *in, double *out)
{
    double t = (double)s->t0 / 1e12, px = pen.x(t), py = pen.y(t);
    double ax = rig_x0(s) - px, ay = rig_y0(s) - py;
    double dx = rig_x1(s) - rig_x0(s), dy = rig_y1(s) - rig_y0(s);
    double a = dx * dx + dy * dy, b = ax * dx + ay * dy;
    double c = ax * ax + ay * ay - pen.radius * pen.radius;
    double from = 0, to = 1;
    if (a > 0) {
        double root = b * b - a * c;
        if (root <= 0)
            return false;
        from = fmax(0, (-b - sqrt(root)) / a);
        to = fmin(1, (-b + sqrt(root)) / a);
    } else if (c > 0) {
        return false;
    }
    *in = (double)s->t0 + from * (double)(s->t1 - s->t0);
    *out = (double)s->t0 + to * (double)(s->t1 - s->t0);
    return from < to;
}

static uint64_t pulse_of(const struct crt_stroke *s)
{
    double in, out;
    if (pen.pulse != NEVER)
        return pen.pulse;
    if (!pen.there || !passes(s, &in, &out) || (uint64_t)in < pen.blind_until)
        return NEVER;
    return (uint64_t)in + pen.delay;
}

static uint64_t pen_offer(void *ctx, const struct crt_stroke *s)
{
    uint64_t pulse = pulse_of(s);
    (void)ctx;
    if (pulse == NEVER || pulse > s->t1 || pulse + pen.hold < s->t0)
        return DF_NO_HIT;
    return pulse < s->t0 ? s->t0 : pulse;
}

static void pen_commit(void *ctx, const struct crt_stroke *s)
{
    double in, out;
    (void)ctx;
    pen.pulse = pulse_of(s);
    if (pen.pulse <= s->t1) {
        pen.pulse = NEVER;
        pen.fired++;
    }
    if (pen.there && passes(s, &in, &out))
        pen.blind_until = (uint64_t)out + pen.ready;
}

/* ---- the board ------------------------------------------------------------------------------- */

static struct {
    void (*pen)(void *), (*stop)(void *);
    void *pen_ctx, *stop_ctx;
    bool tip;
    unsigned refreshes, resumed;
} board;

volatile uint16_t *dpu_memory(void)
{
    return machine.memory;
}

/* The processor is so much later than the interrupt. */
#define LATENCY (12 * US)

void dpu_start(uint32_t address)
{
    df_dpu_write(&machine.dpu, DF_DPC, (uint16_t)address, machine.dpu.t + LATENCY);
}

void dpu_resume(void)
{
    board.resumed++;
    df_dpu_write(&machine.dpu, DF_DPC, 1, machine.dpu.t + LATENCY);
}

uint32_t dpu_pc(void)
{
    return dpu_rig_reg(&machine, DF_DPC);
}

unsigned dpu_x(void)
{
    return dpu_rig_reg(&machine, DF_XPR) & DF_XPR_X;
}

unsigned dpu_y(void)
{
    return dpu_rig_reg(&machine, DF_YPR) & DF_YPR_Y;
}

void dpu_on_stop(void (*handler)(void *ctx), void *ctx)
{
    board.stop = handler;
    board.stop_ctx = ctx;
}

void dpu_on_pen(void (*handler)(void *ctx), void *ctx)
{
    board.pen = handler;
    board.pen_ctx = ctx;
}

bool pen_tip(enum input_head head)
{
    return head == INPUT_VECTOR && board.tip;
}

void board_refresh(uint32_t number)
{
    board.refreshes = number;
}

uint32_t irq_lock(void)
{
    return 0;
}

void irq_unlock(uint32_t state)
{
    (void)state;
}

uint64_t timer_now(void)
{
    return machine.dpu.t / (US * 1000000 / TIMER_HZ);
}

static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    (void)ctx;
    (void)line;
    (void)level;
    (void)t;
}

/* ---- a refresh --------------------------------------------------------------------------------- */

enum { LOW = 0x1000 };

static double period; /* s */

static double now(void)
{
    return (double)machine.dpu.t / 1e12;
}

static void refresh(void)
{
    uint64_t ps = (uint64_t)(period * 1e12), tick = (machine.dpu.t / ps + 1) * ps;
    df_dpu_sync(&machine.dpu, tick);
    for (int i = 0; i < 20000 && machine.dpu.state != DF_WAITING_SYNC; i++) {
        if (machine.dpu.state == DF_RUNNING)
            df_dpu_step(&machine.dpu);
        else if (machine.dpu.state == DF_WAITING_RESUME)
            board.pen(board.pen_ctx);
        else
            board.stop(board.stop_ctx);
    }
    assert_int_equal(machine.dpu.state, DF_WAITING_SYNC);
}

static double path[6]; /* of the pens below */

static double still_x(double t)
{
    (void)t;
    return path[0];
}

static double still_y(double t)
{
    (void)t;
    return path[1];
}

static void begin(double refreshes, double delay_us)
{
    memset(&pen, 0, sizeof pen);
    memset(&board, 0, sizeof board);
    pen.there = true;
    pen.radius = 1.5 / MM;
    pen.delay = (uint64_t)(delay_us * US_REAL);
    pen.ready = 45 * US;
    pen.hold = 2 * US;
    pen.pulse = NEVER;
    pen.x = still_x;
    pen.y = still_y;
    dpu_rig_init(&machine);
    machine.desc.timing = df_timing_of_tube(crt_tube_row_find("VR17"), DF_TIMING_VALUE);
    machine.desc.beam = (struct df_beam){NULL, pen_offer, pen_commit};
    machine.desc.wires.interrupt = interrupt;
    dpu_rig_restart(&machine);
    LOAD(&machine, 0, DF_STATUS_A | DF_LSA_SYNC, DF_JUMP, LOW);
    period = 1 / refreshes;
    path[0] = path[1] = 512;
    tracking_begin(&tracking, LOW, 0);
    df_dpu_write(&machine.dpu, DF_DPC, 0, 0);
    df_dpu_step(&machine.dpu);
    assert_int_equal(machine.dpu.state, DF_WAITING_SYNC);
}

static void refreshes(int count)
{
    for (int i = 0; i < count; i++)
        refresh();
}

static double error(void)
{
    return hypot((double)tracking.at.x - pen.x(now()), (double)tracking.at.y - pen.y(now()));
}

/* ---- tests --------------------------------------------------------------------------------------- */

static void takes_up_the_pen_that_points_at_the_cross(void **state)
{
    (void)state;
    begin(60, 0.6);
    pen.there = false;
    refreshes(20);
    assert_int_equal(tracking.state, TRACKING_LOST);
    assert_int_equal(tracking.counts.losses, 0);
    pen.there = true;
    path[0] = 516;
    path[1] = 509;
    refreshes(20);
    assert_int_equal(tracking.state, TRACKING_FOLLOWING);
    assert_true(error() <= 1.0);
    assert_int_equal(board.refreshes, 40);
}

static void place_is_exact_whatever_the_delay(void **state)
{
    (void)state;
    double worst = 0;
    srand(7);
    for (int i = 0; i < 60; i++) {
        begin(60, 0.1 + 0.02 * i);
        refreshes(30);
        for (int k = 0; k < 8; k++) {
            path[0] += rand() % 11 - 5 + 0.37;
            path[1] += rand() % 11 - 5 - 0.41;
            refreshes(4);
            assert_int_equal(tracking.state, TRACKING_FOLLOWING);
            worst = fmax(worst, error());
        }
    }
    print_message("static error at most %.2f units\n", worst);
    assert_true(worst < 1.2);
}

/* What comes of strokes one way: they are seen where the beam is when the pulse arrives. */
static void one_way_is_late_by_speed_times_delay(void **state)
{
    (void)state;
    for (int i = 0; i < 12; i++) {
        double delay = 0.05 * i, moved = 10 * delay; /* us; units in that time */
        begin(60, delay);
        tracking.radius = (float)pen.radius;
        refreshes(30);
        assert_true(fabs((double)tracking.one_way.x - (path[0] - moved)) <= 1.0);
        assert_true(fabs((double)tracking.one_way.y - (path[1] - moved)) <= 1.0);
        assert_true(error() <= 0.8);
    }
}

/* ---- speed ----------------------------------------------------------------------------------------- */

/* Back and forth across 800 units at constant speed, path[2] units a second, from path[3] on. */
static double sweep_x(double t)
{
    double way = t < path[3] ? 0 : (t - path[3]) * path[2], lap = fmod(way, 1600);
    return 512 + (lap < 400 ? lap : lap < 1200 ? 800 - lap : lap - 1600);
}

/* A circle of 300 units, from its right on, the same. */
static double circle_x(double t)
{
    return 512 + 300 * cos(t < path[3] ? 0 : (t - path[3]) * path[2] / 300);
}

static double circle_y(double t)
{
    return 512 + 300 * sin(t < path[3] ? 0 : (t - path[3]) * path[2] / 300);
}

/* Whether it still follows after two seconds; the greatest error meanwhile. */
static bool follows(double rate, double speed, bool circle, bool predicts, double *worst)
{
    begin(rate, 0.6);
    tracking.predicts = predicts;
    path[2] = speed;
    path[3] = 0.5;
    pen.x = circle ? circle_x : sweep_x;
    pen.y = circle ? circle_y : still_y;
    tracking_put(&tracking, (struct point2){(float)pen.x(0), (float)pen.y(0)});
    *worst = 0;
    refreshes((int)(0.4 * rate));
    tracking.counts.losses = 0;
    for (int i = 0; i < (int)(2.5 * rate); i++) {
        refresh();
        if (tracking.state == TRACKING_FOLLOWING)
            *worst = fmax(*worst, error());
    }
    return tracking.state == TRACKING_FOLLOWING && tracking.counts.losses == 0;
}

/* mm/s. Every speed below it is followed, too, a tenth apart, and no error is greater than what the pen
 * goes in 2 ms: it moves on while it is searched, and while the refresh ends. */
static double greatest(double rate, bool circle, bool predicts)
{
    double worst, most = 0;
    for (double v = 40; v < 4000 && follows(rate, v / MM, circle, predicts, &worst); v *= 1.1) {
        assert_true(worst < 2 + v / MM * 2e-3);
        most = v;
    }
    return most;
}

/* What a spiral reaches in its first refresh is what the pen may go from one refresh to the next. */
static void follows_up_to_a_speed_and_no_faster(void **state)
{
    (void)state;
    static const double rates[] = {30, 40, 60};
    for (int i = 0; i < 3; i++) {
        double reach = (double)SPIRAL_FIRST * MM * rates[i];
        for (int circle = 0; circle < 2; circle++)
            for (int predicts = 0; predicts < 2; predicts++) {
                double most = greatest(rates[i], circle, predicts);
                assert_true(most > 0.8 * reach && most < 1.1 * reach);
                print_message("%2.0f Hz, %s, %s: %4.0f mm/s\n", rates[i],
                              circle ? "circle" : "sweeps", predicts ? "predicts" : "does not",
                              most);
            }
    }
}

/* A pen that speeds up slowly is ahead of by no more than it gains in a refresh: no search is seen. */
static void prediction_saves_searches(void **state)
{
    (void)state;
    double worst;
    assert_true(follows(60, 300 / MM, true, true, &worst));
    uint32_t with = tracking.counts.searches;
    assert_true(follows(60, 300 / MM, true, false, &worst));
    assert_int_equal(with, 0);
    assert_true(tracking.counts.searches > 50);
}

/* ---- lost, and found again --------------------------------------------------------------------------- */

static void is_lost_when_taken_away_and_stays_there(void **state)
{
    (void)state;
    begin(60, 0.6);
    refreshes(20);
    pen.there = false;
    refreshes(1);
    assert_int_equal(tracking.state, TRACKING_SEARCHING);
    refreshes(TRACKING_PATIENCE - 2);
    assert_int_equal(tracking.state, TRACKING_SEARCHING);
    refreshes(1);
    assert_int_equal(tracking.state, TRACKING_LOST);
    assert_int_equal(tracking.counts.losses, 1);
    uint32_t searches = tracking.counts.searches;
    refreshes(30);
    assert_int_equal(tracking.counts.searches, searches);
    assert_true(hypot((double)tracking.cross.x - 512, (double)tracking.cross.y - 512) < 3);
}

/* Anywhere on the screen, its edges and corners among them. */
static void scan_finds_it_anywhere(void **state)
{
    (void)state;
    srand(11);
    begin(60, 0.6);
    for (int i = 0; i < 150; i++) {
        pen.there = false;
        refreshes(TRACKING_PATIENCE + 2);
        assert_int_equal(tracking.state, TRACKING_LOST);
        pen.there = true;
        for (int k = 0; k < 2; k++)
            path[k] = i % 3 == k ? (rand() % 2 ? 1 : 1022) : rand() % 1024;
        refreshes(3);
        if (hypot((double)tracking.cross.x - path[0], (double)tracking.cross.y - path[1]) > 60)
            assert_int_equal(tracking.state, TRACKING_LOST);
        tracking_scan(&tracking);
        refreshes(4);
        assert_int_equal(tracking.state, TRACKING_FOLLOWING);
        assert_true(error() < 1.5);
    }
}

static void a_scan_that_finds_nothing_ends(void **state)
{
    (void)state;
    begin(60, 0.6);
    pen.there = false;
    tracking_scan(&tracking);
    refreshes(10);
    assert_int_equal(tracking.counts.scans, 3);
    assert_int_equal(tracking.state, TRACKING_LOST);
}

static void is_put_elsewhere_and_waits_there(void **state)
{
    (void)state;
    begin(60, 0.6);
    refreshes(5);
    tracking_put(&tracking, (struct point2){100, 900});
    refreshes(3);
    assert_int_equal(tracking.state, TRACKING_LOST);
    assert_true(fabsf(tracking.cross.x - 100) < 1 && fabsf(tracking.cross.y - 900) < 1);
    path[0] = 102;
    path[1] = 897;
    refreshes(3);
    assert_int_equal(tracking.state, TRACKING_FOLLOWING);
}

/* Pulses at random, from light in the room: neither followed nor taken for the pen for long. */
static void chance_pulses_are_not_followed(void **state)
{
    (void)state;
    srand(3);
    begin(60, 0.6);
    pen.there = false;
    unsigned followed = 0;
    for (int i = 0; i < 600; i++) {
        if (rand() % 3 == 0)
            pen.pulse = machine.dpu.t + (uint64_t)rand() % (17000 * US);
        refresh();
        followed += tracking.state == TRACKING_FOLLOWING;
    }
    assert_int_equal(followed, 0);
}

/* ---- samples, others -------------------------------------------------------------------------------- */

static unsigned placed;
static struct tracking_sample last;

static void place(void *ctx, const struct tracking_sample *sample)
{
    (void)ctx;
    placed++;
    last = *sample;
}

static void one_sample_a_refresh(void **state)
{
    (void)state;
    begin(60, 0.6);
    tracking.place = place;
    placed = 0;
    assert_false(tracking_frame(&tracking));
    refreshes(10);
    board.tip = true;
    refreshes(1);
    assert_true(tracking_frame(&tracking));
    assert_int_equal(placed, 11);
    assert_true(last.pressed && last.state == TRACKING_FOLLOWING);
    assert_in_range(last.time, TIMER_HZ / 60 * 11, TIMER_HZ / 60 * 12);
    refreshes(TRACKING_SAMPLES + 5);
    placed = 0;
    assert_true(tracking_frame(&tracking));
    assert_int_equal(placed, TRACKING_SAMPLES);
    assert_int_equal(tracking.dropped, 5);
}

static unsigned others;

static void other_hit(void *ctx)
{
    (void)ctx;
    others++;
    assert_in_range(dpu_pc(), 0x10, 0x40);
    dpu_resume();
}

static void hits_elsewhere_are_handed_on(void **state)
{
    (void)state;
    begin(60, 0.6);
    tracking.others = other_hit;
    LOAD(&machine, 2, DF_JUMP, 0x10);
    LOAD(&machine, 0x10, 0114140, 700, 512, 0110000, DF_BEAM_ON | 100, 0, 0110100, DF_JUMP, LOW);
    path[0] = 750;
    others = 0;
    refreshes(7);
    assert_int_equal(others, 7);
    assert_int_equal(tracking.state, TRACKING_LOST);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(takes_up_the_pen_that_points_at_the_cross),
        cmocka_unit_test(place_is_exact_whatever_the_delay),
        cmocka_unit_test(one_way_is_late_by_speed_times_delay),
        cmocka_unit_test(follows_up_to_a_speed_and_no_faster),
        cmocka_unit_test(prediction_saves_searches),
        cmocka_unit_test(is_lost_when_taken_away_and_stays_there),
        cmocka_unit_test(scan_finds_it_anywhere),
        cmocka_unit_test(a_scan_that_finds_nothing_ends),
        cmocka_unit_test(is_put_elsewhere_and_waits_there),
        cmocka_unit_test(chance_pulses_are_not_followed),
        cmocka_unit_test(one_sample_a_refresh),
        cmocka_unit_test(hits_elsewhere_are_handed_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
