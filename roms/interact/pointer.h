/* pointer.h — one place on the stage that the person points at, with whatever device is at hand.
 *
 *      tablet ─ touch panel ─ mouse ─ light pen ──reports──▶ queue ──▶ pointer: place, near, pressed,
 *                                                (interrupt)            what has just happened
 *
 * Models:     the locator and the button of graphics packages (GKS, ISO 7942), in one: the device used last
 *             has it. A tablet's surface is the picture: the largest part of it with the picture's shape,
 *             about its middle. A mouse moves the place by counts, 10 stage units a millimetre, and up to
 *             twice that when it is fast. A finger is where it touches, and pressed while it does. A light
 *             pen on the raster head is where it fires, corrected by what calibration found
 *             (pointer_calibrate); on the vector head it is where a tracking cross follows it
 *             (pointer_tracking.h).
 * Use:        once a retrace is often enough. Reports are taken from the devices by interrupt and wait in a
 *             queue, so a program that is busy drawing loses none:
 *
 *                  while (pointer_poll(&pointer))            menus, buttons: what has changed since
 *                      if (pointer.pressed_now) …
 *                  while (pointer_next(&pointer))            strokes: every report by itself
 *                      …
 *
 * Taps:       a press and its release between two polls are both told. In one poll the press comes first;
 *             whatever would be a second press waits for the next poll.
 * Taking over: a device takes the pointer when it is pressed, when it appears, or when it has moved by
 *             POINTER_MOVED; none takes it by moving while another is pressed.
 * Raster pen: it fires where the beam lights the screen: on black it sees nothing. A press there is told
 *             as soon as the pen sees light, if it does within POINTER_PATIENCE. pointer_pen_field is the
 *             remedy. Firings of a single field far from those before are not believed: room
 *             light makes such.
 * Units:      stage units (roms/stage/stage.h).
 * Ownership:  plain values; the stage must outlive it, and it must not move: it is the interrupt handlers'.
 * Errors:     devices that are not connected never point. When the queue is full, newer reports replace the
 *             last one in it, and `lost` tells.
 * Not modelled: several pointers at once.
 */
#ifndef ROMS_INTERACT_POINTER_H
#define ROMS_INTERACT_POINTER_H

#include <stdbool.h>

#include "raster/video_regs.h"
#include "roms/bsp/input.h"
#include "roms/bsp/timer.h"
#include "roms/geometry/vector.h"
#include "roms/interact/pen_rows.h"
#include "roms/stage/stage.h"

enum pointer_device { POINTER_NONE, POINTER_TABLET, POINTER_TOUCH, POINTER_MOUSE, POINTER_PEN };
enum { POINTER_DEVICES = POINTER_PEN + 1 };

enum {
    POINTER_MOVED = 24,               /* stage units by which a device takes over */
    POINTER_QUEUE = 64,               /* reports that wait */
    POINTER_FRESH_MS = 50,            /* a pen that has not fired for so long sees nothing */
    POINTER_PATIENCE_MS = 250,        /* how long a press of the pen's tip waits for light */
    POINTER_TRACKED = POINTER_DEVICES /* private: the pen on the vector head */
};

/* What a device said. x, y: tablet: counts; touch panel: micrometres; mouse: counts since its report
 * before; raster pen: dot, line of the beam, z its field. */
struct pointer_report {
    uint8_t device;
    bool placed; /* x, y are of now */
    bool near, pressed, lost;
    bool sure;    /* a firing that needs no other */
    bool tracked; /* pen on the vector head: place says where */
    unsigned buttons;
    int32_t x, y, z;
    struct point2 place;
    uint32_t since, time; /* ticks of the timer, modulo 2^32: report before (mouse), this one */
};

/* What is remembered of a device. */
struct pointer_seen {
    bool near, pressed;
    struct point2 at;
};

struct pointer {
    struct point2 at;           /* within the picture */
    enum pointer_device device; /* that was used last */
    bool near;                  /* the device is over the picture: a cursor is to be shown */
    bool pressed;               /* tip, finger, first button */
    /* Since the poll before: it was pressed, it was released, and where. */
    bool pressed_now, released_now;
    struct point2 pressed_at, released_at;
    unsigned buttons;             /* others: bit 1, 2, 3 */
    bool lost;                    /* reports were lost: a stroke may have a gap */
    struct pointer_report report; /* the last of the device that has the pointer */
    int32_t mouse_x, mouse_y;     /* counts in all */
    /* Private. */
    struct stage *stage;
    struct tablet_facts tablet;
    struct touch_facts touch;
    uint32_t mouse_nm;
    float pen_dots, pen_lines; /* what calibration found: subtracted from where the beam was */
    struct pointer_seen seen[POINTER_DEVICES + 1];
    /* The raster pen, as reports are taken. */
    struct point2 pen_at, pen_place; /* of the last firing; of the last that was believed */
    uint32_t pen_time, pen_seen;     /* when that was */
    int32_t pen_said[3];             /* x, y, z of its report */
    uint32_t pen_pushed;             /* when the tip was pressed that is not yet told of */
    bool follows; /* the tracking cross has the pen of the vector head (pointer_tracking.h) */
    bool pen_fired, pen_sees, pen_tip, pen_waits, pen_tap;
    /* Written by handlers. */
    struct pointer_report queue[POINTER_QUEUE];
    volatile unsigned put, taken; /* modulo 2^32 */
    bool overflow;
    unsigned mouse_buttons;
    uint32_t mouse_time;
    bool tip, fired; /* of the raster pen: pressed; ever */
    struct pen_rows rows;
    uint32_t fired_time;
    bool fired_blue; /* in a blue field */
    bool blue;       /* the field that is being shown is blue */
    unsigned rested;
    uint32_t colours[VIDEO_LUT_ENTRIES];
};

/* Switches every device on. */
void pointer_open(struct pointer *pointer, struct stage *stage);
/* Takes what the devices have reported; true when anything has changed. */
bool pointer_poll(struct pointer *pointer);
/* Takes one report, the oldest; false: there is none. */
bool pointer_next(struct pointer *pointer);
/* The pen on the raster head fires so many dots and lines late (roms/calibrate); lines may be negative. */
void pointer_calibrate(struct pointer *pointer, float dots, float lines);
/* Where the pen on the raster head is when it fires while the beam is there. */
struct point2 pointer_pen_point(const struct pointer *pointer, float line, float dot);
/* The pen on the vector head is there, for whoever tracks it; may be called in a handler. */
void pointer_pen_place(struct pointer *pointer, struct point2 at, bool near, bool pressed);
/* On: while the tip is pressed and the pen sees nothing, the screen is shown wholly blue for a single
 * field every now and then, and the pen is found, whatever the picture. The look-up table changes in the
 * retraces before and after, pixels and pages do not. It has the retrace handler (video_on_retrace);
 * entries that a program changes during the blue field are lost. */
void pointer_pen_field(struct pointer *pointer, bool on);

/* For pointer_devices.c and pointer_field.c. */
void pointer_listen(struct pointer *pointer);
void pointer_push(struct pointer *pointer, const struct pointer_report *report);
void pointer_settle(struct pointer *pointer);

#endif
