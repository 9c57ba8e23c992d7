/* A display processor saved between any two words and loaded into another goes on alike. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "tests/support/dpu_invariants.h"

#define US UINT64_C(1000000) /* ps */

static uint16_t memory[32768];

/* A processor, what it drew, and what decides how it is poked. */
struct bench {
    struct df_dpu dpu;
    struct dpu_watch watch;
    uint64_t seed;
    uint64_t drawn; /* hash of strokes, line changes and registers */
};

static void mix(uint64_t *h, uint64_t v)
{
    *h = (*h ^ v) * UINT64_C(0x100000001b3);
    *h ^= *h >> 29;
}

static uint64_t offer(void *ctx, const struct crt_stroke *s)
{
    return dpu_watch_offer(&((struct bench *)ctx)->watch, s);
}

static void commit(void *ctx, const struct crt_stroke *s)
{
    struct bench *b = ctx;
    uint32_t bits[5];
    dpu_watch_commit(&b->watch, s);
    memcpy(bits, &s->x0, 5 * sizeof bits[0]); /* x0, y0, x1, y1, drive */
    mix(&b->drawn, s->t0);
    mix(&b->drawn, s->t1);
    for (int i = 0; i < 5; i++)
        mix(&b->drawn, bits[i]);
    mix(&b->drawn, s->source);
}

static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    struct bench *b = ctx;
    dpu_watch_interrupt(&b->watch, line, level, t);
    mix(&b->drawn, t * 8 + (unsigned)line * 2 + level);
}

static void connect(struct bench *b, uint64_t average_ps, uint32_t memory_bytes)
{
    struct df_dpu_desc desc = {
        .memory = memory,
        .memory_bytes = memory_bytes,
        .screen = {235, 235, 1024, 1024},
        .timing = DPU_WATCH_TIMING,
        .drive = {0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 1.00},
        .beam = {b, offer, commit},
        .wires = {b, interrupt, NULL},
    };
    desc.timing.average_ps = average_ps;
    memset(b, 0, sizeof *b);
    b->watch.dpu = &b->dpu;
    df_dpu_init(&b->dpu, &desc);
}

/* Mostly data, so that there is something to draw; vectors with the pen on; some jumps. */
static void fill(uint64_t seed)
{
    for (size_t i = 0; i < sizeof memory / sizeof memory[0]; i++) {
        uint16_t word = (uint16_t)(dpu_random(&seed) >> 32);
        unsigned op = word >> DF_MODE_SHIFT & 15;
        bool spare = word & DF_CONTROL && (op == 7 || op == 9 || op == 10 || op == 11);
        if ((spare && dpu_random(&seed) % 64) || (word & DF_CONTROL && dpu_random(&seed) % 2))
            word &= 0x7fff;
        if (word & DF_CONTROL && op <= DF_MODE_RELPOINT && dpu_random(&seed) % 2)
            word |= DF_SGM_PEN | DF_SGM_PEN_ON;
        memory[i] = word;
    }
}

/* One word, or what gets a processor that stands still going. */
static void go(struct bench *b)
{
    struct df_dpu *dpu = &b->dpu;
    uint64_t n = dpu_random(&b->seed), t = dpu->t + n % (50 * US);
    if (dpu->state == DF_RUNNING && n % 128)
        dpu_watch_step(&b->watch);
    else if (dpu->state == DF_WAITING_SYNC && n % 4)
        df_dpu_sync(dpu, t);
    else
        df_dpu_write(dpu, DF_DPC, n % 3 ? 1 : (uint16_t)(n >> 16 & ~UINT64_C(1)), t);
    dpu_watch_state(&b->watch);
    for (unsigned offset = DF_DPC; offset <= DF_YPR; offset += 2)
        mix(&b->drawn, df_dpu_read(dpu, offset));
}

static struct crt_state save(struct bench *b)
{
    struct crt_state s;
    crt_state_save(&s);
    df_dpu_state(&b->dpu, &s);
    if (s.failed)
        fail_msg("%s", s.err.text);
    return s;
}

/* The observer knows what it would know had it been there from the start. */
static bool load(struct bench *b, const uint8_t *bytes, size_t size)
{
    struct crt_state s;
    crt_state_load(&s, bytes, size);
    df_dpu_state(&b->dpu, &s);
    b->watch.strokes = b->dpu.usage.strokes;
    b->watch.last_t1 = b->watch.line_t = 0;
    memcpy(b->watch.lines, b->dpu.pending, sizeof b->watch.lines);
    return !s.failed;
}

static void same_bytes(struct bench *a, struct bench *b)
{
    struct crt_state one = save(a), two = save(b);
    assert_int_equal(one.size, two.size);
    assert_memory_equal(one.out, two.out, one.size);
    crt_state_free(&one);
    crt_state_free(&two);
}

/* What would not show at once in what is drawn. */
static void same_fields(const struct df_dpu *a, const struct df_dpu *b)
{
    assert_true(a->t == b->t && a->raised_at == b->raised_at && a->state == b->state);
    assert_true(a->words == b->words && a->instructions == b->instructions);
    assert_memory_equal(&a->usage, &b->usage, sizeof a->usage);
    assert_true(a->illegal == b->illegal && a->timeout == b->timeout);
    for (unsigned offset = DF_DPC; offset <= DF_YPR; offset += 2)
        assert_int_equal(df_dpu_read(a, offset), df_dpu_read(b, offset));
}

