/* solids.c — the present object: making it, its tables, their checks, planes. */
#include <stddef.h>
#include <stdio.h>

#include "roms/commands/solids.h"
#include "roms/scenery/workroom.h"
#include "roms/monitor/command.h"
#include "roms/monitor/print.h"
#include "roms/solids/broken.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"
#include "roms/solids/object_check.h"

/* ---- making and drawing it ------------------------------------------------------------------- */

struct look *present_look(void)
{
    static struct look look = {-30, 25, 0};
    return &look;
}

/* When there are few. */
static void name_vertices(struct stage *stage, const struct scene *scene)
{
    enum { FEW = 16 };
    stage_ink(stage, INK_TEXT);
    for (int i = 0; i < scene->vertices && scene->vertices <= FEW; i++) {
        char name[16];
        snprintf(name, sizeof name, "V%d", i + 1);
        stage_text(stage, scene->vertex[i].x + 8, scene->vertex[i].y + 6, name);
    }
}

void draw_object(struct monitor *m, const struct object *o, const char *title)
{
    struct workroom *room = workroom();
    const struct look *look = present_look();
    struct matrix4 turn = view_turn(look->yaw, look->pitch);
    float reach = object_reach(o), scale = 360 / reach;
    struct view view = view_on_stage(&turn, look->eye * reach, scale, 600, 400);
    scene_clear(&room->lines);
    stage_begin(&m->stage);
    stage_title(&m->stage, title);
    if (scene_add(&room->lines, o, &view, 0, 0)) {
        stage_ink(&m->stage, INK_GREEN);
        stage_wireframe(&m->stage, &room->lines);
        name_vertices(&m->stage, &room->lines);
    }
    stage_end(&m->stage);
}

static void print_counts(const struct object *o)
{
    printf("%d vertices, %d edges, %d polygons; V - E + S = %d\n", o->vertices, o->edges,
           o->polygons, o->vertices - o->edges + o->polygons);
}

struct shape {
    float size[3];
    int segments, rings;
};

/* Sizes of 0.01…1000; those that are not given stay. */
static bool take_sizes(struct words *w, struct shape *s, int count)
{
    for (int i = 0; i < count && words_next_is_number(w); i++)
        if (!words_bounded(w, 0.01f, 1000, &s->size[i]))
            return false;
    return true;
}

static bool take_counts(struct words *w, int most, int *segments, int *rings)
{
    if (words_next_is_number(w) && !words_whole(w, 3, most, segments))
        return false;
    return rings == NULL || !words_next_is_number(w) || words_whole(w, 3, most, rings);
}

enum { BOX, SPHERE, CYLINDER, TORUS, VESSEL, PAIR };
static const char *const shapes[] = {"box", "sphere", "cylinder", "torus", "vessel", "pair", NULL};

static bool take_shape(struct words *w, int which, struct shape *s)
{
    enum { ROUND = 36 };
    static const struct shape usual[] = {{{2, 2, 2}, 0, 0},  {{1, 0, 0}, 16, 10},
                                         {{1, 2, 0}, 16, 0}, {{1, 0.4f, 0}, 24, 12},
                                         {{1, 0, 0}, 16, 0}, {{0, 0, 0}, 0, 0}};
    static const int sizes[] = {3, 1, 2, 2, 0, 0};
    *s = usual[which];
    if (!take_sizes(w, s, sizes[which]))
        return false;
    if (which == SPHERE || which == TORUS)
        return take_counts(w, ROUND, &s->segments, &s->rings) && words_end(w);
    if (which == CYLINDER)
        return take_counts(w, MODEL_SEGMENTS, &s->segments, NULL) && words_end(w);
    if (which == VESSEL && words_next_is_number(w) &&
        !words_whole(w, 8, VESSEL_SEGMENTS, &s->segments))
        return false;
    return words_end(w);
}

/* Five vertices: a triangle and a quadrilateral that share E3. */
static bool make_pair(struct object *o)
{
    static const struct point2 at[] = {
        {-0.2f, 1}, {-1.4f, -0.3f}, {-0.1f, -1}, {1.2f, -0.6f}, {1.3f, 0.7f}};
    static const int s1[] = {0, 1, 2}, s2[] = {0, 2, 3, 4};
    for (int i = 0; i < 5; i++)
        object_vertex(o, at[i].x, at[i].y, 0);
    return object_polygon(o, s1, 3, 0) >= 0 && object_polygon(o, s2, 4, 0) >= 0;
}

