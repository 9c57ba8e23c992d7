/* The machine with its processor: who sees what when, interrupts, goals, copies; all against closed
 * forms, and the same however the run is cut into pieces. */
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
#include "emu/trouble.h"

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

static void transmit(void *ctx, uint8_t byte, uint64_t t)
{
    vm_console_print(ctx, byte, t);
}

static void boot(struct bench *b, const uint32_t *code, size_t words, bool display)
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
static struct bench *set_up(const uint32_t *code, size_t words, const uint16_t *file, size_t length)
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

static void tear_down(struct bench *b)
{
    df_program_free(&b->display);
    vm_console_free(&b->console);
    vm_board_destroy(b->board);
    free(b->m);
    free(b);
}

/* ---- stores and fetches ------------------------------------------------------------------------- */

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

struct seen {
    uint64_t t[4096];
    uint16_t word[4096];
    size_t count;
};

static void see(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                const struct df_dpu *dpu)
{
    struct seen *s = ctx;
    (void)dpu;
    if (address != 01002 || !fetched)
        return;
    assert_true(s->count < COUNT(s->t));
    s->t[s->count] = t;
    s->word[s->count++] = word;
}

static struct seen *watch_in_pieces(uint64_t piece)
{
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    struct seen *s = calloc(1, sizeof *s);
    const struct vm_hooks hooks = {.ctx = s, .word = see};
    assert_non_null(s);
    while (b->m->now < 20 * MS)
        vm_machine_trace(b->m, b->m->now + piece < 20 * MS ? b->m->now + piece : 20 * MS, &hooks);
    tear_down(b);
    return s;
}

static void a_fetch_sees_the_stores_begun_before_it(void **state)
{
    (void)state;
    struct seen *s = watch_in_pieces(20 * MS);
    assert_true(s->count > 600);
    for (size_t i = 0; i < s->count; i++) {
        /* The n-th store begins at cycle FIRST_STORE + EVERY * (n - 1). */
        uint64_t begun = (s->t[i] + CYCLE - 1) / CYCLE; /* cycles begun before t */
        uint64_t stores = begun > FIRST_STORE ? (begun - 1 - FIRST_STORE) / EVERY + 1 : 0;
        assert_int_equal(s->word[i], stores % 1024);
    }
    free(s);
}

static void pieces_of_a_run_change_nothing(void **state)
{
    (void)state;
    static const uint64_t pieces[] = {1 * MS, 777777, 20001, 5000000001};
    struct seen *whole = watch_in_pieces(20 * MS);
    for (size_t i = 0; i < COUNT(pieces); i++) {
        struct seen *cut = watch_in_pieces(pieces[i]);
        assert_memory_equal(cut, whole, sizeof *cut);
        free(cut);
    }
    free(whole);
}

/* ---- interrupts --------------------------------------------------------------------------------- */

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

static void stop_interrupts_come_when_the_word_is_done(void **state)
{
    (void)state;
    struct bench *b = set_up(stopper, COUNT(stopper), stopping, COUNT(stopping));
    /* A refresh is four instructions of AVERAGE; the handler begins at the first cycle not before
     * its end, and starts the file again three cycles after that. */
    uint64_t start = 11 * CYCLE, n = 0;
    while (start + 4 * AVERAGE < 10 * MS) {
        uint64_t end = start + 4 * AVERAGE, taken = (end + CYCLE - 1) / CYCLE * CYCLE;
        vm_machine_run(b->m, end);
        assert_int_equal(b->board->irq.pending & 1 << IRQ_LINE_STOP, 0);
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->m->stops, n + 1);
        vm_machine_run(b->m, taken + CYCLE);
        n++;
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->board->irq.pending & 1 << IRQ_LINE_STOP, 1 << IRQ_LINE_STOP);
        start = taken + 2 * CYCLE;
        vm_machine_run(b->m, start + 2 * CYCLE);
        assert_int_equal(b->board->cpu.x[A4], IRQ_LINE_STOP);
        assert_int_equal(b->board->cpu.x[A5], 0);
    }
    assert_true(n > 200);
    assert_int_equal(b->m->refreshes.last.number, n);
    assert_int_equal(b->m->refreshes.last.words, 5);
    tear_down(b);
}

