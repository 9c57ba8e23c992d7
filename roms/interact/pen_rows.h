/* pen_rows.h — where a light pen on the raster head looks, from all its firings in a field.
 *
 *      · · ▔▔▔ · ·     first row that it sees: a short piece; whether it fires there depends on the spot
 *      · ▔▔▔▔▔▔▔ ·
 *      ▔▔▔▔▔▔▔▔▔▔▔     middle row: the line; here it fires at the left end of a long piece: the dot
 *      · ▔▔▔▔▔▔▔ ·
 *      · · ▔▔▔ · ·     last row
 *
 * Models:     the beam lights the rows that the pen sees one after the other, and the pen fires in each
 *             that is bright enough: the middle of first and last is the line; the dot is the mean of
 *             the rows about it. A pen that is too slow for that fires in the first row only, and that
 *             is all there is to go by.
 * False ones: a firing far from the others, which room light makes, is not of them: the longest run of
 *             neighbouring rows counts.
 * Units:      lines, dots.
 * Ownership:  plain value.
 * Errors:     firings that have no room are left out.
 */
#ifndef ROMS_INTERACT_PEN_ROWS_H
#define ROMS_INTERACT_PEN_ROWS_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/bsp/input.h"

enum { PEN_ROWS = 64 };

struct pen_rows {
    unsigned count;
    uint32_t field;
    uint16_t line[PEN_ROWS], dot[PEN_ROWS]; /* in the order of time */
};

/* False: the firing is of another field than those before it; it is not taken. */
bool pen_rows_add(struct pen_rows *rows, const struct pen_hit *hit);
/* False: there are no firings. *seen: rows in which it fired; may be NULL. */
bool pen_rows_middle(const struct pen_rows *rows, float *line, float *dot, unsigned *seen);

#endif
