/* A million random words never break what must hold of strokes, time and state. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "display_file/df_regs.h"
#include "tests/support/dpu_invariants.h"

#define US UINT64_C(1000000) /* ps */

static uint16_t memory[32768];
static struct df_dpu dpu;
static struct dpu_watch watch;

static struct df_dpu_desc description(void)
{
    return (struct df_dpu_desc){
        .memory = memory,
        .memory_bytes = sizeof memory,
        .screen = {235, 235, 1024, 1024},
        .timing = DPU_WATCH_TIMING,
        .drive = {0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 1.00},
        .beam = {&watch, dpu_watch_offer, dpu_watch_commit},
        .wires = {&watch, dpu_watch_interrupt, dpu_watch_bell},
    };
}

/* Memory full of random words; spare codes are rare, or the processor would hang most of the time.
 */
static void fill(uint64_t *seed)
{
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++) {
        uint16_t word = (uint16_t)(dpu_random(seed) >> 32);
        unsigned op = word >> 11 & 15;
        bool spare = word & DF_CONTROL && (op == 7 || op == 9 || op == 10 || op == 11);
        /* Three quarters data, so that there is something to draw. */
        if (spare || (word & DF_CONTROL && dpu_random(seed) % 2))
            word &= 0x7fff;
        memory[i] = word;
    }
}

/* Restarts whatever stopped, now and then in the other way. */
static void poke(uint64_t *seed)
{
    uint64_t n = dpu_random(seed);
    uint64_t t = dpu.t + n % (50 * US);

    if (dpu.state == DF_WAITING_SYNC && n % 4)
        df_dpu_sync(&dpu, t);
    else
        df_dpu_write(&dpu, DF_DPC, n % 3 ? 1 : (uint16_t)(n >> 16 & ~UINT64_C(1)), t);
    dpu_watch_state(&watch);
}

static void run(struct df_dpu_desc desc, uint64_t seed, uint64_t words)
{
    fill(&seed);
    watch = (struct dpu_watch){.dpu = &dpu, .pen = seed | 1};
    df_dpu_init(&dpu, &desc);
    for (uint64_t n = 0; n < words; n++) {
        if (dpu.state != DF_RUNNING || dpu_random(&seed) % 256 == 0)
            poke(&seed);
        else
            dpu_watch_step(&watch);
    }
    assert_true(watch.strokes > words / 10);
    assert_true(dpu.usage.vectors > words / 100);
    assert_true(dpu.usage.characters > words / 100);
}

static void a_million_random_words(void **state)
{
    (void)state;
    run(description(), UINT64_C(0x0123456789abcdef), 1000000);
}

static void random_words_in_average_mode(void **state)
{
    (void)state;
    struct df_dpu_desc desc = description();
    desc.timing.average_ps = 33330000;
    run(desc, UINT64_C(42), 200000);
    desc.timing.average_ps = 1000000007;
    run(desc, UINT64_C(43), 200000);
}

static void random_words_in_colour(void **state)
{
    (void)state;
    struct df_dpu_desc desc = description();
    desc.personality = DF_VS60;
    run(desc, UINT64_C(46), 300000);
    desc.timing.average_ps = 33330000;
    run(desc, UINT64_C(47), 100000);
}

static void random_words_on_a_low_screen_in_little_memory(void **state)
{
    (void)state;
    struct df_dpu_desc desc = description();
    desc.screen = (struct crt_screen){229, 171, 1024, 768};
    desc.memory_bytes = 16384;
    run(desc, UINT64_C(44), 200000);
}

/* The same words give the same strokes: nothing depends on what was there before. */
static void runs_repeat(void **state)
{
    (void)state;
    run(description(), UINT64_C(45), 50000);
    uint64_t t = dpu.t, strokes = watch.strokes, lit = dpu.usage.lit_ps;
    run(description(), UINT64_C(45), 50000);
    assert_int_equal(dpu.t, t);
    assert_int_equal(watch.strokes, strokes);
    assert_int_equal(dpu.usage.lit_ps, lit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_million_random_words),
        cmocka_unit_test(random_words_in_average_mode),
        cmocka_unit_test(random_words_in_colour),
        cmocka_unit_test(random_words_on_a_low_screen_in_little_memory),
        cmocka_unit_test(runs_repeat),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
