/* segments.c — a train of segments that move by image transformation, and the display memory that
 * holds them.
 *
 *      smoke  ○ ○ o        each part is a segment; smoke is made and deleted all the time
 *      ┌─┐____||__
 *      │ │________|        memory: │1 │2│///│5│ │7  │   used, being left, free; arcs: the jumps
 *       (+)(+)(+)
 *
 * Models:     what a segmented display file does with its memory (roms/stage/segments.h).
 * Ownership:  static storage.
 * Errors:     smoke that finds no room is not made.
 * Source:     W. M. Newman, R. F. Sproull, Principles of Interactive Computer Graphics (1979),
 *             chapter 8.
 */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/lessons/lesson.h"
#include "roms/stage/segments.h"

/* Once from side to side while all chapters pass; the train stands in one of them for a while. */
#define WAY   (STAGE_WIDTH + 600)
#define SPEED (WAY / (5 * CHAPTER_SECONDS - PAUSE_SECONDS))

enum { MEMORY_BYTES = 1760, CIRCLE_MOST = 20, RAIL = 330 };
enum {
    TRACK = 1,
    HILLS,
    SIGNAL,
    LAMP,
    ENGINE,
    ROD,
    WHEEL,             /* and the two after it */
    SMOKE = WHEEL + 3, /* and those after it */
    SMOKES = 9,
    NAMES = SMOKE + SMOKES
};

struct puff {
    float born; /* seconds; below 0: is not there */
    float x;
};

/* Display memory as it was: shown for a moment, so that it can be read. */
struct snapshot {
    int count, leaving_count, holes;
    struct {
        int name;
        struct extent words;
    } block[SEGMENTS_MOST];
    struct extent leaving[SEGMENTS_LEAVING];
    uint32_t low, high, free;
    float due; /* the next one, seconds */
};

static struct lesson_state {
    struct segments segments;
    struct snapshot memory;
    bool made, stopped, smoking, hidden, bright;
    float before; /* seconds, of the last picture */
    float train;  /* how far it has come */
    float pause;  /* until then it stands, and memory with it */
    int chapter;
    int next_puff;
    float puff_due;
    struct puff puff[SMOKES];
} lesson_state;

static enum ink ink_of(int name)
{
    static const enum ink inks[SMOKE] = {
        [TRACK] = INK_BROWN,  [HILLS] = INK_GREEN,      [SIGNAL] = INK_TEXT,
        [LAMP] = INK_RED,     [ENGINE] = INK_CYAN,      [ROD] = INK_ORANGE,
        [WHEEL] = INK_YELLOW, [WHEEL + 1] = INK_YELLOW, [WHEEL + 2] = INK_YELLOW};
    return name < SMOKE ? inks[name] : INK_VIOLET;
}

/* ---- making the parts ------------------------------------------------------------------------ */

static void put_circle(struct segments *s, float x, float y, float radius, int sides)
{
    struct point2 p[CIRCLE_MOST];
    for (int i = 0; i < sides; i++) {
        float angle = TURN * (float)i / (float)sides;
        p[i] = (struct point2){x + radius * cosf(angle), y + radius * sinf(angle)};
    }
    segment_put(s, SEGMENT_POLYGON, p, sides);
}

static void put_line(struct segments *s, float x0, float y0, float x1, float y1)
{
    struct point2 p[] = {{x0, y0}, {x1, y1}};
    segment_put(s, SEGMENT_POLYLINE, p, 2);
}

static void put_box(struct segments *s, enum segment_kind kind, float x, float y, float width,
                    float height)
{
    struct point2 p[] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    segment_put(s, kind, p, 4);
}

static void make_track(struct segments *s)
{
    put_line(s, 0, RAIL, STAGE_WIDTH, RAIL);
    put_line(s, 0, RAIL - 14, STAGE_WIDTH, RAIL - 14);
    for (int x = 40; x < STAGE_WIDTH; x += 160)
        put_box(s, SEGMENT_POLYGON, (float)x, RAIL - 28, 40, 14);
}

static void make_hills(struct segments *s)
{
    static const struct point2 hills[] = {{0, 430},   {120, 520},  {250, 470},
                                          {430, 610}, {600, 500},  {760, 560},
                                          {930, 640}, {1080, 520}, {1200, 560}};
    segment_put(s, SEGMENT_POLYLINE, hills, (int)(sizeof hills / sizeof hills[0]));
}

