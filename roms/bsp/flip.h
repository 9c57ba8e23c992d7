/* flip.h — a moving picture without tearing: a still part, and a moving one in two places.
 *
 *      still:  sync, words that stay, jump ─┐          A is shown: B may be written
 *        ▲                       address ───┴▶ A ─┐    one store to the jump's address shows B
 *        └──────────────────────── jump ◀─────────┘
 *
 * Models:     a display file that the display processor goes through all the time. Whatever the
 *             moment of the store, a refresh shows A or B whole.
 * Time:       a place that was shown may be written again when the display processor has left it.
 * Units:      display addresses, bytes.
 * Ownership:  plain value; display memory from `low` to `low` + FLIP_BYTES is its own.
 * Errors:     a picture that does not fit is cut off (display.h).
 * Source:     as programs of the time did it: the address of a jump is one word.
 */
#ifndef ROMS_BSP_FLIP_H
#define ROMS_BSP_FLIP_H

#include <stdbool.h>
#include <stdint.h>

#include "roms/bsp/display.h"

#define FLIP_STILL  0x4000u /* bytes for the still part */
#define FLIP_MOVING 0x2000u /* bytes for each moving one */
#define FLIP_BYTES  (FLIP_STILL + 2 * FLIP_MOVING)

struct flip {
    uint32_t low;
    uint32_t patch; /* where the jump's address is */
    int shown;      /* 0 or 1: the moving part that the jump leads to */
};

/* Begins the still part, which waits for the sync tick first; draw it with the writer. */
struct display flip_begin(struct flip *flip, uint32_t low);
/* Ends it, with an empty moving part, and starts the display processor. */
void flip_start(struct flip *flip, struct display *still);

/* False while the display processor is in the part that is not shown: try again later. Else begins
 * that part anew. */
bool flip_draw(const struct flip *flip, struct display *moving);
/* Ends it and shows it from now on. */
void flip_show(struct flip *flip, struct display *moving);

#endif
