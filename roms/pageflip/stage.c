/* What stands still, and the bars. */
#include "roms/pageflip/pageflip.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

enum { MARGIN = 24, HEAD = 88, BAR_PARTS = 6, MARK = 16 }; /* a bar is a sixth of the stage */

void pageflip_colours(void)
{
    video_set_colour(PAGEFLIP_GROUND, 0x000000);
    for (unsigned i = 0; i < PAGEFLIP_SHADES; i++) {
        unsigned level = 40 + i * 215 / (PAGEFLIP_SHADES - 1);
        video_set_colour(PAGEFLIP_SHADE + i,
                         level << 16 | level * 178 / 255 << 8 | level * 60 / 255);
    }
    video_set_colour(PAGEFLIP_WHITE, 0xFFFFFF);
    video_set_colour(PAGEFLIP_FRAME, 0x7F7F7F);
    video_set_colour(PAGEFLIP_BAR, 0x40C8E0);
    video_set_colour(PAGEFLIP_MARK, 0xFF3030);
}

static void frame(const struct canvas *c, struct pageflip_rect r)
{
    canvas_frame(c, r.x - 4, r.y - 4, r.width + 8, r.height + 8, 1, PAGEFLIP_FRAME);
}

void pageflip_stage(struct pageflip_page *page, struct canvas canvas)
{
    int height = canvas.height - HEAD - 2 * MARGIN, y = HEAD + MARGIN;
    int width = canvas.width - 4 * MARGIN; /* margins, and one between them */
    int bars = width * 3 / 5 / (4 * BAR_PARTS) * (4 * BAR_PARTS); /* whole words */
    int solid = (width - bars) / 4 * 4;
    *page = (struct pageflip_page){
        .canvas = canvas,
        .solid = {MARGIN, y, solid, height},
        .bars = {MARGIN * 3 + solid, y, bars, height},
        .swept = -1,
        .mark = -1,
    };
    canvas_clear(&page->canvas, PAGEFLIP_GROUND);
    frame(&page->canvas, page->solid);
    frame(&page->canvas, page->bars);
}

void pageflip_text(struct pageflip_page *page, bool synced)
{
    static const char *const heads[] = {"WITHOUT SYNC", "WITH SYNC"};
    static const char *const lines[] = {"drawn on the page that is shown, wherever the beam is",
                                        "drawn on a hidden page, shown from the next retrace on"};
    const struct canvas *c = &page->canvas;
    int scale = c->width >= 1000 ? 3 : 2, small = c->width >= 1000 ? 2 : 1;
    int x = MARGIN - 4;
    canvas_fill(c, 0, 0, c->width, HEAD, PAGEFLIP_GROUND);
    canvas_text(c, x, MARGIN - 4, scale, scale, PAGEFLIP_WHITE, heads[synced]);
    if (small * FONT_WIDTH * 54 > c->width - 2 * x)
        small = 1;
    canvas_text(c, x, MARGIN + FONT_HEIGHT * scale + 4, small, small, PAGEFLIP_FRAME,
                lines[synced]);
}

/* What changes in every row alike: stretches of it, in words, that get another colour. */
struct change {
    int from, length;
    uint32_t colours; /* of four pixels */
};
struct changes {
    int count;
    struct change list[4 * BAR_PARTS];
};

/* The stage goes round: beyond its right edge is its left one. */
static void add(struct changes *changes, int width, int from, int length, uint32_t colour)
{
    from = (from % width + width) % width;
    int first = length < width - from ? length : width - from;
    uint32_t colours = colour * 0x01010101u;
    changes->list[changes->count++] = (struct change){from, first, colours};
    if (first < length)
        changes->list[changes->count++] = (struct change){0, length - first, colours};
}

/* The bars grow on one side and shrink on the other. */
static struct changes moved_to(const struct pageflip_page *page, int swept)
{
    struct changes changes = {0};
    int width = page->bars.width / 4, moved = (swept - page->swept) / 4;
    for (int i = 0; i < BAR_PARTS; i += 2) {
        int at = page->swept / 4 + i * width / BAR_PARTS;
        add(&changes, width, at + width / BAR_PARTS, moved, PAGEFLIP_BAR);
        add(&changes, width, at, moved, PAGEFLIP_GROUND);
    }
    return changes;
}

static void change_row(const struct changes *changes, uint32_t *row)
{
    const struct change *end = changes->list + changes->count;
    for (const struct change *c = changes->list; c < end; c++) {
        uint32_t *to = row + c->from + c->length;
        for (uint32_t *at = row + c->from; at < to; at++)
            *at = c->colours;
    }
}

static void mark(const struct pageflip_page *page, int row, uint32_t colour)
{
    for (int i = 0; i < MARK; i++)
        canvas_fill(&page->canvas, page->bars.x - 6 - MARK + i, row + i, MARK - i, 1, colour);
}

/* From the beginning: all is dark. */
static void first(struct pageflip_page *page, int swept)
{
    const struct pageflip_rect *r = &page->bars;
    canvas_fill(&page->canvas, r->x, r->y, r->width, r->height, PAGEFLIP_GROUND);
    page->swept = swept - r->width / BAR_PARTS; /* a whole bar of change */
}

void pageflip_bars(struct pageflip_page *page, int swept, bool look)
{
    const struct pageflip_rect *r = &page->bars;
    swept &= ~3;
    if (page->swept < 0 || swept - page->swept > r->width / BAR_PARTS)
        first(page, swept);
    pageflip_unmark(page);
    struct changes changes = moved_to(page, swept);
    int beam = (int)video_beam_row();
    look = look && beam > r->y && beam < page->canvas.height; /* else it comes after us */
    for (int y = r->y; y < r->y + r->height; y++) {
        int before = beam;
        beam = look ? (int)video_beam_row() : 0;
        look = look && beam >= before && beam < page->canvas.height;
        if (look && beam <= y) {
            look = false;
            page->mark = y;
            mark(page, y, PAGEFLIP_MARK);
        }
        change_row(&changes,
                   (uint32_t *)(void *)(page->canvas.pixels + (uint32_t)y * page->canvas.pitch +
                                        (uint32_t)r->x));
    }
    page->swept = swept;
}

void pageflip_unmark(struct pageflip_page *page)
{
    if (page->mark >= 0)
        mark(page, page->mark, PAGEFLIP_GROUND);
    page->mark = -1;
}
