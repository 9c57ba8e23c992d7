/* Steps of the machine to the end of every stroke, against what the trace's hooks say. */
#include <math.h>

#include "tests/emu/processor_rig.h"

#define DF_MODE(m) (DF_SET_MODE | (m) << DF_MODE_SHIFT)
#define LIT        DF_BEAM_ON

/* Characters, a vector of dots and dashes across the screen, points: many strokes a word, and one. */
static const uint16_t words[] = {
    DF_MODE(DF_MODE_POINT),
    100,
    100,
    DF_MODE(DF_MODE_CHAR),
    'A' | 'g' << 8,
    '.' | '#' << 8,
    DF_MODE(DF_MODE_LONG) | DF_SGM_LINE | DF_LINE_DOTDASH,
    LIT | 700,
    300,
    DF_MODE(DF_MODE_LONG) | DF_SGM_LINE | DF_LINE_SOLID,
    LIT | DF_SIGN_X | 300,
    200,
    DF_MODE(DF_MODE_POINT) | DF_SGM_LINE | DF_LINE_SOLID,
    LIT | 500,
    500,
    LIT | 501,
    500,
    DF_STOP,
};

#define DASHED    7 /* words that vectors begin with */
#define SOLID     10
#define VECTOR(s) ((s)->source == 01000 + 2 * DASHED || (s)->source == 01000 + 2 * SOLID)

static struct vm_machine *start(void)
{
    struct vm_machine *m = calloc(1, sizeof *m);
    struct df_program program = {0};
    struct crt_error err;
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    assert_non_null(m);
    assert_true(df_program_init(&program, &err));
    for (size_t i = 0; i < COUNT(words); i++)
        df_program_put(&program, 01000 + 2 * (uint32_t)i, words[i]);
    program.entry = 01000;
    vm_machine_init(m, &(struct vm_machine_desc){.row = row,
                                                 .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                                 .tick = {60, 1},
                                                 .memory_bytes = 16384,
                                                 .on_stop = VM_RESTART});
    assert_true(vm_machine_load(m, &program, "test", &err));
    df_program_free(&program);
    return m;
}

/* What the hooks see. */
struct seen {
    struct crt_stroke stroke[2048];
    size_t count;
};

static void see(void *ctx, const struct crt_stroke *stroke)
{
    struct seen *seen = ctx;
    assert_true(seen->count < COUNT(seen->stroke));
    seen->stroke[seen->count++] = *stroke;
}

static void run_seen(struct seen *seen, uint64_t until)
{
    struct vm_machine *m = start();
    vm_machine_trace(m, until, &(struct vm_hooks){.ctx = seen, .stroke = see});
    free(m);
}

/* Ends of strokes: all that is lit without a break by one word of the program above, whose words each draw points
 * apart, dashes apart, or one whole vector. */
static size_t ends_of(const struct seen *seen, uint64_t ends[])
{
    size_t count = 0;
    for (size_t i = 0; i < seen->count; i++) {
        const struct crt_stroke *s = &seen->stroke[i], *next = s + 1;
        bool goes_on =
            i + 1 < seen->count && next->t0 == s->t1 && next->source == s->source && VECTOR(s);
        if (!goes_on)
            ends[count++] = s->t1;
    }
    return count;
}

static void every_stroke_is_a_step(void **state)
{
    static struct seen seen;
    static uint64_t ends[COUNT(seen.stroke)];
    (void)state;
    seen.count = 0;
    run_seen(&seen, 50 * MS);
    size_t count = ends_of(&seen, ends), whole = 0;
    struct vm_machine *m = start();
    assert_true(count > 3 * 60);
    for (size_t i = 0; i < count; i++) {
        assert_true(vm_machine_run_stroke(m, CRT_PS_PER_S));
        assert_int_equal(m->now, ends[i]);
        assert_int_equal(vm_machine_stroke_before(m, m->now + 1), ends[i]);
        if (i > 0 && ends[i] - ends[i - 1] < 100 * US)
            assert_int_equal(vm_machine_stroke_before(m, m->now), ends[i - 1]);
        whole += vm_machine_stroke(m)->source == 01000 + 2 * SOLID;
    }
    /* One step for each vector, with its rests: three refreshes. */
    assert_int_equal(whole, 3);
    free(m);
}

