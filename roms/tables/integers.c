/* Register-to-register and immediate integer instructions, multiplication and division. */
#include <stdio.h>

#include "roms/tables/tables.h"

#define OPERATION(name, mnemonic)                                                                  \
    static uint32_t op_##name(uint32_t a, uint32_t b)                                              \
    {                                                                                              \
        uint32_t value;                                                                            \
        __asm__ volatile(mnemonic " %0, %1, %2" : "=r"(value) : "r"(a), "r"(b));                   \
        return value;                                                                              \
    }
#define IMMEDIATE(name, mnemonic, number)                                                          \
    static uint32_t op_##name(uint32_t a, uint32_t b)                                              \
    {                                                                                              \
        uint32_t value;                                                                            \
        (void)b;                                                                                   \
        __asm__ volatile(mnemonic " %0, %1, " number : "=r"(value) : "r"(a));                      \
        return value;                                                                              \
    }

OPERATION(add, "add")
OPERATION(sub, "sub")
OPERATION(sll, "sll")
OPERATION(slt, "slt")
OPERATION(sltu, "sltu")
OPERATION(xor, "xor")
OPERATION(srl, "srl")
OPERATION(sra, "sra")
OPERATION(or, "or")
OPERATION(and, "and")
OPERATION(mul, "mul")
OPERATION(mulh, "mulh")
OPERATION(mulhsu, "mulhsu")
OPERATION(mulhu, "mulhu")
OPERATION(div, "div")
OPERATION(divu, "divu")
OPERATION(rem, "rem")
OPERATION(remu, "remu")
IMMEDIATE(addi, "addi", "-2048")
IMMEDIATE(slti, "slti", "2047")
IMMEDIATE(sltiu, "sltiu", "-1")
IMMEDIATE(xori, "xori", "-1366")
IMMEDIATE(ori, "ori", "1365")
IMMEDIATE(andi, "andi", "-256")
IMMEDIATE(slli, "slli", "31")
IMMEDIATE(srli, "srli", "1")
IMMEDIATE(srai, "srai", "31")

/* 1 where the branch is taken. */
#define BRANCH(name)                                                                               \
    static uint32_t op_##name(uint32_t a, uint32_t b)                                              \
    {                                                                                              \
        uint32_t taken = 1;                                                                        \
        __asm__ volatile(#name " %1, %2, 1f; li %0, 0; 1:" : "+r"(taken) : "r"(a), "r"(b));        \
        return taken;                                                                              \
    }

BRANCH(beq)
BRANCH(bne)
BRANCH(blt)
BRANCH(bge)
BRANCH(bltu)
BRANCH(bgeu)

#define ROW(name)                                                                                  \
    {                                                                                              \
#name, op_##name                                                                           \
    }

static const struct {
    const char *name;
    uint32_t (*run)(uint32_t a, uint32_t b);
} operations[] = {
    ROW(add),  ROW(sub),  ROW(sll),  ROW(slt),  ROW(sltu), ROW(xor),    ROW(srl),
    ROW(sra),  ROW(or),   ROW(and),  ROW(mul),  ROW(mulh), ROW(mulhsu), ROW(mulhu),
    ROW(div),  ROW(divu), ROW(rem),  ROW(remu), ROW(addi), ROW(slti),   ROW(sltiu),
    ROW(xori), ROW(ori),  ROW(andi), ROW(slli), ROW(srli), ROW(srai),   ROW(beq),
    ROW(bne),  ROW(blt),  ROW(bge),  ROW(bltu), ROW(bgeu),
};

/* Edges of both kinds of number, division by zero and its overflow among their pairs. */
static const uint32_t edges[] = {
    0,          1,          2,          0xFFFFFFFF, 0x80000000, 0x7FFFFFFF,
    0x80000001, 0xFFFF8000, 0x00010000, 0x55555555, 0xFFFFFFF9, 7,
};

#define EDGES (sizeof edges / sizeof *edges)

static uint32_t sum_of(uint32_t (*run)(uint32_t, uint32_t))
{
    uint32_t sum = TABLES_SUM_START, state = 1;
    for (unsigned i = 0; i < EDGES * EDGES; i++)
        sum = tables_sum(sum, run(edges[i / EDGES], edges[i % EDGES]));
    for (int i = 0; i < 2000; i++) {
        uint32_t a = tables_random(&state), b = tables_random(&state);
        /* Divisors and distances of every size. */
        sum = tables_sum(sum, run(a, b >> (a & 31)));
    }
    return sum;
}

void tables_integers(void)
{
    static const uint32_t pairs[][2] = {
        {7, 3}, {0xFFFFFFF9, 3}, {5, 0}, {0x80000000, 0xFFFFFFFF}, {0x80000000, 33},
    };
    printf("integers: check sum, then");
    for (unsigned k = 0; k < sizeof pairs / sizeof *pairs; k++)
        printf(" (%lx, %lx)", (unsigned long)pairs[k][0], (unsigned long)pairs[k][1]);
    printf("\n");
    for (unsigned i = 0; i < sizeof operations / sizeof *operations; i++) {
        printf("%-6s %08lx", operations[i].name, (unsigned long)sum_of(operations[i].run));
        for (unsigned k = 0; k < sizeof pairs / sizeof *pairs; k++)
            printf(" %08lx", (unsigned long)operations[i].run(pairs[k][0], pairs[k][1]));
        printf("\n");
    }
}
