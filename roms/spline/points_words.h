/* points_words.h — the words of points_text.h; private to reading and writing.
 *
 * Models:     names in the order of their enumerations.
 * Ownership:  constants.
 * Errors:     none.
 */
#ifndef ROMS_SPLINE_POINTS_WORDS_H
#define ROMS_SPLINE_POINTS_WORDS_H

#include "roms/spline/points_text.h"

extern const char *const points_kinds[MODEL_KINDS];
extern const char *const points_knots[3];
extern const char *const points_joints[JOINTS];

#endif
