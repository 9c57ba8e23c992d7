/* tenths.h — numbers with one decimal, for programs whose printf knows whole numbers only.
 *
 * Models:     rounded to the nearest tenth.
 * Domain:     up to 2·10^8.
 * Units:      the caller's.
 * Ownership:  writes the caller's text.
 * Errors:     what does not fit is cut.
 */
#ifndef ROMS_STAGE_TENTHS_H
#define ROMS_STAGE_TENTHS_H

#include <stdbool.h>
#include <stddef.h>

/* At least so wide; positive ones with a sign, if asked. */
void tenths_text(char *text, size_t size, float value, int width, bool sign);

#endif
