/* solids.c — the lesson about polygon tables: models turn beside their tables; broken tables are
 * caught. */
#include <stddef.h>
#include <stdio.h>

#include "roms/scenery/depth.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/scenery/workroom.h"
#include "roms/solids/broken.h"
#include "roms/solids/models.h"
#include "roms/solids/normals.h"
#include "roms/solids/object_check.h"
#include "roms/visible/depth_surface.h"

enum { BOX, CYLINDER, SPHERE, TORUS, VESSEL, MODELS, PAGES = MODELS + OBJECT_RULES };
enum { PAGE_SECONDS = 8, MOST_NAMED = 40, LEFT = 395, MIDDLE = 400, COLUMN = 800, ROW = 37 };

static struct solids {
    int page;
    bool made; /* the page's object is in the workroom */
    bool wire;
    struct object_check check;
    struct object_fault fault;
    bool has_fault;
} solids;

static void begin(void *own)
{
    struct solids *s = own;
    s->wire = false;
}

static void turn(void *own, int page)
{
    struct solids *s = own;
    s->page = page;
    s->made = false;
}

static bool key(void *own, int k)
{
    struct solids *s = own;
    if (k != 'w')
        return false;
    s->wire = !s->wire;
    return true;
}

/* ---- objects --------------------------------------------------------------------------------- */

static void lower(struct object *o, float by)
{
    struct matrix4 m = matrix4_identity();
    m.at[1][3] = -by;
    object_transform(o, 0, &m);
}

static void make_model(struct object *o, int page)
{
    static const enum ink_ramp ramps[] = {RAMP_COPPER, RAMP_BLUE, RAMP_GREEN, RAMP_GOLD,
                                          RAMP_COPPER};
    struct object_attribute paint = scene_attribute("paint", ramps[page]);
    object_clear(o);
    object_attribute(o, &paint);
    if (page == BOX)
        object_box(o, 2.2f, 1.6f, 1.4f, 0);
    else if (page == CYLINDER)
        object_cylinder(o, 1, 2, 16, 0);
    else if (page == SPHERE)
        object_sphere(o, 1, 16, 10, 0);
    else if (page == TORUS)
        object_torus(o, 1, 0.42f, 20, 10, 0);
    else {
        object_vessel(o, 1, 12, 0);
        lower(o, 0.2f);
    }
}

static void make(struct solids *s)
{
    struct object *o = &workroom()->object;
    s->made = true;
    s->has_fault = false;
    if (s->page < MODELS) {
        make_model(o, s->page);
        return;
    }
    object_broken(o, s->page - MODELS);
    object_check_begin(&s->check, o);
    s->has_fault = object_check_next(&s->check, &s->fault);
}

/* ---- tables ---------------------------------------------------------------------------------- */

struct column {
    struct stage *stage;
    float y;
};

static void row(struct column *c, enum ink ink, const char *text)
{
    stage_ink(c->stage, ink);
    stage_text(c->stage, COLUMN, c->y, text);
    c->y -= ROW;
}

/* Two decimals, no minus before a zero. */
static double tidy(float v)
{
    return v > -0.005f && v < 0.005f ? 0 : (double)v;
}

static void vertex_row(struct column *c, const struct object *o, int i, enum ink ink)
{
    char text[40];
    struct vector3 v = o->vertex[i];
    snprintf(text, sizeof text, "V%-4d%6.2f%6.2f%6.2f", i + 1, tidy(v.x), tidy(v.y), tidy(v.z));
    row(c, ink, text);
}

static void edge_row(struct column *c, const struct object *o, int i, enum ink ink)
{
    char text[40];
    const struct object_edge *e = &o->edge[i];
    int n =
        snprintf(text, sizeof text, "E%-2d V%-2d V%-2d", i + 1, e->vertex[0] + 1, e->vertex[1] + 1);
    for (int k = 0; k < 2; k++)
        if (e->polygon[k] != OBJECT_NONE)
            n += snprintf(text + n, sizeof text - (size_t)n, " S%d", e->polygon[k] + 1);
    row(c, ink, text);
}

static void polygon_row(struct column *c, const struct object *o, int i, enum ink ink)
{
    char text[40];
    const struct object_polygon *p = &o->polygon[i];
    int n = snprintf(text, sizeof text, "S%-2d", i + 1);
    for (int k = 0; k < p->count && k < 4; k++)
        n += snprintf(text + n, sizeof text - (size_t)n, " E%d", o->side[p->first + k].edge + 1);
    if (p->count > 4)
        snprintf(text + n, sizeof text - (size_t)n, " ..");
    row(c, ink, text);
}

