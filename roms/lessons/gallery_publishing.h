/* gallery_publishing.h — a page, composed and looked at; private to gallery_publishing*.c.
 *
 * Units: hundredths of an inch; the page is 850 by 1100, origin bottom left.
 */
#ifndef ROMS_LESSONS_GALLERY_PUBLISHING_H
#define ROMS_LESSONS_GALLERY_PUBLISHING_H

#include "roms/raster/text_antialiased.h"
#include "roms/stage/stage.h"

enum { PAGE_WIDTH = 850, PAGE_HEIGHT = 1100, PAGE_SHADES = 32 };

/* What of the page is looked at, and how. */
struct page_view {
    struct stage *stage;
    struct canvas canvas;     /* of the picture alone */
    float left, top;          /* where that is on the page's canvas */
    struct point2 middle;     /* of the view, on the page */
    float zoom;               /* stage units a hundredth of an inch */
    const uint32_t *ramp;     /* PAGE_SHADES values from paper to ink */
    struct text_shades *body; /* the commonest size of text */
};

struct page_view page_look(struct stage *stage, struct point2 middle, float zoom);
struct point2 page_place(const struct page_view *view, struct point2 p);
/* The page; `seconds` moves what moves on it. */
void page_draw(const struct page_view *view, float seconds);

#endif
