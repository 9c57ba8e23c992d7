/* surfaces.c — the lesson about visible surfaces: one scene by each method, and where methods
 * fail. */
#include <stddef.h>
#include <stdio.h>

#include "roms/scenery/depth.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/pages.h"
#include "roms/scenery/workroom.h"
#include "roms/visible/depth_surface.h"

enum { WIRE, BACK, DEPTH, SCAN, PAINT, CIRCLE, FROM_0, PAGES };
enum { PAGE_SECONDS = 9, LEFT = 295, RIGHT = 905, MIDDLE = 410, HALF = 340 };

static struct surfaces {
    int page, made; /* made: the scene in the workroom; -1: none */
} surfaces;

static void begin(void *own)
{
    ((struct surfaces *)own)->made = -1;
}

static void turn(void *own, int page)
{
    ((struct surfaces *)own)->page = page;
}

/* ---- scenes ---------------------------------------------------------------------------------- */

/* The scene at a place: in the workroom's pixels and lines. */
static void build(struct surfaces *s, struct stage *stage, enum scene_which which, float yaw,
                  float pitch, float room, float x, unsigned flags)
{
    struct workroom *w = workroom();
    if (s->made != (int)which)
        scene_make(&w->object, which);
    s->made = (int)which;
    struct matrix4 turn = view_turn(yaw, pitch);
    float scale = room / object_reach(&w->object);
    struct view dots = view_on_canvas(stage, &turn, 0, scale, x, MIDDLE);
    struct view units = view_on_stage(&turn, 0, scale, x, MIDDLE);
    scene_clear(&w->scene);
    scene_clear(&w->lines);
    scene_add(&w->scene, &w->object, &dots, flags, 0);
    scene_add(&w->lines, &w->object, &units, flags, 0);
    scene_shade(&w->scene, &w->object);
}

/* In the part of the canvas about `x`. */
static void by_depth(struct stage *stage, float far, float x)
{
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    if (depth.width == 0)
        return;
    int middle = (int)stage_canvas_x(stage, STAGE_WIDTH / 2);
    depth_clear_part(&depth, x < STAGE_WIDTH / 2 ? 0 : middle, 0, middle, depth.height, far);
    depth_scene(&stage->canvas, &depth, &workroom()->scene);
}

static void vector_lines(struct stage *stage)
{
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_GREEN);
    stage_hidden_lines(stage, &workroom()->lines, EDGES_FOLDED);
    stage_heads(stage, STAGE_BOTH);
}

static void heading(struct stage *stage, float x, enum ink ink, const char *text)
{
    stage_ink(stage, ink);
    stage_text_middle(stage, x, 20, text);
}

/* ---- wireframe, back faces ------------------------------------------------------------------- */

static void draw_wire(struct surfaces *s, struct stage *stage, float seconds)
{
    bool culled = s->page == BACK;
    build(s, stage, SCENE_SOLIDS, 20 * seconds, 20, 450, 600, culled ? SCENE_CULLED : 0);
    stage_ink(stage, INK_GREEN);
    stage_wireframe(stage, &workroom()->lines);
    stage_caption(stage, culled ? "V.N > 0: it looks away. Each convex solid is right now, but not "
                                  "the ring, and not one before another."
                                : "Every edge is drawn: what is in front, what is behind?");
}

/* ---- the depth buffer ------------------------------------------------------------------------ */

struct range {
    float far, near;
};

static struct range depths(const struct scene *scene)
{
    struct range r = {1e9f, -1e9f};
    for (int i = 0; i < scene->corners; i++) {
        float z = scene->vertex[scene->corner[i]].z;
        r.far = fminf(r.far, z);
        r.near = fmaxf(r.near, z);
    }
    return r;
}

