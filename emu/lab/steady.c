#include "emu/lab/steady.h"

#include <math.h>

const char vm_steady_model[] =
    "Flicker: Farrell, Benson and Haynie (1987), 95 % of viewers who look straight at an evenly "
    "lit "
    "field; single lines on a dark screen flicker less. A refresh brings the same light however "
    "rarely it comes, so long lists are dimmer.";

/* No CFF is as high: 10⁵ cd/m² in the widest field have one below 250 Hz. */
#define TOO_FAST_HZ 1000.0

double vm_steady_luminance(const struct vm_steady *s, double hz)
{
    return s->held ? s->cd_m2 : s->cd_m2 * hz / s->at_hz;
}

bool vm_steady_flickers(const struct vm_steady *s, double hz)
{
    return crt_flickers(&s->viewer, vm_steady_luminance(s, hz), hz,
                        crt_glow_harmonic(&s->glow, hz, 1));
}

double vm_steady_free_hz(uint64_t ps)
{
    return (double)CRT_PS_PER_S / (double)ps;
}

double vm_steady_locked_hz(const struct vm_steady *s, uint64_t ps)
{
    uint64_t ticks = ps ? crt_tick_at(s->tick, ps - 1) + 1 : 1; /* the first not before its end */
    return crt_rate_hz(s->tick) / (double)ticks;
}

/* Above the least rate the CFF rises more slowly than the rate: one crossing. */
static double crossing(const struct vm_steady *s)
{
    double low = VM_STEADY_LEAST_HZ, high = TOO_FAST_HZ;
    if (!vm_steady_flickers(s, low))
        return low;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        if (vm_steady_flickers(s, middle))
            low = middle;
        else
            high = middle;
    }
    return high;
}

void vm_steady_find(struct vm_steady *s)
{
    double tick_hz = crt_rate_hz(s->tick);
    s->hz = crossing(s);
    s->longest = (uint64_t)((double)CRT_PS_PER_S / s->hz);
    s->ticks = (int)floor(tick_hz / s->hz);
    s->locked_ps = crt_tick_time(s->tick, (uint64_t)s->ticks);
}
