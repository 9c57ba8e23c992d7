/* encode.h — display-file data words from numbers, for the assembler and the disassembler.
 *
 * Deltas are sign-magnitude, so a delta of 0 is written with a positive sign.
 * Errors:     a number outside its range asserts.
 * Source:     DEC EK-VT11-TM-001.
 */
#ifndef DF_ENCODE_H
#define DF_ENCODE_H

#include <stdbool.h>
#include <stdint.h>

#define DF_POINT_MAX 1023
#define DF_LONG_MAX  1023
#define DF_SHORT_MAX 63

uint16_t df_encode_short(bool lit, int32_t dx, int32_t dy); /* short vector, relative point */
uint16_t df_encode_long_x(bool lit, int32_t dx);
uint16_t df_encode_long_y(int32_t dy);
uint16_t df_encode_point_x(bool lit, int32_t x);
uint16_t df_encode_point_y(int32_t y);

#endif
