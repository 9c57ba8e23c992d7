/* Steps back by strokes and scan lines lead to the very state that was there on the way; where the beam is, told
 * against the strokes and the timing. */
#include "tests/emu/light_rig.h"

#include <math.h>
#include <string.h>

#include "emu/where.h"
#include "tests/support/rig_digest.h"

static void run_to(struct bench *b, uint64_t t)
{
    while (b->rig.machine->now < t) {
        uint64_t next = b->rig.machine->now + 7 * MS;
        vm_machine_run(b->rig.machine, next < t ? next : t);
        vm_history_note(b->history);
    }
}

/* ---- there and back ------------------------------------------------------------------------------ */

static void there_and_back(struct bench *b, enum vm_unit unit,
                           bool (*forward)(struct vm_machine *, uint64_t))
{
    enum { STEPS = 60 };
    static struct digest was[STEPS];
    static uint64_t at[STEPS];
    static const unsigned hops[] = {1, 1, 7, 1, 20, 1, 3};
    struct vm_machine *m = b->rig.machine;
    struct crt_error err;
    for (int i = 0; i < STEPS; i++) {
        assert_true(forward(m, m->now + CRT_PS_PER_S));
        vm_history_note(b->history);
        was[i] = rig_digest(&b->rig);
        at[i] = m->now;
    }
    unsigned i = STEPS - 1;
    for (size_t k = 0; k < COUNT(hops); k++) {
        i -= hops[k];
        assert_true(vm_history_back(b->history, unit, hops[k], &err));
        assert_int_equal(m->now, at[i]);
        struct digest is = rig_digest(&b->rig);
        assert_memory_equal(is.byte, was[i].byte, sizeof is.byte);
    }
    /* From in between, the last is where it came from. */
    vm_machine_run(m, m->now + (at[i + 1] - at[i]) / 2);
    assert_true(vm_history_back(b->history, unit, 1, &err));
    assert_int_equal(m->now, at[i]);
}

static void back_by_strokes(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/lander.df", NULL, NULL, VM_VIEW_VECTOR);
    run_to(b, 300 * MS);
    there_and_back(b, VM_UNIT_STROKE, vm_machine_run_stroke);
    tear_down(b);
}

/* Over the dark time between refreshes, and where nothing is known but a snapshot. */
static void back_by_strokes_over_the_dark(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/spin.df", NULL, NULL, VM_VIEW_VECTOR);
    struct vm_machine *m = b->rig.machine;
    struct crt_error err;
    uint64_t end = 0;
    run_to(b, 190 * MS);
    while (m->now < 215 * MS) {
        assert_true(vm_machine_run_stroke(m, CRT_PS_PER_S));
        vm_history_note(b->history);
        end = m->now < 215 * MS ? m->now : end;
    }
    assert_true(end > 200 * MS);
    tear_down(b);
    b = set_up("roms/spin.df", NULL, NULL, VM_VIEW_VECTOR);
    m = b->rig.machine;
    run_to(b, 215 * MS);
    memset(m->recent, 0, sizeof m->recent); /* as if just loaded */
    assert_true(vm_history_back(b->history, VM_UNIT_STROKE, 1, &err));
    assert_int_equal(m->now, end);
    /* There is a first one. */
    while (vm_history_back(b->history, VM_UNIT_STROKE, 500, &err))
        ;
    assert_string_equal(err.text, "this is as far back as the run is remembered");
    assert_int_equal(m->now, 0);
    tear_down(b);
}

static void back_by_lines(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/mask.elf", NULL, NULL, VM_VIEW_RASTER);
    struct vm_machine *m = b->rig.machine;
    run_to(b, 60 * MS);
    assert_true(vm_machine_uses_raster(m));
    there_and_back(b, VM_UNIT_LINE, vm_machine_run_line);
    uint32_t line, dot;
    assert_true(ras_head_beam(&m->raster, m->now, &line, &dot));
    assert_int_equal(dot, 0);
    tear_down(b);
}

/* ---- where --------------------------------------------------------------------------------------- */

struct seen {
    struct crt_stroke stroke[4096];
    size_t count;
};

static void see(void *ctx, const struct crt_stroke *stroke)
{
    struct seen *seen = ctx;
    if (seen->count < COUNT(seen->stroke))
        seen->stroke[seen->count++] = *stroke;
}

