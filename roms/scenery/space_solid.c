#include "roms/scenery/space_solid.h"

#include <math.h>
#include <stdio.h>

#include "roms/geometry/projection_perspective.h"
#include "roms/geometry/scalar.h"
#include "roms/geometry/transform3.h"
#include "roms/raster/polygon_fill.h"

/* A solid where it is drawn. */
struct drawn {
    const struct space_view *view;
    const struct space_solid *solid;
    struct vector3 world[SPACE_CORNERS];
    struct point2 at[SPACE_CORNERS];
    bool seen[SPACE_CORNERS];
    bool faces[SPACE_FACES]; /* the viewer */
    bool mirrored;
};

void space_fit(struct space_view *view, float left, float bottom, float width, float height,
               const struct point2 *places, int count)
{
    struct point2 low = places[0], high = places[0];
    for (int i = 1; i < count; i++) {
        low = (struct point2){scalar_min(low.x, places[i].x), scalar_min(low.y, places[i].y)};
        high = (struct point2){scalar_max(high.x, places[i].x), scalar_max(high.y, places[i].y)};
    }
    float across = scalar_max(high.x - low.x, 1e-6f), up = scalar_max(high.y - low.y, 1e-6f);
    view->scale = scalar_min(width / across, height / up);
    view->x = left + width / 2 - view->scale * (low.x + high.x) / 2;
    view->y = bottom + height / 2 - view->scale * (low.y + high.y) / 2;
}

bool space_place(const struct space_view *view, struct vector3 p, struct point2 *out)
{
    struct point2 at;
    if (!projection_place(&view->projection, p, &at))
        return false;
    *out = (struct point2){view->x + view->scale * at.x, view->y + view->scale * at.y};
    return true;
}

void space_line(const struct space_view *view, struct vector3 a, struct vector3 b)
{
    struct point2 from, to;
    if (space_place(view, a, &from) && space_place(view, b, &to))
        stage_line(view->stage, from.x, from.y, to.x, to.y);
}

void space_text(const struct space_view *view, struct vector3 at, const char *text)
{
    struct point2 p;
    if (space_place(view, at, &p) && p.x > 0 && p.x < STAGE_WIDTH - 40 && p.y > 0 &&
        p.y < STAGE_HEIGHT - 30)
        stage_text(view->stage, p.x + 8, p.y + 4, text);
}

/* ---- axes ------------------------------------------------------------------------------------ */

