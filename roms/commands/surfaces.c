/* surfaces.c — visible surfaces: back faces, and pictures by each method. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "roms/commands/solids.h"
#include "roms/commands/surface_picture.h"
#include "roms/monitor/command.h"
#include "roms/monitor/print.h"
#include "roms/visible/back_face.h"

/* ---- back faces ------------------------------------------------------------------------------ */

enum { PARALLEL, EYE };

/* The present object, edges of back faces alone dim. */
static void draw_faces(struct monitor *m, const struct object *o, const bool *back)
{
    struct workroom *room = workroom();
    const struct look *look = present_look();
    struct matrix4 turn = view_turn(look->yaw, look->pitch);
    float reach = object_reach(o);
    struct view view = view_on_stage(&turn, look->eye * reach, 360 / reach, 600, 400);
    scene_clear(&room->lines);
    stage_begin(&m->stage);
    stage_title(&m->stage, "Back faces (dim)");
    scene_add(&room->lines, o, &view, 0, 0);
    for (int i = 0; i < room->lines.edges; i++) {
        const struct object_edge *e = &o->edge[i];
        bool dim = back[e->polygon[0]] && (e->polygon[1] == OBJECT_NONE || back[e->polygon[1]]);
        struct vector3 a = room->lines.vertex[e->vertex[0]], b = room->lines.vertex[e->vertex[1]];
        stage_ink(&m->stage, dim ? INK_GRID : INK_GREEN);
        stage_line(&m->stage, a.x, a.y, b.x, b.y);
    }
    stage_end(&m->stage);
}

static bool back_face(struct monitor *m, struct words *w)
{
    static const char *const kinds[] = {"parallel", "eye", NULL};
    static bool is_back[OBJECT_POLYGONS];
    const struct object *o = present_object();
    struct vector3 view;
    int kind, back = 0;
    if (!words_choice(w, kinds, &kind))
        return false;
    bool taken = kind == PARALLEL ? words_direction(w, 3, WORDS_FARTHEST, &view)
                                  : words_vector(w, WORDS_FARTHEST, &view);
    if (!taken || !words_end(w))
        return false;
    printf("           A        B        C        D %9s  polygon  by the sign of D\n",
           kind == PARALLEL ? "V.N" : "at E");
    for (int i = 0; i < o->polygons; i++) {
        struct plane p = plane_of_polygon(o, i);
        struct vector3 n = {p.a, p.b, p.c};
        bool hidden =
            kind == PARALLEL ? back_face_parallel(n, view) : back_face_perspective(&p, view);
        bool edge_on = kind == PARALLEL && vector3_dot(n, view) == 0;
        back += hidden;
        is_back[i] = hidden;
        printf("S%-4d %8.4f %8.4f %8.4f %8.4f %9.4f  %-7s  %s\n", i + 1, print_tidy(p.a),
               print_tidy(p.b), print_tidy(p.c), print_tidy(p.d),
               print_tidy(kind == PARALLEL ? vector3_dot(n, view) : plane_value(&p, view)),
               hidden    ? "back"
               : edge_on ? "edge-on"
                         : "front",
               p.d < 0   ? "front"
               : p.d > 0 ? "back"
                         : "-");
    }
    printf("%d of %d polygons are back faces\n", back, o->polygons);
    draw_faces(m, o, is_back);
    return true;
}

/* ---- tables of the methods ------------------------------------------------------------------- */

static int pixels_of(const struct scene *scene, const struct surface *s)
{
    struct surface_scan row;
    int count = 0;
    surface_scan_begin(&row, scene, s, SURFACE_WIDTH, SURFACE_HEIGHT);
    while (surface_scan_next(&row))
        count += row.x1 > row.x0 ? row.x1 - row.x0 : 0;
    return count;
}

static void table_depth_buffer(const struct scene *scene)
{
    printf("          A       B       C          D    -A/C    -B/C  pixels\n");
    for (int i = 0; i < scene->surfaces; i++) {
        const struct surface *s = &scene->surface[i];
        const struct plane *p = &s->plane;
        printf("S%-3d %7.4f %7.4f %7.4f %10.4f", s->polygon + 1, print_tidy(p->a), print_tidy(p->b),
               print_tidy(p->c), print_tidy(p->d));
        if (p->c != 0)
            printf(" %7.4f %7.4f %7d\n", print_tidy(-p->a / p->c), print_tidy(-p->b / p->c),
                   pixels_of(scene, s));
        else
            printf(" edge-on\n");
    }
}

static void print_run(const struct scan_line *s, const struct scan_run *run)
{
    const struct scene *scene = s->scene;
    printf("%4d %4d ", run->x0, run->x1 - 1);
    if (run->surface == SURFACE_NONE) {
        printf(" background\n");
        return;
    }
    for (int i = 0; i < s->flags; i++) {
        const struct surface *f = &scene->surface[s->flagged[i]];
        printf(" S%d", f->polygon + 1);
        if (s->flags > 1)
            printf(" z=%.4f", print_tidy(surface_depth(f, (float)run->x0, (float)s->y)));
    }
    printf("  -> S%d\n", scene->surface[run->surface].polygon + 1);
}

static void table_scan_line(const struct scene *scene, int row)
{
    struct scan_line *s = &workroom()->scan_line;
    struct scan_run run;
    scan_line_begin(s, scene, SURFACE_WIDTH, SURFACE_HEIGHT);
    while (scan_line_next(s) && s->y < row)
        ;
    printf("row %d: %d active edges\n         x    dx/dy  of\n", row, s->active_count);
    for (int i = 0; i < s->active_count; i++) {
        const struct scan_line_edge *e = &s->edge[s->active[i]];
        printf("%10.4f %8.4f  S%d\n", print_tidy(e->edge.x), print_tidy(e->edge.slope),
               scene->surface[e->surface].polygon + 1);
    }
    printf("pixels     flags on, depths where there are several\n");
    while (scan_line_run(s, &run))
        print_run(s, &run);
}

