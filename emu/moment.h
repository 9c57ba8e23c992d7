/* moment.h — when to take the picture: found by running the machine once without light.
 *
 *      --at T                     that time
 *      --when stop:N | refresh:N  end of the N-th stop word or refresh
 *      --when mark:N              the firmware's store of N to IDENTITY_MARK
 *      --when console:TEXT        the end of the last byte of TEXT on the console
 *      neither                    end of the first complete refresh that begins at 0.5 s or later;
 *                                 of a recording its end; where something is typed or --input has
 *                                 acts, later than firmware has read it, the acts are over, and it
 *                                 waits for more (or computes for 3 s)
 *
 * Models:     nothing. Stops and refreshes are counted from where the run begins: power-on, or the
 *             machine of --load-state; then "neither" is the first refresh that begins a tick later.
 * Time:       picoseconds since power-on.
 * Ownership:  the rig stays the caller's.
 * Errors:     an exit status and one sentence: 1 guest trouble, 2 usage, 3 the moment does not come
 *             within --timeout of simulated time.
 */
#ifndef EMU_MOMENT_H
#define EMU_MOMENT_H

#include "emu/rig.h"

struct vm_moment_options {
    struct vm_time at, timeout;
    const char *when;
};

/* By then the first refreshes have passed and phosphors have settled. */
#define VM_SETTLED_PS (CRT_PS_PER_S / 2)

#define VM_MOMENT_ROWS 3
extern const struct vm_option vm_moment_rows[VM_MOMENT_ROWS];

/* Runs `rig`, which has no tube, to the moment and stores it; the rig is then as the program is. */
int vm_moment_find(struct vm_rig *rig, const struct vm_moment_options *options,
                   const struct vm_settings *settings, const struct vm_input *input,
                   uint64_t *moment, struct crt_error *err);

#endif
