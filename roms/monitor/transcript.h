/* transcript.h — what the console said last, for those who look at the screen.
 *
 *      printf ──▶ stdout ──┬──▶ console (roms/bsp/console.h)
 *                          └──▶ the last lines ──transcript_draw──▶ a page on the stage
 *
 * Models:     TRANSCRIPT_LINES lines of TRANSCRIPT_WIDTH characters; longer ones are broken.
 * Ownership:  static storage; this file defines the C library's standard streams for the monitor.
 * Errors:     none.
 */
#ifndef ROMS_MONITOR_TRANSCRIPT_H
#define ROMS_MONITOR_TRANSCRIPT_H

#include "roms/stage/stage.h"

enum { TRANSCRIPT_LINES = 30, TRANSCRIPT_WIDTH = 72 };

/* What is to be seen there though it was not printed: what was typed. */
void transcript_add(const char *text);
/* Lines that were ended since power-on. */
unsigned transcript_count(void);
/* A page with the last lines, between stage_begin and stage_end. */
void transcript_draw(struct stage *stage);

#endif
