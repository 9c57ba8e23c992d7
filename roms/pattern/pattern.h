/* pattern.h — the parts of the test patterns.
 *
 * Models:     a screen of 32 bits a pixel, laid out in a grid of 16 by 12 cells that are square on
 *             the glass, whatever the mode; what remains at the edges is the border.
 * Position:   cells about the middle of the screen, x to the right, y downwards; or pixels.
 * Ownership:  plain values; draws into the canvas.
 * Errors:     none.
 * Source:     SMPTE EG 1-1990 for the bars; the rest is ours, in the manner of the cards of the time.
 */
#ifndef ROMS_PATTERN_PATTERN_H
#define ROMS_PATTERN_PATTERN_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/bsp/video.h"

#define PATTERN_ACROSS 16
#define PATTERN_DOWN   12

#define PATTERN_BLACK  0x000000
#define PATTERN_WHITE  0xFFFFFF
#define PATTERN_LEVELS 17 /* of coverage, 0…16 sixteenths */

struct pattern {
    struct canvas canvas;
    struct video_timing timing;
    int x, y;                      /* the middle */
    int cell_x, cell_y;            /* a cell, dots and rows */
    int text;                      /* pixels of the screen for one of the font */
    uint8_t level[PATTERN_LEVELS]; /* video level whose light is so many sixteenths of white */
};

void pattern_begin(struct pattern *p);

/* Each fills the screen. */
void pattern_card(const struct pattern *p);
void pattern_bars(const struct pattern *p);
void pattern_hatch(const struct pattern *p);
void pattern_gamma(const struct pattern *p);
void pattern_resolution(const struct pattern *p);
void pattern_focus(const struct pattern *p);
void pattern_field(const struct pattern *p, uint32_t colour);

/* ---- places and colours ------------------------------------------------------------------------ */

int pattern_x(const struct pattern *p, float cells);
int pattern_y(const struct pattern *p, float cells);
uint32_t pattern_grey(unsigned level); /* 0…255 */
/* The grey whose light is `share` of white's on a tube of exponent `gamma`. */
uint32_t pattern_light(float share, float gamma);

/* ---- parts, between corners given in cells ----------------------------------------------------- */

struct pattern_box {
    float x0, y0, x1, y1;
};

void pattern_fill(const struct pattern *p, struct pattern_box box, uint32_t colour);
/* Bars of black and white, `pair` pixels a pair: lines upright, or level. */
void pattern_grating(const struct pattern *p, struct pattern_box box, int pair, bool level);
/* Lines that run from pairs of `wide` pixels to pairs of `narrow` ones, with marks: upright lines
 * that meet downwards, or level ones that meet to the right; `back`: upwards, to the left. Edges
 * have greys where a pixel is partly covered, so that no pattern but the tube's limit is seen. */
struct pattern_wedge {
    int pairs;
    float wide, narrow;
    bool level, back, marks;
};
void pattern_wedge(const struct pattern *p, struct pattern_box box, struct pattern_wedge wedge);
/* A star of 18 rays in a ring, about the middle of the box. */
void pattern_star(const struct pattern *p, float x, float y, float radius);
/* Text about a place, its middle at `y`; enlarged. */
void pattern_label(const struct pattern *p, float x, float y, int enlarge, uint32_t colour,
                   const char *text);

/* Of the running mode: "1024x768@60", "48.363 kHz", "60.00 Hz"; of the tube: "320 x 240 mm". */
#define PATTERN_NAME 48
void pattern_mode_name(const struct pattern *p, char *text);
void pattern_line_rate(const struct pattern *p, char *text);
void pattern_field_rate(const struct pattern *p, char *text);
void pattern_screen_size(char *text);

#endif
