/* Registers of the raster head: what they hold, what a new timing does, when wires change. */
#include "tests/raster/head_rig.h"

static uint64_t frame_time(const struct ras_timing *t)
{
    return rig_dot(t, 0, (uint64_t)t->h.total * t->v.total);
}

static void there_are_these_and_no_more(void **state)
{
    (void)state;
    static const uint32_t known[] = {
        VIDEO_CONTROL,    VIDEO_STATUS,   VIDEO_IRQ_ENABLE, VIDEO_BASE,
        VIDEO_PITCH,      VIDEO_FORMAT,   VIDEO_OVERSCAN,   VIDEO_LINE_COMPARE,
        VIDEO_BEAM_LINE,  VIDEO_BEAM_DOT, VIDEO_FIELDS,     VIDEO_WIDTH_UM,
        VIDEO_HEIGHT_UM,  VIDEO_CLOCK,    VIDEO_H_VISIBLE,  VIDEO_H_SYNC_START,
        VIDEO_H_SYNC_END, VIDEO_H_TOTAL,  VIDEO_V_VISIBLE,  VIDEO_V_SYNC_START,
        VIDEO_V_SYNC_END, VIDEO_V_TOTAL,  VIDEO_SYNC,       VIDEO_LOAD};
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    for (uint32_t offset = 0; offset < 0x1000; offset++) {
        bool is = false;
        uint32_t value;
        for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
            is |= known[i] == offset;
        assert_int_equal(ras_head_read(&r->head, offset, 0, &value), is);
        assert_int_equal(ras_head_write(&r->head, offset, 0, 0), is);
    }
    rig_close(r);
}

static void power_on(void **state)
{
    (void)state;
    struct crt_error err;
    struct ras_timing t;
    assert_true(ras_mode_parse("525/60i", &t, &err));
    t.h.visible = 719;
    struct head_rig *r = rig_open(&t, 1, 0);
    for (int again = 0; again < 2; again++) {
        const struct {
            uint32_t offset, value;
        } rows[] = {{VIDEO_CONTROL, 0},
                    {VIDEO_IRQ_ENABLE, 0},
                    {VIDEO_BASE, 0},
                    {VIDEO_PITCH, 720},
                    {VIDEO_FORMAT, 8},
                    {VIDEO_OVERSCAN, 0},
                    {VIDEO_LINE_COMPARE, 0xffffffff},
                    {VIDEO_BEAM_LINE, 0},
                    {VIDEO_BEAM_DOT, 0},
                    {VIDEO_FIELDS, 0},
                    {VIDEO_WIDTH_UM, 320000},
                    {VIDEO_HEIGHT_UM, 240000},
                    {VIDEO_CLOCK, 13500000},
                    {VIDEO_H_VISIBLE, 719},
                    {VIDEO_H_SYNC_START, 736},
                    {VIDEO_H_SYNC_END, 799},
                    {VIDEO_H_TOTAL, 858},
                    {VIDEO_V_VISIBLE, 480},
                    {VIDEO_V_SYNC_START, 488},
                    {VIDEO_V_SYNC_END, 494},
                    {VIDEO_V_TOTAL, 525},
                    {VIDEO_SYNC, VIDEO_SYNC_INTERLACED}};
        for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
            assert_int_equal(rig_read(r, rows[i].offset, 7), rows[i].value);
        for (uint32_t i = 0; i < VIDEO_LUT_ENTRIES; i++)
            assert_int_equal(ras_head_lut_read(&r->head, i), i * 0x010101);
        /* All of it changed, and reset. */
        rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON | VIDEO_CONTROL_BLANK, 8);
        for (uint32_t offset = VIDEO_IRQ_ENABLE; offset <= VIDEO_SYNC; offset += 4)
            ras_head_write(&r->head, offset, 0x5a5a5a5a, 8);
        ras_head_lut_write(&r->head, 3, 5);
        ras_head_reset(&r->head, 9);
        assert_true(ras_head_next(&r->head) == UINT64_MAX);
    }
    rig_close(r);
}

/* ---- a new timing ----------------------------------------------------------------------------- */

