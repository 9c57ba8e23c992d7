/* expose.h — runs machines with their tubes and hands out frames: one, or a sequence; of one machine, or of
 * several side by side.
 *
 *      shot n: [begin, at)      a side gathers the light of [at − exposure, at), or of the shot itself
 *
 * Models:     nothing. Frames may overlap when the exposure is longer than what lies between the shots.
 *             Exposures are cut off at power-on. Each side runs by itself, to the same instants.
 * Time:       picoseconds.
 * Ownership:  the shots are malloced, vm_shots_free releases them. The frames belong to vm_expose and live
 *             until the sink returns.
 * Errors:     one sentence; a sink that fails stops the run.
 */
#ifndef EMU_EXPOSE_H
#define EMU_EXPOSE_H

#include "emu/frame.h"
#include "emu/progress.h"
#include "emu/versus.h"

#define VM_OVERLAP_MAX 64

/* The instant of a picture, and when what it is of began: before that, or the same. */
struct vm_shot {
    uint64_t begin, at;
};

/* In order of time. */
struct vm_shots {
    struct vm_shot *shot;
    uint64_t count;
};

bool vm_shots_init(struct vm_shots *shots, uint64_t count, struct crt_error *err);
void vm_shots_free(struct vm_shots *shots);
/* from, and so on `fps` times a second: instants come from their numbers, not by adding rounded intervals. */
void vm_shots_at_rate(struct vm_shots *shots, uint64_t from, struct crt_rate fps);
/* At most `most` of them, evenly chosen, the first and the last among them. */
void vm_shots_choose(struct vm_shots *shots, uint64_t most);

/* The number of the n-th one chosen. */
uint64_t vm_shots_chosen(uint64_t n, uint64_t count, uint64_t most);

/* How many frames of that exposure (0: the shots' own) are open at once; above VM_OVERLAP_MAX vm_expose
 * refuses. */
uint64_t vm_shots_overlap(const struct vm_shots *shots, uint64_t exposure);

/* A machine, and for how long its pictures gather light; 0: as long as the shot says. */
struct vm_exposed {
    struct vm_rig *rig;
    uint64_t exposure;
};

/* Receives the frames of shot `number` (from 0), one of each side; the machines are at its instant. */
typedef bool (*vm_frame_sink)(void *ctx, const struct vm_frame *const frame[], uint64_t number,
                              struct crt_error *err);

/* `count` sides, at most VM_SIDES; `progress` may be NULL. */
bool vm_expose(const struct vm_exposed *sides, int count, const struct vm_shots *shots,
               struct vm_progress *progress, vm_frame_sink sink, void *ctx, struct crt_error *err);

#endif
