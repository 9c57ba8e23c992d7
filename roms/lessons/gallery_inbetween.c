/* gallery_inbetween.c — key-frame animation: a dolphin leaps. Five key drawings of Bézier
 * outlines; the frames between them are computed, each point along straight lines or along a
 * spline. */
#include <stdio.h>

#include "roms/curves/bezier.h"
#include "roms/curves/key_frames.h"
#include "roms/lessons/curve_pen.h"
#include "roms/lessons/lesson.h"
#include "roms/raster/polygon_fill.h"

enum { KEYS = 5, OUTLINE = 36, FIN = 9, EYE = OUTLINE + FIN, DRAWING = EYE + 1 };
enum { SKINS_MOST = 4, FRAMES = 24, SEA = 190 };

/* The drawing at rest, nose to the right: a closed outline of cubic pieces (every third point
 * is on it), the fin in front, the eye. */
static const struct point2 rest[DRAWING] = {
    {180, -8},  {162, 4},    {148, 2},    {136, 14},   {108, 38},   {64, 44},    {20, 42},
    {8, 56},    {-4, 76},    {-22, 86},   {-26, 68},   {-34, 48},   {-40, 36},   {-75, 28},
    {-105, 16}, {-125, 8},   {-140, 14},  {-160, 34},  {-178, 44},  {-172, 28},  {-160, 14},
    {-158, 2},  {-160, -10}, {-170, -24}, {-176, -38}, {-158, -30}, {-140, -14}, {-122, -8},
    {-80, -20}, {-30, -44},  {20, -42},   {60, -40},   {104, -36},  {136, -19},  {150, -16},
    {172, -17}, {70, -30},   {58, -56},   {34, -84},   {10, -90},   {20, -70},   {26, -50},
    {38, -32},  {48, -30},   {60, -30},   {118, 4},
};

/* How the animator posed it. */
static const struct pose {
    float x, y, angle, bend;
} poses[KEYS] = {
    {120, 110, 1.15f, 0.0022f},   {310, 470, 0.95f, -0.0012f}, {600, 610, 0, -0.0058f},
    {880, 470, -0.95f, -0.0030f}, {1080, 110, -1.2f, 0.0012f},
};

struct inbetween {
    struct vector3 key[KEYS][DRAWING];
    enum key_path path;
    enum key_timing timing;
    int skins; /* in-betweens shown between two keys */
    bool playing, steered;
    float time; /* 0…1 of the leap; beyond 1 it rests */
    float seconds;
};

static struct inbetween lesson;

/* The drawing bent along an arc, turned and placed. */
static void draw_key(const struct pose *pose, struct vector3 *out)
{
    float c = cosf(pose->angle), s = sinf(pose->angle);
    for (int i = 0; i < DRAWING; i++) {
        float turn = pose->bend * rest[i].x, sine = sinf(turn), cosine = cosf(turn);
        float x = sine / pose->bend - rest[i].y * sine;
        float y = (1 - cosine) / pose->bend + rest[i].y * cosine;
        out[i] = (struct vector3){pose->x + c * x - s * y, pose->y + s * x + c * y, 0};
    }
}

static void begin(void *state)
{
    struct inbetween *l = state;
    *l = (struct inbetween){.skins = 2, .playing = true};
    for (int k = 0; k < KEYS; k++)
        draw_key(&poses[k], l->key[k]);
}

static void step(struct inbetween *l, int frames)
{
    float frame = floorf(l->time * FRAMES + 0.5f) + (float)frames;
    l->playing = false;
    l->time = fminf(fmaxf(frame, 0), FRAMES) / FRAMES;
}

static void key(void *state, int k)
{
    struct inbetween *l = state;
    if (k == 'l')
        l->path = (enum key_path)((l->path + 1) % KEY_PATHS);
    else if (k == 'e')
        l->timing = (enum key_timing)((l->timing + 1) % KEY_TIMINGS);
    else if (k == '+' || k == '=')
        l->skins = l->skins < SKINS_MOST ? l->skins + 1 : SKINS_MOST;
    else if (k == '-')
        l->skins = l->skins > 0 ? l->skins - 1 : 0;
    else if (k == 'p')
        l->playing = !l->playing;
    else if (k == KEY_LEFT)
        step(l, -1);
    else if (k == KEY_RIGHT)
        step(l, 1);
    else
        return;
    l->steered = l->steered || k == 'l' || k == 'e';
}

