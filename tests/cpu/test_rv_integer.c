/* Every integer instruction on awkward operands, in the fast loop and clock by clock, against formulas
 * in 64-bit arithmetic that share nothing with the processor's. */
#include "tests/support/rv_rig.h"

static struct rig rig;
static struct rig *const r = &rig;

static const uint32_t operands[] = {
    0,          1,          2,          3,          31,         32,         33,         0x7FFF,
    0x8000,     0xFFFF,     0x10000,    0x55555555, 0xAAAAAAAA, 0x7FFFFFFE, 0x7FFFFFFF, 0x80000000,
    0x80000001, 0xFFFF8000, 0xFFFFFFFE, 0xFFFFFFFF, 0x12345678, 0xDEADBEEF,
};
#define OPERANDS (sizeof operands / sizeof operands[0])

static int64_t signed_of(uint32_t a)
{
    return a < 0x80000000u ? (int64_t)a : (int64_t)a - INT64_C(0x100000000);
}

static uint32_t low(int64_t a)
{
    return (uint32_t)((uint64_t)a & 0xFFFFFFFFu);
}

/* floor(a / 2ⁿ), without shifting. */
static int64_t floor_divide(int64_t a, int64_t by)
{
    int64_t q = a / by;
    return a % by < 0 ? q - 1 : q;
}

/* The upper half of a product, by halves of 16 bits as on paper. */
static uint32_t upper_product(uint32_t a, uint32_t b)
{
    uint32_t al = a & 0xFFFF, ah = a >> 16, bl = b & 0xFFFF, bh = b >> 16;
    uint32_t middle = ah * bl + (al * bl >> 16);
    uint32_t carry = al * bh + (middle & 0xFFFF);
    return ah * bh + (middle >> 16) + (carry >> 16);
}

static uint32_t ref_add(uint32_t a, uint32_t b)
{
    return low(signed_of(a) + signed_of(b));
}
static uint32_t ref_sub(uint32_t a, uint32_t b)
{
    return low(signed_of(a) - signed_of(b));
}
static uint32_t ref_sll(uint32_t a, uint32_t b)
{
    for (uint32_t n = b % 32; n > 0; n--)
        a += a;
    return a;
}
static uint32_t ref_srl(uint32_t a, uint32_t b)
{
    return low(floor_divide((int64_t)a, INT64_C(1) << b % 32));
}
static uint32_t ref_sra(uint32_t a, uint32_t b)
{
    return low(floor_divide(signed_of(a), INT64_C(1) << b % 32));
}
static uint32_t ref_slt(uint32_t a, uint32_t b)
{
    return signed_of(a) < signed_of(b) ? 1 : 0;
}
static uint32_t ref_sltu(uint32_t a, uint32_t b)
{
    return (int64_t)a - (int64_t)b < 0 ? 1 : 0;
}
static uint32_t ref_and(uint32_t a, uint32_t b)
{
    uint32_t result = 0;
    for (uint32_t bit = 1; bit != 0; bit += bit)
        result += (a / bit % 2 == 1 && b / bit % 2 == 1) ? bit : 0;
    return result;
}
static uint32_t ref_or(uint32_t a, uint32_t b)
{
    return a + b - ref_and(a, b);
}
static uint32_t ref_xor(uint32_t a, uint32_t b)
{
    return a + b - 2 * ref_and(a, b);
}
static uint32_t ref_mul(uint32_t a, uint32_t b)
{
    uint32_t sum = 0;
    for (uint32_t n = 0; n < 32; n++)
        sum += b / (1u << n) % 2 == 1 ? ref_sll(a, n) : 0;
    return sum;
}
static uint32_t ref_mulhu(uint32_t a, uint32_t b)
{
    return upper_product(a, b);
}
/* A negative operand is 2³² too much. */
static uint32_t ref_mulh(uint32_t a, uint32_t b)
{
    return upper_product(a, b) - (signed_of(a) < 0 ? b : 0) - (signed_of(b) < 0 ? a : 0);
}
static uint32_t ref_mulhsu(uint32_t a, uint32_t b)
{
    return upper_product(a, b) - (signed_of(a) < 0 ? b : 0);
}
static uint32_t ref_div(uint32_t a, uint32_t b)
{
    return b == 0 ? low(-1) : low(signed_of(a) / signed_of(b));
}
static uint32_t ref_divu(uint32_t a, uint32_t b)
{
    return b == 0 ? low(-1) : low((int64_t)a / (int64_t)b);
}
static uint32_t ref_rem(uint32_t a, uint32_t b)
{
    return b == 0 ? a : low(signed_of(a) % signed_of(b));
}
static uint32_t ref_remu(uint32_t a, uint32_t b)
{
    return b == 0 ? a : low((int64_t)a % (int64_t)b);
}