static void write_timing(struct head_rig *r, const struct ras_timing *t, uint64_t at)
{
    rig_write(r, VIDEO_CLOCK, (uint32_t)t->clock.num, at);
    rig_write(r, VIDEO_H_VISIBLE, t->h.visible, at);
    rig_write(r, VIDEO_H_SYNC_START, t->h.sync_start, at);
    rig_write(r, VIDEO_H_SYNC_END, t->h.sync_end, at);
    rig_write(r, VIDEO_H_TOTAL, t->h.total, at);
    rig_write(r, VIDEO_V_VISIBLE, t->v.visible, at);
    rig_write(r, VIDEO_V_SYNC_START, t->v.sync_start, at);
    rig_write(r, VIDEO_V_SYNC_END, t->v.sync_end, at);
    rig_write(r, VIDEO_V_TOTAL, t->v.total, at);
    rig_write(r, VIDEO_SYNC,
              (t->h_plus ? VIDEO_SYNC_H_PLUS : 0u) | (t->v_plus ? VIDEO_SYNC_V_PLUS : 0u) |
                  (t->interlaced ? VIDEO_SYNC_INTERLACED : 0u),
              at);
}

static void a_loaded_timing_runs(void **state)
{
    (void)state;
    struct ras_timing small = RIG_SMALL, xga, tv;
    struct crt_error err;
    assert_true(ras_mode_parse("1024x768@60", &xga, &err));
    assert_true(ras_mode_parse("525/60i", &tv, &err));
    struct head_rig *r = rig_open(&small, 1, 0);
    /* Off: it waits. */
    write_timing(r, &xga, 100);
    rig_write(r, VIDEO_LOAD, 1, 100);
    assert_int_equal(r->retimes, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 200);
    assert_int_equal(r->retimes, 1);
    assert_int_equal(r->retime[0].origin, 200);
    /* 65 MHz / (1344 · 806) reduced. */
    assert_int_equal(r->retime[0].field.num, 78125);
    assert_int_equal(r->retime[0].field.den, 1302);
    /* On again: nothing begins anew. */
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 300);
    assert_int_equal(r->retimes, 1);
    /* The middle of row 10: the line goes on to its end, the new timing begins at once. */
    uint64_t t = rig_dot(&xga, 200, 1344 * 10 + 500);
    write_timing(r, &tv, t);
    assert_int_equal(rig_read(r, VIDEO_BEAM_LINE, t), 10);
    rig_write(r, VIDEO_LOAD, 0, t);
    assert_int_equal(r->lines, 11);
    assert_int_equal(r->line[10].t1, rig_dot(&xga, 200, 1344 * 10 + 1024));
    assert_int_equal(r->retimes, 2);
    assert_int_equal(r->retime[1].origin, t);
    assert_int_equal(r->retime[1].field.num, 60000); /* 13.5 MHz · 2 / (858 · 525) */
    assert_int_equal(r->retime[1].field.den, 1001);
    assert_int_equal(rig_read(r, VIDEO_BEAM_LINE, t), 0);
    assert_int_equal(rig_read(r, VIDEO_BEAM_DOT, t), 0);
    assert_int_equal(rig_read(r, VIDEO_FIELDS, t), 1);
    rig_run(r, t + 100 * CRT_PS_PER_US);
    assert_int_equal(r->lines, 12); /* row 0 would begin before row 10 has ended */
    assert_int_equal(r->line[11].source, 2);
    assert_int_equal(r->line[11].t0, rig_dot(&tv, t, 858));
    rig_close(r);
}

/* Base, pitch and format are taken when a timing begins. */
static void a_timing_begins_with_the_registers(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    r->buffer[400] = 77;
    rig_write(r, VIDEO_BASE, 400, 0);
    assert_true(rig_read(r, VIDEO_STATUS, 0) & VIDEO_STATUS_WAITING);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    assert_false(rig_read(r, VIDEO_STATUS, 0) & VIDEO_STATUS_WAITING);
    assert_int_equal(r->line[0].drive[0][0], 77);
    rig_write(r, VIDEO_BASE, 404, 1);
    assert_true(rig_read(r, VIDEO_STATUS, 1) & VIDEO_STATUS_WAITING);
    rig_write(r, VIDEO_BASE, 400, 2); /* as it is: nothing to wait for */
    assert_false(rig_read(r, VIDEO_STATUS, 2) & VIDEO_STATUS_WAITING);
    rig_close(r);
}

