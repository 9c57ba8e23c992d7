/* why.h — provenance of light: what put the light there that a place on the glass shows now.
 *
 *      power-on, a saved state, or the window's history
 *          │ run again, with a photodiode at the place and a record of who stored what
 *          ▼
 *      deposits ─┬─ vector head: the display word of each piece, as it was then ─┬─▶ struct vm_why
 *                └─ raster head: the scan line, its dots there, their bytes     ─┘    (why_text.h
 *                                 └──▶ the store that wrote them last before that      makes lines)
 *
 * Models:     nothing of its own: shares are those of crt/photodiode.h. What a word was is read from
 *             display memory when its piece was drawn; who wrote a byte is the last store before
 *             that, or before the scan line was read.
 * Dots:       a scan line lights a place by the dots around it: the one named is the one that gives most,
 *             the range has those that give at least a thousandth of that; both by the spot's width
 *             at the line's brightest dot there. Shares do not depend on it.
 * Observing:  never disturbs: what runs is a machine of its own.
 * Time:       picoseconds since power-on.
 * Units:      cd/m² of luminance, cd·s/m² of fluence, all colours together.
 * Ownership:  vm_why_run and vm_why_past allocate what vm_why_free releases. Settings and input stay
 *             the caller's and may go before the answer does.
 * Errors:     an exit status or false, and one sentence; nothing is to be freed then.
 * Not modelled: bytes that the firmware's image or a display file brought along have no store. What a
 *             debugger writes has none either.
 */
#ifndef EMU_LAB_WHY_H
#define EMU_LAB_WHY_H

#include "emu/debug/history.h"
#include "emu/rig.h"
#include "emu/saved.h"

/* A place on a head's glass: millimetres from the middle, y up; and in head units, of the vector head
 * from the bottom left, of the raster head dots from the top left. */
struct vm_why_place {
    enum vm_head head;
    double x, y, x_mm, y_mm;
};

/* From head units, or from millimetres, as the machine's heads are set up now. */
struct vm_why_place vm_why_at(const struct vm_machine *m, enum vm_head head, double x, double y);
struct vm_why_place vm_why_at_mm(const struct vm_machine *m, enum vm_head head, double x_mm,
                                 double y_mm);

/* A store of the processor. */
struct vm_why_store {
    bool known;          /* false: none since the record began */
    uint32_t pc, word;   /* the instruction */
    uint32_t returns_to; /* register ra then: of a function that calls none, who called it */
    uint64_t t, cycle;   /* when the instruction began, ps and clocks */
};

struct vm_why_word {
    uint32_t address; /* of the datum's first word: bytes of display memory */
    uint16_t word[2];
    int words;     /* of the datum: 1 or 2 */
    unsigned mode; /* DF_MODE_… it was read in */
};

/* Rows from 0 at the top; what is no row of the picture is overscan: no pixel, no bytes. */
struct vm_why_row {
    int32_t row;
    bool overscan;
    int32_t dot, first, last; /* the dot that gives most here; those that give something */
    uint32_t address, bytes;  /* of that dot in the refresh buffer; its bytes */
    uint32_t bits;            /* a dot has so many */
};

struct vm_why_deposit {
    uint64_t t0, t1;         /* ps, while its beam was lit */
    double fluence;          /* cd·s/m², all it gives here in the end */
    double share;            /* cd/m² of what is seen now */
    uint32_t source;         /* as crt/piece.h has it */
    bool named;              /* what follows is known */
    struct vm_why_word word; /* vector head */
    struct vm_why_row row;   /* raster head */
    struct vm_why_store store;
};

#define VM_WHY_LATELY (CRT_PS_PER_S / 10)

struct vm_why {
    struct vm_why_place place;
    uint64_t t;       /* when one looks */
    uint64_t from;    /* what came before is `older` */
    bool power_on;    /* `from` is when the machine was switched on: nothing came before */
    bool stores;      /* there is a processor, whose stores were recorded */
    bool recording;   /* the strokes are of a recording: there are no words */
    double luminance; /* cd/m² */
    double older;     /* of it, of light from before `from` */
    struct vm_why_deposit
        *deposit; /* in order of t0; their shares and `older` sum to `luminance` */
    size_t count;
    /* Of the last VM_WHY_LATELY: the lit beam that came
     * nearest, and on the raster head what the line nearest to the place had there, lit or not. */
    bool near, passed;
    struct vm_why_deposit nearest, at_place; /* without fluence and share */
    double nearest_mm;                       /* from the place to the middle of the beam */
};

struct vm_why_desc {
    const struct vm_settings *settings;
    const struct vm_input *input;
    struct vm_why_place place;
};

/* Runs a machine of its own from power-on, or from saved->load, to t: an exit status. */
int vm_why_run(struct vm_why *why, const struct vm_why_desc *desc,
               const struct vm_saved_options *saved, uint64_t t, struct crt_error *err);

/* The same for a machine as it stands, run again from what `history` remembers of it: light from before
 * that is `older`, stores from before are unknown. Half a second is run again with light, and more in the
 * dark when it is not known who stored what is seen, as long as that takes about a second of the host's.
 * `desc` is what the rig was opened with. */
bool vm_why_past(struct vm_why *why, const struct vm_why_desc *desc, const struct vm_rig *rig,
                 const struct vm_history *history, struct crt_error *err);

void vm_why_free(struct vm_why *why);

#endif
