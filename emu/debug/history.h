/* history.h — going back: a run remembered by snapshots, and replayed from one of them.
 *
 *      ●────────●───●──●─●●●          snapshots: the older, the sparser
 *                      │ load
 *                      └──▶ replay ──▶ ◎ target      now ✕
 *
 * Models:     a run is deterministic, so the state after instruction, word or refresh n is that of
 *             an earlier snapshot run on to n: bit for bit what it was, light included.
 * Outside:    what reaches the machine from outside (a knob turned, memory written by a debugger)
 *             is not replayed. vm_history_mark tells of it, and no replay crosses such a moment.
 *             What the machine logs itself (console input) needs no mark.
 * Time:       picoseconds of simulated time. Snapshots are taken by vm_history_note when due: call
 *             it between runs, as often as convenient.
 * Memory:     below the budget; when it is full, the snapshot goes whose gap is smallest for its
 *             age, so that the spacing grows with age.
 * Films:      none may be open on the rig's tube when going back.
 * Ownership:  vm_history_create allocates, vm_history_destroy frees; the rig must outlive it.
 * Errors:     one sentence. Out of memory: there is less history.
 */
#ifndef EMU_DEBUG_HISTORY_H
#define EMU_DEBUG_HISTORY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/error.h"
#include "emu/rig.h"

struct vm_history_desc {
    struct vm_rig *rig;
    uint64_t period; /* ps between snapshots; 0: a tenth of a second */
    size_t budget;   /* bytes; 0: 256 MiB */
};

struct vm_history;

/* Takes the first snapshot: further back nothing goes. */
struct vm_history *vm_history_create(const struct vm_history_desc *desc, struct crt_error *err);
void vm_history_destroy(struct vm_history *h);

/* Takes a snapshot when one is due. */
void vm_history_note(struct vm_history *h);
/* The machine was just changed from outside. */
void vm_history_mark(struct vm_history *h);
/* Forgets all and begins here: another program, another snapshot was loaded. */
void vm_history_forget(struct vm_history *h);

enum vm_unit { VM_UNIT_INSTRUCTION, VM_UNIT_WORD, VM_UNIT_REFRESH };

/* Goes back by n instructions of the processor, n words of the display processor, or to the n-th end
 * of a refresh before here (from within a refresh the first is where it began). False and a sentence: not that
 * much is remembered; the rig is then where memory begins. */
bool vm_history_back(struct vm_history *h, enum vm_unit unit, uint64_t n, struct crt_error *err);
/* Runs the rig on to the next place where a condition holds, and returns true there; false with the
 * rig at `limit` ps: what begins then or later does not count. Where the rig is at the call counts
 * only when `here`. Must do the same again when called again from the same state. */
typedef bool vm_history_find(void *ctx, struct vm_rig *rig, uint64_t limit, bool here);

/* Goes back to the last place before now at which the condition held. False and a sentence: there
 * is none in what is remembered; the rig is then where memory begins. */
bool vm_history_back_until(struct vm_history *h, vm_history_find *find, void *ctx,
                           struct crt_error *err);

/* How much is remembered. */
struct vm_history_extent {
    size_t snapshots, bytes;
    uint64_t oldest; /* ps */
};
struct vm_history_extent vm_history_extent(const struct vm_history *h);

#endif
