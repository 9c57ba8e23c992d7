/* segments.c — the table of segments: names and attributes. */
#include "roms/stage/segments.h"

#include <stdio.h>
#include <string.h>

#include "roms/stage/segment_parts.h"

void segments_begin(struct segments *s, struct stage *stage, uint32_t bytes)
{
    bytes = bytes < SEGMENTS_BYTES_LEAST  ? SEGMENTS_BYTES_LEAST
            : bytes > SEGMENTS_BYTES_MOST ? SEGMENTS_BYTES_MOST
                                          : bytes & ~1u;
    s->stage = stage;
    s->low = STAGE_FREE_LOW;
    s->high = STAGE_FREE_LOW + bytes;
    s->count = 0;
    s->open = -1;
    s->ink = INK_TEXT;
    s->type = STAGE_SOLID;
    s->pick = 0;
    s->pictures = 0;
    segment_records_begin(s);
    stage->tenant = NULL;
    segment_words_take(s);
}

const char *segment_sentence(enum segment_status status)
{
    static const char *const sentences[] = {
        [SEGMENT_OK] = "done",
        [SEGMENT_ONE_IS_OPEN] = "a segment is open; close it first",
        [SEGMENT_NONE_IS_OPEN] = "no segment is open; create one first",
        [SEGMENT_EXISTS] = "a segment of that name exists already",
        [SEGMENT_UNKNOWN] = "there is no segment of that name",
        [SEGMENT_TABLE_FULL] = "there are 64 segments already",
        [SEGMENT_RECORDS_FULL] = "the segments have as many primitives as can be kept",
        [SEGMENT_TOO_LONG] = "a primitive has at most 128 points, a text 40 characters",
        [SEGMENT_NO_ROOM] = "display memory has no room for its words",
    };
    return sentences[status];
}

static int index_of(const struct segments *s, int name)
{
    for (int i = 0; i < s->count; i++)
        if (s->table[i].name == name)
            return i;
    return -1;
}

const struct segment *segment_find(const struct segments *s, int name)
{
    int i = index_of(s, name);
    return i < 0 ? NULL : &s->table[i];
}

/* ---- making and deleting --------------------------------------------------------------------- */

enum segment_status segment_create(struct segments *s, int name)
{
    if (s->open >= 0)
        return SEGMENT_ONE_IS_OPEN;
    if (index_of(s, name) >= 0)
        return SEGMENT_EXISTS;
    if (s->count == SEGMENTS_MOST)
        return SEGMENT_TABLE_FULL;
    s->open = s->count++;
    s->table[s->open] = (struct segment){
        .name = name, .visible = true, .transform = matrix3_identity(), .first = -1, .last = -1};
    return SEGMENT_OK;
}

/* `changed` takes the i-th one's place, with words of its own. */
static enum segment_status change(struct segments *s, int i, struct segment changed)
{
    segment_words_take(s);
    enum segment_status status = segment_words_replace(s, i, &changed);
    if (status != SEGMENT_OK)
        return status;
    changed.box = segment_raster_box(s, &changed);
    segment_raster_damage(s, s->table[i].box);
    segment_raster_damage(s, changed.box);
    s->table[i] = changed;
    return SEGMENT_OK;
}

enum segment_status segment_show(struct segments *s)
{
    return s->open < 0 ? SEGMENT_NONE_IS_OPEN : change(s, s->open, s->table[s->open]);
}

enum segment_status segment_close(struct segments *s)
{
    enum segment_status status = segment_show(s);
    if (status == SEGMENT_OK)
        s->open = -1;
    return status;
}

enum segment_status segment_delete(struct segments *s, int name)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    segment_words_take(s);
    enum segment_status status = segment_words_remove(s, i);
    if (status != SEGMENT_OK)
        return status;
    segment_raster_damage(s, s->table[i].box);
    segment_records_free(s, &s->table[i]);
    s->open = s->open == i ? -1 : s->open > i ? s->open - 1 : s->open;
    s->count--;
    memmove(&s->table[i], &s->table[i + 1], (size_t)(s->count - i) * sizeof s->table[0]);
    return SEGMENT_OK;
}

enum segment_status segment_rename(struct segments *s, int name, int to)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    if (index_of(s, to) >= 0)
        return SEGMENT_EXISTS;
    s->table[i].name = to;
    return SEGMENT_OK;
}

/* ---- primitives ------------------------------------------------------------------------------ */

static struct segment_record attributes(const struct segments *s, enum segment_kind kind)
{
    return (struct segment_record){.kind = kind, .ink = s->ink, .type = s->type, .pick = s->pick};
}

enum segment_status segment_put(struct segments *s, enum segment_kind kind,
                                const struct point2 *points, int count)
{
    struct segment_record like = attributes(s, kind);
    if (s->open < 0)
        return SEGMENT_NONE_IS_OPEN;
    return segment_records_add(s, &s->table[s->open], &like, points, count);
}

enum segment_status segment_put_text(struct segments *s, struct point2 at, const char *text)
{
    struct segment_record like = attributes(s, SEGMENT_STRING);
    if (s->open < 0)
        return SEGMENT_NONE_IS_OPEN;
    if (strlen(text) > SEGMENT_TEXT)
        return SEGMENT_TOO_LONG;
    snprintf(like.text, sizeof like.text, "%s", text);
    return segment_records_add(s, &s->table[s->open], &like, &at, 1);
}

/* ---- attributes ------------------------------------------------------------------------------ */

enum segment_status segment_set_visible(struct segments *s, int name, bool visible)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    struct segment g = s->table[i];
    g.visible = visible;
    return change(s, i, g);
}

enum segment_status segment_set_detectable(struct segments *s, int name, bool detectable)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    struct segment g = s->table[i];
    g.detectable = detectable;
    return change(s, i, g);
}

enum segment_status segment_set_highlight(struct segments *s, int name,
                                          enum segment_highlight highlight)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    struct segment g = s->table[i];
    g.highlight = highlight;
    return change(s, i, g);
}

enum segment_status segment_set_transform(struct segments *s, int name,
                                          const struct matrix3 *transform)
{
    int i = index_of(s, name);
    if (i < 0)
        return SEGMENT_UNKNOWN;
    struct segment g = s->table[i];
    g.transform = *transform;
    return change(s, i, g);
}
