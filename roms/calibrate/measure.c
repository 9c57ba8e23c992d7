/* measure.c — firings of some fields to one place; places to one offset. */
#include <stdlib.h>
#include <string.h>

#include "roms/calibrate/calibrate.h"

enum {
    SETTLE = 2,         /* fields after the press that do not count: the hand still moves */
    UNSTEADY_DOTS = 24, /* between firings of a pen that is held still, and noise */
    UNSTEADY_LINES = 6,
};

static int compare(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* The middle one; *spread: from the first to the last. */
static int median(const int *values, int *spread)
{
    int sorted[HITS];
    memcpy(sorted, values, sizeof sorted);
    qsort(sorted, HITS, sizeof *sorted, compare);
    *spread = sorted[HITS - 1] - sorted[0];
    return sorted[HITS / 2];
}

/* No pen is so late that it would be nearer to another target. */
static bool from_elsewhere(const struct calibration *c, const struct place *place,
                           const struct pen_hit *hit)
{
    return abs((int)hit->dot - place->x) > (int)c->timing.h_visible / 8 ||
           abs((int)hit->line - place->y) > (int)c->timing.v_visible / 8;
}

static bool fill_in(struct firings *f, struct place *place)
{
    int lines;
    place->dot = median(f->dot, &place->spread);
    place->line = median(f->line, &lines);
    f->count = 0;
    if (place->spread > UNSTEADY_DOTS || lines > UNSTEADY_LINES)
        return false;
    place->dx = (float)(place->dot - place->x);
    place->dy = (float)(place->line - place->y);
    place->measured = true;
    return true;
}

bool measure_field(const struct calibration *c, struct firings *f, struct place *place,
                   bool pressed, const struct pen_hit *hit)
{
    if (!pressed) {
        f->count = f->skipped = 0;
        return false;
    }
    if (hit == NULL || from_elsewhere(c, place, hit) || f->skipped++ < SETTLE)
        return false;
    f->dot[f->count] = (int)hit->dot;
    f->line[f->count] = (int)hit->line;
    return ++f->count == HITS && fill_in(f, place);
}

void measure_left(const struct calibration *c, struct place *place)
{
    place->left_x = place->dx - c->dots;
    place->left_y = place->dy - c->lines;
}

void measure_offset(struct calibration *c)
{
    c->dots = c->lines = 0;
    for (int i = 0; i < TARGETS; i++) {
        c->dots += c->place[i].dx / TARGETS;
        c->lines += c->place[i].dy / TARGETS;
    }
    c->found = true;
    for (int i = 0; i < TARGETS; i++)
        measure_left(c, &c->place[i]);
}

float measure_length(float x, float y)
{
    return __builtin_sqrtf(x * x + y * y);
}
