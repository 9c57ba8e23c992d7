#include "emu/trace_lines.h"

#include "crt/beam_file.h"
#include "crt/penetration.h"
#include "display_file/df_regs.h"
#include "emu/cpu/rv_disasm.h"
#include "emu/memmap.h"
#include "input/script.h"

#define ULL(x) ((unsigned long long)(x))

static void print_registers(FILE *out, uint64_t t, uint16_t address, uint16_t word,
                            const struct df_dpu *dpu)
{
    enum crt_level level = df_dpu_level(dpu);
    fprintf(out, "dpu %llu DPC=%06o WORD=%06o MPR=%06o XPR=%06o YPR=%06o", ULL(t), address, word,
            df_dpu_read(dpu, DF_MPR), df_dpu_read(dpu, DF_XPR), df_dpu_read(dpu, DF_YPR));
    if (level != CRT_LEVEL_ONLY)
        fprintf(out, " COLOUR=%s", crt_level_name(level));
    fputc('\n', out);
}

static void print_word(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                       const struct df_dpu *dpu)
{
    const struct vm_trace_lines *l = ctx;
    if (!fetched)
        fprintf(l->out, "# dpu %llu bus time-out at DPC=%06o\n", ULL(t), address);
    else
        print_registers(l->out, t, address, word, dpu);
}

static void print_stroke(void *ctx, const struct crt_stroke *stroke)
{
    crt_beam_write_stroke(((const struct vm_trace_lines *)ctx)->out, stroke);
}

/* ---- processor ----------------------------------------------------------------------------------
 */

static bool before(void *ctx, struct rv_cpu *cpu)
{
    struct vm_trace_lines *l = ctx;
    uint32_t word;
    l->accesses = rv_fetch(cpu, cpu->pc, &word) && rv_access_of(cpu, word, &l->access);
    return false;
}

static void print_store(const struct vm_trace_lines *l, const struct rv_cpu *cpu, uint32_t word)
{
    unsigned source = word >> 20 & 31;
    bool is_float = (word & 0x7F) == 0x27;
    uint32_t value = is_float ? cpu->f[source] : cpu->x[source];
    int digits = (int)l->access.width * 2;
    if (digits < 8)
        value &= (1u << 4 * digits) - 1;
    fprintf(l->out, " [%08x]=%0*x", l->access.address, digits, value);
}

static void print_instruction(void *ctx, struct rv_cpu *cpu, uint32_t pc, uint32_t word,
                              bool trapped)
{
    const struct vm_trace_lines *l = ctx;
    char text[RV_DISASM_MAX];
    rv_disasm(pc, word, text, sizeof text);
    fprintf(l->out, "cpu %llu PC=%08x WORD=%08x %s", ULL(vm_board_time(l->board, cpu->cycle - 1)),
            pc, word, text);
    int destination = rv_destination(word);
    if (trapped)
        fprintf(l->out, " trap: %s",
                rv_cause_name(cpu->state == RV_HALTED ? cpu->trouble.cause : cpu->mcause));
    else if (l->accesses && l->access.store)
        print_store(l, cpu, word);
    else if (destination >= 32)
        fprintf(l->out, " %s=%08x", rv_f_name((unsigned)destination - 32),
                cpu->f[destination - 32]);
    else if (destination > 0)
        fprintf(l->out, " %s=%08x", rv_x_name((unsigned)destination), cpu->x[destination]);
    fputc('\n', l->out);
}

/* ---- interrupts ---------------------------------------------------------------------------------
 */

static void print_line(void *ctx, uint64_t t, unsigned line, bool level)
{
    static const char *const names[IRQ_LINES] = {
        [IRQ_LINE_STOP] = "stop",       [IRQ_LINE_PEN] = "pen",
        [IRQ_LINE_CHAR] = "character",  [IRQ_LINE_NAME] = "name",
        [IRQ_LINE_RETRACE] = "retrace", [IRQ_LINE_COMPARE] = "line compare",
        [IRQ_LINE_INPUT] = "input",     [IRQ_LINE_UART] = "uart"};
    const struct vm_trace_lines *l = ctx;
    fprintf(l->out, "irq %llu %s %s\n", ULL(t), names[line], level ? "high" : "low");
}

static void print_interrupt(void *ctx, struct rv_cpu *cpu, uint32_t cause)
{
    const struct vm_trace_lines *l = ctx;
    fprintf(l->out, "irq %llu processor takes %s at PC=%08x\n",
            ULL(vm_board_time(l->board, cpu->cycle)), rv_cause_name(cause), cpu->mepc);
}

/* ---- video --------------------------------------------------------------------------------------
 */

static void print_signal(void *ctx, enum ras_signal signal, bool level, uint64_t t)
{
    const struct vm_trace_lines *l = ctx;
    uint32_t line = 0, dot;
    if (signal != RAS_PICTURE) {
        fprintf(l->out, "video %llu %s %s\n", ULL(t), signal == RAS_HSYNC ? "hsync" : "vsync",
                level ? "high" : "low");
        return;
    }
    /* The last dot of a row is still its own. */
    ras_head_beam(l->head, level ? t : t - 1, &line, &dot);
    fprintf(l->out, "video %llu row %lu %s\n", ULL(t), (unsigned long)line,
            level ? "begins" : "ends");
}

static void print_latch(void *ctx, uint64_t t)
{
    const struct vm_trace_lines *l = ctx;
    const struct ras_latch *latch = &l->head->latch;
    fprintf(l->out, "video %llu retrace base=%08lx pitch=%lu format=%lu\n", ULL(t),
            (unsigned long)latch->base, (unsigned long)latch->pitch, (unsigned long)latch->format);
}

