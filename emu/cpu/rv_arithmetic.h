/* rv_arithmetic.h — integer operations that C has not got as RISC-V means them.
 *
 * Models:     division, the upper half of products, arithmetic shift.
 * Ownership:  pure functions.
 * Errors:     none: division by zero and overflow have results (7.2 of the manual).
 * Source:     The RISC-V Instruction Set Manual I, chapters 2 and 7.
 */
#ifndef EMU_CPU_RV_ARITHMETIC_H
#define EMU_CPU_RV_ARITHMETIC_H

#include <stdint.h>

/* By zero: all ones. −2³¹ / −1 is −2³¹ again, as negation has it. */
static inline uint32_t rv_div(uint32_t a, uint32_t b)
{
    return b == 0 ? UINT32_MAX : b == UINT32_MAX ? 0 - a : (uint32_t)((int32_t)a / (int32_t)b);
}

static inline uint32_t rv_divu(uint32_t a, uint32_t b)
{
    return b == 0 ? UINT32_MAX : a / b;
}

/* By zero: the dividend. */
static inline uint32_t rv_rem(uint32_t a, uint32_t b)
{
    return b == 0 ? a : b == UINT32_MAX ? 0 : (uint32_t)((int32_t)a % (int32_t)b);
}

static inline uint32_t rv_remu(uint32_t a, uint32_t b)
{
    return b == 0 ? a : a % b;
}

/* Of operands extended to 64 bits; a signed one by an unsigned one fits in, too. */
static inline uint32_t rv_mulh(int64_t a, int64_t b)
{
    return (uint32_t)((uint64_t)(a * b) >> 32);
}

static inline uint32_t rv_mulhu(uint32_t a, uint32_t b)
{
    return (uint32_t)((uint64_t)a * b >> 32);
}

/* gcc and clang shift negative numbers arithmetically. */
static inline uint32_t rv_sra(uint32_t a, uint32_t b)
{
    return (uint32_t)((int32_t)a >> (b & 31));
}

#endif