static void make_signal(struct segments *s)
{
    put_box(s, SEGMENT_POLYGON, 1010, RAIL, 14, 250);
    put_box(s, SEGMENT_POLYGON, 990, RAIL + 250, 54, 70);
}

static void make_lamp(struct segments *s)
{
    put_circle(s, 1017, RAIL + 285, 20, 10);
}

/* About the middle of its middle wheel. */
static void make_engine(struct segments *s)
{
    static const struct point2 body[] = {{-230, 0},  {-230, 210}, {-250, 230}, {-90, 230},
                                         {-90, 130}, {60, 130},   {60, 210},   {50, 230},
                                         {120, 230}, {110, 210},  {110, 130},  {190, 130},
                                         {215, 90},  {190, 50},   {190, 0}};
    segment_put(s, SEGMENT_AREA, body, (int)(sizeof body / sizeof body[0]));
    s->ink = INK_BRIGHT;
    put_box(s, SEGMENT_POLYGON, -200, 140, 80, 60);
    put_line(s, -90, 100, 190, 100);
    segment_put_text(s, (struct point2){-60, 60}, "KINESCOPE");
}

static void make_wheel(struct segments *s)
{
    put_circle(s, 0, 0, 58, CIRCLE_MOST);
    put_circle(s, 0, 0, 12, 6);
    put_line(s, -58, 0, 58, 0);
    put_line(s, 0, -58, 0, 58);
}

static void make_rod(struct segments *s)
{
    put_box(s, SEGMENT_POLYGON, -150, -7, 300, 14);
}

static void make(struct segments *s, int name, void (*draw)(struct segments *s))
{
    s->ink = ink_of(name);
    if (segment_create(s, name) != SEGMENT_OK)
        return;
    draw(s);
    segment_close(s);
}

static void make_all(struct lesson_state *l, struct stage *stage)
{
    struct segments *s = &l->segments;
    segments_begin(s, stage, MEMORY_BYTES);
    make(s, TRACK, make_track);
    make(s, HILLS, make_hills);
    make(s, SIGNAL, make_signal);
    make(s, LAMP, make_lamp);
    make(s, ENGINE, make_engine);
    for (int i = 0; i < 3; i++)
        make(s, WHEEL + i, make_wheel);
    make(s, ROD, make_rod);
    segment_set_highlight(s, LAMP, SEGMENT_BLINKING);
    l->made = true;
}

/* ---- what moves ------------------------------------------------------------------------------ */

static struct matrix3 placed(float x, float y, float scale, float turns)
{
    float c = scale * cosf(turns * TURN), s = scale * sinf(turns * TURN);
    return (struct matrix3){{{c, -s, x}, {s, c, y}, {0, 0, 1}}};
}

static void set(struct segments *s, int name, struct matrix3 transform)
{
    segment_set_transform(s, name, &transform);
}

/* From beyond the left edge to beyond the right one, and again. */
static float engine_x(const struct lesson_state *l)
{
    return l->train - WAY * floorf(l->train / WAY) - 260;
}

static void move_train(struct lesson_state *l)
{
    struct segments *s = &l->segments;
    float x = engine_x(l), y = RAIL + 58, turns = -l->train / (TURN * 58);
    set(s, ENGINE, placed(x, y, 1, 0));
    for (int i = 0; i < 3; i++)
        set(s, WHEEL + i, placed(x + 130 * (float)(i - 1), y, 1, turns));
    set(s, ROD, placed(x + 36 * cosf(turns * TURN), y + 36 * sinf(turns * TURN), 1, 0));
    segment_set_visible(s, LAMP, x > 500 && x < 1300);
}

static void make_puff(struct lesson_state *l, float seconds)
{
    struct segments *s = &l->segments;
    int i = l->next_puff, name = SMOKE + i;
    s->ink = ink_of(name);
    if (segment_find(s, name) != NULL || segment_create(s, name) != SEGMENT_OK)
        return;
    put_circle(s, 0, 0, 14, 7 + 5 * i % 12); /* of many lengths */
    if (segment_close(s) != SEGMENT_OK) {
        segment_delete(s, name);
        return;
    }
    l->puff[i] = (struct puff){seconds, engine_x(l) + 85};
    l->next_puff = (i + 1) % SMOKES;
}

