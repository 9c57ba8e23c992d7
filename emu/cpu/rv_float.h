/* rv_float.h — single-precision arithmetic to the last flag: IEEE 754-2008 as RISC-V has it.
 *
 * Models:     every operation of the F extension on bits (uint32_t), in all five rounding modes,
 *             RMM included; tininess after rounding; canonical NaN 7fc00000; fmin and fmax as in
 *             2.2 of F (-0 < +0, a quiet NaN loses, a signalling one raises NV). Integer arithmetic
 *             only: the same on every host, whatever its float unit does.
 * Flags:      the function ORs RV_NX … RV_NV into *flags.
 * Ownership:  pure functions.
 * Errors:     none; `rm` must be 0…4 (the caller has resolved DYN and refused 5 and 6).
 * Source:     The RISC-V Instruction Set Manual I, chapter 11; IEEE 754-2008.
 * Fast path:  rv_float_fast.h has the same results from the host's float unit where that is certain
 *             to be right; this file is what it falls back on.
 */
#ifndef EMU_CPU_RV_FLOAT_H
#define EMU_CPU_RV_FLOAT_H

#include <stdint.h>

enum { RV_NX = 1, RV_UF = 2, RV_OF = 4, RV_DZ = 8, RV_NV = 16 };
enum { RV_RNE = 0, RV_RTZ = 1, RV_RDN = 2, RV_RUP = 3, RV_RMM = 4, RV_DYN = 7 };

#define RV_NAN 0x7FC00000u

uint32_t rv_fadd(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags);
uint32_t rv_fsub(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags);
uint32_t rv_fmul(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags);
uint32_t rv_fdiv(uint32_t a, uint32_t b, unsigned rm, uint32_t *flags);
uint32_t rv_fsqrt(uint32_t a, unsigned rm, uint32_t *flags);
/* a·b + c with one rounding; the four fused instructions flip signs of a and c. */
uint32_t rv_fmadd(uint32_t a, uint32_t b, uint32_t c, unsigned rm, uint32_t *flags);

uint32_t rv_fmin(uint32_t a, uint32_t b, uint32_t *flags);
uint32_t rv_fmax(uint32_t a, uint32_t b, uint32_t *flags);
uint32_t rv_feq(uint32_t a, uint32_t b, uint32_t *flags); /* quiet; 0 or 1 */
uint32_t rv_flt(uint32_t a, uint32_t b, uint32_t *flags); /* signalling */
uint32_t rv_fle(uint32_t a, uint32_t b, uint32_t *flags);
uint32_t rv_fclass(uint32_t a); /* ten bits, one set */

uint32_t rv_fcvt_w(uint32_t a, unsigned rm, uint32_t *flags);  /* to int32, as bits */
uint32_t rv_fcvt_wu(uint32_t a, unsigned rm, uint32_t *flags); /* to uint32 */
uint32_t rv_fcvt_from_w(uint32_t a, unsigned rm, uint32_t *flags);
uint32_t rv_fcvt_from_wu(uint32_t a, unsigned rm, uint32_t *flags);

#endif
