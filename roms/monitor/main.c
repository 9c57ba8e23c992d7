/* monitor — the terminal's own program: lessons, and a console language for all that they show.
 *
 *      kinescope run                                     the menu, in a window
 *      kinescope run --headless --console < script
 *
 * It also runs on a board without heads, where it prints the same tables.
 */
#include <stdio.h>

#include "roms/monitor/shell.h"

/* The vector head's tube, unless another is asked for: things move here, and P39 glows on for long. */
extern const char kinescope_tube[];
const char kinescope_tube[] = "VR17/P31";

int main(void)
{
    static struct monitor monitor;
    stage_open(&monitor.stage);
    printf("kinescope monitor; \"help\" lists the commands.\n");
    shell_run(&monitor);
    return 0;
}
