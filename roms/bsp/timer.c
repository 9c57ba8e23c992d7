#include "roms/bsp/timer.h"

#include <assert.h>
#include <stddef.h>

#include "roms/bsp/interrupts.h"

static struct timer *first; /* armed timers, by due */

static volatile uint32_t *clint(uint32_t offset)
{
    return (volatile uint32_t *)(MAP_CLINT + offset);
}

uint64_t timer_now(void)
{
    for (;;) {
        uint32_t high = *clint(CLINT_MTIME + 4);
        uint32_t low = *clint(CLINT_MTIME);
        if (*clint(CLINT_MTIME + 4) == high)
            return (uint64_t)high << 32 | low;
    }
}

/* In an order that never asks for an earlier time than both the old one and the new. */
static void compare_with(uint64_t due)
{
    *clint(CLINT_MTIMECMP) = UINT32_MAX;
    *clint(CLINT_MTIMECMP + 4) = (uint32_t)(due >> 32);
    *clint(CLINT_MTIMECMP) = (uint32_t)due;
}

static void insert(struct timer *timer)
{
    struct timer **link = &first;
    while (*link != NULL && (*link)->due <= timer->due)
        link = &(*link)->next;
    timer->next = *link;
    *link = timer;
    timer->armed = true;
}

static void take_out(struct timer *timer)
{
    struct timer **link = &first;
    while (*link != NULL && *link != timer)
        link = &(*link)->next;
    if (*link != NULL)
        *link = timer->next;
    timer->armed = false;
}

static void next_interrupt(void)
{
    compare_with(first != NULL ? first->due : UINT64_MAX);
}

static void run_due(void)
{
    while (first != NULL && first->due <= timer_now()) {
        struct timer *timer = first;
        take_out(timer);
        if (timer->period != 0) {
            timer->due += timer->period;
            insert(timer);
        }
        timer->callback(timer->ctx);
    }
    next_interrupt();
}

static void arm(struct timer *timer, uint64_t delay, uint64_t period)
{
    uint32_t state = irq_lock();
    if (timer->armed)
        take_out(timer);
    timer->due = timer_now() + delay;
    timer->period = period;
    insert(timer);
    next_interrupt();
    irq_attach_timer(run_due);
    irq_unlock(state);
}

void timer_once(struct timer *timer, uint64_t delay)
{
    arm(timer, delay, 0);
}

void timer_every(struct timer *timer, uint64_t period)
{
    assert(period != 0);
    arm(timer, period, period);
}

void timer_stop(struct timer *timer)
{
    uint32_t state = irq_lock();
    if (timer->armed) {
        take_out(timer);
        next_interrupt();
    }
    irq_unlock(state);
}

static void wake(void *ctx)
{
    *(volatile bool *)ctx = true;
}

void timer_sleep(uint64_t delay)
{
    volatile bool over = false;
    struct timer timer = {.callback = wake, .ctx = (void *)&over};
    timer_once(&timer, delay);
    uint32_t state = irq_lock();
    while (!over)
        irq_wait();
    irq_unlock(state);
}