/* Nothing but the stop: the line falls at START and rises when that word is done. */
static void a_line_falls_at_start_though_the_first_word_raises_it(void **state)
{
    (void)state;
    static const uint16_t stop[] = {DF_STATUS_A | DF_LSA_STOP_INT | DF_LSA_STOP_INT_ON |
                                    DF_LSA_STOP};
    struct bench *b = set_up(stopper, COUNT(stopper), stop, COUNT(stop));
    uint64_t start = 11 * CYCLE;
    for (uint32_t n = 1; n < 20; n++) {
        uint64_t taken = (start + AVERAGE + CYCLE - 1) / CYCLE * CYCLE;
        vm_machine_run(b->m, taken + 4 * CYCLE);
        assert_int_equal(b->board->cpu.x[A0], n);
        assert_int_equal(b->board->cpu.x[A4], IRQ_LINE_STOP);
        assert_int_equal(b->board->cpu.x[A5], 0);
        start = taken + 2 * CYCLE;
    }
    tear_down(b);
}

/* ---- registers ---------------------------------------------------------------------------------- */

/* Runs code that ends in WFI with interrupts off, and returns the bench. */
static struct bench *run_code(const uint32_t *code, size_t words)
{
    struct bench *b = set_up(code, words, looped, COUNT(looped));
    vm_machine_run(b->m, MS);
    return b;
}

static void display_memory_takes_all_widths(void **state)
{
    (void)state;
    static const uint32_t code[] = {
        LUI(A0, MAP_DISPLAY >> 12),
        LUI(A1, 0x12345),
        ADDI(A1, A1, 0x678),
        SW(A1, A0, 0x100),
        SB(A1, A0, 0x101),
        SH(A1, A0, 0x106),
        LW(A2, A0, 0x100),
        LHU(A3, A0, 0x102),
        LBU(A4, A0, 0x101),
        LW(A5, A0, 0x104),
        WFI,
    };
    struct bench *b = run_code(code, COUNT(code));
    assert_int_equal(b->m->memory[0x80], 0x7878);
    assert_int_equal(b->m->memory[0x81], 0x1234);
    assert_int_equal(b->m->memory[0x83], 0x5678);
    assert_int_equal(b->board->cpu.x[A2], 0x12347878);
    assert_int_equal(b->board->cpu.x[A3], 0x1234);
    assert_int_equal(b->board->cpu.x[A4], 0x78);
    assert_int_equal(b->board->cpu.x[A5], 0x56780000);
    tear_down(b);
}

static void identity_says_what_is_here(void **state)
{
    (void)state;
    static const uint32_t code[] = {
        LUI(A0, MAP_IDENTITY >> 12), LW(A1, A0, IDENTITY_MAGIC),
        LW(A2, A0, IDENTITY_HEADS),  LW(A3, A0, IDENTITY_ENTRY),
        LW(A4, A0, IDENTITY_CLOCK),  SW(A3, A0, IDENTITY_MARK),
        LW(A5, A0, IDENTITY_TICK),   WFI,
    };
    struct bench *b = run_code(code, COUNT(code));
    assert_int_equal(b->board->cpu.x[A1], IDENTITY_KNSC);
    assert_int_equal(b->board->cpu.x[A2], 1);
    assert_int_equal(b->board->cpu.x[A3], 01000);
    assert_int_equal(b->board->cpu.x[A4], VM_CPU_HZ);
    assert_int_equal(b->board->cpu.x[A5], 0);
    assert_int_equal(b->m->marks, 1);
    assert_int_equal(b->m->mark, 01000);
    tear_down(b);
}

