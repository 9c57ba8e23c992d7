/* What a window shows of light: long exposures put together are those taken in one piece; nothing flashes where
 * nothing is to; which pictures flash. */
#include "tests/emu/light_rig.h"

#include <math.h>
#include <string.h>

#include "emu/calm.h"
#include "emu/show.h"

/* ---- long exposures ------------------------------------------------------------------------------ */

static const float *light_of(const struct vm_frame *f, size_t *cells)
{
    *cells = (size_t)f->film[VM_VECTOR].grid.cols * (size_t)f->film[VM_VECTOR].grid.rows;
    return f->film[VM_VECTOR].light[0];
}

/* The largest difference of two films, as a part of the largest sample. */
static double apart(const struct vm_frame *a, const struct vm_frame *b)
{
    size_t cells;
    const float *x = light_of(a, &cells), *y = light_of(b, &cells);
    double most = 0, crest = 0;
    for (size_t i = 0; i < cells; i++) {
        most = fmax(most, fabs((double)x[i] - (double)y[i]));
        crest = fmax(crest, (double)y[i]);
    }
    assert_true(crest > 0);
    return most / crest;
}

/* The film of [t0, t1), by a machine that does nothing else. */
static void taken_at_once(uint64_t t0, uint64_t t1, const struct vm_frame *sum)
{
    struct bench *b = set_up("roms/spin.df", "VR17", "P39", VM_VIEW_VECTOR);
    struct vm_frame film;
    struct crt_error err;
    assert_true(vm_frame_init(&film, &b->rig, &err));
    vm_machine_run(b->rig.machine, t0);
    vm_frame_open(&film, &b->rig, t0, t1);
    vm_machine_run(b->rig.machine, t1);
    assert_true(vm_frame_complete(&film));
    assert_true(apart(sum, &film) < 2e-4); /* crt/tube.h: good to 1e-3 */
    vm_frame_free(&film);
    tear_down(b);
}

#define STEPS 700

struct sliding {
    struct bench *b;
    float *kept[STEPS]; /* the light of each step, and when it began */
    uint64_t begin[STEPS];
    int steps;
    struct vm_sliding *sliding;
    struct vm_frame step, sum;
};

static struct sliding begin(void)
{
    struct sliding s = {.b = set_up("roms/spin.df", "VR17", "P39", VM_VIEW_VECTOR)};
    struct crt_error err;
    assert_true(vm_frame_init(&s.step, &s.b->rig, &err));
    assert_true(vm_frame_init(&s.sum, &s.b->rig, &err));
    assert_non_null(s.sliding = vm_sliding_create(&s.b->rig, &err));
    return s;
}

static void go_on(struct sliding *s, uint64_t step, uint64_t shutter)
{
    struct vm_machine *m = s->b->rig.machine;
    struct crt_error err;
    vm_frame_open(&s->step, &s->b->rig, m->now, m->now + step);
    vm_machine_run(m, m->now + step);
    assert_true(vm_frame_complete(&s->step));
    size_t cells;
    const float *light = light_of(&s->step, &cells);
    assert_non_null(s->kept[s->steps] = malloc(cells * sizeof *light));
    memcpy(s->kept[s->steps], light, cells * sizeof *light);
    s->begin[s->steps++] = s->step.t0;
    assert_true(vm_sliding_add(s->sliding, &s->step, shutter, &s->sum, &err));
    assert_int_equal(s->sum.t1, m->now);
    assert_true(vm_frame_complete(&s->sum));
}

/* The sum is that of the steps it says; no step's end is rounded more than a float is. */
static void is_the_sum(const struct sliding *s)
{
    size_t cells;
    const float *sum = light_of(&s->sum, &cells);
    for (size_t i = 0; i < cells; i++) {
        double light = 0;
        for (int k = s->steps - 1; k >= 0 && s->begin[k] >= s->sum.t0; k--)
            light += (double)s->kept[k][i];
        assert_true(fabs(light - (double)sum[i]) <= 4e-7 * light);
    }
}

static void end(struct sliding *s)
{
    is_the_sum(s);
    for (int k = 0; k < s->steps; k++)
        free(s->kept[k]);
    vm_sliding_destroy(s->sliding);
    vm_frame_free(&s->step);
    vm_frame_free(&s->sum);
    tear_down(s->b);
}

