/* space_project.c — projections: project. */
#include <stdio.h>
#include <string.h>

#include "roms/commands/space_commands.h"
#include "roms/commands/space_picture.h"
#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/projection_perspective.h"
#include "roms/geometry/transform3.h"
#include "roms/monitor/print.h"

enum family { ELEVATION, AXONOMETRIC, OBLIQUE, PERSPECTIVE };

struct request {
    const char *name;
    enum family family;
    struct axonometric axonometric;
    struct matrix4 turn, projection; /* perspective: the object's rotation, then the projection */
    struct matrix4 matrix;           /* of both */
    struct space_points points;
};

static bool elevation(struct words *w, struct request *r, int which)
{
    (void)w;
    r->family = ELEVATION;
    r->matrix = projection_elevation((enum elevation)which);
    return true;
}

static bool isometric(struct words *w, struct request *r, int which)
{
    (void)w;
    (void)which;
    r->family = AXONOMETRIC;
    r->axonometric = projection_isometric();
    return true;
}

static bool dimetric(struct words *w, struct request *r, int which)
{
    (void)which;
    float factor = 0.5f;
    r->family = AXONOMETRIC;
    if (words_next_is_number(w) && !words_amount(w, &factor))
        return false;
    if (!projection_dimetric(factor, &r->axonometric))
        return words_refuse(w, "the factor of z lies above 0 and up to 1");
    return true;
}

static bool trimetric(struct words *w, struct request *r, int which)
{
    (void)which;
    float turn = -30, tilt = 20;
    r->family = AXONOMETRIC;
    if (words_next_is_number(w) && (!words_amount(w, &turn) || !words_amount(w, &tilt)))
        return false;
    r->axonometric = projection_axonometric(turn, tilt);
    return true;
}

/* which: 0 cavalier, 1 cabinet, 2 with angle and factor. */
static bool oblique(struct words *w, struct request *r, int which)
{
    float degrees = 225, factor = which == 0 ? 1 : 0.5f;
    r->family = OBLIQUE;
    if ((which == 2 || words_next_is_number(w)) && !words_amount(w, &degrees))
        return false;
    if (which == 2 && !words_amount(w, &factor))
        return false;
    r->matrix = projection_oblique(degrees, factor);
    return true;
}

static bool finish_perspective(struct words *w, struct request *r, struct vector3 prp, float zvp,
                               float turn, float tilt)
{
    struct matrix4 about_y = transform3_rotate(AXIS3_Y, turn);
    struct matrix4 about_x = transform3_rotate(AXIS3_X, tilt);
    r->family = PERSPECTIVE;
    r->turn = matrix4_product(&about_x, &about_y);
    if (!projection_perspective(prp, zvp, &r->projection))
        return words_refuse(w, "zprp and zvp must differ");
    r->matrix = matrix4_product(&r->projection, &r->turn);
    return true;
}

static bool perspective(struct words *w, struct request *r, int which)
{
    (void)which;
    struct vector3 prp = {0, 0, 0};
    float zvp, turn = 0, tilt = 0;
    if (!words_amount(w, &prp.z) || !words_amount(w, &zvp))
        return false;
    if (words_take(w, "from") && (!words_amount(w, &prp.x) || !words_amount(w, &prp.y)))
        return false;
    if (words_take(w, "turn") && !words_amount(w, &turn))
        return false;
    if (words_take(w, "tilt") && !words_amount(w, &tilt))
        return false;
    return finish_perspective(w, r, prp, zvp, turn, tilt);
}

/* which: how many vanishing points. */
static bool points_perspective(struct words *w, struct request *r, int which)
{
    static const struct vector3 eyes[] = {{4, 4, 10}, {0, 1.2f, 10}, {0, 1, 10}};
    struct vector3 prp = eyes[which - 1];
    float zvp = 0;
    if (words_next_is_number(w) && (!words_amount(w, &prp.z) || !words_amount(w, &zvp)))
        return false;
    return finish_perspective(w, r, prp, zvp, which > 1 ? -35 : 0, which > 2 ? 25 : 0);
}