static void move_smoke(struct lesson_state *l, float seconds)
{
    for (int i = 0; i < SMOKES; i++) {
        float age = seconds - l->puff[i].born;
        if (l->puff[i].born < 0)
            continue;
        if (age > 2.6f) {
            if (segment_delete(&l->segments, SMOKE + i) == SEGMENT_OK)
                l->puff[i].born = -1;
            continue;
        }
        set(&l->segments, SMOKE + i,
            placed(l->puff[i].x - 22 * age, RAIL + 310 + 46 * age, 0.8f + 0.9f * age, 0.1f * age));
    }
    float x = engine_x(l);
    if (l->smoking && !l->stopped && seconds >= l->puff_due && x > -80 && x < 1150) {
        make_puff(l, seconds);
        l->puff_due = seconds + 0.3f;
    }
}

/* ---- chapters -------------------------------------------------------------------------------- */

enum { CHAPTERS = 5, COMPACTION = 4 };
#define CHAPTER_SECONDS 6.0f
#define PAUSE_SECONDS   2.0f

static const char *const captions[CHAPTERS] = {
    "Each part is a segment: it has a name and a transformation of its own",
    "New words go into free memory; one store leads the jump before them there",
    "Red: old words, free when the display processor has left them",
    "Smoke is made and deleted: holes of all sizes",
    "Compaction: the segments are moved together, and there is one hole",
};

/* Things stand still for a moment, so that one hole can be seen. */
static void compact(struct lesson_state *l, float seconds)
{
    segments_compact(&l->segments);
    l->pause = seconds + PAUSE_SECONDS;
    l->memory.due = seconds;
}

static void run(struct lesson_state *l, float seconds)
{
    int chapter = (int)(seconds / CHAPTER_SECONDS) % CHAPTERS;
    if (chapter != l->chapter && chapter == COMPACTION)
        compact(l, seconds);
    l->chapter = chapter;
    float step = seconds - l->before;
    l->before = seconds;
    if (seconds < l->pause) {
        for (int i = 0; i < SMOKES; i++)
            if (l->puff[i].born >= 0)
                l->puff[i].born += step;
        return;
    }
    if (!l->stopped)
        l->train += SPEED * (step < 0.2f ? step : 0.2f);
    move_train(l);
    move_smoke(l, seconds);
}

/* ---- memory ---------------------------------------------------------------------------------- */

enum { MAP_LEFT = 30, MAP_BOTTOM = 125, MAP_WIDTH = 1140, MAP_HEIGHT = 100 };
#define SNAPSHOT_SECONDS 0.5f

static void take_snapshot(struct snapshot *m, const struct segments *s, float seconds)
{
    m->count = 0;
    for (int i = 0; i < s->count; i++) {
        const struct segment *g = &s->table[i];
        if (g->at == 0)
            continue;
        m->block[m->count].name = g->name;
        m->block[m->count++].words = (struct extent){g->at, g->bytes};
    }
    m->leaving_count = s->leaving_count;
    memcpy(m->leaving, s->leaving, sizeof m->leaving);
    m->holes = s->free.holes;
    m->low = s->low;
    m->high = s->high;
    m->free = free_store_total(&s->free);
    m->due = seconds + SNAPSHOT_SECONDS;
}

static float map_x(const struct snapshot *m, uint32_t address)
{
    return MAP_LEFT + (float)(address - m->low) * MAP_WIDTH / (float)(m->high - m->low);
}

