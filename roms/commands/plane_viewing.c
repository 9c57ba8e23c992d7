/* plane_viewing.c — `window` and `view`: windows and viewports, viewing frames. */
#include <math.h>
#include <stdio.h>

#include "roms/clip/window_viewport.h"
#include "roms/commands/flat_words.h"
#include "roms/commands/plane_parts.h"
#include "roms/monitor/print.h"

/* ---- window ---------------------------------------------------------------------------------- */

static bool take_window(struct words *w, struct clip_window *out)
{
    if (!flat_window(w, out))
        return false;
    while (words_next_is(w, "zoom") || words_next_is(w, "pan")) {
        float v[2];
        if (words_take(w, "zoom")) {
            if (!words_bounded(w, 0.001f, 1000, v))
                return false;
            *out = window_zoom(out, v[0]);
        } else if (words_take(w, "pan")) {
            if (!words_amounts(w, v, 2))
                return false;
            *out = window_pan(out, v[0], v[1]);
        }
    }
    float least = fminf(out->x_max - out->x_min, out->y_max - out->y_min);
    float most = fmaxf(fmaxf(fabsf(out->x_min), fabsf(out->x_max)),
                       fmaxf(fabsf(out->y_min), fabsf(out->y_max)));
    if (!(least >= FLAT_LEAST * 1e-3f && most <= 1e9f))
        return words_refuse(w, "the window has become too small or too large");
    return true;
}

static void print_window(const char *name, const struct clip_window *w)
{
    printf("%s (%.4f,%.4f) to (%.4f,%.4f)\n", name, print_tidy(w->x_min), print_tidy(w->y_min),
           print_tidy(w->x_max), print_tidy(w->y_max));
}

static void panel(struct stage *s, float left, const struct clip_window *shown,
                  const struct plane_figure *f, enum ink ink, const char *name)
{
    struct point2 all[FLAT_POINTS + 2] = {{shown->x_min, shown->y_min},
                                          {shown->x_max, shown->y_max}};
    for (int i = 0; i < f->count; i++)
        all[i + 2] = f->corner[i];
    struct graph g =
        graph_fit(s, left, 60, STAGE_WIDTH / 2 - 20, STAGE_HEIGHT - 60, all, f->count + 2);
    plane_picture_rectangle(&g, shown, INK_GREEN);
    plane_picture_figure(&g, f, ink, false, "");
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, left + STAGE_WIDTH / 4, 20, name);
}

bool plane_window(struct monitor *m, struct words *w)
{
    struct clip_window window, viewport;
    struct plane_figure before, after;
    struct matrix3 matrix;
    bool given;
    if (!take_window(w, &window))
        return false;
    if (!words_take(w, "to"))
        return words_refuse(w, "\"to\" and a viewport are missing");
    if (!flat_window(w, &viewport) || !plane_take_figure(w, &before, &given))
        return false;
    window_to_viewport(&window, &viewport, &matrix);
    after = plane_figure_image(&before, &matrix);
    if (!plane_figure_sane(&after))
        return words_refuse(w, "the result is beyond +-1e9");
    print_window("window  ", &window);
    print_window("viewport", &viewport);
    printf("sx %.4f sy %.4f\n", print_tidy(matrix.at[0][0]), print_tidy(matrix.at[1][1]));
    print_matrix3("", &matrix);
    for (int i = 0; given && i < before.count; i++) {
        print_point2(before.corner[i]);
        printf(" -> ");
        print_point2(after.corner[i]);
        printf("%s\n", clip_point(&window, before.corner[i]) ? "" : " outside the window");
    }
    stage_begin(&m->stage);
    panel(&m->stage, 0, &window, &before, INK_CYAN, "window");
    panel(&m->stage, STAGE_WIDTH / 2 + 20, &viewport, &after, INK_ORANGE, "viewport");
    stage_title(&m->stage, "Window to viewport transformation");
    stage_caption(&m->stage, "Where a point lies in the window, there it lies in the viewport");
    stage_end(&m->stage);
    return true;
}

/* ---- view ------------------------------------------------------------------------------------ */

static void frame_axes(const struct graph *g, struct point2 origin, struct point2 up)
{
    float length = hypotf(up.x, up.y), reach = 160 / g->scale;
    struct point2 v = {up.x / length * reach, up.y / length * reach};
    struct point2 x = {origin.x + v.y, origin.y - v.x}, y = {origin.x + v.x, origin.y + v.y};
    stage_ink(g->stage, INK_GREEN);
    graph_line(g, origin, x);
    graph_line(g, origin, y);
    graph_text(g, x, "xv");
    graph_text(g, y, "yv");
}

bool plane_view(struct monitor *m, struct words *w)
{
    struct point2 origin;
    struct vector3 toward;
    struct plane_figure before, after;
    struct matrix3 matrix;
    bool given;
    if (!words_point(w, WORDS_FARTHEST, &origin) ||
        !words_direction(w, 2, WORDS_FARTHEST, &toward) || !plane_take_figure(w, &before, &given))
        return false;
    const struct point2 up = {toward.x, toward.y};
    view_frame(origin, up, &matrix); /* it has a length */
    after = plane_figure_image(&before, &matrix);
    printf("world to view\n");
    print_matrix3("", &matrix);
    if (given)
        plane_figure_print(&before, &after);
    struct point2 all[FLAT_POINTS + 2] = {{0, 0}, origin};
    for (int i = 0; i < before.count; i++)
        all[i + 2] = before.corner[i];
    stage_begin(&m->stage);
    struct graph g =
        graph_fit(&m->stage, 0, 0, STAGE_WIDTH / 2 - 20, STAGE_HEIGHT, all, before.count + 2);
    graph_axes(&g);
    frame_axes(&g, origin, up);
    plane_picture_figure(&g, &before, INK_CYAN, false, "");
    all[1] = all[0];
    for (int i = 0; i < after.count; i++)
        all[i + 2] = after.corner[i];
    g = graph_fit(&m->stage, STAGE_WIDTH / 2 + 20, 0, STAGE_WIDTH / 2 - 20, STAGE_HEIGHT, all,
                  after.count + 2);
    graph_axes(&g);
    plane_picture_figure(&g, &after, INK_ORANGE, true, "");
    stage_title(&m->stage, "A viewing frame: world coordinates, viewing coordinates");
    stage_caption(&m->stage, "The frame's y axis points up on the right");
    stage_end(&m->stage);
    return true;
}
