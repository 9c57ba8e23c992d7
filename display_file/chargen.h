/* chargen.h — the character generator: codes to dots, control characters, shift-out.
 *
 *      cell time split into 48 slots: column 0 from the base line up, then column 1, …
 *      ●●·●····│·●······│ …          a dot is lit from the start of its slot
 *
 * Models:     6 × 8 dots of 2 × 2 units scanned by columns; advance 14, line feed 24 units; BS, LF,
 *             CR, SO, SI; descenders 4 units lower; italics (a slant of one unit in three).
 * Off screen: a character whose base line (12 units) is partly off screen is not drawn but
 *             advances; single dots off screen stay dark.
 * Pen:        no hits on the first and last columns. A hit lets the character finish, then stops
 *             the processor when its interrupt is enabled; RESUME draws the word's second
 *             character (assumed).
 * Time:       picoseconds: a printing code, space included, takes the cell; BS, LF and CR settle
 *             like moves; others take nothing beyond the fetch (assumed). A dot longer than its
 *             slot is cut to it.
 * Position:   head units.
 * Ownership:  works on the caller's struct df_dpu, allocates nothing.
 * Errors:     a bad shifted-out code raises the character interrupt.
 * Source:     DEC EK-VT11-TM-001.
 * Not modelled: the beam's way between the dots of a cell, which is dark.
 */
#ifndef DF_CHARGEN_H
#define DF_CHARGEN_H

#include "display_file/dpu.h"

#define DF_CHARACTER_ADVANCE 14
#define DF_LINE_FEED         24

/* Takes one code, 0–0177. May stop the processor: bad shifted-out code, pen. */
void df_chargen_code(struct df_dpu *dpu, unsigned code);

#endif
