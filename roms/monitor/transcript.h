/* transcript.h — what the console said last, for those who look at the screen.
 *
 *      printf ──▶ stdout ──┬──▶ console (roms/bsp/console.h)
 *                          └──▶ the last lines ──transcript_draw──▶ a page on the stage
 *
 * Models:     the last TRANSCRIPT_KEPT lines of TRANSCRIPT_WIDTH characters, TRANSCRIPT_LINES a page; longer
 *             lines are broken, where they can at a blank.
 * Ownership:  static storage; this file defines the C library's standard streams for the monitor.
 * Errors:     none.
 */
#ifndef ROMS_MONITOR_TRANSCRIPT_H
#define ROMS_MONITOR_TRANSCRIPT_H

#include "roms/stage/stage.h"

enum { TRANSCRIPT_KEPT = 300, TRANSCRIPT_LINES = 28, TRANSCRIPT_WIDTH = 72 };

/* What is to be seen there though it was not printed: what was typed. */
void transcript_add(const char *text);
/* Lines that were ended since power-on. */
unsigned transcript_count(void);
/* A page, between stage_begin and stage_end: that of the last lines, or so many pages before. Returns how
 * many there are before that of the last lines. */
unsigned transcript_draw(struct stage *stage, unsigned back);

#endif
