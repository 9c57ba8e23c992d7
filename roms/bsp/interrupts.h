/* interrupts.h — who is called when a line of the interrupt controller rises, or the timer is due.
 *
 *      device ──line──▶ controller ──claim──▶ irq_external ──▶ the line's handler
 *      mtime >= mtimecmp ───────────────────▶ irq_timer ─────▶ the timer's handler (timer.h)
 *
 * Models:     one handler a line, called with interrupts off; critical sections; waiting.
 * Time:       lines are levels: a handler must make its device drop the line, or disable it, or
 *             it is called again at once.
 * Ownership:  contexts belong to the caller.
 * Errors:     lines that do not exist are ignored. On a board that is not KNSC lines never rise; the
 *             timer works. Exceptions end the program (trap.S).
 * Source:     emu/memmap.h.
 */
#ifndef ROMS_BSP_INTERRUPTS_H
#define ROMS_BSP_INTERRUPTS_H

#include <stdint.h>

/* Calls handler(ctx) while the line (IRQ_LINE_…) is high, from now on. */
void irq_attach(unsigned line, void (*handler)(void *ctx), void *ctx);
void irq_enable(unsigned line);
void irq_disable(unsigned line);

/* Calls `handler` while the timer is due, from now on. */
void irq_attach_timer(void (*handler)(void));

/* Between them no interrupt is taken. They nest: irq_unlock gets what irq_lock returned. */
uint32_t irq_lock(void);
void irq_unlock(uint32_t state);

/* Within irq_lock: waits for an interrupt and takes it. To wait for what a handler does:
 *
 *      uint32_t state = irq_lock();
 *      while (!done)
 *          irq_wait();
 *      irq_unlock(state);
 */
void irq_wait(void);

/* Called by trap.S only. */
void irq_timer(void);
void irq_external(void);
_Noreturn void irq_exception(void);

#endif
