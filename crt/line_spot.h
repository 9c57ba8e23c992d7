/* line_spot.h — the spot of scan lines along the line: kernels from dots to columns; private to the files
 * of lines.
 *
 * Models:     what the moments of a dot's current (crt/line_beam.h) give at a column, for the cut spot:
 *             its integrals in closed form, tabled by phase and by sigma.
 * Units:      dots, sigma; CRT_KERNEL_BITS of a whole number.
 * Ownership:  crt_line_spot_new allocates, crt_line_spot_free frees; levels belong to the spot.
 * Errors:     NULL or false when memory is out.
 */
#ifndef CRT_LINE_SPOT_H
#define CRT_LINE_SPOT_H

#include "crt/line_beam.h"

struct crt_line_spot *crt_line_spot_new(double sigma_mm, double pitch_mm);
void crt_line_spot_free(struct crt_line_spot *spot); /* NULL is no spot */
/* Makes the kernels of a level, unless they are there. */
bool crt_line_spot_level(struct crt_line_spot *spot, int index);

#endif
