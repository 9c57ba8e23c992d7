#include "roms/lessons/relief.h"

#include <math.h>
#include <stdio.h>

#include "roms/scenery/depth.h"
#include "roms/scenery/workroom.h"

enum { LEGEND_X = 1085, LEGEND_LOW = 180, LEGEND_HIGH = 620, LEGEND_WIDTH = 40 };
#define RELIEF_HALF   1.5f /* of its side */
#define RELIEF_HEIGHT 0.42f

/* From low to high. */
static const enum ink_ramp ramps[RELIEF_BANDS] = {RAMP_BLUE, RAMP_GREEN, RAMP_GOLD, RAMP_COPPER,
                                                  RAMP_GREY};
static const enum ink band_inks[RELIEF_BANDS] = {INK_BLUE, INK_GREEN, INK_YELLOW, INK_ORANGE,
                                                 INK_TEXT};
static const char *const names[FIELDS] = {"height", "height", "heat"};

static float level_of(const struct field *f, int band)
{
    float low = field_low(f), high = field_high(f);
    return low + (high - low) * (float)band / RELIEF_BANDS;
}

/* ---- the surface ----------------------------------------------------------------------------- */

static float height_of(const struct field *f, float value)
{
    float scale = f->kind == FIELD_HEAT ? 2.2f : 1;
    return (value - (field_low(f) + field_high(f)) / 2) * RELIEF_HEIGHT * scale;
}

static void make_mesh(struct mesh *mesh, const struct field *f)
{
    mesh->vertices = mesh->triangles = 0;
    for (int r = 0; r < FIELD_SIDE; r++) {
        for (int c = 0; c < FIELD_SIDE; c++) {
            float x = ((float)c / (FIELD_SIDE - 1) * 2 - 1) * RELIEF_HALF;
            float z = ((float)r / (FIELD_SIDE - 1) * 2 - 1) * RELIEF_HALF;
            mesh->place[mesh->vertices++] = (struct vector3){x, height_of(f, f->now[r][c]), z};
        }
    }
    for (int r = 0; r + 1 < FIELD_SIDE; r++) {
        for (int c = 0; c + 1 < FIELD_SIDE; c++) {
            int a = r * FIELD_SIDE + c, b = a + FIELD_SIDE;
            const int corners[2][3] = {{a, b, b + 1}, {a, b + 1, a + 1}};
            for (int k = 0; k < 6; k++)
                mesh->corner[mesh->triangles + k / 3][k % 3] = (uint16_t)corners[k / 3][k % 3];
            mesh->triangles += 2;
        }
    }
}

/* Normals by differences of the neighbours' heights; the first and last rows have their
 * neighbours'. */
static void make_normals(struct mesh *mesh)
{
    for (int r = 0; r < FIELD_SIDE; r++) {
        for (int c = 0; c < FIELD_SIDE; c++) {
            int left = c > 0 ? c - 1 : c, right = c + 1 < FIELD_SIDE ? c + 1 : c;
            int back = r > 0 ? r - 1 : r, front = r + 1 < FIELD_SIDE ? r + 1 : r;
            const struct vector3 *row = &mesh->place[r * FIELD_SIDE];
            const struct vector3 *b = &mesh->place[back * FIELD_SIDE + c];
            const struct vector3 *a = &mesh->place[front * FIELD_SIDE + c];
            struct vector3 along = vector3_difference(row[right], row[left]);
            struct vector3 across = vector3_difference(*a, *b);
            mesh->normal[r * FIELD_SIDE + c] = vector3_direction(vector3_cross(across, along));
        }
    }
}

static void place(struct relief *r, const struct stage *stage, float yaw)
{
    struct mesh_view *v = &r->view;
    v->model = view_turn(yaw, 38);
    v->distance = 6;
    v->x = stage_canvas_x(stage, 480);
    v->y = stage_canvas_y(stage, 440);
    v->dots_x = v->dots_y = 232 * stage->dots;
    mesh_project(&r->mesh, v);
    r->lighting = lighting_dark(0.25f);
    lighting_add(&r->lighting,
                 (struct light){.kind = LIGHT_FAR, .at = {-1.2f, 0.9f, 0.35f}, .intensity = 0.85f});
    r->material = (struct material){0.6f, 0.75f, 0.25f, 24, 0, false};
    for (int i = 0; i < r->mesh.vertices; i++)
        v->vertex[i].intensity = illumination_sum(
            illuminate(&r->lighting, &r->material, v->vertex[i].place, v->vertex[i].normal));
}