/* Each would be an access fault; with mtvec 0 nobody handles it. */
static void what_no_device_takes_is_a_fault_nobody_handles(void **state)
{
    (void)state;
    const struct {
        uint32_t instruction, base, cause;
    } cases[] = {
        {LBU(A1, A0, 0), MAP_DPU, RV_LOAD_FAULT},              /* width */
        {LW(A1, A0, 0), MAP_DPU, RV_LOAD_FAULT},               /* width */
        {SH(A1, A0, 040), MAP_DPU, RV_STORE_FAULT},            /* no such register */
        {LHU(A1, A0, 0), MAP_IDENTITY, RV_LOAD_FAULT},         /* width */
        {SW(A1, A0, 0), MAP_IDENTITY, RV_STORE_FAULT},         /* read-only */
        {LW(A1, A0, 0), MAP_DISPLAY + 0x10000, RV_LOAD_FAULT}, /* beyond what memory there is */
        {LW(A1, A0, 0), 0x50000000, RV_LOAD_FAULT},            /* nobody */
        {SW(A1, A0, 0), MAP_PROGRAM, RV_STORE_FAULT},          /* ROM */
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        const uint32_t code[] = {LUI(A0, cases[i].base >> 12), cases[i].instruction, WFI};
        struct bench *b = set_up(code, COUNT(code), looped, COUNT(looped));
        struct vm_input input = {.name = "test"};
        struct crt_error err;
        assert_true(vm_machine_run_end(b->m, MS));
        assert_int_equal(b->board->cpu.state, RV_HALTED);
        assert_int_equal(b->board->cpu.trouble.cause, cases[i].cause);
        assert_int_equal(b->board->cpu.trouble.pc, MAP_PROGRAM + 4);
        assert_int_equal(vm_find_trouble(b->m, &input, &err), VM_TROUBLE_TRAP);
        assert_non_null(strstr(err.text, "80000004"));
        tear_down(b);
    }
}

static void firmware_can_be_booted_again_after_it_was_lost(void **state)
{
    (void)state;
    static const uint32_t lost[] = {LUI(A0, 0x50000), LW(A1, A0, 0)};
    static const uint8_t counting[] = {0x13, 0x05, 0x15, 0,
                                       0x6f, 0xf0, 0xdf, 0xff}; /* addi a0; j */
    const struct vm_elf elf = {
        .segment = {{MAP_PROGRAM, counting, sizeof counting, sizeof counting, false, true}},
        .segments = 1,
        .entry = MAP_PROGRAM};
    struct bench *b = set_up(lost, COUNT(lost), NULL, 0);
    struct crt_error err;
    assert_true(vm_machine_run_end(b->m, MS));
    vm_machine_run(b->m, MS);
    assert_true(vm_machine_boot(b->m, &elf, NULL, "again", &err));
    vm_machine_run(b->m, 2 * MS);
    assert_int_equal(b->board->cpu.state, RV_RUNNING);
    assert_int_equal(b->board->cpu.x[A0], MS / CYCLE / 2);
    assert_int_equal(b->board->cpu.cycle, 2 * MS / CYCLE);
    tear_down(b);
}

/* ---- goals -------------------------------------------------------------------------------------- */

static void the_finisher_ends_a_run_with_its_status(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_FINISHER >> 12), LUI(A1, 0x73), ADDI(A1, A1, 0x333),
                                    SW(A1, A0, 0), JUMP_BACK(0)};
    struct bench *b = set_up(code, COUNT(code), NULL, 0);
    int status = 0;
    assert_true(vm_machine_run_end(b->m, MS));
    assert_int_equal(b->m->now, 4 * CYCLE);
    assert_true(vm_machine_exited(b->m, &status));
    assert_int_equal(status, 7);
    vm_machine_run(b->m, 2 * MS);
    assert_int_equal(b->m->now, 2 * MS);
    assert_int_equal(rv_retired(&b->board->cpu), 4);
    tear_down(b);
}

/* Power-on again is at the present time, however long ago the processor ended. */
static void firmware_that_has_ended_can_be_booted_again(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_FINISHER >> 12), LUI(A1, 5), ADDI(A1, A1, 0x555),
                                    SW(A1, A0, 0), JUMP_BACK(0)};
    struct bench *b = set_up(code, COUNT(code), NULL, 0);
    assert_true(vm_machine_run_end(b->m, MS));
    vm_machine_run(b->m, 2 * MS);
    boot(b, code, COUNT(code), false);
    assert_true(vm_machine_run_end(b->m, 3 * MS));
    assert_int_equal(b->m->now, 2 * MS + 4 * CYCLE);
    assert_int_equal(b->board->finisher.t, 2 * MS + 3 * CYCLE);
    assert_int_equal(rv_retired(&b->board->cpu), 8);
    tear_down(b);
}

