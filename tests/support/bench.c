#include "tests/support/bench.h"

#include <stdlib.h>
#include <time.h>

double bench_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_wall_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

double bench_floor_ns(size_t cells)
{
    float *plane = calloc(cells, sizeof *plane), *film = calloc(cells, sizeof *film);
    double best = 1e9;
    for (int round = 0; plane != NULL && film != NULL && round < 20; round++) {
        double start = bench_seconds();
        for (size_t i = 0; i < cells; i++) {
            film[i] = plane[i] * 0.2F;
            plane[i] = plane[i] * 0.8F + 1e-3F;
        }
        __asm__ volatile("" ::"r"(plane), "r"(film) : "memory");
        double took = bench_seconds() - start;
        best = took < best ? took : best;
    }
    free(plane);
    free(film);
    return best * 1e9 / (double)cells;
}