static void impossible_timings_are_refused(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    static const struct {
        uint32_t offset, value;
    } bad[] = {{VIDEO_CLOCK, 0},
               {VIDEO_CLOCK, 99999},
               {VIDEO_CLOCK, 1000000001},
               {VIDEO_H_VISIBLE, 7},
               {VIDEO_H_VISIBLE, 19},
               {VIDEO_H_SYNC_START, 21},
               {VIDEO_H_SYNC_START, 15},
               {VIDEO_H_SYNC_END, 25},
               {VIDEO_H_SYNC_END, 18},
               {VIDEO_H_TOTAL, 20},
               {VIDEO_H_TOTAL, 16385},
               {VIDEO_H_TOTAL, ~0u},
               {VIDEO_V_VISIBLE, 0},
               {VIDEO_V_VISIBLE, 12},
               {VIDEO_V_SYNC_START, 13},
               {VIDEO_V_SYNC_END, 16},
               {VIDEO_V_TOTAL, 12},
               {VIDEO_V_TOTAL, 1000000},
               {VIDEO_V_SYNC_END, 1u << 31}};
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        uint64_t at = 1000 + i;
        write_timing(r, &t, at);
        rig_write(r, bad[i].offset, bad[i].value, at);
        assert_int_equal(rig_read(r, bad[i].offset, at), bad[i].value);
        rig_write(r, VIDEO_LOAD, 1, at);
        assert_true(rig_read(r, VIDEO_STATUS, at) & VIDEO_STATUS_BAD_MODE);
        rig_write(r, VIDEO_STATUS, VIDEO_STATUS_BAD_MODE, at);
        assert_false(rig_read(r, VIDEO_STATUS, at) & VIDEO_STATUS_BAD_MODE);
    }
    assert_int_equal(r->retimes, 1);
    rig_run(r, frame_time(&t) - 1);
    assert_int_equal(r->lines, 10); /* what was goes on */
    rig_close(r);
}

static void what_the_monitor_cannot_follow(void **state)
{
    (void)state;
    struct crt_error err;
    struct ras_timing vga, t;
    assert_true(ras_mode_parse("640x480@60", &vga, &err));
    struct head_rig *r = rig_open(&vga, 1, 0);
    r->head.desc.monitor = (struct ras_monitor){30, 50, 50, 76, 70};
    static const struct {
        const char *mode;
        bool follows;
    } rows[] = {{"800x600@60", true},    {"1024x768@60", true}, {"1280x1024@60", false}, /* kHz */
                {"640x480@85", false},                                                   /* Hz */
                {"1024x768@43i", false},                          /* fields */
                {"525/60i", false},      {"1024x768@70", false}}; /* 15.7 kHz; 75 MHz, 56 kHz */
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        assert_true(ras_mode_parse(rows[i].mode, &t, &err));
        write_timing(r, &t, i);
        rig_write(r, VIDEO_LOAD, 1, i);
        uint32_t status = rig_read(r, VIDEO_STATUS, i);
        assert_int_equal(!(status & VIDEO_STATUS_OUT_RANGE), rows[i].follows);
        assert_false(status & VIDEO_STATUS_BAD_MODE);
        rig_write(r, VIDEO_STATUS, VIDEO_STATUS_OUT_RANGE, i);
    }
    rig_close(r);
}

static void formats(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    for (uint32_t f = 0; f < 70; f++) {
        bool is = f == 1 || f == 2 || f == 4 || f == 8 || f == 16 || f == 24 || f == 32;
        rig_write(r, VIDEO_FORMAT, 8, 0);
        rig_write(r, VIDEO_FORMAT, f, 0);
        assert_int_equal(rig_read(r, VIDEO_FORMAT, 0), is ? f : 8);
        assert_int_equal(!(rig_read(r, VIDEO_STATUS, 0) & VIDEO_STATUS_BAD_FORMAT), is);
        rig_write(r, VIDEO_STATUS, ~0u, 0);
    }
    rig_close(r);
}

/* Off: no event, no line; what has been handed over stays. On: a first field. */
static void off_and_on(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    uint64_t row3 = rig_dot(&t, 0, 3 * 24 + 4);
    rig_write(r, VIDEO_CONTROL, 0, row3);
    assert_int_equal(r->lines, 4);
    assert_true(ras_head_next(&r->head) == UINT64_MAX);
    rig_run(r, frame_time(&t) * 3);
    assert_int_equal(r->lines, 4);
    uint64_t on = frame_time(&t) * 3 + 17;
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, on);
    assert_int_equal(ras_head_next(&r->head), on);
    rig_run(r, on);
    assert_int_equal(r->line[4].t0, on);
    assert_int_equal(r->line[4].source, 0);
    assert_int_equal(r->retimes, 2);
    rig_close(r);
}

/* ---- wires ------------------------------------------------------------------------------------ */

