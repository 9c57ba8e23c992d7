/* film_bytes.c — a display file in, its film's bytes out: what the cross-compiled comparison runs.
 *
 *      film_bytes FILE.oct TUBE AT_PS THREADS > bytes
 *
 * Writes what SHA-256 is taken of (width, height, depth, big-endian samples), so that `sha256sum` of it must
 * equal `kinescope capture --film --hash`. Links neither libpng, GL, inih nor nettle, so that it can be built for any
 * machine with nothing but a C library.
 */
#include "crt/develop.h"
#include "display_file/loaders.h"
#include "emu/machine.h"
#include "tests/cross/bytes.h"

int main(int argc, char **argv)
{
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
                                              .personality = row->penetration ? DF_VS60 : DF_VT11,
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
    bool written = put_image(&image);
    crt_image_free(&image);
    crt_film_free(&film);
    crt_tube_destroy(tube);
    df_program_free(&program);
    free(machine);
    free(text);
    return written ? 0 : die("could not write");
}
