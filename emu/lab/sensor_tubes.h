/* sensor_tubes.h — the tube of a head that only a photodiode looks at.
 *
 * Models:     a tube with a few cells about the place: a diode opened at power-on sees all pieces by itself, so
 *             that planes need not be paid for. A machine that is loaded or saved has its whole tubes.
 * Units:      mm from the screen centre.
 * Ownership:  plain values; settings must outlive them.
 * Errors:     none.
 */
#ifndef EMU_LAB_SENSOR_TUBES_H
#define EMU_LAB_SENSOR_TUBES_H

#include "emu/settings.h"

struct vm_tubes vm_sensor_tubes(const struct vm_settings *settings, enum vm_head head, double x_mm,
                                double y_mm);

#endif
