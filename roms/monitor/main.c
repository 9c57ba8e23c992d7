/* monitor — the terminal's own program: lessons, and a console language for all that they show.
 *
 *      kinescope run                                     the menu, in a window
 *      kinescope run roms/monitor.elf --headless --console < script
 *
 * It also runs on a board without heads, where it prints the same tables.
 */
#include <stdio.h>

#include "roms/bsp/console.h"
#include "roms/monitor/command.h"

int main(void)
{
    static struct monitor monitor;
    static char line[1024];
    stage_open(&monitor.stage);
    printf("kinescope monitor; \"help\" lists the commands.\n");
    for (;;) {
        printf("> ");
        if (console_line(line, sizeof line) < 0)
            return 0;
        command_line(&monitor, line);
    }
}
