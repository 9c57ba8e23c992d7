/* Loads and stores of every width, sign and offset; code that is data first. */
#include <stdio.h>
#include <string.h>

#include "roms/tables/tables.h"

static uint8_t bytes[64] __attribute__((aligned(8)));

static void fill(void)
{
    for (unsigned i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i * 37 + 0x80);
}

static uint32_t sum_of_bytes(void)
{
    uint32_t sum = TABLES_SUM_START;
    for (unsigned i = 0; i < sizeof bytes; i++)
        sum = tables_sum(sum, bytes[i]);
    return sum;
}

#define LOAD(mnemonic, offset)                                                                     \
    do {                                                                                           \
        uint32_t value;                                                                            \
        __asm__ volatile(mnemonic " %0, " offset "(%1)"                                            \
                         : "=r"(value)                                                             \
                         : "r"(bytes + 32)                                                         \
                         : "memory");                                                              \
        printf("%-3s %4s %08lx\n", mnemonic, offset, (unsigned long)value);                        \
    } while (0)

#define STORE(mnemonic, offset)                                                                    \
    do {                                                                                           \
        fill();                                                                                    \
        __asm__ volatile(mnemonic " %0, " offset "(%1)"                                            \
                         :                                                                         \
                         : "r"(0xA1B2C3D4u), "r"(bytes + 32)                                       \
                         : "memory");                                                              \
        printf("%-3s %4s %08lx\n", mnemonic, offset, (unsigned long)sum_of_bytes());               \
    } while (0)

static void widths(void)
{
    fill();
    LOAD("lb", "-1");
    LOAD("lb", "0");
    LOAD("lb", "1");
    LOAD("lb", "2");
    LOAD("lbu", "3");
    LOAD("lbu", "-4");
    LOAD("lh", "-2");
    LOAD("lh", "2");
    LOAD("lhu", "-32");
    LOAD("lhu", "30");
    LOAD("lw", "-32");
    LOAD("lw", "28");
    STORE("sb", "-1");
    STORE("sb", "1");
    STORE("sb", "3");
    STORE("sh", "-2");
    STORE("sh", "2");
    STORE("sw", "-32");
    STORE("sw", "28");
}

/* A word goes through a float register unchanged, also when it is a signalling NaN. */
static void floats(void)
{
    static const uint32_t words[] = {0x7F800001, 0xFFC12345, 0x80000001, 0xDEADBEEF};
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++) {
        uint32_t copy = 0;
        __asm__ volatile("flw ft0, 0(%0); fsw ft0, 0(%1)"
                         :
                         : "r"(&words[i]), "r"(&copy)
                         : "ft0", "memory");
        printf("flw %08lx fsw %08lx\n", (unsigned long)words[i], (unsigned long)copy);
    }
}

/* A function is written, called, changed and called again. */
static void changed_code(void)
{
    static uint32_t code[2] __attribute__((aligned(8)));
    uint32_t (*run)(void) = (uint32_t(*)(void))(uintptr_t)code;
    printf("changed code:");
    for (uint32_t number = 1; number <= 3; number++) {
        code[0] = number << 20 | 10 << 7 | 0x13; /* li a0, number */
        code[1] = 0x00008067;                    /* ret */
        __asm__ volatile(".option push; .option arch, +zifencei; fence.i; .option pop"
                         :
                         :
                         : "memory");
        printf(" %lu", (unsigned long)run());
    }
    printf("\n");
}

/* A megabyte of program memory, a page apart and back: nothing is kept in two places. */
static void far_apart(void)
{
    static uint32_t room[0x40000];
    uint32_t sum = TABLES_SUM_START;
    for (uint32_t i = 0; i < 256; i++)
        room[i * 1024] = i * 0x01010101u;
    for (uint32_t i = 256; i-- > 0;)
        sum = tables_sum(sum, room[i * 1024]);
    memmove((uint8_t *)room + 4097, room, sizeof room / 2);
    for (uint32_t i = 0; i < sizeof room / sizeof *room; i += 7)
        sum = tables_sum(sum, room[i]);
    printf("far apart %08lx\n", (unsigned long)sum);
}

void tables_memory(void)
{
    printf("memory\n");
    widths();
    floats();
    changed_code();
    far_apart();
}
