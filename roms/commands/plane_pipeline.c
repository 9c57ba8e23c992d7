/* plane_pipeline.c — `pipeline`: from model to device coordinates, stage by stage. */
#include <stdio.h>

#include "roms/clip/pipeline2.h"
#include "roms/commands/flat_words.h"
#include "roms/commands/plane_ops.h"
#include "roms/commands/plane_parts.h"
#include "roms/monitor/print.h"

struct job {
    struct plane_ops ops;
    struct view2 view;
    struct plane_figure figure;
    struct pipeline2 pipeline;
    struct sutherland_hodgman work;
};

static bool take_view(struct words *w, struct view2 *v)
{
    *v = (struct view2){.up = {0, 1}, .viewport = {0, 0, 1, 1}, .device = {0, 0, 640, 480}};
    if (words_take(w, "view")) {
        struct vector3 up;
        if (!words_point(w, WORDS_FARTHEST, &v->origin) ||
            !words_direction(w, 2, WORDS_FARTHEST, &up))
            return false;
        v->up = (struct point2){up.x, up.y};
    }
    if (!words_take(w, "window"))
        return words_refuse(w, "\"window\" is missing");
    if (!flat_window(w, &v->window))
        return false;
    if (words_take(w, "viewport")) {
        if (!flat_window(w, &v->viewport))
            return false;
        if (v->viewport.x_min < 0 || v->viewport.y_min < 0 || v->viewport.x_max > 1 ||
            v->viewport.y_max > 1)
            return words_refuse(w, "a viewport lies within 0 and 1");
    }
    if (words_take(w, "device")) {
        int width, height;
        if (!words_whole(w, 1, 4096, &width) || !words_whole(w, 1, 4096, &height))
            return false;
        v->device = (struct clip_window){0, 0, (float)width, (float)height};
    }
    return true;
}

static void print_matrices(const struct pipeline2 *p)
{
    const struct {
        const char *name;
        const struct matrix3 *matrix;
    } stages[] = {{"model: MC to WC", &p->model},
                  {"view: WC to VC", &p->view},
                  {"normalize: VC to NVC", &p->normalize},
                  {"device: NVC to DC", &p->device},
                  {"product: MC to DC", &p->whole}};
    for (int i = 0; i < 5; i++) {
        printf("%s\n", stages[i].name);
        print_matrix3("", stages[i].matrix);
    }
}

/* A corner in all five coordinate systems, a row each. */
static void print_stages(const struct pipeline2 *p, const struct plane_figure *f)
{
    const struct matrix3 *stages[] = {&p->model, &p->view, &p->normalize, &p->device};
    printf("MC WC VC NVC DC\n");
    for (int i = 0; i < f->count; i++) {
        struct point2 at = f->corner[i];
        print_point2(at);
        for (int k = 0; k < 4; k++) {
            at = matrix3_apply(stages[k], at);
            printf(" ");
            print_point2(at);
        }
        printf("\n");
    }
}

/* What is left of one point, of a line, of a polygon: corners in DC. */
static int clip(struct job *j)
{
    struct point2 *p = j->work.corner;
    p[0] = j->figure.corner[0];
    p[1] = j->figure.corner[1];
    if (j->figure.count == 1)
        return pipeline2_point(&j->pipeline, &p[0]) ? 1 : 0;
    if (j->figure.count == 2)
        return pipeline2_line(&j->pipeline, &p[0], &p[1]) ? 2 : 0;
    return pipeline2_polygon(&j->pipeline, j->figure.corner, j->figure.count, &j->work);
}

/* ---- the picture ----------------------------------------------------------------------------- */

/* The window, which the view turns, as corners in the world. */
static void window_in_world(const struct job *j, struct point2 corner[4])
{
    struct matrix3 back;
    const struct clip_window *w = &j->view.window;
    const struct point2 c[] = {
        {w->x_min, w->y_min}, {w->x_max, w->y_min}, {w->x_max, w->y_max}, {w->x_min, w->y_max}};
    matrix3_inverse(&j->pipeline.view, &back); /* a frame has one */
    for (int i = 0; i < 4; i++)
        corner[i] = matrix3_apply(&back, c[i]);
}

static void show_world(struct stage *s, const struct job *j, const struct plane_figure *world)
{
    struct point2 all[FLAT_POINTS + 5] = {{0, 0}};
    window_in_world(j, &all[1]);
    for (int i = 0; i < world->count; i++)
        all[i + 5] = world->corner[i];
    struct graph g =
        graph_fit(s, 0, 60, STAGE_WIDTH / 2 - 20, STAGE_HEIGHT - 60, all, world->count + 5);
    graph_axes(&g);
    stage_ink(s, INK_GREEN);
    graph_polygon(&g, &all[1], 4);
    plane_picture_figure(&g, world, INK_CYAN, false, "");
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, STAGE_WIDTH / 4, 20, "world and window");
}

static void show_device(struct stage *s, const struct job *j, const struct plane_figure *left)
{
    const struct clip_window *d = &j->view.device, *v = &j->view.viewport;
    const struct point2 all[] = {{d->x_min, d->y_min}, {d->x_max, d->y_max}};
    struct graph g =
        graph_fit(s, STAGE_WIDTH / 2 + 20, 60, STAGE_WIDTH / 2 - 20, STAGE_HEIGHT - 60, all, 2);
    const struct clip_window viewport = {v->x_min * d->x_max, v->y_min * d->y_max,
                                         v->x_max * d->x_max, v->y_max * d->y_max};
    plane_picture_rectangle(&g, d, INK_GRID);
    plane_picture_figure(&g, left, INK_ORANGE, true, "");
    plane_picture_rectangle(&g, &viewport, INK_GREEN);
    stage_ink(s, INK_TEXT);
    stage_text_middle(s, 3 * STAGE_WIDTH / 4, 20, "device and viewport");
}

static void show(struct monitor *m, const struct job *j, int left)
{
    struct plane_figure world = plane_figure_image(&j->figure, &j->pipeline.model);
    struct plane_figure device = {.count = left < FLAT_POINTS ? left : FLAT_POINTS};
    for (int i = 0; i < device.count; i++)
        device.corner[i] = j->work.corner[i];
    stage_begin(&m->stage);
    show_world(&m->stage, j, &world);
    show_device(&m->stage, j, &device);
    stage_title(&m->stage, "The viewing pipeline: MC, WC, VC, NVC, DC");
    stage_caption(&m->stage, "What the window holds is clipped and fills the viewport");
    stage_end(&m->stage);
}

bool plane_pipeline(struct monitor *m, struct words *w)
{
    static struct job j;
    bool given;
    j.ops.product = matrix3_identity();
    if (plane_ops_next(w) && !plane_ops_take(w, &j.ops))
        return false;
    if (!take_view(w, &j.view) || !plane_take_figure(w, &j.figure, &given))
        return false;
    pipeline2_begin(&j.pipeline, &j.view);
    pipeline2_model(&j.pipeline, &j.ops.product);
    struct plane_figure world = plane_figure_image(&j.figure, &j.pipeline.model);
    struct plane_figure all = plane_figure_image(&j.figure, &j.pipeline.whole);
    if (!plane_figure_sane(&world) || !plane_figure_sane(&all))
        return words_refuse(w, "the result is beyond +-1e9");
    int left = clip(&j);
    print_matrices(&j.pipeline);
    if (m->table)
        print_stages(&j.pipeline, &j.figure);
    if (left == 0) {
        printf("rejected\n");
    } else {
        printf("clipped, in DC: ");
        flat_print_points(j.work.corner, left);
    }
    show(m, &j, left);
    return true;
}
