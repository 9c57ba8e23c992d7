/* The tube when memory is short: every allocation made to fail in its turn; nothing crashes or
 * leaks, and the user is told. And misuse, which asserts. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "crt/develop.h"
#include "crt/tube.h"
#include "tests/support/tube_model.h"

#define COLS 64
#define ROWS 48
#define CELL 0.25

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define SANITIZED
#endif

/* ---- an allocator that fails when told to ------------------------------------------------------ */

static long countdown = -1; /* allocations until one fails; below 0: none does */
static bool failed;
static long live; /* allocations not freed */

#ifndef SANITIZED
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *at, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *at);

static bool fails(void)
{
    if (countdown < 0 || countdown-- > 0)
        return false;
    failed = true;
    return true;
}

static void *counted(void *at)
{
    live += at != NULL;
    return at;
}

void *malloc(size_t size)
{
    return fails() ? NULL : counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size)
{
    return fails() ? NULL : counted(__libc_calloc(count, size));
}

void *realloc(void *at, size_t size)
{
    if (fails())
        return NULL;
    return at ? __libc_realloc(at, size) : counted(__libc_malloc(size));
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : counted(__libc_memalign(alignment, size));
}

void free(void *at)
{
    live -= at != NULL;
    __libc_free(at);
}
#endif

/* ---- memory -------------------------------------------------------------------------------------- */

static const double shares[] = {0.3, 0.3, 0.4}, taus[] = {0.12, 2.16, 60};

static struct crt_tube_row row;
static struct crt_phosphor phosphor;

static struct crt_tube_desc desc_of(int threads)
{
    row = model_row(CELL, 0);
    phosphor = model_phosphor(3, shares, taus);
    phosphor.colour[0] = (struct crt_chromaticity){0.226, 0.528};
    return (struct crt_tube_desc){
        .row = &row,
        .phosphor = &phosphor,
        .grid = {COLS, ROWS, CELL, -COLS * CELL / 2, ROWS * CELL / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = threads,
    };
}

/* Three refreshes; the film of the last is left in `film`. False when the tube or the film was not
 * to be had; *intact as the tube says. */
static bool three_refreshes(const struct crt_tube_desc *desc, struct crt_film *film, bool *intact,
                            struct crt_error *err)
{
    struct crt_tube *tube = crt_tube_create(desc, err);
    if (!tube)
        return false;
    if (!crt_film_init(film, tube, err)) {
        crt_tube_destroy(tube);
        return false;
    }
    crt_film_open(tube, film, crt_tick_time(desc->epoch, 2), crt_tick_time(desc->epoch, 3));
    for (uint64_t n = 0; n < 3; n++) {
        uint32_t seed = 5;
        uint64_t t = crt_tick_time(desc->epoch, n) + 15 * CRT_PS_PER_MS;
        for (int i = 0; i < 600; i++, t += 2000000) { /* more than the journal first has room for */
            struct crt_stroke s = {.t0 = t, .t1 = t + 1000000, .drive = 1};
            s.x0 = (float)model_uniform(&seed, -7, 7);
            s.y0 = (float)model_uniform(&seed, -5, 5);
            s.x1 = s.x0 + 1;
            s.y1 = s.y0 - 1;
            crt_tube_stroke(tube, &s);
        }
        crt_tube_advance(tube, crt_tick_time(desc->epoch, n + 1));
    }
    *intact = crt_tube_intact(tube, err);
    crt_tube_destroy(tube);
    return true;
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 2; threads++) {
        struct crt_tube_desc desc = desc_of(threads);
        struct crt_film whole, film = {0};
        struct crt_error err;
        bool intact;
        assert_true(three_refreshes(&desc, &whole, &intact, &err) && intact);
        size_t bytes = (size_t)COLS * ROWS * sizeof(float);
        int refused = 0, lossy = 0, unharmed = 0;
        for (int n = 0; n < 200; n++) {
            long before = live;
            memset(&film, 0, sizeof film);
            err.text[0] = 0;
            failed = false;
            countdown = n;
            bool made = three_refreshes(&desc, &film, &intact, &err);
            countdown = -1;
            if (!failed)
                break; /* there are no more allocations */
            if (!made) {
                assert_non_null(strstr(err.text, "memory"));
                refused++;
            } else if (!intact) {
                assert_non_null(strstr(err.text, "memory"));
                lossy++;
            } else {
                assert_memory_equal(film.light[0], whole.light[0], bytes);
                unharmed++;
            }
            crt_film_free(&film);
            assert_int_equal(live, before);
        }
        print_message("# %d threads: %d times refused, %d times light lost and told, %d times "
                      "unharmed\n",
                      threads, refused, lossy, unharmed);
#ifndef SANITIZED
        assert_true(refused > 8 && lossy > 0 && unharmed > 0);
#endif
        crt_film_free(&film);
        crt_film_free(&whole);
    }
}

