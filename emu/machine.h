/* machine.h — the machine: what is wired to what, and in which order things happen.
 *
 *      board (processor, console, timer) ── DPU registers ──┐
 *         │ ▲ interrupt lines 1–3          START, RESUME    ▼
 *         │ └──────────────────────────────────────────── dpu ── offer ▶ pen ── commit ─┬▶ tube
 *         ├─ stores ─▶ display memory ─────────fetch───────▲                            └▶ hooks
 *         ├─ stores ─▶ refresh buffer ──pixels──▶ raster head ── scan lines ──▶ raster tube
 *         │ ▲ interrupt lines 5, 6  registers, look-up table ──▲
 *      sync ticks ──▶ dpu, stand-in, end of a tube epoch
 *         │ ▲ line 7, keys to the console
 *         └─┴─ registers ── pens, tablet, panel, keyboard, mouse ◀── acts of the person
 *      recording (.beam) ── strokes ─────────────────────────────────────────────────────▲
 *
 * Models:     a vector head with or without a processor, and with a processor a raster head, too.
 *             Without a processor a stand-in does what a refresh program would: when the display file
 *             has stopped it starts it again at the next sync tick (or not: VM_HALT), and resumes it
 *             at the next tick after a pen or character interrupt. Instead of a display processor a
 *             recording of beam pieces can drive the tube.
 * Time:       picoseconds since power-on. At equal times: raster head, tick, interrupt line, word,
 *             acts and input devices, console, timer, processor. An instruction begun at t comes after the word fetched at t
 *             and the line of pixels read at t; what is fetched or read after t sees what it stored.
 *             What the display processor reports (interrupt lines) rises when the word that causes it
 *             is done; its registers show what the word leads to from its fetch on.
 * Refresh:    emu/refresh.h. Refreshes are counted from 1 as they end. Of a program that uses the
 *             raster head and has never started the display processor, a refresh is a frame.
 * Ownership:  the caller owns the struct (303 KiB: not for small stacks); board, console, tubes and
 *             what the desc points at must outlive it. Allocates nothing.
 * Errors:     vm_machine_load: one sentence. Guest trouble is a state of the display processor or
 *             the processor (emu/trouble.h puts it into words).
 * Not modelled: bus contention.
 */
#ifndef EMU_MACHINE_H
#define EMU_MACHINE_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/ticks.h"
#include "crt/tube.h"
#include "display_file/dpu.h"
#include "display_file/program.h"
#include "emu/board/board.h"
#include "emu/console.h"
#include "emu/flow.h"
#include "emu/operator.h"
#include "emu/refresh.h"
#include "input/unit.h"
#include "raster/head.h"

enum vm_on_stop { VM_RESTART, VM_HALT };

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
    /* An interrupt line (IRQ_LINE_…) changes at t. May be NULL. */
    void (*line)(void *ctx, uint64_t t, unsigned line, bool level);
    /* An act reaches the devices, or one of them has something for the program. May be NULL. */
    void (*act)(void *ctx, const struct inp_act *act);
    void (*input)(void *ctx, uint64_t t, const struct inp_unit *unit);
    /* A scan line goes to the raster tube, its pixels just read. With a raster tube. May be NULL. */
    void (*scan)(void *ctx, const struct crt_scan_line *line);
    const struct ras_hooks *raster;   /* signals of the raster head; may be NULL */
    const struct rv_hooks *processor; /* each instruction; may be NULL */
};

struct vm_machine_desc {
    const struct crt_tube_row *row;
    struct df_timing timing;
    enum df_personality personality;
    struct crt_rate tick;
    uint32_t memory_bytes;
    enum vm_on_stop on_stop;
    struct crt_tube *tube;      /* NULL: nobody observes, so no light is computed */
    struct vm_board *board;     /* NULL: no processor */
    struct vm_console *console; /* far end of the board's UART; NULL: not connected */
    uint8_t *buffer;            /* VIDEO_BUFFER_BYTES for the raster head; NULL: there is none */
    const struct crt_tube_row *raster_row;
    struct ras_timing raster_timing; /* at power-on */
    struct crt_tube *raster_tube;    /* NULL: nobody observes */
    /* Input devices; NULL: there are none. Knobs are those of the monitors, as turned since. */
    const struct inp_setup *setup;
    const struct crt_phosphor *phosphor, *raster_phosphor;
    struct crt_knobs knobs, raster_knobs;
    const struct vm_operator *person; /* NULL: nobody is there */
};

/* An interrupt of the display processor, and the line it drives on the board. */
struct vm_interrupt {
    bool pending; /* as the display processor has it */
    uint64_t count, last_t;
    uint64_t change; /* when the line takes the level of `pending`; VM_NEVER: it has it */
};

/* A word draws no more strokes than this: a vector across the screen, dot by dot, has fewer. */
#define VM_STROKES_KEPT 256

#define VM_NEVER    UINT64_MAX
#define VM_NO_ENTRY 0xFFFFFFFFu

struct vm_machine {
    struct vm_machine_desc desc;
    struct df_dpu dpu;
    bool has_program; /* a display file that the stand-in looks after */
    uint32_t entry;   /* of the display file; VM_NO_ENTRY: none was loaded or started */
    uint32_t beside;  /* entry of the display file that lies beside firmware, or VM_NO_ENTRY */
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
    struct crt_stroke
        recent[VM_STROKES_KEPT]; /* the last strokes, by number modulo that; no part of the
                                                  machine's state, forgotten when one is loaded */
    uint64_t bells;
    uint64_t marks; /* marks set by the program */
    uint32_t mark;  /* the last one's number */
    struct vm_refreshes refreshes;
    struct vm_interrupt interrupt[DF_INT_COUNT];
    struct ras_head raster;   /* with desc.buffer */
    uint64_t raster_advanced; /* what the raster tube was last told */
    struct inp_unit devices;  /* with desc.setup */
    struct vm_done done;      /* of desc.person's acts */
    bool looks[INP_SCREENS];  /* a pen does, at that head */
    uint16_t memory[DF_MEMORY_BYTES / 2];
};

