/* Control and status registers: what a write leaves, and that counters count. */
#include <stdio.h>

#include "roms/bsp/csr.h"
#include "roms/tables/tables.h"

#define EXCHANGE(name, instruction, value)                                                         \
    do {                                                                                           \
        uint32_t before, after;                                                                    \
        __asm__ volatile(instruction " %0, " #name ", %2; csrr %1, " #name                         \
                         : "=&r"(before), "=&r"(after)                                             \
                         : "r"(value));                                                            \
        printf("%-9s %-6s %08lx: %08lx then %08lx\n", #name, instruction, (unsigned long)(value),  \
               (unsigned long)before, (unsigned long)after);                                       \
    } while (0)

static void exchanges(void)
{
    uint32_t kept = csr_read_mscratch();
    csr_write_mscratch(0x12345678);
    EXCHANGE(mscratch, "csrrw", 0xFFFF0000u);
    EXCHANGE(mscratch, "csrrs", 0x000000FFu);
    EXCHANGE(mscratch, "csrrc", 0x0F0F0F0Fu);
    csr_write_mscratch(kept);
    csr_write_fcsr(0);
    EXCHANGE(fcsr, "csrrw", 0x000000F5u);
    EXCHANGE(fflags, "csrrc", 0x00000004u);
    EXCHANGE(frm, "csrrw", 0x00000003u);
    EXCHANGE(fcsr, "csrrs", 0xFFFFFF08u);
    csr_write_fcsr(0);
}

static void counters(void)
{
    uint32_t first = csr_read_minstret();
    uint32_t second = csr_read_minstret();
    printf("minstret %s\n", second - first - 1 < 1000000 ? "counts" : "does not count");
}

void tables_control(void)
{
    printf("control registers\n");
    exchanges();
    counters();
}
