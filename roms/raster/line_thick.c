#include "roms/raster/line_thick.h"

#include <math.h>

#include "roms/geometry/scalar.h"

enum part { PART_POINT, PART_START, PART_SEGMENT, PART_END, PART_NONE };

static struct point2 shifted(struct point2 p, struct point2 by, float k)
{
    return (struct point2){p.x + k * by.x, p.y + k * by.y};
}

static struct point2 end_of(const struct line_thick *l, int segment)
{
    return l->point[segment + 1 < l->count ? segment + 1 : 0];
}

/* Of length 1. */
static struct point2 direction(const struct line_thick *l, int segment)
{
    struct point2 a = l->point[segment], b = end_of(l, segment);
    float dx = b.x - a.x, dy = b.y - a.y, length = sqrtf(dx * dx + dy * dy);
    return (struct point2){dx / length, dy / length};
}

/* The first segment from there on that has a length, or as many as there are. */
static int segment_from(const struct line_thick *l, int i)
{
    int segments = l->closed ? l->count : l->count - 1;
    for (; i < segments; i++) {
        struct point2 a = l->point[i], b = end_of(l, i);
        float dx = b.x - a.x, dy = b.y - a.y;
        if (dx * dx + dy * dy > 0)
            break;
    }
    return i;
}

void line_thick_begin(struct line_thick *l, const struct point2 *points, int count, bool closed,
                      const struct line_style *style)
{
    *l = (struct line_thick){
        .point = points, .count = count, .closed = closed && count > 1, .style = *style};
    l->part = PART_NONE;
    if (count < 1 || !(style->width > 0) || style->width > THICK_WIDEST)
        return;
    l->at = segment_from(l, 0);
    l->part = l->at >= count - !l->closed ? PART_POINT : l->closed ? PART_SEGMENT : PART_START;
}

/* ---- pieces ---------------------------------------------------------------------------------- */

static void add(struct thick_piece *piece, struct point2 p)
{
    piece->corner[piece->count++] = p;
}

/* From a to b, r to each side; d: from a to b. */
static void bar(struct thick_piece *piece, struct point2 a, struct point2 b, struct point2 d,
                float r)
{
    struct point2 side = {-d.y, d.x};
    add(piece, shifted(a, side, r));
    add(piece, shifted(b, side, r));
    add(piece, shifted(b, side, -r));
    add(piece, shifted(a, side, -r));
}

static void disc(struct thick_piece *piece, struct point2 p, float r)
{
    int corners = 8 + (int)(8.4f * sqrtf(r)); /* 1/16 pixel between arc and chord; 126 at most */
    for (int i = 0; i < corners; i++) {
        float angle = TURN * (float)i / (float)corners;
        add(piece, (struct point2){p.x + r * cosf(angle), p.y + r * sinf(angle)});
    }
}

/* Outward along d. */
static void cap(const struct line_thick *l, struct thick_piece *piece, struct point2 p,
                struct point2 d)
{
    float r = l->style.width / 2;
    piece->kind = PIECE_CAP;
    if (l->style.cap == CAP_ROUND)
        disc(piece, p, r);
    else if (l->style.cap == CAP_SQUARE)
        bar(piece, p, shifted(p, d, r), d, r);
}

static void point_cap(const struct line_thick *l, struct thick_piece *piece)
{
    const struct point2 right = {1, 0};
    float r = l->style.width / 2;
    piece->kind = PIECE_CAP;
    if (l->style.cap == CAP_SQUARE)
        bar(piece, shifted(l->point[0], right, -r), shifted(l->point[0], right, r), right, r);
    else
        cap(l, piece, l->point[0], right);
}

/* What lies between two segments on the outer side of the corner at p. */
static void join(const struct line_thick *l, struct thick_piece *piece, struct point2 p,
                 struct point2 d0, struct point2 d1)
{
    const float limit = THICK_MITER_LIMIT;
    float cross = d0.x * d1.y - d0.y * d1.x, dot = d0.x * d1.x + d0.y * d1.y;
    float r = cross > 0 ? l->style.width / 2 : -l->style.width / 2;
    struct point2 n0 = {d0.y, -d0.x}, n1 = {d1.y, -d1.x};
    piece->kind = PIECE_JOIN;
    if (l->style.join == JOIN_ROUND) {
        disc(piece, p, l->style.width / 2);
        return;
    }
    add(piece, p);
    add(piece, shifted(p, n0, r));
    if (l->style.join == JOIN_MITER && 2 <= limit * limit * (1 + dot)) {
        struct point2 both = {n0.x + n1.x, n0.y + n1.y};
        add(piece, shifted(p, both, r / (1 + dot)));
    }
    add(piece, shifted(p, n1, r));
}

/* Behind a segment: a join, or a cap. */
static void end_part(struct line_thick *l, struct thick_piece *piece)
{
    int segments = l->closed ? l->count : l->count - 1, next = segment_from(l, l->at + 1);
    struct point2 p = end_of(l, l->at), d = direction(l, l->at);
    l->part = next < segments ? PART_SEGMENT : PART_NONE;
    if (next >= segments && l->closed)
        next = segment_from(l, 0);
    if (next < segments)
        join(l, piece, p, d, direction(l, next));
    else
        cap(l, piece, p, d);
    l->at = next;
}

bool line_thick_next(struct line_thick *l, struct thick_piece *piece)
{
    for (;;) {
        struct point2 d;
        piece->count = 0;
        switch ((enum part)l->part) {
        case PART_POINT:
            l->part = PART_NONE;
            point_cap(l, piece);
            break;
        case PART_START:
            l->part = PART_SEGMENT;
            d = direction(l, l->at);
            cap(l, piece, l->point[l->at], (struct point2){-d.x, -d.y});
            break;
        case PART_SEGMENT:
            l->part = PART_END;
            piece->kind = PIECE_SEGMENT;
            bar(piece, l->point[l->at], end_of(l, l->at), direction(l, l->at), l->style.width / 2);
            break;
        case PART_END:
            end_part(l, piece);
            break;
        case PART_NONE:
            return false;
        }
        if (piece->count > 0)
            return true;
    }
}

void canvas_line_thick(const struct canvas *c, const struct point2 *points, int count, bool closed,
                       const struct line_style *style, uint32_t colour)
{
    struct line_thick line;
    struct thick_piece piece;
    line_thick_begin(&line, points, count, closed, style);
    while (line_thick_next(&line, &piece))
        canvas_polygon(c, piece.corner, piece.count, POLYGON_NON_ZERO, colour);
}
