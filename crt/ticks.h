/* ticks.h — simulated time and the sync ticks of a head.
 *
 * Models:     a clock of exactly num/den ticks a second that ticks first at time 0.
 * Time:       uint64_t picoseconds since power-on (213 days fit).
 * Method:     the time of tick n is floor(n · 10^12 · den / num), from the count by a 128-bit
 *             product, never by adding rounded periods, so no error accumulates.
 * Errors:     a rate with num == 0 or den == 0 asserts.
 */
#ifndef CRT_TICKS_H
#define CRT_TICKS_H

#include <stdint.h>

#define CRT_PS_PER_S  UINT64_C(1000000000000)
#define CRT_PS_PER_MS UINT64_C(1000000000)
#define CRT_PS_PER_US UINT64_C(1000000)

/* num/den ticks a second, e.g. {60, 1} or {60000, 1001}. */
struct crt_rate {
    uint64_t num, den;
};

/* The rate as a number, Hz; for people, never for times. */
double crt_rate_hz(struct crt_rate rate);

/* Time of tick n, ps. */
uint64_t crt_tick_time(struct crt_rate rate, uint64_t n);

/* The greatest n whose tick has happened at or before time t: crt_tick_time(n) <= t. */
uint64_t crt_tick_at(struct crt_rate rate, uint64_t t);

#endif
