/* processor_rig.h — a machine with firmware given word by word and a display file beside it; the
 * programs that its tests share. */
#ifndef TESTS_PROCESSOR_RIG_H
#define TESTS_PROCESSOR_RIG_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "display_file/df_regs.h"
#include "emu/machine.h"
#include "emu/memmap.h"

#define COUNT(a) (sizeof(a) / sizeof *(a))
#define US       CRT_PS_PER_US
#define MS       CRT_PS_PER_MS
#define CYCLE    20000u /* ps at 50 MHz */
#define AVERAGE  (10 * US)

/* Instructions, as The RISC-V Instruction Set Manual I encodes them. */
enum { ZERO = 0, T0 = 5, T1 = 6, A0 = 10, A1, A2, A3, A4, A5 };
#define I(op, f3, rd, rs1, imm)                                                                    \
    ((uint32_t)(imm) << 20 | (uint32_t)(rs1) << 15 | (f3) << 12 | (uint32_t)(rd) << 7 | (op))
#define ADDI(rd, rs1, imm)   I(0x13u, 0u, rd, rs1, imm)
#define LUI(rd, upper)       ((uint32_t)(upper) << 12 | (uint32_t)(rd) << 7 | 0x37u)
#define LOAD(f3, rd, rs1, i) I(0x03u, f3, rd, rs1, i)
#define STORE(f3, rs2, rs1, imm)                                                                   \
    (((uint32_t)(imm) >> 5 & 0x7F) << 25 | (uint32_t)(rs2) << 20 | (uint32_t)(rs1) << 15 |         \
     (f3) << 12 | ((uint32_t)(imm)&0x1F) << 7 | 0x23u)
#define LBU(rd, rs1, imm) LOAD(4u, rd, rs1, imm)
#define LHU(rd, rs1, imm) LOAD(5u, rd, rs1, imm)
#define LW(rd, rs1, imm)  LOAD(2u, rd, rs1, imm)
#define SB(rs2, rs1, imm) STORE(0u, rs2, rs1, imm)
#define SH(rs2, rs1, imm) STORE(1u, rs2, rs1, imm)
#define SW(rs2, rs1, imm) STORE(2u, rs2, rs1, imm)
#define JUMP_BACK(words)                                                                           \
    ((0x80000000u | (((uint32_t)(-4 * (words)) >> 1 & 0x3FF) << 21) |                              \
      (((uint32_t)(-4 * (words)) >> 11 & 1) << 20) | ((uint32_t)(-4 * (words)) & 0xFF000)) |       \
     0x6Fu)
#define CSRW(csr, rs1) I(0x73u, 1u, 0, rs1, csr)
#define WFI            0x10500073u
#define NOP            ADDI(ZERO, ZERO, 0)

#define POINT (DF_SET_MODE | DF_MODE_POINT << DF_MODE_SHIFT)

struct bench {
    struct vm_machine *m;
    struct vm_board *board;
    struct vm_console console;
    struct df_program display;
};

static inline void transmit(void *ctx, uint8_t byte, uint64_t t)
{
    vm_console_print(ctx, byte, t);
}

static inline void boot(struct bench *b, const uint32_t *code, size_t words, bool display)
{
    struct crt_error err;
    uint8_t *bytes = malloc(4 * words);
    assert_non_null(bytes);
    for (size_t i = 0; i < 4 * words; i++)
        bytes[i] = (uint8_t)(code[i / 4] >> 8 * (i % 4));
    const struct vm_elf elf = {.segment = {{MAP_PROGRAM, bytes, (uint32_t)(4 * words),
                                            (uint32_t)(4 * words), false, true}},
                               .segments = 1,
                               .entry = MAP_PROGRAM};
    assert_true(vm_machine_boot(b->m, &elf, display ? &b->display : NULL, "test", &err));
    free(bytes);
}

