/* piece.h — beam pieces: all that a tube ever receives.
 *
 *      drive 0…1 ──┐
 *                  ▼
 *      (x0,y0,t0) ●━━━━━━━━━━━━━━▶● (x1,y1,t1)      stroke: constant speed, constant drive
 *
 *      drive[gun][0 … dots-1]
 *      (x0,y0,t0) ●▔▁▔▔▁▁▁▔▁▔▔▔▁▁▶● (x1,y1,t1)      scan line: constant speed, a drive a dot
 *
 * Models:     one stretch of lit beam. A point is a stroke that stays put (x0 = x1, y0 = y1)
 *             from t0 to t1. Blanked moves are not pieces. A scan line is one sweep of a raster with
 *             the drive of each dot and gun; the dots divide time and way evenly.
 * Time:       picoseconds since power-on; t1 > t0. Pieces arrive in order of t0 and do not overlap.
 * Position:   tube millimetres from the screen centre, x right, y up (crt/geometry.h converts).
 * Drive:      0…1 of the grid's full drive, before front-panel knobs and the gun's power law,
 *             which belong to the tube (crt/spot.h).
 * Level:      of strokes on a penetration tube: the beam voltage, enum crt_level; other tubes have
 *             but one.
 * Source:     where the light came from: the display-file byte address of the word that drew it, or
 *             the scan line's number from the top of the picture.
 * A vector: three pieces, at rest where it starts, moving, at rest where it ends.
 * Ownership:  plain values, copied by whoever keeps them; the dots of a scan line, too.
 * Errors:     none here; the tube asserts the order (crt/tube.h), a reader of files refuses it.
 */
#ifndef CRT_PIECE_H
#define CRT_PIECE_H

#include <stdint.h>

/* Beam voltages of a penetration tube. */
enum crt_level {
    CRT_LEVEL_ONLY,
    CRT_LEVEL_RED,
    CRT_LEVEL_ORANGE,
    CRT_LEVEL_YELLOW,
    CRT_LEVEL_GREEN
};

struct crt_stroke {
    uint64_t t0, t1;      /* ps */
    float x0, y0, x1, y1; /* mm */
    float drive;          /* 0…1 */
    uint32_t source;      /* display-file byte address */
    uint32_t level;       /* enum crt_level */
};

#define CRT_MAX_GUNS 3
#define CRT_MAX_DOTS 8192

struct crt_scan_line {
    uint64_t t0, t1;      /* ps; the beam is lit from t0, where dot 0 begins, to t1 */
    float x0, y0, x1, y1; /* mm, where it is then, before convergence errors; y0 = y1 */
    int dots;             /* 1 … CRT_MAX_DOTS */
    int guns;             /* 1 or 3, as the tube has: red, green, blue */
    const uint8_t *drive[CRT_MAX_GUNS]; /* `dots` each: 255 = full drive */
    uint32_t source;                    /* scan line, from 0 at the top of the picture */
};

#endif
