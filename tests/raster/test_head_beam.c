/* Where the beam is: registers, lines and interrupts against counters that count every dot of whole
 * frames, as the hardware would. */
#include <math.h>

#include "tests/raster/head_rig.h"

/* The counters: dots of a line, lines (halves of them when interlaced) of a field. */
struct counters {
    const struct ras_timing *t;
    uint32_t h, v, fields;
    uint32_t row; /* of the line under way */
};

static uint32_t halves(const struct counters *c)
{
    return c->t->interlaced ? 1 : 0;
}

static void count_dot(struct counters *c)
{
    bool end = ++c->h == c->t->h.total;
    if (end || (c->t->interlaced && c->h == c->t->h.total / 2)) {
        if (++c->v == c->t->v.total) {
            c->v = 0;
            c->fields++;
        }
    }
    if (end) {
        c->h = 0;
        c->row = c->v;
    }
}

static bool vertical_sync(const struct counters *c)
{
    return c->v >= c->t->v.sync_start + halves(c) && c->v < c->t->v.sync_end + halves(c);
}

static uint32_t status_of(const struct counters *c)
{
    uint32_t s = 0;
    if (c->row >= c->t->v.visible)
        s |= VIDEO_STATUS_VBLANK;
    if (c->h >= c->t->h.visible)
        s |= VIDEO_STATUS_HBLANK;
    if (vertical_sync(c))
        s |= VIDEO_STATUS_VSYNC;
    if (c->h >= c->t->h.sync_start && c->h < c->t->h.sync_end)
        s |= VIDEO_STATUS_HSYNC;
    if (c->t->interlaced && c->fields % 2)
        s |= VIDEO_STATUS_FIELD;
    return s;
}

static const uint32_t now_bits = VIDEO_STATUS_VBLANK | VIDEO_STATUS_HBLANK | VIDEO_STATUS_VSYNC |
                                 VIDEO_STATUS_HSYNC | VIDEO_STATUS_FIELD;

/* The registers at time t are what the counters say. */
static void same_registers(struct head_rig *r, const struct counters *c, uint64_t t)
{
    uint32_t line, dot, status;
    assert_true(ras_head_beam(&r->head, t, &line, &dot));
    assert_true(ras_head_read(&r->head, VIDEO_STATUS, t, &status));
    if (line != c->row || dot != c->h || (status & now_bits) != status_of(c))
        fail_msg("at %llu: line %u dot %u status %x, counters %u %u %x", (unsigned long long)t,
                 line, dot, status & now_bits, c->row, c->h, status_of(c));
    assert_int_equal(ras_head_fields(&r->head, t), c->fields + 1);
}

/* Counts `frames` frames; checks registers at the first and last instant of each `every`th dot, and the
 * times of lines and interrupts. */
static void run(const struct ras_timing *timing, uint32_t compare, int frames, unsigned every)
{
    const uint64_t origin = 12345678901;
    struct head_rig *r = rig_open(timing, 1, 0);
    struct counters c = {.t = timing};
    uint64_t frame = (uint64_t)timing->h.total * timing->v.total;
    rig_write(r, VIDEO_LINE_COMPARE, compare, origin);
    rig_write(r, VIDEO_IRQ_ENABLE, VIDEO_STATUS_RETRACE | VIDEO_STATUS_COMPARE, origin);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, origin);
    int lines = 0, irqs = 0;
    for (uint64_t n = 0; n < frame * (uint64_t)frames; n++, count_dot(&c)) {
        uint64_t t = rig_dot(timing, origin, n);
        bool sync = vertical_sync(&c), begins = c.h == 0 && c.row < timing->v.visible;
        rig_run(r, t);
        if (begins) {
            assert_int_equal(r->lines, ++lines);
            assert_int_equal(r->line[lines - 1].t0, t);
            assert_int_equal(r->line[lines - 1].t1, rig_dot(timing, origin, n + timing->h.visible));
            assert_int_equal(r->line[lines - 1].source, c.row);
        }
        struct counters before = c;
        if (n > 0 && sync && (c.h == 0 || (timing->interlaced && c.h == timing->h.total / 2)) &&
            before.v == timing->v.sync_start + halves(&c)) {
            assert_int_equal(r->irq[irqs].which, RAS_INT_RETRACE);
            assert_int_equal(r->irq[irqs++].t, t);
            rig_write(r, VIDEO_STATUS, VIDEO_STATUS_RETRACE, t);
            irqs++; /* the level drops again */
        }
        if (begins && c.row == compare) {
            assert_int_equal(r->irq[irqs].which, RAS_INT_COMPARE);
            assert_int_equal(r->irq[irqs++].t, t);
            rig_write(r, VIDEO_STATUS, VIDEO_STATUS_COMPARE, t);
            irqs++;
        }
        assert_int_equal(r->irqs, irqs);
        assert_int_equal(r->lines, lines);
        if (n % every == 0) {
            same_registers(r, &c, t);
            same_registers(r, &c, rig_dot(timing, origin, n + 1) - 1);
        }
        if (r->lines > RIG_NOTES - 8)
            r->lines = lines = 0;
    }
    assert_int_equal(r->retimes, 1);
    assert_int_equal(r->retime[0].origin, origin);
    rig_close(r);
}

