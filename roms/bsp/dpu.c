#include "roms/bsp/dpu.h"

#include "emu/memmap.h"
#include "roms/bsp/board.h"
#include "roms/bsp/interrupts.h"

struct event {
    unsigned line;
    void (*handler)(void *ctx);
    void *ctx;
};

/* Where a handler left the display processor stopped: lines that are masked until it starts. */
static struct event stop = {.line = IRQ_LINE_STOP}, pen = {.line = IRQ_LINE_PEN},
                    character = {.line = IRQ_LINE_CHAR};
static unsigned masked;  /* bit n: line n */
static unsigned started; /* how often */

/* Memory for display files on a board without a vector head. */
static volatile uint16_t nowhere[DPU_BYTES / 2];

volatile uint16_t *dpu_memory(void)
{
    return board_has_vector_head() ? (volatile uint16_t *)MAP_DISPLAY : nowhere;
}

static uint16_t read(uint32_t offset)
{
    return board_has_vector_head() ? *(volatile uint16_t *)(MAP_DPU + offset) : 0;
}

static void write_dpc(uint16_t value)
{
    if (!board_has_vector_head())
        return;
    uint32_t state = irq_lock();
    started++;
    *(volatile uint16_t *)(MAP_DPU + DF_DPC) = value;
    for (unsigned line = 0; masked != 0; line++) {
        if (masked & 1u << line)
            irq_enable(line);
        masked &= ~(1u << line);
    }
    irq_unlock(state);
}

void dpu_start(uint32_t address)
{
    write_dpc((uint16_t)(address & ~1u));
}

void dpu_resume(void)
{
    write_dpc(1);
}

uint32_t dpu_pc(void)
{
    return read(DF_DPC);
}

uint16_t dpu_status(void)
{
    return read(DF_MPR);
}

unsigned dpu_x(void)
{
    return read(DF_XPR) & DF_XPR_X;
}

unsigned dpu_y(void)
{
    return read(DF_YPR) & DF_YPR_Y;
}

/* The line stays high until START or RESUME: without one it must not interrupt for ever. */
static void arrived(void *ctx)
{
    const struct event *event = ctx;
    unsigned before = started;
    event->handler(event->ctx);
    if (started == before) {
        irq_disable(event->line);
        masked |= 1u << event->line;
    }
}

static void attach(struct event *event, void (*handler)(void *ctx), void *ctx)
{
    uint32_t state = irq_lock();
    event->handler = handler;
    event->ctx = ctx;
    irq_attach(event->line, arrived, event);
    irq_unlock(state);
}

void dpu_on_stop(void (*handler)(void *ctx), void *ctx)
{
    attach(&stop, handler, ctx);
}

void dpu_on_pen(void (*handler)(void *ctx), void *ctx)
{
    attach(&pen, handler, ctx);
}

void dpu_on_character(void (*handler)(void *ctx), void *ctx)
{
    attach(&character, handler, ctx);
}
