/* steady.h — from which refresh rate on a picture does not flicker for a viewer, and how long its refresh
 * may take then.
 *
 *      each refresh brings the same light ─▶ the mean luminance falls with the rate
 *
 * Models:     crt/flicker.h. Luminance is that at a rate (a tube's line_luminance at line_refresh) and goes
 *             with the rate, unless it is held by turning up the brightness.
 * Time:       picoseconds; Hz.
 * Ownership:  plain values.
 * Errors:     none.
 * Not modelled: rates below VM_STEADY_LEAST_HZ, where the model of flicker does not hold.
 */
#ifndef EMU_LAB_STEADY_H
#define EMU_LAB_STEADY_H

#include "crt/flicker.h"
#include "crt/ticks.h"

#define VM_STEADY_LEAST_HZ 12.0

struct vm_steady {
    struct crt_viewer viewer;
    struct crt_glow glow;
    double cd_m2, at_hz;
    bool held; /* the luminance is cd_m2 at every rate */
    struct crt_rate tick;
    /* filled in by vm_steady_find */
    double hz;          /* the lowest rate that does not flicker, at least VM_STEADY_LEAST_HZ */
    uint64_t longest;   /* ps: a refresh of that rate */
    int ticks;          /* the most ticks a locked refresh may take; 0: flickers even at one */
    uint64_t locked_ps; /* those */
};

/* What it is of, a sentence or two. */
extern const char vm_steady_model[];

void vm_steady_find(struct vm_steady *s);

double vm_steady_luminance(const struct vm_steady *s, double hz);
bool vm_steady_flickers(const struct vm_steady *s, double hz);
/* Of a refresh that takes so long: without waiting; waiting for the tick. */
double vm_steady_free_hz(uint64_t ps);
double vm_steady_locked_hz(const struct vm_steady *s, uint64_t ps);

#endif
