#include "roms/bsp/board.h"

#include "emu/memmap.h"
#include "roms/bsp/console.h"

static volatile uint32_t *identity(uint32_t offset)
{
    return (volatile uint32_t *)(MAP_IDENTITY + offset);
}

bool board_is_knsc(void)
{
    return *identity(IDENTITY_MAGIC) == IDENTITY_KNSC;
}

/* What the register holds, or `otherwise` on another board. */
static uint32_t ask(uint32_t offset, uint32_t otherwise)
{
    return board_is_knsc() ? *identity(offset) : otherwise;
}

static void tell(uint32_t offset, uint32_t value)
{
    if (board_is_knsc())
        *identity(offset) = value;
}

bool board_has_vector_head(void)
{
    return ask(IDENTITY_HEADS, 0) & 1;
}

bool board_has_raster_head(void)
{
    return ask(IDENTITY_HEADS, 0) & 2;
}

uint32_t board_version(void)
{
    return ask(IDENTITY_VERSION, 0);
}

uint32_t board_clock_hz(void)
{
    return ask(IDENTITY_CLOCK, 0);
}

uint32_t board_entry(void)
{
    return ask(IDENTITY_ENTRY, BOARD_NO_ENTRY);
}

uint32_t board_ticks(void)
{
    return ask(IDENTITY_TICK, 0);
}

void board_mark(uint32_t number)
{
    tell(IDENTITY_MARK, number);
}

void board_refresh(uint32_t number)
{
    tell(IDENTITY_REFRESH, number);
}

void board_exit(int status)
{
    volatile uint32_t *finisher = (volatile uint32_t *)MAP_FINISHER;
    uint32_t code = (uint32_t)status & 0xFF;
    if (status != 0 && code == 0)
        code = 0xFF;
    console_drain(); /* what is still being sent would be lost */
    *finisher = code == 0 ? FINISHER_PASS : code << 16 | FINISHER_FAIL;
    for (;;)
        __asm__ volatile("wfi");
}

/* The C library's exit() and abort() end here. */
_Noreturn void _exit(int status);
void _exit(int status)
{
    board_exit(status);
}
