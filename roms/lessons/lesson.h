/* lesson.h — a chapter of computer graphics as a picture that moves and can be steered.
 *
 *      lesson_run: ──key──▶ lesson.key        ┌──▶ title, picture, caption on both heads (stage.h)
 *                  ──time─▶ lesson.draw ──────┘
 *
 * A lesson draws its whole picture each time it is asked. It says in a caption what to look at, and runs
 * without keys: what they change also changes by itself, slowly.
 *
 * Models:     a program that is a picture of the time and of its state.
 * Time:       seconds since the lesson began, simulated.
 * Ownership:  the state is static storage that the lesson's own file defines; begin sets all of it.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_LESSON_H
#define ROMS_LESSONS_LESSON_H

#include <stdbool.h>

#include "roms/lessons/key.h"
#include "roms/stage/stage.h"

struct lesson {
    const char *name;  /* one word, for the command `lesson NAME` */
    const char *title; /* for the menu: under 40 characters */
    const char *keys;  /* what the keys do, under 60 characters: "+ - radius  space next" */
    void *state;
    void (*begin)(void *state);
    /* A key other than those that leave (q, Escape). */
    void (*key)(void *state, int key);
    /* Draws all of the picture between stage_begin and stage_end, which the caller calls. Returns after
     * how many seconds it wants to draw again; 0: at once; below 0: after the next key. */
    float (*draw)(void *state, struct stage *stage, float seconds);
};

/* Chapters, each upon those before it, then the gallery; lessons.c. Ends with NULL. */
extern const struct lesson *const lessons[];

#endif
