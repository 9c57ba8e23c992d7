/* areas.c — commands about areas and the attributes of lines and text. */
#include "roms/commands/areas.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "roms/monitor/command.h"

struct areas_box areas_box(const struct point2 *p, int count)
{
    float left = p[0].x, right = left, low = p[0].y, high = low;
    for (int i = 1; i < count; i++) {
        left = fminf(left, p[i].x);
        right = fmaxf(right, p[i].x);
        low = fminf(low, p[i].y);
        high = fmaxf(high, p[i].y);
    }
    return (struct areas_box){(int)floorf(left), (int)floorf(low), (int)ceilf(right),
                              (int)ceilf(high)};
}

void areas_add(char *text, size_t room, const char *format, ...)
{
    size_t length = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + length, room - length, format, list);
    va_end(list);
}

const struct command commands_areas[] = {
    {"fill", "even-odd|non-zero x y x y x y ...", "fills a polygon by its active edges",
     areas_fill},
    {"boundary", "4|8 x y in x y x y x y ...", "fills from a seed to a polygon's boundary",
     areas_boundary},
    {"flood", "4|8 x y in x y x y x y ...", "gives what is connected with a seed its colour",
     areas_flood},
    {"dashed", "DASH GAP ... at x y x y ...", "a polyline of dashes", areas_dashed},
    {"thick", "WIDTH butt|square|round bevel|miter|round [closed] x y x y ...",
     "a polyline with a width, caps and joins", areas_thick},
    {"antialias", "x0 y0 x1 y1", "a line whose pixels are as light as it covers them",
     areas_antialias},
    {"text", "WIDTH HEIGHT right|up|left|down WORDS ...", "characters of that size and direction",
     areas_text},
    {"dither", "LEVELS", "a ramp of intensities from few levels", areas_dither},
    {NULL, NULL, NULL, NULL},
};
