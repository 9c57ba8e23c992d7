/* show_step.c — stepping in both directions: by a refresh, a display word, an instruction, a stroke, a scan line. */
#include <stdio.h>

#include "emu/cpu/rv_disasm.h"
#include "emu/show.h"

#define PATIENCE_PS  CRT_PS_PER_S  /* how long a step forward waits for what it steps by */
#define LONGEST_WORD CRT_PS_PER_MS /* longer than a display word draws */

static const char *const unit_names[] = {[VM_UNIT_INSTRUCTION] = "instruction",
                                         [VM_UNIT_WORD] = "display word",
                                         [VM_UNIT_REFRESH] = "refresh",
                                         [VM_UNIT_STROKE] = "stroke of the beam",
                                         [VM_UNIT_LINE] = "scan line"};

/* ---- remembering --------------------------------------------------------------------------------
 */

void vm_show_note(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++)
        if (show->side[i]->history)
            vm_history_note(show->side[i]->history);
}

void vm_show_mark(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++)
        if (show->side[i]->history)
            vm_history_mark(show->side[i]->history);
}

void vm_show_forget(struct vm_show *show)
{
    for (int i = 0; i < show->sides; i++)
        if (show->side[i]->history)
            vm_history_forget(show->side[i]->history);
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
    return vm_machine_run_unit(m, show->unit, m->now + PATIENCE_PS) ||
           crt_fail(err, "no %s within a second of simulated time", unit_names[show->unit]);
}

/* The oscilloscope sees the refreshes. */
static void run_watched(struct vm_show *show, struct vm_shown *p, uint64_t until)
{
    struct vm_scope *scope = &show->scope;
    struct vm_machine *m = p->rig.machine;
    if (scope->probe.diode && show->side[scope->side] == p)
        vm_probe_run(&scope->probe, m, until);
    else
        vm_machine_run(m, until > m->now ? until : m->now);
}

/* Goes to `place`, which is past or present, once more, with the light of the shutter's time, or
 * of the tick, that ends there on film. */
static bool expose_side(struct vm_show *show, struct vm_shown *p, const struct place *place,
                        struct crt_error *err)
{
    struct vm_machine *m = p->rig.machine;
    uint64_t exposure = vm_show_exposure(show), back = exposure + LONGEST_WORD;
    uint64_t from = place->now > exposure ? place->now - exposure : 0;
    /* From so far back that what was under way is known, and what an oscilloscope shows. */
    if (show->scope.placed && back < VM_SCOPE_PAST)
        back = VM_SCOPE_PAST;
    if (!vm_history_recall(p->history, place->now > back ? place->now - back : 0, err))
        return false;
    run_watched(show, p, from);
    if (place->now > m->now) {
        vm_frame_open(&p->frame, &p->rig, m->now, place->now);
        run_watched(show, p, place->now);
    }
    /* What happens at that very moment, and had happened. */
    vm_machine_run_words(m, place->words, place->now + 1);
    if (p->rig.board)
        vm_machine_run_retired(m, place->retired, place->now);
    return true;
}

/* The left machine at its place, the other one at the same instant. */
static bool expose(struct vm_show *show, const struct place *place, struct crt_error *err)
{
    bool ok = true, ready = true;
    for (int i = 0; ok && i < show->sides; i++) {
        const struct place instant = {.now = place->now};
        ok = expose_side(show, show->side[i], i == 0 ? place : &instant, err);
        ready &= vm_frame_complete(&show->side[i]->frame);
    }
    show->film_ready = ready;
    if (ok && ready)
        vm_show_develop(show);
    return ok;
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
    char text[200] = "", time[40], next[RV_DISASM_MAX];
    uint32_t line, dot;
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
    const struct crt_stroke *stroke = show->unit == VM_UNIT_STROKE ? vm_machine_stroke(m) : NULL;
    if (stroke)
        snprintf(text, sizeof text, "stroke of word %06o, %s", (unsigned)stroke->source, time);
    if (show->unit == VM_UNIT_LINE && ras_head_beam(&m->raster, m->now, &line, &dot))
        snprintf(text, sizeof text, "scan line %u, %s", (unsigned)line, time);
    if (show->unit == VM_UNIT_REFRESH)
        snprintf(text, sizeof text, "refresh %llu, %s",
                 (unsigned long long)m->refreshes.last.number, time);
    vm_show_say(show, text);
}

static bool remembered(const struct vm_show *show)
{
    bool all = true;
    for (int i = 0; i < show->sides; i++)
        all &= show->side[i]->history != NULL;
    return all;
}

void vm_show_look_again(struct vm_show *show)
{
    const struct place place = place_of(show->program);
    struct crt_error err;
    if (show->paused && remembered(show) && !expose(show, &place, &err))
        vm_show_say(show, err.text);
}

void vm_show_step(struct vm_show *show, int direction)
{
    struct vm_shown *p = show->program;
    struct crt_error err;
    show->paused = true;
    show->speed_since = 0;
    if (!remembered(show)) {
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

static bool suits(const struct vm_show *show, enum vm_unit unit)
{
    const struct vm_machine *m = show->program->rig.machine;
    switch (unit) {
    case VM_UNIT_INSTRUCTION:
        return m->desc.board != NULL;
    case VM_UNIT_WORD:
    case VM_UNIT_STROKE:
        return vm_machine_uses_vector(m);
    case VM_UNIT_LINE:
        return vm_machine_uses_raster(m);
    case VM_UNIT_REFRESH:
        break;
    }
    return true;
}

void vm_show_next_unit(struct vm_show *show)
{
    static const enum vm_unit next[] = {[VM_UNIT_REFRESH] = VM_UNIT_WORD,
                                        [VM_UNIT_WORD] = VM_UNIT_INSTRUCTION,
                                        [VM_UNIT_INSTRUCTION] = VM_UNIT_STROKE,
                                        [VM_UNIT_STROKE] = VM_UNIT_LINE,
                                        [VM_UNIT_LINE] = VM_UNIT_REFRESH};
    char text[96];
    do
        show->unit = next[show->unit];
    while (!suits(show, show->unit));
    snprintf(text, sizeof text, "steps by a%s %s - Right Ctrl with Left, Right",
             show->unit == VM_UNIT_INSTRUCTION ? "n" : "", unit_names[show->unit]);
    vm_show_say(show, text);
}

void vm_show_check_unit(struct vm_show *show)
{
    if (!suits(show, show->unit))
        show->unit = VM_UNIT_REFRESH;
}