static void table_painter(const struct scene *scene)
{
    struct painter *p = &workroom()->painter;
    int count = 0;
    painter_begin(p, scene);
    printf("from far to near:");
    for (int s = painter_next(p); s >= 0; s = painter_next(p))
        printf("%sS%d", count++ % 12 == 0 ? "\n  " : " ", scene->surface[s].polygon + 1);
    printf("\n");
}

static void table_lines(const struct scene *scene)
{
    struct hidden_lines *h = &workroom()->hidden;
    struct hidden_part part;
    printf("               from                  to  of edge\n");
    hidden_begin(h, scene, EDGES_FOLDED);
    while (hidden_next(h, &part))
        printf("%9.4f %9.4f %9.4f %9.4f  V%d-V%d %s\n", print_tidy(part.a.x), print_tidy(part.a.y),
               print_tidy(part.b.x), print_tidy(part.b.y), scene->edge[part.edge].vertex[0] + 1,
               scene->edge[part.edge].vertex[1] + 1, part.seen ? "seen" : "hidden");
}

static void print_table(const struct scene *scene, enum surface_method method, int row)
{
    switch (method) {
    case METHOD_SCAN_LINE:
        table_scan_line(scene, row);
        break;
    case METHOD_PAINTER:
        table_painter(scene);
        break;
    case METHOD_LINES:
        table_lines(scene);
        break;
    default:
        table_depth_buffer(scene);
    }
}

/* ---- pictures -------------------------------------------------------------------------------- */

static int lit(const uint8_t *pixels)
{
    int count = 0;
    for (int i = 0; i < SURFACE_WIDTH * SURFACE_HEIGHT; i++)
        count += pixels[i] != INK_BLACK;
    return count;
}

static void print_answer(const struct scene *scene, enum surface_method method)
{
    if (method == METHOD_LINES) {
        struct hidden_lines *h = &workroom()->hidden;
        struct hidden_part part;
        int seen = 0, hidden = 0;
        hidden_begin(h, scene, EDGES_FOLDED);
        while (hidden_next(h, &part)) {
            seen += part.seen;
            hidden += !part.seen;
        }
        printf("%d parts of edges are seen, %d hidden\n", seen, hidden);
        return;
    }
    printf("%d surfaces; %d pixels lit\n", scene->surfaces, lit(surface_pixels(0)));
    if (method == METHOD_PAINTER && workroom()->painter.circles > 0)
        printf("Surfaces overlap in a circle or pierce each other: no order is right.\n");
}

static bool take_scene(struct words *w, int *which)
{
    *which = SCENE_OBJECT;
    if (words_left(w) == 0 || words_next_is(w, "row"))
        return true;
    return words_choice(w, scene_names, which);
}

static bool hidden(struct monitor *m, struct words *w)
{
    int method, which, row = SURFACE_HEIGHT / 2;
    if (!words_choice(w, surface_methods, &method) || !take_scene(w, &which))
        return false;
    if (words_take(w, "row") && !words_whole(w, 0, SURFACE_HEIGHT - 1, &row))
        return false;
    if (!words_end(w))
        return false;
    if (!surface_scene((enum scene_which)which, present_look()))
        return words_refuse(w, "the eye is too near; look from farther away");
    const struct scene *scene = &workroom()->scene;
    surface_draw(scene, (enum surface_method)method, 0);
    if (m->table)
        print_table(scene, (enum surface_method)method, row);
    print_answer(scene, (enum surface_method)method);
    surface_show(m, (enum surface_method)method, NULL);
    return true;
}

static bool count(struct monitor *m, struct words *w)
{
    int a, b, which, different = 0;
    if (!words_choice(w, surface_methods, &a) || !words_choice(w, surface_methods, &b) ||
        !take_scene(w, &which) || !words_end(w))
        return false;
    if (a == METHOD_LINES || b == METHOD_LINES)
        return words_refuse(w, "lines have no surfaces to compare");
    if (!surface_scene((enum scene_which)which, present_look()))
        return words_refuse(w, "the eye is too near; look from farther away");
    const struct scene *scene = &workroom()->scene;
    surface_draw(scene, (enum surface_method)a, 0);
    surface_draw(scene, (enum surface_method)b, 1);
    uint8_t *first = surface_pixels(0), *second = surface_pixels(1);
    for (int i = 0; i < SURFACE_WIDTH * SURFACE_HEIGHT; i++) {
        bool differs = first[i] != second[i];
        different += differs;
        if (differs)
            first[i] = INK_RED;
        else if (first[i] != INK_BLACK)
            first[i] = (uint8_t)ink_shade(RAMP_GREY, 0.12f);
    }
    printf("%s and %s differ in %d of %d pixels\n", surface_methods[a], surface_methods[b],
           different, SURFACE_WIDTH * SURFACE_HEIGHT);
    surface_show(m, METHOD_DEPTH_BUFFER, "Where the methods differ (red)");
    return true;
}

const struct command commands_surfaces[] = {
    {"back-face", "parallel vx vy vz|eye x y z",
     "the present object's back faces, looking along V or from E", back_face},
    {"hidden",
     "depth-buffer|scan-line|painter|lines|depth-from-0|all [object|solids|two|cycle|pierce] "
     "[row Y]",
     "what is seen, by a method; table on: its working (of a row)", hidden},
    {"count", "METHOD METHOD [object|solids|two|cycle|pierce]",
     "in how many pixels two methods differ", count},
    {NULL, NULL, NULL, NULL},
};