static void the_beam_is_on_its_stroke(void **state)
{
    static struct seen seen;
    (void)state;
    struct bench *b = set_up("roms/lander.df", NULL, NULL, VM_VIEW_VECTOR);
    vm_machine_trace(b->rig.machine, 40 * MS, &(struct vm_hooks){.ctx = &seen, .stroke = see});
    tear_down(b);
    assert_true(seen.count > 500);
    b = set_up("roms/lander.df", NULL, NULL, VM_VIEW_VECTOR);
    struct vm_machine *m = b->rig.machine;
    char text[160], address[16];
    for (size_t i = 0; i < seen.count; i += 7) {
        const struct crt_stroke *s = &seen.stroke[i];
        vm_machine_run(m, s->t0 + (s->t1 - s->t0) / 4);
        struct vm_where w = vm_where(m, VM_VECTOR);
        assert_true(w.known && w.lit);
        assert_true(fabs(w.x_mm - (0.75 * (double)s->x0 + 0.25 * (double)s->x1)) < 1e-3);
        assert_true(fabs(w.y_mm - (0.75 * (double)s->y0 + 0.25 * (double)s->y1)) < 1e-3);
        vm_where_text(m, &w, text, sizeof text);
        snprintf(address, sizeof address, "%06o:", (unsigned)s->source);
        assert_int_equal(strncmp(text, address, strlen(address)), 0);
        assert_non_null(strstr(text, "beam on"));
    }
    tear_down(b);
}

static void the_raster_is_told_by_line_and_dot(void **state)
{
    (void)state;
    struct bench *b = set_up("roms/mask.elf", NULL, NULL, VM_VIEW_RASTER);
    struct vm_machine *m = b->rig.machine;
    char text[160];
    struct vm_where w = vm_where(m, VM_RASTER);
    vm_where_text(m, &w, text, sizeof text);
    assert_string_equal(text, "the raster head is off");
    run_to(b, 60 * MS);
    const struct ras_timing *t = &m->raster.timing;
    uint64_t frame = (uint64_t)t->v.total * t->h.total;
    uint64_t begun = crt_tick_at(t->clock, m->now - m->raster.origin) / frame * frame + frame;
    const uint32_t places[][2] = {{0, 0},
                                  {10, 20},
                                  {10, t->h.visible},
                                  {5, t->h.total - 1},
                                  {t->v.visible - 1, t->h.visible - 1},
                                  {t->v.visible + 5, 3},
                                  {t->v.total - 1, 0}};
    for (size_t i = 0; i < COUNT(places); i++) {
        uint64_t at =
            begun + (uint64_t)i * frame + (uint64_t)places[i][0] * t->h.total + places[i][1];
        vm_machine_run(m, m->raster.origin + crt_tick_time(t->clock, at));
        w = vm_where(m, VM_RASTER);
        assert_int_equal(w.line, places[i][0]);
        assert_int_equal(w.dot, places[i][1]);
        bool seen = w.line < t->v.visible && w.dot < t->h.visible;
        assert_int_equal(w.on_screen, seen);
        vm_where_text(m, &w, text, sizeof text);
        assert_true((strstr(text, "blanking") == NULL) == seen);
    }
    tear_down(b);
}

static void times_have_the_digits_that_move(void **state)
{
    (void)state;
    char text[40];
    vm_where_time(UINT64_C(1234567890123), CRT_PS_PER_S / 60, text, sizeof text);
    assert_string_equal(text, "1.23 s");
    vm_where_time(UINT64_C(1234567890123), CRT_PS_PER_S / 60000, text, sizeof text);
    assert_string_equal(text, "1.23456 s");
    vm_where_time(UINT64_C(1234567890123), 1, text, sizeof text);
    assert_string_equal(text, "1.234567890123 s");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(back_by_strokes),
        cmocka_unit_test(back_by_strokes_over_the_dark),
        cmocka_unit_test(back_by_lines),
        cmocka_unit_test(the_beam_is_on_its_stroke),
        cmocka_unit_test(the_raster_is_told_by_line_and_dot),
        cmocka_unit_test(times_have_the_digits_that_move),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
