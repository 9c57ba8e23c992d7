/* main — a benchmark as firmware: prints its check sum and how many instructions it took. */
#include <stdio.h>

#include "roms/bench/kernel.h"
#include "roms/bsp/board.h"
#include "roms/bsp/csr.h"

int main(void)
{
    uint32_t before = csr_read_minstret();
    uint32_t sum = kernel_run();
    uint32_t after = csr_read_minstret();
    board_mark(1);
    printf("%s: check sum %08lx\n", kernel_name, (unsigned long)sum);
    if (board_is_knsc()) /* elsewhere the counter may count something else */
        printf("%lu instructions\n", (unsigned long)(after - before));
    return 0;
}
