#include "emu/where.h"

#include <stdio.h>

#include "display_file/disasm.h"
#include "emu/quantity.h"

/* ---- vector head ---------------------------------------------------------------------------------
 */

/* The stroke under way at t, else the next one; NULL: none is known. */
static const struct crt_stroke *stroke_at(const struct vm_machine *m, uint64_t t)
{
    const struct crt_stroke *best = NULL;
    for (int i = 0; i < VM_STROKES_KEPT; i++) {
        const struct crt_stroke *s = &m->recent[i];
        if (s->t1 > t && (!best || s->t0 < best->t0))
            best = s;
    }
    return best;
}

static void find_vector(const struct vm_machine *m, struct vm_where *w)
{
    const struct crt_screen *screen = &m->dpu.desc.screen;
    const struct crt_stroke *s = stroke_at(m, m->now);
    w->known = vm_machine_uses_vector(m) || m->recording.count > 0;
    w->on_screen = w->known;
    if (!s) {
        w->x = m->dpu.x;
        w->y = m->dpu.y;
        vm_machine_place(m, INP_VECTOR, w->x, w->y, &w->x_mm, &w->y_mm);
        return;
    }
    double part = m->now > s->t0 ? (double)(m->now - s->t0) / (double)(s->t1 - s->t0) : 0;
    w->lit = m->now >= s->t0;
    w->x_mm = (double)s->x0 + part * ((double)s->x1 - (double)s->x0);
    w->y_mm = (double)s->y0 + part * ((double)s->y1 - (double)s->y0);
    crt_mm_to_units(screen, w->x_mm, w->y_mm, &w->x, &w->y);
}

/* What the display processor is at. */
static void describe_word(const struct vm_machine *m, char *text, size_t size)
{
    const struct df_dpu *dpu = &m->dpu;
    uint32_t address = dpu->source;
    char words[48] = "", second[48] = "";
    if (m->recording.count) {
        snprintf(text, size, "recording, stroke %zu", m->played);
        return;
    }
    if (dpu->state != DF_RUNNING && dpu->t <= m->now) {
        snprintf(text, size, "%06o: %s", dpu->dpc,
                 dpu->state == DF_STOPPED        ? "stopped"
                 : dpu->state == DF_WAITING_SYNC ? "waits for sync"
                                                 : "waits for RESUME");
        return;
    }
    if (address >= m->desc.memory_bytes) {
        snprintf(text, size, "%06o", (unsigned)address);
        return;
    }
    df_disassemble_word(m->memory[address / 2], dpu->mode, words, sizeof words);
    if (dpu->dpc != address + 4 || address + 4 > m->desc.memory_bytes) {
        snprintf(text, size, "%06o: %06o %s", (unsigned)address, m->memory[address / 2], words);
        return;
    }
    df_disassemble_word(m->memory[address / 2 + 1], dpu->mode, second, sizeof second);
    snprintf(text, size, "%06o: %06o %06o %s, %s", (unsigned)address, m->memory[address / 2],
             m->memory[address / 2 + 1], words, second);
}

/* ---- raster head ---------------------------------------------------------------------------------
 */

static void find_raster(const struct vm_machine *m, struct vm_where *w)
{
    const struct ras_timing *timing = &m->raster.timing;
    if (!m->desc.buffer || !ras_head_beam(&m->raster, m->now, &w->line, &w->dot))
        return;
    w->known = true;
    w->on_screen = w->lit = w->line < timing->v.visible && w->dot < timing->h.visible;
    w->x = w->dot;
    w->y = w->line;
    vm_machine_place(m, INP_RASTER, w->x, w->y, &w->x_mm, &w->y_mm);
}

static const char *part_of(const struct ras_span *span, uint32_t at)
{
    return at < span->visible      ? "picture"
           : at < span->sync_start ? "front porch"
           : at < span->sync_end   ? "sync"
                                   : "back porch";
}

static void describe_raster(const struct vm_machine *m, const struct vm_where *w, char *text,
                            size_t size)
{
    const struct ras_timing *t = &m->raster.timing;
    int n = snprintf(text, size, "line %u, dot %u", (unsigned)w->line, (unsigned)w->dot);
    if (n < 0 || (size_t)n >= size)
        return;
    if (w->on_screen)
        snprintf(text + n, size - (size_t)n, " at %.1f, %.1f mm", w->x_mm, w->y_mm);
    else if (w->line >= t->v.visible)
        snprintf(text + n, size - (size_t)n, ": vertical blanking, %s", part_of(&t->v, w->line));
    else
        snprintf(text + n, size - (size_t)n, ": horizontal blanking, %s", part_of(&t->h, w->dot));
}

/* ---- both ----------------------------------------------------------------------------------------
 */

struct vm_where vm_where(const struct vm_machine *m, enum vm_head head)
{
    struct vm_where w = {.head = head};
    if (head == VM_RASTER)
        find_raster(m, &w);
    else
        find_vector(m, &w);
    return w;
}

void vm_where_text(const struct vm_machine *m, const struct vm_where *w, char *text, size_t size)
{
    char word[128];
    if (!w->known) {
        snprintf(text, size, "the %s head is off", w->head == VM_RASTER ? "raster" : "vector");
        return;
    }
    if (w->head == VM_RASTER) {
        describe_raster(m, w, text, size);
        return;
    }
    describe_word(m, word, sizeof word);
    snprintf(text, size, "%s  beam %s at %.1f, %.1f = %.1f, %.1f mm", word, w->lit ? "on" : "dark",
             w->x, w->y, w->x_mm, w->y_mm);
}

void vm_where_time(uint64_t t, uint64_t step, char *text, size_t size)
{
    int digits = 2;
    for (uint64_t unit = CRT_PS_PER_S / 100; digits < 12 && step < unit; unit /= 10)
        digits++;
    vm_format_clock(t, digits, text, size);
}
