/* fuzz_machine.c — a machine with any display memory and any pokes, and what its tube shows.
 *
 * Input:      byte 0    tube row          byte 1  phosphor
 *             byte 2    flags, see enum   byte 3  knobs: 2 bits each of brightness, contrast, focus;
 *                       64: the VS60's colours
 *             byte 4    sync tick (2 bits), begin of the exposure (3), its length (3), in eighths
 *                       of 2 ms
 *             byte 5    how many pokes follow, 0–31
 *             4 bytes each: when, in 1/64 of the run; what (3 bits); value low byte, value high
 *             the rest: little-endian display words from address 0
 * The tube has a spot of 1/24 of its width, so that a few thousand cells hold all of its light.
 * Checks:     the machine keeps time; light, stored energy and probes are finite and not negative;
 *             no more light than the strokes brought; the same film again from the other kernels,
 *             with reuse of footprints and with two threads.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/penetration.h"
#include "crt/spot.h"
#include "display_file/df_regs.h"
#include "emu/machine.h"

#define MS        CRT_PS_PER_MS
#define EIGHTH    (MS / 4) /* of 2 ms */
#define MAX_POKES 31
#define CLOSE_UP  48 /* cells */

enum {
    CLOSE = 1,   /* the grid of a close-up instead of the whole screen */
    HALT = 2,    /* no restart after a stop word */
    AVERAGE = 4, /* every instruction takes 10 µs */
    LITTLE_MEMORY = 8,
    LOW = 16,     /* the shortest times of the row */
    HIGH = 32,    /* the longest */
    LATE = 64,    /* power-on was long ago */
    THREADS = 128 /* two for the second run */
};

struct poke {
    uint64_t t;
    unsigned what; /* 0 DPC, 1 DPC odd, 2 MPR, 3 another register, 4–6 a word of memory, 7 knobs */
    uint16_t value;
};

struct plan {
    unsigned flags;
    struct crt_tube_row row;
    const struct crt_phosphor *phosphor;
    struct crt_knobs knobs;
    enum df_personality personality;
    struct crt_rate tick;
    struct crt_grid grid;
    uint64_t begin, t0, t1; /* of the run and of the exposure, its end too */
    struct poke poke[MAX_POKES];
    unsigned pokes;
    struct df_program program;
};

/* What a run leaves over to be compared. */
struct outcome {
    struct crt_film film;
    uint64_t words, strokes;
    double stored;
};

/* Stands between generator and machine: adds up the light that strokes bring. */
struct meter {
    struct vm_machine *m;
    const struct crt_phosphor *phosphor;
    void (*commit)(void *ctx, const struct crt_stroke *stroke); /* the machine's own */
    struct crt_knobs knobs;
    double cell_mm, brought;
    uint64_t last_t1;
};

#define REQUIRE(condition)                                                                         \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #condition);                \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/* ---- input ------------------------------------------------------------------------------------- */

static struct crt_knobs knobs_of(unsigned bits)
{
    static const double brightness[] = {0, 1, -1, 0.3}, contrast[] = {1, 4, 0, 0.5},
                        focus[] = {0, 4, 1, 0.1};
    return (struct crt_knobs){brightness[bits & 3], contrast[bits >> 2 & 3], focus[bits >> 4 & 3]};
}

static void plan_tube(struct plan *p, const uint8_t *b)
{
    static const struct crt_rate ticks[] = {{1000, 1}, {240, 1}, {60, 1}, {60000, 1001}};
    size_t rows, phosphors;
    const struct crt_tube_row *row = crt_tube_rows(&rows);
    const struct crt_phosphor *phosphor = crt_phosphors(&phosphors);
    struct crt_error err;
    while (row[rows - 1].kind != CRT_VECTOR_TUBE) /* which come first */
        rows--;
    p->row = row[b[0] % rows];
    p->phosphor = &phosphor[b[1] % phosphors];
    if (!crt_penetration_fits(&p->row, p->phosphor, &err))
        p->phosphor = crt_phosphor_find("P49");
    p->personality = b[3] & 64 ? DF_VS60 : DF_VT11;
    p->flags = b[2];
    p->knobs = knobs_of(b[3]);
    p->tick = ticks[b[4] & 3];
    double spot = p->row.width.value / 24;
    p->row.spot.value = p->row.spot.low = p->row.spot.high = spot < 50 ? spot : 50;
    REQUIRE(crt_tube_check(&p->row, &err));
    double size = p->row.spot.value;
    p->grid = p->flags & CLOSE ? crt_grid_closeup(size, -2 * size, 4 * size, CLOSE_UP, CLOSE_UP)
                               : crt_tube_grid(&p->row);
    p->begin = p->flags & LATE ? 5 * CRT_PS_PER_S + 7 : 0;
    p->t0 = p->begin + (b[4] >> 2 & 7) * EIGHTH;
    p->t1 = p->t0 + ((b[4] >> 5) + 1u) * EIGHTH;
}

