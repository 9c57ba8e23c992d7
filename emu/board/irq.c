#include "emu/board/irq.h"

#include <assert.h>

#include "emu/memmap.h"

#define LINES ((1u << IRQ_LINES) - 2) /* 0 is no line */

static void drive(struct vm_irq *q, uint64_t t)
{
    vm_wire_drive(&q->desc.external, &q->level, (q->pending & q->enable) != 0, t);
}

void vm_irq_init(struct vm_irq *q, const struct vm_irq_desc *desc)
{
    *q = (struct vm_irq){.desc = *desc};
}

void vm_irq_reset(struct vm_irq *q, uint64_t t)
{
    q->enable = 0;
    drive(q, t);
}

void vm_irq_set(struct vm_irq *q, unsigned line, bool level, uint64_t t)
{
    assert(line > 0 && line < IRQ_LINES);
    if (level)
        q->pending |= 1u << line;
    else
        q->pending &= ~(1u << line);
    drive(q, t);
}

static uint32_t lowest(uint32_t lines)
{
    for (uint32_t line = 1; line < IRQ_LINES; line++)
        if (lines >> line & 1)
            return line;
    return 0;
}

bool vm_irq_read(struct vm_irq *q, uint32_t offset, uint32_t *value, uint64_t t)
{
    (void)t;
    *value = offset == IRQ_PENDING  ? q->pending
             : offset == IRQ_ENABLE ? q->enable
             : offset == IRQ_CLAIM  ? lowest(q->pending & q->enable)
                                    : 0;
    return true;
}

bool vm_irq_write(struct vm_irq *q, uint32_t offset, uint32_t value, uint64_t t)
{
    if (offset == IRQ_ENABLE) {
        q->enable = value & LINES;
        drive(q, t);
    }
    return true;
}

void vm_irq_state(struct vm_irq *q, struct crt_state *s)
{
    crt_state_begin(s, "IRQC", 1);
    crt_state_u32(s, &q->pending);
    crt_state_u32(s, &q->enable);
    crt_state_bool(s, &q->level);
    crt_state_check(s, ((q->pending | q->enable) & ~LINES) == 0, "interrupt lines");
    crt_state_check(s, q->level == ((q->pending & q->enable) != 0), "external interrupt");
    crt_state_end(s);
}
