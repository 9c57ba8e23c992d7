/* machine.h — the machine: what is wired to what, and in which order things happen.
 *
 *                       START, RESUME
 *      stand-in ───────────────────────▶┌─────┐ offer ▶ pen (none yet)
 *         ▲   display memory ──fetch───▶│ dpu │ commit ─┬─▶ tube (may be absent: nobody looks)
 *         └──────── interrupts ─────────└─────┘         └─▶ trace hooks
 *      sync ticks ──▶ dpu, stand-in, end of a tube epoch       ▲
 *      recording (.beam) ── strokes ───────────────────────────┘
 *
 * Models:     a vector head without a processor. The stand-in does what a refresh program would:
 *             when the display file has stopped it starts it again at the next sync tick (or not:
 *             VM_HALT), and resumes it at the next tick after a pen or character interrupt.
 *             Instead of a display processor a recording of beam pieces can drive the tube.
 * Time:       picoseconds since power-on. At equal times the tick comes before the word.
 * Refresh:    emu/flow.h. Refreshes are counted from 1 as they end.
 * Ownership:  the caller owns the struct (256 KiB: not for small stacks); the tube and what the
 *             desc points at must outlive it. Allocates nothing.
 * Errors:     vm_machine_load: one sentence. Guest trouble is a state of the display processor
 *             (emu/trouble.h puts it into words).
 * Not modelled: a CPU, a raster head, a light pen; bus contention.
 */
#ifndef EMU_MACHINE_H
#define EMU_MACHINE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/ticks.h"
#include "crt/tube.h"
#include "display_file/dpu.h"
#include "display_file/program.h"
#include "emu/flow.h"

enum vm_on_stop { VM_RESTART, VM_HALT };

struct vm_refresh {
    uint64_t number; /* 1… ; 0 = none yet */
    uint64_t begin, end;
    uint64_t words, instructions, strokes;
    uint64_t lit; /* ps of beam on */
};

/* A recording: strokes in order of t0. */
struct vm_recording {
    const struct crt_stroke *strokes;
    size_t count;
};

/* Called by vm_machine_trace only. `word` follows the execution of a word: `t` is when it was
 * fetched and `address` from where; `fetched` is false when the bus timed out instead. */
struct vm_hooks {
    void *ctx;
    void (*word)(void *ctx, uint64_t t, uint16_t address, uint16_t word, bool fetched,
                 const struct df_dpu *dpu);                     /* may be NULL */
    void (*stroke)(void *ctx, const struct crt_stroke *stroke); /* may be NULL */
};

struct vm_machine_desc {
    const struct crt_tube_row *row;
    struct df_timing timing;
    struct crt_rate tick;
    uint32_t memory_bytes;
    enum vm_on_stop on_stop;
    struct crt_tube *tube; /* NULL: nobody observes, so no light is computed */
};

struct vm_interrupt {
    bool pending;
    uint64_t count, last_t;
};

struct vm_machine {
    struct vm_machine_desc desc;
    struct df_dpu dpu;
    bool has_program;
    uint32_t entry;
    struct vm_flow flow;
    struct vm_recording recording;
    size_t played;                   /* strokes of the recording delivered */
    uint64_t loaded, strokes_before; /* when the program was, and the strokes until then */
    struct vm_hooks hooks;

    uint64_t now;                      /* everything before this has happened */
    uint64_t advanced;                 /* what the tube was last told */
    uint64_t ticks;                    /* sync ticks so far; tick 0 is at power-on */
    uint64_t tick_time;                /* of the next one */
    uint64_t strokes, lit, last_light; /* pieces drawn; beam-on time; end of the last piece */
    uint64_t stops, last_stop;         /* stop words executed; when the last was done */
    uint64_t bells;
    bool in_refresh;
    struct vm_refresh current; /* being drawn; its counts are totals at its begin */
    struct vm_refresh refresh; /* the last complete one */
    struct vm_interrupt interrupt[DF_INT_COUNT];
    uint16_t memory[DF_MEMORY_BYTES / 2];
};

void vm_machine_init(struct vm_machine *m, const struct vm_machine_desc *desc);

/* Resets the display processor, copies the words into display memory and writes the entry to DPC,
 * at the present time. `name` is for the sentence. Nothing has changed when it fails. */
bool vm_machine_load(struct vm_machine *m, const struct df_program *program, const char *name,
                     struct crt_error *err);
/* Plays a recording instead, from power-on. */
void vm_machine_play(struct vm_machine *m, struct vm_recording recording);

/* Everything that happens before `until`: words fetched and ticks; then the tube is advanced. */
void vm_machine_run(struct vm_machine *m, uint64_t until);
/* The same with hooks: a loop of its own, so that the other has no test for them. */
void vm_machine_trace(struct vm_machine *m, uint64_t until, const struct vm_hooks *hooks);

/* Runs until one more refresh is complete, or to `limit`. True when one was; m->now is then its
 * end. */
bool vm_machine_run_refresh(struct vm_machine *m, uint64_t limit);
/* Runs until one more stop word was executed, or to `limit`. */
bool vm_machine_run_stop(struct vm_machine *m, uint64_t limit);
/* A copy that goes on alone, without the tube: for looking ahead. */
void vm_machine_copy(struct vm_machine *copy, const struct vm_machine *m);
/* Executes one word (or, when the processor waits, goes on to the next tick): a single step. */
void vm_machine_step(struct vm_machine *m);

/* All of the machine but its tube, between two events. When the machine has a tube, that must have
 * been loaded before, and belong to the same instant. A machine whose loading failed is fit to be
 * initialised or loaded again, for nothing else. */
void vm_machine_state(struct vm_machine *m, struct crt_state *s);

#endif
