/* One test per register and its write effects; START, RESUME, stop, sync, time-out. */
#include "tests/support/dpu_rig.h"

static struct dpu_rig rig;
static struct dpu_rig *const r = &rig;

static void expect_event(size_t index, enum df_interrupt line, bool level, uint64_t t)
{
    assert_true(index < r->event_count);
    assert_int_equal(r->events[index].line, line);
    assert_int_equal(r->events[index].level, level);
    assert_int_equal(r->events[index].t, t);
}

static void reset_state(void **state)
{
    (void)state;
    dpu_rig_init(r);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), 4 << 8);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 0);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 0);
    assert_true(r->dpu.pen_intensify);
    assert_false(r->dpu.pen_interrupt || r->dpu.stop_interrupt);
    /* Reset brings all that back, and drops interrupts, but not time. */
    RUN(r, 0113777, 0171670, 0174177, 0114000, 5, 6, 0173400);
    assert_int_equal(r->event_count, 1);
    uint64_t t = r->dpu.t;
    df_dpu_reset(&r->dpu, 0);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), 4 << 8);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 0);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 0);
    assert_true(r->dpu.pen_intensify);
    assert_false(r->dpu.pen_interrupt || r->dpu.stop_interrupt);
    assert_int_equal(r->dpu.words, 0);
    assert_int_equal(r->dpu.t, t);
    assert_int_equal(r->event_count, 2);
    df_dpu_reset(&r->dpu, t + 5);
    assert_int_equal(r->dpu.t, t + 5);
}

static void dpc_counts_past_the_word(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0400, 0164000, 0164000);
    df_dpu_write(&r->dpu, DF_DPC, 0400, 0);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0400);
    df_dpu_step(&r->dpu);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0402);
    /* The last word of memory is followed by the first. */
    LOAD(r, 0177776, 0164000);
    LOAD(r, 0, 0164000, DF_STOP);
    dpu_rig_go(r, 0177776);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 4);
}

static void even_write_starts_there(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0113777, 0174177, 0114000, 5, 6, 0100000, 'A' | 0101 << 8);
    /* START keeps position, intensity, mode, step and character … */
    unsigned mpr = dpu_rig_reg(r, DF_MPR);
    assert_int_equal(mpr & DF_MPR_STOP, DF_MPR_STOP);
    df_dpu_write(&r->dpu, DF_DPC, 0200, 100 * US);
    assert_int_equal(r->dpu.state, DF_RUNNING);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0200);
    assert_int_equal(r->dpu.t, 100 * US);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), mpr & ~(unsigned)DF_MPR_STOP);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 077 << 10 | (5 + 28));
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 1 << 10 | 6);
    /* … but forgets half a datum and a pending address. */
    LOAD(r, 0, 0110000, DF_BEAM_ON | 9, DF_STOP);
    LOAD(r, 0200, 1, 2, DF_STOP);
    df_dpu_write(&r->dpu, DF_DPC, 0, r->dpu.t);
    df_dpu_step(&r->dpu);
    df_dpu_step(&r->dpu);
    dpu_rig_go(r, 0200);
    assert_int_equal(r->dpu.x, 5 + 28 + 1);
    LOAD(r, 0, 0160000, 0400);
    df_dpu_write(&r->dpu, DF_DPC, 0, r->dpu.t);
    df_dpu_step(&r->dpu);
    LOAD(r, 0200, DF_STOP);
    dpu_rig_go(r, 0200);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 0202);
}

static void start_while_drawing_waits_for_the_generator(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0110000, DF_BEAM_ON | 100, 0);
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    for (int i = 0; i < 3; i++)
        df_dpu_step(&r->dpu);
    uint64_t busy = r->dpu.t;
    df_dpu_write(&r->dpu, DF_DPC, 0, busy - 5 * US);
    assert_int_equal(r->dpu.t, busy);
    dpu_rig_continue(r);
    assert_int_equal(r->count, 2);
    assert_true(r->strokes[1].t0 >= r->strokes[0].t1);
}

static void odd_write_resumes(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, DF_STOP, 0164000, DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 2);
    df_dpu_write(&r->dpu, DF_DPC, 0777, 50 * US);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 2);
    assert_int_equal(r->dpu.state, DF_RUNNING);
    assert_int_equal(r->dpu.t, 50 * US);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_STOP, 0);
    dpu_rig_continue(r);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 6);
    /* A RESUME while running changes nothing, half a datum included. */
    LOAD(r, 0, 0110000, DF_BEAM_ON | 9, 8, DF_STOP);
    df_dpu_write(&r->dpu, DF_DPC, 0, r->dpu.t);
    df_dpu_step(&r->dpu);
    df_dpu_step(&r->dpu);
    uint64_t t = r->dpu.t;
    df_dpu_write(&r->dpu, DF_DPC, 1, t + 3 * US);
    assert_int_equal(r->dpu.t, t);
    dpu_rig_continue(r);
    assert_int_equal(r->count, 1);
    dpu_rig_expect_stroke(r, 0, 0, 0, 9, 8);
}

