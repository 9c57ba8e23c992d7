#include "roms/commands/flat_words.h"

#include <math.h>
#include <stdio.h>

#include "roms/monitor/print.h"

bool flat_numbers(struct words *w, float *out, int count)
{
    if (!words_numbers(w, out, count))
        return false;
    for (int i = 0; i < count; i++)
        if (!(fabsf(out[i]) <= FLAT_MOST))
            return words_refuse(w, "%g is beyond +-%d", (double)out[i], FLAT_MOST);
    return true;
}

bool flat_point(struct words *w, struct point2 *out)
{
    float v[2];
    if (!flat_numbers(w, v, 2))
        return false;
    *out = (struct point2){v[0], v[1]};
    return true;
}

bool flat_window(struct words *w, struct clip_window *out)
{
    float v[4];
    if (!flat_numbers(w, v, 4))
        return false;
    if (!(v[0] < v[2] && v[1] < v[3]))
        return words_refuse(w, "a window without an area: xmin < xmax and ymin < ymax are wanted");
    if (v[2] - v[0] < FLAT_LEAST || v[3] - v[1] < FLAT_LEAST)
        return words_refuse(w, "a window is at least %g wide and high", (double)FLAT_LEAST);
    *out = (struct clip_window){v[0], v[1], v[2], v[3]};
    return true;
}

bool flat_points(struct words *w, struct point2 *out, int fewest, int *count)
{
    int n = 0;
    for (; words_left(w) > 0; n++) {
        if (n == FLAT_POINTS)
            return words_refuse(w, "at most %d points", FLAT_POINTS);
        if (!flat_point(w, &out[n]))
            return false;
    }
    if (n < fewest)
        return words_refuse(w, "at least %d point%s wanted", fewest, fewest > 1 ? "s are" : " is");
    *count = n;
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
