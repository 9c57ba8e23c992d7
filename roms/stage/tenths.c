#include "roms/stage/tenths.h"

#include <stdio.h>
#include <stdlib.h>

#include "roms/geometry/scalar.h"

void tenths_text(char *text, size_t size, float value, int width, bool sign)
{
    char number[24];
    int tenths = scalar_nearest(value * 10);
    snprintf(number, sizeof number, "%s%d.%d",
             tenths < 0 ? "-"
             : sign     ? "+"
                        : "",
             abs(tenths) / 10, abs(tenths) % 10);
    snprintf(text, size, "%*s", width, number);
}