static void small_frames(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    run(&t, 3, 3, 1);
    t.clock = (struct crt_rate){2700007, 11}; /* dots that are no whole number of ps */
    run(&t, 9, 3, 1);
    t.v = (struct ras_span){10, 10, 15, 15}; /* no porches */
    t.h = (struct ras_span){16, 16, 24, 24};
    run(&t, 0, 3, 1);
    t.clock = (struct crt_rate){100000, 1};
    t.v = (struct ras_span){1, 1, 2, 5};
    run(&t, 0, 5, 1);
}

static void small_interlaced_frames(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    t.interlaced = true;
    for (uint32_t compare = 0; compare <= 10; compare++)
        run(&t, compare, 3, 1);
    t.v = (struct ras_span){10, 10, 14, 15};
    run(&t, 9, 3, 1);
    t.v = (struct ras_span){11, 12, 13, 17}; /* an odd number of rows */
    run(&t, 10, 3, 1);
    t.clock = (struct crt_rate){100000, 1};
    t.h.total = 80;
    t.v = (struct ras_span){1, 1, 2, 3};
    run(&t, 0, 5, 1);
}

static void modes_of_the_table(void **state)
{
    (void)state;
    static const char *const names[] = {"525/60i", "640x480@60", "1024x768@43i"};
    struct crt_error err;
    struct ras_timing t;
    for (int i = 0; i < 3; i++) {
        assert_true(ras_mode_parse(names[i], &t, &err));
        run(&t, 101, 2, 13);
    }
}

/* The second field: its lines half a line later in time and half a line pitch of a field lower. */
static void fields_interleave(void **state)
{
    (void)state;
    struct crt_error err;
    struct ras_timing t;
    assert_true(ras_mode_parse("525/60i", &t, &err));
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_run(r, CRT_PS_PER_S / 25);
    const struct rig_line *first = &r->line[0], *second = &r->line[240], *third = &r->line[480];
    assert_int_equal(first->source, 0);
    assert_int_equal(second->source, 1);
    assert_int_equal(third->source, 0);
    /* Of 525 lines of 63.556 us: 262.5 + 0.5, then 262. 858 dots a line, 13.5 MHz. */
    assert_int_equal(second->t0, (uint64_t)858 * 263 * 1000000 * 2 / 27);
    assert_int_equal(third->t0, (uint64_t)858 * 525 * 1000000 * 2 / 27);
    double pitch = 240.0 / 480;
    assert_true(fabs(first->y - second->y - pitch) < 1e-5);
    assert_true(fabs(first->y - r->line[1].y - 2 * pitch) < 1e-5);
    assert_true(first->y == third->y);
    assert_true(fabs(first->y - (120 - pitch / 2)) < 1e-5);
    assert_true(fabs(r->line[479].y - (-120 + pitch / 2)) < 1e-5);
    rig_close(r);
}