struct operation {
    const char *name;
    unsigned funct7, funct3;
    uint32_t (*ref)(uint32_t a, uint32_t b);
    enum { NO_IMMEDIATE, IMMEDIATE, AMOUNT } immediate;
};

static const struct operation operations[] = {
    {"add", 0, 0, ref_add, IMMEDIATE},
    {"sub", 0x20, 0, ref_sub, NO_IMMEDIATE},
    {"sll", 0, 1, ref_sll, AMOUNT},
    {"slt", 0, 2, ref_slt, IMMEDIATE},
    {"sltu", 0, 3, ref_sltu, IMMEDIATE},
    {"xor", 0, 4, ref_xor, IMMEDIATE},
    {"srl", 0, 5, ref_srl, AMOUNT},
    {"sra", 0x20, 5, ref_sra, AMOUNT},
    {"or", 0, 6, ref_or, IMMEDIATE},
    {"and", 0, 7, ref_and, IMMEDIATE},
    {"mul", 1, 0, ref_mul, NO_IMMEDIATE},
    {"mulh", 1, 1, ref_mulh, NO_IMMEDIATE},
    {"mulhsu", 1, 2, ref_mulhsu, NO_IMMEDIATE},
    {"mulhu", 1, 3, ref_mulhu, NO_IMMEDIATE},
    {"div", 1, 4, ref_div, NO_IMMEDIATE},
    {"divu", 1, 5, ref_divu, NO_IMMEDIATE},
    {"rem", 1, 6, ref_rem, NO_IMMEDIATE},
    {"remu", 1, 7, ref_remu, NO_IMMEDIATE},
};
#define OPERATIONS (sizeof operations / sizeof operations[0])

static int set_up(void **state)
{
    (void)state;
    rig_init(r);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(r);
    return 0;
}

/* The word, then wfi: in one go, so that the fast loop does it, or a clock at a time. */
static void execute(uint32_t word, bool clock_by_clock)
{
    RIG_PUT(r, 0, word, W_WFI);
    r->cpu.state = RV_RUNNING;
    (clock_by_clock ? rig_step : rig_run)(r, 0, 1000);
    assert_int_equal(r->cpu.state, RV_WAITING);
    assert_int_equal(r->cpu.pc, RIG_BASE + 8);
}

static void expect(const char *name, uint32_t a, uint32_t b, uint32_t got, uint32_t want)
{
    if (got != want)
        fail_msg("%s of %08x and %08x: %08x, must be %08x", name, a, b, got, want);
}

static void register_forms(void **state)
{
    (void)state;
    for (size_t i = 0; i < OPERATIONS; i++) {
        const struct operation *op = &operations[i];
        for (size_t n = 0; n < 2 * OPERANDS * OPERANDS; n++) {
            uint32_t a = operands[n / 2 / OPERANDS], b = operands[n / 2 % OPERANDS];
            r->cpu.x[A0] = a;
            r->cpu.x[A1] = b;
            execute(w_r(op->funct7, op->funct3, 0x33, A2, A0, A1), n % 2 == 1);
            expect(op->name, a, b, r->cpu.x[A2], op->ref(a, b));
            assert_int_equal(r->cpu.x[A0], a);
            assert_int_equal(r->cpu.x[A1], b);
        }
    }
}

