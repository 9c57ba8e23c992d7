/* gallery_cad.c — computer-aided design: a bracket in three elevations and an isometric view, its
 * hidden edges dashed, its dimensions measured; whoever changes one changes every view. */
#include <stddef.h>
#include <stdio.h>

#include "roms/geometry/scalar.h"
#include "roms/scenery/depth.h"
#include "roms/lessons/lesson.h"
#include "roms/scenery/workroom.h"
#include "roms/solids/bracket.h"
#include "roms/visible/depth_surface.h"

enum { DIMENSIONS = 6 };

static struct cad {
    float value[DIMENSIONS]; /* millimetres, as in struct bracket */
    int chosen;
    bool by_hand;
    bool hidden; /* dashed edges are drawn */
} cad;

static const struct dimension {
    const char *name;
    float usual, low, high;
} dimensions[DIMENSIONS] = {
    {"width", 60, 30, 72},    {"height", 62, 36, 70},    {"depth", 70, 40, 78},
    {"thickness", 12, 6, 18}, {"upper hole", 28, 8, 48}, {"lower hole", 24, 8, 44},
};

static struct bracket part(const struct cad *c)
{
    const float *v = c->value;
    return (struct bracket){v[0], v[1], v[2], v[3], v[4], v[5]};
}

static void begin(void *state)
{
    struct cad *c = state;
    *c = (struct cad){.hidden = true};
    for (int i = 0; i < DIMENSIONS; i++)
        c->value[i] = dimensions[i].usual;
}

/* Changes a dimension if the part stays one. */
static void change(struct cad *c, int which, float by)
{
    const struct dimension *d = &dimensions[which];
    float before = c->value[which];
    c->value[which] = fminf(fmaxf(before + by, d->low), d->high);
    struct bracket b = part(c);
    if (!bracket_fits(&b))
        c->value[which] = before;
}

static void key(void *state, int k)
{
    struct cad *c = state;
    if (k == 'h') {
        c->hidden = !c->hidden;
        return;
    }
    if (k == KEY_DOWN)
        c->chosen = (c->chosen + 1) % DIMENSIONS;
    else if (k == KEY_UP)
        c->chosen = (c->chosen + DIMENSIONS - 1) % DIMENSIONS;
    else if (k == '+' || k == '=')
        change(c, c->chosen, 2);
    else if (k == '-')
        change(c, c->chosen, -2);
    else if (k != 'p')
        return;
    c->by_hand = k != 'p' || !c->by_hand;
}

/* One dimension after the other swings about its usual value. */
static void change_by_time(struct cad *c, float seconds)
{
    enum { SWING = 4 };
    int which = (int)(seconds / SWING) % DIMENSIONS;
    float angle = TURN * fmodf(seconds, SWING) / SWING;
    for (int i = 0; i < DIMENSIONS; i++)
        c->value[i] = dimensions[i].usual;
    change(c, which, 0.22f * dimensions[which].usual * sinf(angle));
    c->chosen = which;
}

/* ---- views ----------------------------------------------------------------------------------- */

static void dashed(struct stage *stage, struct vector3 a, struct vector3 b)
{
    const float dash = 9, gap = 8;
    float dx = b.x - a.x, dy = b.y - a.y, length = sqrtf(dx * dx + dy * dy);
    for (float at = 0; at < length; at += dash + gap) {
        float end = fminf(at + dash, length);
        stage_line(stage, a.x + dx * at / length, a.y + dy * at / length, a.x + dx * end / length,
                   a.y + dy * end / length);
    }
}

/* The part's edges: those that are seen, and those that are not. */
static void edges(const struct cad *c, struct stage *stage, const struct scene *scene)
{
    struct hidden_lines *h = &workroom()->hidden;
    struct hidden_part p;
    hidden_begin(h, scene, EDGES_CREASED);
    while (hidden_next(h, &p)) {
        stage_ink(stage, p.seen ? INK_BRIGHT : INK_GRID);
        if (p.seen)
            stage_line(stage, p.a.x, p.a.y, p.b.x, p.b.y);
        else if (c->hidden)
            dashed(stage, p.a, p.b);
    }
}