/* The polygon that is pointed out, its edges and its corners. */
static void tables_of(struct stage *stage, const struct object *o, int polygon)
{
    struct column c = {stage, 740};
    char text[40];
    const struct object_polygon *p = &o->polygon[polygon];
    int shown = p->count < 4 ? p->count : 4;
    snprintf(text, sizeof text, "%d VERTICES", o->vertices);
    row(&c, INK_CYAN, text);
    for (int k = 0; k < shown; k++)
        vertex_row(&c, o, object_corner(o, polygon, k), INK_TEXT);
    c.y -= ROW / 2;
    snprintf(text, sizeof text, "%d EDGES", o->edges);
    row(&c, INK_CYAN, text);
    for (int k = 0; k < shown; k++)
        edge_row(&c, o, o->side[p->first + k].edge, INK_TEXT);
    c.y -= ROW / 2;
    snprintf(text, sizeof text, "%d POLYGONS", o->polygons);
    row(&c, INK_CYAN, text);
    polygon_row(&c, o, polygon, INK_BRIGHT);
    c.y -= ROW / 2;
    snprintf(text, sizeof text, "V - E + S = %d", o->vertices - o->edges + o->polygons);
    row(&c, INK_GREEN, text);
}

static void report(struct stage *stage, const struct object *o, const struct solids *s)
{
    static const char *const rules[OBJECT_RULES] = {"vertex: two edges", "edge: in a polygon",
                                                    "polygon: closed", "polygon: shares",
                                                    "pointers back"};
    struct column c = {stage, 700};
    for (int i = 0; i < OBJECT_RULES; i++) {
        char text[40];
        bool wrong = s->has_fault && (int)s->fault.rule == i;
        snprintf(text, sizeof text, "%d %-19s%s", i + 1, rules[i], wrong ? "NO" : "ok");
        row(&c, wrong ? INK_RED : INK_TEXT, text);
    }
    c.y -= ROW;
    if (s->fault.rule == RULE_VERTEX_ENDS) {
        vertex_row(&c, o, s->fault.index, INK_RED);
        row(&c, INK_TEXT, "is no end of any edge");
    } else if (s->fault.rule == RULE_EDGE_USED) {
        edge_row(&c, o, s->fault.index, INK_RED);
        row(&c, INK_TEXT, "is in no polygon");
    } else if (s->fault.rule == RULE_RECIPROCAL) {
        edge_row(&c, o, s->fault.index, INK_RED);
        polygon_row(&c, o, s->fault.other, INK_TEXT);
        row(&c, INK_TEXT, "does not have that edge");
    } else {
        polygon_row(&c, o, s->fault.index, INK_RED);
        row(&c, INK_TEXT,
            s->fault.rule == RULE_POLYGON_CLOSED ? "does not come back" : "shares no edge");
    }
}

/* ---- pictures -------------------------------------------------------------------------------- */

static void label(struct stage *stage, struct vector3 at, char letter, int number)
{
    char text[16];
    snprintf(text, sizeof text, "%c%d", letter, number + 1);
    stage_text(stage, at.x + 8, at.y + 6, text);
}

static void edge_line(struct stage *stage, const struct scene *scene, const struct object *o, int e)
{
    struct vector3 a = scene->vertex[o->edge[e].vertex[0]], b = scene->vertex[o->edge[e].vertex[1]];
    stage_line(stage, a.x, a.y, b.x, b.y);
}

/* A polygon's edges and corners with their names. */
static void outline(struct stage *stage, const struct scene *scene, const struct object *o, int p)
{
    for (int k = 0; k < o->polygon[p].count; k++) {
        edge_line(stage, scene, o, o->side[o->polygon[p].first + k].edge);
        int v = object_corner(o, p, k);
        if (o->polygons <= MOST_NAMED && o->polygon[p].count <= 4)
            label(stage, scene->vertex[v], 'V', v);
    }
}

static void shaded(struct stage *stage, struct scene *scene, const struct object *o)
{
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    if (depth.width == 0)
        return;
    scene_shade(scene, o);
    depth_clear(&depth, -1e9f);
    depth_scene(&stage->canvas, &depth, scene);
}

/* The polygon whose turn it is, among those that face the viewer. */
static int pointed_out(const struct scene *scene, float seconds)
{
    int middle = scene->surfaces / 2, step = (int)(seconds / 2);
    return scene->surfaces == 0 ? 0 : scene->surface[(middle + step * 7) % scene->surfaces].polygon;
}

