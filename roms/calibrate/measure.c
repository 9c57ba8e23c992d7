/* measure.c — firings of some fields to one place; places to one offset. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "roms/calibrate/calibrate.h"
#include "roms/geometry/scalar.h"

enum {
    SETTLE = 2,         /* fields after the press that do not count: the hand still moves */
    UNSTEADY_DOTS = 24, /* between firings of a pen that is held still, and noise */
    UNSTEADY_LINES = 6,
};

static int compare(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* The middle one; *spread: from the first to the last. */
static float median(const float *values, int count, float *spread)
{
    float sorted[HITS];
    memcpy(sorted, values, (size_t)count * sizeof *sorted);
    qsort(sorted, (size_t)count, sizeof *sorted, compare);
    *spread = sorted[count - 1] - sorted[0];
    return sorted[count / 2];
}

/* No pen is so late that it would be nearer to another target. */
static bool from_elsewhere(const struct calibration *c, const struct place *place, float dot,
                           float line)
{
    return fabsf(dot - (float)place->x) > (float)c->timing.h_visible / 8 ||
           fabsf(line - (float)place->y) > (float)c->timing.v_visible / 8;
}

static bool fill_in(struct firings *f, struct place *place)
{
    float lines;
    place->dot = median(f->dot, HITS, &place->spread);
    place->line = median(f->line, HITS, &lines);
    f->count = 0;
    if (place->spread > UNSTEADY_DOTS || lines > UNSTEADY_LINES)
        return false;
    place->dx = place->dot - (float)place->x;
    place->dy = place->line - (float)place->y;
    place->measured = true;
    return true;
}

bool measure_field(const struct calibration *c, struct firings *f, struct place *place,
                   bool pressed, const struct pen_rows *rows)
{
    float dot, line;
    unsigned seen;
    if (!pressed) {
        f->count = f->skipped = 0;
        return false;
    }
    if (!pen_rows_middle(rows, &line, &dot, &seen) || from_elsewhere(c, place, dot, line) ||
        f->skipped++ < SETTLE)
        return false;
    f->dot[f->count] = dot;
    f->line[f->count] = line;
    place->rows = (int)seen;
    return ++f->count == HITS && fill_in(f, place);
}

void measure_left(const struct calibration *c, struct place *place)
{
    place->left_x = place->dx - c->dots;
    place->left_y = place->dy - c->lines;
}

/* In its rows the pen shows how large a spot it sees: so that and the time, both of which are in the offset,
 * are told apart. */
static void find_pen(struct calibration *c)
{
    float rows = 0;
    for (int i = 0; i < TARGETS; i++)
        rows += (float)c->place[i].rows / TARGETS;
    float um = rows * (float)video_height_um() / (float)c->timing.v_visible;
    float dots = video_width_um() > 0 ? (float)c->timing.h_visible / (float)video_width_um() : 0;
    float radius = um / 2 * dots;
    c->sees_um = scalar_nearest(um);
    c->late_ns = scalar_nearest((c->dots + radius) * 1e9f / (float)c->timing.clock_hz);
}

void measure_offset(struct calibration *c)
{
    float dx[TARGETS], dy[TARGETS], spread;
    for (int i = 0; i < TARGETS; i++) {
        dx[i] = c->place[i].dx;
        dy[i] = c->place[i].dy;
    }
    c->dots = median(dx, TARGETS, &spread);
    c->lines = median(dy, TARGETS, &spread);
    c->found = true;
    for (int i = 0; i < TARGETS; i++)
        measure_left(c, &c->place[i]);
    find_pen(c);
}

float measure_length(float x, float y)
{
    return sqrtf(x * x + y * y);
}
