/* lesson_run.h — runs a lesson until somebody leaves it.
 *
 * Models:     keys and time for one lesson (roms/lessons/lesson.h).
 * Errors:     none. After the end of input it runs on where there is a head to look at, so that a capture can
 *             show any moment of it; elsewhere it is left.
 */
#ifndef ROMS_MONITOR_LESSON_RUN_H
#define ROMS_MONITOR_LESSON_RUN_H

#include "roms/lessons/lesson.h"
#include "roms/monitor/monitor.h"

void lesson_run(struct monitor *monitor, const struct lesson *lesson);

#endif
