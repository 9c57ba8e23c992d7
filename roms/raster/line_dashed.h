/* line_dashed.h — lines with a pattern of dashes and gaps that goes on around corners.
 *
 *      ━━━━━  ━  ━━━━━┓        lengths {10, 4, 2, 4}: dash, gap, dash, gap in pixels along the
 *                     ┃        line, whatever its slope; what is left of a dash at a corner
 *                     ╹        is drawn behind it
 *
 * Models:     the pixels of line_bresenham.h, each on or off by its distance from where the pattern began.
 * Cost:       about 35 instructions a pixel, and those of canvas_dot where it is on.
 * Domain:     coordinates of at most 30000; lengths 1…255.
 * Units:      pixels of the canvas.
 * Ownership:  the pattern is the caller's; the phase, too: it goes from line to line.
 * Errors:     none; a line beyond the domain has no pixels; a pattern without lengths is solid.
 * Source:     elementary; J. E. Bresenham, IBM Systems Journal 4 (1965) 25, for the pixels.
 */
#ifndef ROMS_RASTER_LINE_DASHED_H
#define ROMS_RASTER_LINE_DASHED_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/raster/canvas.h"
#include "roms/raster/line_bresenham.h"

enum { DASH_LENGTHS = 8 };

/* An even number of lengths: dash, gap, … */
struct dash_pattern {
    uint8_t length[DASH_LENGTHS];
    int count;
};

/* Where in the pattern a line begins; all 0 at its start. */
struct dash_phase {
    int which;    /* the length that it is in */
    int32_t gone; /* of that, 16 bits behind the point */
};

struct line_dashed {
    const struct dash_pattern *pattern;
    struct dash_phase *phase;
    struct line_bresenham pixels;
    int32_t advance; /* distance of neighbours, 16 bits behind the point */
};

void line_dashed_begin(struct line_dashed *line, int x0, int y0, int x1, int y1,
                       const struct dash_pattern *pattern, struct dash_phase *phase);

static inline bool line_dashed_on(const struct line_dashed *l)
{
    return (l->phase->which & 1) == 0;
}

/* The next pixel, and whether it is on. Both ends are pixels; the phase is that of the last one. */
static inline bool line_dashed_next(struct line_dashed *l, int *x, int *y, bool *on)
{
    if (!line_bresenham_next(&l->pixels))
        return false;
    *x = l->pixels.x;
    *y = l->pixels.y;
    *on = line_dashed_on(l);
    if (l->pixels.k == l->pixels.last || l->pattern->count == 0)
        return true;
    l->phase->gone += l->advance;
    while (l->phase->gone >= l->pattern->length[l->phase->which] << 16) {
        l->phase->gone -= l->pattern->length[l->phase->which] << 16;
        l->phase->which = l->phase->which + 1 < l->pattern->count ? l->phase->which + 1 : 0;
    }
    return true;
}

/* The pattern goes on where `phase` says, which is moved to the line's end. */
void canvas_line_dashed(const struct canvas *c, int x0, int y0, int x1, int y1,
                        const struct dash_pattern *pattern, struct dash_phase *phase,
                        uint32_t colour);

#endif
