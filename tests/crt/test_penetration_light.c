/* Light of a penetration tube's layers against a slow exact integral; energy, probe, snapshots; and tubes
 * of one voltage, which know nothing of it. */
#include <string.h>

#include "crt/penetration.h"
#include "crt/spot.h"
#include "crt/tube.h"
#include "tests/support/penetration_model.h"
#include "tests/support/tube_model.h"

#define COLS 104
#define ROWS 88
#define TICK (CRT_PS_PER_S / 60)

#define STROKES 240

struct scene {
    struct crt_stroke stroke[STROKES];
    int count;
};

static void add(struct scene *s, uint64_t *t, uint64_t length, const float place[4], float drive,
                enum crt_level level)
{
    s->stroke[s->count++] = (struct crt_stroke){*t,       *t + length, place[0], place[1], place[2],
                                                place[3], drive,       07,       level};
    *t += length;
}

/* Vectors with rests at their ends, single strokes and dots, in all colours, over some ticks; all
 * near a corner, where the colours are apart. */
static void make_scene(struct scene *s, uint32_t seed)
{
    uint64_t t = 12345;
    *s = (struct scene){.count = 0};
    while (s->count + 3 <= STROKES) {
        float p[4];
        for (int i = 0; i < 4; i++)
            p[i] = (float)(100 + model_uniform(&seed, -7, 7));
        float a[4] = {p[0], p[1], p[0], p[1]}, b[4] = {p[2], p[3], p[2], p[3]};
        enum crt_level level = (enum crt_level)(model_random(&seed) % CRT_LEVELS);
        float drive = (float)model_uniform(&seed, 0.4, 1);
        switch (model_random(&seed) % 3) {
        case 0:
            add(s, &t, 100000, a, drive, level);
            add(s, &t, 20000000, p, drive, level);
            add(s, &t, 100000, b, drive, level);
            break;
        case 1:
            add(s, &t, 5000000, p, drive, level);
            break;
        default:
            add(s, &t, 1000000, a, drive, level);
            break;
        }
        t += model_random(&seed) % 1000000 + (model_random(&seed) % 16 == 0 ? TICK / 3 : 0);
    }
}

static struct crt_tube_desc desc_of(const struct crt_tube_row *r)
{
    double cell = r->spot.value / CRT_WIDTH60_SIGMA;
    return (struct crt_tube_desc){
        .row = r,
        .phosphor = p49(),
        .grid = {COLS, ROWS, cell, 100 - COLS * cell / 2, 100 + ROWS * cell / 2},
        .epoch = {60, 1},
        .knobs = {0, 1, 0},
        .threads = 1};
}

static struct crt_tube *new_tube(const struct crt_tube_desc *desc)
{
    struct crt_error err;
    struct crt_tube *tube = crt_tube_create(desc, &err);
    if (!tube)
        fail_msg("%s", err.text);
    return tube;
}

/* Films [a, b) of a scene. */
static void expose(const struct crt_tube_desc *desc, const struct scene *s, uint64_t a, uint64_t b,
                   struct crt_film *film)
{
    struct crt_error err;
    struct crt_tube *tube = new_tube(desc);
    assert_true(crt_film_init(film, tube, &err));
    int next = 0;
    for (; next < s->count && s->stroke[next].t0 < a; next++)
        crt_tube_stroke(tube, &s->stroke[next]);
    crt_tube_advance(tube, a);
    crt_film_open(tube, film, a, b);
    for (; next < s->count && s->stroke[next].t0 < b; next++)
        crt_tube_stroke(tube, &s->stroke[next]);
    crt_tube_advance(tube, b);
    assert_true(film->complete);
    crt_tube_destroy(tube);
}

