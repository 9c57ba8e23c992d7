/* space.c — transformations of space: 3d. The other commands are in space_….c. */
#include <stdio.h>

#include "roms/commands/space_commands.h"
#include "roms/commands/space_picture.h"
#include "roms/commands/space_words.h"
#include "roms/geometry/projection_parallel.h"
#include "roms/monitor/print.h"

/* A line of `3d`. */
struct request {
    struct space_operation operation[SPACE_OPERATIONS];
    int operations;
    bool inverse, cube;
    struct matrix4 matrix;
    struct space_points before, after;
};

/* The unit cube: the corners at y = 1 from x = 0, z = 1 round, then those below them. */
static const struct space_points cube = {
    {{0, 1, 1}, {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, 8};

static bool take(struct words *w, struct request *r)
{
    r->operations = 0;
    do {
        if (r->operations == SPACE_OPERATIONS)
            return words_refuse(w, "at most %d operations", SPACE_OPERATIONS);
        if (!space_operation(w, &r->operation[r->operations]))
            return false;
        r->operations++;
    } while (words_take(w, "then"));
    r->inverse = words_take(w, "inverse");
    if (!space_at(w, &r->before))
        return false;
    r->cube = r->before.count == 0;
    if (r->cube)
        r->before = cube;
    return true;
}

/* The product, the points; false: they cannot be had. */
static bool reckon(struct words *w, struct request *r)
{
    r->matrix = r->operation[0].transform.matrix;
    for (int i = 1; i < r->operations; i++)
        r->matrix = matrix4_product(&r->operation[i].transform.matrix, &r->matrix);
    if (!space_matrix_fits(&r->matrix))
        return words_refuse(w, "the product's numbers are too large");
    struct matrix4 inverse;
    if (r->inverse) {
        if (!matrix4_inverse(&r->matrix, &inverse))
            return words_refuse(w, "the product has no inverse");
        if (!space_matrix_fits(&inverse))
            return words_refuse(w, "the inverse's numbers are too large");
        r->matrix = inverse;
    }
    r->after.count = r->before.count;
    for (int i = 0; i < r->before.count; i++) {
        r->after.at[i] = matrix4_apply(&r->matrix, r->before.at[i]);
        if (!space_vector_fits(r->after.at[i]))
            return words_refuse(w, "the points' numbers are too large");
    }
    return true;
}

static void print_line_working(const struct space_operation *o)
{
    const struct rotate_axis *l = &o->line;
    printf("direction ");
    print_vector3(l->direction);
    printf(", d = %.4f\n", (double)l->d);
    printf("sin alpha = %.4f, cos alpha = %.4f\n", print_tidy(l->sine_alpha),
           print_tidy(l->cosine_alpha));
    printf("sin beta = %.4f, cos beta = %.4f\n", print_tidy(l->sine_beta),
           print_tidy(l->cosine_beta));
}

static void print_factors(const struct request *r)
{
    for (int i = 0; i < r->operations; i++) {
        const struct space_operation *o = &r->operation[i];
        printf("%d. %s\n", i + 1, o->name);
        if (o->about_line)
            print_line_working(o);
        for (int k = 0; k < o->transform.steps; k++) {
            char name[16];
            snprintf(name, sizeof name, "%5s =", o->transform.step[k].name);
            print_matrix4(name, &o->transform.step[k].matrix);
        }
        if (o->transform.steps > 1 && r->operations > 1)
            print_matrix4("    M =", &o->transform.matrix);
    }
}

static void print_result(const struct request *r)
{
    print_matrix4(r->inverse ? " M^-1 =" : "    M =", &r->matrix);
    for (int i = 0; i < r->before.count; i++) {
        print_vector3(r->before.at[i]);
        printf(" -> ");
        print_vector3(r->after.at[i]);
        printf("\n");
    }
}

/* The axis of rotation, and some way beyond its points. */
static void draw_line(const struct space_view *view, const struct space_operation *o, float axes)
{
    struct vector3 beyond = vector3_times(o->line.direction, 0.5f * axes);
    space_line(view, vector3_difference(o->p1, beyond), vector3_sum(o->p2, beyond));
    space_text(view, o->p1, "A");
    space_text(view, o->p2, "B");
}

static void draw(struct stage *s, const struct request *r)
{
    enum { PICTURE = 800, COLUMN = 820 };
    struct vector3 all[2 * SPACE_POINTS];
    int count = 0;
    struct axonometric a = projection_axonometric(-35, 25);
    for (int i = 0; i < r->before.count; i++) {
        all[count++] = r->before.at[i];
        all[count++] = r->after.at[i];
    }
    stage_begin(s);
    struct space_scene scene = space_scene(s, &a.matrix, PICTURE, all, count);
    const struct space_view *view = &scene.view;
    struct matrix4 one = matrix4_identity();
    space_axes(view, scene.axes, scene.negative);
    for (int i = 0; i < r->operations; i++) {
        const struct space_operation *o = &r->operation[i];
        stage_ink(s, INK_YELLOW);
        if (o->about_line)
            draw_line(view, o, scene.axes);
    }
    stage_ink(s, INK_TEXT);
    if (r->cube) {
        space_draw(view, &space_cube, &one, SPACE_WIRE);
        space_draw(view, &space_cube, &r->matrix, SPACE_FILLED);
    } else {
        space_figure(view, &r->before, true);
        stage_ink(s, INK_BRIGHT);
        space_figure(view, &r->after, true);
    }
    stage_ink(s, INK_TEXT);
    space_matrix(s, COLUMN, STAGE_HEIGHT - 120, r->inverse ? "M^-1 =" : "M =", &r->matrix);
    stage_title(s, r->inverse ? "The inverse transformation" : "Transformation of space");
    stage_caption(s, r->cube ? "thin: before; solid: after" : "grey: before; bright: after");
    stage_end(s);
}

static bool transform(struct monitor *m, struct words *w)
{
    struct request r;
    if (!take(w, &r) || !reckon(w, &r))
        return false;
    if (m->table)
        print_factors(&r);
    print_result(&r);
    draw(&m->stage, &r);
    return true;
}

const struct command commands_space[] = {
    {"3d", "OP [then OP ...] [inverse] [at x y z ...]; OP: " SPACE_OPERATIONS_FORM,
     "transforms points, or the unit cube", transform},
    {"viewing", "vrp-x vrp-y vrp-z vpn-x vpn-y vpn-z vup-x vup-y vup-z [at x y z ...]",
     "turns world coordinates into viewing coordinates", space_viewing},
    {"project", "KIND [at x y z ...]; KIND: " SPACE_PROJECTIONS_FORM,
     "projects points, or a house; cavalier, cabinet, oblique: degrees at which the z axis is "
     "drawn",
     space_project},
    {"clip3d",
     "parallel|perspective [zprp zvp] xmin ymin xmax ymax near far line|polygon x y z x y z ...",
     "clips a line or a polygon to the view volume", space_clip},
    {NULL, NULL, NULL, NULL},
};
