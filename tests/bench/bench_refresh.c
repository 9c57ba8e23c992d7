/* Speed of the whole vector head: words in display memory to light on film.
 *
 * 1. A display file of 1000 random long vectors (|Δ| <= 100 units on each axis, 2006 words) on a VR17 at its own
 *    film grid, P39, one exposure a refresh, one thread: refreshes a second with a picture that
 *    changes every refresh (display memory rewritten, so no footprint is ever used again) and with a
 *    static one; nanoseconds per cell that the refresh lights, beside what reading and
 *    writing the plane and the film once costs (the floor no method gets under).
 * 2. The programs of the tour without exposures: simulated seconds a second.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/asm.h"
#include "display_file/df_regs.h"
#include "emu/machine.h"
#include "tests/support/bench.h"

#define VECTORS   1000
#define WARM      20
#define BLOCK     20
#define BLOCKS    15 /* of which the best and the median are told: the machine is seldom alone */
#define REFRESHES (BLOCK * BLOCKS)
#define SETS      (WARM + REFRESHES) /* a changing picture never comes again */

static uint32_t draw_number(uint32_t *seed, uint32_t n)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)*seed * n >> 32);
}

/* One long vector from *at that stays on the screen. */
static uint16_t delta(uint32_t *seed, int *at)
{
    int d;
    do
        d = (int)draw_number(seed, 201) - 100;
    while (*at + d < 0 || *at + d > 1023);
    *at += d;
    return (uint16_t)(d < 0 ? DF_SIGN_X | -d : d);
}

/* Load Status A (sync), point, x, y, long vector, 1000 data, jump 0: 2007 words. */
static void write_vectors(uint16_t *memory, uint32_t seed, unsigned intensity)
{
    int x = 512, y = 512;
    unsigned n = 0;
    memory[n++] = DF_STATUS_A | DF_LSA_SYNC;
    memory[n++] = DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT;
    memory[n++] = (uint16_t)x;
    memory[n++] = (uint16_t)y;
    memory[n++] = (uint16_t)(DF_SET_MODE | DF_MODE_LONG << DF_MODE_SHIFT | DF_SGM_INTENSITY |
                             intensity << DF_SGM_INTENSITY_SHIFT);
    for (int i = 0; i < VECTORS; i++) {
        memory[n++] = (uint16_t)(DF_BEAM_ON | delta(&seed, &x));
        memory[n++] = delta(&seed, &y);
    }
    memory[n++] = DF_JUMP;
    memory[n++] = 0;
}

/* Cells that one refresh from the dark lights. */
static size_t lit_cells(const struct crt_film *film)
{
    size_t lit = 0, cells = (size_t)film->grid.cols * (size_t)film->grid.rows;
    for (size_t i = 0; i < cells; i++)
        lit += film->light[0][i] > 0;
    return lit;
}

struct rig {
    struct crt_tube *tube;
    struct vm_machine *machine;
    struct crt_film film;
    struct crt_rate tick;
};