static const struct vector3 unit[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* An arrow along an axis; its head and ticks lie along another one. */
static void arrow(const struct space_view *view, struct vector3 tip, struct vector3 across)
{
    struct vector3 neck = vector3_times(tip, 0.94f);
    float wide = 0.02f * vector3_length(tip);
    space_line(view, (struct vector3){0, 0, 0}, tip);
    space_line(view, tip, vector3_sum(neck, vector3_times(across, wide)));
    space_line(view, tip, vector3_sum(neck, vector3_times(across, -wide)));
}

float space_round(float at_least)
{
    float power = powf(10, floorf(log10f(at_least)));
    float digit = at_least / power;
    return power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
}

/* Ticks at round places; the last one has its figure. */
static void ticks(const struct space_view *view, struct vector3 along, struct vector3 across,
                  float length)
{
    float step = space_round(length / 6), wide = 0.012f * length;
    int count = (int)(0.9f * length / step);
    for (int i = 1; i <= count; i++) {
        struct vector3 at = vector3_times(along, (float)i * step);
        space_line(view, at, vector3_sum(at, vector3_times(across, -wide)));
        if (i == count) {
            char text[16];
            snprintf(text, sizeof text, "%g", (double)((float)i * step));
            space_text(view, vector3_sum(at, vector3_times(across, -8 * wide)), text);
        }
    }
}

void space_axes(const struct space_view *view, float length, bool negative)
{
    static const enum ink inks[] = {INK_RED, INK_GREEN, INK_CYAN};
    static const char *const names[] = {"x", "y", "z"};
    enum ink before = view->stage->ink;
    for (int i = 0; i < 3; i++) {
        struct vector3 tip = vector3_times(unit[i], length), across = unit[i == 1 ? 0 : 1];
        stage_ink(view->stage, INK_GRID);
        if (negative)
            space_line(view, (struct vector3){0, 0, 0}, vector3_times(tip, -1));
        stage_ink(view->stage, inks[i]);
        arrow(view, tip, across);
        ticks(view, unit[i], across, length);
        space_text(view, vector3_times(tip, 1.05f), names[i]);
    }
    stage_ink(view->stage, before);
}

/* ---- faces ----------------------------------------------------------------------------------- */

static bool faces_viewer(const struct drawn *d, const struct space_face *f)
{
    float area = 0;
    for (int i = 0; i < f->corners; i++) {
        struct point2 a = d->at[f->corner[i]], b = d->at[f->corner[(i + 1) % f->corners]];
        area += a.x * b.y - a.y * b.x;
    }
    return d->mirrored ? area < 0 : area > 0;
}

static bool whole(const struct drawn *d, const struct space_face *f)
{
    for (int i = 0; i < f->corners; i++)
        if (!d->seen[f->corner[i]])
            return false;
    return true;
}

static uint32_t shade(const struct drawn *d, const struct space_face *f)
{
    const struct vector3 light = {-0.42f, 0.7f, 0.58f};
    const struct vector3 *w = d->world;
    struct vector3 a = vector3_difference(w[f->corner[1]], w[f->corner[0]]);
    struct vector3 b = vector3_difference(w[f->corner[2]], w[f->corner[0]]);
    struct vector3 n = vector3_direction(vector3_cross(a, b));
    float facing = vector3_dot(n, light) * (d->mirrored ? -1 : 1);
    float lit = 0.16f + (facing > 0 ? 0.5f * facing : 0);
    return ink_shade((enum ink_ramp)f->ramp, f->mark ? 0.55f * lit + 0.1f : lit);
}

/* On the raster head, with a dark edge. */
static void fill(const struct drawn *d, const struct space_face *f)
{
    struct stage *s = d->view->stage;
    struct point2 pixels[SPACE_FACE_CORNERS], places[SPACE_FACE_CORNERS];
    enum ink before = s->ink;
    unsigned heads = s->heads;
    for (int i = 0; i < f->corners; i++) {
        places[i] = d->at[f->corner[i]];
        pixels[i] = (struct point2){stage_canvas_x(s, places[i].x), stage_canvas_y(s, places[i].y)};
    }
    canvas_polygon(&s->canvas, pixels, f->corners, POLYGON_EVEN_ODD, shade(d, f));
    stage_heads(s, heads & STAGE_RASTER);
    stage_ink(s, INK_BLACK);
    stage_polygon(s, places, f->corners);
    stage_ink(s, before);
    stage_heads(s, heads);
}

/* The face on the other side of the edge from a to b; NULL: it is a mark's. */
static const struct space_face *neighbour(const struct space_solid *s, int a, int b)
{
    for (const struct space_face *f = s->face; f < s->face + s->faces; f++)
        for (int i = 0; i < f->corners; i++)
            if (f->corner[i] == b && f->corner[(i + 1) % f->corners] == a)
                return f;
    return NULL;
}

/* The edges of a face, each once for both faces: by the one that is seen, else by the first. */
static void edges(const struct drawn *d, const struct space_face *f, bool seen)
{
    for (int i = 0; i < f->corners; i++) {
        int a = f->corner[i], b = f->corner[(i + 1) % f->corners];
        const struct space_face *other = neighbour(d->solid, a, b);
        bool other_seen = other != NULL && d->faces[other - d->solid->face];
        if (other != NULL && (other_seen == seen ? other < f : other_seen))
            continue;
        stage_line(d->view->stage, d->at[a].x, d->at[a].y, d->at[b].x, d->at[b].y);
    }
}

static void draw_faces(const struct drawn *d, int from, int to, enum space_style style)
{
    struct stage *s = d->view->stage;
    unsigned heads = s->heads;
    enum ink before = s->ink;
    for (int i = from; i < to; i++) {
        const struct space_face *f = &d->solid->face[i];
        if (!whole(d, f))
            continue;
        bool seen = d->faces[i];
        if (style == SPACE_WIRE) {
            edges(d, f, seen);
            continue;
        }
        if (seen)
            fill(d, f);
        else if (f->mark)
            continue;
        stage_heads(s, heads & STAGE_VECTOR);
        stage_ink(s, !seen ? INK_GRID : f->mark ? INK_TEXT : INK_BRIGHT);
        edges(d, f, seen);
        stage_heads(s, heads);
        stage_ink(s, before);
    }
}

void space_draw(const struct space_view *view, const struct space_solid *solid,
                const struct matrix4 *model, enum space_style style)
{
    struct drawn d = {.view = view, .solid = solid, .mirrored = transform3_determinant(model) < 0};
    for (int i = 0; i < solid->corners; i++) {
        d.world[i] = matrix4_apply(model, solid->corner[i]);
        d.seen[i] = space_place(view, d.world[i], &d.at[i]);
    }
    for (int i = 0; i < solid->faces; i++)
        d.faces[i] = faces_viewer(&d, &solid->face[i]);
    if (d.faces[solid->stands]) {
        draw_faces(&d, 0, solid->second, style);
        draw_faces(&d, solid->second, solid->faces, style);
    } else {
        draw_faces(&d, solid->second, solid->faces, style);
        draw_faces(&d, 0, solid->second, style);
    }
}
