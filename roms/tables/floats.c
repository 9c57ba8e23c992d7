/* Float instructions: every rounding mode, with the flags they leave. */
#include <stdbool.h>
#include <stdio.h>

#include "roms/bsp/csr.h"
#include "roms/tables/tables.h"

/* What an instruction that takes up to three floats, or a whole number, gives; bits. */
#define FLOATS(name, instruction)                                                                  \
    static uint32_t op_##name(uint32_t a, uint32_t b, uint32_t c)                                  \
    {                                                                                              \
        uint32_t value;                                                                            \
        __asm__ volatile("fmv.w.x ft0, %1; fmv.w.x ft1, %2; fmv.w.x ft2, %3;" instruction          \
                         "; fmv.x.w %0, ft3"                                                       \
                         : "=r"(value)                                                             \
                         : "r"(a), "r"(b), "r"(c)                                                  \
                         : "ft0", "ft1", "ft2", "ft3");                                            \
        return value;                                                                              \
    }
#define WHOLE(name, instruction)                                                                   \
    static uint32_t op_##name(uint32_t a, uint32_t b, uint32_t c)                                  \
    {                                                                                              \
        uint32_t value;                                                                            \
        (void)c;                                                                                   \
        __asm__ volatile("fmv.w.x ft0, %1; fmv.w.x ft1, %2;" instruction                           \
                         : "=r"(value)                                                             \
                         : "r"(a), "r"(b)                                                          \
                         : "ft0", "ft1", "ft3");                                                   \
        return value;                                                                              \
    }

FLOATS(fadd, "fadd.s ft3, ft0, ft1")
FLOATS(fsub, "fsub.s ft3, ft0, ft1")
FLOATS(fmul, "fmul.s ft3, ft0, ft1")
FLOATS(fdiv, "fdiv.s ft3, ft0, ft1")
FLOATS(fsqrt, "fsqrt.s ft3, ft0")
FLOATS(fmin, "fmin.s ft3, ft0, ft1")
FLOATS(fmax, "fmax.s ft3, ft0, ft1")
FLOATS(fsgnj, "fsgnj.s ft3, ft0, ft1")
FLOATS(fsgnjn, "fsgnjn.s ft3, ft0, ft1")
FLOATS(fsgnjx, "fsgnjx.s ft3, ft0, ft1")
FLOATS(fmadd, "fmadd.s ft3, ft0, ft1, ft2")
FLOATS(fmsub, "fmsub.s ft3, ft0, ft1, ft2")
FLOATS(fnmadd, "fnmadd.s ft3, ft0, ft1, ft2")
FLOATS(fnmsub, "fnmsub.s ft3, ft0, ft1, ft2")
FLOATS(fcvtsw, "fmv.x.w t0, ft0; fcvt.s.w ft3, t0")
FLOATS(fcvtswu, "fmv.x.w t0, ft0; fcvt.s.wu ft3, t0")
WHOLE(feq, "feq.s %0, ft0, ft1")
WHOLE(flt, "flt.s %0, ft0, ft1")
WHOLE(fle, "fle.s %0, ft0, ft1")
WHOLE(fclass, "fclass.s %0, ft0")
WHOLE(fcvtws, "fcvt.w.s %0, ft0")
WHOLE(fcvtwus, "fcvt.wu.s %0, ft0")
/* With the mode in the instruction, whatever frm says. */
FLOATS(fadd_rup, "fadd.s ft3, ft0, ft1, rup")
FLOATS(fmul_rdn, "fmul.s ft3, ft0, ft1, rdn")
FLOATS(fdiv_rmm, "fdiv.s ft3, ft0, ft1, rmm")
FLOATS(fsqrt_rtz, "fsqrt.s ft3, ft0, rtz")
FLOATS(fmadd_rne, "fmadd.s ft3, ft0, ft1, ft2, rne")
WHOLE(fcvtws_rtz, "fcvt.w.s %0, ft0, rtz")

#define ROW(name, operands)                                                                        \
    {                                                                                              \
#name, op_##name, operands                                                                 \
    }

static const struct {
    const char *name;
    uint32_t (*run)(uint32_t a, uint32_t b, uint32_t c);
    int operands;
} operations[] = {
    ROW(fadd, 2),      ROW(fsub, 2),      ROW(fmul, 2),       ROW(fdiv, 2),     ROW(fsqrt, 1),
    ROW(fmin, 2),      ROW(fmax, 2),      ROW(fsgnj, 2),      ROW(fsgnjn, 2),   ROW(fsgnjx, 2),
    ROW(fmadd, 3),     ROW(fmsub, 3),     ROW(fnmadd, 3),     ROW(fnmsub, 3),   ROW(fcvtsw, 1),
    ROW(fcvtswu, 1),   ROW(feq, 2),       ROW(flt, 2),        ROW(fle, 2),      ROW(fclass, 1),
    ROW(fcvtws, 1),    ROW(fcvtwus, 1),   ROW(fadd_rup, 2),   ROW(fmul_rdn, 2), ROW(fdiv_rmm, 2),
    ROW(fsqrt_rtz, 1), ROW(fmadd_rne, 3), ROW(fcvtws_rtz, 1),
};