/* ---- cutting at a level ---------------------------------------------------------------------- */

/* A corner with its value. */
struct spot {
    struct shade_vertex v;
    float value;
};

/* Where the value is `level`, on the way from a lower to a higher corner. */
static struct spot between(const struct spot *low, const struct spot *high, float level)
{
    float t = (level - low->value) / (high->value - low->value);
    const struct shade_vertex *a = &low->v, *b = &high->v;
    struct spot s = {.value = level};
    s.v.x = a->x + (b->x - a->x) * t;
    s.v.y = a->y + (b->y - a->y) * t;
    s.v.z = a->z + (b->z - a->z) * t;
    s.v.intensity = a->intensity + (b->intensity - a->intensity) * t;
    return s;
}

struct cutting {
    struct stage *stage;
    struct shade *shade;
    const struct field *field;
};

static void fill(const struct cutting *c, int band, const struct spot *p, int count)
{
    c->shade->first = (float)ink_shade(ramps[band], 0) + 0.5f;
    c->shade->top = c->shade->first + INK_LEVELS - 0.75f;
    for (int i = 1; i + 1 < count; i++)
        shade_gouraud(c->shade, &p[0].v, &p[i].v, &p[i + 1].v);
}

/* The contour line from p to q, on the vector head; canvas pixels. */
static void contour(const struct cutting *c, const struct spot *p, const struct spot *q, int band)
{
    struct stage *s = c->stage;
    float per = 1 / s->dots, x0 = stage_canvas_x(s, 0), y0 = stage_canvas_y(s, 0);
    stage_ink(s, band == RELIEF_BANDS / 2 ? INK_TEXT : band_inks[band]);
    stage_line(s, (p->v.x - x0) * per, (y0 - p->v.y) * per, (q->v.x - x0) * per,
               (y0 - q->v.y) * per);
}

/* Corners in the order of their values; fills it band by band from the lowest. */
static void cut(const struct cutting *c, const struct spot *low, const struct spot *mid,
                const struct spot *high)
{
    struct spot left = *low, right = *low; /* where the part that is still to be filled begins */
    bool passed = false;                   /* the middle corner */
    for (int band = 0; band < RELIEF_BANDS; band++) {
        float level = level_of(c->field, band + 1);
        if (level <= low->value && band + 1 < RELIEF_BANDS)
            continue;
        bool last = level >= high->value || band + 1 == RELIEF_BANDS;
        struct spot part[5] = {left};
        int count = 1;
        if (right.v.x != left.v.x || right.v.y != left.v.y)
            part[count++] = right;
        if (last) {
            if (!passed)
                part[count++] = *mid;
            part[count++] = *high;
            fill(c, band, part, count);
            return;
        }
        bool pass = !passed && mid->value < level;
        if (pass)
            part[count++] = *mid;
        passed = passed || pass;
        right = passed ? between(mid, high, level) : between(low, mid, level);
        left = between(low, high, level);
        part[count++] = right;
        part[count++] = left;
        fill(c, band, part, count);
        contour(c, &left, &right, band + 1);
    }
}

static void cut_triangle(const struct cutting *c, const struct relief *r, const uint16_t *corner)
{
    struct spot s[3];
    for (int k = 0; k < 3; k++) {
        int row = corner[k] / FIELD_SIDE, column = corner[k] % FIELD_SIDE;
        s[k] = (struct spot){r->view.vertex[corner[k]], c->field->now[row][column]};
    }
    int low = s[0].value <= s[1].value ? 0 : 1, high = 1 - low;
    if (s[2].value < s[low].value)
        low = 2;
    else if (s[2].value > s[high].value)
        high = 2;
    cut(c, &s[low], &s[3 - low - high], &s[high]);
}

/* ---- around it ------------------------------------------------------------------------------- */