/* The left half's depths as grey levels in the right half: nearer is lighter. */
static void show_buffer(struct stage *stage, struct range range)
{
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    const struct canvas *c = &stage->canvas;
    int shift = (int)(stage_canvas_x(stage, RIGHT) - stage_canvas_x(stage, LEFT));
    int x0 = (int)stage_canvas_x(stage, 0), x1 = (int)stage_canvas_x(stage, 2 * LEFT);
    int y0 = (int)stage_canvas_y(stage, STAGE_HEIGHT), y1 = (int)stage_canvas_y(stage, 50);
    uint8_t grey[INK_LEVELS];
    for (int i = 0; i < INK_LEVELS; i++)
        grey[i] = (uint8_t)ink_shade(RAMP_GREY, (float)i / (INK_LEVELS - 1));
    float k = (INK_LEVELS - 3) / (range.near - range.far);
    for (int y = y0 > 0 ? y0 : 0; y < y1 && y < depth.height; y++) {
        const float *from = depth.depth + y * depth.width;
        uint8_t *to = c->pixels + (uint32_t)y * c->pitch + shift;
        for (int x = x0 > 0 ? x0 : 0; x < x1 && x + shift < c->width; x++) {
            int level = from[x] < range.far ? 0 : 2 + (int)((from[x] - range.far) * k);
            to[x] = grey[level < INK_LEVELS ? level : INK_LEVELS - 1];
        }
    }
}

/* What the buffer holds along a row, as a curve; down to its foot where nothing is. */
static void show_profile(struct stage *stage, struct range range, float height)
{
    enum { APART = 4 }; /* pixels */
    const float foot = 190, high = 400, k = (high - 40) / (range.near - range.far);
    struct depth_buffer depth = lesson_depth(&stage->canvas);
    int row = (int)stage_canvas_y(stage, height);
    struct point2 before = {RIGHT - 290, foot};
    bool level = true;
    for (int x = (int)stage_canvas_x(stage, LEFT - 290); x < (int)stage_canvas_x(stage, LEFT + 290);
         x += APART) {
        float z = depth.depth[row * depth.width + (x > 0 ? x : 0)];
        struct point2 at = {((float)x - stage->left) / stage->dots + RIGHT - LEFT,
                            z < range.far ? foot : foot + 40 + (z - range.far) * k};
        /* One line for all of the foot. */
        if (level && at.y == foot)
            continue;
        if (level)
            stage_line(stage, before.x, foot, at.x, foot);
        stage_line(stage, level ? at.x : before.x, before.y, at.x, at.y);
        level = at.y == foot;
        before = at;
    }
    stage_line(stage, before.x, before.y, RIGHT + 290, level ? foot : before.y);
}

static void draw_depth(struct surfaces *s, struct stage *stage, float seconds)
{
    build(s, stage, SCENE_SOLIDS, 20 * seconds, 20, HALF, LEFT, SCENE_CULLED);
    struct range range = depths(&workroom()->scene);
    float height = MIDDLE + 10 + 150 * sinf(0.8f * seconds);
    by_depth(stage, -1e9f, LEFT);
    if (lesson_depth(&stage->canvas).width > 0) {
        show_buffer(stage, range);
        stage_heads(stage, STAGE_VECTOR);
        stage_ink(stage, INK_BRIGHT);
        show_profile(stage, range, height);
        stage_line(stage, 0, height, 2 * LEFT, height);
        stage_text_middle(stage, RIGHT, 130, "depths along the row");
        stage_heads(stage, STAGE_BOTH);
    }
    vector_lines(stage);
    heading(stage, LEFT, INK_TEXT, "refresh buffer");
    stage_heads(stage, STAGE_RASTER);
    heading(stage, RIGHT, INK_TEXT, "depth buffer: near is light");
    stage_heads(stage, STAGE_BOTH);
    stage_caption(stage,
                  "At each pixel: is this surface nearer than what the buffer holds? Then it "
                  "is stored and shown.");
}

/* ---- scan line ------------------------------------------------------------------------------- */

enum { COLUMN = 850 };

static void run_text(struct stage *stage, float y, const struct scan_line *sl,
                     const struct scan_run *run)
{
    char text[40];
    int n = 0;
    for (int i = 0; i < sl->flags && i < 3; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "S%d ", sl->flagged[i] + 1);
    if (sl->flags > 1)
        snprintf(text + n, sizeof text - (size_t)n, "-> depth: S%d", run->surface + 1);
    else
        snprintf(text + n, sizeof text - (size_t)n, "alone");
    stage_ink(stage, sl->flags > 1 ? INK_YELLOW : INK_TEXT);
    stage_text(stage, COLUMN, y, text);
}

