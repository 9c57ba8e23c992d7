/* space_projections.c — one house by eight parallel projections, then in perspective with its
 * vanishing points. */
#include <math.h>
#include <stdio.h>

#include "roms/geometry/projection_parallel.h"
#include "roms/geometry/projection_perspective.h"
#include "roms/geometry/transform3.h"
#include "roms/lessons/space_pages.h"
#include "roms/scenery/space_solid.h"

/* ---- parallel -------------------------------------------------------------------------------- */

enum { PANELS = 8, ACROSS = 4, PANEL_WIDTH = STAGE_WIDTH / ACROSS, PANEL_HEIGHT = 390 };

static struct matrix4 panel_projection(int panel, float seconds, struct space_viewer viewer)
{
    struct axonometric a = projection_isometric();
    switch (panel) {
    case 0:
        return projection_elevation(ELEVATION_FRONT);
    case 1:
        return projection_elevation(ELEVATION_RIGHT);
    case 2:
        return projection_elevation(ELEVATION_PLAN);
    case 3:
        return a.matrix;
    case 4:
        projection_dimetric(0.5f, &a);
        return a.matrix;
    case 5:
        return projection_axonometric(-30 + 25 * sinf(seconds * 0.9f) + viewer.turn,
                                      20 + 8 * sinf(seconds * 0.6f) + viewer.tilt)
            .matrix;
    case 6:
        return projection_oblique(225, 1);
    default:
        return projection_oblique(225, 0.5f);
    }
}

void space_page_parallel(struct stage *stage, float seconds, struct space_viewer viewer)
{
    static const char *const names[PANELS] = {"front",    "right side", "plan",     "isometric",
                                              "dimetric", "trimetric",  "cavalier", "cabinet"};
    static const char *const say[] = {
        "Elevations and plan: one face, true in shape and size",
        "Axonometric: isometric shortens x, y, z alike, dimetric two of them",
        "Oblique: the front stays true; depth is whole in cavalier, half in cabinet",
    };
    struct matrix4 one = matrix4_identity();
    int about = (int)(seconds / 4.7f) % 3;
    for (int i = 0; i < PANELS; i++) {
        float left = (float)(i % ACROSS * PANEL_WIDTH);
        float bottom = (float)((1 - i / ACROSS) * PANEL_HEIGHT);
        bool spoken = about == 0 ? i < 3 : about == 1 ? i >= 3 && i < 6 : i >= 6;
        struct space_view view = {
            .stage = stage, .projection = panel_projection(i, seconds, viewer), .scale = 48};
        struct point2 middle = {0, 0};
        projection_place(&view.projection, (struct vector3){0, 1.8f, 0}, &middle);
        view.x = left + PANEL_WIDTH / 2 - view.scale * middle.x;
        view.y = bottom + PANEL_HEIGHT / 2 + 24 - view.scale * middle.y;
        stage_ink(stage, INK_BRIGHT);
        space_draw(&view, &space_house, &one, SPACE_FILLED);
        stage_ink(stage, spoken ? INK_YELLOW : INK_TEXT);
        stage_text_middle(stage, left + PANEL_WIDTH / 2, bottom + 8, names[i]);
    }
    stage_title(stage, "Parallel projections of one house");
    stage_caption(stage, say[about]);
}

/* ---- perspective ----------------------------------------------------------------------------- */

/* The house's corners that lines to the vanishing points start at, for x, y and z. */
static const int from_corners[3][5] = {{0, 4, 5, 9, -1}, {0, 1, 5, 6, -1}, {0, 1, 2, 3, 4}};

