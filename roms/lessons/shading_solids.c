/* shading_solids.c — pages of shaded solids. */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/geometry/scalar.h"
#include "roms/lessons/shading.h"
#include "roms/light/power.h"

static const char *const names[SHADINGS] = {"flat", "Gouraud", "Phong", "fast Phong"};

/* On the raster head shaded, on the vector head its wires. */
static struct studio_cost draw_solid(struct studio *s, struct stage *stage,
                                     const struct studio_pose *pose, enum shading shading,
                                     enum ink_ramp ramp)
{
    struct studio_cost cost = studio_shade(s, stage, pose, shading, ramp);
    unsigned heads = stage->heads;
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_GREEN);
    studio_wires(s, stage, pose);
    stage_heads(stage, heads);
    stage_ink(stage, INK_TEXT);
    return cost;
}

/* ---- the four side by side ------------------------------------------------------------------- */

void shading_compare_begin(struct shading_lesson *l)
{
    studio_solid(l->studio, STUDIO_TORUS, 14);
}

void shading_compare(struct shading_lesson *l, struct stage *stage, float t)
{
    l->studio->material.n = l->n;
    for (int i = 0; i < SHADINGS; i++) {
        float x = i % 2 ? 905 : 295, y = i < 2 ? 588 : 198;
        struct studio_pose pose = {x, y, 198, 24 * t, 40 + 25 * sinf(0.5f * t), 5};
        draw_solid(l->studio, stage, &pose, (enum shading)i, RAMP_COPPER);
        stage_ink(stage, INK_BRIGHT);
        stage_text(stage, x - 290, y + 165, names[i]);
    }
    stage_caption(
        stage,
        "The same 98 faces. Look at the highlight: facets, stars, a spot - and pieces, where the "
        "normals differ too much for a series.");
}

/* ---- one that turns -------------------------------------------------------------------------- */

void shading_turn_begin(struct shading_lesson *l)
{
    studio_solid(l->studio, (enum studio_model)l->model, l->model == STUDIO_VESSEL ? 16 : 32);
}

void shading_turn(struct shading_lesson *l, struct stage *stage, float t)
{
    static const enum ink_ramp ramps[SHADINGS] = {RAMP_GREY, RAMP_GREEN, RAMP_COPPER, RAMP_GOLD};
    int shading = l->shading >= 0 ? l->shading : (int)(t / 5) % SHADINGS;
    float radius = l->model == STUDIO_VESSEL ? 440 : 330;
    struct studio_pose pose = {600, l->model == STUDIO_VESSEL ? 370 : 400, radius, 40 * t, 30, 5};
    char text[96];
    l->studio->material.n = l->n;
    struct studio_cost cost =
        draw_solid(l->studio, stage, &pose, (enum shading)shading, ramps[shading]);
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, 20, 740, names[shading]);
    stage_ink(stage, INK_TEXT);
    snprintf(text, sizeof text, "n = %.0f", (double)l->n);
    stage_text(stage, 20, 705, text);
    if (cost.pixels > 0) {
        snprintf(text, sizeof text, "%d triangles", l->studio->mesh.triangles);
        stage_text(stage, 20, 80, text);
        snprintf(text, sizeof text, "%.1f instructions a pixel", (double)cost.shade / cost.pixels);
        stage_text(stage, 20, 50, text);
        snprintf(text, sizeof text, "%.0f a second", (double)l->rate);
        stage_text(stage, 20, 20, text);
    }
    stage_caption(stage, "Turned, lit, projected and shaded anew each time.");
}

/* ---- term by term ---------------------------------------------------------------------------- */

void shading_terms_begin(struct shading_lesson *l)
{
    studio_solid(l->studio, STUDIO_VESSEL, 16);
}

/* How much goes where, for light from the upper left: the length of a line in each direction. */
static void lobe(struct stage *s, float x, float y, int term, float n)
{
    enum { PARTS = 36 };
    static const float light = 2.2f, mirrored = PI - 2.2f; /* angles above the surface */
    struct point2 p[PARTS + 1];
    for (int i = 0; i <= PARTS; i++) {
        float angle = (float)i * (PI / PARTS), r = 60;
        if (term == 1)
            r = 110 * sinf(light);
        if (term == 2)
            r = 140 * power(cosf(angle - mirrored), n);
        p[i] = (struct point2){x + r * cosf(angle), y + r * sinf(angle)};
    }
    stage_polyline(s, p, PARTS + 1);
    stage_line(s, x - 130, y, x + 130, y);
    if (term > 0)
        stage_line(s, x, y, x + 150 * cosf(light), y + 150 * sinf(light));
}

void shading_terms(struct shading_lesson *l, struct stage *stage, float t)
{
    static const char *const what[] = {"ambient", "+ diffuse", "+ specular"};
    static const char *const terms[] = {"ka Ia", "kd I (N.L)", "ks I (R.V)^n"};
    struct material *m = &l->studio->material;
    int shown = (int)(t / 1.5f) + 1;
    struct studio_pose big = {600, 510, 330, 30 * t, 25, 5};
    int upper = shown > 3 ? 3 : shown;
    *m = (struct material){0.3f, upper > 1 ? 0.55f : 0, upper > 2 ? 0.4f : 0, l->n, 0, false};
    draw_solid(l->studio, stage, &big, SHADE_PHONG, RAMP_GOLD);
    for (int i = 0; i < 3; i++) {
        struct studio_pose small = {220 + 380 * (float)i, 140, 165, 30 * t, 25, 5};
        *m = (struct material){
            i == 0 ? 0.3f : 0, i == 1 ? 0.55f : 0, i == 2 ? 0.4f : 0, l->n, 0, false};
        studio_shade(l->studio, stage, &small, SHADE_PHONG, RAMP_GOLD);
        stage_ink(stage, i < upper ? INK_BRIGHT : INK_GRID);
        stage_heads(stage, STAGE_VECTOR);
        lobe(stage, small.x, 65, i, l->n);
        stage_heads(stage, STAGE_BOTH);
        stage_text_middle(stage, small.x, 262, what[i]);
        stage_text_middle(stage, small.x, 12, terms[i]);
    }
    stage_caption(stage,
                  "I = ka Ia + kd I (N.L) + ks I (R.V)^n: above their sum, below each term alone.");
}