static bool make_shape(struct object *o, int which, const struct shape *s)
{
    switch (which) {
    case BOX:
        return object_box(o, s->size[0], s->size[1], s->size[2], 0);
    case SPHERE:
        return object_sphere(o, s->size[0], s->segments, s->rings, 0);
    case CYLINDER:
        return object_cylinder(o, s->size[0], s->size[1], s->segments, 0);
    case TORUS:
        return object_torus(o, s->size[0], s->size[1], s->segments, s->rings, 0);
    case VESSEL:
        return object_vessel(o, 1, s->segments, 0);
    default:
        return make_pair(o);
    }
}

static bool object(struct monitor *m, struct words *w)
{
    struct object *o = present_object();
    struct shape shape;
    int which;
    if (!words_choice(w, shapes, &which) || !take_shape(w, which, &shape))
        return false;
    if (which == TORUS && shape.size[1] >= shape.size[0])
        return words_refuse(w, "the tube's radius must be below the ring's");
    struct object_attribute paint =
        scene_attribute("clay", which == VESSEL ? RAMP_GOLD : RAMP_COPPER);
    object_clear(o);
    object_attribute(o, &paint);
    make_shape(o, which, &shape);
    object_normals(o, NORMALS_CREASE);
    print_counts(o);
    draw_object(m, o, shapes[which]);
    return true;
}

static bool look(struct monitor *m, struct words *w)
{
    enum { ANGLE = 3600 };
    struct look at = {0, 0, 0};
    if (!words_bounded(w, -ANGLE, ANGLE, &at.yaw) || !words_bounded(w, -ANGLE, ANGLE, &at.pitch) ||
        (words_next_is_number(w) && !words_number(w, &at.eye)) || !words_end(w))
        return false;
    if (at.eye != 0 && !(at.eye >= 1.5f && at.eye <= 100))
        return words_refuse(w,
                            "the eye is 1.5 to 100 times the object's reach away, or 0: parallel");
    *present_look() = at;
    draw_object(m, present_object(), "The present object");
    return true;
}

/* ---- its tables ------------------------------------------------------------------------------ */

/* FROM TO, counted from 1; without them all. */
static bool take_rows(struct words *w, int count, int *from, int *to)
{
    *from = 1;
    *to = count;
    if (words_next_is_number(w) && !words_whole(w, 1, count, from))
        return false;
    if (words_next_is_number(w) && !words_whole(w, *from, count, to))
        return false;
    return words_end(w);
}

static bool vertices(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    int from, to;
    (void)m;
    if (!take_rows(w, o->vertices, &from, &to))
        return false;
    for (int i = from - 1; i < to; i++)
        printf("V%d: %.4f, %.4f, %.4f\n", i + 1, print_tidy(o->vertex[i].x),
               print_tidy(o->vertex[i].y), print_tidy(o->vertex[i].z));
    return true;
}

static void print_edges(const struct object *o, int from, int to)
{
    for (int i = from - 1; i < to; i++) {
        const struct object_edge *e = &o->edge[i];
        printf("E%d: V%d, V%d  ->", i + 1, e->vertex[0] + 1, e->vertex[1] + 1);
        for (int k = 0; k < 2; k++)
            if (e->polygon[k] != OBJECT_NONE)
                printf(" S%d", e->polygon[k] + 1);
        printf("\n");
    }
}

static bool edges(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    int from, to;
    (void)m;
    if (!take_rows(w, o->edges, &from, &to))
        return false;
    print_edges(o, from, to);
    return true;
}

static void print_polygons(const struct object *o, int from, int to)
{
    for (int i = from - 1; i < to; i++) {
        const struct object_polygon *p = &o->polygon[i];
        printf("S%d:", i + 1);
        for (int k = 0; k < p->count; k++)
            printf("%s E%d", k > 0 ? "," : "", o->side[p->first + k].edge + 1);
        printf("  (");
        for (int k = 0; k < p->count; k++)
            printf("%sV%d", k > 0 ? " " : "", object_corner(o, i, k) + 1);
        printf(")  A%d\n", p->attribute + 1);
    }
}

static bool polygons(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    int from, to;
    (void)m;
    if (!take_rows(w, o->polygons, &from, &to))
        return false;
    print_polygons(o, from, to);
    return true;
}

