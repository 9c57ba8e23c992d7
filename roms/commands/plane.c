/* plane.c — `2d`: transformations of the plane, composed and inverted. */
#include <stddef.h>
#include <stdio.h>

#include "roms/commands/flat_words.h"
#include "roms/commands/plane_ops.h"
#include "roms/commands/plane_parts.h"
#include "roms/commands/plane_picture.h"
#include "roms/monitor/command.h"
#include "roms/monitor/print.h"

/* [at x y …], or the default figure without a word. */
bool plane_take_figure(struct words *w, struct plane_figure *f, bool *given)
{
    *f = plane_figure_default();
    *given = words_take(w, "at");
    const struct words_wanted wanted = {1, FLAT_POINTS, WORDS_FARTHEST};
    return (!*given || words_points2(w, wanted, f->corner, &f->count)) && words_end(w);
}

static void caption(struct monitor *m, const struct plane_ops *ops, bool inverse)
{
    char text[160];
    int at = snprintf(text, sizeof text, "%s", inverse ? "Inverse of: " : "");
    for (int i = 0; i < ops->count && at < (int)sizeof text; i++)
        at += snprintf(text + at, sizeof text - (size_t)at, "%s%s", i > 0 ? ", then " : "",
                       ops->op[i].whole.name);
    stage_caption(&m->stage, text);
}

static bool transform(struct monitor *m, struct words *w)
{
    static struct plane_ops ops;
    struct plane_figure before, after;
    bool given;
    if (!plane_ops_take(w, &ops))
        return false;
    bool inverse = words_take(w, "inverse");
    struct matrix3 whole = ops.product;
    if (inverse && !matrix3_inverse(&ops.product, &whole))
        return words_refuse(w, "the transformation has no inverse");
    if (!plane_take_figure(w, &before, &given))
        return false;
    after = plane_figure_image(&before, &whole);
    if (!plane_figure_sane(&after))
        return words_refuse(w, "the result is beyond +-1e9");
    if (m->table)
        plane_ops_print(&ops);
    printf("%s\n", ops.count > 1 ? "product" : "matrix");
    print_matrix3("", &ops.product);
    if (inverse) {
        printf("inverse\n");
        print_matrix3("", &whole);
    }
    if (given)
        plane_figure_print(&before, &after);
    stage_begin(&m->stage);
    plane_picture_both(m, &before, &after);
    stage_title(&m->stage, "Transformation of the plane: before (cyan) and after");
    caption(m, &ops, inverse);
    stage_end(&m->stage);
    return true;
}

const struct command commands_plane[] = {
    {"2d", "OP [then OP ...] [inverse] [at x y ...]; OP: " PLANE_OPS_FORM,
     "transforms figures of the plane: matrices, their product, points", transform},
    {"window", "xmin ymin xmax ymax [zoom f] [pan dx dy] to xmin ymin xmax ymax [at x y ...]",
     "window to viewport transformation", plane_window},
    {"view", "x0 y0 up-x up-y [at x y ...]",
     "a viewing frame in the world: its origin and the direction up", plane_view},
    {"pipeline",
     "[OP [then OP ...]] [view x0 y0 up-x up-y] window xmin ymin xmax ymax "
     "[viewport xmin ymin xmax ymax] [device width height] [at x y ...]",
     "the whole way from model to device coordinates, clipped", plane_pipeline},
    {NULL, NULL, NULL, NULL},
};
