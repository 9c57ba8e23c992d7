/* space_viewing.c — the viewing transformation: viewing. */
#include <stdio.h>

#include "roms/commands/space_commands.h"
#include "roms/commands/space_picture.h"
#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/transform3.h"
#include "roms/geometry/view3.h"
#include "roms/monitor/print.h"

struct request {
    struct vector3 reference, normal, up;
    struct view3 view;
    struct space_points before, after;
};

static bool take(struct words *w, struct request *r)
{
    if (!words_vector(w, WORDS_FARTHEST, &r->reference) ||
        !words_direction(w, 3, WORDS_FARTHEST, &r->normal) ||
        !words_direction(w, 3, WORDS_FARTHEST, &r->up) || !space_at(w, &r->before))
        return false;
    if (!view3(r->reference, r->normal, r->up, &r->view))
        return words_refuse(w, "the normal and the view-up must not be parallel");
    r->after.count = r->before.count;
    for (int i = 0; i < r->before.count; i++)
        r->after.at[i] = matrix4_apply(&r->view.matrix, r->before.at[i]);
    return true;
}

static void print_axis(const char *name, struct vector3 v)
{
    printf("%s = ", name);
    print_vector3(v);
    printf("\n");
}

static void print_result(const struct request *r, bool table)
{
    print_axis("u", r->view.u);
    print_axis("v", r->view.v);
    print_axis("n", r->view.n);
    if (table) {
        print_matrix4("    T =", &r->view.translate);
        print_matrix4("    R =", &r->view.rotate);
    }
    print_matrix4("    M =", &r->view.matrix);
    for (int i = 0; i < r->before.count; i++) {
        print_vector3(r->before.at[i]);
        printf(" -> ");
        print_vector3(r->after.at[i]);
        printf("\n");
    }
}

/* What is looked at: the points, or the house. */
static void draw_subject(const struct space_view *view, const struct request *r)
{
    struct matrix4 one = matrix4_identity();
    stage_ink(view->stage, INK_BRIGHT);
    if (r->before.count > 0)
        space_figure(view, &r->before, false);
    else
        space_draw(view, &space_house, &one, SPACE_FILLED);
}

static int subject(const struct request *r, struct vector3 *out)
{
    int count = 0;
    for (; count < r->before.count; count++)
        out[count] = r->before.at[count];
    if (count == 0)
        for (; count < space_house.corners; count++)
            out[count] = space_house.corner[count];
    return count;
}

/* The viewing axes, where they are in the world. */
static void draw_frame(const struct space_view *view, const struct request *r, float length)
{
    static const char *const names[] = {"u", "v", "n"};
    const struct vector3 axis[] = {r->view.u, r->view.v, r->view.n};
    for (int i = 0; i < 3; i++) {
        struct vector3 tip = vector3_sum(r->reference, vector3_times(axis[i], length));
        stage_ink(view->stage, INK_YELLOW);
        space_line(view, r->reference, tip);
        space_text(view, tip, names[i]);
    }
}

static void draw_world(struct stage *s, const struct request *r)
{
    struct vector3 all[SPACE_CORNERS + 4];
    int count = subject(r, all);
    struct axonometric a = projection_axonometric(-35, 25);
    all[count++] = r->reference;
    struct space_scene scene = space_scene(s, &a.matrix, STAGE_WIDTH / 2, all, count);
    const struct space_view *view = &scene.view;
    space_axes(view, scene.axes, scene.negative);
    draw_subject(view, r);
    draw_frame(view, r, scene.axes * 0.35f);
}

static void draw_view(struct stage *s, const struct request *r)
{
    enum { LEFT = STAGE_WIDTH / 2 + 40, WIDTH = STAGE_WIDTH / 2 - 80, BOTTOM = 100, HEIGHT = 600 };
    struct vector3 all[SPACE_CORNERS];
    struct point2 at[SPACE_CORNERS];
    int count = subject(r, all);
    for (int i = 0; i < count; i++) {
        struct vector3 p = matrix4_apply(&r->view.matrix, all[i]);
        at[i] = (struct point2){p.x, p.y};
    }
    struct space_view view = {.stage = s, .projection = r->view.matrix};
    space_fit(&view, LEFT + 20, BOTTOM + 20, WIDTH - 40, HEIGHT - 40, at, count);
    stage_ink(s, INK_YELLOW);
    stage_rectangle(s, LEFT, BOTTOM, WIDTH, HEIGHT);
    stage_text_middle(s, LEFT + WIDTH / 2, BOTTOM - 44, "the view plane: u right, v up");
    draw_subject(&view, r);
}

static void draw(struct stage *s, const struct request *r)
{
    stage_begin(s);
    draw_world(s, r);
    draw_view(s, r);
    stage_title(s, "The viewing transformation");
    stage_caption(s, "left: the world with the axes u, v, n; right: the view plane");
    stage_end(s);
}

bool space_viewing(struct monitor *m, struct words *w)
{
    struct request r;
    if (!take(w, &r))
        return false;
    print_result(&r, m->table);
    draw(&m->stage, &r);
    return true;
}
