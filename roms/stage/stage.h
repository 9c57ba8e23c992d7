/* stage.h — one drawing on both heads: title, picture, caption.
 *
 *      ┌──────────── title ────────────┐      raster head: 640 x 480 (or what there is), two pages,
 *      │ (0,800)                       │      shown at retrace
 *      │                               │      vector head: a display file in two places, shown by
 *      │     picture, stage units      │      one store
 *      │                               │
 *      │ (0,0)                (1200,0) │      what is drawn between stage_begin and stage_end is
 *      └────── caption, prompt ────────┘      shown whole or not at all; the prompt at once
 *
 * Models:     the output primitives of graphics packages: polyline, marker, fill area, text (ISO
 *             7942, GKS), with a driver for each head: into pixels by scan conversion
 *             (roms/raster), into display-file words (roms/bsp/display.h). Lines are clipped to the
 *             picture.
 * Units:      stage units: 1200 across, 800 up, origin bottom left, y up; square on both heads.
 * Ownership:  plain value, one for the program; it has the whole refresh buffer, the look-up table
 *             and display memory.
 * Errors:     a head that is not there takes everything and keeps nothing. Words that do not fit
 *             into display memory are left out; `full` tells, and so does the picture. Places
 *             that are not finite, or beyond a million, are left out. A display processor that
 *             stands still in the part that comes next is waited for half a second, once a picture.
 * Not modelled: areas on the vector head: their outline is drawn, hatched when asked. Display
 *             memory of less than 64 KiB; tubes of fewer than 1024 units up (VR14 cuts the title).
 */
#ifndef ROMS_STAGE_STAGE_H
#define ROMS_STAGE_STAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/bsp/display.h"
#include "roms/geometry/vector.h"
#include "roms/raster/canvas.h"
#include "roms/stage/ink.h"

enum { STAGE_WIDTH = 1200, STAGE_HEIGHT = 800 };
enum { STAGE_PROMPT = 70 }; /* characters of a prompt, at most */
enum { STAGE_RASTER = 1, STAGE_VECTOR = 2, STAGE_BOTH = 3 };
/* As the VT11 has them: the same on both heads. */
enum stage_line_type {
    STAGE_SOLID = DF_LINE_SOLID,
    STAGE_LONG_DASH = DF_LINE_LONG,
    STAGE_SHORT_DASH = DF_LINE_SHORT,
    STAGE_DOT_DASH = DF_LINE_DOTDASH
};
/* Room that a character takes on either head, and lines of text apart; stage units. */
enum { STAGE_CHARACTER = 17, STAGE_TEXT_LINE = 30 };
/* Corners of an area, at most; with more its outline is drawn. */
enum { STAGE_AREA_CORNERS = 128 };

/* Display memory: the pictures that stage_begin and stage_end make, then room for display files of
 * others (stage_chain); byte addresses. */
enum {
    STAGE_PART_LOW = 0x0100, /* before it: wait for the tick, prompt, jump to the part shown */
    STAGE_PART_BYTES = 0x6000,
    STAGE_FREE_LOW = STAGE_PART_LOW + 2 * STAGE_PART_BYTES,
    STAGE_FREE_HIGH = 0x10000
};

struct stage {
    struct canvas canvas;   /* the page that is being drawn; 0 by 0 without a raster head */
    struct display display; /* the words that are being written */
    unsigned heads;         /* those that the primitives go to, STAGE_… */
    enum ink ink;
    unsigned pictures; /* that were shown */
    bool full;         /* words were left out of the last one */
    enum stage_line_type line_type;
    float hatch_degrees, hatch_apart; /* of areas on the vector head; 0 apart: none */
    /* Private. */
    struct canvas page[2];
    float left, bottom,
        dots;        /* of the picture on the canvas: dots, rows from the top; dots a unit */
    float units;     /* head units a stage unit */
    uint32_t patch;  /* where the display file jumps to the part that is shown */
    uint32_t chain;  /* where the part goes on; 0: nowhere */
    uint32_t prompt; /* where the prompt's characters are */
    char prompted[STAGE_PROMPT + 1];
    int page_shown, part_shown;
    uint32_t flipped;       /* retraces when the page was given */
    const void *tenant;     /* whose display files are in STAGE_FREE_LOW… */
    int intensity, type;    /* as the words before have them; -1: not known */
    struct point2 dash_end; /* of the broken line before, which the next may go on with */
    float dash_phase;
};

