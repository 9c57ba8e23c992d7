/* text.h — text clipped to a window by three rules.
 *
 *            ┌───────────┐        string:     all of it or none          ┌───────────┐
 *        TEXT│TEXT       │        character:  whole characters           │  XT       │
 *            └───────────┘        component:  what lies within, dot by dot
 *
 * Models:     characters of dots, each in a cell of its own; cells stand side by side. The first
 *             two rules look at the boxes of cells, the third cuts every dot.
 * Cost:       string: 4 comparisons; character: 4 a character; component: 4 comparisons a run of
 *             dots.
 * Domain:     a font of at most 8 dots across a character; finite sizes.
 * Units:      the caller's, y up. Dots: the font's; row 0 is the top.
 * Ownership:  the text and the font must outlive the iterator.
 * Errors:     none; a text of no characters has no parts.
 * Source:     D. Hearn, M. P. Baker, Computer Graphics (2nd ed. 1994), section 6-10.
 */
#ifndef ROMS_CLIP_TEXT_H
#define ROMS_CLIP_TEXT_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/clip/window.h"

enum clip_text_rule { CLIP_TEXT_STRING, CLIP_TEXT_CHARACTER, CLIP_TEXT_COMPONENT };

struct clip_font {
    int width, height;                  /* dots of a cell */
    uint8_t (*row)(char c, int number); /* bit 7 is the left dot */
};

/* Where a text stands. */
struct clip_text {
    const char *text;
    const struct clip_font *font;
    struct point2 at; /* lower left corner of the first cell */
    float dot;        /* side of a dot */
};

/* The box of all of it. */
struct clip_window clip_text_box(const struct clip_text *t);
/* Does the rule show this character, or (component) may it show a part of it? */
bool clip_text_shows(const struct clip_text *t, const struct clip_window *window,
                     enum clip_text_rule rule, int number);

/* The lit parts that are left, a run of dots at a time, from the first character on, top row
 * first. */
struct clip_text_parts {
    struct clip_window part; /* a rectangle */
    /* Private. */
    struct clip_text text;
    struct clip_window window;
    enum clip_text_rule rule;
    int number, row, column;
};

void clip_text_begin(struct clip_text_parts *p, const struct clip_text *text,
                     const struct clip_window *window, enum clip_text_rule rule);
bool clip_text_next(struct clip_text_parts *p);

#endif
