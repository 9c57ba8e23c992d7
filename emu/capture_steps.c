/* capture_steps.c — sequences of single steps, and what is said under a picture. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/disasm.h"
#include "emu/caption.h"
#include "emu/capture_parts.h"
#include "emu/command.h"
#include "emu/cpu/rv_disasm.h"

#define PATIENCE_PS CRT_PS_PER_S /* how long a step may take to come */
#define COUNT       24           /* by default */

static const char *const names[] = {[VM_UNIT_INSTRUCTION] = "instruction",
                                    [VM_UNIT_WORD] = "word",
                                    [VM_UNIT_REFRESH] = "refresh",
                                    [VM_UNIT_STROKE] = "stroke",
                                    [VM_UNIT_LINE] = "line"};

enum vm_unit vm_capture_unit(const char *name)
{
    int unit = VM_UNIT_INSTRUCTION;
    while (name && unit < VM_UNIT_LINE && strcmp(name, names[unit]) != 0)
        unit++;
    return (enum vm_unit)unit;
}

/* ---- steps --------------------------------------------------------------------------------------
 */

static uint16_t word_at(const struct vm_machine *m, uint32_t address)
{
    return address + 1 < m->desc.memory_bytes ? m->memory[address / 2] : 0;
}

/* Executes one more word; the step is over when the word is done: then the next one may be fetched. */
static bool run_word(struct vm_machine *m, uint64_t limit, struct vm_step_word *word)
{
    uint16_t from = m->dpu.dpc;
    bool within = m->dpu.phase != 0;
    *word = (struct vm_step_word){from, word_at(m, from), (uint8_t)m->dpu.mode};
    if (!vm_machine_run_words(m, m->dpu.words + 1, limit))
        return false;
    /* Another word, when something started the processor elsewhere meanwhile. */
    if (!within && m->dpu.dpc != (uint16_t)(from + 2) && !m->dpu.illegal) {
        word->address = (uint16_t)(m->dpu.dpc - 2);
        word->word = word_at(m, word->address);
    }
    if (m->dpu.t > m->now)
        vm_machine_run(m, m->dpu.t);
    return true;
}

static bool step(struct vm_capture *c, struct vm_machine *m, uint64_t number)
{
    uint64_t limit = m->now + PATIENCE_PS;
    return c->unit == VM_UNIT_WORD ? run_word(m, limit, &c->word[number])
                                   : vm_machine_run_unit(m, c->unit, limit);
}

/* What has no such thing at all. */
static bool check_step(const struct vm_capture *c, const struct vm_machine *m,
                       struct crt_error *err)
{
    if ((c->unit == VM_UNIT_LINE || c->unit == VM_UNIT_INSTRUCTION) && !m->desc.board)
        return crt_fail(err,
                        "--step %s is for firmware; %s has refreshes, words and strokes to step by",
                        names[c->unit], c->input.name);
    if (c->input.is_recording && c->unit != VM_UNIT_STROKE)
        return crt_fail(err, "a recording has only strokes to step by: --step stroke");
    return true;
}

int vm_capture_steps(struct vm_capture *c, struct vm_machine *m, struct crt_error *err)
{
    uint64_t places = (uint64_t)c->places.width * (uint64_t)c->places.height;
    uint64_t count = c->o.count ? (uint64_t)c->o.count : places ? places : COUNT;
    if (!check_step(c, m, err))
        return VM_EXIT_USAGE;
    c->fps = c->o.fps.num ? c->o.fps : (struct crt_rate){25, 1};
    if (!vm_shots_init(&c->shots, count, err))
        return VM_EXIT_TROUBLE;
    if (c->unit == VM_UNIT_WORD && !(c->word = calloc((size_t)count, sizeof *c->word))) {
        crt_fail(err, "not enough memory for that many steps; lower --count");
        return VM_EXIT_TROUBLE;
    }
    for (uint64_t n = 0; n < count; n++) {
        uint64_t begin = m->now;
        if (!step(c, m, n)) {
            char text[40];
            vm_format_seconds(begin, text, sizeof text);
            crt_fail(err, "after %llu steps no %s comes within a second, from %s on",
                     (unsigned long long)n, names[c->unit], text);
            return VM_EXIT_TROUBLE;
        }
        c->shots.shot[n] = (struct vm_shot){begin, m->now};
    }
    return VM_EXIT_OK;
}