static bool attributes(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    (void)m;
    if (!words_end(w))
        return false;
    printf("    name      colours     ka     kd     ks        n  transparent\n");
    static const char *const ramps[] = {"grey", "copper", "green", "blue", "gold"};
    for (int i = 0; i < o->attributes; i++) {
        const struct object_attribute *a = &o->attribute[i];
        printf("A%d: %-9s %-7s %6.4f %6.4f %6.4f %8.4f %12.4f\n", i + 1, a->name,
               ramps[a->ramp % INK_RAMPS], (double)a->ambient, (double)a->diffuse,
               (double)a->specular, (double)a->shininess, (double)a->transparency);
    }
    return true;
}

/* ---- checks ---------------------------------------------------------------------------------- */

static void print_fault(const struct object_fault *f)
{
    switch (f->rule) {
    case RULE_VERTEX_ENDS:
        printf("   V%d is an end of %d edge%s\n", f->index + 1, f->other, f->other == 1 ? "" : "s");
        break;
    case RULE_EDGE_USED:
        printf("   E%d is part of no polygon\n", f->index + 1);
        break;
    case RULE_POLYGON_CLOSED:
        printf("   S%d is not closed\n", f->index + 1);
        break;
    case RULE_POLYGON_SHARED:
        printf("   S%d shares no edge\n", f->index + 1);
        break;
    default:
        printf("   E%d and S%d: only one points to the other\n", f->index + 1, f->other + 1);
    }
}

/* A line a rule, and one a fault. True: there is none. */
static bool print_checks(const struct object *o)
{
    static struct object_check check;
    struct object_fault fault;
    object_check_begin(&check, o);
    bool more = object_check_next(&check, &fault), right = !more;
    for (int rule = 0; rule < OBJECT_RULES; rule++) {
        bool holds = !more || fault.rule != (enum object_rule)rule;
        printf("%d  %-52s %s\n", rule + 1, object_rule_text((enum object_rule)rule),
               holds ? "yes" : "NO");
        for (; more && fault.rule == (enum object_rule)rule;
             more = object_check_next(&check, &fault))
            print_fault(&fault);
    }
    return right;
}

static bool check(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    char title[40] = "The present object";
    int which;
    if (words_left(w) > 0) {
        if (!words_choice(w, broken_names, &which) || !words_end(w))
            return false;
        object_broken(&workroom()->object, which);
        o = &workroom()->object;
        snprintf(title, sizeof title, "A pyramid: %s", broken_names[which]);
        if (m->table) {
            print_edges(o, 1, o->edges);
            print_polygons(o, 1, o->polygons);
        }
    }
    printf("%s\n", print_checks(o) ? "The tables are free of errors." : "The tables are wrong.");
    draw_object(m, o, title);
    return true;
}

/* ---- planes ---------------------------------------------------------------------------------- */

static const char *side_text(float value)
{
    return value > 0 ? "outside" : value < 0 ? "inside" : "on the plane";
}

static void line3(struct stage *stage, const struct view *view, struct vector3 a, struct vector3 b)
{
    a = view_place(view, a);
    b = view_place(view, b);
    stage_line(stage, a.x, a.y, b.x, b.y);
}

static void text3(struct stage *stage, const struct view *view, struct vector3 at, const char *text)
{
    at = view_place(view, at);
    stage_text(stage, at.x + 8, at.y + 6, text);
}

static void draw_axes(struct stage *stage, const struct view *view, float length)
{
    static const char *const names[] = {"x", "y", "z"};
    struct vector3 origin = {0, 0, 0};
    const struct vector3 ends[] = {{length, 0, 0}, {0, length, 0}, {0, 0, length}};
    stage_ink(stage, INK_GRID);
    for (int i = 0; i < 3; i++) {
        line3(stage, view, origin, ends[i]);
        text3(stage, view, ends[i], names[i]);
    }
}

