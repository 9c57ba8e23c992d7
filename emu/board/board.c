#include "emu/board/board.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "emu/memmap.h"

/* ---- time ------------------------------------------------------------------------------------------ */

uint64_t vm_board_time(const struct vm_board *board, uint64_t cycle)
{
    return board->period_ps ? cycle * board->period_ps : crt_tick_time(board->clock, cycle);
}

uint64_t vm_board_cycle(const struct vm_board *board, uint64_t t)
{
    uint64_t n;

    if (board->period_ps)
        return t / board->period_ps + (t % board->period_ps != 0);
    n = crt_tick_at(board->clock, t);
    return crt_tick_time(board->clock, n) < t ? n + 1 : n;
}

uint64_t vm_board_now(const struct vm_board *board)
{
    return vm_board_time(board, board->cpu.cycle);
}

uint64_t vm_board_next(const struct vm_board *board)
{
    uint64_t timer = vm_clint_next(&board->clint), uart = vm_uart_next(&board->uart);
    return timer < uart ? timer : uart;
}

void vm_board_event(struct vm_board *board, uint64_t t)
{
    vm_clint_event(&board->clint, t);
    vm_uart_event(&board->uart, t);
}

/* ---- wires ----------------------------------------------------------------------------------------- */

static void timer_wire(void *ctx, bool level, uint64_t t)
{
    (void)t;
    rv_set_interrupt(&((struct vm_board *)ctx)->cpu, RV_INT_TIMER, level);
}

static void software_wire(void *ctx, bool level, uint64_t t)
{
    (void)t;
    rv_set_interrupt(&((struct vm_board *)ctx)->cpu, RV_INT_SOFTWARE, level);
}

static void external_wire(void *ctx, bool level, uint64_t t)
{
    (void)t;
    rv_set_interrupt(&((struct vm_board *)ctx)->cpu, RV_INT_EXTERNAL, level);
}

static void uart_wire(void *ctx, bool level, uint64_t t)
{
    vm_irq_set(&((struct vm_board *)ctx)->irq, IRQ_LINE_UART, level, t);
}

static void finished(void *ctx, uint8_t status, uint64_t t)
{
    (void)status;
    (void)t;
    rv_attention(&((struct vm_board *)ctx)->cpu);
}

/* ---- bus ------------------------------------------------------------------------------------------- */

/* The slice that the processor is running ends at an event; an access may have moved that. */
static bool answer(struct vm_board *board, uint64_t next, bool answered)
{
    if (vm_board_next(board) != next)
        rv_attention(&board->cpu);
    return answered;
}

/* Room in the receiver is an event for whoever has input for it. */
static bool answer_uart(struct vm_board *board, uint64_t next, uint64_t ready, bool answered)
{
    if (vm_uart_ready_at(&board->uart) != ready)
        rv_attention(&board->cpu);
    return answer(board, next, answered);
}

static bool uart_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_board *b = ctx;
    uint64_t next = vm_board_next(b), ready = vm_uart_ready_at(&b->uart);
    bool answered = vm_uart_read(&b->uart, offset, value, vm_board_now(b));

    (void)width;
    return answer_uart(b, next, ready, answered);
}

static bool uart_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_board *b = ctx;
    uint64_t next = vm_board_next(b), ready = vm_uart_ready_at(&b->uart);
    bool answered = vm_uart_write(&b->uart, offset, value, vm_board_now(b));

    (void)width;
    return answer_uart(b, next, ready, answered);
}

static bool clint_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_board *b = ctx;
    (void)width;
    return vm_clint_read(&b->clint, offset, value, vm_board_now(b));
}

static bool clint_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_board *b = ctx;
    uint64_t next = vm_board_next(b);
    bool answered = vm_clint_write(&b->clint, offset, value, vm_board_now(b));

    (void)width;
    return answer(b, next, answered);
}

static bool irq_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_board *b = ctx;
    (void)width;
    return vm_irq_read(&b->irq, offset, value, vm_board_now(b));
}

static bool irq_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_board *b = ctx;
    (void)width;
    return vm_irq_write(&b->irq, offset, value, vm_board_now(b));
}

static bool finisher_read(void *ctx, uint32_t offset, unsigned width, uint32_t *value)
{
    struct vm_board *b = ctx;
    (void)width;
    return vm_finisher_read(&b->finisher, offset, value, vm_board_now(b));
}

