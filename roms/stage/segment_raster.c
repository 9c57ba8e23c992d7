/* segment_raster.c — segments on the raster head: where they are, what is to be drawn anew; and
 * what is at a place, for picking. */
#include <math.h>
#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/stage/device.h"
#include "roms/stage/segment_parts.h"

/* Beyond its points a segment reaches by a marker's arm, or the height of a line of text. */
enum { REACH = 10, TEXT_REACH = 2 * STAGE_TEXT_LINE };

/* ---- boxes ----------------------------------------------------------------------------------- */

static bool is_empty(struct segment_box b)
{
    return b.x0 >= b.x1 || b.y0 >= b.y1;
}

static bool touch(struct segment_box a, struct segment_box b)
{
    return !is_empty(a) && !is_empty(b) && a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

static struct segment_box join(struct segment_box a, struct segment_box b)
{
    if (is_empty(a) || is_empty(b))
        return is_empty(a) ? b : a;
    return (struct segment_box){scalar_min_int(a.x0, b.x0), scalar_min_int(a.y0, b.y0),
                                scalar_max_int(a.x1, b.x1), scalar_max_int(a.y1, b.y1)};
}

/* What a rectangle of stage units covers of the picture. */
static struct segment_box covered(const struct segments *s, struct point2 low, struct point2 high)
{
    int left, top;
    struct canvas c = stage_picture(s->stage, &left, &top);
    low = device_inside(low);
    high = device_inside(high);
    return (struct segment_box){scalar_max_int(device_dot(s->stage, low.x) - 1, left),
                                scalar_max_int(device_row(s->stage, high.y) - 1, top),
                                scalar_min_int(device_dot(s->stage, high.x) + 2, left + c.width),
                                scalar_min_int(device_row(s->stage, low.y) + 2, top + c.height)};
}

struct segment_box segment_raster_box(const struct segments *s, const struct segment *g)
{
    struct point2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    struct segment_primitive p;
    if (!g->visible || g->at == 0)
        return (struct segment_box){0};
    for (int record = g->first; segment_primitive_next(s, g, &record, &p);) {
        bool text = p.record->kind == SEGMENT_STRING;
        float reach = text ? TEXT_REACH : REACH;
        float right = text ? (float)(strlen(p.record->text) * STAGE_CHARACTER) : 0;
        for (int i = 0; i < p.count; i++) {
            if (!device_sane(p.at[i]))
                continue;
            struct point2 a = {p.at[i].x - reach, p.at[i].y - reach};
            struct point2 b = {p.at[i].x + right + reach, p.at[i].y + reach};
            low = (struct point2){a.x < low.x ? a.x : low.x, a.y < low.y ? a.y : low.y};
            high = (struct point2){b.x > high.x ? b.x : high.x, b.y > high.y ? b.y : high.y};
        }
    }
    return low.x > high.x ? (struct segment_box){0} : covered(s, low, high);
}

void segment_raster_damage(struct segments *s, struct segment_box box)
{
    for (int page = 0; page < 2; page++)
        s->damage[page] = join(s->damage[page], box);
}

/* ---- drawing --------------------------------------------------------------------------------- */

static void draw_within(struct segments *s, struct segment_box box)
{
    struct stage view = *s->stage;
    display_begin(&view.display, 0, 0); /* takes nothing */
    view.heads = STAGE_RASTER;
    view.hatch_apart = 0;
    for (int i = 0; i < s->count; i++)
        if (touch(s->table[i].box, box))
            segment_replay(s, &s->table[i], &view);
}

/* A segment is drawn whole or not at all: what it touches is drawn anew, too. */
static struct segment_box closed(const struct segments *s, struct segment_box box)
{
    for (bool grew = true; grew;) {
        grew = false;
        for (int i = 0; i < s->count; i++) {
            struct segment_box with = join(box, s->table[i].box);
            if (!touch(box, s->table[i].box) || memcmp(&with, &box, sizeof box) == 0)
                continue;
            box = with;
            grew = true;
        }
    }
    return box;
}

void segments_draw(struct segments *s)
{
    int left, top, page = 1 - s->stage->page_shown;
    segment_words_take(s);
    segment_show(s);
    struct canvas c = stage_picture(s->stage, &left, &top);
    for (int i = 0; i < s->count; i++)
        s->table[i].box = segment_raster_box(s, &s->table[i]);
    draw_within(s, (struct segment_box){left, top, left + c.width, top + c.height});
    s->damage[0] = s->damage[1] = (struct segment_box){0};
    s->copy[page] = false;
    s->copy[1 - page] = true;
    s->pictures = s->stage->pictures + 1;
    stage_chain(s->stage, s->low);
}

static void copy_page(struct segments *s, int page)
{
    const struct canvas *from = &s->stage->page[1 - page], *to = &s->stage->page[page];
    if (from->height > 0 && from->pixels != to->pixels)
        memcpy(to->pixels, from->pixels, from->pitch * (uint32_t)from->height);
    s->copy[page] = false;
}

bool segments_redraw(struct segments *s)
{
    if (s->stage->tenant != s || s->stage->pictures != s->pictures || s->pictures == 0)
        return false;
    stage_page_begin(s->stage);
    int page = 1 - s->stage->page_shown;
    if (s->copy[page])
        copy_page(s, page);
    struct segment_box box = closed(s, s->damage[page]);
    if (!is_empty(box)) {
        canvas_fill(&s->stage->canvas, box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0, INK_BLACK);
        draw_within(s, box);
    }
    s->damage[page] = (struct segment_box){0};
    stage_page_end(s->stage);
    s->pictures = s->stage->pictures;
    return true;
}

/* ---- picking --------------------------------------------------------------------------------- */

static float distance_to_line(struct point2 p, struct point2 a, struct point2 b)
{
    float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    float t = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
    t = scalar_min(scalar_max(t, 0), 1);
    return hypotf(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

static bool inside(struct point2 p, const struct point2 *q, int count)
{
    bool odd = false;
    for (int i = 0, k = count - 1; i < count; k = i++)
        if ((q[i].y > p.y) != (q[k].y > p.y) &&
            p.x < q[i].x + (p.y - q[i].y) * (q[k].x - q[i].x) / (q[k].y - q[i].y))
            odd = !odd;
    return odd;
}

static float distance_to_text(struct point2 p, struct point2 at, const char *text)
{
    struct point2 near = {
        scalar_min(scalar_max(p.x, at.x), at.x + (float)(strlen(text) * STAGE_CHARACTER)),
        scalar_min(scalar_max(p.y, at.y), at.y + STAGE_CHARACTER)};
    return hypotf(p.x - near.x, p.y - near.y);
}

static float distance(struct point2 place, const struct segment_primitive *p)
{
    enum segment_kind kind = p->record->kind;
    if (kind == SEGMENT_STRING)
        return distance_to_text(place, p->at[0], p->record->text);
    if (kind == SEGMENT_AREA && inside(place, p->at, p->count))
        return 0;
    float nearest = INFINITY;
    bool dots = kind == SEGMENT_MARKER || kind == SEGMENT_DOT;
    for (int i = 0; i < p->count; i++) {
        bool goes_round = kind == SEGMENT_POLYGON || kind == SEGMENT_AREA;
        struct point2 to = dots               ? p->at[i]
                           : i + 1 < p->count ? p->at[i + 1]
                           : goes_round       ? p->at[0]
                                              : p->at[i];
        nearest = scalar_min(nearest, distance_to_line(place, p->at[i], to));
    }
    return nearest;
}

const struct segment *segment_at(const struct segments *s, struct point2 place, float aperture,
                                 int *pick)
{
    const struct segment *found = NULL;
    struct segment_primitive p;
    for (int i = 0; i < s->count; i++) {
        const struct segment *g = &s->table[i];
        if (!g->visible || !g->detectable)
            continue;
        for (int record = g->first; segment_primitive_next(s, g, &record, &p);) {
            float d = distance(place, &p);
            if (d > aperture)
                continue;
            aperture = d;
            found = g;
            *pick = p.record->pick;
        }
    }
    return found;
}
