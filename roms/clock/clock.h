/* clock.h — the parts of a clock's picture.
 *
 * Models:     a dial with Roman numerals; hour, minute and second hand; a counter of hours.
 * Position:   head units about CLOCK_X, CLOCK_Y. Angles: turns, clockwise from 12.
 * Time:       seconds since midnight or noon.
 * Ownership:  draws with the caller's writer.
 * Errors:     none.
 * Source:     numerals stand radially, four is IIII, as on tower clocks.
 */
#ifndef ROMS_CLOCK_CLOCK_H
#define ROMS_CLOCK_CLOCK_H

#include "roms/bsp/display.h"

#define CLOCK_X 512
#define CLOCK_Y 512

/* A place: `along` units from the centre toward `turn`, `across` units clockwise of that. */
struct clock_place {
    float turn, along, across;
};

void clock_at(struct display *d, float turn, float along, float across);
void clock_line(struct display *d, float turn, float along, float across);
/* A circle about a place. */
void clock_ring(struct display *d, struct clock_place centre, float radius, int sides);

void clock_dial(struct display *d);
/* `seconds` since 12 o'clock, with the fraction in which the second hand swings. */
void clock_hands(struct display *d, unsigned seconds, float fraction);

#endif
