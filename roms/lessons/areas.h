/* areas.h — the pages of the lesson about areas; private to roms/lessons/areas*.c.
 *
 * Models:     each draws the whole picture for so many seconds after it began.
 * Units:      seconds; stage units.
 * Ownership:  nothing is kept but what the seconds tell.
 * Errors:     none; without a head nothing is shown.
 */
#ifndef ROMS_LESSONS_AREAS_H
#define ROMS_LESSONS_AREAS_H

#include "roms/stage/stage.h"

void areas_scan_lines(struct stage *stage, float seconds);
void areas_rules(struct stage *stage, float seconds);
void areas_spreading(struct stage *stage, float seconds);
void areas_leak(struct stage *stage, float seconds);
void areas_attributes(struct stage *stage, float seconds);

#endif
