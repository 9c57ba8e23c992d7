/* white.h — white balance: how much of the light each gun of a colour tube must give.
 *
 * Models:     additive mixture: the shares of luminance of three primaries that together are D65.
 * Units:      shares of luminance, sum 1.
 * Source:     CIE 1931; D65 x = 0.3127, y = 0.3290 (ISO/CIE 11664-2).
 * Ownership:  plain values.
 * Errors:     false when the primaries cannot mix D65 (a share would be negative).
 * Not modelled: warmer and colder whites (9300 K).
 */
#ifndef CRT_WHITE_H
#define CRT_WHITE_H

#include <stdbool.h>

#include "crt/phosphor.h"

#define CRT_D65_X 0.3127
#define CRT_D65_Y 0.3290

/* Of the three colours of a phosphor. */
bool crt_white_shares(const struct crt_phosphor *phosphor, double share[3]);

#endif
