/* arithmetic.c — calc: the arithmetic of displays, with its formula. */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "roms/monitor/command.h"

#define MOST 1e9f

/* Numbers above 0, up to MOST. */
static bool amounts(struct words *w, float *out, int count)
{
    for (int i = 0; i < count; i++) {
        if (!words_number(w, &out[i]))
            return false;
        if (!(out[i] > 0 && out[i] <= MOST))
            return words_refuse(w, "numbers here are above 0, up to 1000000000");
    }
    return true;
}

static void print_bytes(double bits)
{
    double bytes = bits / 8;
    printf("= %.0f bytes", bytes);
    if (bytes >= 1048576)
        printf(" = %.4f MB of 1048576", bytes / 1048576);
    printf("\n");
}

/* The beam needs a part of the time to return. A float may lie a little below the number meant. */
static bool refresh(struct words *w)
{
    float v[2], part = 0.95f;
    if (!amounts(w, v, 2) || (words_left(w) > 0 && !amounts(w, &part, 1)) || !words_end(w))
        return false;
    double rate = (double)v[0] / v[1] * part;
    printf("line rate / lines x part = %.0f / %.0f x %.4f = %.4f Hz, rounded down %.0f\n",
           (double)v[0], (double)v[1], (double)part, rate, floor(rate * (1 + FLT_EPSILON)));
    return true;
}

static bool buffer(struct words *w)
{
    float v[3];
    if (!amounts(w, v, 3) || !words_end(w))
        return false;
    printf("width x height x bits / 8 = %.0f x %.0f x %.0f / 8\n", (double)v[0], (double)v[1],
           (double)v[2]);
    print_bytes((double)v[0] * v[1] * v[2]);
    return true;
}

static bool screen(struct words *w)
{
    float v[4];
    if (!amounts(w, v, 4) || !words_end(w))
        return false;
    printf("(%g x %.0f) x (%g x %.0f) x %.0f bits / 8\n", (double)v[0], (double)v[2], (double)v[1],
           (double)v[2], (double)v[3]);
    print_bytes((double)v[0] * v[2] * ((double)v[1] * v[2]) * v[3]);
    return true;
}

static bool load(struct words *w)
{
    float v[4];
    if (!amounts(w, v, 4) || !words_end(w))
        return false;
    printf("width x height x bits / rate = %.0f x %.0f x %.0f / %.0f = %.4f s\n", (double)v[0],
           (double)v[1], (double)v[2], (double)v[3], (double)v[0] * v[1] * v[2] / v[3]);
    return true;
}

static bool display_list(struct words *w)
{
    float v[2];
    if (!amounts(w, v, 2) || !words_end(w))
        return false;
    printf("1 / (refreshes a second x time of an instruction) = 1 / (%g x %g us) = %.0f\n",
           (double)v[1], (double)v[0], floor(1e6 / ((double)v[0] * v[1])));
    return true;
}

static bool calc(struct monitor *m, struct words *w)
{
    static const char *const names[] = {"refresh", "buffer",       "screen",
                                        "load",    "display-list", NULL};
    static bool (*const run[])(struct words *) = {refresh, buffer, screen, load, display_list};
    int which;
    (void)m;
    return words_choice(w, names, &which) && run[which](w);
}

const struct command commands_arithmetic[] = {
    {"calc",
     "refresh LINES-A-SECOND LINES [PART] | buffer WIDTH HEIGHT BITS | screen INCHES INCHES DPI "
     "BITS\n"
     "  | load WIDTH HEIGHT BITS BITS-A-SECOND | display-list MICROSECONDS REFRESHES",
     "the arithmetic of displays", calc},
    {NULL, NULL, NULL, NULL},
};
