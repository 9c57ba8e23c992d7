/* view_figures.c — figures as polylines of a segment: lines that follow each other are one. */
#include "roms/clip/liang_barsky.h"
#include "roms/geometry/scalar.h"
#include "roms/sketch/view_parts.h"

enum { MARK_LENGTH = 14, MARK_OFF = 9, MARK_APART = 4 };
/* For what is no figure: grid, menu, rubber band, status. */
enum { SPARE_BYTES = 3000, SPARE_RECORDS = 200 };

static const struct clip_window area = {0, AREA_BOTTOM, AREA_RIGHT, AREA_TOP};

struct pen {
    struct segments *segments;
    const struct tools *tools;
    struct point2 at[SEGMENT_POINTS];
    int count;
    enum ink ink;
    float units;    /* head units a stage unit */
    uint32_t bytes; /* of display memory, that there is room for */
    int records;
    bool full; /* something was left out */
};

/* Short vectors take one word, long ones two; a place and two mode words before them. */
static uint32_t bytes_of(const struct pen *pen)
{
    uint32_t bytes = 8;
    for (int i = 1; i < pen->count; i++) {
        float x = fabsf(pen->at[i].x - pen->at[i - 1].x),
              y = fabsf(pen->at[i].y - pen->at[i - 1].y);
        bytes += scalar_max(x, y) * pen->units < 63 ? 2 : 4;
    }
    return bytes;
}

static void flush(struct pen *pen)
{
    uint32_t bytes = bytes_of(pen);
    int records = (pen->count + SEGMENT_RECORD_POINTS - 1) / SEGMENT_RECORD_POINTS;
    pen->segments->ink = pen->ink;
    pen->full |= pen->count > 1 && (bytes > pen->bytes || records > pen->records);
    if (pen->count > 1 && !pen->full) {
        segment_put(pen->segments, SEGMENT_POLYLINE, pen->at, pen->count);
        pen->bytes -= bytes;
        pen->records -= records;
    }
    pen->count = 0;
}

static bool is_at(struct point2 a, struct point2 b)
{
    return a.x == b.x && a.y == b.y;
}

static bool is_sane(struct point2 p)
{
    return fabsf(p.x) < 1e5f && fabsf(p.y) < 1e5f;
}

static void line(struct pen *pen, struct point2 a, struct point2 b)
{
    if (!is_sane(a) || !is_sane(b) || !clip_liang_barsky(&area, &a, &b))
        return;
    if (pen->count > 0 && is_at(b, pen->at[pen->count - 1])) {
        struct point2 end = a;
        a = b;
        b = end;
    }
    if (pen->count == 0 || pen->count == SEGMENT_POINTS || !is_at(a, pen->at[pen->count - 1])) {
        flush(pen);
        pen->at[pen->count++] = a;
    }
    pen->at[pen->count++] = b;
}

/* Chords at most a quarter of a unit off. */
static void arc(struct pen *pen, const struct stroke *stroke, float begin, float sweep)
{
    float radius = stroke_radius(stroke);
    if (!(radius < 1e5f) || radius == 0)
        return;
    int pieces = 3 + (int)(sweep / TURN * scalar_clamp(1.5f * PI * sqrtf(radius), 12, 120));
    float c = cosf(sweep / (float)pieces), s = sinf(sweep / (float)pieces);
    float x = radius * cosf(begin), y = radius * sinf(begin);
    struct point2 middle = stroke->at[0], a = {middle.x + x, middle.y + y};
    for (int i = 0; i < pieces; i++) {
        float turned = x * c - y * s;
        y = x * s + y * c;
        x = turned;
        struct point2 b = {middle.x + x, middle.y + y};
        line(pen, a, b);
        a = b;
    }
}

