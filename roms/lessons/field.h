/* field.h — fields over a square that are computed step by step: waves and heat.
 *
 *      u(t+1) = 2 u(t) − u(t−1) + c² ∇²u − damping      waves
 *      u(t+1) = u(t) + k ∇²u                            heat
 *
 * Models:     the wave equation with sources that swing and a rim that takes waves in; the heat
 *             equation with hot spots and a cold rim. ∇² by the four neighbours.
 * Cost:       about 20 instructions a point and step; FIELD_RATE steps a second.
 * Domain:     FIELD_SIDE by FIELD_SIDE points; c² = 0.25 and k = 0.2 are stable (below ½ and ¼).
 * Units:      steps; heights about −1…1, heat 0…1.
 * Ownership:  plain value of 13 KB.
 * Errors:     none.
 * Source:     R. Courant, K. Friedrichs, H. Lewy, Mathematische Annalen 100 (1928) 32, for when it
 *             is stable.
 * Not modelled: obstacles other than the wall with two gaps.
 */
#ifndef ROMS_LESSONS_FIELD_H
#define ROMS_LESSONS_FIELD_H

#include <stdbool.h>

enum { FIELD_SIDE = 33, FIELD_RATE = 40 };
enum field_kind { FIELD_SOURCES, FIELD_SLITS, FIELD_HEAT, FIELDS };

struct field {
    enum field_kind kind;
    int steps; /* done */
    float now[FIELD_SIDE][FIELD_SIDE], before[FIELD_SIDE][FIELD_SIDE];
    float damping[FIELD_SIDE][FIELD_SIDE]; /* of waves: grows toward the rim */
};

void field_begin(struct field *f, enum field_kind kind);
void field_step(struct field *f);
/* Steps on to so many seconds; at most a second's at once. */
void field_until(struct field *f, float seconds);
/* Between which heights it will be shown. */
float field_low(const struct field *f);
float field_high(const struct field *f);
/* A point that is a wall. */
bool field_is_wall(const struct field *f, int row, int column);

#endif
