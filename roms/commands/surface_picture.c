#include "roms/commands/surface_picture.h"

#include <stddef.h>
#include <string.h>

#include "roms/scenery/depth.h"
#include "roms/visible/depth_surface.h"

const char *const surface_methods[] = {"depth-buffer", "scan-line", "painter", "lines",
                                       "depth-from-0", "all",       NULL};
static const char *const titles[] = {"Depth buffer",
                                     "Scan line",
                                     "Painter's method",
                                     "Hidden lines removed",
                                     "A depth buffer that begins with 0",
                                     "Surfaces as they come"};

uint8_t *surface_pixels(int picture)
{
    static struct {
        _Alignas(4) uint8_t at[2][SURFACE_WIDTH * SURFACE_HEIGHT];
    } pixels;
    return pixels.at[picture];
}

static struct canvas picture_canvas(int picture)
{
    return (struct canvas){
        surface_pixels(picture), SURFACE_WIDTH, SURFACE_WIDTH, SURFACE_HEIGHT, 8, 1.0f};
}

/* Every edge has two polygons. */
static bool is_closed_solid(const struct object *o)
{
    for (int i = 0; i < o->edges; i++)
        if (o->edge[i].polygon[1] == OBJECT_NONE)
            return false;
    return true;
}

bool surface_scene(enum scene_which which, const struct look *look)
{
    struct workroom *room = workroom();
    struct object *o = which == SCENE_OBJECT ? present_object() : &room->object;
    bool closed = scene_make(o, which);
    struct look at = *look;
    if (which == SCENE_SOLIDS || which == SCENE_PIERCE)
        at = (struct look){-20, 20, 0};
    else if (which != SCENE_OBJECT)
        at = (struct look){0, 0, 0};
    struct matrix4 turn = view_turn(at.yaw, at.pitch);
    float reach = object_reach(o), stage_scale = 370 / reach;
    struct view pixels = {
        turn, at.eye * reach, stage_scale / 2, SURFACE_WIDTH / 2, SURFACE_HEIGHT / 2, -1};
    struct view stage =
        view_on_stage(&turn, at.eye * reach, stage_scale, STAGE_WIDTH / 2, STAGE_HEIGHT / 2);
    unsigned flags = closed && is_closed_solid(o) ? SCENE_CULLED : 0;
    scene_clear(&room->scene);
    scene_clear(&room->lines);
    if (!scene_add(&room->scene, o, &pixels, flags, INK_TEXT) ||
        !scene_add(&room->lines, o, &stage, flags, INK_TEXT))
        return false;
    scene_shade(&room->scene, o);
    return true;
}

static void draw_lines(const struct canvas *c, const struct scene *scene)
{
    struct hidden_lines *h = &workroom()->hidden;
    struct hidden_part part;
    hidden_begin(h, scene, EDGES_FOLDED);
    while (hidden_next(h, &part))
        if (part.seen)
            canvas_line(c, (int)(part.a.x + 0.5f), (int)(part.a.y + 0.5f), (int)(part.b.x + 0.5f),
                        (int)(part.b.y + 0.5f), INK_GREEN);
}

void surface_draw(const struct scene *scene, enum surface_method method, int picture)
{
    struct canvas c = picture_canvas(picture);
    canvas_clear(&c, INK_BLACK);
    struct depth_buffer depth = lesson_depth(&c);
    switch (method) {
    case METHOD_DEPTH_BUFFER:
    case METHOD_FROM_0:
        depth_clear(&depth, method == METHOD_FROM_0 ? 0 : -1e9f);
        depth_scene(&c, &depth, scene);
        break;
    case METHOD_SCAN_LINE:
        scan_line_scene(&workroom()->scan_line, &c, scene);
        break;
    case METHOD_PAINTER:
        painter_scene(&workroom()->painter, &c, scene);
        break;
    case METHOD_LINES:
        draw_lines(&c, scene);
        break;
    case METHOD_ALL:
        for (int i = 0; i < scene->surfaces; i++)
            paint_surface(&c, scene, &scene->surface[i]);
    }
}

/* Into the middle of the picture; where the canvas is smaller the rest is left out. */
static void copy_picture(const struct stage *stage)
{
    const struct canvas *c = &stage->canvas;
    int left = (int)stage_canvas_x(stage, STAGE_WIDTH / 2) - SURFACE_WIDTH / 2;
    int top = (int)stage_canvas_y(stage, STAGE_HEIGHT / 2) - SURFACE_HEIGHT / 2;
    if (c->bits != 8 || left < 0 || left + SURFACE_WIDTH > c->width)
        return;
    for (int y = 0; y < SURFACE_HEIGHT; y++)
        if (top + y >= 0 && top + y < c->height)
            memcpy(c->pixels + (uint32_t)(top + y) * c->pitch + left,
                   surface_pixels(0) + y * SURFACE_WIDTH, SURFACE_WIDTH);
}

void surface_show(struct monitor *m, enum surface_method method, const char *title)
{
    struct workroom *room = workroom();
    stage_begin(&m->stage);
    stage_heads(&m->stage, STAGE_RASTER);
    copy_picture(&m->stage);
    stage_heads(&m->stage, STAGE_VECTOR);
    stage_ink(&m->stage, INK_GREEN);
    if (method == METHOD_ALL)
        stage_wireframe(&m->stage, &room->lines);
    else
        stage_hidden_lines(&m->stage, &room->lines, EDGES_FOLDED);
    stage_title(&m->stage, title != NULL ? title : titles[method]);
    stage_end(&m->stage);
}