/* Instructions at the begin of program memory, in ROM; a display file at 01000. */
static inline struct bench *set_up(const uint32_t *code, size_t words, const uint16_t *file,
                                   size_t length)
{
    struct bench *b = calloc(1, sizeof *b);
    struct crt_error err;
    const struct crt_tube_row *row = crt_tube_row_find("VR17");
    struct df_timing timing = df_timing_of_tube(row, DF_TIMING_VALUE);
    timing.average_ps = AVERAGE;
    assert_non_null(b);
    b->m = calloc(1, sizeof *b->m);
    assert_non_null(b->m);
    vm_console_init(&b->console, &(struct vm_console_desc){NULL, NULL, NULL});
    b->board = vm_board_create((struct crt_rate){VM_CPU_HZ, 1},
                               &(struct vm_uart_out){&b->console, transmit}, &err);
    assert_non_null(b->board);
    assert_true(df_program_init(&b->display, &err));
    for (size_t i = 0; i < length; i++)
        df_program_put(&b->display, 01000 + 2 * (uint32_t)i, file[i]);
    b->display.entry = 01000;
    vm_machine_init(b->m, &(struct vm_machine_desc){.row = row,
                                                    .timing = timing,
                                                    .tick = {60, 1},
                                                    .memory_bytes = 65536,
                                                    .board = b->board,
                                                    .console = &b->console});
    boot(b, code, words, length > 0);
    return b;
}

static inline void tear_down(struct bench *b)
{
    df_program_free(&b->display);
    vm_console_free(&b->console);
    vm_board_destroy(b->board);
    free(b->m);
    free(b);
}

/* ---- programs ---- */

/* Starts the display file, then stores 1, 2, 3 … as the word at 01002, every fifth cycle. */
static const uint32_t writer[] = {
    LUI(A0, MAP_DISPLAY >> 12),
    ADDI(A0, A0, 01002),
    LUI(A1, MAP_DPU >> 12),
    ADDI(A2, ZERO, 01000),
    SH(A2, A1, DF_DPC),
    ADDI(A3, ZERO, 0),
    ADDI(A3, A3, 1),
    I(0x13u, 7u, A3, A3, 0x3FF), /* andi */
    SH(A3, A0, 0),
    NOP,
    JUMP_BACK(4),
};
#define FIRST_STORE 8 /* its cycle */
#define EVERY       5

static const uint16_t looped[] = {POINT, 0, 100, DF_JUMP, 01000};

/* Waits for stop interrupts; starts the file again and counts in a0. The handler is at 0x40. */
static const uint32_t stopper[] = {
    /* 00 */ LUI(A1, MAP_DPU >> 12),
    /* 04 */ ADDI(A2, ZERO, 01000),
    /* 08 */ LUI(A3, MAP_IRQ >> 12),
    /* 0c */ ADDI(T0, ZERO, 1 << IRQ_LINE_STOP),
    /* 10 */ SW(T0, A3, IRQ_ENABLE),
    /* 14 */ LUI(T0, MAP_PROGRAM >> 12),
    /* 18 */ ADDI(T0, T0, 0x40),
    /* 1c */ CSRW(0x305, T0), /* mtvec */
    /* 20 */ LUI(T1, 1),
    /* 24 */ ADDI(T1, T1, -2048),
    /* 28 */ CSRW(0x304, T1),           /* mie: external */
    /* 2c */ SH(A2, A1, DF_DPC),        /* cycle 11 */
    /* 30 */ I(0x73u, 6u, 0, 8, 0x300), /* csrsi mstatus, MIE */
    /* 34 */ WFI,
    /* 38 */ JUMP_BACK(1),
    /* 3c */ NOP,
    /* 40 */ ADDI(A0, A0, 1),
    /* 44 */ LW(A4, A3, IRQ_CLAIM),
    /* 48 */ SH(A2, A1, DF_DPC),
    /* 4c */ LW(A5, A3, IRQ_CLAIM),
    /* 50 */ 0x30200073u, /* mret */
};

static const uint16_t stopping[] = {DF_STATUS_A | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON, POINT,
                                    DF_BEAM_ON | 100, 100, DF_STOP};

#endif
