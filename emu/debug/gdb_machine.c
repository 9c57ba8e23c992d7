#include "emu/debug/gdb_machine.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

#include "crt/penetration.h"
#include "display_file/df_regs.h"
#include "emu/cpu/rv_disasm.h"
#include "emu/memmap.h"
#include "emu/quantity.h"

#define SLICE_PS  (CRT_PS_PER_S / 1000)
#define REGISTERS 8 /* bytes of the display processor's: DPC, MPR, XPR, YPR */

/* ---- time ---- */

static uint64_t now(void *ctx)
{
    return ((struct vm_machine *)ctx)->now;
}

static bool exited(void *ctx, int *status)
{
    return vm_machine_exited(ctx, status);
}

static void run(void *ctx, uint64_t until)
{
    vm_machine_run_end(ctx, until);
}

static bool watch(void *ctx, uint64_t until, const struct rv_hooks *hooks)
{
    return vm_machine_watch(ctx, until, hooks);
}

/* ---- memory ---- */

/* How many bytes of [address, address + size) lie in a range from its first on. */
static size_t within(uint32_t address, size_t size, uint32_t base, uint32_t length)
{
    uint32_t offset = address - base;
    if (offset >= length)
        return 0;
    return size < length - offset ? size : length - offset;
}

static uint8_t display_byte(const struct vm_machine *m, uint32_t offset)
{
    return (uint8_t)(m->memory[offset / 2] >> 8 * (offset & 1));
}

static void set_display_byte(struct vm_machine *m, uint32_t offset, uint8_t byte)
{
    uint16_t *word = &m->memory[offset / 2];
    unsigned shift = 8 * (offset & 1);
    *word = (uint16_t)((*word & ~(0xFFu << shift)) | (unsigned)byte << shift);
}

static uint8_t register_byte(const struct vm_machine *m, uint32_t offset)
{
    return (uint8_t)(df_dpu_read(&m->dpu, offset & ~1u) >> 8 * (offset & 1));
}

static size_t read(void *ctx, uint32_t address, uint8_t *bytes, size_t size)
{
    const struct vm_machine *m = ctx;
    size_t n = within(address, size, MAP_PROGRAM, MAP_PROGRAM_SIZE);
    if (n > 0) {
        memcpy(bytes, m->desc.board->memory + (address - MAP_PROGRAM), n);
        return n;
    }
    n = within(address, size, MAP_DISPLAY, m->desc.memory_bytes);
    for (uint32_t i = 0; i < n; i++)
        bytes[i] = display_byte(m, address - MAP_DISPLAY + i);
    if (n > 0)
        return n;
    n = within(address, size, MAP_DPU, REGISTERS);
    for (uint32_t i = 0; i < n; i++)
        bytes[i] = register_byte(m, address - MAP_DPU + i);
    return n;
}

static size_t write(void *ctx, uint32_t address, const uint8_t *bytes, size_t size)
{
    struct vm_machine *m = ctx;
    size_t n = within(address, size, MAP_PROGRAM, MAP_PROGRAM_SIZE);
    if (n > 0) {
        memcpy(m->desc.board->memory + (address - MAP_PROGRAM), bytes, n);
        rv_changed(&m->desc.board->cpu, address, address + (uint32_t)n);
        return n;
    }
    n = within(address, size, MAP_DISPLAY, m->desc.memory_bytes);
    for (uint32_t i = 0; i < n; i++)
        set_display_byte(m, address - MAP_DISPLAY + i, bytes[i]);
    return n;
}

/* ---- monitor commands ---- */

static void tell_time(const struct vm_machine *m, char *text, size_t size)
{
    const struct rv_cpu *cpu = &m->desc.board->cpu;
    char seconds[40];
    vm_format_seconds(m->now, seconds, sizeof seconds);
    snprintf(text, size, "%s, cycle %llu, %llu instructions, %llu sync ticks, %llu refreshes\n",
             seconds, (unsigned long long)cpu->cycle, (unsigned long long)rv_retired(cpu),
             (unsigned long long)(m->ticks - 1), (unsigned long long)m->refreshes.last.number);
}