static void mpr_write_rings_the_bell(void **state)
{
    (void)state;
    dpu_rig_init(r);
    struct df_dpu before = r->dpu;
    df_dpu_write(&r->dpu, DF_MPR, 0177777, 5);
    df_dpu_write(&r->dpu, DF_MPR, 0, 6);
    assert_int_equal(r->bells, 2);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), df_dpu_read(&before, DF_MPR));
    assert_int_equal(r->dpu.state, DF_STOPPED);
    r->dpu.desc.wires.bell = NULL;
    df_dpu_write(&r->dpu, DF_MPR, 0, 7);
}

static void mpr_shows_the_mode_of_data(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0114000, 0164000, 5, 6, 0170000);
    df_dpu_write(&r->dpu, DF_DPC, 0, 0);
    static const unsigned shown[] = {3, 015, 3, 3, 016};
    for (unsigned i = 0; i < 5; i++) {
        df_dpu_step(&r->dpu);
        assert_int_equal((dpu_rig_reg(r, DF_MPR) & DF_MPR_MODE) >> 11, shown[i]);
    }
}

static void mpr_shows_every_parameter(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0100000 | 02000 | 5 << 7 | 020 | 010 | 04 | 2, 0170060);
    assert_int_equal(dpu_rig_reg(r, DF_MPR), 0100000 | 070000 | 5 << 8 | 020 | 010 | 2);
}

static void xpr_and_ypr_ignore_writes(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0174100 | 3, 0114000, 5, 6);
    df_dpu_write(&r->dpu, DF_XPR, 0177777, 0);
    df_dpu_write(&r->dpu, DF_YPR, 0177777, 0);
    assert_int_equal(dpu_rig_reg(r, DF_XPR), 3 << 10 | 5);
    assert_int_equal(dpu_rig_reg(r, DF_YPR), 6);
}

static void ypr_shows_six_bits_of_the_character(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0100000, 'a' | 'z' << 8);
    assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, 'z' & 077);
    RUN(r, 0100000, 'a'); /* NUL is not copied */
    assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, 'a' & 077);
    RUN(r, 0100000, 015 << 8 | 'b');
    assert_int_equal(dpu_rig_reg(r, DF_YPR) >> 10, 015);
}

static void vs60_registers_are_not_there(void **state)
{
    (void)state;
    dpu_rig_init(r);
    RUN(r, 0114000, 5, 6);
    for (unsigned offset = 010; offset <= 036; offset += 2) {
        df_dpu_write(&r->dpu, offset, 0177777, 0);
        assert_int_equal(dpu_rig_reg(r, offset), 0);
    }
    assert_int_equal(r->dpu.state, DF_STOPPED);
}

static void stop_interrupts_when_enabled(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0164000, 0173400, 0164000, DF_STOP, 0173000);
    dpu_rig_go(r, 0);
    assert_int_equal(r->event_count, 1);
    expect_event(0, DF_INT_STOP, true, 2 * FETCH);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 4);
    /* RESUME takes the line down; the enable stays. */
    df_dpu_write(&r->dpu, DF_DPC, 1, 100 * US);
    expect_event(1, DF_INT_STOP, false, 100 * US);
    dpu_rig_continue(r);
    expect_event(2, DF_INT_STOP, true, 100 * US + 2 * FETCH);
    /* START does, too; and the word that disables does not interrupt. */
    df_dpu_write(&r->dpu, DF_DPC, 8, 200 * US);
    expect_event(3, DF_INT_STOP, false, 200 * US);
    dpu_rig_continue(r);
    assert_int_equal(r->event_count, 4);
    assert_int_equal(r->dpu.state, DF_STOPPED);
}

static void lines_do_not_fall_before_they_rise(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0173400);
    dpu_rig_go(r, 0);
    expect_event(0, DF_INT_STOP, true, FETCH);
    df_dpu_write(&r->dpu, DF_DPC, 0, FETCH / 2); /* while the word is still being decoded */
    expect_event(1, DF_INT_STOP, false, FETCH);
    assert_int_equal(r->dpu.t, FETCH);
}