/* Also where the firmware says itself what a refresh is. */
static void a_stop_is_when_its_word_is_done(void **state)
{
    (void)state;
    static const uint32_t code[] = {LUI(A0, MAP_IDENTITY >> 12), SW(ZERO, A0, IDENTITY_REFRESH),
                                    LUI(A1, MAP_DPU >> 12),      ADDI(A2, ZERO, 01000),
                                    SH(A2, A1, DF_DPC),          WFI};
    struct bench *b = set_up(code, COUNT(code), stopping, COUNT(stopping));
    assert_true(vm_machine_run_stop(b->m, MS));
    assert_int_equal(b->m->now, 4 * CYCLE + 4 * AVERAGE);
    assert_int_equal(b->m->now, b->m->last_stop);
    tear_down(b);
}

/* The instruction begun when the word was fetched has been executed, too. */
static void where_a_word_was_reached_can_be_saved(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    for (uint64_t n = 1; n < 20; n++) {
        struct crt_state s;
        assert_true(vm_machine_run_words(b->m, n, MS));
        crt_state_save(&s);
        vm_machine_state(b->m, &s);
        if (s.failed)
            fail_msg("%s", s.err.text);
        crt_state_free(&s);
    }
    tear_down(b);
}

static void runs_stop_at_an_instruction_or_a_word(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    for (uint64_t n = 1; n < 3000; n += 7) {
        assert_true(vm_machine_run_retired(b->m, n, MS));
        assert_int_equal(rv_retired(&b->board->cpu), n);
        assert_int_equal(b->m->now, n * CYCLE);
    }
    uint64_t words = b->m->dpu.words;
    for (uint64_t n = words + 1; n < words + 100; n++) {
        assert_true(vm_machine_run_words(b->m, n, MS));
        assert_int_equal(b->m->dpu.words, n);
        assert_true(b->board->cpu.cycle >= b->m->now / CYCLE);
        assert_true((b->board->cpu.cycle - 1) * CYCLE < b->m->now);
    }
    assert_false(vm_machine_run_retired(b->m, UINT64_MAX, b->m->now + US));
    tear_down(b);
}

static bool at_the_store(void *ctx, struct rv_cpu *cpu)
{
    (void)ctx;
    return cpu->pc == MAP_PROGRAM + 8 * 4 && cpu->x[A3] == 100;
}

static void a_debugger_stops_before_an_instruction(void **state)
{
    (void)state;
    struct bench *b = set_up(writer, COUNT(writer), looped, COUNT(looped));
    const struct rv_hooks hooks = {NULL, at_the_store, NULL, NULL};
    assert_true(vm_machine_watch(b->m, 10 * MS, &hooks));
    uint64_t cycle = FIRST_STORE + EVERY * 99;
    assert_int_equal(b->m->now, cycle * CYCLE);
    assert_int_equal(b->board->cpu.cycle, cycle);
    assert_true(b->m->memory[01002 / 2] == 99);
    vm_machine_run(b->m, b->m->now + CYCLE);
    assert_true(b->m->memory[01002 / 2] == 100);
    tear_down(b);
}

/* ---- console ------------------------------------------------------------------------------------ */

/* Sends back each byte plus one. */
static const uint32_t echo[] = {
    LUI(A0, MAP_UART >> 12),
    LBU(A1, A0, 5),
    I(0x13u, 7u, A1, A1, 1), /* andi: data ready */
    0xfe058ce3u /* beq a1,zero,-8 */,
    LBU(A2, A0, 0),
    ADDI(A2, A2, 1),
    SB(A2, A0, 0),
    JUMP_BACK(6),
};

struct paper {
    char text[32];
    uint64_t t[32];
    size_t count;
};

static void to_paper(void *ctx, uint8_t byte, uint64_t t)
{
    struct paper *p = ctx;
    p->text[p->count] = (char)byte;
    p->t[p->count++] = t;
}

static void the_console_keeps_its_baud_rate(void **state)
{
    (void)state;
    struct bench *b = set_up(echo, COUNT(echo), NULL, 0);
    struct paper paper = {"", {0}, 0};
    b->console.desc = (struct vm_console_desc){.ctx = &paper, .sink = to_paper};
    assert_true(vm_console_type(&b->console, "HAL", 3, 100 * US));
    vm_console_watch(&b->console, "BM");
    assert_true(vm_machine_run_console(b->m, 10 * MS));
    assert_int_equal(b->m->now, paper.t[2]);
    assert_string_equal(paper.text, "IBM");
    double byte = 10e12 / 115200;
    for (int i = 1; i < 3; i++) {
        double apart = (double)(paper.t[i] - paper.t[i - 1]);
        assert_true(apart > byte * 0.999 && apart < byte * 1.02);
    }
    assert_true(paper.t[0] > 100 * US + (uint64_t)byte);
    tear_down(b);
}

