/* segment_records.c — the primitives of segments, in records that are linked. */
#include <stdio.h>

#include "roms/stage/segment_parts.h"

void segment_records_begin(struct segments *s)
{
    for (int i = 0; i < SEGMENT_RECORDS; i++)
        s->record[i].next = i + 1 < SEGMENT_RECORDS ? i + 1 : -1;
    s->free_record = 0;
}

static bool has_records(const struct segments *s, int needed)
{
    for (int i = s->free_record; i >= 0 && needed > 0; i = s->record[i].next)
        needed--;
    return needed <= 0;
}

static void append(struct segments *s, struct segment *g, const struct segment_record *record)
{
    int i = s->free_record;
    s->free_record = s->record[i].next;
    s->record[i] = *record;
    s->record[i].next = -1;
    if (g->first < 0)
        g->first = i;
    else
        s->record[g->last].next = i;
    g->last = i;
}

enum segment_status segment_records_add(struct segments *s, struct segment *g,
                                        const struct segment_record *like,
                                        const struct point2 *points, int count)
{
    if (count > SEGMENT_POINTS)
        return SEGMENT_TOO_LONG;
    if (!has_records(s, (count + SEGMENT_RECORD_POINTS - 1) / SEGMENT_RECORD_POINTS))
        return SEGMENT_RECORDS_FULL;
    while (count > 0) {
        struct segment_record r = *like;
        r.count = count < SEGMENT_RECORD_POINTS ? count : SEGMENT_RECORD_POINTS;
        for (int i = 0; i < r.count; i++)
            r.at[i] = points[i];
        points += r.count;
        count -= r.count;
        r.more = count > 0;
        append(s, g, &r);
    }
    return SEGMENT_OK;
}

void segment_records_free(struct segments *s, struct segment *g)
{
    if (g->first < 0)
        return;
    s->record[g->last].next = s->free_record;
    s->free_record = g->first;
    g->first = g->last = -1;
}

bool segment_primitive_next(const struct segments *s, const struct segment *g, int *record,
                            struct segment_primitive *p)
{
    if (*record < 0)
        return false;
    p->record = &s->record[*record];
    p->count = 0;
    for (bool more = true; more && *record >= 0;) {
        const struct segment_record *r = &s->record[*record];
        for (int i = 0; i < r->count && p->count < SEGMENT_POINTS; i++)
            p->at[p->count++] = matrix3_apply(&g->transform, r->at[i]);
        more = r->more;
        *record = r->next;
    }
    return true;
}

static void draw(struct stage *stage, const struct segment_primitive *p)
{
    switch (p->record->kind) {
    case SEGMENT_POLYLINE:
        stage_polyline(stage, p->at, p->count);
        break;
    case SEGMENT_POLYGON:
        stage_polygon(stage, p->at, p->count);
        break;
    case SEGMENT_AREA:
        stage_area(stage, p->at, p->count);
        break;
    case SEGMENT_MARKER:
        for (int i = 0; i < p->count; i++)
            stage_marker(stage, p->at[i].x, p->at[i].y);
        break;
    case SEGMENT_DOT:
        for (int i = 0; i < p->count; i++)
            stage_dot(stage, p->at[i].x, p->at[i].y);
        break;
    case SEGMENT_STRING:
        stage_text(stage, p->at[0].x, p->at[0].y, p->record->text);
        break;
    }
}

/* A bright area would hide what is drawn on it: its outline is bright. */
static void draw_highlighted(struct stage *stage, struct segment_primitive *p)
{
    unsigned heads = stage->heads;
    stage_heads(stage, heads & STAGE_RASTER);
    stage_ink(stage, p->record->ink);
    draw(stage, p);
    stage_heads(stage, heads);
    stage_ink(stage, INK_BRIGHT);
    if (p->record->kind == SEGMENT_AREA)
        stage_polygon(stage, p->at, p->count);
    else
        draw(stage, p);
}

void segment_replay(const struct segments *s, const struct segment *g, struct stage *stage)
{
    struct segment_primitive p;
    for (int record = g->first; segment_primitive_next(s, g, &record, &p);) {
        stage_line_type(stage, p.record->type);
        stage_ink(stage, p.record->ink);
        if (g->highlight == SEGMENT_NORMAL)
            draw(stage, &p);
        else
            draw_highlighted(stage, &p);
    }
}