static bool take(struct words *w, struct request *r)
{
    static const struct {
        const char *name, *form;
        bool (*take)(struct words *w, struct request *r, int which);
        int which;
    } kinds[] = {
        {"front", "", elevation, ELEVATION_FRONT},
        {"rear", "", elevation, ELEVATION_REAR},
        {"left", "", elevation, ELEVATION_LEFT},
        {"right", "", elevation, ELEVATION_RIGHT},
        {"plan", "", elevation, ELEVATION_PLAN},
        {"isometric", "", isometric, 0},
        {"dimetric", "[factor]", dimetric, 0},
        {"trimetric", "[turn tilt]", trimetric, 0},
        {"cavalier", "[degrees]", oblique, 0},
        {"cabinet", "[degrees]", oblique, 1},
        {"oblique", "degrees factor", oblique, 2},
        {"perspective", "zprp zvp [from x y] [turn degrees] [tilt degrees]", perspective, 0},
        {"one-point", "[zprp zvp]", points_perspective, 1},
        {"two-point", "[zprp zvp]", points_perspective, 2},
        {"three-point", "[zprp zvp]", points_perspective, 3},
    };
    enum { KINDS = sizeof kinds / sizeof kinds[0] };
    int i = 0;
    while (i < KINDS && !words_take(w, kinds[i].name))
        i++;
    if (i == KINDS)
        return words_left(w) == 0
                   ? words_refuse(w, "a projection is missing")
                   : words_refuse(w, "there is no projection \"%.40s\"", words_peek(w));
    *r = (struct request){.name = kinds[i].name};
    if (!kinds[i].take(w, r, kinds[i].which))
        return space_refuse_form(w, kinds[i].name, kinds[i].form);
    if (r->family == AXONOMETRIC)
        r->matrix = r->axonometric.matrix;
    return space_at(w, &r->points);
}

/* ---- on the console -------------------------------------------------------------------------- */

static void print_axonometric(const struct axonometric *a)
{
    static const char *const names[] = {"x", "y", "z"};
    printf("turned about y by %.4f, tilted about x by %.4f\n", print_tidy(a->turn),
           print_tidy(a->tilt));
    printf("axis  drawn at  foreshortening\n");
    for (int i = 0; i < 3; i++)
        printf("%4s %9.4f %15.4f\n", names[i], print_tidy(a->angle[i]), print_tidy(a->factor[i]));
}

static void print_vanishing(const struct request *r)
{
    static const char *const counts[] = {"no", "one", "two", "three"};
    static const char *const names[] = {"x", "y", "z"};
    struct vanishing v = projection_vanishing_axes(&r->matrix);
    printf("dp = zprp - zvp = %.4f\n", print_tidy(-1 / r->projection.at[3][2]));
    printf("%s-point perspective\n", counts[v.count]);
    for (int i = 0; i < 3; i++)
        if (v.has[i]) {
            printf("lines along %s meet at ", names[i]);
            print_point2(v.at[i]);
            printf("\n");
        }
}

static void print_points(const struct request *r)
{
    for (int i = 0; i < r->points.count; i++) {
        struct point2 at;
        print_vector3(r->points.at[i]);
        if (projection_place(&r->matrix, r->points.at[i], &at)) {
            printf(" -> ");
            print_point2(at);
            printf("\n");
        } else {
            printf(" is beside or behind the reference point\n");
        }
    }
}

static void print_result(const struct request *r, bool table)
{
    if (r->family == PERSPECTIVE && table) {
        print_matrix4("    R =", &r->turn);
        print_matrix4("    P =", &r->projection);
    }
    print_matrix4("    M =", &r->matrix);
    if (r->family == AXONOMETRIC)
        print_axonometric(&r->axonometric);
    if (r->family == PERSPECTIVE)
        print_vanishing(r);
    print_points(r);
}

/* ---- in the picture -------------------------------------------------------------------------- */

static void draw(struct stage *s, const struct request *r)
{
    enum { PICTURE = 800, COLUMN = 820 };
    char title[48];
    struct matrix4 one = matrix4_identity();
    bool house = r->points.count == 0;
    stage_begin(s);
    struct space_scene scene =
        space_scene(s, &r->matrix, PICTURE, house ? space_house.corner : r->points.at,
                    house ? space_house.corners : r->points.count);
    const struct space_view *view = &scene.view;
    space_axes(view, scene.axes, scene.negative);
    stage_ink(s, INK_BRIGHT);
    if (house)
        space_draw(view, &space_house, &one, SPACE_FILLED);
    else
        space_figure(view, &r->points, false);
    stage_ink(s, INK_TEXT);
    space_matrix(s, COLUMN, STAGE_HEIGHT - 120, "M =", &r->matrix);
    snprintf(title, sizeof title, "Projection: %s", r->name);
    stage_title(s, title);
    stage_end(s);
}

bool space_project(struct monitor *m, struct words *w)
{
    struct request r;
    if (!take(w, &r))
        return false;
    print_result(&r, m->table);
    draw(&m->stage, &r);
    return true;
}
