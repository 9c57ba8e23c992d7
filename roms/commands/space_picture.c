#include "roms/commands/space_picture.h"

#include <math.h>
#include <stdio.h>

#include "roms/geometry/projection_perspective.h"
#include "roms/monitor/print.h"

void space_matrix(struct stage *s, float x, float y, const char *name, const struct matrix4 *m)
{
    enum { ROW = 38, COLUMN = 96 };
    stage_text(s, x, y, name);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++) {
            char text[24];
            float value = m->at[i][k];
            snprintf(text, sizeof text, fabsf(value) < 100 ? "%5.2f" : "%5.0f",
                     fabsf(value) < 0.005f ? 0 : (double)value);
            stage_text(s, x + (float)(COLUMN * k), y - (float)(ROW * (i + 1)), text);
        }
}

static void plumb_line(const struct space_view *view, struct vector3 p)
{
    enum ink before = view->stage->ink;
    stage_ink(view->stage, INK_GRID);
    struct vector3 foot = {p.x, 0, p.z};
    space_line(view, p, foot);
    space_line(view, (struct vector3){p.x, 0, 0}, foot);
    space_line(view, (struct vector3){0, 0, p.z}, foot);
    stage_ink(view->stage, before);
}

void space_figure(const struct space_view *view, const struct space_points *points, bool plumb)
{
    int n = points->count;
    for (int i = 0; i < n; i++) {
        struct point2 at;
        if (plumb && n <= 4)
            plumb_line(view, points->at[i]);
        if (space_place(view, points->at[i], &at))
            stage_marker(view->stage, at.x, at.y);
        if (n > 2 || i + 1 < n)
            space_line(view, points->at[i], points->at[(i + 1) % n]);
    }
}

struct space_scene space_scene(struct stage *stage, const struct matrix4 *projection, float width,
                               const struct vector3 *points, int count)
{
    enum { MOST = 7 + 2 * SPACE_CORNERS, MARGIN = 60 };
    struct space_scene scene = {.view = {.stage = stage, .projection = *projection}};
    struct point2 at[MOST];
    int found = 0;
    float reach = 1e-3f, low = 0;
    for (int i = 0; i < count; i++) {
        struct vector3 p = points[i];
        reach = fmaxf(reach, fmaxf(fabsf(p.x), fmaxf(fabsf(p.y), fabsf(p.z))));
        low = fminf(low, fminf(p.x, fminf(p.y, p.z)));
    }
    scene.axes = 1.15f * reach;
    scene.negative = low < -0.3f * reach;
    const struct vector3 own[] = {
        {0, 0, 0}, {scene.axes, 0, 0}, {0, scene.axes, 0}, {0, 0, scene.axes}};
    for (int i = 0; i < 4; i++)
        found += projection_place(projection, own[i], &at[found]);
    for (int i = 0; i < count && found < MOST; i++)
        found += projection_place(projection, points[i], &at[found]);
    if (found == 0)
        at[found++] = (struct point2){0, 0};
    space_fit(&scene.view, MARGIN, MARGIN, width - 2 * MARGIN, STAGE_HEIGHT - 2 * MARGIN, at,
              found);
    return scene;
}