enum { SIDE_X = 980, FRONT_X = 560, ELEVATION_Y = 420, PLAN_Y = 330 };
static const float scale = 3.3f; /* stage units a millimetre */

/* A view whose turn puts the part's (0, 0, 0) at a place. */
static void elevation(const struct cad *c, struct stage *stage, const struct matrix4 *turn, float x,
                      float y)
{
    struct scene *scene = &workroom()->lines;
    struct view view = view_on_stage(turn, 0, scale, x, y);
    scene_clear(scene);
    if (scene_add(scene, &workroom()->object, &view, 0, 0))
        edges(c, stage, scene);
}

/* Rows: where x, y, z of the part go. */
static struct matrix4 turned(float xx, float xz, float yy, float yz, float zx, float zy, float zz)
{
    struct matrix4 m = {{{xx, 0, xz, 0}, {0, yy, yz, 0}, {zx, zy, zz, 0}, {0, 0, 0, 1}}};
    return m;
}

static void isometric(const struct cad *c, struct stage *stage)
{
    struct workroom *w = workroom();
    struct matrix4 turn = view_turn(-45, 35.264f);
    struct bracket b = part(c);
    struct vector3 middle = {0, b.height * 0.5f, b.depth * 0.4f};
    struct vector3 at = matrix4_apply(&turn, middle);
    const float size = 3.1f, x = 240 - at.x * size, y = 220 - at.y * size;
    struct view units = view_on_stage(&turn, 0, size, x, y);
    struct view dots = view_on_canvas(stage, &turn, 0, size, x, y);
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    scene_clear(&w->scene);
    scene_clear(&w->lines);
    if (!scene_add(&w->scene, &w->object, &dots, SCENE_CULLED, 0) ||
        !scene_add(&w->lines, &w->object, &units, SCENE_CULLED, 0))
        return;
    scene_shade(&w->scene, &w->object);
    if (depth.width > 0) {
        depth_clear(&depth, -1e9f);
        depth_scene(&stage->canvas, &depth, &w->scene);
    }
    stage_ink(stage, INK_BRIGHT);
    stage_hidden_lines(stage, &w->lines, EDGES_CREASED);
}

/* ---- dimensions ------------------------------------------------------------------------------ */

static void arrow(struct stage *stage, float x, float y, float dx, float dy)
{
    const float long_side = 12, half = 4;
    stage_line(stage, x, y, x - long_side * dx - half * dy, y - long_side * dy + half * dx);
    stage_line(stage, x, y, x - long_side * dx + half * dy, y - long_side * dy - half * dx);
}

static enum ink dimension_ink(const struct cad *c, int which)
{
    return c->chosen == which ? INK_YELLOW : INK_CYAN;
}

/* From x0 to x1 at height y; extension lines come from `from`. */
static void across(const struct cad *c, struct stage *stage, int which, float x0, float x1, float y,
                   float from)
{
    char text[16];
    float out = y > from ? 8 : -8;
    stage_ink(stage, dimension_ink(c, which));
    stage_line(stage, x0, y, x1, y);
    stage_line(stage, x0, from + out, x0, y + out);
    stage_line(stage, x1, from + out, x1, y + out);
    arrow(stage, x0, y, -1, 0);
    arrow(stage, x1, y, 1, 0);
    snprintf(text, sizeof text, "%.0f", (double)c->value[which]);
    if (x1 - x0 > 60)
        stage_text_middle(stage, (x0 + x1) / 2, y + 8, text);
    else
        stage_text(stage, x1 + 12, y - 6, text);
}

static void upright(const struct cad *c, struct stage *stage, int which, float y0, float y1,
                    float x, float from)
{
    char text[16];
    float out = x > from ? 8 : -8;
    stage_ink(stage, dimension_ink(c, which));
    stage_line(stage, x, y0, x, y1);
    stage_line(stage, from + out, y0, x + out, y0);
    stage_line(stage, from + out, y1, x + out, y1);
    arrow(stage, x, y0, 0, -1);
    arrow(stage, x, y1, 0, 1);
    snprintf(text, sizeof text, "%.0f", (double)c->value[which]);
    stage_text(stage, x + 12, (y0 + y1) / 2 - 8, text);
}

