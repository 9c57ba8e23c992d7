/* segment_words.c — the words of segments in display memory: written, chained by jumps, and
 * freed. */
#include "roms/bsp/dpu.h"
#include "roms/stage/segment_parts.h"

/* The area begins with the root, a jump to the first segment, and the end, which undoes what
 * segments have set and jumps back. */
enum { ROOT_BYTES = 4, END_BYTES = 6, FIXED_BYTES = ROOT_BYTES + END_BYTES, LONGEST_WAIT = 100000 };

/* All that a mode word can set, so that a segment does not depend on the one before it. */
#define SET_ALL (DF_SGM_INTENSITY | DF_SGM_PEN | DF_SGM_BLINK | DF_SGM_LINE)

static uint32_t end_of(const struct segments *s)
{
    return s->low + ROOT_BYTES;
}

static void lead(uint32_t jump_end, uint32_t to)
{
    dpu_memory()[(jump_end - 2) / 2] = (uint16_t)to;
}

/* ---- the chain ------------------------------------------------------------------------------- */

/* The end of the jump before the i-th segment's place. */
static uint32_t jump_before(const struct segments *s, int i)
{
    while (--i >= 0)
        if (s->table[i].at != 0)
            return s->table[i].at + s->table[i].bytes;
    return s->low + ROOT_BYTES;
}

/* Where the jump of the i-th segment leads. */
static uint32_t next_of(const struct segments *s, int i)
{
    while (++i < s->count)
        if (s->table[i].at != 0)
            return s->table[i].at;
    return end_of(s);
}

/* ---- memory that is left --------------------------------------------------------------------- */

/* What is above the store's memory was another's: it is waited for, but is not free. */
static void give(struct segments *s, struct extent left)
{
    uint32_t end = left.at + left.size;
    free_store_give(&s->free, left.at, (end < s->high ? end : s->high) - left.at);
}

/* No jump of the chain leads into these any more, but they may lead into each other: they are free
 * together, at a moment when the display processor is in none of them. */
void segments_release(struct segments *s)
{
    uint32_t pc = dpu_pc();
    for (int i = 0; i < s->leaving_count; i++)
        if (pc >= s->leaving[i].at && pc < s->leaving[i].at + s->leaving[i].size)
            return;
    for (int i = 0; i < s->leaving_count; i++)
        give(s, s->leaving[i]);
    s->leaving_count = 0;
}

/* A refresh at most; for ever if somebody has stopped the display processor there: then not. */
void segments_settle(struct segments *s)
{
    for (int i = 0; i < LONGEST_WAIT && s->leaving_count > 0; i++)
        segments_release(s);
}

/* Words of the i-th segment may be left. */
static bool may_leave(struct segments *s)
{
    segments_release(s);
    if (s->leaving_count == SEGMENTS_LEAVING)
        segments_settle(s);
    return s->leaving_count < SEGMENTS_LEAVING;
}

static void leave(struct segments *s, const struct segment *g)
{
    if (g->at != 0)
        s->leaving[s->leaving_count++] = (struct extent){g->at, g->bytes};
}

/* ---- words ----------------------------------------------------------------------------------- */

/* What a segment begins with. */
static uint16_t setting(const struct segment *g)
{
    unsigned word = DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT | SET_ALL;
    word |= ink_intensity(INK_TEXT) << DF_SGM_INTENSITY_SHIFT;
    word |= g->detectable ? DF_SGM_PEN_ON : 0;
    word |= g->highlight == SEGMENT_BLINKING ? DF_SGM_BLINK_ON : 0;
    return (uint16_t)word;
}

/* Into a hole; false: it is too small. The jump leads to `next`. */
static bool write(struct segments *s, const struct extent *hole, uint32_t next, struct segment *g)
{
    struct stage view = *s->stage;
    struct display *d = &view.display;
    display_begin(d, hole->at, hole->at + hole->size);
    display_word(d, setting(g));
    d->mode = DF_MODE_POINT;
    d->x = d->y = -1;
    view.heads = STAGE_VECTOR;
    view.intensity = (int)ink_intensity(INK_TEXT);
    view.type = STAGE_SOLID;
    view.hatch_apart = 0;
    segment_replay(s, g, &view);
    if (d->full)
        return false;
    display_jump(d, next);
    g->at = hole->at;
    g->bytes = d->at - hole->at;
    return true;
}

/* First fit. */
static bool place(struct segments *s, int i, struct segment *g)
{
    for (int k = 0; k < s->free.holes; k++)
        if (write(s, &s->free.hole[k], next_of(s, i), g))
            return free_store_take(&s->free, g->at, g->bytes);
    return false;
}