void vm_machine_init(struct vm_machine *m, const struct vm_machine_desc *desc);

/* Resets the display processor, copies the words into display memory and writes the entry to DPC,
 * at the present time. `name` is for the sentence. Nothing has changed when it fails. */
bool vm_machine_load(struct vm_machine *m, const struct df_program *program, const char *name,
                     struct crt_error *err);
/* Firmware for the board, at the present time; `display` (or NULL) is a display file to lie beside
 * it, which it finds by IDENTITY_ENTRY. */
bool vm_machine_boot(struct vm_machine *m, const struct vm_elf *elf,
                     const struct df_program *display, const char *name, struct crt_error *err);
/* Plays a recording instead, from power-on. */
void vm_machine_play(struct vm_machine *m, struct vm_recording recording);

/* Everything that happens before `until`: words fetched, instructions, ticks; then the tube is
 * advanced. */
void vm_machine_run(struct vm_machine *m, uint64_t until);
/* The same with hooks: a loop of its own, so that the other has no test for them. */
void vm_machine_trace(struct vm_machine *m, uint64_t until, const struct vm_hooks *hooks);
/* The same with the processor's hooks only: true when `before` stopped it; m->now is then when the
 * instruction would begin. */
bool vm_machine_watch(struct vm_machine *m, uint64_t until, const struct rv_hooks *hooks);

/* Each of these runs to a moment, or to `limit`: true when it came; m->now is then that moment. */
/* One more is complete; of a loop without sync its first word has been executed again. */
bool vm_machine_run_refresh(struct vm_machine *m, uint64_t limit);
bool vm_machine_run_stop(struct vm_machine *m, uint64_t limit);    /* one more stop word is done */
bool vm_machine_run_console(struct vm_machine *m, uint64_t limit); /* the console's watch fires */
bool vm_machine_run_mark(struct vm_machine *m, uint32_t mark, uint64_t limit);
bool vm_machine_run_end(struct vm_machine *m, uint64_t limit); /* the firmware ends or is lost */
/* rv_retired() is `retired`, at once when it is that or more already. */
bool vm_machine_run_retired(struct vm_machine *m, uint64_t retired, uint64_t limit);
/* m->dpu.words is `words`; what else happens when the last one is fetched has happened, too. */
bool vm_machine_run_words(struct vm_machine *m, uint64_t words, uint64_t limit);

/* One more stroke of the vector head (a lit stretch of the beam's path, a vector with its rests) is over; a word
 * may have many. */
bool vm_machine_run_stroke(struct vm_machine *m, uint64_t limit);
/* When the last stroke before t was over, as far as is known; 0: it is not. */
uint64_t vm_machine_stroke_before(const struct vm_machine *m, uint64_t t);
/* The raster head's next line begins, blanked ones too: one visible, in blanking, or the first of a new
 * timing. */
bool vm_machine_run_line(struct vm_machine *m, uint64_t limit);

/* What a machine is stepped by, and one step; instructions need a board. */
enum vm_unit { VM_UNIT_INSTRUCTION, VM_UNIT_WORD, VM_UNIT_REFRESH, VM_UNIT_STROKE, VM_UNIT_LINE };
bool vm_machine_run_unit(struct vm_machine *m, enum vm_unit unit, uint64_t limit);

/* The stroke under way, or the last one that is over; NULL: there is none, or it was drawn before a state
 * was loaded. */
const struct crt_stroke *vm_machine_stroke(const struct vm_machine *m);
/* Where the vector head's beam was last lit, head units; lit: it is now. False: not known. */
bool vm_machine_beam(const struct vm_machine *m, double *x, double *y, bool *lit);

/* The knobs of a head's monitor, from now on: its tube's, and of what a pen at it sees. */
void vm_machine_turn(struct vm_machine *m, enum inp_screen screen, struct crt_knobs knobs);

/* Head units to tube millimetres: the vector head's units, or the raster head's dots from the top left. */
void vm_machine_place(const struct vm_machine *m, enum inp_screen head, double x, double y,
                      double *x_mm, double *y_mm);
/* The other way. */
void vm_machine_units(const struct vm_machine *m, enum inp_screen head, double x_mm, double y_mm,
                      double *x, double *y);

/* A copy that goes on alone, without tubes and console: for looking ahead. `copy` need not be
 * initialised; vm_machine_forget frees its board and refresh buffer. False: out of memory. */
bool vm_machine_copy(struct vm_machine *copy, const struct vm_machine *m);
void vm_machine_forget(struct vm_machine *copy);

/* Executes one word (or, when the display processor waits, goes on to the next tick): a single
 * step. */
void vm_machine_step(struct vm_machine *m);

/* Whether the program has used a head so far: started the display processor, switched the raster head
 * on. */
bool vm_machine_uses_vector(const struct vm_machine *m);
bool vm_machine_uses_raster(const struct vm_machine *m);

/* The firmware has ended itself; with which exit status. */
bool vm_machine_exited(const struct vm_machine *m, int *status);

/* All of the machine but its tubes, between two events: board and console, too. When the machine has
 * a tube, that must have been loaded before, and belong to the same instant. A machine whose loading
 * failed is fit to be initialised or loaded again, for nothing else. */
void vm_machine_state(struct vm_machine *m, struct crt_state *s);

#endif