/* How often the instants of saving were of a kind. */
struct kinds {
    unsigned state[4], phase[3], vector, second, illegal, timeout, hit, line[DF_INT_COUNT];
};

static void count(struct kinds *k, const struct df_dpu *dpu)
{
    k->state[dpu->state]++;
    k->phase[dpu->phase]++;
    k->vector += dpu->vector.active;
    k->second += dpu->second.active;
    k->illegal += dpu->illegal;
    k->timeout += dpu->timeout;
    k->hit += dpu->hit;
    for (int line = 0; line < DF_INT_COUNT; line++)
        k->line[line] += dpu->pending[line];
}

static void all_kinds(const struct kinds *k)
{
    for (int i = 0; i < 4; i++)
        assert_true(k->state[i] > 10);
    for (int i = 0; i < 3; i++)
        assert_true(k->phase[i] > 10 && k->line[i] > 10);
    assert_true(k->vector > 10 && k->second > 10 && k->illegal > 10 && k->timeout > 10);
    assert_true(k->hit > 10);
}

/* Saves after every few words and goes on for some with both. */
static void run(uint64_t average_ps, uint64_t seed, struct kinds *kinds)
{
    static struct bench one, two;
    fill(seed);
    connect(&one, average_ps, sizeof memory / 2);
    one.seed = seed;
    one.watch.pen = seed | 1;
    for (int n = 0; n < 6000; n++) {
        for (uint64_t i = dpu_random(&seed) % 7; i > 0; i--)
            go(&one);
        count(kinds, &one.dpu);
        struct crt_state saved = save(&one);
        connect(&two, average_ps, sizeof memory / 2);
        assert_true(load(&two, saved.out, saved.size));
        same_fields(&one.dpu, &two.dpu);
        same_bytes(&one, &two);
        two.seed = one.seed;
        two.watch.pen = one.watch.pen;
        one.drawn = two.drawn = 0;
        for (int i = 0; i < 8; i++) {
            go(&one);
            go(&two);
        }
        assert_int_equal(one.drawn, two.drawn);
        same_bytes(&one, &two);
        crt_state_free(&saved);
    }
}

static void it_goes_on_from_any_word(void **state)
{
    (void)state;
    struct kinds kinds = {.vector = 0};
    run(0, UINT64_C(0x0123456789abcdef), &kinds);
    run(33330000, UINT64_C(42), &kinds);
    all_kinds(&kinds);
}

/* Bits flipped and bytes replaced: refused, or nothing that must hold of the processor breaks. */
static void damage_is_refused_or_harmless(void **state)
{
    (void)state;
    static struct bench one, two;
    uint64_t seed = 7;
    unsigned taken = 0, refused = 0;
    fill(seed);
    connect(&one, 0, sizeof memory / 2);
    one.seed = 9;
    one.watch.pen = 11;
    for (int n = 0; n < 300; n++) {
        do
            go(&one);
        while (n % 2 && !one.dpu.vector.active); /* every other with a vector to be resumed */
        struct crt_state saved = save(&one);
        for (size_t i = 0; i < saved.size; i++) {
            uint8_t was = saved.out[i];
            uint64_t r = dpu_random(&seed);
            saved.out[i] = (uint8_t)(r % 4 ? was ^ 1u << r % 8 : r >> 8);
            connect(&two, 0, sizeof memory / 2);
            two.seed = one.seed;
            two.watch.pen = one.watch.pen;
            bool ok = load(&two, saved.out, saved.size);
            taken += ok;
            refused += !ok;
            for (int k = 0; ok && k < 10; k++)
                go(&two);
            saved.out[i] = was;
        }
        for (size_t size = 0; size < saved.size; size += 1 + size / 8)
            assert_false(load(&two, saved.out, size));
        crt_state_free(&saved);
    }
    print_message("# %u damaged bytes taken, %u refused\n", taken, refused);
    assert_true(taken > 1000 && refused > 1000);
}

/* What the generators would divide by or index with. */
static void impossible_vectors_are_refused(void **state)
{
    (void)state;
    static struct bench b;
    struct crt_state s;
    const struct df_pending_vector good = {
        .active = true, .x1 = 100, .y1 = 50, .units = 100, .span = 1000, .rest = 10, .done = 500};
    struct df_pending_vector wrong[] = {good, good, good, good, good, good};
    wrong[0].x1 = 0, wrong[0].y1 = 0, wrong[0].units = 0;
    wrong[1].rest = 500;
    wrong[2].rest = UINT64_MAX / 2 + 1;
    wrong[3].done = 1001;
    wrong[4].y1 = 1024;
    wrong[5].span = UINT64_C(1) << 51;
    connect(&b, 0, sizeof memory);
    b.dpu.state = DF_WAITING_RESUME;
    b.dpu.t = US;
    b.dpu.vector = good;
    s = save(&b);
    assert_true(load(&b, s.out, s.size));
    assert_memory_equal(&b.dpu.vector, &good, sizeof good);
    crt_state_free(&s);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        b.dpu.vector = wrong[i];
        crt_state_save(&s);
        df_dpu_state(&b.dpu, &s);
        assert_true(s.failed);
        assert_string_equal(s.err.text, "the snapshot's interrupted vector is impossible");
        crt_state_free(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_goes_on_from_any_word),
        cmocka_unit_test(damage_is_refused_or_harmless),
        cmocka_unit_test(impossible_vectors_are_refused),
    };
    return cmocka_run_group_tests_name("dpu_state", tests, NULL, NULL);
}