/* Two short lines beside the middle, as the line lies. */
static void mark(struct pen *pen, const struct stroke *stroke, unsigned constraint)
{
    struct point2 m = {(stroke->at[0].x + stroke->at[1].x) / 2,
                       (stroke->at[0].y + stroke->at[1].y) / 2};
    flush(pen);
    enum ink ink = pen->ink;
    pen->ink = INK_BLUE;
    for (int i = 0; i < 2; i++) {
        float off = MARK_OFF + (float)(i * MARK_APART), half = MARK_LENGTH / 2.0f;
        if (constraint == CONSTRAINT_HORIZONTAL)
            line(pen, (struct point2){m.x - half, m.y - off},
                 (struct point2){m.x + half, m.y - off});
        else
            line(pen, (struct point2){m.x + off, m.y - half},
                 (struct point2){m.x + off, m.y + half});
        flush(pen);
    }
    pen->ink = ink;
}

static void take(void *ctx, const struct stroke *stroke)
{
    struct pen *pen = ctx;
    float begin, sweep;
    if (pen->full)
        return;
    unsigned constraint = pen->tools->drawing.now.figure[stroke->figure].constraint;
    switch (stroke->kind) {
    case FIGURE_LINE:
        line(pen, stroke->at[0], stroke->at[1]);
        if (!stroke->inner && constraint != CONSTRAINT_NONE)
            mark(pen, stroke, constraint);
        break;
    case FIGURE_CIRCLE:
        stroke_arc(stroke, &begin, &sweep);
        arc(pen, stroke, begin, TURN);
        break;
    case FIGURE_ARC:
        stroke_arc(stroke, &begin, &sweep);
        arc(pen, stroke, begin, sweep);
        break;
    default:
        break;
    }
}

static enum ink ink_of(const struct view *view, const struct figure *f, int i)
{
    if (view->moving[i])
        return INK_YELLOW;
    if (view->hot == i)
        return INK_ORANGE;
    if (view->selected[i])
        return INK_BRIGHT;
    return f->kind == FIGURE_COPY ? INK_CYAN : INK_GREEN;
}

static bool is_shown(const struct tools *tools, int i)
{
    const struct figure *f = &tools->drawing.now.figure[i];
    return f->kind != FIGURE_NONE && f->picture == tools->picture;
}

static bool is_empty(const struct tools *tools, int group)
{
    for (int i = group * VIEW_GROUP; i < (group + 1) * VIEW_GROUP; i++)
        if (is_shown(tools, i))
            return false;
    return true;
}

/* ---- groups ---------------------------------------------------------------------------------- */

/* What figures may take of display memory; words that are just being left count as free. */
static uint32_t budget(const struct segments *s)
{
    uint32_t free = free_store_total(&s->free);
    for (int i = 0; i < s->leaving_count; i++)
        free += s->leaving[i].size;
    return free > SPARE_BYTES ? free - SPARE_BYTES : 0;
}

static int free_records(const struct segments *s)
{
    int count = 0;
    for (int i = s->free_record; i >= 0; i = s->record[i].next)
        count++;
    return count > SPARE_RECORDS ? count - SPARE_RECORDS : 0;
}

/* Into a segment that is open then; false: not all of it, for want of room. */
static bool build(struct view *view, const struct tools *tools, int group)
{
    static struct pen pen;
    const struct drawing_state *s = &tools->drawing.now;
    pen = (struct pen){.segments = &view->segments,
                       .tools = tools,
                       .units = view->stage.units,
                       .bytes = budget(&view->segments),
                       .records = free_records(&view->segments)};
    view_renew(view);
    for (int i = group * VIEW_GROUP; i < (group + 1) * VIEW_GROUP; i++) {
        const struct figure *f = &s->figure[i];
        if (!is_shown(tools, i))
            continue;
        if (ink_of(view, f, i) != pen.ink)
            flush(&pen);
        pen.ink = ink_of(view, f, i);
        expand_figure(s, i, take, &pen);
    }
    flush(&pen);
    return !pen.full;
}

void view_group(struct view *view, const struct tools *tools, int group)
{
    int name = NAME_GROUP + group;
    view->stale[group] = view->lacking[group] = false;
    if (is_empty(tools, group)) {
        segment_delete(&view->segments, name);
        return;
    }
    bool built = build(view, tools, group);
    if (!built) { /* without the old one there may be room */
        segment_delete(&view->segments, NAME_NEW);
        segment_delete(&view->segments, name);
        built = build(view, tools, group);
    }
    view->lacking[group] = !view_renewed(view, name) || !built;
}
