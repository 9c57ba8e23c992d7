/* A light pen saved at any moment and loaded into another goes on alike; hostile bytes are refused or do
 * no harm. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdlib.h>
#include <string.h>

#include "tests/input/pen_scene.h"

#define US UINT64_C(1000000)

/* A pen, and where its time and its story are. */
struct story {
    struct inp_pen pen;
    bool raster;
    uint64_t t, seed, count, told;
    uint8_t dots[3][64];
};

static uint64_t bits(struct story *s)
{
    return inp_noise_bits(s->seed, s->count++);
}

static double between(struct story *s, double low, double high)
{
    return low + (high - low) * inp_noise_even(s->seed, s->count++);
}

static void tell(struct story *s, uint64_t v)
{
    s->told = (s->told ^ v) * UINT64_C(0x100000001b3);
    s->told ^= s->told >> 29;
}

static struct inp_pen_setup setup;

static void begin(struct story *s, bool raster, uint64_t seed)
{
    const struct crt_tube_row *row = crt_tube_row_find(raster ? "COLOR17" : "LAB31");
    struct inp_pen_desc desc = {&setup, row, crt_phosphor_find(row->phosphor), {0, 1, 0}, seed};
    memset(s, 0, sizeof *s);
    s->seed = seed;
    s->raster = raster;
    inp_pen_init(&s->pen, &desc);
}

static void draw_stroke(struct story *s)
{
    struct crt_stroke stroke = {.t0 = s->t, .t1 = s->t + 1 + bits(s) % (3 * US)};
    uint64_t when = 0;
    stroke.x0 = (float)between(s, -6, 6);
    stroke.y0 = (float)between(s, -6, 6);
    stroke.x1 = bits(s) % 2 ? stroke.x0 : (float)between(s, -6, 6);
    stroke.y1 = bits(s) % 2 ? stroke.y0 : (float)between(s, -6, 6);
    stroke.drive = (float)between(s, 0, 1);
    tell(s, inp_pen_offer(&s->pen, &stroke));
    if (inp_pen_stroke(&s->pen, &stroke, &when))
        tell(s, when);
    s->t = stroke.t1;
}

static void draw_line(struct story *s)
{
    struct crt_scan_line line = {
        .t0 = s->t, .t1 = s->t + 3 * US, .x0 = -160, .x1 = 160, .dots = 64, .guns = 3};
    line.y0 = line.y1 = (float)between(s, -4, 4);
    for (int gun = 0; gun < 3; gun++) {
        for (int i = 0; i < 64; i++)
            s->dots[gun][i] = (uint8_t)(bits(s) & bits(s));
        line.drive[gun] = s->dots[gun];
    }
    inp_pen_line(&s->pen, &line);
    for (int i = 0; i < 50 && inp_pen_next(&s->pen) <= line.t1; i++) {
        uint64_t next = inp_pen_next(&s->pen);
        tell(s, next + inp_pen_event(&s->pen, next > s->t ? next : s->t));
    }
    s->t = line.t1;
}

static void go(struct story *s)
{
    switch (bits(s) % 16) {
    case 0:
        inp_hand_move(&s->pen.hand, (struct inp_place){between(s, -3, 3), between(s, -3, 3), 0},
                      s->t, bits(s) % (50 * US));
        break;
    case 1:
        inp_hand_away(&s->pen.hand);
        break;
    case 2:
        inp_pen_set_knobs(&s->pen, (struct crt_knobs){between(s, -0.2, 0.2), 1, between(s, 0, 1)});
        break;
    case 3:
        s->pen.tip = bits(s) % 2;
        break;
    case 4:
        s->t += bits(s) % (bits(s) % 4 ? 10 * US : 20000 * US);
        break;
    default:
        if (s->raster)
            draw_line(s);
        else
            draw_stroke(s);
    }
    tell(s, inp_pen_next(&s->pen));
    tell(s, inp_pen_looks(&s->pen));
}

static struct crt_state save(struct story *s)
{
    struct crt_state state;
    crt_state_save(&state);
    inp_pen_state(&s->pen, &state);
    if (state.failed)
        fail_msg("%s", state.err.text);
    return state;
}

static bool load(struct story *s, const uint8_t *bytes, size_t size)
{
    struct crt_state state;
    crt_state_load(&state, bytes, size);
    inp_pen_state(&s->pen, &state);
    return !state.failed;
}