/* ---- shininess ------------------------------------------------------------------------------- */

void shading_shine_begin(struct shading_lesson *l)
{
    studio_solid(l->studio, STUDIO_SPHERE, 24);
}

/* cos^n of −90°…90°, with few lines. */
static void power_curve(struct stage *s, float x, float y, float width, float height, float n)
{
    enum { PARTS = 36 };
    struct point2 p[PARTS + 1];
    for (int i = 0; i <= PARTS; i++) {
        float at = (float)i / PARTS * 2 - 1;
        p[i] = (struct point2){x + at * width / 2, y + height * power(cosf(at * (PI / 2)), n)};
    }
    stage_polyline(s, p, PARTS + 1);
}

void shading_shine(struct shading_lesson *l, struct stage *stage, float t)
{
    enum { BALLS = 4, CURVE_LOW = 50, CURVE = 190 };
    static const float exponents[BALLS] = {2, 8, 32, 128};
    static const enum ink inks[BALLS] = {INK_GREEN, INK_CYAN, INK_YELLOW, INK_RED};
    l->studio->lighting.light[0].at =
        vector3_direction((struct vector3){1.5f * sinf(0.7f * t), 1, 1.2f});
    for (int i = 0; i < BALLS; i++) {
        float x = 150 + 300 * (float)i;
        char text[24];
        struct studio_pose pose = {x, 580, 140, 0, 10, 5};
        l->studio->material.n = exponents[i];
        draw_solid(l->studio, stage, &pose, SHADE_PHONG, RAMP_BLUE);
        snprintf(text, sizeof text, "n = %.0f", (double)exponents[i]);
        stage_ink(stage, INK_BRIGHT);
        stage_text_middle(stage, x, 395, text);
        stage_ink(stage, INK_GRID);
        stage_line(stage, x - 130, CURVE_LOW, x + 130, CURVE_LOW);
        stage_line(stage, x, CURVE_LOW, x, CURVE_LOW + CURVE + 20);
        stage_ink(stage, inks[i]);
        power_curve(stage, x, CURVE_LOW, 260, CURVE, exponents[i]);
        stage_ink(stage, INK_TEXT);
        stage_text_middle(stage, x, 280, "cos^n");
        stage_text(stage, x - 134, 16, "-90");
        stage_text(stage, x + 100, 16, "90");
    }
    stage_caption(stage, "The larger n, the narrower the highlight: chalk has n near 1, polished "
                         "metal 100 and more.");
}

/* ---- lights that move ------------------------------------------------------------------------ */

void shading_lights_begin(struct shading_lesson *l)
{
    struct lighting *g = &l->studio->lighting;
    studio_solid(l->studio, STUDIO_VESSEL, 16);
    *g = lighting_dark(0.3f);
    g->a0 = 0.4f;
    g->a1 = 0;
    g->a2 = 0.12f;
    g->eye_far = true;
    lighting_add(g, (struct light){.kind = LIGHT_NEAR, .intensity = 0.7f});
    lighting_add(g, (struct light){.kind = LIGHT_NEAR, .intensity = 0.7f});
}

static void draw_lamp(struct stage *s, const struct studio_pose *pose, const struct studio *studio,
                      struct vector3 at)
{
    enum { RAYS = 8 };
    float eye = pose->eye * studio->reach;
    float k = pose->radius / studio->reach * eye / (eye - at.z);
    float x = pose->x + at.x * k, y = pose->y + at.y * k;
    for (int i = 0; i < RAYS; i++) {
        float c = cosf((float)i * (TURN / RAYS)), n = sinf((float)i * (TURN / RAYS));
        stage_line(s, x + 9 * c, y + 9 * n, x + 20 * c, y + 20 * n);
    }
}

void shading_lights(struct shading_lesson *l, struct stage *stage, float t)
{
    struct lighting *g = &l->studio->lighting;
    struct studio_pose pose = {600, 370, 470, 15 * t, 20, 6};
    g->light[0].at = (struct vector3){2.3f * cosf(t), 1.3f, 2.3f * sinf(t)};
    g->light[1].at = (struct vector3){2.0f * sinf(0.7f * t), 1.6f * cosf(0.7f * t), 1.9f};
    l->studio->material.n = l->n;
    int shading = l->shading >= 0 ? l->shading : SHADE_GOURAUD;
    draw_solid(l->studio, stage, &pose, (enum shading)shading, RAMP_COPPER);
    stage_ink(stage, INK_YELLOW);
    for (int i = 0; i < g->count; i++)
        draw_lamp(stage, &pose, l->studio, g->light[i].at);
    stage_caption(
        stage,
        "Two lamps at places: their light falls as 1/(a0 + a1 d + a2 d^2), highlights follow them. "
        "There are no shadows.");
}
