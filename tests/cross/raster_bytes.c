/* raster_bytes.c — firmware in, the film of its raster head out: what the cross-compiled comparison runs beside
 * film_bytes.c.
 *
 *      raster_bytes FILE.elf TUBE AT_PS THREADS > bytes
 *
 * As `kinescope capture FILE.elf --view raster --tube TUBE --film --hash` takes SHA-256 of. Links no library
 * but C's, so the tube's mode must be one of the table.
 */
#include <string.h>

#include "crt/develop.h"
#include "emu/machine.h"
#include "tests/cross/bytes.h"

static const struct ras_mode *mode_of(const struct crt_tube_row *row)
{
    size_t count;
    const struct ras_mode *modes = ras_modes(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(modes[i].name, row->mode) == 0)
            return &modes[i];
    return NULL;
}

static bool film_of(struct vm_machine *m, struct crt_tube *tube, uint64_t at,
                    const struct crt_tube_row *row, struct crt_image *image, struct crt_error *err)
{
    struct crt_film film;
    const struct ras_timing *timing = &m->desc.raster_timing;
    uint64_t exposure = crt_tick_time(ras_field_rate(timing), timing->interlaced ? 2 : 1);
    if (!crt_film_init(&film, tube, err))
        return false;
    vm_machine_run(m, at - exposure);
    crt_film_open(tube, &film, at - exposure, at);
    vm_machine_run(m, at);
    bool ok =
        crt_develop(&film, crt_phosphor_find(row->phosphor), crt_auto_gain(row), 16, 1, image, err);
    crt_film_free(&film);
    return ok;
}

int main(int argc, char **argv)
{
    struct crt_error err;
    struct crt_image image;
    struct vm_elf elf;
    size_t length = 0;
    if (argc != 5)
        return die("usage: raster_bytes FILE.elf TUBE AT_PS THREADS");
    const struct crt_tube_row *vector = crt_tube_row_find("VR17"),
                              *row = crt_tube_row_find(argv[2]);
    const struct ras_mode *mode = row ? mode_of(row) : NULL;
    char *bytes = slurp(argv[1], &length);
    struct vm_machine *m = malloc(sizeof *m);
    uint8_t *buffer = calloc(1, VIDEO_BUFFER_BYTES);
    if (!mode || !bytes || !m || !buffer ||
        !vm_elf_parse(&elf, argv[1], (const uint8_t *)bytes, length, &err))
        return die("no such tube, mode or program");
    struct vm_board *board = vm_board_create((struct crt_rate){VM_CPU_HZ, 1}, NULL, &err);
    struct crt_tube *tube =
        crt_tube_create(&(struct crt_tube_desc){.row = row,
                                                .phosphor = crt_phosphor_find(row->phosphor),
                                                .grid = crt_tube_grid(row),
                                                .epoch = ras_field_rate(&mode->timing),
                                                .knobs = {0, 1, 0},
                                                .threads = atoi(argv[4])},
                        &err);
    if (!board || !tube)
        return die(err.text);
    vm_machine_init(m,
                    &(struct vm_machine_desc){.row = vector,
                                              .timing = df_timing_of_tube(vector, DF_TIMING_VALUE),
                                              .tick = {(uint64_t)vector->sync.value, 1},
                                              .memory_bytes = DF_ADDRESS_SPACE,
                                              .board = board,
                                              .buffer = buffer,
                                              .raster_row = row,
                                              .raster_timing = mode->timing,
                                              .raster_tube = tube});
    if (!vm_machine_boot(m, &elf, NULL, argv[1], &err) ||
        !film_of(m, tube, strtoull(argv[3], NULL, 10), row, &image, &err))
        return die(err.text);
    bool written = put_image(&image);
    crt_image_free(&image);
    crt_tube_destroy(tube);
    vm_board_destroy(board);
    vm_elf_free(&elf);
    free(buffer);
    free(m);
    free(bytes);
    return written ? 0 : die("could not write");
}
