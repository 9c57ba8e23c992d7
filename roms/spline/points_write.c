/* points_write.c — a model as text. */
#include <stdio.h>

#include "roms/spline/points_words.h"

const char *const points_kinds[MODEL_KINDS] = {"bezier", "pieces", "natural", "b-spline"};
const char *const points_knots[3] = {"uniform", "chordal", "centripetal"};
const char *const points_joints[JOINTS] = {"c1", "g1", "corner"};

/* 9 digits tell floats apart. */
static int put_numbers(char *text, size_t size, const float *v, int count)
{
    int length = 0;
    for (int i = 0; i < count; i++)
        length += snprintf(text + length, size - (size_t)length, " %.9g", (double)v[i]);
    return length;
}

static void write_point(const struct model_point *p, char *line, size_t size)
{
    const float place[] = {p->at.x, p->at.y};
    const float handles[] = {p->in.x, p->in.y, p->out.x, p->out.y};
    int length = snprintf(line, size, "point");
    length += put_numbers(line + length, size - (size_t)length, place, 2);
    if (p->own || p->joint != JOINT_C1)
        length += snprintf(line + length, size - (size_t)length, " %s", points_joints[p->joint]);
    if (p->own)
        length += put_numbers(line + length, size - (size_t)length, handles, 4);
    snprintf(line + length, size - (size_t)length, "\n");
}

void points_write(const struct model *m, void (*put)(void *ctx, const char *line), void *ctx)
{
    char line[POINTS_TEXT_LINE];
    put(ctx, "spline 1\n");
    snprintf(line, sizeof line, "kind %s knots %s %s\n", points_kinds[m->kind],
             points_knots[m->parameter], m->closed ? "closed" : "open");
    put(ctx, line);
    for (int i = 0; i < m->count; i++) {
        write_point(&m->point[i], line, sizeof line);
        put(ctx, line);
    }
    put(ctx, "end\n");
}