/* A hole's diameter, at the end of a line through its middle that leaves the part. */
static void diameter(const struct cad *c, struct stage *stage, int which, float x, float y)
{
    char text[16];
    float r = c->value[which] / 2 * scale, k = 0.7071f;
    float end = (c->value[0] / 2 * scale + 16) / k;
    stage_ink(stage, dimension_ink(c, which));
    stage_line(stage, x - k * r, y - k * r, x + k * end, y + k * end);
    arrow(stage, x - k * r, y - k * r, -k, -k);
    arrow(stage, x + k * r, y + k * r, k, k);
    snprintf(text, sizeof text, "d %.0f", (double)c->value[which]);
    stage_text(stage, x + k * end + 6, y + k * end, text);
}

/* A chain line through a hole's middle. */
static void centre_lines(struct stage *stage, float x, float y, float half)
{
    stage_ink(stage, INK_RED);
    dashed(stage, (struct vector3){x - half, y, 0}, (struct vector3){x + half, y, 0});
    dashed(stage, (struct vector3){x, y - half, 0}, (struct vector3){x, y + half, 0});
}

static void dimension_views(const struct cad *c, struct stage *stage)
{
    struct bracket b = part(c);
    float half = b.width / 2 * scale, front = FRONT_X,
          top = ELEVATION_Y + (b.height + b.width / 2) * scale;
    float hole_y = ELEVATION_Y + b.height * scale, side = SIDE_X - b.depth * scale / 2;
    float lower = bracket_lower_z(&b) * scale;
    centre_lines(stage, front, hole_y, b.upper_diameter / 2 * scale + 14);
    centre_lines(stage, front, PLAN_Y - lower, b.lower_diameter / 2 * scale + 14);
    across(c, stage, 0, front - half, front + half, PLAN_Y - b.depth * scale - 34,
           PLAN_Y - b.depth * scale);
    diameter(c, stage, 4, front, hole_y);
    diameter(c, stage, 5, front, PLAN_Y - lower);
    upright(c, stage, 1, ELEVATION_Y, hole_y, front + half + 34, front + half);
    across(c, stage, 2, side, side + b.depth * scale, ELEVATION_Y - 44, ELEVATION_Y);
    across(c, stage, 3, side, side + b.thickness * scale, top + 24, top);
}

static void list(const struct cad *c, struct stage *stage)
{
    char text[40];
    for (int i = 0; i < DIMENSIONS; i++) {
        stage_ink(stage, c->chosen == i ? INK_YELLOW : INK_TEXT);
        snprintf(text, sizeof text, "%-11s%3.0f mm", dimensions[i].name, (double)c->value[i]);
        stage_text(stage, 20, 740 - 40 * (float)i, text);
    }
}

static float draw(void *state, struct stage *stage, float seconds)
{
    struct cad *c = state;
    if (!c->by_hand)
        change_by_time(c, seconds);
    struct bracket b = part(c);
    struct object *o = &workroom()->object;
    struct object_attribute steel = scene_attribute("steel", RAMP_BLUE);
    object_clear(o);
    object_attribute(o, &steel);
    object_bracket(o, &b, 0);
    isometric(c, stage);
    struct matrix4 front = matrix4_identity();
    struct matrix4 plan = turned(1, 0, 0, -1, 0, 1, 0), side = turned(0, 1, 1, 0, -1, 0, 0);
    elevation(c, stage, &front, FRONT_X, ELEVATION_Y);
    elevation(c, stage, &plan, FRONT_X, PLAN_Y);
    elevation(c, stage, &side, SIDE_X - b.depth * scale / 2, ELEVATION_Y);
    dimension_views(c, stage);
    list(c, stage);
    stage_title(stage, "A bracket: front, side, plan, isometric");
    stage_caption(stage, "One model, four views: change a dimension and all of them follow. Hidden "
                         "edges are dashed.");
    return 0;
}

extern const struct lesson lesson_gallery_cad;
const struct lesson lesson_gallery_cad = {"cad",
                                          "Gallery: computer-aided design",
                                          "up down dimension  + - change  p pause  h hidden edges",
                                          &cad,
                                          begin,
                                          key,
                                          draw};
