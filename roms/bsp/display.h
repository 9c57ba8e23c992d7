/* display.h — writes display files: places and lines in, display-processor words out.
 *
 *      display_at, _dot, _line, _text ──▶ mode words as needed, data words ──▶ display memory
 *
 * Models:     points, vectors (short ones where they are short), characters, sync, stop, jump.
 * Position:   head units, 0…1023, origin bottom left; places beyond are moved to the edge.
 * Ownership:  plain value; writes to display memory between `at` and `end`.
 * Errors:     words that do not fit are left out and `full` is set; room for a jump is kept.
 * Source:     display_file/df_regs.h.
 * Not modelled: graphplot, relative points, shift-out, blink.
 */
#ifndef ROMS_BSP_DISPLAY_H
#define ROMS_BSP_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

#include "display_file/df_regs.h"

struct display {
    uint32_t at;  /* address of the next word */
    uint32_t end; /* the first address that is not ours */
    bool full;
    int x, y;         /* where the beam is */
    int mode;         /* of the words before, DF_MODE_…; -1: not known */
    uint16_t setting; /* what the next mode word changes: intensity, line type */
};

/* An empty display file in [low, high). Intensity and line type are what they were. */
void display_begin(struct display *d, uint32_t low, uint32_t high);

/* For what follows: intensity 0…7; line type DF_LINE_…. */
void display_intensity(struct display *d, unsigned level);
void display_line_type(struct display *d, unsigned type);

/* The beam goes to a place, dark; lights the place; draws a line to the place. */
void display_at(struct display *d, int x, int y);
void display_dot(struct display *d, int x, int y);
void display_line(struct display *d, int x, int y);

/* Characters from a place on; the beam ends somewhere. */
void display_text(struct display *d, int x, int y, const char *text);

void display_sync(struct display *d); /* waits for the sync tick */
void display_stop(struct display *d); /* stops and interrupts */
void display_jump(struct display *d, uint32_t address);

/* Any word. */
void display_word(struct display *d, uint16_t word);

#endif
