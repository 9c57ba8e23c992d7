/* large_text.h — text that can be read from the back of a room.
 *
 * Models:     characters twice as large on the raster head; on the vector head the one size that
 *             its character generator has. Numbers and matrices made of them.
 * Units:      stage units (roms/stage/stage.h); a character takes LARGE_ADVANCE on the raster head.
 * Ownership:  nothing.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_LARGE_TEXT_H
#define ROMS_LESSONS_LARGE_TEXT_H

#include "roms/geometry/matrix3.h"
#include "roms/stage/stage.h"

enum { LARGE_ADVANCE = 31, LARGE_LINE = 56, LARGE_MATRIX_WIDTH = 530 };

/* Base line begins at x, y; about x. */
void large_text(struct stage *stage, float x, float y, const char *text);
void large_text_middle(struct stage *stage, float x, float y, const char *text);
/* Its first row's base line is at y; x: its left bracket. */
void large_matrix3(struct stage *stage, float x, float y, const struct matrix3 *m);

#endif
