/* Speed of the raster head: dots scanned out a second, each format, on three guns and one; and what a
 * simulated second of it costs when nobody looks. 1024x768@60, random pixels. */
#include <stdio.h>
#include <stdlib.h>

#include "raster/head.h"
#include "tests/support/bench.h"

#define FIELDS 40
#define BLOCKS 7 /* of which the best is told: the machine is seldom alone */

static uint64_t dots;

static void see(void *ctx, const struct crt_scan_line *line)
{
    (void)ctx;
    dots += (uint64_t)line->dots;
}

/* Seconds that `fields` fields take. */
static double run(struct ras_head *head, uint64_t fields)
{
    uint64_t end = ras_head_next(head) + crt_tick_time(ras_field_rate(&head->timing), fields);
    double start = bench_seconds();
    while (ras_head_next(head) < end)
        ras_head_event(head, ras_head_next(head));
    return bench_seconds() - start;
}

static double best(struct ras_head *head)
{
    double least = 1e18;
    for (int i = 0; i < BLOCKS; i++) {
        double took = run(head, FIELDS);
        least = took < least ? took : least;
    }
    return least;
}

static void scan(uint8_t *buffer, int guns, uint32_t format, bool looks)
{
    static struct ras_head head;
    struct crt_error err;
    struct ras_head_desc desc = {.buffer = buffer,
                                 .width_mm = 280,
                                 .height_mm = 210,
                                 .border_mm = 5,
                                 .guns = guns,
                                 .monitor = {0, 200, 0, 200, 200},
                                 .wires = {.line = looks ? see : NULL}};
    if (!ras_mode_parse("1024x768@60", &desc.timing, &err))
        return;
    ras_head_init(&head, &desc);
    ras_head_write(&head, VIDEO_FORMAT, format, 0);
    ras_head_write(&head, VIDEO_PITCH, 1024 * format / 8, 0);
    ras_head_write(&head, VIDEO_CONTROL, VIDEO_CONTROL_ON, 0);
    dots = 0;
    double took = best(&head);
    if (looks)
        printf("scan: %2u bits, %d gun%s %6.2f Gdots/s, %5.2f %% of a processor at 60 Hz\n", format,
               guns, guns > 1 ? "s" : " ", (double)dots / BLOCKS / took / 1e9,
               100 * took * 60 / FIELDS);
    else
        printf("scan: nobody looks     %6.0f simulated seconds a second\n", FIELDS / 60.0 / took);
}

int main(void)
{
    static const uint32_t formats[] = {1, 2, 4, 8, 16, 24, 32};
    uint8_t *buffer = malloc(VIDEO_BUFFER_BYTES);
    uint32_t seed = 1;
    if (!buffer)
        return 1;
    for (uint32_t i = 0; i < VIDEO_BUFFER_BYTES; i++) {
        seed = seed * 1664525u + 1013904223u;
        buffer[i] = (uint8_t)(seed >> 24);
    }
    for (int guns = 3; guns >= 1; guns -= 2)
        for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++)
            scan(buffer, guns, formats[i], true);
    scan(buffer, 3, 8, false);
    free(buffer);
    return 0;
}