/* The triangle with its normal; the point, if there is one, with its way to the plane. */
static void draw_plane(struct monitor *m, const struct vector3 p[3], const struct plane *plane,
                       const struct vector3 *point)
{
    struct stage *stage = &m->stage;
    struct vector3 n = plane_normal(plane), middle = {0, 0, 0};
    float reach = point != NULL ? vector3_length(*point) : 0;
    for (int i = 0; i < 3; i++) {
        middle = vector3_sum(middle, vector3_times(p[i], 1.0f / 3));
        reach = fmaxf(reach, vector3_length(p[i]));
    }
    struct matrix4 turn = view_turn(-38, 18);
    struct view view = view_on_stage(&turn, 0, 400 / reach, 560, 330);
    stage_begin(stage);
    stage_title(stage, "A plane through three points");
    draw_axes(stage, &view, reach);
    stage_ink(stage, INK_YELLOW);
    for (int i = 0; i < 3; i++) {
        static const char *const names[] = {"P1", "P2", "P3"};
        line3(stage, &view, p[i], p[(i + 1) % 3]);
        text3(stage, &view, p[i], names[i]);
    }
    struct vector3 tip = vector3_sum(middle, vector3_times(n, reach / 3));
    stage_ink(stage, INK_GREEN);
    line3(stage, &view, middle, tip);
    text3(stage, &view, tip, "N");
    if (point != NULL) {
        float away = plane_value(plane, *point) /
                     vector3_length((struct vector3){plane->a, plane->b, plane->c});
        struct vector3 at = view_place(&view, *point);
        stage_ink(stage, INK_RED);
        stage_marker(stage, at.x, at.y);
        line3(stage, &view, *point, vector3_difference(*point, vector3_times(n, away)));
        text3(stage, &view, *point, away > 0 ? "outside" : away < 0 ? "inside" : "on the plane");
    }
    stage_end(stage);
}

static bool plane(struct monitor *m, struct words *w)
{
    enum { FARTHEST = 10000 /* D grows with the third power */ };
    struct vector3 at[3], q = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        if (!words_vector(w, FARTHEST, &at[i]))
            return false;
    bool has_point = words_take(w, "at");
    if ((has_point && !words_vector(w, FARTHEST, &q)) || !words_end(w))
        return false;
    struct plane p = plane_through(at[0], at[1], at[2]);
    if (p.a == 0 && p.b == 0 && p.c == 0)
        return words_refuse(w, "the points lie on a line");
    printf("A = %.4f  B = %.4f  C = %.4f  D = %.4f\n", print_tidy(p.a), print_tidy(p.b),
           print_tidy(p.c), print_tidy(p.d));
    printf("N = ");
    print_vector3(plane_normal(&p));
    printf("\n");
    if (has_point) {
        float value = plane_value(&p, q);
        print_vector3(q);
        printf(": Ax + By + Cz + D = %.4f, %s\n", print_tidy(value), side_text(value));
    }
    draw_plane(m, at, &p, has_point ? &q : NULL);
    return true;
}

static bool inside(struct monitor *m, struct words *w)
{
    const struct object *o = present_object();
    struct vector3 at;
    int first = -1;
    (void)m;
    if (!words_vector(w, WORDS_FARTHEST, &at) || !words_end(w))
        return false;
    int outside = solid_planes_outside(o, at, &first);
    print_vector3(at);
    if (outside == 0)
        printf(": inside of all %d planes; within the solid if it is convex\n", o->polygons);
    else
        printf(": outside of %d of %d planes, the first is that of S%d\n", outside, o->polygons,
               first + 1);
    return true;
}

const struct command commands_solids[] = {
    {"object",
     "box [w h d]|sphere [r [SEGMENTS [RINGS]]]|cylinder [r h [SEGMENTS]]|"
     "torus [R r [SEGMENTS [RINGS]]]|vessel [SEGMENTS]|pair",
     "makes the present object and draws it", object},
    {"look", "YAW PITCH [EYE]", "turns the present object; EYE: how many times its reach away",
     look},
    {"vertices", "[FROM [TO]]", "the present object's vertex table", vertices},
    {"edges", "[FROM [TO]]", "its edge table, with the pointers to polygons", edges},
    {"polygons", "[FROM [TO]]", "its polygon table: edges, corners, attribute", polygons},
    {"attributes", "", "its attribute table", attributes},
    {"check", "[vertex|edge|open|alone|pointer|whole]",
     "checks the tables of the present object, or of a broken one", check},
    {"plane", "x1 y1 z1 x2 y2 z2 x3 y3 z3 [at x y z]", "the plane through three points", plane},
    {"inside", "x y z", "is a point inside of the planes of the present object?", inside},
    {NULL, NULL, NULL, NULL},
};
