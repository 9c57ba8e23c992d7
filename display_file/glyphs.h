/* glyphs.h — the dot patterns of the character generator: 6 × 8 dots a character, our own design.
 *
 *      column  0 1 2 3 4 5
 *      bit 7   · · · · · ·    top row
 *       …
 *      bit 0   · · · · · ·    base line
 *
 * Models:     one pattern a code. A glyph that descends is drawn with its origin two dots (4 units)
 *             lower.
 * Codes:      040–0177 are the 96 ASCII characters (0177 is a filled block); with shift-out 0–037
 *             except 017 are 31 special characters: Greek letters, arrows, mathematics.
 * Units:      dots. Also used for text over the glass.
 * Ownership:  constant data.
 * Errors:     NULL for a code without a glyph.
 * Source:     code assignment after DEC EK-VT11-TM-001; the drawings are ours.
 * Not modelled: DEC's own dot patterns.
 */
#ifndef DF_GLYPHS_H
#define DF_GLYPHS_H

#include <stdbool.h>
#include <stdint.h>

#define DF_GLYPH_COLUMNS 6
#define DF_GLYPH_ROWS    8

struct df_glyph {
    uint8_t column[DF_GLYPH_COLUMNS]; /* bit 7 = top row, bit 0 = base line */
    bool descends;
};

/* The glyph of an ASCII code 040–0177; NULL for others. */
const struct df_glyph *df_glyph_ascii(unsigned code);

/* The glyph of a shifted-out code 0–037; NULL for 017 and others. */
const struct df_glyph *df_glyph_special(unsigned code);

/* The special character's name, for listings ("lambda"); NULL as above. */
const char *df_glyph_special_name(unsigned code);

#endif
