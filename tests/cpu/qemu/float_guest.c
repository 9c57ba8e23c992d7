/* float_guest.c — the instructions themselves: a Linux program for RV32IMF without a library. */
#include "tests/cpu/qemu/float_run.h"

/* The operands travel as bits: fmv does not touch them. The flags are read and cleared in one go, as a
 * write to a CSR is slow under QEMU. */
#define RUN(body, ...)                                                                             \
    uint32_t result, raised;                                                                       \
    __asm__ volatile(body "\n fsflags %1, zero"                                                    \
                     : "=&r"(result), "=&r"(raised)                                                \
                     : __VA_ARGS__                                                                 \
                     : "ft0", "ft1", "ft2", "ft3");                                                \
    *flags = raised;                                                                               \
    return result

#define BODY_ONE(name, mode)                                                                       \
    RUN("fmv.w.x ft0, %2\n" name " ft3, ft0" mode "\n fmv.x.w %0, ft3", "r"(o->a))
#define BODY_TWO(name, mode)                                                                       \
    RUN("fmv.w.x ft0, %2\n fmv.w.x ft1, %3\n" name " ft3, ft0, ft1" mode "\n fmv.x.w %0, ft3",     \
        "r"(o->a), "r"(o->b))
#define BODY_THREE(name, mode)                                                                     \
    RUN("fmv.w.x ft0, %2\n fmv.w.x ft1, %3\n fmv.w.x ft2, %4\n" name " ft3, ft0, ft1, ft2" mode    \
        "\n fmv.x.w %0, ft3",                                                                      \
        "r"(o->a), "r"(o->b), "r"(o->c))
#define BODY_COMPARE(name, mode)                                                                   \
    RUN("fmv.w.x ft0, %2\n fmv.w.x ft1, %3\n" name " %0, ft0, ft1" mode, "r"(o->a), "r"(o->b))
#define BODY_TO_INTEGER(name, mode)   RUN("fmv.w.x ft0, %2\n" name " %0, ft0" mode, "r"(o->a))
#define BODY_FROM_INTEGER(name, mode) RUN(name " ft3, %2" mode "\n fmv.x.w %0, ft3", "r"(o->a))

#define STATIC(op, name, kind, mode)                                                               \
    static uint32_t op##_##mode(const struct operands *o, uint32_t *flags)                         \
    {                                                                                              \
        BODY_##kind(name, ", " #mode);                                                             \
    }
#define ROUNDED(op, name, kind)                                                                    \
    FLOAT_MODES(STATIC, op, name, kind)                                                            \
    static uint32_t op##_dynamic(const struct operands *o, uint32_t *flags)                        \
    {                                                                                              \
        BODY_##kind(name, ", dyn");                                                                \
    }
#define PLAIN(op, name, kind)                                                                      \
    static uint32_t op##_plain(const struct operands *o, uint32_t *flags)                          \
    {                                                                                              \
        BODY_##kind(name, "");                                                                     \
    }
FLOAT_ROUNDED(ROUNDED)
FLOAT_PLAIN(PLAIN)

/* With a static mode, the CSR holds another one. */
#define STATIC_CASE(op, name, kind, mode)  {name, #mode, (MODE_##mode + 1) % 5, op##_##mode},
#define DYNAMIC_CASE(op, name, kind, mode) {name, #mode " dynamic", MODE_##mode, op##_dynamic},
#define ROUNDED_CASES(op, name, kind)                                                              \
    FLOAT_MODES(STATIC_CASE, op, name, kind) FLOAT_MODES(DYNAMIC_CASE, op, name, kind)
#define PLAIN_CASE(op, name, kind) {name, "", MODE_rne, op##_plain},
const struct float_case float_cases[] = {FLOAT_ROUNDED(ROUNDED_CASES) FLOAT_PLAIN(PLAIN_CASE)};
const unsigned float_case_count = sizeof float_cases / sizeof float_cases[0];

void float_begin(uint32_t frm)
{
    __asm__ volatile("fscsr %0" : : "r"(frm << 5)); /* and no flags */
}

/* RISC-V Linux: number in a7, arguments from a0. */
static long system_call(long number, long a, long b, long c)
{
    register long a0 __asm__("a0") = a;
    register long a1 __asm__("a1") = b;
    register long a2 __asm__("a2") = c;
    register long a7 __asm__("a7") = number;
    __asm__ volatile("ecall" : "+r"(a0) : "r"(a1), "r"(a2), "r"(a7) : "memory");
    return a0;
}

enum { SYS_WRITE = 64, SYS_EXIT = 93 };

void float_put(const char *text, unsigned length)
{
    system_call(SYS_WRITE, 1, (long)text, (long)length);
}

/* The stack as Linux leaves it: the count of arguments, then the arguments. */
void float_start(long *stack);
void float_start(long *stack)
{
    system_call(SYS_EXIT, float_main((int)stack[0], (char **)(stack + 1)), 0, 0);
}

__asm__(".globl _start\n"
        "_start:\n"
        "    .option push\n"
        "    .option norelax\n"
        "    la gp, __global_pointer$\n"
        "    .option pop\n"
        "    mv a0, sp\n"
        "    j float_start\n");
