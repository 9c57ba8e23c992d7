/* Scan-out: one line of pixels or overscan to the sink. */
#include <string.h>

#include "raster/head_parts.h"

bool ras_row_address(const struct ras_head *head, uint32_t row, uint32_t *at)
{
    const struct ras_latch *latch = &head->latch;
    uint64_t begin = latch->base + (uint64_t)latch->pitch * row;
    *at = (uint32_t)begin;
    return begin + ras_format_bytes(latch->format, head->timing.h.visible) <= VIDEO_BUFFER_BYTES;
}

static void drive(struct ras_head *head, const uint32_t *colour, uint32_t count, uint32_t at)
{
    if (head->desc.guns == 1)
        ras_drive_luma(colour, count, head->dots[0] + at);
    else
        ras_drive_guns(colour, count, head->dots[0] + at, head->dots[1] + at, head->dots[2] + at);
}

/* What the guns make of one colour. */
static void drive_of(const struct ras_head *head, uint32_t colour, uint8_t to[CRT_MAX_GUNS])
{
    if (head->desc.guns == 1)
        ras_drive_luma(&colour, 1, to);
    else
        ras_drive_guns(&colour, 1, to, to + 1, to + 2);
}

static void fill(struct ras_head *head, const uint8_t colour[CRT_MAX_GUNS], int64_t at,
                 int64_t count)
{
    for (int g = 0; g < head->desc.guns; g++)
        memset(head->dots[g] + at, colour[g], (size_t)count);
}

/* What a line consists of: dots of overscan, then either pixels from `at` or more overscan. */
struct content {
    int64_t row, left, right;
    bool pixels;
    uint32_t at; /* byte in the buffer */
    uint8_t edge[CRT_MAX_GUNS];
};

/* False when nothing of the line is lit. */
static bool decide(struct ras_head *head, uint64_t begin, struct content *c)
{
    const struct ras_sweep *w = &head->sweep;
    *c = (struct content){.row = ras_row_at(head, begin)};
    bool picture = c->row >= 0 && c->row < head->timing.v.visible;
    if (!head->blank) {
        drive_of(head, head->overscan, c->edge);
        c->pixels = picture && ras_row_address(head, (uint32_t)c->row, &c->at);
        if (picture && !c->pixels)
            head->status |= VIDEO_STATUS_BAD_BASE;
    }
    bool edge = false;
    for (int g = 0; g < head->desc.guns; g++)
        edge |= c->edge[g] != 0;
    int64_t since_sync = w->field + c->row * w->unit - w->sync_end;
    c->left = edge && begin > 0 ? (w->left < since_sync ? w->left : since_sync) : 0;
    c->right = edge ? w->right : 0;
    return picture || edge;
}

static void place(const struct ras_head *head, const struct content *c, struct crt_scan_line *line)
{
    const struct ras_head_desc *desc = &head->desc;
    double columns = head->timing.h.visible, rows = head->timing.v.visible;
    double x_mm = desc->width_mm / columns, y_mm = desc->height_mm / rows;
    line->x0 = (float)(((double)-c->left - columns / 2) * x_mm);
    line->x1 = (float)((columns / 2 + (double)c->right) * x_mm);
    line->y0 = line->y1 = (float)((rows / 2 - (double)c->row - 0.5) * y_mm);
}

static void draw(struct ras_head *head, const struct content *c, struct crt_scan_line *line)
{
    uint32_t colour[RAS_MAX_DOTS + 8];
    uint32_t visible = head->timing.h.visible;
    fill(head, c->edge, 0, c->pixels ? c->left : line->dots);
    if (c->pixels) {
        fill(head, c->edge, c->left + visible, c->right);
        ras_read_pixels(head->latch.format, head->desc.buffer + c->at, visible, head->lut, colour);
        drive(head, colour, visible, (uint32_t)c->left);
    }
    line->guns = head->desc.guns;
    line->source = (uint32_t)c->row;
    for (int g = 0; g < line->guns; g++)
        line->drive[g] = head->dots[g];
    place(head, c, line);
    head->desc.wires.line(head->desc.wires.ctx, line);
}

void ras_head_pixels(const struct ras_head *head, uint32_t row, uint32_t *colour)
{
    uint32_t at, visible = head->timing.h.visible;
    if (ras_row_address(head, row, &at)) {
        ras_read_pixels(head->latch.format, head->desc.buffer + at, visible, head->lut, colour);
        return;
    }
    for (uint32_t x = 0; x < visible; x++)
        colour[x] = head->overscan;
}

void ras_scan(struct ras_head *head, uint64_t begin)
{
    struct content c;
    if (!decide(head, begin, &c))
        return;
    int64_t visible = head->timing.h.visible;
    struct crt_scan_line line = {
        .t0 = ras_dot_time(head, begin - (uint64_t)c.left),
        .t1 = ras_dot_time(head, begin + (uint64_t)(visible + c.right)),
        .dots = (int)(c.left + visible + c.right),
    };
    if (line.t0 < head->lit_until) /* a line of the timing before is under way */
        return;
    head->lit_until = line.t1;
    if (head->desc.wires.line)
        draw(head, &c, &line);
}