/* The destination is an operand, or both operands are one register. */
static void registers_overlap(void **state)
{
    (void)state;
    for (size_t i = 0; i < OPERATIONS; i++) {
        const struct operation *op = &operations[i];
        for (size_t n = 0; n < OPERANDS; n++) {
            uint32_t a = operands[n], b = operands[(n + 7) % OPERANDS];
            r->cpu.x[A0] = a;
            r->cpu.x[A1] = b;
            execute(w_r(op->funct7, op->funct3, 0x33, A0, A0, A1), false);
            expect(op->name, a, b, r->cpu.x[A0], op->ref(a, b));
            r->cpu.x[A0] = a;
            execute(w_r(op->funct7, op->funct3, 0x33, A1, A0, A1), false);
            expect(op->name, a, b, r->cpu.x[A1], op->ref(a, b));
            execute(w_r(op->funct7, op->funct3, 0x33, A0, A0, A0), false);
            expect(op->name, a, a, r->cpu.x[A0], op->ref(a, a));
        }
    }
}

static void immediate_forms(void **state)
{
    (void)state;
    static const int32_t immediates[] = {-2048, -2047, -1024, -1, 0, 1, 31, 1365, 2046, 2047};
    for (size_t i = 0; i < OPERATIONS; i++) {
        const struct operation *op = &operations[i];
        size_t count = op->immediate == AMOUNT      ? 32
                       : op->immediate == IMMEDIATE ? sizeof immediates / sizeof immediates[0]
                                                    : 0;
        for (size_t n = 0; n < 2 * count * OPERANDS; n++) {
            uint32_t a = operands[n / 2 / count], k = (uint32_t)(n / 2 % count);
            int32_t imm = op->immediate == AMOUNT ? (int32_t)(k | op->funct7 << 5) : immediates[k];
            uint32_t b = op->immediate == AMOUNT ? k : (uint32_t)imm;
            r->cpu.x[A0] = a;
            execute(w_i(op->funct3, 0x13, A2, A0, imm), n % 2 == 1);
            expect(op->name, a, b, r->cpu.x[A2], op->ref(a, b));
        }
    }
}

static void upper_immediates(void **state)
{
    (void)state;
    for (size_t n = 0; n < 2 * OPERANDS; n++) {
        uint32_t value = operands[n / 2] << 12;
        execute(w_lui(A0, value), n % 2 == 1);
        assert_int_equal(r->cpu.x[A0], value);
        execute(w_auipc(A0, value), n % 2 == 1);
        assert_int_equal(r->cpu.x[A0], low((int64_t)RIG_BASE + value));
    }
}

/* What is written to x0 is gone; x0 as an operand is 0. */
static void x0_is_zero(void **state)
{
    (void)state;
    r->cpu.x[A0] = 0x1234;
    r->cpu.x[A1] = 3;
    for (size_t i = 0; i < OPERATIONS; i++) {
        execute(w_r(operations[i].funct7, operations[i].funct3, 0x33, ZERO, A0, A1), i % 2 == 1);
        assert_int_equal(r->cpu.x[ZERO], 0);
        execute(w_r(operations[i].funct7, operations[i].funct3, 0x33, A2, ZERO, A1), i % 2 == 1);
        expect(operations[i].name, 0, 3, r->cpu.x[A2], operations[i].ref(0, 3));
    }
    const uint32_t words[] = {w_addi(ZERO, A0, 1), w_lui(ZERO, 0x5000),       w_auipc(ZERO, 0x5000),
                              w_lw(ZERO, A2, 0),   w_i(4, 0x03, ZERO, A2, 0), w_jal(ZERO, 4),
                              w_jalr(ZERO, A2, 4), w_csrr(ZERO, CYCLE),       W_FENCE,
                              W_FENCE_I,           w_addi(ZERO, ZERO, 5)};
    for (size_t i = 0; i < 2 * (sizeof words / sizeof words[0]); i++) {
        r->cpu.x[A2] = RIG_BASE;
        execute(words[i / 2], i % 2 == 1);
        assert_int_equal(r->cpu.x[ZERO], 0);
    }
    execute(w_addi(A0, ZERO, -7), false);
    assert_int_equal(r->cpu.x[A0], low(-7));
}

