/* dpu.h — the display processor: a DEC VT11, word by word, or with the colours of the VS60.
 *
 *                    ┌───────────────────────────────┐
 *   display memory ─▶│ fetch ─▶ decode ─▶ vector gen │─▶ offer ─▶ (pen) ─▶ commit ─▶ tube
 *     START/RESUME ─▶│ DPC MPR XPR YPR    char gen   │─▶ interrupt lines: stop, pen, character
 *        sync tick ─▶└───────────────────────────────┘─▶ bell
 *
 * Models:     the VT11 instruction set bit for bit: modes, data, status words, registers and their
 *             write effects, wrap at 12 bits, dashes, blink, italics, shift-out; stop, pen,
 *             character and bus time-out interrupts; the re-fetch hang of illegal words.
 *             Personality VS60: Load Status B sets the colour, which strokes carry as their level;
 *             a change takes colour_switch_ps more, with the beam off. Assumed: setting the colour
 *             that is set takes nothing; the colour is green after reset and START leaves it; the
 *             processor fetches nothing while the voltage changes. The rest is the VT11's.
 * Time:       picoseconds; `t` is the fetch time of the next word. Every word costs more than 0 ps.
 *             The generators start when the word (or its last word) has been decoded.
 * Position:   registers in head units; strokes leave in tube millimetres through desc.screen.
 * Ownership:  the caller owns the struct; memory, screen and contexts must outlive it. Allocates
 *             nothing.
 * Errors:     guest trouble becomes a status bit, an interrupt or a hang as in hardware; misuse
 *             asserts.
 * Source:     DEC EK-VT11-TM-001, EK-VT48-TM-001 (VS60); open questions are marked "assumed" where
 *             they are decided.
 * Not modelled: bus contention, analog drift, the rest of the VS60 (its words are the VT11's here,
 *             illegal ones among them).
 */
#ifndef DF_DPU_H
#define DF_DPU_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/geometry.h"
#include "crt/piece.h"
#include "crt/state.h"
#include "display_file/timing.h"

enum df_personality {
    DF_VT11,
    DF_VS60 /* so far: colour only */
};

enum df_interrupt { DF_INT_STOP, DF_INT_PEN, DF_INT_CHARACTER, DF_INT_COUNT };

enum df_state {
    DF_STOPPED, /* DSTOP, or never started */
    DF_RUNNING,
    DF_WAITING_SYNC,   /* Load Status A with sync: until df_dpu_sync() */
    DF_WAITING_RESUME, /* pen hit, character or time-out interrupt: until RESUME or START */
};

#define DF_NO_HIT UINT64_MAX

/* Where beam pieces go. `offer` may be NULL (no pen): it returns the time within the stroke at
 * which a pen fires, or DF_NO_HIT; the generator then cuts the stroke there. `commit` receives what
 * is left. Every lit piece is offered once, in order, also where the processor ignores the answer
 * (first and last columns of a character, a vector or character that was hit already, the intensify
 * spot): the pen sees light, not logic. What a cut leaves over is offered again when it is drawn.
 */
struct df_beam {
    void *ctx;
    uint64_t (*offer)(void *ctx, const struct crt_stroke *stroke);
    void (*commit)(void *ctx, const struct crt_stroke *stroke);
};

struct df_wires {
    void *ctx;
    void (*interrupt)(void *ctx, enum df_interrupt line, bool level, uint64_t t); /* may be NULL */
    void (*bell)(void *ctx, uint64_t t);                                          /* may be NULL */
};

struct df_dpu_desc {
    enum df_personality personality;
    const uint16_t *memory; /* display memory, words */
    uint32_t memory_bytes;  /* fetches at or above time out */
    struct crt_screen screen;
    struct df_timing timing;
    double drive[8]; /* beam drive of each intensity level, 0…1 */
    struct df_beam beam;
    struct df_wires wires;
};

/* The vector being drawn; after a pen interrupt, what RESUME still has to draw. */
struct df_pending_vector {
    bool active;
    int32_t x0, y0; /* where it started, head units */
    int32_t x1, y1; /* where it is going, head units before wrapping (on screen when drawn) */
    uint32_t units; /* along the longer axis */
    uint64_t span;  /* ps the beam is lit, rests included */
    uint64_t rest;  /* of that, ps it rests at each end */
    uint64_t done;  /* ps of the span already drawn */
};

