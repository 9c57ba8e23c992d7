#include "roms/digitise/table.h"

#include <math.h>
#include <stdio.h>

struct table {
    void (*put)(void *ctx, const char *line);
    void *ctx;
    char line[TABLE_LINE];
};

const char *table_kind(unsigned kind)
{
    static const char *const names[] = {"none", "electrical", "sonic", "resistive"};
    return kind < sizeof names / sizeof *names ? names[kind] : "unknown";
}

static void heading(const struct session *s, struct table *t)
{
    snprintf(t->line, TABLE_LINE, "# tablet %s, %.3f mm a count, %.2f reports a second, lost %u\n",
             table_kind(s->facts.kind), (double)session_unit(s),
             (double)((float)s->facts.millihertz / 1000), (unsigned)s->reading.lost);
    t->put(t->ctx, t->line);
    if (s->placed)
        snprintf(
            t->line, TABLE_LINE,
            "# paper %s, %d points, residual %.3f mm rms%s, %.4f mm a count, turned %.2f deg\n",
            s->fit.affine ? "affine" : "similarity", s->fit.points, (double)s->fit.residual,
            s->fit.checked ? "" : " (as few as it takes)", (double)fit_scale(&s->fit),
            (double)fit_turn(&s->fit));
    else
        snprintf(t->line, TABLE_LINE, "# paper none: millimetres of the tablet\n");
    t->put(t->ctx, t->line);
    t->put(t->ctx, "line,point,x_mm,y_mm,z_mm,samples,s_mm,gap\n");
}

static void points(const struct drawing *d, const struct drawing_line *line, int number,
                   struct table *t)
{
    for (int i = 0; i < line->count; i++) {
        const struct drawing_point *p = &d->point[line->first + i];
        snprintf(t->line, TABLE_LINE, "%d,%d,%.3f,%.3f,%.3f,%u,%.3f,%d\n", number, i + 1,
                 (double)p->x, (double)p->y, (double)p->z, (unsigned)p->samples,
                 (double)p->deviation, p->gap);
        t->put(t->ctx, t->line);
    }
}

static void measures(const struct drawing *d, const struct drawing_line *line, int number,
                     struct table *t)
{
    struct drawing_measure m = drawing_measure(d, line);
    snprintf(t->line, TABLE_LINE,
             "# line %d: %d points, %s, gaps %d, length %.2f mm, with heights %.2f mm, "
             "area %.1f mm2\n",
             number, line->count, line->closed ? "closed" : "open", m.gaps, (double)m.length,
             (double)m.space, (double)fabsf(m.area));
    t->put(t->ctx, t->line);
}

void table_write(const struct session *s, void (*put)(void *ctx, const char *line), void *ctx)
{
    struct table t = {.put = put, .ctx = ctx};
    struct drawing_line line = {0};
    heading(s, &t);
    for (int number = 1; drawing_next_line(&s->drawing, &line); number++) {
        points(&s->drawing, &line, number, &t);
        if (!line.alone)
            measures(&s->drawing, &line, number, &t);
    }
    put(ctx, "# end\n");
}
