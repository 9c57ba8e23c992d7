/* machine_wires.c — what comes out of the display processor: strokes, interrupt lines, bells; and
 * what starts it. */
#include "display_file/df_regs.h"
#include "emu/machine_parts.h"
#include "emu/memmap.h"

struct vm_counts vm_counts(const struct vm_machine *m)
{
    return (struct vm_counts){m->dpu.words, m->dpu.instructions, m->strokes, m->lit};
}

/* ---- strokes ------------------------------------------------------------------------------------
 */

void vm_count_stroke(struct vm_machine *m, const struct crt_stroke *stroke)
{
    m->recent[m->strokes++ % VM_STROKES_KEPT] = *stroke;
    m->lit += stroke->t1 - stroke->t0;
    m->last_light = stroke->t1;
    if (m->desc.tube)
        crt_tube_stroke(m->desc.tube, stroke);
    if (m->looks[INP_VECTOR])
        inp_unit_stroke(&m->devices, stroke);
}

static void commit(void *ctx, const struct crt_stroke *stroke)
{
    vm_count_stroke(ctx, stroke);
}

static void commit_hooked(void *ctx, const struct crt_stroke *stroke)
{
    struct vm_machine *m = ctx;
    vm_count_stroke(m, stroke);
    if (m->hooks.stroke)
        m->hooks.stroke(m->hooks.ctx, stroke);
}

static uint64_t offer(void *ctx, const struct crt_stroke *stroke)
{
    const struct vm_machine *m = ctx;
    return inp_pen_offer(&m->devices.pen[INP_VECTOR], stroke);
}

void vm_wire_pen(struct vm_machine *m)
{
    m->dpu.desc.beam.offer = m->looks[INP_VECTOR] ? offer : NULL;
}

/* ---- interrupt lines ----------------------------------------------------------------------------
 */

const unsigned vm_lines[DF_INT_COUNT] = {
    [DF_INT_STOP] = IRQ_LINE_STOP, [DF_INT_PEN] = IRQ_LINE_PEN, [DF_INT_CHARACTER] = IRQ_LINE_CHAR};

void vm_set_line(struct vm_machine *m, unsigned line, bool level, uint64_t t)
{
    bool is = (bool)(m->desc.board->irq.pending >> line & 1);
    if (is == level) /* it was to rise, and START came before that */
        return;
    if (m->hooks.line)
        m->hooks.line(m->hooks.ctx, t, line, level);
    vm_irq_set(&m->desc.board->irq, line, level, t);
}

/* The line changes when the word is done, which is in the future while it is being drawn. A change
 * not yet made is overtaken by the next one, which is never earlier. */
static void interrupt(void *ctx, enum df_interrupt line, bool level, uint64_t t)
{
    struct vm_machine *m = ctx;
    struct vm_interrupt *i = &m->interrupt[line];
    if (level && !i->pending) {
        i->count++;
        i->last_t = t;
    }
    i->pending = level;
    if (m->desc.board)
        i->change = t;
}

uint64_t vm_wires_next(const struct vm_machine *m)
{
    uint64_t next = VM_NEVER;
    for (int line = 0; line < DF_INT_COUNT; line++)
        next = m->interrupt[line].change < next ? m->interrupt[line].change : next;
    return next;
}

void vm_wires_change(struct vm_machine *m, uint64_t t)
{
    for (int line = 0; line < DF_INT_COUNT; line++) {
        struct vm_interrupt *i = &m->interrupt[line];
        if (i->change > t)
            continue;
        i->change = VM_NEVER;
        vm_set_line(m, vm_lines[line], i->pending, t);
    }
}

static void bell(void *ctx, uint64_t t)
{
    (void)t;
    ((struct vm_machine *)ctx)->bells++;
}

void vm_wire_dpu(struct vm_machine *m, struct df_dpu_desc *desc)
{
    desc->beam = (struct df_beam){m, NULL, commit};
    desc->wires = (struct df_wires){m, interrupt, bell};
}

void vm_wire_hooks(struct vm_machine *m, bool hooked)
{
    m->dpu.desc.beam.commit = hooked ? commit_hooked : commit;
}

/* ---- START --------------------------------------------------------------------------------------
 */

void vm_start(struct vm_machine *m, uint16_t address, uint64_t t)
{
    struct vm_counts counts = vm_counts(m);
    df_dpu_write(&m->dpu, DF_DPC, address, t);
    if (!m->refreshes.flow.start_begins)
        return;
    vm_refreshes_end(&m->refreshes, m->dpu.t, &counts);
    vm_refreshes_begin(&m->refreshes, m->dpu.t, &counts);
}