/* Whole frames: exactly so many. */
static void whole_frames_are_the_shutters_time(void **state)
{
    (void)state;
    struct sliding s = begin();
    for (int i = 1; i <= 40; i++) {
        go_on(&s, 7 * MS, 35 * MS);
        assert_int_equal(s.sum.t0, i < 5 ? 0 : (uint64_t)(i - 5) * 7 * MS);
    }
    taken_at_once(s.sum.t0, s.sum.t1, &s.sum);
    end(&s);
}

/* Uneven ones: as near to it as whole frames come; what has gone leaves nothing behind. */
static void uneven_frames_come_near(void **state)
{
    (void)state;
    const uint64_t shutter = 50 * MS;
    uint64_t random = 7;
    struct sliding s = begin();
    for (int i = 0; i < 120; i++) {
        go_on(&s, MS / 2 + next_random(&random) % (9 * MS), shutter);
        uint64_t length = s.sum.t1 - s.sum.t0;
        if (s.b->rig.machine->now > 2 * shutter)
            assert_true(length + 5 * MS > shutter && length < shutter + 5 * MS);
    }
    taken_at_once(s.sum.t0, s.sum.t1, &s.sum);
    end(&s);
}

/* Very many within the shutter's time: they are put together, and the sum is still a film. */
static void many_frames_are_put_together(void **state)
{
    (void)state;
    const uint64_t shutter = 60 * MS;
    struct sliding s = begin();
    for (int i = 0; i < STEPS; i++) {
        go_on(&s, MS / 5, shutter);
        uint64_t length = s.sum.t1 - s.sum.t0;
        if (s.b->rig.machine->now > 2 * shutter)
            assert_true(length > shutter - shutter / 30 && length < shutter + shutter / 30);
    }
    taken_at_once(s.sum.t0, s.sum.t1, &s.sum);
    end(&s);
}

/* Another time begins anew: after a step back, say. */
static void another_time_begins_anew(void **state)
{
    (void)state;
    struct sliding s = begin();
    for (int i = 0; i < 5; i++)
        go_on(&s, 10 * MS, 100 * MS);
    vm_machine_run(s.b->rig.machine, 90 * MS);
    go_on(&s, 10 * MS, 100 * MS);
    assert_int_equal(s.sum.t0, 90 * MS);
    go_on(&s, 10 * MS, 100 * MS);
    assert_int_equal(s.sum.t0, 90 * MS);
    taken_at_once(s.sum.t0, s.sum.t1, &s.sum);
    end(&s);
}

/* ---- nothing flashes ----------------------------------------------------------------------------- */

/* Crest and trough of what is shown of a light that is on for a third of each period, as parts of its mean. */
static void watch(double hz, double *crest, double *trough, double *mean, double *given)
{
    struct bench *b = set_up("roms/spin.df", "VR17", "P31", VM_VIEW_VECTOR);
    struct vm_frame frame;
    struct crt_error err;
    size_t cells, n = 0;
    assert_true(vm_frame_init(&frame, &b->rig, &err));
    struct vm_calm *calm = vm_calm_create(&b->rig, &err);
    assert_non_null(calm);
    vm_frame_clear(&frame);
    frame.t1 = frame.film[VM_VECTOR].t1 = CRT_PS_PER_S / 60;
    float *light = frame.film[VM_VECTOR].light[0];
    *crest = *mean = *given = 0;
    *trough = INFINITY;
    for (int i = 0; i < 60 * 8; i++) {
        double phase = i * hz / 60 + 0.013;                       /* never on an edge */
        light[5] = phase - floor(phase) < 1.0 / 3 ? 0.05F : 0.0F; /* 3 cd/m2 */
        light[6] = 2.0F / 60;
        const struct vm_frame *shown = vm_calm_show(calm, &frame, 1.0 / 60);
        const float *seen = light_of(shown, &cells);
        if (i < 60 * 5)
            continue;
        *crest = fmax(*crest, 60 * (double)seen[5]);
        *trough = fmin(*trough, 60 * (double)seen[5]);
        *mean += 60 * (double)seen[5];
        *given += (double)light[5] * 60;
        n++;
        assert_true(fabs(60 * (double)seen[6] - 2) < 1e-3);
    }
    *mean /= (double)n;
    *given /= (double)n;
    vm_calm_destroy(calm);
    vm_frame_free(&frame);
    tear_down(b);
}

