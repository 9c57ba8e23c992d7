/* pages.h — a lesson of several pages: which one, since when, at what pace.
 *
 *      lesson.key ──▶ own key, or space b p + - ─┐
 *      lesson.draw ──▶ the lesson's own clock ───┴▶ page at, seconds of it ──▶ title, picture, caption
 *
 * Models:     a clock that can stand and go faster or slower; pages that follow one another by
 *             themselves, and by keys. A page whose lesson's own keys were used stays.
 * Keys:       the same in every lesson: PAGES_KEYS. Those that a lesson takes itself come first.
 * Units:      seconds.
 * Ownership:  static storage of the lesson's file; pages_begin sets all that changes.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_PAGES_H
#define ROMS_LESSONS_PAGES_H

#include <stdbool.h>

#include "roms/lessons/key.h"
#include "roms/stage/stage.h"

#define PAGES_TURN "space next  b before  p pause"
#define PAGES_KEYS PAGES_TURN "  + - pace"

/* A page that is a function of the time. */
struct page {
    const char *title, *caption; /* NULL: draw writes it */
    float seconds;               /* until the next one */
    void (*draw)(struct stage *stage, float seconds);
};

struct pages {
    const struct page *page; /* NULL: `draw` draws them all */
    int count;
    float again; /* seconds from picture to picture, as lesson.draw returns them */

    /* What a lesson with a state of its own adds, or NULL. */
    void *own;
    void (*begin)(void *own);          /* the lesson begins */
    void (*turn)(void *own, int page); /* a page begins */
    /* Draws a page, title and caption included. Returns how long it lasts. */
    float (*draw)(void *own, struct stage *stage, int page, float seconds);
    /* Whether the key was one of its own. */
    bool (*key)(void *own, int key);

    float apart; /* seconds from the picture before to this one, whatever the pace */
    /* Private. */
    int at;
    bool paused, stays;
    float now, begun, before, pace;
};

/* A lesson's begin, key and draw; its state is a struct pages. */
void pages_begin(void *state);
void pages_key(void *state, int key);
float pages_draw(void *state, struct stage *stage, float seconds);

/* Goes to a page, 0…; from below 0 and from behind the last on the other side. */
void pages_go(struct pages *pages, int page);

#endif
