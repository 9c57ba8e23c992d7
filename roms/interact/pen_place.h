/* pen_place.h — where a light pen on the raster head looks, from where the beam was when it fired.
 *
 *      beam ──▶ comes into what the pen sees ──late──▶ pulse: dot, line ──▶ less `dots`, `lines`
 *
 * Models:     the beam goes on while the pen is late, and came in left of the middle: an offset, which
 *             roms/calibrate finds. A pulse just after the beam has left its row is found in blanking; one so
 *             late that the next row has begun belongs to the row before.
 * Units:      dots and lines of the mode that runs; stage units.
 * Ownership:  plain values.
 * Errors:     none: without a raster head the usual offset is 0. Places may lie beyond the picture.
 */
#ifndef ROMS_INTERACT_PEN_PLACE_H
#define ROMS_INTERACT_PEN_PLACE_H

#include "roms/stage/stage.h"

/* The pen of the raster head, unless calibration has said otherwise: how late it fires after the beam has come
 * into what it sees, and how large that is. What roms/calibrate finds with the figures of input/pen.h. */
#define PEN_LATE_NS 360
#define PEN_SEES_UM 4050

/* So many dots it is late, unless calibration has said otherwise. */
float pen_usual_dots(void);
/* `dots`, `lines`: how late the pen is; lines may be negative. */
struct point2 pen_place(const struct stage *stage, float dots, float lines, float line, float dot);

#endif
