#include "roms/commands/flat_words.h"

#include <math.h>
#include <stdio.h>

#include "roms/monitor/print.h"

bool flat_window(struct words *w, struct clip_window *out)
{
    float v[4];
    if (!words_amounts(w, v, 4))
        return false;
    if (!(v[0] < v[2] && v[1] < v[3]))
        return words_refuse(w, "a window without an area: xmin < xmax and ymin < ymax are wanted");
    if (v[2] - v[0] < FLAT_LEAST || v[3] - v[1] < FLAT_LEAST)
        return words_refuse(w, "a window is at least %g wide and high", (double)FLAT_LEAST);
    *out = (struct clip_window){v[0], v[1], v[2], v[3]};
    return true;
}

void flat_print(int width, float value)
{
    if (value == rintf(value))
        printf("%*d", width, (int)value);
    else
        printf("%*.4f", width, print_tidy(value));
}

void flat_print_points(const struct point2 *p, int count)
{
    for (int i = 0; i < count; i++) {
        if (i > 0)
            printf(" ");
        print_point2(p[i]);
    }
    printf("\n");
}
