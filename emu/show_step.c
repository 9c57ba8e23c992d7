/* show_step.c — stepping by an instruction, a display word or a refresh, in both directions. */
#include <stdio.h>

#include "emu/cpu/rv_disasm.h"
#include "emu/show.h"

#define PATIENCE_PS CRT_PS_PER_S /* how long a step forward waits for what it steps by */

static const char *const unit_names[] = {[VM_UNIT_INSTRUCTION] = "instruction",
                                         [VM_UNIT_WORD] = "display word",
                                         [VM_UNIT_REFRESH] = "refresh"};

/* ---- remembering --------------------------------------------------------------------------------
 */

void vm_show_note(struct vm_show *show)
{
    if (show->program->history)
        vm_history_note(show->program->history);
}

void vm_show_mark(struct vm_show *show)
{
    if (show->program->history)
        vm_history_mark(show->program->history);
}

void vm_show_forget(struct vm_show *show)
{
    if (show->program->history)
        vm_history_forget(show->program->history);
}

/* ---- stepping -----------------------------------------------------------------------------------
 */

/* Where a step has led. */
struct place {
    uint64_t now, words, retired;
};

static struct place place_of(const struct vm_shown *p)
{
    return (struct place){p->rig.machine->now, p->rig.machine->dpu.words,
                          p->rig.board ? rv_retired(&p->rig.board->cpu) : 0};
}

static bool forward(struct vm_show *show, struct crt_error *err)
{
    struct vm_machine *m = show->program->rig.machine;
    uint64_t limit = m->now + PATIENCE_PS;
    bool came = show->unit == VM_UNIT_REFRESH ? vm_machine_run_refresh(m, limit)
                : show->unit == VM_UNIT_WORD
                    ? vm_machine_run_words(m, m->dpu.words + 1, limit)
                    : vm_machine_run_retired(m, rv_retired(&m->desc.board->cpu) + 1, limit);
    return came || crt_fail(err, "no %s within a second of simulated time", unit_names[show->unit]);
}

/* Goes to `place`, which is past or present, once more, with the light of the shutter's time, or
 * of the tick, that ends there on film. */
static bool expose(struct vm_show *show, const struct place *place, struct crt_error *err)
{
    struct vm_shown *p = show->program;
    struct vm_machine *m = p->rig.machine;
    uint64_t exposure = vm_show_exposure(show);
    uint64_t from = place->now > exposure ? place->now - exposure : 0;
    if (!vm_history_recall(p->history, from, err))
        return false;
    if (from > m->now)
        vm_machine_run(m, from);
    if (place->now > m->now) {
        vm_frame_open(&p->frame, &p->rig, m->now, place->now);
        vm_machine_run(m, place->now);
        vm_show_develop(show);
        show->film_ready = true;
    }
    /* What happens at that very moment, and had happened. */
    vm_machine_run_words(m, place->words, place->now + 1);
    if (p->rig.board)
        vm_machine_run_retired(m, place->retired, place->now);
    return true;
}

/* What comes next, as text. */
static void describe_instruction(const struct rv_cpu *cpu, char *text, size_t size)
{
    uint32_t word;
    if (cpu->state == RV_WAITING)
        snprintf(text, size, "waits");
    else if (rv_fetch(cpu, cpu->pc, &word))
        rv_disasm(cpu->pc, word, text, size);
    else
        snprintf(text, size, "nothing");
}

static void say_place(struct vm_show *show)
{
    const struct vm_machine *m = show->program->rig.machine;
    char text[200], time[40], next[RV_DISASM_MAX];
    vm_format_seconds(m->now, time, sizeof time);
    if (show->unit == VM_UNIT_INSTRUCTION) {
        describe_instruction(&m->desc.board->cpu, next, sizeof next);
        snprintf(text, sizeof text, "instruction %llu, next %08x %s, %s",
                 (unsigned long long)rv_retired(&m->desc.board->cpu), m->desc.board->cpu.pc, next,
                 time);
    }
    if (show->unit == VM_UNIT_WORD)
        snprintf(text, sizeof text, "display word %llu, next at %06o, %s",
                 (unsigned long long)m->dpu.words, m->dpu.dpc, time);
    if (show->unit == VM_UNIT_REFRESH)
        snprintf(text, sizeof text, "refresh %llu, %s",
                 (unsigned long long)m->refreshes.last.number, time);
    vm_show_say(show, text);
}

void vm_show_step(struct vm_show *show, int direction)
{
    struct vm_shown *p = show->program;
    struct crt_error err;
    show->paused = true;
    show->speed_since = 0;
    if (!p->history) {
        vm_show_say(show, p->input.is_recording ? "a recording has nothing to step by"
                                                : "there is no memory to remember the run");
        return;
    }
    bool ok =
        direction < 0 ? vm_history_back(p->history, show->unit, 1, &err) : forward(show, &err);
    const struct place place = place_of(p);
    struct crt_error why;
    if (!expose(show, &place, &why))
        vm_show_say(show, why.text);
    else if (!ok)
        vm_show_say(show, err.text);
    else
        say_place(show);
}

void vm_show_next_unit(struct vm_show *show)
{
    char text[96];
    show->unit = show->unit == VM_UNIT_REFRESH                            ? VM_UNIT_WORD
                 : show->unit == VM_UNIT_WORD && show->program->rig.board ? VM_UNIT_INSTRUCTION
                                                                          : VM_UNIT_REFRESH;
    snprintf(text, sizeof text, "steps by a%s %s - Right Ctrl with Left, Right",
             show->unit == VM_UNIT_INSTRUCTION ? "n" : "", unit_names[show->unit]);
    vm_show_say(show, text);
}
