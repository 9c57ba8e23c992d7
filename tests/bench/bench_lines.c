/* Speed of scan lines: a colour tube of 1024 x 768 dots and a white one of 640 x 480, a film every field;
 * pictures in which every line changes each field, and pictures that stand. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "crt/tube.h"
#include "tests/support/bench.h"
#include "tests/support/line_model.h"
#include "tests/support/tube_model.h"

#define PICTURES 4
#define BLOCK    4 /* fields timed together */
#define ROUNDS   12

struct mode {
    int dots, lines, total,
        fields;  /* total: dots of a line with its retrace; fields: lines of a field */
    uint64_t hz; /* dots a second */
};

static const struct mode xga = {1024, 768, 1344, 806, 65000000};
static const struct mode vga = {640, 480, 800, 525, 25175000};

struct contest {
    const char *name;
    const struct mode *mode;
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    const uint8_t *pictures;
    bool changing;
    int threads;
    enum crt_simd simd;
    struct crt_tube *tube;
    struct crt_film film;
    struct crt_rate field;
    uint64_t fields;
    double best; /* seconds a field */
};

/* Text on the left, something like a photograph on the right, both moving; or dots at random. */
static uint8_t dot_of(const struct mode *m, int picture, int gun, int x, int y, uint32_t *seed,
                      bool noise)
{
    uint32_t r = model_random(seed);
    if (noise)
        return (uint8_t)(r >> 8);
    if (x < m->dots * 6 / 10) {
        int row = (y + 3 * picture) / 16, line = (y + 3 * picture) % 16, col = x / 9;
        uint32_t glyph = ((uint32_t)(row * 131 + col * 17 + picture) * 2654435761u) >> 7;
        bool ink =
            line > 2 && line < 13 && x % 9 > 0 && (glyph >> (line / 2 * 3 + x % 9 / 3) % 24 & 1);
        return ink ? (uint8_t)(gun == 2 ? 160 : 230) : (uint8_t)(gun == 2 ? 60 : 0);
    }
    int wave = (x * (3 + gun) + y * 2 + picture * 5) % 512;
    return (uint8_t)(30 + (wave < 256 ? wave : 511 - wave) * 7 / 10 + (int)(r >> 28));
}

static uint8_t *make_pictures(const struct mode *m, int guns, bool noise)
{
    size_t plane = (size_t)m->dots * (size_t)m->lines;
    uint8_t *all = malloc((size_t)PICTURES * (size_t)guns * plane), *at = all;
    uint32_t seed = 1;
    for (int p = 0; all && p < PICTURES; p++)
        for (int g = 0; g < guns; g++)
            for (int y = 0; y < m->lines; y++)
                for (int x = 0; x < m->dots; x++)
                    *at++ = dot_of(m, p, g, x, y, &seed, noise);
    return all;
}

