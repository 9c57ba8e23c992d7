/* pointer.h — one place on the stage that the person points at, with whatever device is at hand.
 *
 *      tablet ─ touch panel ─ mouse ─ light pen ─▶ pointer: place, near, pressed, what has just happened
 *
 * Models:     the locator and the button of graphics packages (GKS, ISO 7942), in one: the device used last
 *             has it. A tablet's surface is the picture, as large as fits; a mouse moves the place by counts;
 *             a finger is where it touches, and pressed while it does; a light pen on the raster head is
 *             where it fires, corrected by what calibration found (pointer_calibrate), on the vector head
 *             where a tracking cross follows it.
 * Units:      stage units (roms/stage/stage.h).
 * Ownership:  plain values; the stage must outlive it.
 * Errors:     devices that are not connected never point.
 * Not modelled: several pointers at once.
 */
#ifndef ROMS_INTERACT_POINTER_H
#define ROMS_INTERACT_POINTER_H

#include <stdbool.h>

#include "roms/bsp/input.h"
#include "roms/geometry/vector.h"
#include "roms/stage/stage.h"

enum pointer_device { POINTER_NONE, POINTER_TABLET, POINTER_TOUCH, POINTER_MOUSE, POINTER_PEN };

struct pointer {
    struct point2 at;           /* within the picture */
    enum pointer_device device; /* that was used last */
    bool near;                  /* the device is over the picture: a cursor is to be shown */
    bool pressed;               /* tip, finger, first button */
    /* Since the poll before: it was pressed, it was released. A short tap is both. */
    bool pressed_now, released_now;
    unsigned buttons; /* others: bit 1, 2, 3 */
    bool lost;        /* reports were lost: a stroke may have a gap */
    /* Private. */
    struct stage *stage;
    float mouse_x, mouse_y;
    float pen_dots, pen_lines; /* what calibration found: subtracted from where the beam was */
};

/* Switches every device on. */
void pointer_open(struct pointer *pointer, struct stage *stage);
/* Takes what the devices have reported; true when anything has changed. Reports come 30 to 60 times a
 * second: poll as often. */
bool pointer_poll(struct pointer *pointer);
/* The pen on the raster head fires so many dots and lines late (roms/calibrate). */
void pointer_calibrate(struct pointer *pointer, float dots, float lines);

#endif
