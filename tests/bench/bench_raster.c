/* bench_raster — the raster head with its tube: refresh buffer to film, an exposure every field, as so many
 * times real time. The picture is a landscape of smooth slopes and noise in 8 bits through the look-up
 * table, with a hundred words of text-like marks; "changing" scrolls it, so that every line of every field
 * differs. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/tube.h"
#include "raster/head.h"
#include "tests/support/bench.h"

#define FIELDS 60
#define WARM   6

struct rig {
    struct ras_head *head;
    uint8_t *buffer;
    struct crt_tube *tube;
    struct crt_film film;
    struct crt_rate field;
};

static void scan_line(void *ctx, const struct crt_scan_line *line)
{
    crt_tube_scan_line(((struct rig *)ctx)->tube, line);
}

static uint32_t noise(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 24;
}

/* Twice as many rows as are shown, so that there is something to scroll to. */
static void paint(uint8_t *buffer, uint32_t pitch, uint32_t rows)
{
    uint32_t state = 1;
    for (uint32_t y = 0; y < rows; y++)
        for (uint32_t x = 0; x < pitch; x++) {
            uint32_t slope = (x * 3 + y * 2) / 8, word = (x / 7 ^ y / 9) * 2654435761u >> 28;
            bool text = y % 64 < 40 && x % 256 < 120 && word < 5;
            buffer[y * pitch + x] = (uint8_t)(text ? 255 : (slope + noise(&state) / 16) & 0xFF);
        }
}

static bool set_up(struct rig *rig, const char *tube, const char *mode, enum crt_simd simd,
                   int threads)
{
    struct crt_error err = {""};
    const struct crt_tube_row *row = crt_tube_row_find(tube);
    const struct crt_phosphor *phosphor = row ? crt_phosphor_find(row->phosphor) : NULL;
    struct ras_head_desc desc = {0};
    memset(rig, 0, sizeof *rig);
    if (!row || !phosphor || !ras_mode_parse(mode, &desc.timing, &err)) {
        printf("raster: skipped: %s %s\n", tube, err.text);
        return false;
    }
    rig->field = ras_field_rate(&desc.timing);
    rig->head = calloc(1, sizeof *rig->head);
    rig->buffer = calloc(1, VIDEO_BUFFER_BYTES);
    rig->tube = crt_tube_create(&(struct crt_tube_desc){.row = row,
                                                        .phosphor = phosphor,
                                                        .grid = crt_tube_grid(row),
                                                        .epoch = rig->field,
                                                        .knobs = {0, 1, 0},
                                                        .threads = threads,
                                                        .simd = simd},
                                &err);
    if (!rig->tube || !crt_film_init(&rig->film, rig->tube, &err)) {
        printf("raster: skipped: %s\n", err.text);
        return false;
    }
    paint(rig->buffer, desc.timing.h.visible, 2 * desc.timing.v.visible);
    desc.buffer = rig->buffer;
    desc.width_mm = row->width.value;
    desc.height_mm = row->height.value;
    desc.border_mm = row->border.value;
    desc.guns = crt_tube_guns(row);
    desc.monitor = ras_monitor_of(row);
    desc.wires = (struct ras_wires){.ctx = rig, .line = scan_line};
    ras_head_init(rig->head, &desc);
    ras_head_reset(rig->head, 0);
    for (uint32_t i = 0; i < 256; i++)
        rig->head->lut[i] = i << 16 | (255 - i) << 8 | ((i * 5) & 0xFF);
    ras_head_write(rig->head, VIDEO_PITCH, desc.timing.h.visible, 0);
    ras_head_write(rig->head, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    return true;
}

static void tear_down(struct rig *rig)
{
    crt_film_free(&rig->film);
    crt_tube_destroy(rig->tube);
    free(rig->head);
    free(rig->buffer);
}

/* One field of the head to the tube, exposed. */
static void field(struct rig *rig, uint64_t n, bool changing)
{
    uint64_t t0 = crt_tick_time(rig->field, n), t1 = crt_tick_time(rig->field, n + 1);
    if (changing)
        ras_head_write(
            rig->head, VIDEO_BASE,
            rig->head->timing.h.visible * (uint32_t)(n * 5 % rig->head->timing.v.visible), t0);
    crt_film_open(rig->tube, &rig->film, t0, t1);
    while (ras_head_next(rig->head) < t1)
        ras_head_event(rig->head, ras_head_next(rig->head));
    crt_tube_advance(rig->tube, t1);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void measure(const char *tube, const char *mode, bool changing, enum crt_simd simd,
                    int threads)
{
    struct rig rig;
    double took[FIELDS];
    if (!set_up(&rig, tube, mode, simd, threads))
        return;
    for (uint64_t n = 0; n < WARM + FIELDS; n++) {
        double start = threads > 1 ? bench_wall_seconds() : bench_seconds();
        field(&rig, n, changing);
        if (n >= WARM)
            took[n - WARM] = (threads > 1 ? bench_wall_seconds() : bench_seconds()) - start;
    }
    qsort(took, FIELDS, sizeof took[0], by_size);
    double period = (double)rig.field.den / (double)rig.field.num, median = took[FIELDS / 2];
    size_t cells = (size_t)rig.film.grid.cols * (size_t)rig.film.grid.rows;
    printf("raster: %-8s %-13s %-8s %-8s %d thread%s  %5.2f x real time (best %5.2f), %.2f ns a "
           "cell and gun\n",
           tube, mode, changing ? "changing" : "static",
           simd == CRT_SIMD_BASELINE ? "baseline" : "best", threads, threads > 1 ? "s" : " ",
           period / median, period / took[0],
           median * 1e9 / (double)cells / (double)rig.film.colours);
    tear_down(&rig);
}

int main(void)
{
    static const struct {
        const char *tube, *mode;
    } cases[] = {{"COLOR17", "1024x768@60"}, {"MONO12", "640x480@60"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++)
        for (int changing = 1; changing >= 0; changing--) {
            measure(cases[i].tube, cases[i].mode, changing, CRT_SIMD_BASELINE, 1);
            measure(cases[i].tube, cases[i].mode, changing, CRT_SIMD_AUTO, 1);
            measure(cases[i].tube, cases[i].mode, changing, CRT_SIMD_AUTO, 2);
        }
    return 0;
}