static bool plan_of(struct plan *p, const uint8_t *data, size_t size)
{
    if (size < 6)
        return false;
    plan_tube(p, data);
    p->pokes = data[5] & 31;
    data += 6;
    size -= 6;
    if (size < 4 * (size_t)p->pokes + 2)
        return false;
    uint64_t last = p->begin;
    for (unsigned i = 0; i < p->pokes; i++, data += 4, size -= 4) {
        uint64_t t = p->begin + (p->t1 - p->begin) * (data[0] & 63u) / 64;
        last = t > last ? t : last;
        p->poke[i] = (struct poke){last, data[1] & 7u, (uint16_t)(data[2] | data[3] << 8)};
    }
    for (uint32_t at = 0; at + 1 < size && at < DF_ADDRESS_SPACE; at += 2)
        df_program_put(&p->program, at, (uint16_t)(data[at] | data[at + 1] << 8));
    return true;
}

/* ---- a run ------------------------------------------------------------------------------------- */

/* Light of a stroke in parts of one on a tube of one voltage. */
static double worth(const struct meter *meter, const struct crt_stroke *s)
{
    struct crt_voltage v =
        crt_voltage_at(meter->m->desc.row, meter->phosphor, (enum crt_level)s->level);
    double sum = 0;
    for (int k = 0; k < meter->phosphor->terms; k++)
        sum += meter->phosphor->term[k].w * v.light[meter->phosphor->term[k].colour];
    return sum;
}

static void measure(void *ctx, const struct crt_stroke *s)
{
    struct meter *meter = ctx;
    REQUIRE(s->t1 > s->t0 && s->t0 >= meter->last_t1);
    REQUIRE(s->drive >= 0 && s->drive <= 1);
    meter->last_t1 = s->t1;
    REQUIRE(s->level < CRT_LEVELS);
    meter->brought += crt_spot_at(meter->m->desc.row, &meter->knobs, (double)s->drive).power *
                      worth(meter, s) * (double)(s->t1 - s->t0) * 1e-12 /
                      (meter->cell_mm * meter->cell_mm);
    meter->commit(meter->m, s);
}

static void connect(struct meter *meter, const struct plan *p, struct vm_machine *m)
{
    struct df_beam *beam = &m->dpu.desc.beam;
    *meter = (struct meter){m, p->phosphor, beam->commit, p->knobs, p->grid.cell_mm, 0, 0};
    *beam = (struct df_beam){meter, NULL, measure};
}

/* With a meter by the plain loop, else by the one with hooks. */
static void run_to(struct vm_machine *m, uint64_t t, const struct meter *meter)
{
    struct vm_hooks hooks = {.ctx = NULL};
    if (meter)
        vm_machine_run(m, t);
    else
        vm_machine_trace(m, t, &hooks);
    REQUIRE(m->now == t && m->tick_time >= t);
    REQUIRE(m->dpu.state != DF_RUNNING || m->dpu.t >= t);
    REQUIRE(m->refreshes.last.end <= m->dpu.t && m->refreshes.last.begin <= m->refreshes.last.end);
}

static void apply(struct vm_machine *m, struct crt_tube *tube, const struct poke *p,
                  struct meter *meter)
{
    switch (p->what) {
    case 0:
        df_dpu_write(&m->dpu, DF_DPC, (uint16_t)(p->value & ~1u), m->now);
        break;
    case 1:
        df_dpu_write(&m->dpu, DF_DPC, p->value | 1, m->now);
        break;
    case 2:
        df_dpu_write(&m->dpu, DF_MPR, p->value, m->now);
        break;
    case 3:
        df_dpu_write(&m->dpu, p->value, p->value, m->now);
        break;
    case 7:
        crt_tube_set_knobs(tube, knobs_of(p->value));
        if (meter)
            meter->knobs = knobs_of(p->value);
        break;
    default: /* near the program's begin, a word made of what is there already */
        m->memory[p->value & 63] = (uint16_t)(m->memory[p->value & 63] ^ p->value << (p->what - 4));
        break;
    }
}