static bool place_somehow(struct segments *s, int i, struct segment *g)
{
    if (place(s, i, g))
        return true;
    segments_settle(s);
    if (place(s, i, g))
        return true;
    if (s->free.holes < 2)
        return false;
    segments_compact(s);
    return place(s, i, g);
}

enum segment_status segment_words_replace(struct segments *s, int i, struct segment *changed)
{
    if (!changed->visible) {
        enum segment_status status = segment_words_remove(s, i);
        changed->at = changed->bytes = 0;
        return status;
    }
    struct segment g = *changed;
    if (!may_leave(s) || !place_somehow(s, i, &g))
        return SEGMENT_NO_ROOM;
    if (s->leaving_count == SEGMENTS_LEAVING) {
        free_store_give(&s->free, g.at, g.bytes);
        return SEGMENT_NO_ROOM;
    }
    leave(s, &s->table[i]); /* where it is now: it may have been moved */
    lead(jump_before(s, i), g.at);
    *changed = g;
    return SEGMENT_OK;
}

enum segment_status segment_words_remove(struct segments *s, int i)
{
    if (s->table[i].at == 0)
        return SEGMENT_OK;
    if (!may_leave(s))
        return SEGMENT_NO_ROOM;
    lead(jump_before(s, i), next_of(s, i));
    leave(s, &s->table[i]);
    s->table[i].at = s->table[i].bytes = 0;
    return SEGMENT_OK;
}

/* ---- moving together ------------------------------------------------------------------------- */

static void move(struct segments *s, int i, uint32_t to)
{
    volatile uint16_t *memory = dpu_memory();
    struct segment *g = &s->table[i];
    if (!may_leave(s) || !free_store_take(&s->free, to, g->bytes))
        return;
    for (uint32_t k = 0; k < g->bytes; k += 2)
        memory[(to + k) / 2] = memory[(g->at + k) / 2];
    leave(s, g);
    lead(jump_before(s, i), to);
    g->at = to;
    segments_settle(s);
}

static int segment_above(const struct segments *s, const struct extent *hole)
{
    for (int i = 0; i < s->count; i++)
        if (s->table[i].at == hole->at + hole->size)
            return i;
    return -1;
}

/* The segment above the lowest hole goes down into it; one that is too large goes out of the way
 * first, which makes the hole larger than it: so this ends. */
void segments_compact(struct segments *s)
{
    segments_settle(s);
    for (int rounds = 0; rounds < 4 * SEGMENTS_MOST && s->free.holes > 0; rounds++) {
        struct extent hole = s->free.hole[0];
        int i = segment_above(s, &hole), k = s->free.holes - 1;
        if (i < 0 || s->leaving_count > 0)
            return;
        uint32_t bytes = s->table[i].bytes;
        if (bytes <= hole.size) {
            move(s, i, hole.at);
            continue;
        }
        while (k > 0 && s->free.hole[k].size < bytes)
            k--;
        if (k == 0)
            return;
        move(s, i, s->free.hole[k].at);
    }
}

/* ---- taking display memory ------------------------------------------------------------------- */

/* The last picture may still lead here: to the end, which is always the same words at the same
 * place. The display processor may be in any segment of the store that had the memory before, and
 * that one's jumps lead on through all of them. */
static void clear(struct segments *s)
{
    volatile uint16_t *end = dpu_memory() + end_of(s) / 2, *root = dpu_memory() + s->low / 2;
    const uint16_t undo =
        DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT | DF_SGM_PEN | DF_SGM_BLINK | DF_SGM_LINE;
    end[0] = undo;
    end[1] = DF_JUMP;
    end[2] = 0;
    root[1] = (uint16_t)end_of(s);
    root[0] = DF_JUMP;
    s->free.holes = 0;
    s->leaving[0] = (struct extent){s->low + FIXED_BYTES, STAGE_FREE_HIGH - s->low - FIXED_BYTES};
    s->leaving_count = 1;
}

void segment_words_take(struct segments *s)
{
    if (s->stage->tenant == s)
        return;
    s->stage->tenant = s;
    clear(s);
    segments_settle(s);
    for (int i = 0; i < s->count; i++)
        s->table[i].at = s->table[i].bytes = 0;
    for (int i = 0; i < s->count; i++) {
        struct segment g = s->table[i];
        if (g.visible && segment_words_replace(s, i, &g) == SEGMENT_OK)
            s->table[i] = g;
    }
}