static void same_future_after_a_snapshot(void **state)
{
    static struct story one, other;
    (void)state;
    setup = slow_setup();
    for (int i = 0; i < 60; i++) {
        setup.room.value = i % 3 ? 0 : 4000;
        begin(&one, i % 2, 100 + (uint64_t)i);
        for (uint64_t n = 0; n < 5 + 3 * (uint64_t)i; n++)
            go(&one);
        struct crt_state saved = save(&one);
        begin(&other, i % 2, 100 + (uint64_t)i);
        assert_true(load(&other, saved.out, saved.size));
        other.t = one.t;
        other.count = one.count;
        other.told = one.told;
        for (int n = 0; n < 60; n++) {
            go(&one);
            go(&other);
            assert_true(one.told == other.told);
        }
        struct crt_state a = save(&one), b = save(&other);
        assert_int_equal(a.size, b.size);
        assert_memory_equal(a.out, b.out, a.size);
        crt_state_free(&a);
        crt_state_free(&b);
        crt_state_free(&saved);
    }
}

/* Bytes changed at random: refused, or a pen that goes on within bounds. */
static void hostile_bytes_do_no_harm(void **state)
{
    static struct story s;
    int refused = 0, taken = 0;
    (void)state;
    setup = slow_setup();
    begin(&s, false, 5);
    for (int n = 0; n < 40; n++)
        go(&s);
    struct crt_state saved = save(&s);
    uint8_t *bytes = malloc(saved.size);
    assert_non_null(bytes);
    for (int i = 0; i < 3000; i++) {
        begin(&s, false, 6 + (uint64_t)i);
        memcpy(bytes, saved.out, saved.size);
        for (uint64_t n = 1 + bits(&s) % 4; n > 0; n--)
            bytes[bits(&s) % saved.size] = bits(&s) % 2 ? 0xFF : (uint8_t)bits(&s);
        if (!load(&s, bytes, bits(&s) % 8 ? saved.size : bits(&s) % saved.size)) {
            refused++;
        } else {
            taken++;
            s.t = bits(&s) % 2 ? s.pen.sight.t : bits(&s) % (UINT64_C(1) << 62);
        }
        for (int n = 0; n < 3; n++)
            go(&s);
        assert_true(s.pen.sight.fast == s.pen.sight.fast && s.pen.sight.slow == s.pen.sight.slow);
    }
    assert_true(refused > 500 && taken > 200);
    free(bytes);
    crt_state_free(&saved);
}

/* No number, infinite, too large: refused, wherever it stands. */
static void impossible_values_are_refused(void **state)
{
    static struct story s, other;
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e300};
    (void)state;
    setup = slow_setup();
    begin(&s, false, 5);
    for (int i = 0; i < 4 * 4; i++) {
        struct inp_pen_sight *sight = &s.pen.sight;
        struct crt_state saved = save(&s);
        double *at[] = {&sight->stored[0], &sight->fast, &sight->slow, &s.pen.knobs.focus},
               v = *at[i / 4];
        size_t before = saved.size;
        uint8_t *bytes = malloc(before);
        memcpy(bytes, saved.out, before);
        *at[i / 4] = 12345.678; /* to find it */
        struct crt_state marked = save(&s);
        assert_int_equal(marked.size, before);
        size_t place = 0;
        while (marked.out[place] == bytes[place])
            place++;
        *at[i / 4] = v;
        double mark = 12345.678;
        while (memcmp(marked.out + place, &mark, sizeof mark) != 0)
            place--;
        memcpy(bytes + place, &bad[i % 4], sizeof bad[0]);
        begin(&other, false, 5);
        assert_true(load(&other, saved.out, before));
        assert_false(load(&other, bytes, before));
        free(bytes);
        crt_state_free(&saved);
        crt_state_free(&marked);
    }
}

static void is_the_same_twice(void **state)
{
    static struct story a, b;
    (void)state;
    setup = slow_setup();
    for (int raster = 0; raster < 2; raster++) {
        begin(&a, raster, 17);
        begin(&b, raster, 17);
        for (int n = 0; n < 300; n++) {
            go(&a);
            go(&b);
        }
        assert_true(a.told == b.told && a.told != 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_future_after_a_snapshot),
        cmocka_unit_test(hostile_bytes_do_no_harm),
        cmocka_unit_test(impossible_values_are_refused),
        cmocka_unit_test(is_the_same_twice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
