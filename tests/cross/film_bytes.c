/* film_bytes.c — a display file in, its film's bytes out: what the cross-compiled comparison runs.
 *
 *      film_bytes FILE.oct TUBE AT_PS THREADS > bytes
 *      film_bytes lines > bytes        (scan lines of a colour tube, float samples)
 *
 * Writes what SHA-256 is taken of (width, height, depth, big-endian samples), so that `sha256sum` of it must
 * equal `kinescope capture --film --hash`. Links neither libpng, GL, inih nor nettle, so that it can be built for any
 * machine with nothing but a C library.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "crt/develop.h"
#include "display_file/loaders.h"
#include "emu/machine.h"
#include "tests/support/line_model.h"

static void put32(uint32_t v)
{
    putchar((int)(v >> 24 & 255));
    putchar((int)(v >> 16 & 255));
    putchar((int)(v >> 8 & 255));
    putchar((int)(v & 255));
}

static int die(const char *sentence)
{
    fprintf(stderr, "film_bytes: %s\n", sentence);
    return 1;
}

static char *slurp(const char *path, size_t *length)
{
    FILE *in = fopen(path, "rb");
    if (in == NULL)
        return NULL;
    char *text = malloc(1u << 22);
    *length = text != NULL ? fread(text, 1, 1u << 22, in) : 0;
    fclose(in);
    return text;
}

/* Two fields of a colour tube and of a white one whose spot grows, out of focus at the edges, as the bits
 * of the second field's film. */
static int write_lines(bool colour)
{
    static uint8_t dots[3][300];
    struct crt_tube_row row =
        colour ? line_model_colour_row(80, 60, 0.445) : line_model_row(80, 60, 0.45);
    struct crt_phosphor p22 = line_model_p22();
    const struct crt_phosphor *phosphor = colour ? &p22 : crt_phosphor_find("P4");
    const uint64_t field = CRT_PS_PER_S / 60;
    struct crt_error err;
    struct crt_film film;
    uint32_t seed = 1;
    row.spot_edge.value = 1.3;
    row.converge_edge.value = colour ? 0.2 : 0;
    row.spot_growth.value = colour ? 0 : 0.1;
    struct crt_tube *tube = crt_tube_create(&(struct crt_tube_desc){.row = &row,
                                                                    .phosphor = phosphor,
                                                                    .grid = crt_tube_grid(&row),
                                                                    .epoch = {60, 1},
                                                                    .knobs = {0.02, 0.9, 0.1},
                                                                    .threads = 2},
                                            &err);
    if (tube == NULL || !crt_film_init(&film, tube, &err))
        return die(err.text);
    for (uint64_t n = 0; n < 400; n++) {
        if (n == 200) {
            crt_tube_advance(tube, field);
            crt_film_open(tube, &film, field, 2 * field - 7000000000);
        }
        for (int i = 0; i < 900; i++) {
            seed = seed * 1664525 + 1013904223;
            dots[i / 300][i % 300] = (uint8_t)(seed >> 24);
        }
        const uint64_t t0 = n / 200 * field + 300000000 + n % 200 * 70000000;
        const float y = 30 - 0.3F * ((float)(n % 200) + 0.5F);
        crt_tube_scan_line(tube, &(struct crt_scan_line){t0,
                                                         t0 + 15000000,
                                                         -40,
                                                         y,
                                                         40,
                                                         y,
                                                         300,
                                                         colour ? 3 : 1,
                                                         {dots[0], dots[1], dots[2]},
                                                         (uint32_t)n});
    }
    crt_tube_advance(tube, 2 * field);
    const size_t cells = (size_t)film.grid.cols * (size_t)film.grid.rows;
    for (int c = 0; c < film.colours; c++)
        for (size_t i = 0; i < cells; i++) {
            uint32_t bits;
            memcpy(&bits, &film.light[c][i], sizeof bits);
            put32(bits);
        }
    crt_film_free(&film);
    crt_tube_destroy(tube);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "lines") == 0)
        return write_lines(true) || write_lines(false) || fflush(stdout) != 0;
    struct crt_error err;
    size_t length = 0;
    if (argc != 5)
        return die("usage: film_bytes FILE.oct TUBE AT_PS THREADS");
    const struct crt_tube_row *row = crt_tube_row_find(argv[2]);
    char *text = slurp(argv[1], &length);
    if (row == NULL || text == NULL)
        return die("no such tube or file");
    const struct crt_phosphor *phosphor = crt_phosphor_find(row->phosphor);
    const uint64_t at = strtoull(argv[3], NULL, 10);
    const struct crt_rate tick = {(uint64_t)row->sync.value, 1};

    struct df_program program;
    if (!df_program_init(&program, &err) || !df_load_oct(argv[1], text, length, &program, &err))
        return die(err.text);
    struct crt_tube *tube = crt_tube_create(&(struct crt_tube_desc){.row = row,
                                                                    .phosphor = phosphor,
                                                                    .grid = crt_tube_grid(row),
                                                                    .epoch = tick,
                                                                    .knobs = {0, 1, 0},
                                                                    .threads = atoi(argv[4])},
                                            &err);
    struct vm_machine *machine = malloc(sizeof *machine);
    struct crt_film film;
    if (tube == NULL || machine == NULL || !crt_film_init(&film, tube, &err))
        return die("out of memory");
    vm_machine_init(machine,
                    &(struct vm_machine_desc){.row = row,
                                              .timing = df_timing_of_tube(row, DF_TIMING_VALUE),
                                              .tick = tick,
                                              .memory_bytes = DF_ADDRESS_SPACE,
                                              .tube = tube});
    if (!vm_machine_load(machine, &program, argv[1], &err))
        return die(err.text);
    const uint64_t exposure = crt_tick_time(tick, 1);
    vm_machine_run(machine, at - exposure);
    crt_film_open(tube, &film, at - exposure, at);
    vm_machine_run(machine, at);

    struct crt_image image;
    if (!crt_develop(&film, phosphor, crt_auto_gain(row), 16, 1, &image, &err))
        return die(err.text);
    put32((uint32_t)image.width);
    put32((uint32_t)image.height);
    put32(16);
    const size_t samples = (size_t)image.width * (size_t)image.height * 3;
    for (size_t i = 0; i < samples; i++) {
        putchar(image.samples[i] >> 8);
        putchar(image.samples[i] & 255);
    }
    crt_image_free(&image);
    crt_film_free(&film);
    crt_tube_destroy(tube);
    df_program_free(&program);
    free(machine);
    free(text);
    return fflush(stdout) == 0 ? 0 : die("could not write");
}