static void flashes_are_taken_out(void **state)
{
    (void)state;
    const double rates[] = {3, 5, 10, 15, 20};
    for (size_t i = 0; i < COUNT(rates); i++) {
        double crest, trough, mean, given;
        watch(rates[i], &crest, &trough, &mean, &given);
        assert_true(fabs(mean - given) < 0.01 * given);
        assert_true(crest - trough < 0.1 * mean);
        /* Two filters of the first order: the fundamental is left with 1/(1 + (2 pi f tau)^2). Nearly, as
         * harmonics and the 60 steps a second count, too. */
        double w = 2 * 3.141592653589793 * rates[i] * VM_CALM_S;
        double wave = 3 * 2 / 3.141592653589793 * sin(3.141592653589793 / 3) / (1 + w * w);
        if (rates[i] <= 10)
            assert_true(fabs((crest - trough) / 2 - wave) < 0.25 * wave);
    }
}

/* ---- which pictures flash ------------------------------------------------------------------------ */

static double flash(const char *phosphor, double refresh, double scale, double shutter)
{
    return vm_show_flash_hz(crt_phosphor_find(phosphor), refresh, scale, shutter, 60);
}

static void pictures_that_flash(void **state)
{
    (void)state;
    assert_true(flash("P31", 60, 1, 0) <= 0);              /* a picture each */
    assert_true(fabs(flash("P31", 50, 1, 0) - 10) < 1e-9); /* beats with the host */
    assert_true(fabs(flash("P31", 20, 1, 0) - 20) < 1e-9);
    assert_true(fabs(flash("P31", 60, 0.1, 0) - 6) < 1e-9); /* slowed */
    assert_true(flash("P31", 60, 0.01, 0) <= 0);            /* 0.6 Hz */
    assert_true(flash("P31", 0, 1, 0) <= 0);                /* not known */
    assert_true(flash("P31", 50, 1, 0.2) <= 0);             /* ten refreshes to each picture */
    assert_true(flash("P39", 50, 1, 0) <= 0);               /* hardly modulated */
    assert_true(flash("P31", 61, 1, 0) <= 0);               /* beats once a second */
}

/* The gain that a picture of so many seconds is shown by, after the one before. */
static int gain_of(struct vm_show *show, double exposure_s)
{
    for (int h = 0; h < VM_HEADS; h++) {
        struct crt_film *film = &show->program->frame.film[h];
        film->t0 = CRT_PS_PER_S;
        film->t1 = film->t0 + (uint64_t)(exposure_s * (double)CRT_PS_PER_S);
        film->complete = true;
    }
    vm_show_follow_gain(show);
    return vm_show_gain(show, VM_VECTOR);
}

/* By closed form: of a flash's light the part that comes within the exposure, per second; two stops more. */
static double gain_wanted(const struct crt_phosphor *p, double exposure_s)
{
    double sum = 0;
    for (int i = 0; i < p->terms; i++)
        sum -= p->term[i].w * expm1(-exposure_s / p->term[i].tau_s);
    return fmin(2 - log2(sum / exposure_s / 60), 0);
}

/* It follows the exposure, but pictures of times that differ by a little are all shown by one gain. */
static void automatic_gain_is_steady(void **state)
{
    (void)state;
    struct vm_show *show = calloc(1, sizeof *show);
    struct vm_shown *shown = calloc(1, sizeof *shown);
    assert_true(show && shown);
    show->side[0] = show->program = shown;
    show->sides = 1;
    show->film_ready = show->gain_auto = true;
    shown->rate_hz = 60;
    for (int h = 0; h < VM_HEADS; h++)
        shown->settings.monitor[h].phosphor = *crt_phosphor_find("P31");
    for (double exposure = 8e-3; exposure > 1e-6; exposure *= 0.93) {
        double wanted = gain_wanted(&shown->settings.monitor[0].phosphor, exposure);
        gain_of(show, 5e-3);
        int gain = gain_of(show, exposure);
        assert_true(fabs(gain - wanted) <= 0.76);
        int changes = 0;
        for (int i = 0; i < 60; i++) {
            int next = gain_of(show, exposure * (1 + 0.08 * sin(i)));
            changes += next != gain;
            gain = next;
        }
        assert_true(changes <= 1);
    }
    free(shown);
    free(show);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_frames_are_the_shutters_time),
        cmocka_unit_test(uneven_frames_come_near),
        cmocka_unit_test(many_frames_are_put_together),
        cmocka_unit_test(another_time_begins_anew),
        cmocka_unit_test(flashes_are_taken_out),
        cmocka_unit_test(pictures_that_flash),
        cmocka_unit_test(automatic_gain_is_steady),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