/* The second character of a word whose first one raised an interrupt; RESUME draws it. */
struct df_pending_character {
    bool active;
    uint8_t code;
};

/* What has been executed since reset, for summaries. */
struct df_usage {
    uint64_t vectors;    /* not null, beam on, whether or not on screen */
    uint64_t points;     /* lit points: point, graphplot, relative */
    uint64_t characters; /* cells, spaces included */
    uint64_t moves;      /* beam-off moves */
    uint64_t strokes;    /* committed */
    uint64_t lit_ps;     /* with the beam on */
    uint64_t colours;    /* changes of colour */
};

struct df_dpu {
    struct df_dpu_desc desc;
    uint64_t t; /* fetch time of the next word; no stroke ends later */
    enum df_state state;
    uint16_t dpc;
    bool illegal;          /* re-fetching an illegal word for ever */
    bool timeout;          /* stopped by a bus time-out */
    uint64_t words;        /* executed since reset */
    uint64_t instructions; /* the same; a datum or jump of two words counts once, at its end */
    struct df_usage usage;

    /* registers (dpu_control.c sets them, dpu.c reads them out) */
    unsigned mode, intensity, line_type, step;
    unsigned colour; /* DF_COLOUR_…; on a VT11 never changed */
    unsigned opcode; /* MPR 74000: assumed to be of the last control word or datum */
    bool blink, italics, shift_out, pen_interrupt, pen_intensify, stop_interrupt;
    bool internal_stop, hit, edge;
    bool so_error;         /* MPR 100, assumed: a code of 40 or more while shifted out */
    int32_t x, y;          /* position, 12-bit two's complement range wraps */
    uint16_t hit_x, hit_y; /* latched at a pen hit */
    uint16_t character;    /* the last code the character generator took */
    bool pending[DF_INT_COUNT];
    uint64_t raised_at; /* when one was raised last, ps */

    /* the word being executed (dpu.c, dpu_data.c) */
    uint16_t first_word; /* first half of a two-word datum */
    uint8_t phase;       /* enum df_phase of dpu_internal.h */
    uint32_t source;     /* address of the datum's first word */
    uint64_t clock;      /* how far the generators have got, ps */
    uint64_t window;     /* average mode: ps this action must fill */
    bool stopping;       /* a pen hit with its interrupt enabled happened in this action */

    /* generators (vecgen.c, chargen.c) */
    int32_t max_x, max_y;       /* the last units on screen */
    struct crt_placing placing; /* head units to millimetres */
    struct df_pending_vector vector;
    struct df_pending_character second;
};

/* Copies desc and resets at time 0. Times in desc.timing are brought into 1 ps … 1 s where the
 * beam needs them not to be 0 (fetch, vector unit, point, dot). */
void df_dpu_init(struct df_dpu *dpu, const struct df_dpu_desc *desc);
/* Power-on state: stopped, character mode, intensity 4, solid, green, interrupts off, pen intensify on.
 * Never takes back strokes already committed: `t` is the later of the given time and theirs. */
void df_dpu_reset(struct df_dpu *dpu, uint64_t t);

/* Registers (display_file/df_regs.h offsets) at time t. Writes act at t, or when the generator has
 * finished what it is drawing, if that is later. Other offsets read 0 and ignore writes. */
uint16_t df_dpu_read(const struct df_dpu *dpu, unsigned offset);
void df_dpu_write(struct df_dpu *dpu, unsigned offset, uint16_t value, uint64_t t);

/* What strokes carry now: CRT_LEVEL_ONLY on a VT11. */
enum crt_level df_dpu_level(const struct df_dpu *dpu);

/* Executes the word at dpu->t. Requires DF_RUNNING. */
void df_dpu_step(struct df_dpu *dpu);

/* The line sync tick. */
void df_dpu_sync(struct df_dpu *dpu, uint64_t t);

/* Everything but desc and what follows from it, between two words: also what RESUME has still to
 * draw, half a datum, levels of the interrupt lines. Loading calls no wire: whoever keeps levels
 * loads them itself. A processor whose loading failed is fit to be reset or loaded again. */
void df_dpu_state(struct df_dpu *dpu, struct crt_state *s);

#endif
