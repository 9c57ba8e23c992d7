/* areas.c — commands about areas and the attributes of lines and text. */
#include "roms/commands/areas.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "roms/monitor/command.h"

bool areas_points(struct words *w, struct point2 *p, int least, int most, float limit, int *count)
{
    int left = words_left(w);
    if (left % 2 != 0 && words_next_is_number(w))
        return words_refuse(w, "a point takes two numbers, and there are %d", left);
    if (left / 2 < least)
        return words_refuse(w, "at least %d points are needed", least);
    if (left / 2 > most)
        return words_refuse(w, "at most %d points can be taken", most);
    *count = left / 2;
    for (int i = 0; i < *count; i++) {
        if (!words_number(w, &p[i].x) || !words_number(w, &p[i].y))
            return false;
        if (p[i].x < -limit || p[i].x > limit || p[i].y < -limit || p[i].y > limit)
            return words_refuse(w, "point %d is not within -%d and %d", i + 1, (int)limit,
                                (int)limit);
    }
    return true;
}

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
