/* line_look.h — looking at scan lines without changing anything: luminance at a point, and totals.
 *
 * Models:     as crt/line_beam.h, integrated over time in double precision.
 * Units:      mm, ps; cd/m², cd·s/m².
 * Accuracy:   1e-4 of the brightest.
 * Ownership:  nothing is kept.
 * Errors:     totals are NaN when memory is out.
 */
#ifndef CRT_LINE_LOOK_H
#define CRT_LINE_LOOK_H

#include "crt/tube_parts.h"

/* Adds the luminance at a point at time t of lines of a list drawn between `from` and `to`, by the
 * phosphor's terms of `mask`. */
void crt_lines_look(const struct crt_tube *tube, const struct crt_line_list *list, double x_mm,
                    double y_mm, uint64_t t, uint64_t from, uint64_t to, uint32_t mask,
                    double cd_m2[CRT_MAX_COLOURS]);

/* Light that lines still hold at the last advance, summed over the cells of the grid. */
double crt_lines_stored(const struct crt_tube *tube);

#endif
