/* What stands still, and the bars. */
#include "roms/pageflip/pageflip.h"
#include "roms/bsp/video.h"
#include "roms/raster/font.h"

enum { MARGIN = 24, HEAD = 96, BAR_PARTS = 8 }; /* a bar is an eighth of the stage */

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
    *page = (struct pageflip_page){
        .canvas = canvas,
        .solid = {MARGIN, y, width * 2 / 5, height},
        .bars = {MARGIN * 3 + width * 2 / 5, y, width * 3 / 5, height},
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
    static const char *const lines[] = {
        "drawn on the page that the beam shows, whenever the program gets to it",
        "drawn on a page nobody sees, which is shown from the next retrace on"};
    const struct canvas *c = &page->canvas;
    int scale = c->width >= 1000 ? 3 : 2, small = c->width >= 1000 ? 2 : 1;
    int x = MARGIN - 4;
    canvas_fill(c, 0, 0, c->width, HEAD, PAGEFLIP_GROUND);
    canvas_text(c, x, MARGIN - 4, scale, scale, PAGEFLIP_WHITE, heads[synced]);
    if (small * FONT_WIDTH * 70 > c->width - 2 * x)
        small = 1;
    canvas_text(c, x, HEAD - FONT_HEIGHT * small + 4, small, small, PAGEFLIP_FRAME, lines[synced]);
}

/* A stretch of the stage, which goes round: what is beyond its right edge is at the left. */
static void stretch(const struct pageflip_page *page, int from, int length, uint32_t colour)
{
    const struct pageflip_rect *r = &page->bars;
    from %= r->width;
    int first = from + length > r->width ? r->width - from : length;
    canvas_fill(&page->canvas, r->x + from, r->y, first, r->height, colour);
    canvas_fill(&page->canvas, r->x, r->y, length - first, r->height, colour);
}

void pageflip_bars(struct pageflip_page *page, int swept)
{
    const struct pageflip_rect *r = &page->bars;
    int width = r->width / BAR_PARTS;
    if (page->swept >= 0 && swept - page->swept > width) { /* long ago: begin anew */
        canvas_fill(&page->canvas, r->x, r->y, r->width, r->height, PAGEFLIP_GROUND);
        page->swept = -1;
    }
    for (int i = 0; i < BAR_PARTS; i += 2) {
        int at = swept + i * r->width / BAR_PARTS;
        stretch(page, at, width, PAGEFLIP_BAR);
        if (page->swept >= 0) /* what it leaves behind */
            stretch(page, at - (swept - page->swept), swept - page->swept, PAGEFLIP_GROUND);
    }
    page->swept = swept;
}

void pageflip_mark(struct pageflip_page *page, int row)
{
    const int size = 10, x = page->bars.x - 6;
    if (page->mark >= 0)
        canvas_fill(&page->canvas, x - size, page->mark - size, size, 2 * size + 1,
                    PAGEFLIP_GROUND);
    page->mark = row < page->bars.y || row >= page->bars.y + page->bars.height ? -1 : row;
    for (int i = 0; page->mark >= 0 && i < size; i++)
        canvas_fill(&page->canvas, x - 1 - i, page->mark - i, 1, 2 * i + 1, PAGEFLIP_MARK);
}