/* What the scene is for one layer, worked out here. */
static void model_of(const struct scene *s, const struct crt_tube_row *r, int layer,
                     struct model_stroke *out)
{
    const struct crt_knobs knobs = {0, 1, 0};
    for (int i = 0; i < s->count; i++) {
        uint32_t level = s->stroke[i].level ? s->stroke[i].level : CRT_LEVEL_GREEN;
        int n = (int)level - 1;
        double y[2], slower = sqrt(12 / kv[n]);
        double place = 1 + r->colour_register.value * (slower - 1);
        struct crt_spot spot = crt_spot_at(r, &knobs, (double)s->stroke[i].drive);
        layers(n, y);
        out[i].stroke = s->stroke[i];
        out[i].stroke.x0 = (float)((double)s->stroke[i].x0 * place);
        out[i].stroke.y0 = (float)((double)s->stroke[i].y0 * place);
        out[i].stroke.x1 = (float)((double)s->stroke[i].x1 * place);
        out[i].stroke.y1 = (float)((double)s->stroke[i].y1 * place);
        out[i].sigma_mm = spot.sigma_mm * slower;
        /* model_light multiplies by the terms' shares. */
        out[i].power = spot.power * y[layer] / (layer == 0 ? 0.375 : 0.625);
    }
}

static void film_is_the_exact_integral(void **state)
{
    (void)state;
    static struct scene scene;
    static struct model_stroke model[STROKES];
    struct crt_tube_row wide = *row();
    wide.colour_register = (struct crt_figure){0.02, 0, 0.02, "as far as its range goes"};
    struct crt_tube_desc desc = desc_of(&wide);
    make_scene(&scene, 5);
    const uint64_t from[] = {0, TICK / 2, TICK, 3 * TICK / 2},
                   to[] = {3 * TICK, TICK, 2 * TICK, 2 * TICK + 777};
    double worst = 0;
    for (size_t n = 0; n < sizeof from / sizeof from[0]; n++) {
        struct crt_film film;
        uint32_t seed = 9;
        expose(&desc, &scene, from[n], to[n], &film);
        assert_int_equal(film.colours, 2);
        for (int c = 0; c < 2; c++) {
            double peak = 0;
            model_of(&scene, &wide, c, model);
            for (int i = 0; i < COLS * ROWS; i++)
                peak = fmax(peak, (double)film.light[c][i]);
            assert_true(peak > 0);
            for (int k = 0; k < 60; k++) {
                int i = (int)(model_random(&seed) % (COLS * ROWS));
                double x = desc.grid.left_mm + (i % COLS + 0.5) * desc.grid.cell_mm;
                double y = desc.grid.top_mm - (i / COLS + 0.5) * desc.grid.cell_mm;
                double exact = model_light(model, scene.count, p49(), c, x, y, from[n], to[n]);
                worst = fmax(worst, fabs((double)film.light[c][i] - exact) / peak);
            }
        }
        crt_film_free(&film);
    }
    print_message("# film of two layers: within %.1e of its peak\n", worst);
    assert_true(worst < 1e-3);
}

/* Light on film and light left in the screen are what the beam has put in, in every colour. */
static void energy_is_conserved(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(row());
    double cell2 = desc.grid.cell_mm * desc.grid.cell_mm;
    for (int n = 0; n < LEVELS; n++) {
        struct crt_error err;
        struct crt_film film;
        struct crt_tube *tube = new_tube(&desc);
        struct crt_spot spot = crt_spot_at(row(), &desc.knobs, 0.8);
        struct crt_stroke s = {.t0 = 1000,
                               .t1 = 1000 + 30000000,
                               .x0 = 97,
                               .y0 = 98,
                               .x1 = 103,
                               .y1 = 101,
                               .drive = 0.8F,
                               .level = levels[n]};
        double y[2], sum = 0;
        layers(n, y);
        spot = crt_spot_at(row(), &desc.knobs, (double)s.drive);
        double given = spot.power * 30e-6 * (y[0] + y[1]) / cell2;
        assert_true(crt_film_init(&film, tube, &err));
        crt_film_open(tube, &film, 0, TICK / 4);
        crt_tube_stroke(tube, &s);
        crt_tube_advance(tube, TICK / 8); /* all of it still in the journal */
        crt_tube_advance(tube, TICK / 4);
        for (int c = 0; c < 2; c++)
            for (int i = 0; i < COLS * ROWS; i++)
                sum += (double)film.light[c][i];
        near(sum + crt_tube_totals(tube).stored, given, 1e-4);
        /* One tick later in planes and journal: what has not been emitted by then. */
        crt_tube_advance(tube, TICK + TICK / 3);
        double t = ((double)TICK * 4 / 3 - 1000 - 15e6) * 1e-12, left = 0;
        left += y[0] * exp(-t / 0.5e-3) + y[1] * exp(-t / (24e-3 / log(10)));
        double off = crt_tube_totals(tube).stored - spot.power * 30e-6 * left / cell2;
        assert_true(fabs(off) < 2e-3 * spot.power * 30e-6 * left / cell2 + 1e-12 * given);
        crt_film_free(&film);
        crt_tube_destroy(tube);
    }
}

