#include "roms/bsp/interrupts.h"

#include <stddef.h>

#include "emu/memmap.h"
#include "roms/bsp/board.h"
#include "roms/bsp/console.h"
#include "roms/bsp/csr.h"

struct line {
    void (*handler)(void *ctx);
    void *ctx;
};

static struct line lines[IRQ_LINES];
static void (*timer_handler)(void);

static volatile uint32_t *controller(uint32_t offset)
{
    return (volatile uint32_t *)(MAP_IRQ + offset);
}

void irq_enable(unsigned line)
{
    if (line == 0 || line >= IRQ_LINES || !board_is_knsc())
        return;
    uint32_t state = irq_lock();
    *controller(IRQ_ENABLE) |= 1u << line;
    irq_unlock(state);
}

void irq_disable(unsigned line)
{
    if (line == 0 || line >= IRQ_LINES || !board_is_knsc())
        return;
    uint32_t state = irq_lock();
    *controller(IRQ_ENABLE) &= ~(1u << line);
    irq_unlock(state);
}

void irq_attach(unsigned line, void (*handler)(void *ctx), void *ctx)
{
    if (line == 0 || line >= IRQ_LINES || !board_is_knsc())
        return;
    uint32_t state = irq_lock();
    lines[line] = (struct line){handler, ctx};
    irq_enable(line);
    csr_set_mie(CSR_MIE_EXTERNAL);
    irq_unlock(state);
}

void irq_attach_timer(void (*handler)(void))
{
    uint32_t state = irq_lock();
    timer_handler = handler;
    csr_set_mie(CSR_MIE_TIMER);
    irq_unlock(state);
}

uint32_t irq_lock(void)
{
    return csr_clear_mstatus(CSR_MSTATUS_MIE) & CSR_MSTATUS_MIE;
}

void irq_unlock(uint32_t state)
{
    csr_set_mstatus(state & CSR_MSTATUS_MIE);
}

void irq_wait(void)
{
    /* WFI ends when an interrupt is pending although it cannot be taken yet. */
    __asm__ volatile("wfi" : : : "memory");
    csr_set_mstatus(CSR_MSTATUS_MIE);
    csr_clear_mstatus(CSR_MSTATUS_MIE);
}

void irq_timer(void)
{
    timer_handler();
}

void irq_external(void)
{
    uint32_t number = *controller(IRQ_CLAIM);
    if (number == 0)
        return; /* it dropped meanwhile */
    const struct line *line = &lines[number];
    if (line->handler != NULL)
        line->handler(line->ctx);
    else
        irq_disable(number);
}

static void field(const char *name, uint32_t value)
{
    console_write(name);
    console_hex(value);
}

void irq_exception(void)
{
    static const char *const causes[] = {
        "misaligned fetch", "fetch access fault", "illegal instruction", "breakpoint",
        "misaligned load",  "load access fault",  "misaligned store",    "store access fault",
    };
    uint32_t cause = csr_read_mcause();
    console_write("\nUnhandled trap: ");
    console_write(cause < sizeof causes / sizeof *causes ? causes[cause] : "other");
    field(", cause ", cause);
    field(", pc ", csr_read_mepc());
    field(", value ", csr_read_mtval());
    console_put('\n');
    board_exit(1);
}
