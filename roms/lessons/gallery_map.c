/* gallery_map.c — a map drawn through the viewing pipeline: zoom, pan, a turned frame, clipped.
 *
 *      coast, contours, rivers, roads (MC = WC) ─┐
 *      ship, towns (MC, placed by their model) ──┴─▶ VC ─▶ NVC, clipped ─▶ stage
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/clip/pipeline2.h"
#include "roms/clip/text.h"
#include "roms/geometry/scalar.h"
#include "roms/geometry/transform2.h"
#include "roms/lessons/large_text.h"
#include "roms/lessons/lesson.h"
#include "roms/lessons/map_relief.h"
#include "roms/lessons/map_terrain.h"

enum { TOWNS = 9, ROADS = 4, ROAD_POINTS = 6 };

static const struct {
    struct point2 at;
    const char *name;
    int size;
} towns[TOWNS] = {
    {{20, 59}, "Holm", 1},   {{52, 65}, "Kirkdale", 2}, {{79, 68}, "Sund", 1},
    {{86, 81}, "Ness", 1},   {{47, 29}, "Port Elm", 2}, {{56, 16}, "Vik", 1},
    {{95, 42}, "Easter", 1}, {{104, 20}, "Skerry", 1},  {{70, 42}, "Moor End", 1},
};

static const struct {
    struct point2 point[ROAD_POINTS];
    int count;
} roads[ROADS] = {
    {{{20, 59}, {29, 63}, {40, 67}, {52, 65}, {66, 69}, {79, 68}}, 6},
    {{{79, 68}, {77, 74}, {80, 79}, {86, 81}}, 4},
    {{{52, 65}, {50, 54}, {48, 42}, {47, 29}, {51, 21}, {56, 16}}, 6},
    {{{47, 29}, {58, 36}, {70, 42}, {83, 46}, {95, 42}}, 5},
};

/* Made about the origin, bow to the right. */
static const struct point2 hull[] = {
    {-2, -0.7f}, {1.2f, -0.7f}, {2.4f, 0}, {1.2f, 0.7f}, {-2, 0.7f}};
