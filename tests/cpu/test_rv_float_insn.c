/* Float instructions as the processor executes them, in its loops with all their short ways, against the
 * plain functions of rv_float.h: results and flags, whatever was in fcsr before. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "emu/cpu/rv.h"
#include "emu/cpu/rv_float.h"
#include "tests/cpu/float_operands.h"

enum { BASE = 0x10000, SIZE = 4096, MSTATUS = 0x300, FS_INITIAL = 1 << 13 };
enum { A = 1, B = 2, C = 3, RESULT = 4 }; /* registers, x and f */
#define SIGN 0x80000000u
#define WFI  0x10500073u

struct rounded {
    const char *name;
    uint32_t match;
    bool from_x, to_x;
    uint32_t (*want)(const struct operands *o, unsigned rm, uint32_t *flags);
};

#define WANT(name, call)                                                                           \
    static uint32_t name(const struct operands *o, unsigned rm, uint32_t *flags)                   \
    {                                                                                              \
        return call;                                                                               \
    }
WANT(add, rv_fadd(o->a, o->b, rm, flags))
WANT(sub, rv_fsub(o->a, o->b, rm, flags))
WANT(mul, rv_fmul(o->a, o->b, rm, flags))
WANT(quotient, rv_fdiv(o->a, o->b, rm, flags))
WANT(root, rv_fsqrt(o->a, rm, flags))
WANT(madd, rv_fmadd(o->a, o->b, o->c, rm, flags))
WANT(msub, rv_fmadd(o->a, o->b, o->c ^ SIGN, rm, flags))
WANT(nmsub, rv_fmadd(o->a ^ SIGN, o->b, o->c, rm, flags))
WANT(nmadd, rv_fmadd(o->a ^ SIGN, o->b, o->c ^ SIGN, rm, flags))
WANT(to_w, rv_fcvt_w(o->a, rm, flags))
WANT(to_wu, rv_fcvt_wu(o->a, rm, flags))
WANT(from_w, rv_fcvt_from_w(o->a, rm, flags))
WANT(from_wu, rv_fcvt_from_wu(o->a, rm, flags))

/* The manual's table of instructions, without registers and rounding mode. */
static const struct rounded rounded[] = {
    {"fadd.s", 0x00000053, false, false, add},       {"fsub.s", 0x08000053, false, false, sub},
    {"fmul.s", 0x10000053, false, false, mul},       {"fdiv.s", 0x18000053, false, false, quotient},
    {"fsqrt.s", 0x58000053, false, false, root},     {"fmadd.s", 0x00000043, false, false, madd},
    {"fmsub.s", 0x00000047, false, false, msub},     {"fnmsub.s", 0x0000004b, false, false, nmsub},
    {"fnmadd.s", 0x0000004f, false, false, nmadd},   {"fcvt.w.s", 0xc0000053, false, true, to_w},
    {"fcvt.wu.s", 0xc0100053, false, true, to_wu},   {"fcvt.s.w", 0xd0000053, true, false, from_w},
    {"fcvt.s.wu", 0xd0100053, true, false, from_wu},
};

struct plain {
    const char *name;
    uint32_t match;
    bool to_x;
    uint32_t (*want)(const struct operands *o, uint32_t *flags);
};

#define PLAIN(name, call)                                                                          \
    static uint32_t name(const struct operands *o, uint32_t *flags)                                \
    {                                                                                              \
        (void)flags;                                                                               \
        return call;                                                                               \
    }
PLAIN(least, rv_fmin(o->a, o->b, flags))
PLAIN(greatest, rv_fmax(o->a, o->b, flags))
PLAIN(equal, rv_feq(o->a, o->b, flags))
PLAIN(less, rv_flt(o->a, o->b, flags))
PLAIN(less_equal, rv_fle(o->a, o->b, flags))
PLAIN(class, rv_fclass(o->a))
PLAIN(inject, (o->a & ~SIGN) | (o->b & SIGN))
PLAIN(inject_not, (o->a & ~SIGN) | (~o->b & SIGN))
PLAIN(inject_xor, o->a ^ (o->b & SIGN))
PLAIN(move, o->a)