/* ---- frames ---- */

static void frame_at(const struct inbetween *l, float t, struct vector3 *out)
{
    float weight[KEY_FRAMES_MOST];
    key_weights(l->path, KEYS, t, weight);
    for (int i = 0; i < DRAWING; i++) {
        out[i] = vector3_times(l->key[0][i], weight[0]);
        for (int k = 1; k < KEYS; k++)
            out[i] = vector3_sum(out[i], vector3_times(l->key[k][i], weight[k]));
    }
}

static void piece_of(const struct vector3 *loop, int count, int piece, struct vector3 curve[4])
{
    for (int n = 0; n < 4; n++)
        curve[n] = loop[(3 * piece + n) % count];
}

static void draw_loop(struct stage *s, const struct vector3 *loop, int count, bool thin)
{
    for (int i = 0; 3 * i < count; i++) {
        struct vector3 curve[4];
        piece_of(loop, count, i, curve);
        if (!thin) {
            brush_bezier(s, curve, 4, s->ink);
            continue;
        }
        struct vector3 before = curve[0], p;
        for (int n = 1; n <= 4; n++, before = p) {
            p = bezier_point(curve, 4, (float)n / 4);
            stage_line(s, before.x, before.y, p.x, p.y);
        }
    }
}

static void fill_loop(struct stage *s, const struct vector3 *loop, int count, uint32_t colour)
{
    struct point2 corner[POLYGON_CORNERS];
    int corners = 0;
    for (int i = 0; 3 * i < count; i++) {
        struct vector3 curve[4];
        piece_of(loop, count, i, curve);
        corners = pen_collect(curve, 6, corner, corners, POLYGON_CORNERS);
    }
    for (int i = 0; i < corners; i++)
        corner[i] = (struct point2){stage_canvas_x(s, corner[i].x), stage_canvas_y(s, corner[i].y)};
    canvas_polygon(&s->canvas, corner, corners, POLYGON_NON_ZERO, colour);
}

static void draw_skin(struct stage *s, const struct vector3 *drawing, enum ink ink)
{
    stage_ink(s, ink);
    draw_loop(s, drawing, OUTLINE, true);
}

static void draw_dolphin(struct stage *s, const struct vector3 *drawing)
{
    fill_loop(s, drawing, OUTLINE, ink_shade(RAMP_BLUE, 0.55f));
    fill_loop(s, drawing + OUTLINE, FIN, ink_shade(RAMP_BLUE, 0.3f));
    stage_ink(s, INK_BRIGHT);
    draw_loop(s, drawing, OUTLINE, false);
    draw_loop(s, drawing + OUTLINE, FIN, false);
    brush_point(s, drawing[EYE], 6, INK_BRIGHT);
}

/* ---- scene ---- */

static float wave_at(float x, float seconds)
{
    return SEA + 12 * sinf(x * 0.016f + 1.3f * seconds) + 6 * sinf(x * 0.037f - 0.9f * seconds);
}

/* Sky and water of the raster head: rows that grow lighter toward the horizon. */
static void draw_ground(struct stage *s, float seconds)
{
    enum { BANDS = 8, WAVES = 24 };
    const struct canvas *c = &s->canvas;
    int top = (int)stage_canvas_y(s, STAGE_HEIGHT), horizon = (int)stage_canvas_y(s, SEA - 30);
    int left = (int)stage_canvas_x(s, 0), right = (int)stage_canvas_x(s, STAGE_WIDTH);
    for (int i = 0; i < BANDS; i++) {
        int y0 = top + (horizon - top) * i / BANDS, y1 = top + (horizon - top) * (i + 1) / BANDS;
        float light = (float)(i + 1) / (INK_LEVELS - 1);
        canvas_fill(c, left, y0, right - left, y1 - y0, ink_shade(RAMP_BLUE, light));
    }
    int sun = (int)(70 * s->dots);
    canvas_disc(c, (int)stage_canvas_x(s, 600), horizon - sun / 2, canvas_round_dots(c, sun), sun,
                ink_shade(RAMP_GOLD, 0.62f));
    struct point2 water[WAVES + 3];
    for (int i = 0; i <= WAVES; i++) {
        float x = (float)i * STAGE_WIDTH / WAVES;
        water[i] = (struct point2){stage_canvas_x(s, x), stage_canvas_y(s, wave_at(x, seconds))};
    }
    water[WAVES + 1] = (struct point2){(float)right, stage_canvas_y(s, 0)};
    water[WAVES + 2] = (struct point2){(float)left, stage_canvas_y(s, 0)};
    canvas_polygon(c, water, WAVES + 3, POLYGON_EVEN_ODD, ink_shade(RAMP_BLUE, 0.04f));
}

