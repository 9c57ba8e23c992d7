/* pick_find.c — whose words, whose primitive: correlation of the program counter and of places. */
#include <math.h>
#include <string.h>

#include "roms/bsp/dpu.h"
#include "roms/geometry/scalar.h"
#include "roms/interact/pick.h"
#include "roms/stage/segment_parts.h"

/* ---- words --------------------------------------------------------------------------------------- */

uint16_t pick_name_word(int name)
{
    return (uint16_t)(DF_NOP | (unsigned)(name & PICK_NAME_MOST));
}

int pick_name_before(uint32_t pc, uint32_t words)
{
    volatile const uint16_t *memory = dpu_memory();
    for (uint32_t i = 1; i <= words && 2 * i <= pc; i++) {
        unsigned word = memory[pc / 2 - i];
        if ((word & 0174000) == DF_NOP)
            return (int)(word & PICK_NAME_MOST);
    }
    return 0;
}

/* A handler may look while the program is changing the table: what is found must look like a segment. */
static bool is_whole(const struct segment *g)
{
    volatile const uint16_t *memory = dpu_memory();
    unsigned first = memory[g->at / 2], jump = memory[(g->at + g->bytes) / 2 - 2];
    return (first & DF_CONTROL) && first < DF_JUMP && jump == DF_JUMP;
}

int pick_segment_at(const struct segments *segments, uint32_t pc)
{
    for (int i = 0; i < segments->count; i++) {
        const struct segment *g = &segments->table[i];
        if (g->at != 0 && pc > g->at && pc < g->at + g->bytes)
            return g->visible && g->detectable && is_whole(g) ? g->name : 0;
    }
    return 0;
}

/* ---- places --------------------------------------------------------------------------------------- */

static float distance_to_line(struct point2 p, struct point2 a, struct point2 b)
{
    float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    float t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
    t = scalar_clamp(t, 0, 1);
    return hypotf(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

static float distance_to_text(struct point2 p, const struct segment_primitive *q)
{
    float length = (float)(strlen(q->record->text) * STAGE_CHARACTER);
    struct point2 near = {scalar_clamp(p.x, q->at[0].x, q->at[0].x + length),
                          scalar_clamp(p.y, q->at[0].y, q->at[0].y + STAGE_CHARACTER)};
    return hypotf(p.x - near.x, p.y - near.y);
}

/* Of what the vector head draws: areas are outlines. */
static float distance(struct point2 p, const struct segment_primitive *q)
{
    enum segment_kind kind = q->record->kind;
    bool dots = kind == SEGMENT_MARKER || kind == SEGMENT_DOT;
    bool round = kind == SEGMENT_POLYGON || kind == SEGMENT_AREA;
    float nearest = INFINITY;
    if (kind == SEGMENT_STRING)
        return distance_to_text(p, q);
    for (int i = 0; i < q->count; i++) {
        struct point2 to = i + 1 < q->count ? q->at[i + 1] : round ? q->at[0] : q->at[i];
        nearest = scalar_min(nearest, distance_to_line(p, q->at[i], dots ? q->at[i] : to));
    }
    return nearest;
}

int pick_part_at(const struct segments *segments, const struct segment *segment, struct point2 at)
{
    struct segment_primitive p;
    float nearest = INFINITY;
    int part = 0;
    for (int record = segment->first; segment_primitive_next(segments, segment, &record, &p);) {
        float d = distance(at, &p);
        if (d <= nearest) {
            nearest = d;
            part = p.record->pick;
        }
    }
    return part;
}

bool pick_box_of(const struct segments *segments, const struct segment *segment, struct point2 *low,
                 struct point2 *high)
{
    struct segment_primitive p;
    *low = (struct point2){INFINITY, INFINITY};
    *high = (struct point2){-INFINITY, -INFINITY};
    for (int record = segment->first; segment_primitive_next(segments, segment, &record, &p);)
        for (int i = 0; i < p.count; i++) {
            *low = (struct point2){scalar_min(low->x, p.at[i].x), scalar_min(low->y, p.at[i].y)};
            *high = (struct point2){scalar_max(high->x, p.at[i].x), scalar_max(high->y, p.at[i].y)};
        }
    return low->x <= high->x;
}

/* ---- light buttons --------------------------------------------------------------------------------- */

enum { HIGH = 40, BASE = 12, MARGIN = 16 };

void pick_buttons_begin(struct pick *pick)
{
    pick->buttons = 0;
}

static void enable_pen(struct stage *stage, unsigned on)
{
    struct display *d = &stage->display;
    display_word(d, (uint16_t)(DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT | DF_SGM_PEN | on));
    d->mode = DF_MODE_POINT;
    d->x = d->y = -1; /* nothing goes on from here */
}

void pick_button(struct pick *pick, int name, float x, float y, const char *text)
{
    struct stage *stage = pick->segments->stage;
    float half = (float)(strlen(text) * STAGE_CHARACTER) / 2 + MARGIN;
    if (pick->buttons == PICK_BUTTONS)
        return;
    pick->button[pick->buttons++] = (struct pick_button){name, {x - half, y}, {x + half, y + HIGH}};
    display_word(&stage->display, pick_name_word(name));
    enable_pen(stage, DF_SGM_PEN_ON);
    stage_rectangle(stage, x - half, y, 2 * half, HIGH);
    stage_text_middle(stage, x, y + BASE, text);
    enable_pen(stage, 0);
}
