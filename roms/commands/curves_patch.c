/* curves_patch.c — a Bézier patch over a square of 3 by 3, given by its 16 heights. */
#include "roms/commands/curves.h"

#include <stdio.h>

#include "roms/curves/bezier_patch.h"
#include "roms/curves/bezier_run.h"
#include "roms/monitor/print.h"

/* Rows of constant y, from y = 0. */
static const float named_heights[][16] = {
    {0, 0, 0, 0, 0, 4, 4, 0, 0, 4, 4, 0, 0, 0, 0, 0},     /* hill */
    {0, -2, -2, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, -2, -2, 0}, /* saddle */
    {0, 4, -4, 0, 0, 4, -4, 0, 0, 4, -4, 0, 0, 4, -4, 0}, /* wave */
    {0, 0, 0, 2, 0, 2, 2, 1, 0, 2, 2, 0, 2, 1, 0, 0},     /* sail */
};

static bool take_heights(struct words *w, float height[16])
{
    static const char *const names[] = {"hill", "saddle", "wave", "sail", NULL};
    int which = 0;
    bool typed = words_next_is_number(w);
    if (!typed && !words_choice(w, names, &which))
        return false;
    for (int i = 0; i < 16; i++) {
        height[i] = named_heights[which][i];
        if (typed && !words_amount(w, &height[i]))
            return false;
    }
    return true;
}

/* Pairs u v; without them the corners' and the middle's. */
static bool take_pairs(struct words *w, float *place, int *count)
{
    static const float usual[] = {0, 0, 0, 1, 1, 0, 1, 1, 0.5f, 0.5f};
    if (words_left(w) > 0) {
        if (!curves_take_places(w, 0, 1, place, count))
            return false;
        return *count % 2 == 0 || words_refuse(w, "u and v come in pairs, and a v is missing");
    }
    *count = sizeof usual / sizeof usual[0];
    for (int i = 0; i < *count; i++)
        place[i] = usual[i];
    return true;
}

/* Seen from above and aside: turned by −30° about z, then tilted by 35°. */
static struct vector3 aside(struct vector3 p)
{
    const float c = 0.8660254f, s = 0.5f, up = 0.57357644f, over = 0.81915204f;
    return (struct vector3){c * p.x - s * p.y, (s * p.x + c * p.y) * up + p.z * over, 0};
}

static void draw_curve(const struct graph *g, struct vector3 curve[4], enum ink ink)
{
    for (int k = 0; k < 4; k++)
        curve[k] = aside(curve[k]);
    curves_draw_bezier(g, curve, 4, ink);
}

static void draw_net(const struct graph *g, const struct bezier_patch *patch)
{
    for (int j = 0; j < 4; j++) {
        struct vector3 row[4], column[4];
        for (int k = 0; k < 4; k++) {
            row[k] = aside(patch->at[j][k]);
            column[k] = aside(patch->at[k][j]);
        }
        curves_draw_lines(g, row, 4, INK_GRID);
        curves_draw_lines(g, column, 4, INK_GRID);
        for (int k = 0; k < 4; k++)
            curves_draw_marker(g, row[k], INK_RED);
    }
}

static void draw(struct monitor *m, const struct bezier_patch *patch, const float *at, int count)
{
    enum { CURVES = 10 };
    struct point2 shown[16];
    for (int i = 0; i < 16; i++) {
        struct vector3 p = aside(patch->at[i / 4][i % 4]);
        shown[i] = (struct point2){p.x, p.y};
    }
    stage_begin(&m->stage);
    struct graph g = graph_whole(&m->stage, shown, 16);
    stage_title(&m->stage, "Bezier patch");
    draw_net(&g, patch);
    for (int i = 0; i <= CURVES; i++) {
        struct vector3 curve[4];
        bezier_patch_along_v(patch, (float)i / CURVES, curve);
        draw_curve(&g, curve, INK_CYAN);
        bezier_patch_along_u(patch, (float)i / CURVES, curve);
        draw_curve(&g, curve, INK_YELLOW);
    }
    for (int i = 0; i < count; i += 2) {
        struct vector3 p = bezier_patch_point(patch, at[i], at[i + 1]);
        struct vector3 n = bezier_patch_normal(patch, at[i], at[i + 1]);
        struct vector3 tip = aside(vector3_sum(p, vector3_times(n, 0.5f)));
        curves_draw_arrow(&g, aside(p), vector3_difference(tip, aside(p)), INK_GREEN);
    }
    stage_caption(&m->stage, "grey: the control net; cyan: u constant; yellow: v constant; "
                             "green: normals");
    stage_end(&m->stage);
}

static void print_net(const struct bezier_patch *patch)
{
    for (int j = 0; j < 4; j++) {
        for (int k = 0; k < 4; k++) {
            printf("  ");
            curves_print_point(patch->at[j][k], 3);
        }
        printf("\n");
    }
}

bool curves_patch(struct monitor *m, struct words *w)
{
    struct bezier_patch patch;
    float height[16], at[CURVES_PLACES];
    int count;
    if (!take_heights(w, height) || !take_pairs(w, at, &count))
        return false;
    for (int i = 0; i < 16; i++)
        patch.at[i / 4][i % 4] = (struct vector3){(float)(i % 4), (float)(i / 4), height[i]};
    if (m->table)
        print_net(&patch);
    printf("      u       v         x         y         z        nx        ny        nz\n");
    for (int i = 0; i < count; i += 2) {
        struct vector3 p = bezier_patch_point(&patch, at[i], at[i + 1]);
        struct vector3 n = bezier_patch_normal(&patch, at[i], at[i + 1]);
        printf("%7.4f %7.4f %9.4f %9.4f %9.4f %9.4f %9.4f %9.4f\n", (double)at[i],
               (double)at[i + 1], print_tidy(p.x), print_tidy(p.y), print_tidy(p.z),
               print_tidy(n.x), print_tidy(n.y), print_tidy(n.z));
    }
    draw(m, &patch, at, count);
    return true;
}