static const struct point2 house[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/* Where the tour goes: middle, zoom, turn. */
struct stop {
    float x, y, zoom, turn;
};
static const struct stop tour[] = {
    {60, 50, 1, 0},      {47, 30, 2.6f, 0}, {52, 62, 2.6f, 35}, {84, 72, 3.4f, 70},
    {96, 36, 2.2f, 130}, {60, 50, 1, 180},  {60, 50, 1, 360},
};
enum { STOPS = sizeof tour / sizeof tour[0] };
#define STOP_SECONDS 7.0f
#define MOVE_SECONDS 4.5f

static struct {
    struct map_terrain terrain;
    struct sutherland_hodgman work;
    struct stop view; /* what is seen */
    bool touring;
    bool made;
} map;

static const struct clip_window map_viewport = {0, 0, 866, 780}; /* stage units */
static const struct clip_window inset_viewport = {884, 516, 1200, 779};

/* ---- drawing through the pipeline ------------------------------------------------------------ */

static void to_stage(void *ctx, struct point2 a, struct point2 b)
{
    stage_line(ctx, a.x, a.y, b.x, b.y);
}

/* The unit square of normalized coordinates is 1200 by 1200 stage units, so that shapes stay. */
static struct clip_window normalized(const struct clip_window *v)
{
    return (struct clip_window){v->x_min / STAGE_WIDTH, v->y_min / STAGE_WIDTH,
                                v->x_max / STAGE_WIDTH, v->y_max / STAGE_WIDTH};
}

/* So many km up and down, in the viewport's shape. */
static struct pipeline2 pipeline_of(const struct clip_window *viewport, const struct stop *v)
{
    struct pipeline2 p;
    float shape = (viewport->x_max - viewport->x_min) / (viewport->y_max - viewport->y_min);
    float half = 53 / v->zoom;
    struct sine_cosine up = scalar_sine_cosine(v->turn + 90);
    const struct view2 view = {.origin = {v->x, v->y},
                               .up = {up.cosine, up.sine},
                               .window = {-half * shape, -half, half * shape, half},
                               .viewport = normalized(viewport),
                               .device = {0, 0, STAGE_WIDTH, STAGE_WIDTH}};
    pipeline2_begin(&p, &view); /* neither empty nor without a direction */
    return p;
}

static void contours(struct stage *s, const struct pipeline2 *p)
{
    const struct map_terrain *t = &map.terrain;
    for (int i = 0; i < t->lines; i++) {
        const struct map_line *line = &t->line[i];
        bool coast = line->level == 0;
        /* The vector head has every second one: it must be through in a refresh. */
        stage_heads(s, line->level % 2 == 0 ? STAGE_BOTH : STAGE_RASTER);
        stage_ink(s, coast ? INK_BRIGHT : INK_BROWN);
        pipeline2_polyline(p, &t->point[line->first], line->count, to_stage, s);
    }
    stage_heads(s, STAGE_BOTH);
}

static void graticule(struct stage *s, const struct pipeline2 *p)
{
    stage_ink(s, INK_GRID);
    for (int k = 0; k <= MAP_WIDTH; k += 20) {
        const struct point2 north[] = {{(float)k, 0}, {(float)k, MAP_HEIGHT}};
        const struct point2 east[] = {{0, (float)k}, {MAP_WIDTH, (float)k}};
        pipeline2_polyline(p, north, 2, to_stage, s);
        if (k <= MAP_HEIGHT)
            pipeline2_polyline(p, east, 2, to_stage, s);
    }
}

static void rivers_and_roads(struct stage *s, const struct pipeline2 *p)
{
    stage_ink(s, INK_CYAN);
    for (int i = 0; i < MAP_RIVERS; i++)
        pipeline2_polyline(p, map.terrain.river[i], map.terrain.river_count[i], to_stage, s);
    stage_ink(s, INK_RED);
    for (int i = 0; i < ROADS; i++)
        pipeline2_polyline(p, roads[i].point, roads[i].count, to_stage, s);
}

/* A model in the world: turned, sized, put there; filled. */
static void place_model(struct stage *s, struct pipeline2 *p, const struct point2 *corners,
                        int count, struct point2 at, float turn, float size)
{
    struct matrix3 m = transform2_scale(size, size), next = transform2_rotate(turn);
    m = transform2_then(&m, &next);
    next = transform2_translate(at.x, at.y);
    m = transform2_then(&m, &next);
    pipeline2_model(p, &m);
    count = pipeline2_polygon(p, corners, count, &map.work);
    stage_area(s, map.work.corner, count);
    m = matrix3_identity();
    pipeline2_model(p, &m);
}

/* Names are shown whole or not at all. */
static void name_town(struct stage *s, const char *name, struct point2 at)
{
    static const struct clip_font cell = {8, 12, NULL};
    const struct clip_text text = {name, &cell, {at.x + 14, at.y + 8}, 2.05f};
    if (!clip_text_shows(&text, &map_viewport, CLIP_TEXT_STRING, 0))
        return;
    stage_heads(s, STAGE_RASTER);
    stage_ink(s, INK_BLACK);
    stage_text(s, text.at.x + 2, text.at.y - 2, name);
    stage_heads(s, STAGE_BOTH);
    stage_ink(s, INK_BRIGHT);
    stage_text(s, text.at.x, text.at.y, name);
}

/* The same size on the screen in every view, and upright. */
static void draw_towns(struct stage *s, struct pipeline2 *p)
{
    for (int i = 0; i < TOWNS; i++) {
        struct point2 at = towns[i].at;
        stage_ink(s, INK_YELLOW);
        place_model(s, p, house, 4, at, map.view.turn,
                    (float)(towns[i].size + 1) * 0.5f / map.view.zoom);
        if (pipeline2_point(p, &at))
            name_town(s, towns[i].name, at);
    }
}

/* Round the island: an ellipse with corners. */
static struct point2 ship_at(float seconds)
{
    float c = cosf(seconds * 0.06f), n = sinf(seconds * 0.06f);
    return (struct point2){60 + copysignf(57 * powf(fabsf(c), 0.3f), c),
                           50 + copysignf(46 * powf(fabsf(n), 0.3f), n)};
}

static void draw_ship(struct stage *s, struct pipeline2 *p, float seconds)
{
    struct point2 at = ship_at(seconds), ahead = ship_at(seconds + 0.3f);
    float turn = atan2f(ahead.y - at.y, ahead.x - at.x) / DEGREE;
    stage_ink(s, INK_ORANGE);
    place_model(s, p, hull, 5, at, turn, 1.2f / sqrtf(map.view.zoom));
}

/* ---- what stands beside the map -------------------------------------------------------------- */

static void inset(struct stage *s)
{
    static const struct stop whole = {60, 50, 1, 0};
    struct pipeline2 p = pipeline_of(&inset_viewport, &whole);
    const struct map_terrain *t = &map.terrain;
    for (int i = 0; i < t->lines; i++) {
        struct point2 coarse[MAP_POINTS / 3 + 2];
        int n = 0;
        if (t->line[i].level > 0)
            break;
        for (int k = 0; k < t->line[i].count; k += 3)
            coarse[n++] = t->point[t->line[i].first + k];
        coarse[n++] = t->point[t->line[i].first];
        stage_ink(s, INK_GREEN);
        pipeline2_polyline(&p, coarse, n, to_stage, s);
    }
    float half = 53 / map.view.zoom, wide = half * (map_viewport.x_max / map_viewport.y_max);
    struct matrix3 turn = transform2_rotate(map.view.turn);
    struct matrix3 move = transform2_translate(map.view.x, map.view.y);
    struct matrix3 m = transform2_then(&turn, &move);
    const struct point2 window[] = {
        {-wide, -half}, {wide, -half}, {wide, half}, {-wide, half}, {-wide, -half}};
    stage_ink(s, INK_YELLOW);
    pipeline2_model(&p, &m);
    pipeline2_polyline(&p, window, 5, to_stage, s);
    stage_ink(s, INK_TEXT);
    stage_rectangle(s, inset_viewport.x_min, inset_viewport.y_min,
                    inset_viewport.x_max - inset_viewport.x_min,
                    inset_viewport.y_max - inset_viewport.y_min);
}

static void north_arrow(struct stage *s, struct point2 at)
{
    struct sine_cosine of = scalar_sine_cosine(90 - map.view.turn);
    struct point2 n = {of.cosine, of.sine};
    struct point2 tip = {at.x + 60 * n.x, at.y + 60 * n.y},
                  tail = {at.x - 60 * n.x, at.y - 60 * n.y};
    const struct point2 head[] = {tip,
                                  {at.x + 10 * n.x - 22 * n.y, at.y + 10 * n.y + 22 * n.x},
                                  {at.x + 10 * n.x + 22 * n.y, at.y + 10 * n.y - 22 * n.x}};
    stage_ink(s, INK_ORANGE);
    stage_line(s, at.x, at.y, tail.x, tail.y);
    stage_area(s, head, 3);
    large_text_middle(s, at.x + 84 * n.x, at.y + 84 * n.y - 14, "N");
}

static void panel(struct stage *s)
{
    enum { X = 884 };
    char text[24];
    float km = map_viewport.x_max / map_viewport.y_max * 106 / map.view.zoom; /* across */
    float bar = km > 60   ? 20
                : km > 30 ? 10
                : km > 15 ? 5
                          : 2,
          length = bar / km * map_viewport.x_max;
    stage_ink(s, INK_BRIGHT);
    snprintf(text, sizeof text, "zoom %4.1f", (double)map.view.zoom);
    large_text(s, X, 450, text);
    snprintf(text, sizeof text, "turn %4d", (int)rintf(map.view.turn));
    large_text(s, X, 390, text);
    north_arrow(s, (struct point2){1040, 250});
    stage_ink(s, INK_BRIGHT);
    for (int i = 0; i < 3; i++)
        stage_line(s, X, 70 + (float)i * 2, X + length, 70 + (float)i * 2);
    stage_line(s, X, 60, X, 86);
    stage_line(s, X + length, 60, X + length, 86);
    snprintf(text, sizeof text, "%d km", (int)bar);
    large_text(s, X, 14, text);
}

/* ---- the lesson ------------------------------------------------------------------------------ */

static void begin(void *state)
{
    (void)state;
    if (!map.made)
        map_terrain_make(&map.terrain);
    map.made = true;
    map.view = tour[0];
    map.touring = true;
}

/* From stop to stop, standing a while at each. */
static void follow_tour(float seconds)
{
    int i = (int)(seconds / STOP_SECONDS);
    float part = (seconds - (float)i * STOP_SECONDS) / MOVE_SECONDS;
    const struct stop *a = &tour[i % STOPS], *b = &tour[(i + 1) % STOPS];
    part = part > 1 ? 1 : part * part * (3 - 2 * part);
    map.view = (struct stop){a->x + part * (b->x - a->x), a->y + part * (b->y - a->y),
                             a->zoom * powf(b->zoom / a->zoom, part),
                             fmodf(a->turn, 360) + part * (b->turn - fmodf(a->turn, 360))};
}

static void pan(float right, float up)
{
    struct sine_cosine d = scalar_sine_cosine(map.view.turn);
    float step = 10 / map.view.zoom;
    map.view.x += step * (right * d.cosine - up * d.sine);
    map.view.y += step * (right * d.sine + up * d.cosine);
    map.view.x = fminf(fmaxf(map.view.x, 0), MAP_WIDTH);
    map.view.y = fminf(fmaxf(map.view.y, 0), MAP_HEIGHT);
}

static void key(void *state, int k)
{
    (void)state;
    struct stop *v = &map.view;
    map.touring = k == 't';
    if (k == '+' || k == '=')
        v->zoom = fminf(v->zoom * 1.25f, 12);
    else if (k == '-')
        v->zoom = fmaxf(v->zoom / 1.25f, 0.5f);
    else if (k == 'l')
        v->turn = fmodf(v->turn + 10, 360);
    else if (k == 'r')
        v->turn = fmodf(v->turn + 350, 360);
    else if (k == '0')
        *v = tour[0];
    else if (k == KEY_LEFT)
        pan(-1, 0);
    else if (k == KEY_RIGHT)
        pan(1, 0);
    else if (k == KEY_UP)
        pan(0, 1);
    else if (k == KEY_DOWN)
        pan(0, -1);
}

static float draw(void *state, struct stage *s, float seconds)
{
    (void)state;
    if (map.touring)
        follow_tour(seconds);
    struct pipeline2 p = pipeline_of(&map_viewport, &map.view);
    struct matrix3 back;
    if (matrix3_inverse(&p.whole, &back))
        map_relief(s, &map.terrain, &map_viewport, &back);
    graticule(s, &p);
    contours(s, &p);
    rivers_and_roads(s, &p);
    draw_ship(s, &p, seconds);
    draw_towns(s, &p);
    stage_ink(s, INK_TEXT);
    stage_rectangle(s, map_viewport.x_min, map_viewport.y_min, map_viewport.x_max,
                    map_viewport.y_max);
    inset(s);
    panel(s);
    stage_title(s, "A map through the viewing pipeline");
    stage_caption(s, "The yellow frame is the window; what it holds fills the viewport.");
    return 0.04f;
}

extern const struct lesson lesson_gallery_map;
const struct lesson lesson_gallery_map = {
    "map", "Gallery: map", "+ - zoom  arrows pan  l r turn  0 all  t tour", &map, begin, key, draw};
