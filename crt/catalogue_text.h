/* catalogue_text.h — the tables of tubes and phosphors as text of at most 100 columns.
 *
 * Models:     nothing. Briefly, tubes are a table a kind. `why` prints every figure with its range
 *             and source: for tubes all that they have of CRT_TUBE_FIGURES, for phosphors the terms, both published persistences beside the
 *             model's own times, and the notes.
 * Units:      printed with each figure.
 * Ownership:  nothing is kept; the stream stays the caller's.
 * Errors:     none; the caller looks at ferror() of its stream.
 */
#ifndef CRT_CATALOGUE_TEXT_H
#define CRT_CATALOGUE_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include "crt/tube_table.h"

void crt_list_tubes(FILE *to, const struct crt_catalogue *c, bool why);
void crt_list_phosphors(FILE *to, const struct crt_catalogue *c, bool why);

/* One row of it, as `why` prints it. */
void crt_explain_tube(FILE *to, const struct crt_tube_row *row);
void crt_explain_phosphor(FILE *to, const struct crt_phosphor *p);

/* "340 us": three significant digits with a unit of time; "-" for 0, which means not published. */
void crt_time_text(char *to, size_t size, double seconds);

#endif
