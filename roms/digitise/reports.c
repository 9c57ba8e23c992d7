#include "roms/digitise/reports.h"

#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"

/* The report stays readable after it was taken until the next one comes: raw words come first. */
static void on_report(void *ctx)
{
    struct reports *r = ctx;
    struct report report;
    for (unsigned i = 0; i < TABLET_RAW_WORDS; i++)
        report.raw[i] = tablet_raw(i);
    if (!tablet_take(&report.tablet))
        return;
    report.us = (uint32_t)(timer_now() / (TIMER_HZ / 1000000));
    if (r->put - r->taken == REPORTS_MOST) {
        r->full = true;
        return;
    }
    report.tablet.lost |= r->full;
    r->full = false;
    r->waiting[r->put % REPORTS_MOST] = report;
    r->put++;
}

void reports_open(struct reports *r)
{
    *r = (struct reports){0};
    tablet_on(false);
    input_on(INPUT_BIT_TABLET, on_report, r);
}

bool reports_take(struct reports *r, struct report *out)
{
    uint32_t state = irq_lock(); /* a place that is given back is written over at once */
    bool any = r->taken != r->put;
    if (any)
        *out = r->waiting[r->taken++ % REPORTS_MOST];
    irq_unlock(state);
    return any;
}