/* Zeros, ones, subnormals, the ends of the ranges, infinities, NaNs of all kinds, halves. */
static const uint32_t edges[] = {
    0x00000000, 0x80000000, 0x3F800000, 0xBF800000, 0x3F800001, 0x3F7FFFFF, 0x00000001,
    0x80000001, 0x007FFFFF, 0x807FFFFF, 0x00800000, 0x80800000, 0x7F7FFFFF, 0xFF7FFFFF,
    0x7F800000, 0xFF800000, 0x7FC00000, 0xFFC12345, 0x7F800001, 0xFFBFFFFF, 0x3F000000,
    0xC0200000, 0x4B000001, 0xCF000000, 0x4F7FFFFF, 0x33800000, 0x3EAAAAAB, 0x20000000,
};

#define EDGES (sizeof edges / sizeof *edges)

/* Numbers whose results are near each other's last bits: exponents within a narrow range. */
static uint32_t near_one(uint32_t *state)
{
    uint32_t bits = tables_random(state);
    return (bits & 0x807FFFFF) | (120 + (bits >> 23 & 15)) << 23;
}

struct tally {
    uint32_t (*run)(uint32_t, uint32_t, uint32_t);
    uint32_t mode, sum;
};

static void add(struct tally *tally, uint32_t a, uint32_t b, uint32_t c)
{
    csr_write_fcsr(tally->mode << 5);
    uint32_t value = tally->run(a, b, c);
    uint32_t flags = csr_read_fcsr();
    tally->sum = tables_sum(tables_sum(tally->sum, value), flags);
}

/* All pairs of edges; a fused instruction's third operand moves on with them. */
static void add_edges(struct tally *tally, int operands)
{
    unsigned seconds = operands > 1 ? EDGES : 1, thirds = operands > 2 ? EDGES : 1;
    for (unsigned i = 0; i < EDGES; i++) {
        for (unsigned k = 0; k < seconds; k++) {
            for (unsigned n = 0; n < thirds; n++)
                add(tally, edges[i], edges[k], edges[n]);
        }
    }
}

static void add_random(struct tally *tally)
{
    uint32_t state = 2463534242u;
    for (int i = 0; i < 1500; i++) {
        uint32_t a = near_one(&state), b = near_one(&state), c = near_one(&state);
        add(tally, a, b, c);
        add(tally, tables_random(&state), tables_random(&state), tables_random(&state));
    }
}

static void check_sums(void)
{
    printf("floats: check sums of results and flags, rounding to nearest even, to zero, down, up, "
           "to nearest away\n");
    for (unsigned i = 0; i < sizeof operations / sizeof *operations; i++) {
        printf("%-10s", operations[i].name);
        for (uint32_t mode = 0; mode < 5; mode++) {
            struct tally tally = {operations[i].run, mode, TABLES_SUM_START};
            add_edges(&tally, operations[i].operands);
            add_random(&tally);
            csr_write_fcsr(0);
            printf(" %08lx", (unsigned long)tally.sum);
        }
        printf("\n");
    }
}

/* Cases one by one, for whoever looks for the cause of a wrong check sum. */
static void cases(void)
{
    static const uint32_t some[][3] = {
        {0x3F800000, 0x33800000, 0x00000000}, /* half a last bit beside 1 */
        {0x00800000, 0x3F7FFFFF, 0x00000000}, /* about the smallest normal number */
        {0x7F7FFFFF, 0x7F7FFFFF, 0xFF7FFFFF}, /* overflow */
        {0x4F000000, 0xBF000000, 0x7F800001}, /* 2^31; a signalling NaN */
    };
    printf("floats: result/flags in each rounding mode\n");
    for (unsigned i = 0; i < sizeof operations / sizeof *operations; i++) {
        for (unsigned k = 0; k < sizeof some / sizeof *some; k++) {
            printf("%-10s%u", operations[i].name, k);
            for (uint32_t mode = 0; mode < 5; mode++) {
                csr_write_fcsr(mode << 5);
                uint32_t value = operations[i].run(some[k][0], some[k][1], some[k][2]);
                uint32_t flags = csr_read_fcsr() & 31;
                csr_write_fcsr(0);
                printf(" %08lx/%02lx", (unsigned long)value, (unsigned long)flags);
            }
            printf("\n");
        }
    }
}

void tables_floats(void)
{
    check_sums();
    cases();
}