static void sync_waits_for_the_tick(void **state)
{
    (void)state;
    dpu_rig_init(r);
    LOAD(r, 0, 0170004, DF_STOP);
    dpu_rig_go(r, 0);
    assert_int_equal(r->dpu.state, DF_WAITING_SYNC);
    assert_int_equal(r->dpu.words, 1);
    df_dpu_sync(&r->dpu, 16667 * US);
    assert_int_equal(r->dpu.state, DF_RUNNING);
    assert_int_equal(r->dpu.t, 16667 * US);
    dpu_rig_continue(r);
    assert_int_equal(r->dpu.t, 16667 * US + FETCH);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    /* Ticks mean nothing to a processor that does not wait. */
    df_dpu_sync(&r->dpu, 33333 * US);
    assert_int_equal(r->dpu.state, DF_STOPPED);
    assert_int_equal(r->dpu.t, 16667 * US + FETCH);
}

static void sync_can_be_left(void **state)
{
    (void)state;
    dpu_rig_init(r);
    /* A tick while the word is still being decoded is the one waited for. */
    LOAD(r, 0, 0170004, DF_STOP);
    dpu_rig_go(r, 0);
    df_dpu_sync(&r->dpu, FETCH / 2);
    assert_int_equal(r->dpu.t, FETCH);
    /* START ends the wait, RESUME does not. */
    dpu_rig_go(r, 0);
    df_dpu_write(&r->dpu, DF_DPC, 1, 50 * US);
    assert_int_equal(r->dpu.state, DF_WAITING_SYNC);
    LOAD(r, 0100, 0164000);
    df_dpu_write(&r->dpu, DF_DPC, 0100, 60 * US);
    assert_int_equal(r->dpu.state, DF_RUNNING);
    assert_int_equal(r->dpu.t, 60 * US);
    /* The stop bit overrides the sync bit. */
    LOAD(r, 0200, 0172004);
    dpu_rig_go(r, 0200);
    assert_int_equal(r->dpu.state, DF_STOPPED);
}

static void fetch_beyond_memory_times_out(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.memory_bytes = 040000;
    dpu_rig_restart(r);
    LOAD(r, 037776, 0164000);
    dpu_rig_go(r, 037776);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_true(r->dpu.timeout);
    assert_int_equal(r->dpu.words, 1);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 040002);
    assert_int_equal(dpu_rig_reg(r, DF_MPR) & DF_MPR_SO, 0);
    assert_int_equal(r->event_count, 1);
    expect_event(0, DF_INT_CHARACTER, true, 2 * FETCH);
    /* RESUME tries the next word and times out again. */
    df_dpu_write(&r->dpu, DF_DPC, 1, 10 * US);
    expect_event(1, DF_INT_CHARACTER, false, 10 * US);
    assert_false(r->dpu.timeout);
    dpu_rig_continue(r);
    expect_event(2, DF_INT_CHARACTER, true, 10 * US + FETCH);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 040004);
    /* START in memory goes on. */
    df_dpu_write(&r->dpu, DF_DPC, 0, 20 * US);
    assert_false(r->dpu.timeout);
    dpu_rig_continue(r);
    assert_int_equal(r->dpu.state, DF_STOPPED);
}

static void address_word_may_time_out(void **state)
{
    (void)state;
    dpu_rig_init(r);
    r->desc.memory_bytes = 040000;
    dpu_rig_restart(r);
    LOAD(r, 037776, 0160000);
    dpu_rig_go(r, 037776);
    assert_int_equal(r->dpu.state, DF_WAITING_RESUME);
    assert_true(r->dpu.timeout);
    assert_int_equal(dpu_rig_reg(r, DF_DPC), 040002);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reset_state),
        cmocka_unit_test(dpc_counts_past_the_word),
        cmocka_unit_test(even_write_starts_there),
        cmocka_unit_test(start_while_drawing_waits_for_the_generator),
        cmocka_unit_test(odd_write_resumes),
        cmocka_unit_test(mpr_write_rings_the_bell),
        cmocka_unit_test(mpr_shows_the_mode_of_data),
        cmocka_unit_test(mpr_shows_every_parameter),
        cmocka_unit_test(xpr_and_ypr_ignore_writes),
        cmocka_unit_test(ypr_shows_six_bits_of_the_character),
        cmocka_unit_test(vs60_registers_are_not_there),
        cmocka_unit_test(stop_interrupts_when_enabled),
        cmocka_unit_test(lines_do_not_fall_before_they_rise),
        cmocka_unit_test(sync_waits_for_the_tick),
        cmocka_unit_test(sync_can_be_left),
        cmocka_unit_test(fetch_beyond_memory_times_out),
        cmocka_unit_test(address_word_may_time_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
