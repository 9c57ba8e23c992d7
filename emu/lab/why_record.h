/* why_record.h — what was drawn near a place, noted while it was drawn: for why.h.
 *
 *      strokes, scan lines of a traced machine ──▶ notes ──▶ those that became deposits stay
 *                                    └──▶ what came nearest, from `near_from` on
 *
 * Models:     a note is a deposit (why.h) without light: time, word or dots, and who stored them. Words are
 *             read from display memory, dots and their bytes from the raster head, as they are when
 *             the beam is drawn.
 * Time:       picoseconds.
 * Ownership:  the caller's struct; vm_why_record_free releases what it holds.
 * Errors:     out of memory: `failed`.
 */
#ifndef EMU_LAB_WHY_RECORD_H
#define EMU_LAB_WHY_RECORD_H

#include "crt/photodiode.h"
#include "emu/lab/why_stores.h"

struct vm_why_record {
    const struct vm_machine *machine;
    const struct vm_stores *stores;
    struct vm_why_place place;
    struct vm_why_deposit *note; /* in order of t0 */
    size_t count, room;
    size_t kept; /* those before have been compared with the deposits */
    bool failed;
    /* What came nearest. */
    uint64_t near_from;
    bool near, passed;
    struct vm_why_deposit nearest, at_place;
    double nearest_mm, passed_mm;
    /* Of the raster tube's spot: by drive, as the knobs are. */
    struct crt_knobs knobs;
    double current[256], sigma[256], reach_mm;
    struct vm_hooks hooks; /* for vm_machine_trace */
};

/* `record` must stay where it is while its hooks are in use. */
void vm_why_record_init(struct vm_why_record *record, const struct vm_machine *machine,
                        const struct vm_stores *stores, const struct vm_why_place *place);
void vm_why_record_free(struct vm_why_record *record);

/* Forgets notes of what began before `now` and is no deposit. */
void vm_why_record_prune(struct vm_why_record *record, const struct crt_deposit *deposit,
                         size_t count, uint64_t now);
/* Forgets those that began before t. */
void vm_why_record_forget(struct vm_why_record *record, uint64_t t);
/* The note of a deposit; NULL: there is none. */
const struct vm_why_deposit *vm_why_record_find(const struct vm_why_record *record,
                                                const struct crt_deposit *deposit);

#endif
