/* prompt.h — the line under every picture; private to the stage.
 *
 * Models:     on the raster head the lowest row of text of both pages; on the vector head characters in the
 *             part of the display file that every refresh goes through.
 * Ownership:  nothing.
 * Errors:     none; without a head nothing is shown.
 */
#ifndef ROMS_STAGE_PROMPT_H
#define ROMS_STAGE_PROMPT_H

#include "roms/stage/stage.h"

/* Writes the words of an empty prompt; where its characters are. */
uint32_t stage_prompt_begin(struct display *d);
/* The present prompt onto a page. */
void stage_prompt_draw(const struct stage *stage, const struct canvas *page);

#endif
