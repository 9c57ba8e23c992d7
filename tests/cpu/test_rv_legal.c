/* Which words are instructions: opcode, funct3, funct7 and rs2 in all combinations, against the listing in
 * the manual (chapter 24 of volume I, with Zicsr, Zifencei and machine mode). */
#include "tests/support/rv_rig.h"

static struct rig rig;
static struct rig *const r = &rig;

enum { HANDLER = 0x800 };

/* The word & mask is match. In the order of the manual's tables. */
static const struct listed {
    uint32_t mask, match;
    bool rounds; /* funct3 is a rounding mode */
} listed[] = {
    {0x0000007F, 0x00000037, false}, /* lui */
    {0x0000007F, 0x00000017, false}, /* auipc */
    {0x0000007F, 0x0000006F, false}, /* jal */
    {0x0000707F, 0x00000067, false}, /* jalr */
    {0x0000707F, 0x00000063, false}, /* beq */
    {0x0000707F, 0x00001063, false}, /* bne */
    {0x0000707F, 0x00004063, false}, /* blt */
    {0x0000707F, 0x00005063, false}, /* bge */
    {0x0000707F, 0x00006063, false}, /* bltu */
    {0x0000707F, 0x00007063, false}, /* bgeu */
    {0x0000707F, 0x00000003, false}, /* lb */
    {0x0000707F, 0x00001003, false}, /* lh */
    {0x0000707F, 0x00002003, false}, /* lw */
    {0x0000707F, 0x00004003, false}, /* lbu */
    {0x0000707F, 0x00005003, false}, /* lhu */
    {0x0000707F, 0x00000023, false}, /* sb */
    {0x0000707F, 0x00001023, false}, /* sh */
    {0x0000707F, 0x00002023, false}, /* sw */
    {0x0000707F, 0x00000013, false}, /* addi */
    {0x0000707F, 0x00002013, false}, /* slti */
    {0x0000707F, 0x00003013, false}, /* sltiu */
    {0x0000707F, 0x00004013, false}, /* xori */
    {0x0000707F, 0x00006013, false}, /* ori */
    {0x0000707F, 0x00007013, false}, /* andi */
    {0xFE00707F, 0x00001013, false}, /* slli */
    {0xFE00707F, 0x00005013, false}, /* srli */
    {0xFE00707F, 0x40005013, false}, /* srai */
    {0xFE00707F, 0x00000033, false}, /* add */
    {0xFE00707F, 0x40000033, false}, /* sub */
    {0xFE00707F, 0x00001033, false}, /* sll */
    {0xFE00707F, 0x00002033, false}, /* slt */
    {0xFE00707F, 0x00003033, false}, /* sltu */
    {0xFE00707F, 0x00004033, false}, /* xor */
    {0xFE00707F, 0x00005033, false}, /* srl */
    {0xFE00707F, 0x40005033, false}, /* sra */
    {0xFE00707F, 0x00006033, false}, /* or */
    {0xFE00707F, 0x00007033, false}, /* and */
    {0x0000707F, 0x0000000F, false}, /* fence */
    {0x0000707F, 0x0000100F, false}, /* fence.i */
    {0xFFFFFFFF, 0x00000073, false}, /* ecall */
    {0xFFFFFFFF, 0x00100073, false}, /* ebreak */
    {0xFFFFFFFF, 0x30200073, false}, /* mret */
    {0xFFFFFFFF, 0x10500073, false}, /* wfi */
    {0xFE00407F, 0x02000033, false}, /* mul … mulhu */
    {0xFE00407F, 0x02004033, false}, /* div … remu */
    {0x0000707F, 0x00002007, false}, /* flw */
    {0x0000707F, 0x00002027, false}, /* fsw */
    {0x0600007F, 0x00000043, true},  /* fmadd.s */
    {0x0600007F, 0x00000047, true},  /* fmsub.s */
    {0x0600007F, 0x0000004B, true},  /* fnmsub.s */
    {0x0600007F, 0x0000004F, true},  /* fnmadd.s */
    {0xFE00007F, 0x00000053, true},  /* fadd.s */
    {0xFE00007F, 0x08000053, true},  /* fsub.s */
    {0xFE00007F, 0x10000053, true},  /* fmul.s */
    {0xFE00007F, 0x18000053, true},  /* fdiv.s */
    {0xFFF0007F, 0x58000053, true},  /* fsqrt.s */
    {0xFE00707F, 0x20000053, false}, /* fsgnj.s */
    {0xFE00707F, 0x20001053, false}, /* fsgnjn.s */
    {0xFE00707F, 0x20002053, false}, /* fsgnjx.s */
    {0xFE00707F, 0x28000053, false}, /* fmin.s */
    {0xFE00707F, 0x28001053, false}, /* fmax.s */
    {0xFFF0007F, 0xC0000053, true},  /* fcvt.w.s */
    {0xFFF0007F, 0xC0100053, true},  /* fcvt.wu.s */
    {0xFFF0707F, 0xE0000053, false}, /* fmv.x.w */
    {0xFE00707F, 0xA0002053, false}, /* feq.s */
    {0xFE00707F, 0xA0001053, false}, /* flt.s */
    {0xFE00707F, 0xA0000053, false}, /* fle.s */
    {0xFFF0707F, 0xE0001053, false}, /* fclass.s */
    {0xFFF0007F, 0xD0000053, true},  /* fcvt.s.w */
    {0xFFF0007F, 0xD0100053, true},  /* fcvt.s.wu */
    {0xFFF0707F, 0xF0000053, false}, /* fmv.w.x */
};