static void tell_processor(const struct vm_machine *m, char *text, size_t size)
{
    const struct rv_cpu *cpu = &m->desc.board->cpu;
    char line[RV_DISASM_MAX] = "not in program memory";
    uint32_t word;
    if (rv_fetch(cpu, cpu->pc, &word))
        rv_disasm(cpu->pc, word, line, sizeof line);
    int n = snprintf(text, size, "pc %08x: %s\n", (unsigned)cpu->pc, line);
    if (n < 0 || (size_t)n >= size)
        return;
    if (cpu->state == RV_HALTED)
        snprintf(text + n, size - (size_t)n, "lost: nobody handles this: %s, value %08x\n",
                 rv_cause_name(cpu->trouble.cause), (unsigned)cpu->trouble.value);
    else if (cpu->state == RV_WAITING)
        snprintf(text + n, size - (size_t)n, "waits for an interrupt (wfi); enabled: mie %08x\n",
                 (unsigned)cpu->mie);
}

static const char *dpu_state(const struct df_dpu *dpu)
{
    static const char *const names[] = {
        [DF_STOPPED] = "stopped",
        [DF_RUNNING] = "running",
        [DF_WAITING_SYNC] = "waiting for the sync tick",
        [DF_WAITING_RESUME] = "waiting for RESUME",
    };
    if (dpu->timeout)
        return "bus time-out";
    return dpu->illegal ? "fetching an illegal word again and again" : names[dpu->state];
}

static void tell_dpu(const struct vm_machine *m, char *text, size_t size)
{
    const struct df_dpu *dpu = &m->dpu;
    enum crt_level level = df_dpu_level(dpu);
    snprintf(text, size,
             "%s; octal: DPC %06o MPR %06o XPR %06o YPR %06o\n"
             "x %d y %d, %s%s%llu words, %llu strokes, %llu stops\n",
             dpu_state(dpu), (unsigned)df_dpu_read(dpu, DF_DPC), (unsigned)df_dpu_read(dpu, DF_MPR),
             (unsigned)df_dpu_read(dpu, DF_XPR), (unsigned)df_dpu_read(dpu, DF_YPR), (int)dpu->x,
             (int)dpu->y, level == CRT_LEVEL_ONLY ? "" : crt_level_name(level),
             level == CRT_LEVEL_ONLY ? "" : ", ", (unsigned long long)dpu->words,
             (unsigned long long)m->strokes, (unsigned long long)m->stops);
}

static void tell_lines(const struct vm_machine *m, char *text, size_t size)
{
    static const char *const names[IRQ_LINES] = {
        [IRQ_LINE_STOP] = "stop",   [IRQ_LINE_PEN] = "pen",         [IRQ_LINE_CHAR] = "character",
        [IRQ_LINE_NAME] = "name",   [IRQ_LINE_RETRACE] = "retrace", [IRQ_LINE_COMPARE] = "compare",
        [IRQ_LINE_INPUT] = "input", [IRQ_LINE_UART] = "uart",
    };
    const struct vm_irq *irq = &m->desc.board->irq;
    const struct vm_clint *clint = &m->desc.board->clint;
    size_t used = 0;
    for (int i = 1; i < IRQ_LINES; i++) {
        int n = snprintf(text + used, size - used, "%d %-9s  %s  %s\n", i, names[i],
                         irq->pending >> i & 1 ? "high" : "low ",
                         irq->enable >> i & 1 ? "enabled" : "-");
        used += n > 0 && (size_t)n < size - used ? (size_t)n : 0;
    }
    snprintf(text + used, size - used, "  timer      %s\n  software   %s\n",
             clint->timer ? "high" : "low", clint->software ? "high" : "low");
}

static void tell_help(const struct vm_machine *m, char *text, size_t size)
{
    (void)m;
    snprintf(text, size,
             "time         simulated time, clock, instructions, ticks, refreshes\n"
             "cpu          the instruction about to be executed; why the processor waits\n"
             "dpu          the display processor\n"
             "lines        the interrupt lines\n");
}

static bool monitor(void *ctx, const char *command, char *text, size_t size)
{
    static const struct {
        const char *name;
        void (*tell)(const struct vm_machine *m, char *text, size_t size);
    } commands[] = {{"time", tell_time},
                    {"cpu", tell_processor},
                    {"dpu", tell_dpu},
                    {"lines", tell_lines},
                    {"help", tell_help}};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (strcmp(command, commands[i].name) == 0) {
            commands[i].tell(ctx, text, size);
            return true;
        }
    return false;
}

struct vm_gdb_target vm_gdb_machine(struct vm_machine *m)
{
    assert(m->desc.board);
    return (struct vm_gdb_target){
        .ctx = m,
        .cpu = &m->desc.board->cpu,
        .slice = SLICE_PS,
        .now = now,
        .run = run,
        .watch = watch,
        .exited = exited,
        .read = read,
        .write = write,
        .monitor = monitor,
    };
}
