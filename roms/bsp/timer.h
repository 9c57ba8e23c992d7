/* timer.h — the time, and functions to be called at a time.
 *
 *      armed timers, soonest first ──▶ mtimecmp ──interrupt──▶ callback(ctx)
 *
 * Models:     any number of timers, once or periodic, on the one of the processor.
 * Time:       ticks of mtime, TIMER_HZ a second, since power-on. A periodic timer does not drift:
 *             its n-th call is due n periods after its start, however late others were.
 * Ownership:  the caller's struct is linked into a list while it is armed.
 * Errors:     a period of 0 asserts.
 * Source:     emu/memmap.h (CLINT).
 * Not modelled: priorities: callbacks run with interrupts off, one after the other.
 */
#ifndef ROMS_BSP_TIMER_H
#define ROMS_BSP_TIMER_H

#include <stdbool.h>
#include <stdint.h>

#include "emu/memmap.h"

#define TIMER_HZ CLINT_HZ

struct timer {
    void (*callback)(void *ctx);
    void *ctx;
    /* Set by the functions below. */
    uint64_t due, period; /* period 0: once */
    struct timer *next;
    bool armed;
};

/* Ticks since power-on. */
uint64_t timer_now(void);

/* Calls timer->callback `delay` ticks from now; arms anew when it was armed. */
void timer_once(struct timer *timer, uint64_t delay);
/* … and then every `period` ticks, the first time one period from now. */
void timer_every(struct timer *timer, uint64_t period);
void timer_stop(struct timer *timer);

/* Waits; interrupts are taken meanwhile. Not within irq_lock or a handler. */
void timer_sleep(uint64_t delay);

#endif
