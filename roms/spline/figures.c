/* figures.c — title and caption: what the curve is, and its figures at t. */
#include <stdio.h>
#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/spline/view.h"

enum { LINE = 73, CHARACTERS = 2 * LINE };

static const char *plural(int count)
{
    return count == 1 ? "" : "s";
}

static void title(const struct editor *e, const struct curve *c, struct stage *s)
{
    char text[LINE];
    int n = e->model.count;
    const char *closed = c->closed ? ", closed" : "";
    switch (e->model.kind) {
    case MODEL_BEZIER:
        snprintf(text, sizeof text, "Bezier curve of degree %d%s", c->order - 1, closed);
        break;
    case MODEL_PIECES:
        snprintf(text, sizeof text, "%d cubic piece%s with handles%s", c->pieces, plural(c->pieces),
                 closed);
        break;
    case MODEL_NATURAL:
        snprintf(text, sizeof text, "%s spline through %d points",
                 c->closed ? "Periodic" : "Natural", n);
        break;
    default:
        snprintf(text, sizeof text, "B-spline of %d points%s", n, closed);
        break;
    }
    stage_title(s, text);
}

static void radius_text(char *text, size_t size, float curvature)
{
    if (fabsf(curvature) < 1e-6f)
        snprintf(text, size, "straight");
    else
        snprintf(text, size, "radius %.0f", (double)(1 / fabsf(curvature)));
}

/* Blanks on both sides: a caption's line is broken where it is full, not before. */
static void centre(char out[LINE], const char *text)
{
    int length = (int)strlen(text), left = (LINE - 1 - length) / 2;
    memset(out, ' ', LINE - 1);
    memcpy(out + left, text, (size_t)length);
    out[LINE - 1] = '\0';
}

static void caption(const struct editor *e, const struct curve *c, struct stage *s)
{
    char first[LINE], padded[LINE], text[CHARACTERS], radius[20];
    struct curve_place p = curve_at(c, curve_t(c, e->part));
    radius_text(radius, sizeof radius, p.curvature);
    snprintf(first, sizeof first, "t %.3f  point %.1f %.1f  |p'| %.0f  direction %+.1f deg",
             (double)curve_t(c, e->part), (double)p.at.x, (double)p.at.y,
             (double)vector3_length(p.first), (double)(atan2f(p.first.y, p.first.x) / DEGREE));
    centre(padded, first);
    snprintf(text, sizeof text, "%s curvature %+.5f  %s  length %.0f", padded, (double)p.curvature,
             radius, (double)curve_length(c));
    stage_caption(s, text);
}

void figures_draw(const struct editor *e, const struct curve *c, const char *trouble,
                  struct stage *s)
{
    if (trouble) {
        stage_title(s, "Curves by their points");
        stage_caption(s, trouble);
        return;
    }
    title(e, c, s);
    if (e->message)
        stage_caption(s, e->message);
    else
        caption(e, c, s);
}