static bool is_csr_word(uint32_t word)
{
    return (word & 0x7F) == 0x73 && (word >> 12 & 3) != 0;
}

static bool is_listed(uint32_t word)
{
    unsigned funct3 = word >> 12 & 7;
    for (size_t i = 0; i < sizeof listed / sizeof listed[0]; i++)
        if ((word & listed[i].mask) == listed[i].match)
            return !listed[i].rounds || (funct3 != 5 && funct3 != 6);
    return false;
}

static int set_up(void **state)
{
    (void)state;
    rig_init(r);
    RIG_PUT(r, HANDLER, w_jal(ZERO, 0));
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    rig_free(r);
    return 0;
}

/* Whether the processor takes the word for an instruction; it may still trap for another reason. */
static bool is_taken(uint32_t word, bool clock_by_clock)
{
    RIG_PUT(r, 0x400, word, w_jal(ZERO, 0));
    r->cpu.mtvec = RIG_BASE + HANDLER;
    r->cpu.mcause = 99;
    r->cpu.mepc = RIG_BASE + 0x404; /* where mret goes */
    r->cpu.state = RV_RUNNING;
    r->cpu.frm = 0;
    rv_csr_write(&r->cpu, MSTATUS, 3 << 13);
    (clock_by_clock ? rig_step : rig_run)(r, 0x400, clock_by_clock ? 1 : 64);
    if (r->cpu.mcause != RV_ILLEGAL || r->cpu.mepc != RIG_BASE + 0x400)
        return true;
    assert_int_equal(r->cpu.mtval, word);
    return false;
}

static void expect(uint32_t word)
{
    for (int slow = 0; slow < 2; slow++)
        if (is_taken(word, slow) != is_listed(word))
            fail_msg("%08x is %s instruction", word, is_listed(word) ? "an" : "no");
}

/* Sanitizers make everything slow: less is tried. */
static bool slowly(void)
{
    const char *mode = getenv("TEST_MODE");
    return mode && (strcmp(mode, "asan") == 0 || strcmp(mode, "tsan") == 0);
}

static void all_combinations(void **state)
{
    (void)state;
    static const uint32_t registers[] = {0, 1, 2, 5, 31};
    for (uint32_t opcode = 0; opcode < 128; opcode++) {
        uint32_t step = (opcode & 3) != 3 ? 37 : slowly() ? 4 : 1;
        for (uint32_t funct7 = 0; funct7 < 128; funct7 += step)
            for (uint32_t funct3 = 0; funct3 < 8; funct3++)
                for (size_t i = 0; i < 5; i++) {
                    uint32_t word = w_r(funct7, funct3, opcode, 1, 0, registers[i]);
                    if (!is_csr_word(word))
                        expect(word);
                }
    }
}

static void any_words(void **state)
{
    (void)state;
    uint32_t word = 1;
    for (int i = 0; i < (slowly() ? 10000 : 100000); i++) {
        word = word * 1664525u + 1013904223u;
        uint32_t mixed = (word >> 9 | word << 23) | (i % 4 != 0 ? 3 : 0);
        if (!is_csr_word(mixed))
            expect(mixed);
    }
}

/* ecall and its kin have nothing in their other fields. */
static void system_words(void **state)
{
    (void)state;
    for (uint32_t csr = 0; csr < 4096; csr++)
        for (uint32_t rd = 0; rd < 2; rd++)
            for (uint32_t rs1 = 0; rs1 < 2; rs1++) {
                expect(csr << 20 | rs1 << 15 | rd << 7 | 0x73);
                expect(csr << 20 | rs1 << 15 | 4 << 12 | rd << 7 | 0x73);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(all_combinations, set_up, tear_down),
        cmocka_unit_test_setup_teardown(any_words, set_up, tear_down),
        cmocka_unit_test_setup_teardown(system_words, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