static bool taken(unsigned funct3, uint32_t a, uint32_t b)
{
    bool less = funct3 < 6 ? signed_of(a) < signed_of(b) : (int64_t)a < (int64_t)b;
    return (funct3 < 4 ? (int64_t)a - (int64_t)b == 0 : less) != (funct3 % 2 == 1);
}

static void branches(void **state)
{
    (void)state;
    static const unsigned funct3s[] = {0, 1, 4, 5, 6, 7};
    static const int32_t distances[] = {8, 2046 & ~3, 4092, -4096, -8, -600};
    const uint32_t at = 0x2000;
    for (size_t i = 0; i < 6 * 6 * OPERANDS * OPERANDS; i++) {
        unsigned funct3 = funct3s[i % 6];
        int32_t distance = distances[i / 6 % 6];
        uint32_t a = operands[i / 36 / OPERANDS], b = operands[i / 36 % OPERANDS];
        r->cpu.x[A0] = a;
        r->cpu.x[A1] = b;
        r->cpu.state = RV_RUNNING;
        RIG_PUT(r, at, w_b(funct3, A0, A1, distance), W_WFI);
        RIG_PUT(r, at + (uint32_t)distance, W_WFI);
        (i % 5 == 0 ? rig_step : rig_run)(r, at, 1000);
        uint32_t next = taken(funct3, a, b) ? at + (uint32_t)distance : at + 4;
        if (r->cpu.pc != RIG_BASE + next + 4)
            fail_msg("branch %u by %d with %08x and %08x: at %08x", funct3, distance, a, b,
                     r->cpu.pc);
    }
}

static void jumps_link(void **state)
{
    (void)state;
    static const int32_t distances[] = {4, 8, 0x7FFC, -4, -0x4000};
    const uint32_t at = 0x4000;
    for (size_t i = 0; i < 10; i++) {
        int32_t distance = distances[i / 2];
        r->cpu.state = RV_RUNNING;
        RIG_PUT(r, at, w_jal(RA, distance), W_WFI);
        RIG_PUT(r, at + (uint32_t)distance, W_WFI);
        (i % 2 == 1 ? rig_step : rig_run)(r, at, 1000);
        assert_int_equal(r->cpu.pc, RIG_BASE + at + (uint32_t)distance + 4);
        assert_int_equal(r->cpu.x[RA], RIG_BASE + at + 4);

        /* Bit 0 of the target is dropped; base and link may be one register. */
        r->cpu.state = RV_RUNNING;
        r->cpu.x[RA] = RIG_BASE + at + (uint32_t)distance + 8;
        RIG_PUT(r, at, w_jalr(RA, RA, -7));
        (i % 2 == 1 ? rig_step : rig_run)(r, at, 1000);
        assert_int_equal(r->cpu.pc, RIG_BASE + at + (uint32_t)distance + 4);
        assert_int_equal(r->cpu.x[RA], RIG_BASE + at + 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(register_forms, set_up, tear_down),
        cmocka_unit_test_setup_teardown(registers_overlap, set_up, tear_down),
        cmocka_unit_test_setup_teardown(immediate_forms, set_up, tear_down),
        cmocka_unit_test_setup_teardown(upper_immediates, set_up, tear_down),
        cmocka_unit_test_setup_teardown(x0_is_zero, set_up, tear_down),
        cmocka_unit_test_setup_teardown(branches, set_up, tear_down),
        cmocka_unit_test_setup_teardown(jumps_link, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