/* The row at hand: its active edges, its runs. */
static void show_row(struct stage *stage, struct scan_line *sl)
{
    char text[40];
    float y = MIDDLE + 250, at = ((float)(stage->bottom - 1) - (float)sl->y) / stage->dots;
    stage_ink(stage, INK_BRIGHT);
    stage_line(stage, 0, at, COLUMN - 40, at);
    snprintf(text, sizeof text, "row %d", sl->y);
    stage_text(stage, COLUMN, y, text);
    snprintf(text, sizeof text, "%d active edges", sl->active_count);
    stage_text(stage, COLUMN, y - 45, text);
    for (int i = 0; i < sl->active_count; i++) {
        float x = (sl->edge[sl->active[i]].edge.x - stage->left) / stage->dots;
        stage_rectangle(stage, x - 7, at - 7, 14, 14);
    }
    stage_text(stage, COLUMN, y - 120, "flags that are on:");
    struct scan_run run;
    y -= 165;
    while (scan_line_run(sl, &run)) {
        if (run.surface == SURFACE_NONE)
            continue;
        run_text(stage, y, sl, &run);
        y -= 40;
    }
}

static void draw_scan(struct surfaces *s, struct stage *stage, float seconds)
{
    struct workroom *w = workroom();
    struct scan_run run;
    build(s, stage, SCENE_TWO, 12 * sinf(seconds * 0.5f), 0, 390, 415, 0);
    vector_lines(stage);
    if (stage->canvas.width == 0)
        return;
    float part = fmodf(seconds / 6, 1);
    int row = (int)stage_canvas_y(stage, MIDDLE + 270 - part * 540);
    scan_line_begin(&w->scan_line, &w->scene, stage->canvas.width, stage->canvas.height);
    while (scan_line_next(&w->scan_line) && w->scan_line.y < row)
        while (scan_line_run(&w->scan_line, &run))
            if (run.surface != SURFACE_NONE)
                canvas_fill(&stage->canvas, run.x0, w->scan_line.y, run.x1 - run.x0, 1,
                            w->scene.surface[run.surface].colour);
    stage_heads(stage, STAGE_RASTER);
    stage_ink(stage, INK_GRID);
    stage_wireframe(stage, &w->lines);
    stage_heads(stage, STAGE_BOTH);
    show_row(stage, &w->scan_line);
    stage_caption(stage, "Between two active edges the flags say which surfaces are there; depths "
                         "matter only where two are.");
}

/* ---- painter's ------------------------------------------------------------------------------- */

/* The surfaces painted so far; on the vector head their outlines. */
static void paint_part(struct stage *stage, float part)
{
    struct workroom *w = workroom();
    painter_begin(&w->painter, &w->scene);
    int most = (int)(part * (float)(w->painter.count + 1));
    for (int i = 0; i < most; i++) {
        int k = painter_next(&w->painter);
        if (k < 0)
            return;
        if (stage->canvas.width > 0)
            paint_surface(&stage->canvas, &w->scene, &w->scene.surface[k]);
        const struct surface *f = &w->lines.surface[k];
        struct point2 corner[SURFACE_CORNERS];
        for (int n = 0; n < f->count; n++) {
            struct vector3 v = scene_corner(&w->lines, f, n);
            corner[n] = (struct point2){v.x, v.y};
        }
        stage_heads(stage, STAGE_VECTOR);
        stage_ink(stage, INK_GREEN);
        stage_polygon(stage, corner, f->count);
        stage_heads(stage, STAGE_BOTH);
    }
}

static void draw_paint(struct surfaces *s, struct stage *stage, float seconds)
{
    build(s, stage, SCENE_SOLIDS, 12 * seconds, 20, 450, 600, SCENE_CULLED);
    paint_part(stage, fminf(fmodf(seconds, PAGE_SECONDS) / (PAGE_SECONDS - 2), 1));
    stage_caption(stage, "From far to near, each over those before it: sorting by depth does the "
                         "work.");
}

