/* monitor — the terminal's own program: lessons, and a console language for all that they show.
 *
 *      kinescope run                                     the menu, in a window
 *      kinescope run --headless --console < script
 *
 * It also runs on a board without heads, where it prints the same tables.
 */
#include <stdio.h>

#include "roms/monitor/shell.h"

int main(void)
{
    static struct monitor monitor;
    stage_open(&monitor.stage);
    printf("kinescope monitor; \"help\" lists the commands.\n");
    shell_run(&monitor);
    return 0;
}
