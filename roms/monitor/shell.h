/* shell.h — what the monitor does with keys: the menu, the prompt, and the pages on the screen.
 *
 *      menu ◀─┬─▶ the last command's picture
 *             └─▶ transcript (Tab)
 *
 * Models:     one page at a time; the prompt is under each.
 * Ownership:  static storage.
 * Errors:     none; returns at the end of input.
 */
#ifndef ROMS_MONITOR_SHELL_H
#define ROMS_MONITOR_SHELL_H

#include "roms/monitor/monitor.h"

void shell_run(struct monitor *monitor);

#endif
