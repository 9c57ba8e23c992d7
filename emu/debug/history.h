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
 * Films:      that are open on the rig's tube are cancelled by going back.
 * Ownership:  vm_history_create allocates, vm_history_destroy frees; the rig must outlive it.
 * Errors:     one sentence. Out of memory: there is less history, or none before a mark.
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

/* Goes back by n instructions of the processor, n words of the display processor, or to the n-th end
 * of a refresh before here (from within a refresh the first is where it began), of a stroke, or beginning of
 * a line, that is earlier than now. False and a sentence: not that
 * much is remembered; the rig is then where memory begins. */
bool vm_history_back(struct vm_history *h, enum vm_unit unit, uint64_t n, struct crt_error *err);
/* Restores the last snapshot in which the processor's clock is before `cycle`, and forgets the later
 * ones; false when there is none, and nothing has changed. For who searches the past himself
 * (emu/debug/gdb_target.h). */
bool vm_history_rewind(struct vm_history *h, uint64_t cycle);

/* Restores the last snapshot at or before `t` ps, but none from before the last mark; the first of all
 * when there is none. False and a sentence: nothing is remembered. For who runs on from there
 * himself. */
bool vm_history_recall(struct vm_history *h, uint64_t t, struct crt_error *err);

/* The snapshot that vm_history_recall would restore, without restoring it: bytes for vm_rig_state, valid
 * until the history changes, and when it was taken, ps. NULL: nothing is remembered. */
const uint8_t *vm_history_snapshot(const struct vm_history *h, uint64_t t, size_t *size,
                                   uint64_t *taken);

/* How much is remembered. */
struct vm_history_extent {
    size_t snapshots, bytes;
    uint64_t oldest; /* ps */
};
struct vm_history_extent vm_history_extent(const struct vm_history *h);

#endif