static void draw_waves(struct stage *s, float seconds)
{
    enum { STEPS = 30, ROWS = 3 };
    for (int row = 0; row < ROWS; row++) {
        float down = 52 * (float)row, phase = seconds + 2 * (float)row;
        struct vector3 before = {0, wave_at(0, phase) - down, 0};
        for (int i = 1; i <= STEPS; i++) {
            float x = (float)i * STAGE_WIDTH / STEPS;
            struct vector3 p = {x, wave_at(x, phase) - down, 0};
            brush_thin(s, before, p, row == 0 ? INK_CYAN : INK_BLUE);
            before = p;
        }
    }
}

/* The nose's way, and on it the frames that are shown at equal times. */
static void draw_path(const struct inbetween *l, struct stage *s)
{
    enum { STEPS = 40 };
    struct vector3 drawing[DRAWING], before = l->key[0][0];
    for (int i = 1; i <= STEPS; i++) {
        frame_at(l, (float)(KEYS - 1) * (float)i / STEPS, drawing);
        brush_thin(s, before, drawing[0], INK_YELLOW);
        before = drawing[0];
    }
    for (int i = 0; i <= FRAMES; i++) {
        frame_at(l, key_time(l->timing, KEYS, (float)i / FRAMES), drawing);
        brush_point(s, drawing[0], 5, INK_YELLOW);
    }
}

static void draw_skins(const struct inbetween *l, struct stage *s)
{
    struct vector3 drawing[DRAWING];
    for (int k = 0; k + 1 < KEYS; k++)
        for (int i = 1; i <= l->skins; i++) {
            frame_at(l, (float)k + (float)i / (float)(l->skins + 1), drawing);
            stage_heads(s, STAGE_RASTER);
            draw_skin(s, drawing, INK_TEXT);
            stage_heads(s, STAGE_VECTOR);
            draw_skin(s, drawing, INK_GRID);
            stage_heads(s, STAGE_BOTH);
        }
    for (int k = 0; k < KEYS; k++)
        draw_skin(s, l->key[k], INK_ORANGE);
}

/* A leap takes 4 s, a rest 1 s; then straight lines and spline change, and after both the
 * timing. */
static void run(struct inbetween *l, float passed)
{
    if (!l->playing)
        return;
    l->time += passed / 4;
    if (l->time < 1.25f)
        return;
    l->time = 0;
    if (l->steered)
        return;
    l->path = (enum key_path)((l->path + 1) % KEY_PATHS);
    if (l->path == KEY_LINEAR)
        l->timing = (enum key_timing)((l->timing + 1) % KEY_TIMINGS);
}

static float draw(void *state, struct stage *s, float seconds)
{
    static const char *const paths[] = {"linear", "spline"};
    static const char *const timings[] = {"even", "slow in and out", "slow at keys"};
    struct inbetween *l = state;
    struct vector3 drawing[DRAWING];
    char text[64];
    run(l, seconds - l->seconds);
    l->seconds = seconds;
    draw_ground(s, seconds);
    draw_skins(l, s);
    draw_path(l, s);
    frame_at(l, key_time(l->timing, KEYS, l->time), drawing);
    draw_dolphin(s, drawing);
    draw_waves(s, seconds);
    pen_words(s, 260, 730, INK_YELLOW, paths[l->path]);
    pen_words(s, 860, 730, INK_GREEN, timings[l->timing]);
    stage_title(s, "Key frames and in-betweens");
    snprintf(text, sizeof text, "frame %d of %d: key drawings orange, computed ones grey",
             (int)(fminf(l->time, 1) * FRAMES + 0.5f), FRAMES);
    stage_caption(s, text);
    return 0.02f;
}

extern const struct lesson lesson_gallery_inbetween;
const struct lesson lesson_gallery_inbetween = {
    .name = "inbetween",
    .title = "Gallery: key frames and in-betweens",
    .keys = "l path  e ease  p pause  arrows frame  + - skins",
    .state = &lesson,
    .begin = begin,
    .key = key,
    .draw = draw};