static const struct plain plain[] = {
    {"fmin.s", 0x28000053, false, least},        {"fmax.s", 0x28001053, false, greatest},
    {"feq.s", 0xa0002053, true, equal},          {"flt.s", 0xa0001053, true, less},
    {"fle.s", 0xa0000053, true, less_equal},     {"fclass.s", 0xe0001053, true, class},
    {"fsgnj.s", 0x20000053, false, inject},      {"fsgnjn.s", 0x20001053, false, inject_not},
    {"fsgnjx.s", 0x20002053, false, inject_xor}, {"fmv.x.w", 0xe0000053, true, move},
};

static uint8_t memory[SIZE];
static struct rv_cpu cpu;

static bool nothing_to_load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    (void)ctx;
    (void)address;
    (void)width;
    (void)value;
    return false;
}

static bool nothing_to_store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    (void)ctx;
    (void)address;
    (void)width;
    (void)value;
    return false;
}

static int set_up(void **state)
{
    struct rv_desc desc = {.memory = memory,
                           .memory_base = BASE,
                           .memory_size = SIZE,
                           .bus = {NULL, nothing_to_load, nothing_to_store, NULL}};
    (void)state;
    return rv_init(&cpu, &desc) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    rv_free(&cpu);
    return 0;
}

static void put_word(uint32_t at, uint32_t word)
{
    for (unsigned i = 0; i < 4; i++)
        memory[at + i] = (uint8_t)(word >> 8 * i);
}

/* The instruction at the start of memory, wfi behind it; registers in, fcsr in. */
static void load(uint32_t word)
{
    put_word(0, word);
    put_word(4, WFI);
    rv_changed(&cpu, BASE, BASE + 8);
}

static uint32_t with_registers(uint32_t match, bool one)
{
    uint32_t rs2 = one ? 0 : B << 20;
    uint32_t rs3 = (match & 0x53) == 0x43 ? (uint32_t)C << 27 : 0;
    return match | RESULT << 7 | A << 15 | rs2 | rs3;
}

/* Executes it, alone (one clock) or together with wfi (the fast loop). */
static void execute(const struct operands *o, uint32_t fcsr, bool alone)
{
    cpu.pc = BASE;
    cpu.state = RV_RUNNING;
    cpu.frm = fcsr >> 5;
    cpu.fflags = fcsr & 31;
    cpu.x[A] = cpu.f[A] = o->a;
    cpu.f[B] = o->b;
    cpu.f[C] = o->c;
    cpu.x[RESULT] = cpu.f[RESULT] = 0xdeadbeef;
    rv_run(&cpu, cpu.cycle + (alone ? 1 : 1000));
}

static void expect(const char *name, const struct operands *o, uint32_t fcsr, bool to_x,
                   uint32_t bits, uint32_t flags)
{
    uint32_t got = to_x ? cpu.x[RESULT] : cpu.f[RESULT];
    uint32_t other = to_x ? cpu.f[RESULT] : cpu.x[RESULT];

    flags |= fcsr & 31;
    if (got == bits && cpu.fflags == flags && other == 0xdeadbeef)
        return;
    fail_msg("%s of %08x %08x %08x, fcsr %02x: %08x flags %02x, must be %08x flags %02x", name,
             (unsigned)o->a, (unsigned)o->b, (unsigned)o->c, (unsigned)fcsr, (unsigned)got,
             (unsigned)cpu.fflags, (unsigned)bits, (unsigned)flags);
}

static unsigned rounds(unsigned full)
{
    const char *mode = getenv("TEST_MODE");
    return mode && (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0) ? full / 8 : full;
}

/* Set n: all pairs of the table first. */
static struct operands next_set(unsigned n, uint64_t *seed)
{
    struct operands o = operands_next(seed);

    if (n < OPERAND_TABLE * OPERAND_TABLE) {
        o.a = operand_from_table(n / OPERAND_TABLE);
        o.b = operand_from_table(n % OPERAND_TABLE);
        o.c = operand_any_of_table(seed);
    }
    return o;
}

/* rm: the instruction's field; fcsr as it is before. */
static void check_rounded(const struct rounded *r, unsigned rm, uint32_t fcsr, unsigned count)
{
    uint64_t seed = r->match + rm + (fcsr << 8) + 1;
    bool one = r->want == root || r->from_x || r->to_x;
    unsigned mode = rm == RV_DYN ? fcsr >> 5 : rm;

    load(with_registers(r->match, one) | rm << 12);
    for (unsigned n = 0; n < count; n++) {
        struct operands o = next_set(n, &seed);
        uint32_t flags = 0, bits = r->want(&o, mode, &flags);
        for (int alone = 0; alone < 2; alone++) {
            execute(&o, fcsr, alone != 0);
            expect(r->name, &o, fcsr, r->to_x, bits, flags);
        }
    }
}

