#include "crt/ticks.h"

#include <assert.h>

/* 128-bit integers are a compiler extension; __extension__ keeps -Wpedantic quiet about it. */
__extension__ typedef unsigned __int128 u128;

uint64_t crt_tick_time(struct crt_rate rate, uint64_t n)
{
    assert(rate.num > 0 && rate.den > 0);
    return (uint64_t)((u128)n * CRT_PS_PER_S * rate.den / rate.num);
}

uint64_t crt_tick_at(struct crt_rate rate, uint64_t t)
{
    assert(rate.num > 0 && rate.den > 0);
    /* tick_time(n) <= t  <=>  n·10^12·den/num < t + 1; the quotient below is that n or one more. */
    u128 period = (u128)CRT_PS_PER_S * rate.den;
    uint64_t n = (uint64_t)(((u128)t + 1) * rate.num / period);
    return crt_tick_time(rate, n) <= t ? n : n - 1;
}

double crt_rate_hz(struct crt_rate rate)
{
    return (double)rate.num / (double)rate.den;
}
