/* encode.h — display-file data words from numbers, for the assembler and the disassembler.
 *
 * Models:     the data formats of the VT11. Deltas are sign-magnitude: one of 0 is written with a
 *             positive sign.
 * Units:      head units.
 * Ownership:  values in, values out.
 * Errors:     a number outside its range asserts: callers check what users write.
 * Source:     DEC EK-VT11-TM-001.
 * Not modelled: negative zero and bits without meaning, which no number says.
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
