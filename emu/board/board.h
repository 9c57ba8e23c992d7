/* board.h — the computer around the processor: program memory, bus, console, timer, interrupts.
 *
 *                 ┌───────────────── bus ──────────────────┐
 *   rv ◀── memory │ finisher  CLINT  UART  irq  + the machine's ranges (DPU, display memory, …)
 *    ▲▲▲          └────┬───────┬──────┬─────┬──────────────┘
 *    ││└─ external ◀───│───────│──────│─────┘ ◀─ lines 1–8: one wire a device
 *    │└── timer, software ◀────┘      └─ line 8
 *    └─── attention ◀──┘ (the run is over)
 *
 * Models:     the half of the machine that has nothing to do with display. machine.c adds the other
 *             devices' ranges (bus_add) and wires (vm_irq_set) to it.
 * Time:       picoseconds since power-on. Cycle n of the processor begins at crt_tick_time(clock, n);
 *             an instruction begun at t comes after everything that devices do at t.
 * Use:        run the processor to vm_board_cycle(board, vm_board_next(board)), then
 *             vm_board_event(board, vm_board_next(board)). rv_run returns early (rv_attention) when an
 *             access moved vm_board_next, or ended the run (board->finisher.done).
 * Ownership:  vm_board_create allocates (16 MiB of program memory and the processor's cache, most of
 *             it never touched), vm_board_destroy frees.
 * Errors:     out of memory: NULL and a sentence. A wrong width or address is an access fault of the
 *             program. Snapshots are hostile: see vm_board_state.
 * Not modelled: bus contention; reset by the program.
 */
#ifndef EMU_BOARD_BOARD_H
#define EMU_BOARD_BOARD_H

#include "crt/error.h"
#include "crt/state.h"
#include "crt/ticks.h"
#include "emu/board/bus.h"
#include "emu/board/clint.h"
#include "emu/board/elf.h"
#include "emu/board/finisher.h"
#include "emu/board/irq.h"
#include "emu/board/uart.h"
#include "emu/cpu/rv.h"

#define VM_CPU_HZ 50000000

struct vm_board {
    struct rv_cpu cpu;
    struct crt_rate clock; /* of the processor */
    uint64_t period_ps;    /* of the clock where it is a whole number, else 0 */
    uint8_t *memory;       /* MAP_PROGRAM_SIZE bytes */
    struct bus bus;
    struct vm_uart uart;
    struct vm_clint clint;
    struct vm_irq irq;
    struct vm_finisher finisher;
};

/* `console` receives what the UART sends; NULL: nobody does. */
struct vm_board *vm_board_create(struct crt_rate clock, const struct vm_uart_out *console,
                                 struct crt_error *err);
void vm_board_destroy(struct vm_board *board);

/* Power-on with a program at t: clears program memory, resets processor and devices, copies the
 * segments, protects the read-only ones, sets pc to the entry. The cycle count goes on. */
void vm_board_load(struct vm_board *board, const struct vm_elf *elf, uint64_t t);

/* When the processor begins cycle n, and the first cycle that begins at or after t. */
uint64_t vm_board_time(const struct vm_board *board, uint64_t cycle);
uint64_t vm_board_cycle(const struct vm_board *board, uint64_t t);
/* Now, for devices: when the processor's present cycle begins. */
uint64_t vm_board_now(const struct vm_board *board);

/* When the timer or the UART next does something by itself; UINT64_MAX: never. */
uint64_t vm_board_next(const struct vm_board *board);
/* What they do up to t. */
void vm_board_event(struct vm_board *board, uint64_t t);

/* Everything of it that a snapshot holds, program memory too; what the machine has added is the
 * machine's. After loading, values are checked one by one and against each other; when that fails
 * the board is in no useful state, but safe to load again or to destroy. */
void vm_board_state(struct vm_board *board, struct crt_state *s);

#endif