static bool finisher_write(void *ctx, uint32_t offset, unsigned width, uint32_t value)
{
    struct vm_board *b = ctx;
    (void)width;
    return vm_finisher_write(&b->finisher, offset, value, vm_board_now(b));
}

static bool load(void *ctx, uint32_t address, unsigned width, uint32_t *value)
{
    return bus_load(&((struct vm_board *)ctx)->bus, address, width, value);
}

static bool store(void *ctx, uint32_t address, unsigned width, uint32_t value)
{
    return bus_store(&((struct vm_board *)ctx)->bus, address, width, value);
}

static uint64_t time_csr(void *ctx)
{
    struct vm_board *b = ctx;
    return vm_clint_time(&b->clint, vm_board_now(b));
}

/* ---- set-up ---------------------------------------------------------------------------------------- */

static void add_ranges(struct vm_board *b)
{
    const struct bus_range range[] = {
        {MAP_FINISHER, MAP_FINISHER_SIZE, BUS_32, b, finisher_read, finisher_write},
        {MAP_CLINT, MAP_CLINT_SIZE, BUS_32, b, clint_read, clint_write},
        {MAP_UART, MAP_UART_SIZE, BUS_8, b, uart_read, uart_write},
        {MAP_IRQ, MAP_IRQ_SIZE, BUS_32, b, irq_read, irq_write},
    };

    bus_init(&b->bus);
    for (unsigned i = 0; i < sizeof range / sizeof range[0]; i++)
        bus_add(&b->bus, &range[i]);
}

static void init_devices(struct vm_board *b, const struct vm_uart_out *console)
{
    const struct vm_uart_desc uart = {
        .out = console ? *console : (struct vm_uart_out){NULL, NULL},
        .irq = {b, uart_wire},
    };
    const struct vm_clint_desc clint = {{b, timer_wire}, {b, software_wire}};
    const struct vm_irq_desc irq = {{b, external_wire}};
    const struct vm_finisher_desc finisher = {b, finished};

    vm_uart_init(&b->uart, &uart);
    vm_clint_init(&b->clint, &clint);
    vm_irq_init(&b->irq, &irq);
    vm_finisher_init(&b->finisher, &finisher);
}

static bool init_processor(struct vm_board *b)
{
    const struct rv_desc desc = {
        .memory = b->memory,
        .memory_base = MAP_PROGRAM,
        .memory_size = MAP_PROGRAM_SIZE,
        .bus = {b, load, store, time_csr},
    };
    return rv_init(&b->cpu, &desc);
}

struct vm_board *vm_board_create(struct crt_rate clock, const struct vm_uart_out *console,
                                 struct crt_error *err)
{
    struct vm_board *b = calloc(1, sizeof *b);
    uint8_t *memory = calloc(1, MAP_PROGRAM_SIZE); /* pages nobody touches cost nothing */
    uint64_t per_clock = CRT_PS_PER_S * clock.den;

    assert(clock.num > 0 && clock.den > 0 && clock.den <= UINT64_MAX / CRT_PS_PER_S);
    if (b)
        b->memory = memory;
    if (!b || !memory || !init_processor(b)) {
        free(memory);
        free(b);
        crt_fail(err, "out of memory for the processor's board; close other programs");
        return NULL;
    }
    b->clock = clock;
    b->period_ps = per_clock % clock.num == 0 ? per_clock / clock.num : 0;
    add_ranges(b);
    init_devices(b, console);
    return b;
}

void vm_board_destroy(struct vm_board *board)
{
    if (board == NULL)
        return;
    rv_free(&board->cpu);
    free(board->memory);
    free(board);
}

/* ---- program --------------------------------------------------------------------------------------- */

/* The clock of a processor that had ended stood still. */
static void reset(struct vm_board *b, uint64_t t)
{
    uint64_t cycle = vm_board_cycle(b, t);

    if (cycle > b->cpu.cycle) {
        b->cpu.idle += cycle - b->cpu.cycle;
        b->cpu.cycle = cycle;
    }
    rv_reset(&b->cpu);
    vm_uart_reset(&b->uart, t);
    vm_clint_reset(&b->clint, t);
    vm_irq_reset(&b->irq, t);
    vm_finisher_reset(&b->finisher);
}