static void draw_legend(struct stage *stage, const struct field *f)
{
    float per = (float)(LEGEND_HIGH - LEGEND_LOW) / RELIEF_BANDS;
    stage_ink(stage, INK_BRIGHT);
    stage_text_middle(stage, LEGEND_X + 20, LEGEND_HIGH + 45, names[f->kind]);
    for (int i = 0; i <= RELIEF_BANDS; i++) {
        float y = LEGEND_LOW + per * (float)i;
        if (i < RELIEF_BANDS) {
            int x0 = (int)stage_canvas_x(stage, LEGEND_X);
            int x1 = (int)stage_canvas_x(stage, LEGEND_X + LEGEND_WIDTH);
            int top = (int)stage_canvas_y(stage, y + per), low = (int)stage_canvas_y(stage, y);
            canvas_fill(&stage->canvas, x0, top, x1 - x0, low - top, ink_shade(ramps[i], 0.6f));
        }
        stage_ink(stage, INK_TEXT);
        stage_line(stage, LEGEND_X, y, LEGEND_X + LEGEND_WIDTH, y);
        stage_number(stage, LEGEND_X - 95, y - 8, level_of(f, i), 2);
    }
    stage_line(stage, LEGEND_X, LEGEND_LOW, LEGEND_X, LEGEND_HIGH);
    stage_line(stage, LEGEND_X + LEGEND_WIDTH, LEGEND_LOW, LEGEND_X + LEGEND_WIDTH, LEGEND_HIGH);
}

static void draw_rim(struct stage *stage, const struct relief *r)
{
    float per = 1 / stage->dots, x0 = stage_canvas_x(stage, 0), y0 = stage_canvas_y(stage, 0);
    struct point2 last = {0, 0};
    stage_ink(stage, INK_GRID);
    for (int i = 0; i <= 4 * (FIELD_SIDE - 1); i++) {
        int side = i / (FIELD_SIDE - 1) % 4, k = i % (FIELD_SIDE - 1), end = FIELD_SIDE - 1;
        int row = side == 0 ? 0 : side == 1 ? k : side == 2 ? end : end - k;
        int column = side == 0 ? k : side == 1 ? end : side == 2 ? end - k : 0;
        const struct shade_vertex *v = &r->view.vertex[row * FIELD_SIDE + column];
        struct point2 at = {(v->x - x0) * per, (y0 - v->y) * per};
        if (i > 0)
            stage_line(stage, last.x, last.y, at.x, at.y);
        last = at;
    }
}

/* The wall with its gaps, where the field has one. */
static void draw_wall(struct stage *stage, const struct relief *r, const struct field *f)
{
    float per = 1 / stage->dots, x0 = stage_canvas_x(stage, 0), y0 = stage_canvas_y(stage, 0);
    stage_ink(stage, INK_BRIGHT);
    for (int row = 0; row < FIELD_SIDE; row++) {
        for (int c = 0; c + 1 < FIELD_SIDE; c++) {
            const struct shade_vertex *a = &r->view.vertex[row * FIELD_SIDE + c], *b = a + 1;
            if (!field_is_wall(f, row, c) || !field_is_wall(f, row, c + 1))
                continue;
            for (float up = 0; up < 9; up += 2)
                stage_line(stage, (a->x - x0) * per, (y0 - a->y) * per + up, (b->x - x0) * per,
                           (y0 - b->y) * per + up);
        }
    }
}

void relief_draw(struct relief *r, struct stage *stage, const struct field *field, float yaw)
{
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    struct shade shade = shade_begin(&stage->canvas, &depth, ink_shade(RAMP_GREY, 0), INK_LEVELS);
    struct cutting c = {stage, &shade, field};
    make_mesh(&r->mesh, field);
    make_normals(&r->mesh);
    place(r, stage, yaw);
    depth_clear(&depth, -1e30f);
    stage_heads(stage, STAGE_VECTOR);
    for (int i = 0; i < r->mesh.triangles; i++) {
        const uint16_t *corner = r->mesh.corner[i];
        const struct shade_vertex *v = r->view.vertex;
        if (mesh_is_front(&v[corner[0]], &v[corner[1]], &v[corner[2]]))
            cut_triangle(&c, r, corner);
    }
    draw_rim(stage, r);
    stage_heads(stage, STAGE_BOTH);
    draw_wall(stage, r, field);
    draw_legend(stage, field);
}