/* A dot of T seconds: luminance under the probe follows from its fluence and the decay. */
static void probe_sees_each_layer(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(row());
    const double tau[2] = {0.5e-3, 24e-3 / log(10)}, dwell = 2e-6;
    for (int n = 0; n < LEVELS; n++) {
        struct crt_tube *tube = new_tube(&desc);
        struct crt_stroke s = {.t0 = 0,
                               .t1 = 2000000,
                               .x0 = 100,
                               .y0 = 100,
                               .x1 = 100,
                               .y1 = 100,
                               .drive = 1,
                               .level = levels[n]};
        struct crt_spot spot = crt_spot_at(row(), &desc.knobs, 1);
        double y[2], got[CRT_MAX_COLOURS], slower = sqrt(12 / kv[n]);
        double place = 1 + 0.005 * (slower - 1), sigma = spot.sigma_mm * slower;
        layers(n, y);
        crt_tube_stroke(tube, &s);
        for (int when = 0; when < 3; when++) {
            double after = when == 0 ? 0 : when == 1 ? 1e-3 : 20e-3; /* the last one in planes */
            uint64_t t = s.t1 + (uint64_t)(after * 1e12);
            crt_tube_advance(tube, t);
            crt_tube_probe(tube, 100 * place, 100 * place, t, got);
            for (int c = 0; c < 2; c++) {
                double light = spot.power * y[c] / (2 * acos(-1) * sigma * sigma);
                double expected = light * -expm1(-dwell / tau[c]) * exp(-after / tau[c]);
                if (!(fabs(got[c] - expected) <= 0.012 * expected + 1e-12))
                    fail_msg("%s, layer %d after %g s: %g, expected %g", crt_level_name(levels[n]),
                             c, after, got[c], expected);
            }
        }
        crt_tube_destroy(tube);
    }
}

static void only_is_green(void **state)
{
    (void)state;
    static struct scene a, b;
    struct crt_tube_desc desc = desc_of(row());
    struct crt_film films[2];
    make_scene(&a, 7);
    b = a;
    for (int i = 0; i < a.count; i++) {
        a.stroke[i].level = CRT_LEVEL_ONLY;
        b.stroke[i].level = CRT_LEVEL_GREEN;
    }
    expose(&desc, &a, 0, 2 * TICK, &films[0]);
    expose(&desc, &b, 0, 2 * TICK, &films[1]);
    for (int c = 0; c < 2; c++)
        assert_memory_equal(films[0].light[c], films[1].light[c], COLS * ROWS * sizeof(float));
    for (int i = 0; i < COLS * ROWS; i++)
        assert_true(films[0].light[0][i] == 0);
    crt_film_free(&films[0]);
    crt_film_free(&films[1]);
}

/* On a tube of one voltage every level is the same light. */
static void other_tubes_ignore_levels(void **state)
{
    (void)state;
    static struct scene a, b;
    struct crt_tube_row plain = *row();
    plain.penetration = false;
    struct crt_tube_desc desc = desc_of(&plain);
    struct crt_film films[2];
    make_scene(&a, 8);
    b = a;
    for (int i = 0; i < b.count; i++)
        b.stroke[i].level = CRT_LEVEL_ONLY;
    for (int i = 0; i < a.count; i++)
        a.stroke[i].level = (uint32_t)i % CRT_LEVELS; /* also within a vector */
    expose(&desc, &a, TICK / 3, 2 * TICK, &films[0]);
    expose(&desc, &b, TICK / 3, 2 * TICK, &films[1]);
    for (int c = 0; c < 2; c++)
        assert_memory_equal(films[0].light[c], films[1].light[c], COLS * ROWS * sizeof(float));
    crt_film_free(&films[0]);
    crt_film_free(&films[1]);
}