static void load_segment(struct vm_board *b, const struct vm_elf_segment *segment)
{
    uint32_t low = segment->address, high = low + segment->memory_size;
    bool room = true;

    assert(low >= MAP_PROGRAM && segment->memory_size <= MAP_PROGRAM_SIZE - (low - MAP_PROGRAM));
    if (segment->file_size > 0)
        memcpy(b->memory + (low - MAP_PROGRAM), segment->bytes, segment->file_size);
    if (!segment->writable)
        room = rv_protect(&b->cpu, low, high);
    assert(room); /* RV_MAX_ROM >= VM_ELF_MAX_SEGMENTS */
    (void)room;
}

/* Pages that are 0 already are only read: the host need not provide them. */
static void clear_memory(struct vm_board *b)
{
    static const uint8_t zero[4096];

    for (size_t at = 0; at < MAP_PROGRAM_SIZE; at += sizeof zero)
        if (memcmp(b->memory + at, zero, sizeof zero) != 0)
            memset(b->memory + at, 0, sizeof zero);
}

void vm_board_load(struct vm_board *board, const struct vm_elf *elf, uint64_t t)
{
    clear_memory(board);
    rv_writable(&board->cpu);
    reset(board, t);
    for (int i = 0; i < elf->segments; i++)
        load_segment(board, &elf->segment[i]);
    rv_changed(&board->cpu, MAP_PROGRAM, MAP_PROGRAM + MAP_PROGRAM_SIZE);
    board->cpu.pc = elf->entry;
}

/* ---- snapshot -------------------------------------------------------------------------------------- */

static bool wires_agree(const struct vm_board *b)
{
    uint32_t mip = (uint32_t)b->clint.software << RV_INT_SOFTWARE |
                   (uint32_t)b->clint.timer << RV_INT_TIMER |
                   (uint32_t)b->irq.level << RV_INT_EXTERNAL;
    return b->cpu.mip == mip && b->uart.level == (b->irq.pending >> IRQ_LINE_UART & 1);
}

/* Later than any run comes, with room for sums. */
#define LAST_TIME (UINT64_MAX - 1000 * CRT_PS_PER_S)

/* The processor has not run past what devices have still to do, nor the run ended in the future. */
static bool times_agree(const struct vm_board *b)
{
    uint64_t next = vm_board_next(b);

    if (b->cpu.cycle > vm_board_cycle(b, LAST_TIME))
        return false;
    if (next != UINT64_MAX && b->cpu.cycle > vm_board_cycle(b, next))
        return false;
    return !b->finisher.done || b->finisher.t <= vm_board_now(b);
}

/* Read-only ranges are the program's; they come with memory. */
static void rom_state(struct vm_board *b, struct crt_state *s)
{
    struct rv_range rom[RV_MAX_ROM];
    unsigned count = (unsigned)b->cpu.rom_count;

    memcpy(rom, b->cpu.rom, sizeof rom);
    crt_state_unsigned(s, &count, RV_MAX_ROM);
    if (s->loading)
        rv_writable(&b->cpu);
    for (unsigned i = 0; i < count; i++) {
        crt_state_u32(s, &rom[i].low);
        crt_state_u32(s, &rom[i].high);
        bool within = rom[i].low >= MAP_PROGRAM && rom[i].low <= rom[i].high &&
                      rom[i].high <= MAP_PROGRAM + MAP_PROGRAM_SIZE;
        if (crt_state_check(s, within, "read-only memory") && s->loading)
            rv_protect(&b->cpu, rom[i].low, rom[i].high);
    }
}

void vm_board_state(struct vm_board *board, struct crt_state *s)
{
    crt_state_begin(s, "PMEM", 1);
    crt_state_pages(s, board->memory, MAP_PROGRAM_SIZE);
    rom_state(board, s);
    crt_state_end(s);
    rv_state(&board->cpu, s);
    vm_uart_state(&board->uart, s);
    vm_clint_state(&board->clint, s);
    vm_irq_state(&board->irq, s);
    vm_finisher_state(&board->finisher, s);
    if (!s->loading)
        return;
    crt_state_check(s, wires_agree(board), "interrupt wiring");
    crt_state_check(s, times_agree(board), "time of the processor");
}
