/* snapshot.h — a file that holds a machine and its tube at one instant.
 *
 *      "KNSCSTAT"  version  length │ CONF │ TUBE (if somebody looked) │ DPU, MACH, … │ SHA-256
 *                                    └─ what it was made with: emu/debug/config.h
 *
 * Models:     a run continued from a snapshot is the same, bit for bit, as one that never stopped:
 *             light, registers, traces. The bytes are the same whatever observed, on every host.
 * Loading:    into a rig opened with the same program, tube, phosphor and machine. Everything is
 *             checked; a rig whose loading failed is as it was before.
 * Light:      a rig without a tube passes over the tube's part; one with a tube needs it. Films
 *             that are open on it are cancelled.
 * Ownership:  nothing is kept.
 * Errors:     one sentence that names the file.
 */
#ifndef EMU_DEBUG_SNAPSHOT_H
#define EMU_DEBUG_SNAPSHOT_H

#include "crt/state.h"
#include "emu/rig.h"

/* The file is written whole or not at all. */
bool vm_snapshot_save(const char *path, struct vm_rig *rig, const struct vm_settings *settings,
                      const struct vm_input *input, struct crt_error *err);
bool vm_snapshot_load(const char *path, struct vm_rig *rig, const struct vm_settings *settings,
                      const struct vm_input *input, struct crt_error *err);

/* The same in memory: s->out holds the file's bytes when all went well, and crt_state_free releases
 * them in any case. `name` stands for the file in sentences. */
bool vm_snapshot_write(struct crt_state *s, struct vm_rig *rig, const struct vm_settings *settings,
                       const struct vm_input *input, struct crt_error *err);
bool vm_snapshot_read(const uint8_t *bytes, size_t size, const char *name, struct vm_rig *rig,
                      const struct vm_settings *settings, const struct vm_input *input,
                      struct crt_error *err);

/* Without the file around it: tube, if there is one, and machine. */
void vm_rig_state(struct vm_rig *rig, struct crt_state *s);

/* The check sum over `size` bytes, which stands after them. */
#define VM_SNAPSHOT_SUM 32
void vm_snapshot_sum(const uint8_t *bytes, size_t size, uint8_t sum[VM_SNAPSHOT_SUM]);

#endif
