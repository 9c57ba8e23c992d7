/* tables — prints what the processor's instructions give: integers, memory, control registers, floats
 * in all rounding modes with their flags, and the C library's functions of them.
 *
 * It uses nothing but the console, so another board must print the same bytes:
 *
 *      kinescope run roms/tables.elf --headless --console
 *      qemu-system-riscv32 -M virt -bios none -nographic -cpu rv32,c=false,d=false \
 *          -kernel roms/tables.elf
 */
#include <stdio.h>

#include "roms/bsp/board.h"
#include "roms/tables/tables.h"

int main(void)
{
    tables_integers();
    board_mark(1);
    tables_memory();
    board_mark(2);
    tables_control();
    board_mark(3);
    tables_floats();
    board_mark(4);
    tables_functions();
    board_mark(5);
    printf("end of tables\n");
    return 0;
}