static double seconds_now(const struct contest *c)
{
    struct timespec t;
    if (c->threads == 1)
        return bench_seconds();
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool set_up(struct contest *c)
{
    struct crt_error err;
    c->field = (struct crt_rate){c->mode->hz, (uint64_t)(c->mode->total * c->mode->fields)};
    const struct crt_tube_desc desc = {.row = c->row,
                                       .phosphor = c->phosphor,
                                       .grid = crt_tube_grid(c->row),
                                       .epoch = c->field,
                                       .knobs = {0, 1, 0},
                                       .threads = c->threads,
                                       .simd = c->simd};
    c->best = 1e9;
    c->tube = crt_tube_create(&desc, &err);
    if (c->tube && crt_film_init(&c->film, c->tube, &err))
        return true;
    printf("lines: %s skipped: %s\n", c->name, err.text);
    return false;
}

/* Seconds that the tube took for one field. */
static double field(struct contest *c)
{
    const struct mode *m = c->mode;
    int guns = crt_tube_guns(c->row);
    size_t plane = (size_t)m->dots * (size_t)m->lines;
    uint64_t t0 = crt_tick_time(c->field, c->fields), t1 = crt_tick_time(c->field, c->fields + 1);
    uint64_t dot = CRT_PS_PER_S / m->hz;
    const uint8_t *picture =
        c->pictures + (c->changing ? c->fields % PICTURES : 0) * (uint64_t)guns * plane;
    double width = c->row->width.value, height = c->row->height.value;
    double start = seconds_now(c);
    crt_film_open(c->tube, &c->film, t0, t1);
    for (int y = 0; y < m->lines; y++) {
        struct crt_scan_line line = {.t0 = t0 + (uint64_t)(y * m->total) * dot,
                                     .x0 = (float)(-width / 2),
                                     .x1 = (float)(width / 2),
                                     .y0 = (float)(height / 2 - (y + 0.5) * height / m->lines),
                                     .dots = m->dots,
                                     .guns = guns,
                                     .source = (uint32_t)y};
        line.t1 = line.t0 + (uint64_t)m->dots * dot;
        line.y1 = line.y0;
        for (int g = 0; g < guns; g++)
            line.drive[g] = picture + (size_t)g * plane + (size_t)(y * m->dots);
        crt_tube_scan_line(c->tube, &line);
    }
    crt_tube_advance(c->tube, t1);
    c->fields++;
    return seconds_now(c) - start;
}

static void compete(struct contest *c)
{
    double sum = 0;
    field(c);
    field(c);
    for (int n = 0; n < BLOCK; n++)
        sum += field(c);
    c->best = sum / BLOCK < c->best ? sum / BLOCK : c->best;
}

static void report(const struct contest *c)
{
    double period = (double)c->field.den / (double)c->field.num;
    double cells = (double)c->film.grid.cols * c->film.grid.rows * c->film.colours;
    printf("lines: %s %.2f ms a field, %.2f x real time, %.2f ns a cell (%d x %d cells, %d "
           "colours)\n",
           c->name, c->best * 1e3, period / c->best, c->best * 1e9 / cells, c->film.grid.cols,
           c->film.grid.rows, c->film.colours);
}

#define CONTEST(name_, mode_, row_, phosphor_, pictures_, changing_, threads_, simd_)              \
    {                                                                                              \
        .name = name_, .mode = &mode_, .row = &row_, .phosphor = phosphor_, .pictures = pictures_, \
        .changing = changing_, .threads = threads_, .simd = simd_                                  \
    }

int main(int argc, char **argv)
{
    struct crt_tube_row colour = line_model_colour_row(320, 240, 0.445);
    struct crt_tube_row white = line_model_row(204, 153, 0.45);
    struct crt_phosphor p22 = line_model_p22();
    colour.converge_edge.value = 0.3;
    colour.spot_edge.value = 1.3;
    colour.bandwidth.value = 100;
    white.spot_growth.value = 0.08;
    white.spot_edge.value = 1.2;
    white.bandwidth.value = 30;
    const struct crt_phosphor *p4 = crt_phosphor_find("P4");
    uint8_t *three = make_pictures(&xga, 3, false), *noise = make_pictures(&xga, 3, true);
    uint8_t *one = make_pictures(&vga, 1, false);
    struct contest contests[] = {
        CONTEST("colour changing avx2", xga, colour, &p22, three, true, 1, CRT_SIMD_AVX2),
        CONTEST("colour noise avx2", xga, colour, &p22, noise, true, 1, CRT_SIMD_AVX2),
        CONTEST("colour changing avx2, 2 threads", xga, colour, &p22, three, true, 2,
                CRT_SIMD_AVX2),
        CONTEST("colour static avx2", xga, colour, &p22, three, false, 1, CRT_SIMD_AVX2),
        CONTEST("colour static avx2, 2 threads", xga, colour, &p22, three, false, 2, CRT_SIMD_AVX2),
        CONTEST("colour changing baseline", xga, colour, &p22, three, true, 1, CRT_SIMD_BASELINE),
        CONTEST("colour static baseline", xga, colour, &p22, three, false, 1, CRT_SIMD_BASELINE),
        CONTEST("white changing avx2", vga, white, p4, one, true, 1, CRT_SIMD_AVX2),
        CONTEST("white changing avx2, 2 threads", vga, white, p4, one, true, 2, CRT_SIMD_AVX2),
        CONTEST("white static avx2", vga, white, p4, one, false, 1, CRT_SIMD_AVX2),
        CONTEST("white changing baseline", vga, white, p4, one, true, 1, CRT_SIMD_BASELINE),
        CONTEST("white static baseline", vga, white, p4, one, false, 1, CRT_SIMD_BASELINE),
    };
    if (!three || !noise || !one)
        return 1;
    for (size_t i = 0; i < sizeof contests / sizeof contests[0]; i++) {
        struct contest *c = &contests[i];
        if ((argc > 1 && !strstr(c->name, argv[1])) || !set_up(c))
            continue;
        for (int round = 0; round < ROUNDS; round++)
            compete(c);
        report(c);
        crt_film_free(&c->film);
        crt_tube_destroy(c->tube);
    }
    free(three);
    free(noise);
    free(one);
    return 0;
}
