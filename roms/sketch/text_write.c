/* text_write.c — a drawing as lines of text. */
#include <stdio.h>

#include "roms/sketch/text.h"

struct writer {
    const struct drawing_state *s;
    void (*put)(void *ctx, const char *line);
    void *ctx;
    int number[DRAWING_POINTS], points;
};

/* A number of so many decimals, without zeros behind. */
static const char *decimal(char text[16], int32_t value, int32_t unit)
{
    int32_t size = value < 0 ? -value : value, rest = size % unit;
    int at = snprintf(text, 16, "%s%ld", value < 0 ? "-" : "", (long)(size / unit));
    if (rest == 0)
        return text;
    text[at++] = '.';
    while (rest != 0) {
        unit /= 10;
        text[at++] = (char)('0' + rest / unit);
        rest %= unit;
    }
    text[at] = '\0';
    return text;
}

static void write_points(struct writer *w, int picture)
{
    char line[TEXT_LINE + 1], x[16], y[16];
    for (int i = 0; i < DRAWING_POINTS; i++) {
        const struct drawing_point *p = &w->s->point[i];
        if (p->users == 0 || p->picture != picture)
            continue;
        w->number[i] = ++w->points;
        snprintf(line, sizeof line, "point %d %s %s", w->points, decimal(x, p->at.x, PLACE_UNIT),
                 decimal(y, p->at.y, PLACE_UNIT));
        w->put(w->ctx, line);
    }
}

static void write_figure(struct writer *w, const struct figure *f)
{
    static const char *const kept[] = {[CONSTRAINT_NONE] = "",
                                       [CONSTRAINT_HORIZONTAL] = " horizontal",
                                       [CONSTRAINT_VERTICAL] = " vertical"};
    char line[TEXT_LINE + 1], scale[16], angle[16];
    int a = w->number[f->end[0]], b = w->number[f->end[1]], c = w->number[f->end[2]];
    if (f->kind == FIGURE_LINE)
        snprintf(line, sizeof line, "line %d %d%s", a, b, kept[f->constraint]);
    else if (f->kind == FIGURE_CIRCLE)
        snprintf(line, sizeof line, "circle %d %d", a, b);
    else if (f->kind == FIGURE_ARC)
        snprintf(line, sizeof line, "arc %d %d %d", a, b, c);
    else
        snprintf(line, sizeof line, "copy %c %d %s %s", 'A' + f->master - 1, a,
                 decimal(scale, f->scale, SCALE_ONE), decimal(angle, f->angle, ANGLE_DEGREE));
    w->put(w->ctx, line);
}

static void write_picture(struct writer *w, int picture)
{
    write_points(w, picture);
    for (int i = 0; i < DRAWING_FIGURES; i++)
        if (w->s->figure[i].kind != FIGURE_NONE && w->s->figure[i].picture == picture)
            write_figure(w, &w->s->figure[i]);
}

void text_write(const struct drawing_state *s, void (*put)(void *ctx, const char *line), void *ctx)
{
    struct writer w = {.s = s, .put = put, .ctx = ctx};
    char line[TEXT_LINE + 1], x[16], y[16];
    put(ctx, "sketch 1");
    for (int i = 1; i <= DRAWING_MASTERS; i++) {
        if (!s->master[i].used)
            continue;
        snprintf(line, sizeof line, "subpicture %c %s %s", 'A' + i - 1,
                 decimal(x, s->master[i].origin.x, PLACE_UNIT),
                 decimal(y, s->master[i].origin.y, PLACE_UNIT));
        put(ctx, line);
        write_picture(&w, i);
    }
    put(ctx, "drawing");
    write_picture(&w, 0);
    put(ctx, "end");
}
