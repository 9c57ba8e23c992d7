/* hello — the console: says where it is, then says again what is typed, until control-D.
 *
 *      kinescope run roms/hello.elf --console
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"

static void introduce(void)
{
    printf("Hello from kinescope's firmware.\n");
    if (!board_is_knsc()) {
        printf("This board is not a kinescope: no heads here.\n");
        return;
    }
    printf("Memory map %lu, processor at %lu MHz, vector head: %s, raster head: %s.\n",
           (unsigned long)board_version(), (unsigned long)board_clock_hz() / 1000000,
           board_has_vector_head() ? "yes" : "no", board_has_raster_head() ? "yes" : "no");
    if (board_entry() != BOARD_NO_ENTRY)
        printf("A display file is loaded; it starts at %06lo.\n", (unsigned long)board_entry());
}

int main(void)
{
    char line[80];
    introduce();
    printf("Type lines; control-D ends.\n");
    while (console_line(line, sizeof line) >= 0)
        printf("You typed: %s\n", line);
    printf("Bye.\n");
    return 0;
}
