/* hand.h — what the host's mouse stands for in the window.
 *
 *      F9:  light pen ─▶ stylus ─▶ finger ─▶ mouse ─▶ …      those that are connected
 *
 * A program may say what it is made for: firmware by the text at the symbol kinescope_hand (const char
 * kinescope_hand[] = "stylus"). Else a stylus for firmware, a light pen for a display file.
 *
 * The tablet lies beside the screen, so which place on it stands for which on the screen is the program's
 * affair. Firmware may say it, by the text at the symbol kinescope_tablet: left, bottom, width, height of the
 * picture that the tablet stands for, on the raster head, then on the vector head, in 1024ths of the screen's
 * addressable width from its lower left corner. The picture lies in the middle of the tablet, as large as
 * fits. Else it is the whole screen.
 *
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef EMU_HAND_H
#define EMU_HAND_H

#include "emu/heads.h"
#include "input/setup.h"

enum vm_hand { VM_HAND_PEN, VM_HAND_STYLUS, VM_HAND_FINGER, VM_HAND_MOUSE, VM_HANDS };

/* "pen", "stylus", "finger", "mouse"; VM_HANDS: none of them. */
enum vm_hand vm_hand_of_name(const char *name);
/* "light pen", "stylus on the tablet" … */
const char *vm_hand_title(enum vm_hand hand);
/* Whether its device is connected. */
bool vm_hand_present(enum vm_hand hand, const struct inp_setup *setup);

/* Millimetres, on the screen from its middle. */
struct vm_hand_picture {
    double x, y, width, height; /* x, y: of its middle */
};
/* What the text at kinescope_tablet says of a head; the whole screen when it says nothing that can be used. */
struct vm_hand_picture vm_hand_picture(const char *text, enum vm_head head, double width,
                                       double height);
/* A place on the screen as one on the tablet: never beyond the tablet's rim. */
void vm_hand_on_tablet(const struct vm_hand_picture *picture, const struct inp_tablet_setup *tablet,
                       double *x, double *y);

#endif