static void strokes_under_way_are_steps_too(void **state)
{
    static struct seen seen;
    static uint64_t ends[COUNT(seen.stroke)];
    (void)state;
    seen.count = 0;
    run_seen(&seen, 80 * MS);
    ends_of(&seen, ends);
    struct vm_machine *m = start();
    uint64_t random = 12345;
    while (m->now < 45 * MS) {
        random = random * UINT64_C(6364136223846793005) + 1;
        vm_machine_run(m, m->now + (random >> 33) % (50 * US));
        size_t next = 0;
        while (ends[next] <= m->now)
            next++;
        uint64_t end = ends[next];
        if (random >> 62 == 0) {
            assert_false(vm_machine_run_stroke(m, end - 1));
            assert_int_equal(m->now, end - 1 > m->now ? end - 1 : m->now);
        } else {
            assert_true(vm_machine_run_stroke(m, end));
            assert_int_equal(m->now, end);
        }
    }
    free(m);
}

/* Where the beam is, from the strokes themselves. */
static void the_beam_is_where_the_stroke_is(void **state)
{
    static struct seen seen;
    (void)state;
    seen.count = 0;
    run_seen(&seen, 30 * MS);
    struct vm_machine *m = start();
    double x = 0, y = 0;
    bool lit;
    assert_false(vm_machine_beam(m, &x, &y, &lit));
    assert_null(vm_machine_stroke(m));
    for (size_t i = 0; i < seen.count; i++) {
        const struct crt_stroke *s = &seen.stroke[i];
        const struct crt_screen *screen = &m->dpu.desc.screen;
        uint64_t middle = s->t0 + (s->t1 - s->t0) / 2;
        vm_machine_run(m, middle);
        assert_true(vm_machine_beam(m, &x, &y, &lit));
        assert_true(lit);
        float mm[2];
        crt_screen_to_mm(screen, x, y, &mm[0], &mm[1]);
        assert_true(fabsf(mm[0] - (s->x0 + s->x1) / 2) < 1e-3F);
        assert_true(fabsf(mm[1] - (s->y0 + s->y1) / 2) < 1e-3F);
        assert_int_equal(vm_machine_stroke(m)->source, s->source);
        vm_machine_run(m, s->t1);
        assert_true(vm_machine_beam(m, &x, &y, &lit));
        assert_false(lit);
        assert_int_equal(vm_machine_stroke(m)->t1, s->t1);
    }
    assert_true(fabs(x - 501) < 1e-3 && fabs(y - 500) < 1e-3); /* the last point */
    free(m);
}

static void recordings_are_stepped_through(void **state)
{
    (void)state;
    static const struct crt_stroke strokes[] = {
        {MS, 2 * MS, 0, 0, 1, 1, 1, 0, 0},
        {3 * MS, 4 * MS, 1, 1, 2, 2, 1, 0, 0},
        {40 * MS, 41 * MS, 2, 2, 3, 3, 1, 0, 0},
    };
    struct vm_machine *m = start();
    struct vm_machine_desc desc = m->desc;
    vm_machine_init(m, &desc);
    vm_machine_play(m, (struct vm_recording){strokes, COUNT(strokes)});
    for (size_t i = 0; i < COUNT(strokes); i++) {
        assert_true(vm_machine_run_stroke(m, CRT_PS_PER_S));
        assert_int_equal(m->now, strokes[i].t1);
    }
    assert_false(vm_machine_run_stroke(m, 60 * MS));
    assert_int_equal(m->now, 60 * MS);
    free(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_stroke_is_a_step),
        cmocka_unit_test(strokes_under_way_are_steps_too),
        cmocka_unit_test(the_beam_is_where_the_stroke_is),
        cmocka_unit_test(recordings_are_stepped_through),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
