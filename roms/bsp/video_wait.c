/* Waiting for the beam: retrace and the row that was asked for, by interrupt. */
#include <stddef.h>

#include "emu/memmap.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/video.h"

struct wait {
    uint32_t bit; /* of VIDEO_STATUS and VIDEO_IRQ_ENABLE */
    unsigned line;
    void (*handler)(void *ctx);
    void *ctx;
};

static struct wait retrace = {.bit = VIDEO_STATUS_RETRACE, .line = IRQ_LINE_RETRACE},
                   row = {.bit = VIDEO_STATUS_COMPARE, .line = IRQ_LINE_COMPARE};
static volatile uint32_t retraces;

static volatile uint32_t *reg(uint32_t offset)
{
    return (volatile uint32_t *)(MAP_VIDEO + offset);
}

static void arrived(void *ctx)
{
    const struct wait *wait = ctx;
    *reg(VIDEO_STATUS) = wait->bit; /* the line drops */
    if (wait == &retrace)
        retraces++;
    if (wait->handler != NULL)
        wait->handler(wait->ctx);
}

/* Interrupts of this kind come from now on. What was before does not count. */
static void listen(struct wait *wait)
{
    if (!video_present() || (*reg(VIDEO_IRQ_ENABLE) & wait->bit) != 0)
        return;
    *reg(VIDEO_STATUS) = wait->bit;
    irq_attach(wait->line, arrived, wait);
    *reg(VIDEO_IRQ_ENABLE) |= wait->bit;
}

static void set(struct wait *wait, void (*handler)(void *ctx), void *ctx)
{
    uint32_t state = irq_lock();
    wait->handler = handler;
    wait->ctx = ctx;
    listen(wait);
    irq_unlock(state);
}

void video_on_retrace(void (*handler)(void *ctx), void *ctx)
{
    set(&retrace, handler, ctx);
}

void video_on_row(void (*handler)(void *ctx), void *ctx)
{
    set(&row, handler, ctx);
}

void video_compare(uint32_t number)
{
    if (video_present())
        *reg(VIDEO_LINE_COMPARE) = number;
}

uint32_t video_retraces(void)
{
    return retraces;
}

void video_wait_retrace(void)
{
    if (!video_present() || (*reg(VIDEO_CONTROL) & VIDEO_CONTROL_ON) == 0)
        return;
    uint32_t state = irq_lock();
    listen(&retrace);
    uint32_t before = retraces;
    while (retraces == before)
        irq_wait();
    irq_unlock(state);
}