static void draw_model(struct solids *s, struct stage *stage, float seconds)
{
    struct workroom *room = workroom();
    const struct object *o = &room->object;
    struct matrix4 turn = view_turn(18 * seconds, 24);
    float scale = 380 / object_reach(o);
    struct view dots = view_on_canvas(stage, &turn, 0, scale, LEFT, MIDDLE);
    struct view units = view_on_stage(&turn, 0, scale, LEFT, MIDDLE);
    scene_clear(&room->lines);
    scene_add(&room->lines, o, &units, SCENE_CULLED, 0);
    if (!s->wire) {
        scene_clear(&room->scene);
        scene_add(&room->scene, o, &dots, SCENE_CULLED, 0);
        shaded(stage, &room->scene, o);
    }
    stage_heads(stage, s->wire ? STAGE_BOTH : STAGE_VECTOR);
    stage_ink(stage, INK_GREEN);
    stage_hidden_lines(stage, &room->lines, EDGES_FOLDED);
    stage_heads(stage, STAGE_BOTH);
    int polygon = pointed_out(&room->lines, seconds);
    stage_ink(stage, INK_BRIGHT);
    outline(stage, &room->lines, o, polygon);
    tables_of(stage, o, polygon);
    stage_caption(stage, "Each polygon points to its edges, each edge to its two vertices and back "
                         "to its polygons.");
}

static void point_at_fault(struct stage *stage, const struct scene *scene, const struct object *o,
                           const struct object_fault *f)
{
    stage_ink(stage, INK_RED);
    if (f->rule == RULE_VERTEX_ENDS) {
        stage_marker(stage, scene->vertex[f->index].x, scene->vertex[f->index].y);
        label(stage, scene->vertex[f->index], 'V', f->index);
        return;
    }
    if (f->rule == RULE_POLYGON_CLOSED || f->rule == RULE_POLYGON_SHARED) {
        const struct object_polygon *p = &o->polygon[f->index];
        for (int k = 0; k < p->count; k++)
            edge_line(stage, scene, o, o->side[p->first + k].edge);
        return;
    }
    const struct object_edge *e = &o->edge[f->index];
    struct vector3 a = scene->vertex[e->vertex[0]], b = scene->vertex[e->vertex[1]];
    edge_line(stage, scene, o, f->index);
    label(stage, vector3_times(vector3_sum(a, b), 0.5f), 'E', f->index);
}

static void draw_broken(struct solids *s, struct stage *stage, float seconds)
{
    struct workroom *room = workroom();
    const struct object *o = &room->object;
    struct matrix4 turn = view_turn(25 * sinf(0.7f * seconds) - 25, 20);
    float scale = fminf(395 / object_reach(o), 260);
    float left = s->fault.rule == RULE_POLYGON_SHARED ? 300 : 380;
    struct view units = view_on_stage(&turn, 0, scale, left, 390);
    scene_clear(&room->lines);
    scene_add(&room->lines, o, &units, 0, 0);
    stage_ink(stage, INK_GREEN);
    stage_wireframe(stage, &room->lines);
    stage_ink(stage, INK_TEXT);
    for (int i = 0; i < o->vertices; i++)
        if (!(s->fault.rule == RULE_VERTEX_ENDS && i == s->fault.index))
            label(stage, room->lines.vertex[i], 'V', i);
    if (s->has_fault)
        point_at_fault(stage, &room->lines, o, &s->fault);
    report(stage, o, s);
    stage_caption(stage, "One mistake in the tables: one guideline catches it, and says where.");
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    static const char *const titles[PAGES] = {
        "Solids: a box",          "Solids: a cylinder",      "Solids: a sphere",
        "Solids: a torus",        "Solids: a vessel",        "Broken: a lonely vertex",
        "Broken: an unused edge", "Broken: an open polygon", "Broken: a lonely polygon",
        "Broken: a wrong pointer"};
    struct solids *s = own;
    if (!s->made)
        make(s);
    if (page < MODELS)
        draw_model(s, stage, seconds);
    else
        draw_broken(s, stage, seconds);
    stage_title(stage, titles[page]);
    return PAGE_SECONDS;
}

static struct pages pages = {
    .count = PAGES, .own = &solids, .begin = begin, .turn = turn, .draw = draw, .key = key};

extern const struct lesson lesson_solids;
const struct lesson lesson_solids = {"solids",
                                     "Solids and their tables",
                                     PAGES_KEYS "  w wireframe",
                                     &pages,
                                     pages_begin,
                                     pages_key,
                                     pages_draw};