static void developing_without_memory(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(1);
    struct crt_film film;
    struct crt_image image;
    struct crt_error err = {""};
    bool intact;
    assert_true(three_refreshes(&desc, &film, &intact, &err));
    failed = false;
    countdown = 0;
    bool done = crt_develop(&film, &phosphor, 0.01, 8, 1, &image, &err);
    countdown = -1;
    assert_true(done != failed);
    if (done)
        crt_image_free(&image);
    else
        assert_non_null(strstr(err.text, "memory"));
    crt_film_free(&film);
}

/* ---- grids --------------------------------------------------------------------------------------- */

static void smallest_and_greatest_grids(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(1);
    struct crt_error err;
    const struct {
        int cols, rows;
        bool possible;
    } sizes[] = {{8, 1, true},           {8, 3, true},          {64, 1, true},
                 {2048, 2, true},        {8, 2048, true},       {72, 17, true},
                 {0, 10, false},         {-8, 10, false},       {12, 10, false},
                 {8, 0, false},          {65536, 65536, false}, {65536, 300, false},
                 {2147483640, 1, false}, {8, 2147483647, false}};
    for (unsigned i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        int cols = sizes[i].cols, rows = sizes[i].rows;
        desc.grid = (struct crt_grid){cols, rows, CELL, -cols * CELL / 2, rows * CELL / 2};
        for (desc.threads = 1; desc.threads <= 3; desc.threads += 2) {
            struct crt_film film;
            struct crt_tube *tube = crt_tube_create(&desc, &err);
            assert_true((tube != NULL) == sizes[i].possible);
            if (!tube)
                continue;
            assert_true(crt_film_init(&film, tube, &err));
            crt_film_open(tube, &film, 0, CRT_PS_PER_S);
            struct crt_stroke s = {
                .t1 = CRT_PS_PER_MS, .x0 = -400, .x1 = 400, .y0 = 0.1F, .drive = 1};
            crt_tube_stroke(tube, &s);
            s = (struct crt_stroke){.t0 = 2 * CRT_PS_PER_MS,
                                    .t1 = 3 * CRT_PS_PER_MS,
                                    .y0 = -400,
                                    .y1 = 400,
                                    .drive = 1};
            crt_tube_stroke(tube, &s);
            crt_tube_advance(tube, CRT_PS_PER_S);
            double sum = 0;
            for (size_t k = 0; k < (size_t)cols * (size_t)rows; k++)
                sum += (double)film.light[0][k];
            assert_true(sum > 0);
            crt_film_free(&film);
            crt_tube_destroy(tube);
        }
    }
}

static void cells_that_do_not_suit_the_spot(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(1);
    struct crt_error err;
    const struct {
        double cell;
        bool possible;
    } cells[] = {{CELL, true},        {1.25 * CELL, true},  {CELL / 40000, true},
                 {1.3 * CELL, false}, {1e9, false},         {0, false},
                 {-1, false},         {CELL / 2e5, false},  {1e-12, false},
                 {1e-300, false},     {(double)NAN, false}, {(double)INFINITY, false}};
    for (unsigned i = 0; i < sizeof cells / sizeof cells[0]; i++) {
        desc.grid.cell_mm = cells[i].cell;
        err.text[0] = 0;
        struct crt_tube *tube = crt_tube_create(&desc, &err);
        assert_true((tube != NULL) == cells[i].possible);
        if (!tube)
            assert_non_null(strstr(err.text, "film cells of"));
        crt_tube_destroy(tube);
    }
}

