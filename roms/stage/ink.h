/* ink.h — colours that lessons draw with, on heads that have colours and on one that has none.
 *
 *      enum ink ──▶ raster head: an entry of the look-up table
 *             └──▶ vector head: one of eight intensities
 *
 *      entries 0…15: inks; from 16 on: INK_RAMPS ramps of INK_LEVELS shades each
 *
 * Models:     a fixed palette of 256 entries for pixels of 8 bits.
 * Units:      intensities of light 0…1, linear; ink_rgb: what a look-up table takes, 0x00RRGGBB.
 * Ownership:  plain values.
 * Errors:     none; intensities beyond 0…1 are moved to the end.
 * Source:     chosen for this project. Entries of ramps undo a tube's power law of 2.4 (estimate; tubes
 *             differ), so that equal steps of intensity are equal steps of luminance.
 * Not modelled: pixels of fewer bits: raster/dither.h shows what remains there.
 */
#ifndef ROMS_STAGE_INK_H
#define ROMS_STAGE_INK_H

#include <stdint.h>

enum ink {
    INK_BLACK,
    INK_GRID, /* rules, axes, what is behind */
    INK_TEXT,
    INK_BRIGHT,
    INK_RED,
    INK_ORANGE,
    INK_YELLOW,
    INK_GREEN,
    INK_CYAN,
    INK_BLUE,
    INK_VIOLET,
    INK_BROWN,
    INK_COUNT
};

enum ink_ramp { RAMP_GREY, RAMP_COPPER, RAMP_GREEN, RAMP_BLUE, RAMP_GOLD, INK_RAMPS };
enum { INK_LEVELS = 48, INK_ENTRIES = 256 };

/* What the entry of the look-up table is to hold. */
uint32_t ink_rgb(unsigned entry);
/* The entry of a shade: intensity 0…1. */
uint32_t ink_shade(enum ink_ramp ramp, float intensity);
/* The intensity on the vector head, 0…7; of shades (ink_shade), too. */
unsigned ink_intensity(enum ink ink);

#endif