/* Reads a byte, then does nothing for longer than the next one takes. */
static const uint32_t sleepy[] = {
    /* 00 */ LUI(A0, MAP_UART >> 12),
    /* 04 */ LBU(A1, A0, 0),
    /* 08 */ ADDI(T0, ZERO, 1999),
    /* 0c */ NOP,
    /* 10 */ ADDI(T0, T0, -1),
    /* 14 */ 0xfe029ce3u, /* bne t0,zero,-8 */
    /* 18 */ JUMP_BACK(5),
};

static void pieces_do_not_change_when_bytes_arrive(void **state)
{
    (void)state;
    struct bench *whole = set_up(sleepy, COUNT(sleepy), NULL, 0);
    struct bench *cut = set_up(sleepy, COUNT(sleepy), NULL, 0);
    static const char text[300] = "typed";
    assert_true(vm_console_type(&whole->console, text, sizeof text, 0));
    assert_true(vm_console_type(&cut->console, text, sizeof text, 0));
    for (uint64_t t = 60 * US; t < 30 * MS; t += 120 * US) {
        vm_machine_run(whole->m, t);
        while (cut->m->now < t)
            vm_machine_run(cut->m, t - cut->m->now > 17001 ? cut->m->now + 17001 : t);
        assert_int_equal(cut->console.next, whole->console.next);
        assert_int_equal(cut->board->uart.ready_from, whole->board->uart.ready_from);
    }
    assert_true(whole->console.next > 200);
    tear_down(whole);
    tear_down(cut);
}

/* ---- copies ------------------------------------------------------------------------------------- */

static void a_copy_goes_on_alone_to_the_same_end(void **state)
{
    (void)state;
    struct bench *b = set_up(stopper, COUNT(stopper), stopping, COUNT(stopping));
    struct vm_machine *copy = malloc(sizeof *copy);
    assert_non_null(copy);
    vm_machine_run(b->m, 3333333333);
    assert_true(vm_machine_copy(copy, b->m));
    vm_machine_run(copy, 9 * MS);
    assert_int_equal(b->m->now, 3333333333);
    vm_machine_run(b->m, 9 * MS);
    assert_int_equal(copy->desc.board->cpu.x[A0], b->board->cpu.x[A0]);
    assert_int_equal(copy->desc.board->cpu.pc, b->board->cpu.pc);
    assert_int_equal(copy->desc.board->cpu.cycle, b->board->cpu.cycle);
    assert_int_equal(copy->dpu.words, b->m->dpu.words);
    assert_int_equal(copy->dpu.t, b->m->dpu.t);
    assert_int_equal(copy->refreshes.last.end, b->m->refreshes.last.end);
    /* The copy's ROM is ROM, too. */
    assert_int_equal(copy->desc.board->cpu.rom_count, 1);
    vm_machine_forget(copy);
    free(copy);
    tear_down(b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fetch_sees_the_stores_begun_before_it),
        cmocka_unit_test(pieces_of_a_run_change_nothing),
        cmocka_unit_test(stop_interrupts_come_when_the_word_is_done),
        cmocka_unit_test(a_line_falls_at_start_though_the_first_word_raises_it),
        cmocka_unit_test(display_memory_takes_all_widths),
        cmocka_unit_test(identity_says_what_is_here),
        cmocka_unit_test(what_no_device_takes_is_a_fault_nobody_handles),
        cmocka_unit_test(firmware_can_be_booted_again_after_it_was_lost),
        cmocka_unit_test(the_finisher_ends_a_run_with_its_status),
        cmocka_unit_test(firmware_that_has_ended_can_be_booted_again),
        cmocka_unit_test(a_stop_is_when_its_word_is_done),
        cmocka_unit_test(where_a_word_was_reached_can_be_saved),
        cmocka_unit_test(runs_stop_at_an_instruction_or_a_word),
        cmocka_unit_test(a_debugger_stops_before_an_instruction),
        cmocka_unit_test(the_console_keeps_its_baud_rate),
        cmocka_unit_test(pieces_do_not_change_when_bytes_arrive),
        cmocka_unit_test(a_copy_goes_on_alone_to_the_same_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
