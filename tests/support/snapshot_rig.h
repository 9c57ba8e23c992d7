/* snapshot_rig.h — a run of a program, to be saved, loaded and gone on with: what the tests of snapshots
 * share.
 *
 * Models:     a rig with its input and settings, and hashes of all it did while it was traced.
 * Programs:   a file; "randomN", words at random from seed N, with a pen that fires; "recording".
 * Ownership:  snap_open allocates, snap_close frees; a state from snap_save is the caller's.
 * Errors:     what goes wrong is a failed assertion of cmocka.
 */
#ifndef TESTS_SNAPSHOT_RIG_H
#define TESTS_SNAPSHOT_RIG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "emu/debug/snapshot.h"

#define MS   CRT_PS_PER_MS
#define TICK (CRT_PS_PER_S / 60)

/* Everything one run needs. Its parts point at each other: it stays where it is. */
struct snap_run {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_settings_options options;
    struct vm_rig rig;
    bool pen;         /* of the rig: it fires by itself */
    uint64_t drawn;   /* hash of what the machine did while traced */
    uint64_t printed; /* and of what it printed */
};

extern const struct vm_settings_options snap_plain;

/* `light`: with a tube. */
struct snap_run *snap_open(const char *path, bool light, const struct vm_settings_options *options);
void snap_close(struct snap_run *r);
struct crt_state snap_save(struct snap_run *r);
bool snap_load(struct snap_run *r, const uint8_t *bytes, size_t size, struct crt_error *err);
void snap_must_load(struct snap_run *r, const struct crt_state *s);
/* Loading fails with the sentence, and nothing has changed. */
void snap_refused(struct snap_run *r, const struct crt_state *s, const char *sentence);
void snap_same(struct snap_run *a, struct snap_run *b);

/* Two runs in the same state do the same from t0 to t1. */
void snap_go_on_alike(struct snap_run *a, struct snap_run *b, uint64_t t0, uint64_t t1);
/* Somewhere within `span` ps: between words, in them, where something waits. */
void snap_run_somewhere(struct snap_run *r, uint64_t *seed, uint64_t span);
/* Not a sanitizer's build, which would take long. */
bool snap_thorough(void);

#endif