/* A level is pending and enabled; a wire is called when it changes, at that time. */
static void levels(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    uint64_t seed = 4, now = 0;
    struct head_rig *r = rig_open(&t, 1, 0);
    rig_write(r, VIDEO_LINE_COMPARE, 3, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    bool level[2] = {false, false};
    for (int n = 0; n < 5000; n++) {
        now += rig_random(&seed) % (frame_time(&t) / 4);
        uint32_t offset = rig_random(&seed) % 2 ? VIDEO_STATUS : VIDEO_IRQ_ENABLE;
        rig_run(r, now);
        uint32_t pending = rig_read(r, VIDEO_STATUS, now), enabled;
        enabled = rig_read(r, VIDEO_IRQ_ENABLE, now);
        for (int i = 0; i < r->irqs; i++) {
            assert_true(r->irq[i].level != level[r->irq[i].which]);
            level[r->irq[i].which] = r->irq[i].level;
            assert_true(r->irq[i].t <= now);
        }
        assert_int_equal(level[RAS_INT_RETRACE], (pending & enabled & VIDEO_STATUS_RETRACE) != 0);
        assert_int_equal(level[RAS_INT_COMPARE], (pending & enabled & VIDEO_STATUS_COMPARE) != 0);
        assert_int_equal(ras_head_interrupt(&r->head, RAS_INT_RETRACE), level[RAS_INT_RETRACE]);
        rig_forget(r);
        rig_write(r, offset, (uint32_t)rig_random(&seed), now);
        for (int i = 0; i < r->irqs; i++)
            assert_int_equal(r->irq[i].t, now);
    }
    rig_forget(r);
    rig_write(r, VIDEO_IRQ_ENABLE, ~0u, now);
    rig_run(r, now + frame_time(&t));
    assert_int_equal(rig_read(r, VIDEO_IRQ_ENABLE, now + frame_time(&t)),
                     VIDEO_STATUS_RETRACE | VIDEO_STATUS_COMPARE);
    rig_forget(r);
    ras_head_reset(&r->head, now + frame_time(&t));
    assert_int_equal(r->irqs, 2);
    assert_false(r->irq[0].level || r->irq[1].level);
    rig_close(r);
}

/* When COMPARE is set depends on the register as it is when the line begins. */
static void compare_is_moved(void **state)
{
    (void)state;
    struct ras_timing t = RIG_SMALL;
    struct head_rig *r = rig_open(&t, 1, 60); /* with overscan lines are read before they begin */
    uint64_t row5 = rig_dot(&t, 0, 5 * 24), frame = frame_time(&t);
    rig_write(r, VIDEO_IRQ_ENABLE, VIDEO_STATUS_COMPARE, 0);
    rig_write(r, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    rig_write(r, VIDEO_LINE_COMPARE, 5, row5 - 1); /* in time */
    rig_run(r, row5);
    assert_int_equal(r->irqs, 1);
    assert_int_equal(r->irq[0].t, row5);
    rig_write(r, VIDEO_STATUS, VIDEO_STATUS_COMPARE, row5);
    rig_write(r, VIDEO_LINE_COMPARE, 8, row5 + 1);
    rig_write(r, VIDEO_LINE_COMPARE, 5, row5 + 2); /* too late for this frame */
    rig_run(r, frame + row5 - 1);
    assert_int_equal(r->irqs, 2);
    rig_run(r, frame + row5);
    assert_int_equal(r->irqs, 3);
    rig_write(r, VIDEO_STATUS, VIDEO_STATUS_COMPARE, frame + row5);
    rig_write(r, VIDEO_LINE_COMPARE, 10, frame + row5); /* no row of the picture */
    rig_run(r, 4 * frame);
    rig_write(r, VIDEO_LINE_COMPARE, ~0u, 4 * frame);
    rig_run(r, 6 * frame);
    assert_int_equal(r->irqs, 4);
    assert_int_equal(r->lines, 61); /* none was disturbed; row 0 of the seventh has been read */
    rig_close(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(there_are_these_and_no_more),
        cmocka_unit_test(power_on),
        cmocka_unit_test(a_loaded_timing_runs),
        cmocka_unit_test(a_timing_begins_with_the_registers),
        cmocka_unit_test(impossible_timings_are_refused),
        cmocka_unit_test(what_the_monitor_cannot_follow),
        cmocka_unit_test(formats),
        cmocka_unit_test(off_and_on),
        cmocka_unit_test(levels),
        cmocka_unit_test(compare_is_moved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