/* From each corner on to where the lines meet. */
static void construction(const struct space_view *view, const struct vanishing *v)
{
    static const enum ink inks[] = {INK_RED, INK_GREEN, INK_CYAN};
    static const char *const names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; axis++) {
        if (!v->has[axis])
            continue;
        float x = view->x + view->scale * v->at[axis].x, y = view->y + view->scale * v->at[axis].y;
        stage_ink(view->stage, inks[axis]);
        for (int i = 0; i < 5 && from_corners[axis][i] >= 0; i++) {
            struct point2 at;
            if (space_place(view, space_house.corner[from_corners[axis][i]], &at))
                stage_line(view->stage, at.x, at.y, x, y);
        }
        stage_marker(view->stage, x, y);
        stage_text(view->stage, x + (x > STAGE_WIDTH - 60 ? -40 : 14), y + 10, names[axis]);
    }
}

/* The line of eye level, on which all level lines meet. */
static void horizon(const struct space_view *view, const struct vanishing *v)
{
    int on = v->has[2] ? 2 : 0;
    float y = view->y + view->scale * v->at[on].y;
    stage_ink(view->stage, INK_GRID);
    stage_line(view->stage, 0, y, STAGE_WIDTH, y);
    stage_text(view->stage, STAGE_WIDTH - 124, y + 8, "horizon");
}

/* No minus before what one decimal shows as 0. */
static double tidy(float value)
{
    return fabsf(value) < 0.05f ? 0 : (double)value;
}

static void list_points(struct stage *s, const struct vanishing *v)
{
    static const char *const names[] = {"x", "y", "z"};
    float y = 30;
    stage_ink(s, INK_TEXT);
    for (int i = 2; i >= 0; i--) {
        char text[48];
        if (!v->has[i])
            continue;
        snprintf(text, sizeof text, "along %s: (%.1f, %.1f)", names[i], tidy(v->at[i].x),
                 tidy(v->at[i].y));
        stage_text(s, 16, y, text);
        y += 38;
    }
}

/* `x`, `y`: where the view plane's origin is on the stage. */
static void perspective(struct stage *s, struct vector3 eye, float turn, float tilt, float scale,
                        float x, float y)
{
    struct matrix4 about_y = transform3_rotate(AXIS3_Y, turn);
    struct matrix4 about_x = transform3_rotate(AXIS3_X, tilt);
    struct matrix4 turned = matrix4_product(&about_x, &about_y), one = matrix4_identity();
    struct space_view view = {.stage = s, .scale = scale, .x = x, .y = y};
    projection_perspective(eye, 0, &view.projection);
    view.projection = matrix4_product(&view.projection, &turned);
    struct vanishing v = projection_vanishing_axes(&view.projection);
    horizon(&view, &v);
    construction(&view, &v);
    stage_ink(s, INK_BRIGHT);
    space_draw(&view, &space_house, &one, SPACE_FILLED);
    list_points(s, &v);
}

void space_page_one_point(struct stage *stage, float seconds, struct space_viewer viewer)
{
    float sway = sinf(seconds * 0.55f);
    struct vector3 eye = {3 + 2 * sway + viewer.turn * 0.1f, 4.2f + viewer.tilt * 0.05f, 7};
    perspective(stage, eye, 0, 0, 95, 440, 230);
    stage_title(stage, "One-point perspective");
    stage_caption(stage, "Only z crosses the view plane: its lines meet, right before the eye");
}

void space_page_two_point(struct stage *stage, float seconds, struct space_viewer viewer)
{
    float turn = -45 + 9 * sinf(seconds * 0.55f) + viewer.turn * 0.3f;
    struct vector3 eye = {0, 1.4f + viewer.tilt * 0.08f, 6};
    perspective(stage, eye, turn, 0, 70, 600, 320);
    stage_title(stage, "Two-point perspective");
    stage_caption(stage,
                  "x and z cross the view plane: two points on the horizon; uprights stay upright");
}

void space_page_three_point(struct stage *stage, float seconds, struct space_viewer viewer)
{
    float turn = -45 + 9 * sinf(seconds * 0.55f) + viewer.turn * 0.3f;
    struct vector3 eye = {0, 1, 6};
    perspective(stage, eye, turn, 32 + viewer.tilt * 0.2f, 52, 600, 520);
    stage_title(stage, "Three-point perspective");
    stage_caption(stage, "The eye looks down: x, y and z all cross the view plane; three points");
}
