/* board.h — which board the program is on, what the board knows, and the way out.
 *
 *      0x4005_0000 identity ──▶ KNSC: heads, entry, clock, ticks ◀── marks, begins of refreshes
 *                          └──▶ anything else: a board with a console and a timer, no heads
 *
 * Models:     the identity registers and the test finisher (emu/memmap.h).
 * Units:      ticks: of the head's sync. Clock: Hz.
 * Ownership:  nothing.
 * Errors:     on a board without heads every function works all the same: no entry, no ticks, and
 *             nobody takes the marks.
 * Source:     emu/memmap.h.
 */
#ifndef ROMS_BSP_BOARD_H
#define ROMS_BSP_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#define BOARD_NO_ENTRY 0xFFFFFFFFu

/* True where the memory map is kinescope's; false on QEMU's "virt" board, for one. */
bool board_is_knsc(void);
bool board_has_vector_head(void);
bool board_has_raster_head(void);
/* The version of the memory map; 0 on another board. */
uint32_t board_version(void);
/* The nominal clock of the processor; 0: not known. */
uint32_t board_clock_hz(void);

/* Where the display file starts that was loaded beside the program; BOARD_NO_ENTRY: none was. */
uint32_t board_entry(void);
/* Sync ticks since power-on, modulo 2^32; 0 without a head. */
uint32_t board_ticks(void);

/* Tells who observes that this point of the program is reached. */
void board_mark(uint32_t number);
/* Tells that a refresh begins. Once told, the machine counts refreshes by this alone. */
void board_refresh(uint32_t number);

/* Ends the program: 0 is success; other statuses are told by their low 8 bits, 255 where those
 * are 0. exit() comes here. */
_Noreturn void board_exit(int status);

#endif
