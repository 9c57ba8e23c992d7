/* The disassembler: known words, what is no instruction, short buffers, destinations. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "emu/cpu/rv_disasm.h"
#include "tests/cpu/rv_encodings.h"

static void check(uint32_t word, const char *expected, int line)
{
    char text[RV_DISASM_MAX];
    rv_disasm(0x80000100, word, text, sizeof text);
    if (strcmp(text, expected) != 0) {
        print_error("line %d: %08x is \"%s\", expected \"%s\"\n", line, (unsigned)word, text,
                    expected);
        fail();
    }
}
#define assert_text(word, expected) check((word), (expected), __LINE__)

/* Words from the assembler. */
static void known_words(void **state)
{
    (void)state;
    assert_text(0xff050513, "addi a0,a0,-16");
    assert_text(0x00500513, "li a0,5");
    assert_text(0x00000013, "nop");
    assert_text(0x00058513, "mv a0,a1");
    assert_text(0xfff5c513, "not a0,a1");
    assert_text(0x40b00533, "neg a0,a1");
    assert_text(0x00559513, "slli a0,a1,0x5");
    assert_text(0x41f5d513, "srai a0,a1,0x1f");
    assert_text(0xfffff537, "lui a0,0xfffff");
    assert_text(0x12345517, "auipc a0,0x12345");
    assert_text(0xffc12503, "lw a0,-4(sp)");
    assert_text(0x80a12023, "sw a0,-2048(sp)");
    assert_text(0x00008067, "ret");
    assert_text(0x008500e7, "jalr 8(a0)");
    assert_text(0x00858567, "jalr a0,8(a1)");
    assert_text(0x02c58533, "mul a0,a1,a2");
    assert_text(0x0310000f, "fence rw,w");
    assert_text(0x0ff0000f, "fence");
    assert_text(0x8330000f, "fence.tso");
    assert_text(0x0000100f, "fence.i");
    assert_text(0x00000073, "ecall");
    assert_text(0x00100073, "ebreak");
    assert_text(0x30200073, "mret");
    assert_text(0x10500073, "wfi");
    assert_text(0xc0001073, "unimp");
}

static void known_csrs(void **state)
{
    (void)state;
    assert_text(0x30002573, "csrr a0,mstatus");
    assert_text(0x30051073, "csrw mstatus,a0");
    assert_text(0x3001d073, "csrwi mstatus,3");
    assert_text(0x30046073, "csrsi mstatus,8");
    assert_text(0x12359573, "csrrw a0,0x123,a1");
    assert_text(0xb8002573, "csrr a0,mcycleh");
    assert_text(0xc0102573, "rdtime a0");
    assert_text(0x00359573, "fscsr a0,a1");
    assert_text(0x0021d073, "fsrmi 3");
}

static void known_floats(void **state)
{
    (void)state;
    assert_text(0x0045a507, "flw fa0,4(a1)");
    assert_text(0x00a5a227, "fsw fa0,4(a1)");
    assert_text(0x00c5f553, "fadd.s fa0,fa1,fa2");
    assert_text(0x00c59553, "fadd.s fa0,fa1,fa2,rtz");
    assert_text(0x68c5c543, "fmadd.s fa0,fa1,fa2,fa3,rmm");
    assert_text(0x20b58553, "fmv.s fa0,fa1");
    assert_text(0x20c58553, "fsgnj.s fa0,fa1,fa2");
    assert_text(0xc0059553, "fcvt.w.s a0,fa1,rtz");
    assert_text(0xd015f553, "fcvt.s.wu fa0,a1");
    assert_text(0xe0050553, "fmv.x.w a0,fa0");
    assert_text(0xf0050553, "fmv.w.x fa0,a0");
    assert_text(0xa0c59553, "flt.s a0,fa1,fa2");
}

/* Targets are addresses, with wrap at either end of the address space. */
static void targets(void **state)
{
    (void)state;
    assert_text(0xfe050ee3, "beqz a0,0x800000fc");
    assert_text(0x7eb51fe3, "bne a0,a1,0x800010fe");
    assert_text(0x0100006f, "j 0x80000110");
    assert_text(0xffdff0ef, "jal 0x800000fc");
    assert_text(0x8000056f, "jal a0,0x7ff00100");
    char text[RV_DISASM_MAX];
    rv_disasm(0, 0xffdff06f, text, sizeof text);
    assert_string_equal(text, "j 0xfffffffc");
}

/* Shapes that an instruction almost has. */
static void almost(void **state)
{
    (void)state;
    static const uint32_t words[] = {
        0x00000000, 0xffffffff, 0x00004501, /* compressed */
        0x40001013, 0x02059513,             /* shift amounts of 64-bit machines */
        0x00c5d553, 0x00c5e553,             /* reserved rounding modes */
        0x02c5f553, 0x6ac5c543,             /* doubles */
        0x0005b503, 0x00a5b023,             /* ld, sd */
        0x5815f553, 0x20c5b553,             /* fsqrt of two operands, a fourth sign injection */
        0x10200073, 0x00200073, 0x12000073, /* sret, uret, sfence.vma */
        0x0000200f, 0x00004073, 0x100525af, /* no fence, no system, lr.w */
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        char expected[RV_DISASM_MAX];
        snprintf(expected, sizeof expected, ".word 0x%08x", (unsigned)words[i]);
        assert_text(words[i], expected);
        assert_int_equal(rv_destination(words[i]), -1);
    }
}