static void draw_circle(struct surfaces *s, struct stage *stage, float seconds)
{
    enum scene_which which =
        fmodf(seconds, PAGE_SECONDS) < PAGE_SECONDS / 2.0f ? SCENE_CYCLE : SCENE_PIERCE;
    float yaw = which == SCENE_PIERCE ? 30 * sinf(seconds) - 10 : 8 * sinf(seconds);
    build(s, stage, which, yaw, which == SCENE_PIERCE ? 20 : 0, 280, LEFT, 0);
    paint_part(stage, 1);
    build(s, stage, which, yaw, which == SCENE_PIERCE ? 20 : 0, 280, RIGHT, 0);
    by_depth(stage, -1e9f, RIGHT);
    vector_lines(stage);
    heading(stage, LEFT, INK_RED, "painter's: wrong");
    heading(stage, RIGHT, INK_GREEN, "depth buffer: right");
    stage_caption(stage, which == SCENE_CYCLE ? "Each bar lies over the next: whichever is painted "
                                                "first, one comes out wrong."
                                              : "They pierce one another: no order is right until "
                                                "they are cut up.");
}

/* ---- a buffer that begins with 0 ------------------------------------------------------------- */

/* What of a part has z > 0; false: nothing. */
static bool cut_at_0(struct hidden_part *p)
{
    struct vector3 *low = p->a.z < p->b.z ? &p->a : &p->b, high = p->a.z < p->b.z ? p->b : p->a;
    if (high.z <= 0)
        return false;
    if (low->z < 0) {
        float t = high.z / (high.z - low->z);
        *low = vector3_sum(high, vector3_times(vector3_difference(*low, high), t));
    }
    return true;
}

/* On the left what is seen, on the right what of it has z > 0. */
static void near_lines(struct stage *stage)
{
    struct hidden_lines *h = &workroom()->hidden;
    struct hidden_part p;
    const float apart = RIGHT - LEFT;
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_GREEN);
    hidden_begin(h, &workroom()->lines, EDGES_FOLDED);
    while (hidden_next(h, &p)) {
        if (!p.seen)
            continue;
        stage_line(stage, p.a.x, p.a.y, p.b.x, p.b.y);
        if (cut_at_0(&p))
            stage_line(stage, p.a.x + apart, p.a.y, p.b.x + apart, p.b.y);
    }
    stage_heads(stage, STAGE_BOTH);
}

/* Moves the scene to the right. */
static void shift(struct scene *scene, float by)
{
    for (int i = 0; i < scene->vertices; i++)
        scene->vertex[i].x += by;
    for (int i = 0; i < scene->surfaces; i++)
        scene->surface[i].plane.d -= scene->surface[i].plane.a * by;
}

static void draw_from_0(struct surfaces *s, struct stage *stage, float seconds)
{
    build(s, stage, SCENE_SOLIDS, 20 * seconds, 20, HALF, LEFT, SCENE_CULLED);
    near_lines(stage);
    by_depth(stage, -1e9f, LEFT);
    shift(&workroom()->scene, (RIGHT - LEFT) * stage->dots);
    by_depth(stage, 0, RIGHT);
    heading(stage, LEFT, INK_GREEN, "cleared to the far plane");
    heading(stage, RIGHT, INK_RED, "cleared to 0");
    stage_caption(stage,
                  "Larger z is nearer. A buffer that begins with 0 hides all that has z <= 0: "
                  "clear it to the smallest depth.");
}

static float draw(void *own, struct stage *stage, int page, float seconds)
{
    static const struct {
        const char *title;
        void (*draw)(struct surfaces *s, struct stage *stage, float seconds);
    } table[PAGES] = {{"Wireframe", draw_wire},
                      {"Back faces removed", draw_wire},
                      {"Depth buffer", draw_depth},
                      {"Scan line", draw_scan},
                      {"Painter's method", draw_paint},
                      {"Where the painter fails", draw_circle},
                      {"A depth buffer that begins with 0", draw_from_0}};
    table[page].draw(own, stage, seconds);
    stage_title(stage, table[page].title);
    return PAGE_SECONDS;
}

static struct pages pages = {
    .count = PAGES, .own = &surfaces, .begin = begin, .turn = turn, .draw = draw};

extern const struct lesson lesson_surfaces;
const struct lesson lesson_surfaces = {"surfaces",  "Visible surfaces", PAGES_KEYS, &pages,
                                       pages_begin, pages_key,          pages_draw};
