/* line_antialiased.h — lines without steps: a pixel is as light as the line covers it.
 *
 *        ░░▒▒▓▓██▓▓▒▒░░          distance d of a pixel's middle from the line
 *      ──────── line ────────        │
 *        ░░▒▒▓▓██▓▓▒▒░░              ▼  table: a cone of radius 1 over the band |d| <= 1/2
 *                                coverage 0…255 ──▶ entry of a ramp, or blended with what is there
 *
 * Models:     a line one pixel wide, seen through a conical filter that reaches one pixel:
 *             unweighted by direction, equally bright at every slope. Ends may lie between pixels;
 *             there the line is cut across, half a pixel behind its end, so that it moves without
 *             jumping.
 * Cost:       a column: 4 pixels, 4 look-ups, 5 multiplications. Into a ramp of 8-bit pixels about
 *             115 instructions a column, blending into 32 bits 140, into 16 bits 200; to begin 550.
 * Domain:     finite coordinates of at most 30000; what lies outside the canvas is left out. After
 *             4000 columns the line is at most 1/32 pixel off.
 * Units:      pixels of the canvas; whole numbers are middles of pixels.
 * Ownership:  plain values; the ramp is the caller's.
 * Errors:     a line beyond the domain is not drawn; nor is one with fewer than 2 or more than 256
 *             levels, or blended into pixels of less than 16 bits.
 * Source:     S. Gupta, R. F. Sproull, Filtering Edges for Gray-Scale Displays, Computer Graphics
 *             15 (SIGGRAPH 1981) 1; the table is the integral in closed form (line_antialiased.c).
 *             They light 3 pixels a column; a fourth holds what they lose at 45 degrees.
 * Not modelled: the round falling-off of ends; blending in light instead of in the pixels' values.
 */
#ifndef ROMS_RASTER_LINE_ANTIALIASED_H
#define ROMS_RASTER_LINE_ANTIALIASED_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/raster/canvas.h"

enum {
    ANTIALIASED_PIXELS = 4,   /* in a column, or in a row where the line is steep */
    ANTIALIASED_DISTANCE = 64 /* units of distance in a pixel */
};

struct line_antialiased {
    int along, last;      /* the column that comes next, and the last one */
    int32_t minor, slope; /* the other coordinate, 16 bits behind the point; its step */
    int32_t cosine;       /* distance of neighbours in a column, 12 bits behind the point */
    int32_t part_first, part_last; /* how much of the first and last column is the line's, 0…256 */
    bool steep;                    /* columns are rows */
    bool first;
};

/* A column: pixels across, across + 1, … and the column's place along the line. */
struct antialiased_column {
    int along, across;
    bool steep;
    int distance[ANTIALIASED_PIXELS]; /* from the line, 64 to a pixel */
    uint8_t coverage[ANTIALIASED_PIXELS];
};

/* Coverage by distance: 64 entries a pixel; 0 from 3/2 on. */
enum { ANTIALIASED_ENTRIES = 132 };
extern const uint8_t antialiased_coverage[ANTIALIASED_ENTRIES];

/* false: beyond the domain. */
bool line_antialiased_begin(struct line_antialiased *line, float x0, float y0, float x1, float y1);

static inline bool line_antialiased_next(struct line_antialiased *l, struct antialiased_column *out)
{
    if (l->along > l->last)
        return false;
    int32_t cosine = l->cosine, from = ((l->minor & 0xFFFF) >> 4) * cosine >> 12;
    out->along = l->along;
    out->across = (l->minor >> 16) - 1;
    out->steep = l->steep;
    out->distance[0] = (int)((from + cosine) >> 6);
    out->distance[1] = (int)(from >> 6);
    out->distance[2] = (int)((cosine - from) >> 6);
    out->distance[3] = (int)((2 * cosine - from) >> 6);
    out->coverage[0] = antialiased_coverage[out->distance[0]];
    out->coverage[1] = antialiased_coverage[out->distance[1]];
    out->coverage[2] = antialiased_coverage[out->distance[2]];
    out->coverage[3] = antialiased_coverage[out->distance[3]];
    if (l->along == l->last || l->first) {
        int32_t part = l->first ? l->part_first : l->part_last;
        for (int i = 0; i < ANTIALIASED_PIXELS; i++)
            out->coverage[i] = (uint8_t)(out->coverage[i] * part >> 8);
        l->first = false;
    }
    l->along++;
    l->minor += l->slope;
    return true;
}

/* Into a ramp of pixel values, the ground first: `levels` of them. Where an ascending ramp's
 * lighter value stands already it stays, so that lines may cross. */
void canvas_line_antialiased(const struct canvas *c, float x0, float y0, float x1, float y1,
                             const uint32_t *ramp, int levels);
/* Mixed with what is there: pixels of 16 or 32 bits. */
void canvas_line_blended(const struct canvas *c, float x0, float y0, float x1, float y1,
                         uint32_t colour);

#endif
