/* float_run.h — every float operation in every mode on the same operands, here and elsewhere.
 *
 *      float_guest.c (instructions, under QEMU) ─┐
 *                                                ├─ float_run.c ─▶ the same lines, if both are right
 *      float_host.c (emu/cpu/rv_float.h) ────────┘
 *
 * Models:     cases: an operation with a static or dynamic rounding mode. A case runs on sets of
 *             operands, directed ones first, then random ones of its own seed, and gives a line: how
 *             often each flag was raised, and a check sum over all results and flags.
 * Ownership:  text goes out through float_put.
 * Errors:     none.
 * Freestanding: compiled for RV32 without a library too.
 */
#ifndef TESTS_QEMU_FLOAT_RUN_H
#define TESTS_QEMU_FLOAT_RUN_H

#include <stdint.h>

#include "tests/cpu/float_operands.h"

/* X(operation, its name, kind): kind says how many operands it reads and what it gives. */
#define FLOAT_ROUNDED(X)                                                                           \
    X(fadd, "fadd.s", TWO)                                                                         \
    X(fsub, "fsub.s", TWO)                                                                         \
    X(fmul, "fmul.s", TWO)                                                                         \
    X(fdiv, "fdiv.s", TWO)                                                                         \
    X(fsqrt, "fsqrt.s", ONE)                                                                       \
    X(fmadd, "fmadd.s", THREE)                                                                     \
    X(fmsub, "fmsub.s", THREE)                                                                     \
    X(fnmadd, "fnmadd.s", THREE)                                                                   \
    X(fnmsub, "fnmsub.s", THREE)                                                                   \
    X(fcvt_w, "fcvt.w.s", TO_INTEGER)                                                              \
    X(fcvt_wu, "fcvt.wu.s", TO_INTEGER)                                                            \
    X(fcvt_from_w, "fcvt.s.w", FROM_INTEGER)                                                       \
    X(fcvt_from_wu, "fcvt.s.wu", FROM_INTEGER)

#define FLOAT_PLAIN(X)                                                                             \
    X(fmin, "fmin.s", TWO)                                                                         \
    X(fmax, "fmax.s", TWO)                                                                         \
    X(feq, "feq.s", COMPARE)                                                                       \
    X(flt, "flt.s", COMPARE)                                                                       \
    X(fle, "fle.s", COMPARE)                                                                       \
    X(fclass, "fclass.s", TO_INTEGER)

/* Y(X's arguments, mode): for each mode. */
#define FLOAT_MODES(Y, ...)                                                                        \
    Y(__VA_ARGS__, rne)                                                                            \
    Y(__VA_ARGS__, rtz)                                                                            \
    Y(__VA_ARGS__, rdn)                                                                            \
    Y(__VA_ARGS__, rup)                                                                            \
    Y(__VA_ARGS__, rmm)

enum { MODE_rne, MODE_rtz, MODE_rdn, MODE_rup, MODE_rmm };

typedef uint32_t float_function(const struct operands *o, uint32_t *flags);

struct float_case {
    const char *name, *mode;
    uint32_t frm; /* the mode that the CSR holds; a static mode must not look at it */
    float_function *run;
};

/* What the two sides provide. */
extern const struct float_case float_cases[];
extern const unsigned float_case_count;
void float_put(const char *text, unsigned length);
void float_begin(uint32_t frm);

/* Arguments: COUNT: every case on so many sets, a line each, numbered. CASE FROM COUNT: the operands,
 * results and flags of a case's sets from FROM on. Returns the exit status. */
int float_main(int count, char **arguments);

#endif
