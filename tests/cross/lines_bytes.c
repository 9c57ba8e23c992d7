/* lines_bytes.c — the films of made-up scan lines as bits: what the cross-compiled comparison runs beside
 * film_bytes.c.
 *
 *      lines_bytes > bytes
 *
 * Links no library but C's.
 */
#include <string.h>

#include "crt/tube.h"
#include "tests/cross/bytes.h"
#include "tests/support/line_model.h"

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
            for (int shift = 24; shift >= 0; shift -= 8)
                putchar((int)(bits >> shift & 255));
        }
    crt_film_free(&film);
    crt_tube_destroy(tube);
    return 0;
}

int main(void)
{
    int status = write_lines(true) + write_lines(false);
    return status == 0 && fflush(stdout) == 0 ? 0 : 1;
}