/* As ordinary programs run: to nearest, and something was inexact before. Then a host's float unit
 * may do the work. */
static void as_programs_do(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rounded / sizeof rounded[0]; i++) {
        bool truncates = rounded[i].to_x; /* as casts in C do */
        check_rounded(&rounded[i], RV_DYN, RV_NX, rounds(400000));
        check_rounded(&rounded[i], RV_RNE, RV_NX, rounds(100000));
        if (truncates)
            check_rounded(&rounded[i], RV_RTZ, RV_NX, rounds(400000));
    }
}

static void every_mode(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rounded / sizeof rounded[0]; i++) {
        for (uint32_t rm = 0; rm < 5; rm++) {
            for (uint32_t flags = 0; flags < 32; flags += flags < 2 ? 1 : 29) { /* 0, 1, 2, 31 */
                check_rounded(&rounded[i], rm, (rm + 1) % 5 << 5 | flags, rounds(8000));
                check_rounded(&rounded[i], rm, (uint32_t)7 << 5 | flags, rounds(1000));
                check_rounded(&rounded[i], RV_DYN, rm << 5 | flags, rounds(8000));
            }
        }
    }
}

static void without_rounding(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof plain / sizeof plain[0]; i++) {
        const struct plain *p = &plain[i];
        uint64_t seed = p->match;
        load(with_registers(p->match, p->want == class || p->want == move));
        for (unsigned n = 0; n < rounds(100000); n++) {
            struct operands o = next_set(n, &seed);
            uint32_t fcsr = operand_random(&seed) & 0xff, flags = 0, bits = p->want(&o, &flags);
            for (int alone = 0; alone < 2; alone++) {
                execute(&o, fcsr, alone != 0);
                expect(p->name, &o, fcsr, p->to_x, bits, flags);
            }
        }
    }
}

/* fmv.w.x too keeps every bit. */
static void moves(void **state)
{
    uint64_t seed = 5;

    (void)state;
    load(with_registers(0xf0000053, true));
    for (unsigned n = 0; n < 20000; n++) {
        struct operands o = next_set(n, &seed);
        execute(&o, n & 0xff, n & 1);
        expect("fmv.w.x", &o, n & 0xff, false, o.a, 0);
    }
}

/* Modes 5 and 6 do not exist, and 7 in frm neither: illegal, and nothing else happens. */
static void no_such_mode(void **state)
{
    static const struct operands o = {0x3f800000, 0x33800000, 0};

    (void)state;
    for (size_t i = 0; i < sizeof rounded / sizeof rounded[0]; i++) {
        bool one = rounded[i].want == root || rounded[i].from_x || rounded[i].to_x;
        for (uint32_t rm = 5; rm < 8; rm++) {
            for (uint32_t frm = rm == RV_DYN ? 5 : 0; frm < 8; frm++) {
                uint32_t word = with_registers(rounded[i].match, one) | rm << 12;
                load(word);
                cpu.mtvec = BASE + 4;
                execute(&o, frm << 5 | RV_NX, false);
                assert_int_equal(cpu.mcause, RV_ILLEGAL);
                assert_int_equal(cpu.mepc, BASE);
                assert_int_equal(cpu.mtval, word);
                assert_int_equal(cpu.fflags, RV_NX);
                assert_int_equal(cpu.x[RESULT], 0xdeadbeef);
                assert_int_equal(cpu.f[RESULT], 0xdeadbeef);
                cpu.mcause = 0;
            }
        }
    }
}

static int floats_on(void **state)
{
    (void)state;
    rv_reset(&cpu);
    return rv_csr_write(&cpu, MSTATUS, FS_INITIAL) ? 0 : -1;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(as_programs_do, floats_on),
        cmocka_unit_test_setup(every_mode, floats_on),
        cmocka_unit_test_setup(without_rounding, floats_on),
        cmocka_unit_test_setup(moves, floats_on),
        cmocka_unit_test_setup(no_such_mode, floats_on),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