static uint32_t next(uint64_t *state)
{
    *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)(*state >> 32);
}

static bool is_instruction(uint32_t word)
{
    for (int i = 0; i < RV_ENCODINGS; i++)
        if (rv_encoding_matches(i, word))
            return true;
    return false;
}

static void check_either(uint32_t word)
{
    char text[RV_DISASM_MAX], data[RV_DISASM_MAX];
    rv_disasm(word ^ 0x5a5a5a58, word, text, sizeof text);
    snprintf(data, sizeof data, ".word 0x%08x", (unsigned)word);
    if (is_instruction(word) != (strcmp(text, data) != 0)) {
        print_error("%08x is \"%s\"\n", (unsigned)word, text);
        fail();
    }
}

/* Any word is an instruction here exactly when it is one in the manual's tables. */
static void any_words(void **state)
{
    (void)state;
    uint64_t random = 1;
    for (int i = 0; i < 100000; i++)
        check_either(next(&random));
    for (int number = 0; number < RV_ENCODINGS; number++) {
        for (int i = 0; i < 500; i++) {
            uint32_t word = rv_encode(number, next(&random));
            check_either(word);
            check_either(word ^ UINT32_C(1) << next(&random) % 32);
        }
    }
}

/* Cut, never written past, and RV_DISASM_MAX is enough. */
static void short_buffers(void **state)
{
    (void)state;
    uint64_t random = 2;
    for (int i = 0; i < 20000; i++) {
        uint32_t word = rv_encode((int)(next(&random) % RV_ENCODINGS), next(&random));
        char whole[4 * RV_DISASM_MAX], part[RV_DISASM_MAX + 1];
        rv_disasm(0x80000000, word, whole, sizeof whole);
        assert_true(strlen(whole) < RV_DISASM_MAX);
        size_t size = 1 + next(&random) % RV_DISASM_MAX;
        memset(part, '?', sizeof part);
        rv_disasm(0x80000000, word, part, size);
        assert_int_equal(part[size], '?');
        assert_int_equal(strlen(part), strlen(whole) < size ? strlen(whole) : size - 1);
        assert_memory_equal(part, whole, strlen(part));
    }
}

static void destinations(void **state)
{
    (void)state;
    assert_int_equal(rv_destination(0xff050513), 10); /* addi a0 */
    assert_int_equal(rv_destination(0xfffff537), 10); /* lui a0 */
    assert_int_equal(rv_destination(0xffdff0ef), 1);  /* jal ra */
    assert_int_equal(rv_destination(0x00000013), -1); /* nop: x0 */
    assert_int_equal(rv_destination(0x80a12023), -1); /* sw */
    assert_int_equal(rv_destination(0x00a5a227), -1); /* fsw */
    assert_int_equal(rv_destination(0xfe050ee3), -1); /* beqz */
    assert_int_equal(rv_destination(0x0310000f), -1); /* fence */
    assert_int_equal(rv_destination(0x00000073), -1); /* ecall */
    assert_int_equal(rv_destination(0x12359573), 10); /* csrrw a0 */
    assert_int_equal(rv_destination(0x0045a507), 42); /* flw fa0 */
    assert_int_equal(rv_destination(0x0045a007), 32); /* flw ft0 */
    assert_int_equal(rv_destination(0x68c5c543), 42); /* fmadd.s fa0 */
    assert_int_equal(rv_destination(0x00c5f553), 42); /* fadd.s fa0 */
    assert_int_equal(rv_destination(0x5805f553), 42); /* fsqrt.s fa0 */
    assert_int_equal(rv_destination(0xf0050553), 42); /* fmv.w.x fa0 */
    assert_int_equal(rv_destination(0xd015f553), 42); /* fcvt.s.wu fa0 */
    assert_int_equal(rv_destination(0xc0059553), 10); /* fcvt.w.s a0 */
    assert_int_equal(rv_destination(0xe0050553), 10); /* fmv.x.w a0 */
    assert_int_equal(rv_destination(0xe0051553), 10); /* fclass.s a0 */
    assert_int_equal(rv_destination(0xa0c59553), 10); /* flt.s a0 */
}

static void names(void **state)
{
    (void)state;
    assert_string_equal(rv_x_name(0), "zero");
    assert_string_equal(rv_x_name(8), "s0");
    assert_string_equal(rv_x_name(31), "t6");
    assert_string_equal(rv_f_name(10), "fa0");
    assert_string_equal(rv_f_name(31), "ft11");
    assert_string_equal(rv_csr_name(0x305), "mtvec");
    assert_string_equal(rv_csr_name(0xc83), "hpmcounter3h");
    assert_string_equal(rv_csr_name(0x33f), "mhpmevent31");
    assert_null(rv_csr_name(0xb01));
    assert_null(rv_csr_name(0x340 + 4096));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_words),   cmocka_unit_test(known_csrs),
        cmocka_unit_test(known_floats),  cmocka_unit_test(targets),
        cmocka_unit_test(almost),        cmocka_unit_test(any_words),
        cmocka_unit_test(short_buffers), cmocka_unit_test(destinations),
        cmocka_unit_test(names),
    };
    return cmocka_run_group_tests_name("rv_disasm", tests, NULL, NULL);
}
