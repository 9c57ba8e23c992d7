/* check_segments — the segmented display file under random operations while the display processor
 * goes through it: a line a property; exit status 0 when all hold.
 */
#include <math.h>
#include <stdio.h>

#include "roms/bsp/dpu.h"
#include "roms/stage/segments.h"

enum { OPERATIONS = 2000, NAMES = 40, BYTES = 700, FIXED = 10, LINES_MOST = 64 };

struct line {
    double x0, y0, x1, y1;
};

static struct stage stage;
static struct segments store;
static uint32_t seed = 12345;
static unsigned refused, looked, in_hole, compared, wrong, overlaps, broken, lost;

static uint32_t random_below(uint32_t limit)
{
    seed = seed * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

static float random_between(float low, float high)
{
    return low + (high - low) * (float)random_below(1u << 24) / (float)(1 << 24);
}

/* ---- operations ------------------------------------------------------------------------------ */

static void create(int name)
{
    if (segment_create(&store, name) != SEGMENT_OK)
        return;
    for (int i = 1 + (int)random_below(9); i > 0; i--) {
        struct point2 p[] = {{random_between(-300, 1500), random_between(-300, 1100)},
                             {random_between(-300, 1500), random_between(-300, 1100)}};
        segment_put(&store, SEGMENT_POLYLINE, p, 2);
    }
    if (segment_close(&store) != SEGMENT_OK) {
        refused++;
        segment_delete(&store, name);
    }
}

static void transform(int name)
{
    float angle = random_between(-4, 4), scale = random_between(0.3f, 1.5f);
    float c = scale * cosf(angle), s = scale * sinf(angle);
    struct matrix3 t = {
        {{c, -s, random_between(0, 1200)}, {s, c, random_between(0, 800)}, {0, 0, 1}}};
    struct segment before = {0};
    const struct segment *g = segment_find(&store, name);
    if (g == NULL)
        return;
    before = *g;
    if (segment_set_transform(&store, name, &t) != SEGMENT_NO_ROOM)
        return;
    refused++;
    g = segment_find(&store, name);
    lost += g->bytes != before.bytes || g->transform.at[0][0] != before.transform.at[0][0];
}

static void operate(void)
{
    int name = 1 + (int)random_below(NAMES);
    switch (random_below(8)) {
    case 0:
    case 1:
        create(name);
        break;
    case 2:
        segment_delete(&store, name);
        break;
    case 3:
        segment_set_visible(&store, name, random_below(3) > 0);
        break;
    case 4:
        segment_set_highlight(&store, name, (enum segment_highlight)random_below(3));
        break;
    default:
        transform(name);
        break;
    }
}

/* ---- what must hold -------------------------------------------------------------------------- */

/* What is free is nobody's, and the display processor is not there. */
static void look_at_holes(void)
{
    uint32_t pc = dpu_pc(), taken = 0;
    for (int i = 0; i < store.free.holes; i++) {
        const struct extent *h = &store.free.hole[i];
        in_hole += pc >= h->at && pc < h->at + h->size;
        for (int k = 0; k < store.count; k++)
            overlaps += store.table[k].at != 0 && store.table[k].at < h->at + h->size &&
                        h->at < store.table[k].at + store.table[k].bytes;
    }
    looked++;
    for (int k = 0; k < store.count; k++)
        taken += store.table[k].bytes;
    for (int k = 0; k < store.leaving_count; k++)
        taken += store.leaving[k].size;
    lost += taken + free_store_total(&store.free) != store.high - store.low - FIXED;
}

/* The jumps lead through the segments that have words, in their order, to the end. */
static void follow_chain(void)
{
    volatile uint16_t *memory = dpu_memory();
    uint32_t at = memory[store.low / 2 + 1];
    for (int i = 0; i < store.count; i++) {
        const struct segment *g = &store.table[i];
        if (g->at == 0)
            continue;
        broken += g->at != at;
        at = memory[(g->at + g->bytes) / 2 - 1];
    }
    broken += at != store.low + 4 || memory[at / 2 + 2] != 0;
}

static int amount(unsigned word, unsigned sign, unsigned value)
{
    return word & sign ? -(int)value : (int)value;
}

/* The lit vectors of a segment; -1: words that it cannot have. */
static int decode(const struct segment *g, struct line *out)
{
    volatile uint16_t *memory = dpu_memory();
    int x = 0, y = 0, dx, dy, count = 0;
    unsigned mode = 0;
    for (uint32_t at = g->at / 2; at < (g->at + g->bytes) / 2 - 2; at++) {
        unsigned word = memory[at];
        if (word & DF_CONTROL) {
            mode = word >> DF_MODE_SHIFT & 15;
            continue;
        }
        if (mode == DF_MODE_POINT) {
            x = word & 01777;
            y = memory[++at] & 01777;
            continue;
        }
        if (mode == DF_MODE_SHORT) {
            dx = amount(word, DF_SIGN_X, (word & DF_SHORT_DX) >> DF_SHORT_DX_SHIFT);
            dy = amount(word, DF_SHORT_SIGN_Y, word & DF_SHORT_DY);
        } else if (mode == DF_MODE_LONG) {
            dx = amount(word, DF_SIGN_X, word & DF_LONG_DELTA);
            unsigned second = memory[++at];
            dy = amount(second, DF_SIGN_X, second & DF_LONG_DELTA);
        } else {
            return -1;
        }
        if (count == LINES_MOST)
            return -1;
        out[count++] = (struct line){x, y, x + dx, y + dy};
        x += dx;
        y += dy;
    }
    return count;
}

/* Takes off what is beyond an edge: a·x + b·y + c >= 0 stays. */
static bool cut(struct line *l, double a, double b, double c)
{
    double d0 = a * l->x0 + b * l->y0 + c, d1 = a * l->x1 + b * l->y1 + c;
    if (d0 < 0 && d1 < 0)
        return false;
    if (d0 >= 0 && d1 >= 0)
        return true;
    double t = d0 / (d0 - d1), x = l->x0 + t * (l->x1 - l->x0), y = l->y0 + t * (l->y1 - l->y0);
    if (d0 < 0) {
        l->x0 = x;
        l->y0 = y;
    } else {
        l->x1 = x;
        l->y1 = y;
    }
    return true;
}

/* In double precision, in head units; false: not in the picture. */
static bool expected(const struct segment *g, const struct point2 *p, struct line *l)
{
    const float(*m)[3] = g->transform.at;
    const double unit = 1024.0 / STAGE_WIDTH, low = (1024 - STAGE_HEIGHT * unit) / 2;
    *l = (struct line){(double)m[0][0] * p[0].x + (double)m[0][1] * p[0].y + m[0][2],
                       (double)m[1][0] * p[0].x + (double)m[1][1] * p[0].y + m[1][2],
                       (double)m[0][0] * p[1].x + (double)m[0][1] * p[1].y + m[0][2],
                       (double)m[1][0] * p[1].x + (double)m[1][1] * p[1].y + m[1][2]};
    if (!cut(l, 1, 0, 0) || !cut(l, -1, 0, STAGE_WIDTH) || !cut(l, 0, 1, 0) ||
        !cut(l, 0, -1, STAGE_HEIGHT))
        return false;
    *l = (struct line){l->x0 * unit, l->y0 * unit + low, l->x1 * unit, l->y1 * unit + low};
    return true;
}

static bool same(const struct line *a, const struct line *b)
{
    return fabs(a->x0 - b->x0) < 1.01 && fabs(a->y0 - b->y0) < 1.01 && fabs(a->x1 - b->x1) < 1.01 &&
           fabs(a->y1 - b->y1) < 1.01;
}

static void compare_words(const struct segment *g)
{
    struct line drawn[LINES_MOST], want;
    int count = decode(g, drawn), k = 0;
    if (count < 0) {
        wrong++;
        return;
    }
    for (int r = g->first; r >= 0; r = store.record[r].next) {
        if (!expected(g, store.record[r].at, &want))
            continue;
        double length = fabs(want.x1 - want.x0) + fabs(want.y1 - want.y0);
        bool is = k < count && same(&drawn[k], &want);
        wrong += length > 4 && !is;
        compared++;
        k += is;
    }
    wrong += count > k + 2;
}

static bool holds(const char *what, bool is)
{
    printf("%s: %s\n", what, is ? "holds" : "DOES NOT HOLD");
    return is;
}

int main(void)
{
    char text[100];
    bool all = true;
    stage_open(&stage);
    segments_begin(&store, &stage, BYTES);
    stage_begin(&stage);
    segments_draw(&store);
    stage_end(&stage);
    for (int i = 0; i < OPERATIONS; i++) {
        operate();
        segments_release(&store); /* at once, where the display processor may still be */
        look_at_holes();
        follow_chain();
        if (i % 8 == 0 && store.count > 0) {
            const struct segment *g = &store.table[random_below((uint32_t)store.count)];
            if (g->at != 0)
                compare_words(g);
        }
        if (i % 50 == 0)
            segments_redraw(&store);
    }
    snprintf(text, sizeof text, "%d operations: no overlap, no word lost", OPERATIONS);
    all &= holds(text, overlaps == 0 && lost == 0);
    all &= holds("some found no room, and changed nothing", refused > 20 && lost == 0);
    snprintf(text, sizeof text, "%u looks: the display processor is in no hole", looked);
    all &= holds(text, in_hole == 0);
    all &= holds("the jumps lead through the visible segments in their order", broken == 0);
    all &= holds("the words are the lines that were put in, transformed and clipped",
                 wrong == 0 && compared > 200);
    while (store.count > 0)
        if (segment_delete(&store, store.table[0].name) != SEGMENT_OK)
            break;
    segments_compact(&store); /* waits until all is left */
    all &= holds("all deleted: one hole, all of the memory",
                 store.free.holes == 1 && store.free.hole[0].size == BYTES - FIXED);
    return all ? 0 : 1;
}
