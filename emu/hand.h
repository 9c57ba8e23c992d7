/* hand.h — what the host's mouse stands for in the window.
 *
 *      F9:  light pen ─▶ stylus ─▶ finger ─▶ mouse ─▶ …      those that are connected
 *
 * A program may say what it is made for: firmware by the text at the symbol kinescope_hand (const char
 * kinescope_hand[] = "stylus"). Else a stylus for firmware, a light pen for a display file.
 *
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef EMU_HAND_H
#define EMU_HAND_H

#include "input/setup.h"

enum vm_hand { VM_HAND_PEN, VM_HAND_STYLUS, VM_HAND_FINGER, VM_HAND_MOUSE, VM_HANDS };

/* "pen", "stylus", "finger", "mouse"; VM_HANDS: none of them. */
enum vm_hand vm_hand_of_name(const char *name);
/* "light pen", "stylus on the tablet" … */
const char *vm_hand_title(enum vm_hand hand);
/* Whether its device is connected. */
bool vm_hand_present(enum vm_hand hand, const struct inp_setup *setup);

#endif