/* Chooses the mode, fills the look-up table, shows an empty picture on each head. */
void stage_open(struct stage *stage);
/* An empty picture, which stage_end shows; between them the last one stays. stage_begin waits until
 * that one is on the screen. */
void stage_begin(struct stage *stage);
void stage_end(struct stage *stage);

/* After the picture, in each refresh, the display processor goes through the display file at this
 * address, within STAGE_FREE_LOW…, which must end with a jump to 0. stage_begin: none. */
void stage_chain(struct stage *stage, uint32_t address);
/* The raster head's other page, with what was last drawn on it, becomes the canvas; _end shows it.
 * The vector head goes on with its picture. Not between stage_begin and stage_end. */
void stage_page_begin(struct stage *stage);
void stage_page_end(struct stage *stage);

/* Shows the picture before the last one again, and takes this one back into store. */
void stage_flip(struct stage *stage);

/* A line under every picture, shown at once: what is being typed. */
void stage_prompt(struct stage *stage, const char *text);

/* The heads that primitives go to from now on; stage_begin: both. */
void stage_heads(struct stage *stage, unsigned heads);
void stage_ink(struct stage *stage, enum ink ink);
/* Of lines, polylines and polygons from now on; stage_begin: solid. */
void stage_line_type(struct stage *stage, enum stage_line_type type);
/* Areas on the vector head from now on: lines so steep and so far apart; stage_begin: none. */
void stage_hatch(struct stage *stage, float degrees, float apart);

void stage_line(struct stage *stage, float x0, float y0, float x1, float y1);
void stage_polyline(struct stage *stage, const struct point2 *points, int count);
void stage_polygon(struct stage *stage, const struct point2 *points, int count); /* closed */
/* Filled where the head can, even-odd; an outline on the vector head. */
void stage_area(struct stage *stage, const struct point2 *points, int count);
void stage_rectangle(struct stage *stage, float x, float y, float width, float height);
/* A small cross. */
void stage_marker(struct stage *stage, float x, float y);
void stage_dot(struct stage *stage, float x, float y);
/* Base line begins at x, y; about x. Characters beyond the picture's left and right edge are left
 * out; a line that sticks out above or below is moved in. */
void stage_text(struct stage *stage, float x, float y, const char *text);
void stage_text_middle(struct stage *stage, float x, float y, const char *text);
void stage_number(struct stage *stage, float x, float y, float value, int decimals);

/* Above and below the picture. A caption is broken into at most STAGE_CAPTION_LINES lines at
 * spaces. */
enum { STAGE_CAPTION_LINES = 2 };
void stage_title(struct stage *stage, const char *text);
void stage_caption(struct stage *stage, const char *text);

/* Where the picture is on the page: a canvas of its own, and its upper left corner. */
struct canvas stage_picture(const struct stage *stage, int *left, int *top);
/* Where a place of the picture is on the canvas. Whole numbers are middles of pixels. */
float stage_canvas_x(const struct stage *stage, float x);
float stage_canvas_y(const struct stage *stage, float y);
/* … and in head units of the vector head. */
float stage_head_x(const struct stage *stage, float x);
float stage_head_y(const struct stage *stage, float y);
/* Where places of the canvas and of the vector head are on the stage, and beyond it. */
struct point2 stage_from_canvas(const struct stage *stage, float x, float y);
struct point2 stage_from_head(const struct stage *stage, float x, float y);

#endif
