/* flat_words.h — what the commands of the plane take and print alike.
 *
 * Models:     windows as words; figures as short as they are exact.
 * Domain:     coordinates within ±WORDS_FARTHEST, so that single precision keeps five figures and
 *             nothing overflows.
 * Ownership:  plain values.
 * Errors:     as words.h: false, and a sentence is left.
 */
#ifndef ROMS_COMMANDS_FLAT_WORDS_H
#define ROMS_COMMANDS_FLAT_WORDS_H

#include "roms/clip/window.h"
#include "roms/monitor/words.h"

enum { FLAT_POINTS = 97 /* that a command of WORDS_MOST words has room for */ };

#define FLAT_LEAST 0.001f /* a window, across and up */

/* xmin ymin xmax ymax with an area. */
bool flat_window(struct words *w, struct clip_window *out);
/* A whole number as one, others with four decimals; `width` characters. */
void flat_print(int width, float value);
/* "(1.0000,2.0000)" one after the other on a line. */
void flat_print_points(const struct point2 *points, int count);

#endif
