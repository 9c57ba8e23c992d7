/* table.h — the drawing as comma-separated values, with what it was measured with.
 *
 *      # tablet sonic, 0.100 mm a count, 60.00 reports a second, lost 0
 *      # paper affine, 3 points, residual 0.000 mm rms, 0.1000 mm a count, turned 10.0 deg
 *      line,point,x_mm,y_mm,z_mm,samples,s_mm,gap
 *      1,1,12.345,40.002,0.100,18,0.052,0
 *      # line 1: 61 points, closed, gaps 0, length 512.31 mm, area 12345.6 mm2
 *
 * Models:     lines that begin with # are remarks; z and 3-D length are of heights.
 * Units:      as the heading says. Points alone are lines of one point.
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_DIGITISE_TABLE_H
#define ROMS_DIGITISE_TABLE_H

#include "roms/digitise/session.h"

enum { TABLE_LINE = 160 };

/* Hands over line after line, each with its end. */
void table_write(const struct session *session, void (*put)(void *ctx, const char *line),
                 void *ctx);
/* electrical, sonic, … */
const char *table_kind(unsigned kind);

#endif