/* ---- captions -----------------------------------------------------------------------------------
 */

/* A text that grows by parts. */
struct line {
    char *text;
    size_t size, length;
};

static void say(struct line *l, const char *part)
{
    size_t n = strlen(part);
    if (n == 0 || l->length + n + 5 > l->size)
        return;
    l->length += (size_t)snprintf(l->text + l->length, l->size - l->length, "%s%s",
                                  l->length ? " \xC2\xB7 " : "", part);
}

static void say_word(struct line *l, const struct vm_step_word *w)
{
    char text[120], source[64];
    df_disassemble_word(w->word, w->mode, source, sizeof source);
    snprintf(text, sizeof text, "%06o: %06o %s", w->address, w->word, source);
    say(l, text);
}

/* Where the beam is, or was lit last, and by which word. */
static void say_beam(struct line *l, const struct vm_machine *m)
{
    double x, y;
    bool lit;
    char text[96], word[32] = "";
    if (!vm_machine_beam(m, &x, &y, &lit))
        return;
    if (m->dpu.words)
        snprintf(word, sizeof word, " (word %06o)", (unsigned)vm_machine_stroke(m)->source);
    snprintf(text, sizeof text, "beam %s %.0f,%.0f%s", lit ? "at" : "last lit at", x, y, word);
    say(l, text);
}

/* Where the raster head's beam has come to; of a step by a line, that line. */
static void say_line(struct line *l, const struct vm_machine *m, bool step)
{
    uint32_t line, dot;
    char text[96];
    /* At a line's end the next one begins: it is the last moment before that is meant. */
    if (m->now == 0 || !ras_head_beam(&m->raster, m->now - 1, &line, &dot))
        return;
    const struct ras_timing *t = &m->raster.timing;
    const char *where = line >= t->v.visible           ? " (vertical blanking)"
                        : !step && dot >= t->h.visible ? " (blanking)"
                                                       : "";
    size_t n =
        (size_t)snprintf(text, sizeof text, "line %u of %u", (unsigned)line, (unsigned)t->v.total);
    if (!step)
        n += (size_t)snprintf(text + n, sizeof text - n, ", dot %u of %u", (unsigned)dot,
                              (unsigned)t->h.total);
    snprintf(text + n, sizeof text - n, "%s", where);
    say(l, text);
}

static void say_instruction(struct line *l, const struct rv_cpu *cpu)
{
    uint32_t word;
    char text[RV_DISASM_MAX + 24], source[RV_DISASM_MAX];
    if (!rv_fetch(cpu, cpu->pc, &word))
        return;
    rv_disasm(cpu->pc, word, source, sizeof source);
    snprintf(text, sizeof text, "next %08x %s", cpu->pc, source);
    say(l, text);
}

void vm_capture_caption(const struct vm_capture *c, uint64_t number, char *text, size_t size)
{
    const struct vm_capture_side *side = &c->side[0];
    const struct vm_machine *m = side->rig.machine;
    struct line line = {text, size, 0};
    char part[64];
    bool by_line = c->step && c->unit == VM_UNIT_LINE;
    text[0] = '\0';
    vm_format_clock(c->shots.shot[number].at, VM_CAPTION_DIGITS, part, sizeof part);
    say(&line, part);
    if (c->step && c->unit == VM_UNIT_REFRESH) {
        snprintf(part, sizeof part, "refresh %llu", (unsigned long long)m->refreshes.last.number);
        say(&line, part);
    }
    if (c->step && c->unit == VM_UNIT_INSTRUCTION)
        say_instruction(&line, &m->desc.board->cpu);
    if (c->word)
        say_word(&line, &c->word[number]);
    if ((side->view & VM_VIEW_VECTOR) && !by_line)
        say_beam(&line, m);
    if (side->view & VM_VIEW_RASTER)
        say_line(&line, m, by_line);
}
