/* number_text.h — numbers to and from decimal text, the same on every host and in every locale.
 *
 * Read:       whole fields only: the text must be the number and nothing else.
 * Floats:     [-+]digits[.digits][e[-+]digits]; the result is finite. Nine significant digits as
 *             written here read back to the same float; longer text may be off by the last bit of a
 *             float when it lies on the middle between two.
 * Errors:     false, and *value is left alone.
 */
#ifndef CRT_NUMBER_TEXT_H
#define CRT_NUMBER_TEXT_H

#include <stdbool.h>
#include <stdint.h>

#define CRT_FLOAT_TEXT 24 /* characters crt_float_write may need, the NUL included */

bool crt_float_read(const char *text, float *value);
bool crt_decimal_read(const char *text, uint64_t *value);
bool crt_octal_read(const char *text, uint32_t *value);

/* Nine significant digits, as "%.9g" in the C locale. `value` is finite. */
void crt_float_write(char text[CRT_FLOAT_TEXT], float value);

#endif
