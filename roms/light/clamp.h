/* clamp.h — the larger and the smaller of two floats, as the processor's instructions for them.
 *
 * Models:     fmax and fmin; the C library's functions are calls here.
 * Cost:       1 instruction.
 * Ownership:  nothing.
 * Errors:     none; of a NaN and a number, the number.
 * Source:     The RISC-V Instruction Set Manual, volume I (20191213), section 11.6.
 */
#ifndef ROMS_LIGHT_CLAMP_H
#define ROMS_LIGHT_CLAMP_H

#define CLAMP_INLINE static inline __attribute__((always_inline))

CLAMP_INLINE float larger(float a, float b)
{
#ifdef __riscv_flen
    __asm__("fmax.s %0, %0, %1" : "+f"(a) : "f"(b));
    return a;
#else
    return __builtin_fmaxf(a, b);
#endif
}

CLAMP_INLINE float smaller(float a, float b)
{
#ifdef __riscv_flen
    __asm__("fmin.s %0, %0, %1" : "+f"(a) : "f"(b));
    return a;
#else
    return __builtin_fminf(a, b);
#endif
}

CLAMP_INLINE float clamp(float v, float low, float high)
{
    return smaller(larger(v, low), high);
}

#endif