static void draw_block(struct stage *stage, const struct snapshot *m, struct extent words,
                       enum ink ink, bool leaving)
{
    float x0 = map_x(m, words.at) + 1, x1 = map_x(m, words.at + words.size) - 1;
    float y0 = MAP_BOTTOM, y1 = MAP_BOTTOM + MAP_HEIGHT;
    struct point2 p[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    stage_ink(stage, ink);
    if (!leaving) {
        stage_area(stage, p, 4);
        return;
    }
    stage_heads(stage, STAGE_RASTER);
    stage_area(stage, p, 4);
    stage_heads(stage, STAGE_VECTOR);
    stage_line_type(stage, STAGE_SHORT_DASH);
    stage_polygon(stage, p, 4);
    stage_line_type(stage, STAGE_SOLID);
    stage_heads(stage, STAGE_BOTH);
}

/* Where it has room. */
static void draw_name(struct stage *stage, const struct snapshot *m, int i)
{
    char text[8];
    int length = snprintf(text, sizeof text, "%d", m->block[i].name);
    float x0 = map_x(m, m->block[i].words.at);
    float x1 = map_x(m, m->block[i].words.at + m->block[i].words.size);
    if (x1 - x0 < (float)(length * STAGE_CHARACTER))
        return;
    stage_heads(stage, STAGE_RASTER);
    stage_ink(stage, INK_BLACK);
    stage_text_middle(stage, (x0 + x1) / 2, MAP_BOTTOM + MAP_HEIGHT / 2 - 10, text);
    stage_heads(stage, STAGE_VECTOR);
    stage_ink(stage, INK_TEXT);
    stage_text_middle(stage, (x0 + x1) / 2, MAP_BOTTOM + MAP_HEIGHT / 2 - 10, text);
    stage_heads(stage, STAGE_BOTH);
}

/* From each segment to the next one: as deep as it is far. */
static void draw_jumps(struct stage *stage, const struct snapshot *m)
{
    float from = map_x(m, m->low);
    stage_ink(stage, INK_TEXT);
    for (int i = 0; i < m->count; i++) {
        float to = map_x(m, m->block[i].words.at), depth = 10 + fabsf(to - from) * 0.09f;
        struct point2 p[] = {{from, MAP_BOTTOM - 4},
                             {from + (to - from) * 0.2f, MAP_BOTTOM - depth},
                             {from + (to - from) * 0.8f, MAP_BOTTOM - depth},
                             {to, MAP_BOTTOM - 4},
                             {to - 5, MAP_BOTTOM - 14}};
        stage_polyline(stage, p, 5);
        from = map_x(m, m->block[i].words.at + m->block[i].words.size);
    }
}

static void draw_memory(struct stage *stage, const struct snapshot *m)
{
    char text[120];
    uint32_t leaving = 0;
    stage_ink(stage, INK_GRID);
    stage_rectangle(stage, MAP_LEFT - 3, MAP_BOTTOM - 3, MAP_WIDTH + 6, MAP_HEIGHT + 6);
    for (int i = 0; i < m->leaving_count; i++) {
        draw_block(stage, m, m->leaving[i], INK_RED, true);
        leaving += m->leaving[i].size;
    }
    for (int i = 0; i < m->count; i++) {
        draw_block(stage, m, m->block[i].words, ink_of(m->block[i].name), false);
        draw_name(stage, m, i);
    }
    draw_jumps(stage, m);
    snprintf(text, sizeof text, "%u words: %u used, %u being left, %u free in %d hole%s",
             (unsigned)(m->high - m->low) / 2, (unsigned)(m->high - m->low - m->free - leaving) / 2,
             (unsigned)leaving / 2, (unsigned)m->free / 2, m->holes, m->holes == 1 ? "" : "s");
    stage_ink(stage, INK_BRIGHT);
    stage_text(stage, MAP_LEFT, MAP_BOTTOM + MAP_HEIGHT + 14, text);
}

/* ---- the lesson ------------------------------------------------------------------------------ */

static void begin(void *state)
{
    struct lesson_state *l = state;
    l->made = l->stopped = l->hidden = l->bright = false;
    l->smoking = true;
    l->before = l->puff_due = l->pause = l->memory.due = 0;
    l->train = 1017; /* in the middle when segments are moved together */
    l->chapter = l->next_puff = 0;
    for (int i = 0; i < SMOKES; i++)
        l->puff[i].born = -1;
}

static void key(void *state, int k)
{
    struct lesson_state *l = state;
    if (!l->made)
        return;
    switch (k) {
    case 'p':
        l->stopped = !l->stopped;
        break;
    case 'c':
        compact(l, l->before);
        break;
    case 'h':
        l->bright = !l->bright;
        segment_set_highlight(&l->segments, ENGINE, l->bright ? SEGMENT_BLINKING : SEGMENT_NORMAL);
        break;
    case 'v':
        l->hidden = !l->hidden;
        segment_set_visible(&l->segments, ENGINE, !l->hidden);
        break;
    case 's':
        l->smoking = !l->smoking;
        break;
    default:
        break;
    }
}

static float draw(void *state, struct stage *stage, float seconds)
{
    struct lesson_state *l = state;
    if (!l->made)
        make_all(l, stage);
    run(l, seconds);
    segments_draw(&l->segments);
    if (seconds >= l->memory.due)
        take_snapshot(&l->memory, &l->segments, seconds);
    draw_memory(stage, &l->memory);
    stage_title(stage, "A segmented display file");
    stage_caption(stage, captions[l->chapter]);
    return 0;
}

extern const struct lesson lesson_segments;
const struct lesson lesson_segments = {"segments",
                                       "A segmented display file",
                                       "p pause  c compact  h highlight  v hide  s smoke",
                                       &lesson_state,
                                       begin,
                                       key,
                                       draw};