/* The knobs turned to where no knob goes. */
static void absurd_knobs(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(1);
    struct crt_error err;
    struct crt_film film;
    desc.grid.cell_mm = CELL / 40000;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    assert_true(tube && crt_film_init(&film, tube, &err));
    const struct crt_knobs knobs[] = {{0, 1, 4},           {0, 1, 1e300},
                                      {0, 1, (double)NAN}, {(double)NAN, 1, 0},
                                      {0, (double)NAN, 0}, {1e300, -1e300, -1e9}};
    crt_film_open(tube, &film, 0, CRT_PS_PER_S);
    for (unsigned i = 0; i < sizeof knobs / sizeof knobs[0]; i++) {
        struct crt_stroke s = {.t0 = i * CRT_PS_PER_MS, .x1 = 300, .y1 = -200, .drive = 1};
        s.t1 = s.t0 + CRT_PS_PER_MS;
        crt_tube_set_knobs(tube, knobs[i]);
        crt_tube_stroke(tube, &s);
    }
    crt_tube_advance(tube, CRT_PS_PER_S);
    for (size_t i = 0; i < COLS * ROWS; i++)
        assert_true(film.light[0][i] >= 0 && film.light[0][i] < 1e9F);
    crt_film_free(&film);
    crt_tube_destroy(tube);
}

/* ---- misuse -------------------------------------------------------------------------------------- */

static void film_backwards(struct crt_tube *tube, struct crt_film *film)
{
    crt_film_open(tube, film, 2, 1);
}

static void film_of_no_time(struct crt_tube *tube, struct crt_film *film)
{
    crt_film_open(tube, film, 5, 5);
}

static void film_too_late(struct crt_tube *tube, struct crt_film *film)
{
    crt_tube_advance(tube, 1000);
    crt_film_open(tube, film, 999, 2000);
}

static void film_of_another_tube(struct crt_tube *tube, struct crt_film *film)
{
    film->grid.rows++;
    crt_film_open(tube, film, 1, 2);
}

static void film_without_memory(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    struct crt_film none = {0};
    crt_film_open(tube, &none, 1, 2);
}

static void time_backwards(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    crt_tube_advance(tube, 1000);
    crt_tube_advance(tube, 999);
}

static void stroke_backwards(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    struct crt_stroke a = {.t0 = 1000, .t1 = 2000, .drive = 1}, b = {.t0 = 999, .t1 = 2000};
    crt_tube_stroke(tube, &a);
    crt_tube_stroke(tube, &b);
}

static void stroke_too_late(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    crt_tube_advance(tube, 1001);
    struct crt_stroke s = {.t0 = 1000, .t1 = 2000, .drive = 1};
    crt_tube_stroke(tube, &s);
}

static void stroke_in_an_ended_epoch(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    crt_tube_advance(tube, CRT_PS_PER_S);
    struct crt_stroke s = {.t0 = 1000, .t1 = 2000, .drive = 1};
    crt_tube_stroke(tube, &s);
}

static void probe_of_an_ended_epoch(struct crt_tube *tube, struct crt_film *film)
{
    (void)film;
    double cd_m2[CRT_MAX_COLOURS];
    crt_tube_advance(tube, CRT_PS_PER_S);
    crt_tube_probe(tube, 0, 0, 1000, cd_m2);
}

static void misuse_asserts(void **state)
{
    (void)state;
    void (*const misuse[])(struct crt_tube *, struct crt_film *) = {
        film_backwards,           film_of_no_time,        film_too_late,    film_of_another_tube,
        film_without_memory,      time_backwards,         stroke_backwards, stroke_too_late,
        stroke_in_an_ended_epoch, probe_of_an_ended_epoch};
    for (unsigned i = 0; i < sizeof misuse / sizeof misuse[0]; i++) {
        pid_t child = fork();
        if (child == 0) {
            struct crt_tube_desc desc = desc_of(1);
            struct crt_error err;
            struct crt_film film;
            signal(SIGABRT, SIG_DFL);
            if (!freopen("/dev/null", "w", stderr))
                _exit(1);
            struct crt_tube *tube = crt_tube_create(&desc, &err);
            if (tube && crt_film_init(&film, tube, &err))
                misuse[i](tube, &film);
            _exit(0);
        }
        int status = 0;
        assert_true(child > 0 && waitpid(child, &status, 0) == child);
        if (!WIFSIGNALED(status) || WTERMSIG(status) != SIGABRT)
            fail_msg("misuse %u did not assert (status %x)", i, (unsigned)status);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(developing_without_memory),
        cmocka_unit_test(smallest_and_greatest_grids),
        cmocka_unit_test(cells_that_do_not_suit_the_spot),
        cmocka_unit_test(absurd_knobs),
        cmocka_unit_test(misuse_asserts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