/* Nothing drifts: a day after power-on fields begin where the ratio says. */
static void a_day_later(void **state)
{
    (void)state;
    struct crt_error err;
    struct ras_timing t;
    assert_true(ras_mode_parse("640x480@60", &t, &err));
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    /* 25.175 MHz for 86400 s are 2175120000000 dots: 5178857 fields of 420000 dots and 60000. */
    uint64_t day = 86400 * CRT_PS_PER_S;
    uint32_t line, dot;
    assert_true(ras_head_beam(&r->head, day, &line, &dot));
    assert_int_equal(ras_head_fields(&r->head, day), 5178857 + 1);
    assert_int_equal(line, 60000 / 800);
    assert_int_equal(dot, 60000 % 800);
    assert_true(ras_head_beam(&r->head, day - 1, &line, &dot));
    assert_int_equal(line, 60000 / 800 - 1);
    assert_int_equal(dot, 799);
    rig_close(r);
}

static void off_there_is_no_beam(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    uint32_t line, dot;
    assert_false(ras_head_beam(&r->head, 5, &line, &dot));
    assert_true(line == 0 && dot == 0);
    assert_true(ras_head_next(&r->head) == UINT64_MAX);
    assert_int_equal(rig_read(r, VIDEO_STATUS, 5), VIDEO_STATUS_VBLANK | VIDEO_STATUS_HBLANK);
    rig_close(r);
}

/* ---- hooks: what a trace sees ----------------------------------------------------------------- */

struct edges {
    struct head_rig *r;
    uint64_t last;
    int count[3][2], latches, wrong;
};

/* Each edge stands where the registers change. */
static void edge(void *ctx, enum ras_signal signal, bool level, uint64_t t)
{
    static const uint32_t bit[3] = {VIDEO_STATUS_HSYNC, VIDEO_STATUS_VSYNC,
                                    VIDEO_STATUS_VBLANK | VIDEO_STATUS_HBLANK};
    struct edges *e = ctx;
    uint32_t now = 0, before = 0;
    assert_true(t >= e->last);
    e->last = t;
    e->count[signal][level]++;
    ras_head_read(&e->r->head, VIDEO_STATUS, t, &now);
    if (t > 0)
        ras_head_read(&e->r->head, VIDEO_STATUS, t - 1, &before);
    bool is = (now & bit[signal]) != 0, was = (before & bit[signal]) != 0;
    if (signal == RAS_PICTURE) {
        is = !is;
        was = t > 0 && !was;
    }
    e->wrong += is != level || was == level;
}

static void latched(void *ctx, uint64_t t)
{
    struct edges *e = ctx;
    assert_true(t >= e->last);
    e->latches++;
}

static void hooks_see_every_edge(void **state)
{
    (void)state;
    for (int lace = 0; lace < 2; lace++) {
        struct ras_timing t = RIG_SMALL;
        t.interlaced = lace;
        struct head_rig *r = rig_open(&t, 1, 40);
        struct edges e = {.r = r};
        struct ras_hooks hooks = {&e, edge, latched};
        ras_head_hook(&r->head, &hooks, 0);
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
        rig_run(r, rig_dot(&t, 0, 24 * 15 * 4) - 1); /* four frames */
        assert_int_equal(e.wrong, 0);
        assert_int_equal(e.count[RAS_HSYNC][1], 15 * 4);
        assert_int_equal(e.count[RAS_HSYNC][0], 15 * 4);
        assert_int_equal(e.count[RAS_VSYNC][1], lace ? 8 : 4);
        assert_int_equal(e.count[RAS_PICTURE][1], 40);
        assert_int_equal(e.count[RAS_PICTURE][0], 40);
        assert_int_equal(e.latches, (lace ? 8 : 4) + 1);
        rig_close(r);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(small_frames),         cmocka_unit_test(small_interlaced_frames),
        cmocka_unit_test(modes_of_the_table),   cmocka_unit_test(fields_interleave),
        cmocka_unit_test(a_day_later),          cmocka_unit_test(off_there_is_no_beam),
        cmocka_unit_test(hooks_see_every_edge),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