static bool set_up(struct rig *rig, enum crt_simd simd)
{
    struct crt_error err;
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    rig->tick = (struct crt_rate){60, 1};
    rig->machine = malloc(sizeof *rig->machine);
    rig->tube = crt_tube_create(&(struct crt_tube_desc){.row = row,
                                                        .phosphor = crt_phosphor_find("P39"),
                                                        .grid = crt_tube_grid(row),
                                                        .epoch = rig->tick,
                                                        .knobs = {0, 1, 0},
                                                        .threads = 1,
                                                        .simd = simd},
                                &err);
    if (rig->tube == NULL || !crt_film_init(&rig->film, rig->tube, &err)) {
        printf("refresh: skipped: %s\n", err.text);
        return false;
    }
    vm_machine_init(rig->machine,
                    &(struct vm_machine_desc){.row = row,
                                              .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                              .tick = rig->tick,
                                              .memory_bytes = DF_ADDRESS_SPACE,
                                              .tube = rig->tube});
    return true;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void refresh(enum crt_simd simd, const char *name, bool changing, unsigned intensity)
{
    static uint16_t set[SETS][2 * VECTORS + 8];
    struct crt_error err;
    struct df_program program;
    struct rig rig;
    if (!set_up(&rig, simd) || !df_program_init(&program, &err))
        return;
    for (unsigned i = 0; i < SETS; i++)
        write_vectors(set[i], i + 1, intensity);
    for (uint32_t i = 0; i < 2 * VECTORS + 7; i++)
        df_program_put(&program, 2 * i, set[0][i]);
    if (!vm_machine_load(rig.machine, &program, "vectors", &err))
        printf("refresh: %s\n", err.text);

    double start = 0, block[BLOCKS];
    size_t lit = 0;
    for (int n = 0; n < WARM + REFRESHES; n++) {
        if (n >= WARM && (n - WARM) % BLOCK == 0) {
            double now = bench_seconds();
            if (n > WARM)
                block[(n - WARM) / BLOCK - 1] = now - start;
            start = now;
        }
        uint64_t t0 = crt_tick_time(rig.tick, (uint64_t)n);
        uint64_t t1 = crt_tick_time(rig.tick, (uint64_t)n + 1);
        if (changing)
            memcpy(rig.machine->memory, set[n % SETS], sizeof set[0]);
        crt_film_open(rig.tube, &rig.film, t0, t1);
        vm_machine_run(rig.machine, t1);
        if (n <= 2) /* the first refresh that draws; the screen was dark before */
            lit = lit ? lit : lit_cells(&rig.film);
    }
    block[BLOCKS - 1] = bench_seconds() - start;
    qsort(block, BLOCKS, sizeof block[0], by_size);
    double each = block[0] / BLOCK,
           floor = bench_floor_ns((size_t)rig.film.grid.cols * (size_t)rig.film.grid.rows);
    printf("refresh: %-8s intensity %u %-8s %4.0f refreshes/s (median %4.0f), %.2f ns per lit cell "
           "(%zu lit; floor %.2f ns)\n",
           changing ? "changing" : "static", intensity, name, 1 / each, BLOCK / block[BLOCKS / 2],
           each * 1e9 / (double)lit, lit, floor);
    df_program_free(&program);
    crt_film_free(&rig.film);
    crt_tube_destroy(rig.tube);
    free(rig.machine);
}

static void tour(const char *path)
{
    struct crt_error err;
    struct df_program program;
    struct df_asm_report report;
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    if (!df_assemble_file(path, &(struct df_asm_options){false}, &program, &report)) {
        printf("headless: %s\n", report.text);
        df_asm_report_free(&report);
        return;
    }
    struct vm_machine *machine = malloc(sizeof *machine);
    vm_machine_init(machine,
                    &(struct vm_machine_desc){.row = row,
                                              .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                              .tick = {60, 1},
                                              .memory_bytes = DF_ADDRESS_SPACE});
    if (vm_machine_load(machine, &program, path, &err)) {
        double start = bench_seconds();
        vm_machine_run(machine, 20 * CRT_PS_PER_S);
        double took = bench_seconds() - start;
        printf("headless: %-18s %6.0f simulated seconds a second\n", path, 20 / took);
    } else {
        printf("headless: %s\n", err.text);
    }
    free(machine);
    df_program_free(&program);
    df_asm_report_free(&report);
}

/* An argument leaves its opposite out: changing or static, baseline or best. */
static bool wanted(int argc, char **argv, const char *other)
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], other) == 0)
            return false;
    return true;
}

int main(int argc, char **argv)
{
    /* 4 is the intensity after power-on; 7 is the widest spot. */
    for (unsigned intensity = 4; intensity <= 7; intensity += 3)
        for (int changing = 1; changing >= 0; changing--) {
            if (!wanted(argc, argv, changing ? "static" : "changing"))
                continue;
            if (wanted(argc, argv, "best"))
                refresh(CRT_SIMD_BASELINE, "baseline", changing, intensity);
            if (wanted(argc, argv, "baseline"))
                refresh(CRT_SIMD_AUTO, "best", changing, intensity);
        }
    static const char *const programs[] = {"charset", "testcard", "logic",   "rose",
                                           "spin",    "radar",    "growing", "lander"};
    for (size_t i = 0; i < sizeof programs / sizeof programs[0]; i++) {
        char path[64];
        snprintf(path, sizeof path, "roms/%s.df", programs[i]);
        tour(path);
    }
    return 0;
}
