/* piece.h — beam pieces: all that a tube ever receives.
 *
 *      drive 0…1 ──┐
 *                  ▼
 *      (x0,y0,t0) ●━━━━━━━━━━━━━━▶● (x1,y1,t1)      constant speed, constant drive
 *
 * Models:     one stretch of lit beam. A point is a stroke that stays put (x0 = x1, y0 = y1)
 *             from t0 to t1. Blanked moves are not pieces.
 * Time:       picoseconds since power-on; t1 > t0. Pieces arrive in order of t0 and do not overlap.
 * Position:   tube millimetres from the screen centre, x right, y up (crt/geometry.h converts).
 * Drive:      0…1 of the grid's full drive, before front-panel knobs and the gun's power law,
 *             which belong to the tube (crt/spot.h).
 * Source:     where the light came from: the display-file byte address of the word that drew it.
 * A vector: three pieces, at rest where it starts, moving, at rest where it ends.
 * Ownership:  plain values, copied by whoever keeps them.
 * Errors:     none here; the tube asserts the order (crt/tube.h), a reader of files refuses it.
 * Not modelled here: scan lines (many drive samples a piece) and beam voltage.
 */
#ifndef CRT_PIECE_H
#define CRT_PIECE_H

#include <stdint.h>

struct crt_stroke {
    uint64_t t0, t1;      /* ps */
    float x0, y0, x1, y1; /* mm */
    float drive;          /* 0…1 */
    uint32_t source;      /* display-file byte address */
};

#endif
