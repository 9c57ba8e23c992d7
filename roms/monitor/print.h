/* print.h — numbers, points and matrices on the console.
 *
 * Models:     four decimals, and no minus before a zero. Of what commands print, a sentence begins
 *             with a capital and ends with a full stop; figures and what is said of them do neither.
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_MONITOR_PRINT_H
#define ROMS_MONITOR_PRINT_H

#include "roms/geometry/matrix3.h"
#include "roms/geometry/matrix4.h"

/* 0 for what four decimals show as 0; else the value. For printf("%9.4f"). */
double print_tidy(float value);
/* … for what so many decimals, up to 9, show as 0. */
double print_tidy_to(float value, int decimals);
/* A row a line; four decimals in columns. `name` stands before the first row; may be "". */
void print_matrix3(const char *name, const struct matrix3 *m);
void print_matrix4(const char *name, const struct matrix4 *m);
/* "(5.7600,4.0000)": without the end of the line. */
void print_point2(struct point2 p);
void print_vector3(struct vector3 p);

#endif