/* ---- snapshots --------------------------------------------------------------------------------- */

static struct crt_state saved(struct crt_tube *tube)
{
    struct crt_state s;
    crt_state_save(&s);
    crt_tube_state(tube, &s);
    assert_false(s.failed);
    return s;
}

static bool load(struct crt_tube *tube, const struct crt_state *from, struct crt_state *s)
{
    crt_state_load(s, from->out, from->size);
    crt_tube_state(tube, s);
    return !s->failed;
}

static void a_snapshot_keeps_the_colours(void **state)
{
    (void)state;
    static struct scene scene;
    struct crt_tube_desc desc = desc_of(row());
    struct crt_error err;
    make_scene(&scene, 11);
    int half = scene.count / 2;
    struct crt_tube *tube[2] = {new_tube(&desc), new_tube(&desc)};
    struct crt_film film[2];
    for (int i = 0; i < half; i++)
        crt_tube_stroke(tube[0], &scene.stroke[i]);
    uint64_t now = scene.stroke[half - 1].t1;
    crt_tube_advance(tube[0], now);
    struct crt_state before = saved(tube[0]), reading;
    assert_true(load(tube[1], &before, &reading));
    for (int n = 0; n < 2; n++) {
        assert_true(crt_film_init(&film[n], tube[n], &err));
        crt_film_open(tube[n], &film[n], now, now + 2 * TICK);
        for (int i = half; i < scene.count && scene.stroke[i].t0 < now + 2 * TICK; i++)
            crt_tube_stroke(tube[n], &scene.stroke[i]);
        crt_tube_advance(tube[n], now + 2 * TICK);
    }
    for (int c = 0; c < 2; c++)
        assert_memory_equal(film[0].light[c], film[1].light[c], COLS * ROWS * sizeof(float));
    struct crt_state after[2] = {saved(tube[0]), saved(tube[1])};
    assert_int_equal(after[0].size, after[1].size);
    assert_memory_equal(after[0].out, after[1].out, after[0].size);
    for (int n = 0; n < 2; n++) {
        crt_state_free(&after[n]);
        crt_film_free(&film[n]);
        crt_tube_destroy(tube[n]);
    }
    crt_state_free(&before);
}

static void an_impossible_level_is_refused(void **state)
{
    (void)state;
    struct crt_tube_desc desc = desc_of(row());
    struct crt_tube *tube = new_tube(&desc);
    struct crt_stroke s = {.t0 = 5, .t1 = 10, .x0 = 100, .y0 = 100, .x1 = 101, .y1 = 100};
    s.drive = 1;
    s.source = 0x5a5a5a5a;
    s.level = CRT_LEVEL_YELLOW;
    crt_tube_stroke(tube, &s);
    struct crt_state state_of = saved(tube), reading;
    static const uint8_t source[] = {0x5a, 0x5a, 0x5a, 0x5a, CRT_LEVEL_YELLOW, 0, 0, 0};
    uint8_t *at = NULL;
    for (size_t i = 0; i + sizeof source <= state_of.size; i++)
        if (memcmp(state_of.out + i, source, sizeof source) == 0)
            at = state_of.out + i + 4;
    assert_non_null(at);
    assert_true(load(tube, &state_of, &reading));
    *at = CRT_LEVELS;
    assert_false(load(tube, &state_of, &reading));
    assert_non_null(strstr(reading.err.text, "stroke"));
    crt_state_free(&state_of);
    crt_tube_destroy(tube);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(film_is_the_exact_integral),
        cmocka_unit_test(energy_is_conserved),
        cmocka_unit_test(probe_sees_each_layer),
        cmocka_unit_test(only_is_green),
        cmocka_unit_test(other_tubes_ignore_levels),
        cmocka_unit_test(a_snapshot_keeps_the_colours),
        cmocka_unit_test(an_impossible_level_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
