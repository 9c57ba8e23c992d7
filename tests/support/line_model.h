/* line_model.h — rows for tests of scan lines, and a slow exact raster tube to compare with.
 *
 * Models:     light at one point as the integral over time of a Gaussian spot whose place, width and
 *             current follow from the row's figures, times the share of it that is emitted during the
 *             exposure; composite Gauss-Legendre in double precision with the C library's functions.
 *             Nothing is shared with crt/ but the row's figures.
 */
#ifndef LINE_MODEL_H
#define LINE_MODEL_H

#include "crt/tube.h"

/* A raster tube of width × height mm with one gun, gun exponent 2.5, 100 cd/m² at a duty of 0.7. */
struct crt_tube_row line_model_row(double width_mm, double height_mm, double spot_mm);
/* The same with three guns in a triangle. */
struct crt_tube_row line_model_colour_row(double width_mm, double height_mm, double spot_mm);

/* Three colours as the P22 of colour tubes, terms of 1 ms at most. */
struct crt_phosphor line_model_p22(void);

struct line_model {
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    struct crt_knobs knobs;
};

/* Light at (x, y) mm between a and b, of one colour, cd·s/m². */
double line_model_light(const struct line_model *model, const struct crt_scan_line *lines,
                        int count, int colour, double x, double y, uint64_t a, uint64_t b);

/* Power of a gun, cd·mm²/m². */
double line_model_power(const struct line_model *model, int gun);

#endif