static void check_light(const struct plan *p, const struct vm_machine *m,
                        const struct crt_tube *tube, const struct outcome *o,
                        const struct meter *meter)
{
    struct crt_error err;
    double light = 0;
    size_t cells = (size_t)o->film.grid.cols * (size_t)o->film.grid.rows;
    REQUIRE(o->film.complete);
    REQUIRE(crt_tube_intact(tube, &err));
    REQUIRE(isfinite(o->stored) && o->stored >= 0);
    for (int c = 0; c < o->film.colours; c++)
        for (size_t i = 0; i < cells; i++) {
            float f = o->film.light[c][i];
            REQUIRE(isfinite(f) && f >= 0);
            light += (double)f;
        }
    if (meter)
        REQUIRE(light + o->stored <= meter->brought * 1.002 + 1e-9);
    for (int i = 0; i < 4; i++) {
        double cd[CRT_MAX_COLOURS] = {0}, x = p->row.width.value * (i - 2) / 5;
        crt_tube_probe(tube, x, i == 3 ? 1e6 : -x, m->now, cd);
        for (int c = 0; c < o->film.colours; c++)
            REQUIRE(isfinite(cd[c]) && cd[c] >= 0);
    }
}

static struct vm_machine_desc machine_of(const struct plan *p, struct crt_tube *tube)
{
    enum df_timing_choice choice = p->flags & LOW    ? DF_TIMING_LOW
                                   : p->flags & HIGH ? DF_TIMING_HIGH
                                                     : DF_TIMING_VALUE;
    struct vm_machine_desc d = {.row = &p->row,
                                .timing = df_timing_of_tube(&p->row, choice),
                                .personality = p->personality,
                                .tick = p->tick,
                                .memory_bytes = p->flags & LITTLE_MEMORY ? 1024 : DF_ADDRESS_SPACE,
                                .on_stop = p->flags & HALT ? VM_HALT : VM_RESTART,
                                .tube = tube};
    if (p->flags & AVERAGE)
        d.timing.average_ps = 10 * CRT_PS_PER_US;
    return d;
}

static void run(const struct plan *p, bool second, struct outcome *o)
{
    static struct vm_machine m;
    struct crt_error err;
    struct crt_tube_desc desc = {.row = &p->row,
                                 .phosphor = p->phosphor,
                                 .grid = p->grid,
                                 .epoch = p->tick,
                                 .knobs = p->knobs,
                                 .threads = second && p->flags & THREADS ? 2 : 1,
                                 .simd = second ? CRT_SIMD_AUTO : CRT_SIMD_BASELINE,
                                 .no_reuse = !second};
    struct meter measured, *meter = second ? NULL : &measured;
    struct crt_tube *tube = crt_tube_create(&desc, &err);
    REQUIRE(tube);
    REQUIRE(crt_film_init(&o->film, tube, &err));
    struct vm_machine_desc d = machine_of(p, tube);
    vm_machine_init(&m, &d);
    if (meter)
        connect(meter, p, &m);
    run_to(&m, p->begin, meter);
    crt_film_open(tube, &o->film, p->t0, p->t1);
    /* What does not fit into little memory is refused; then nothing is drawn until a poke. */
    if (!vm_machine_load(&m, &p->program, "fuzz", &err))
        REQUIRE(p->flags & LITTLE_MEMORY && strncmp(err.text, "fuzz", 4) == 0);
    for (unsigned i = 0; i < p->pokes; i++) {
        if (p->poke[i].t > m.now)
            run_to(&m, p->poke[i].t, meter);
        apply(&m, tube, &p->poke[i], meter);
    }
    run_to(&m, p->t1, meter);
    o->words = m.dpu.words;
    o->strokes = m.strokes;
    o->stored = crt_tube_totals(tube).stored;
    check_light(p, &m, tube, o, meter);
    crt_tube_destroy(tube);
}

static void compare(const struct outcome *a, const struct outcome *b)
{
    size_t cells = (size_t)a->film.grid.cols * (size_t)a->film.grid.rows;
    REQUIRE(a->words == b->words && a->strokes == b->strokes);
    for (int c = 0; c < a->film.colours; c++)
        REQUIRE(memcmp(a->film.light[c], b->film.light[c], cells * sizeof(float)) == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct plan p = {.flags = 0};
    struct crt_error err;
    REQUIRE(df_program_init(&p.program, &err));
    if (plan_of(&p, data, size)) {
        struct outcome first = {.words = 0}, second = {.words = 0};
        run(&p, false, &first);
        run(&p, true, &second);
        compare(&first, &second);
        crt_film_free(&first.film);
        crt_film_free(&second.film);
    }
    df_program_free(&p.program);
    return 0;
}