/* ---- input --------------------------------------------------------------------------------------
 */

static void print_act(void *ctx, const struct inp_act *act)
{
    const struct vm_trace_lines *l = ctx;
    char text[INP_STATEMENT_MOST];
    size_t n = inp_script_write(act, text);
    fprintf(l->out, "input %.*s", (int)n, text);
}

static void print_pen(struct vm_trace_lines *l, uint64_t t, const struct inp_unit *unit, int screen)
{
    const struct inp_pen_port *port = &unit->port[screen];
    if (port->firings == l->seen.firings[screen])
        return;
    l->seen.firings[screen] = port->firings;
    fprintf(l->out, "input %llu pen %s fires", ULL(t), screen == INP_RASTER ? "raster" : "vector");
    if (screen == INP_RASTER && (port->status & PEN_HIT))
        fprintf(l->out, ", beam at line %lu dot %lu field %lu", (unsigned long)port->line,
                (unsigned long)port->dot, (unsigned long)port->field);
    fputc('\n', l->out);
}

static void print_tablet(struct vm_trace_lines *l, uint64_t t, const struct inp_tablet *tablet)
{
    static const char *const names[] = {"far", "near", "touch"};
    const struct inp_tablet_report *r = &tablet->report;
    if (tablet->serial == l->seen.tablet)
        return;
    l->seen.tablet = tablet->serial;
    fprintf(l->out, "input %llu tablet report %lu: %ld %ld %ld %s buttons=%u\n", ULL(t),
            (unsigned long)tablet->serial, (long)r->x, (long)r->y, (long)r->z,
            names[r->proximity % 3], r->buttons);
}

static void print_touch(struct vm_trace_lines *l, uint64_t t, const struct inp_touch *touch)
{
    const struct inp_touch_report *r = &touch->report;
    if (touch->serial == l->seen.touch)
        return;
    l->seen.touch = touch->serial;
    fprintf(l->out, "input %llu touch report %lu: %lu %lu%s%s\n", ULL(t),
            (unsigned long)touch->serial, (unsigned long)r->x, (unsigned long)r->y,
            r->touched ? " touched" : " lifted", r->unsure ? " unsure" : "");
}

static void print_mouse(struct vm_trace_lines *l, uint64_t t, const struct inp_mouse *mouse)
{
    uint32_t x, y, buttons;
    inp_mouse_read(mouse, INPUT_MOUSE_X, t, &x);
    inp_mouse_read(mouse, INPUT_MOUSE_Y, t, &y);
    inp_mouse_read(mouse, INPUT_MOUSE_BUTTONS, t, &buttons);
    if (x == l->seen.x && y == l->seen.y && buttons == l->seen.buttons)
        return;
    l->seen.x = x;
    l->seen.y = y;
    l->seen.buttons = buttons;
    fprintf(l->out, "input %llu mouse %ld %ld buttons=%lu\n", ULL(t), (long)(int32_t)x,
            (long)(int32_t)y, (unsigned long)buttons);
}

static void print_input(void *ctx, uint64_t t, const struct inp_unit *unit)
{
    struct vm_trace_lines *l = ctx;
    for (int s = 0; s < INP_SCREENS; s++)
        print_pen(l, t, unit, s);
    print_tablet(l, t, &unit->tablet);
    print_touch(l, t, &unit->touch);
    print_mouse(l, t, &unit->mouse);
}

/* What was reported before the trace begins is no news. */
static void see(struct vm_trace_lines *l, const struct inp_unit *unit, uint64_t t)
{
    for (int s = 0; s < INP_SCREENS; s++)
        l->seen.firings[s] = unit->port[s].firings;
    l->seen.tablet = unit->tablet.serial;
    l->seen.touch = unit->touch.serial;
    inp_mouse_read(&unit->mouse, INPUT_MOUSE_X, t, &l->seen.x);
    inp_mouse_read(&unit->mouse, INPUT_MOUSE_Y, t, &l->seen.y);
    inp_mouse_read(&unit->mouse, INPUT_MOUSE_BUTTONS, t, &l->seen.buttons);
}

void vm_trace_lines_init(struct vm_trace_lines *l, enum vm_trace_what what, FILE *out,
                         const struct vm_machine *machine)
{
    *l =
        (struct vm_trace_lines){.out = out, .board = machine->desc.board, .head = &machine->raster};
    l->hooks.ctx = l->processor.ctx = l->raster.ctx = l;
    if (what == VM_TRACE_DPU)
        l->hooks.word = print_word;
    if (what == VM_TRACE_BEAM)
        l->hooks.stroke = print_stroke;
    if (what == VM_TRACE_CPU) {
        l->processor.before = before;
        l->processor.after = print_instruction;
    }
    if (what == VM_TRACE_IRQ)
        l->hooks.line = print_line;
    if (what == VM_TRACE_INPUT) {
        l->hooks.act = print_act;
        l->hooks.input = print_input;
        see(l, &machine->devices, machine->now);
    }
    if (what == VM_TRACE_VIDEO) {
        l->raster.signal = print_signal;
        l->raster.latch = print_latch;
        l->hooks.raster = &l->raster;
    }
    if (what == VM_TRACE_CPU || what == VM_TRACE_IRQ) {
        l->processor.interrupt = print_interrupt;
        l->hooks.processor = &l->processor;
    }
}
