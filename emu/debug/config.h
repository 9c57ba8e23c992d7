/* config.h — what a snapshot depends on and does not hold: program, tube, phosphor, machine.
 *
 *      program ──┐
 *      tube row ─┼─▶ fields, little-endian ─▶ SHA-256 each ─▶ compared by kind, so that a refusal
 *      phosphor ─┤                                            can say what differs
 *      machine ──┘
 *
 * Models:     the part of a run that is given from outside. Knobs, threads and kernels are no part
 *             of it: knobs are state, and light does not depend on the others. Figures count, not
 *             names: a tube of the same name with another spot is another tube.
 * Ownership:  plain value.
 * Errors:     vm_config_of: out of memory. vm_config_agree: one sentence without the file's name.
 */
#ifndef EMU_DEBUG_CONFIG_H
#define EMU_DEBUG_CONFIG_H

#include "crt/state.h"
#include "emu/rig.h"

enum vm_config_kind {
    VM_CONFIG_PROGRAM,
    VM_CONFIG_TUBE,
    VM_CONFIG_PHOSPHOR,
    VM_CONFIG_RASTER, /* tube, phosphor and mode at power-on */
    VM_CONFIG_INPUT,
    VM_CONFIG_MACHINE,
    VM_CONFIG_KINDS
};

#define VM_CONFIG_HASH 32 /* bytes of SHA-256 */

struct vm_config {
    char program[64], tube[24], phosphor[16], raster[24];
    struct crt_rate tick;
    uint8_t hash[VM_CONFIG_KINDS][VM_CONFIG_HASH];
};

bool vm_config_of(struct vm_config *config, const struct vm_rig *rig,
                  const struct vm_settings *settings, const struct vm_input *input,
                  struct crt_error *err);

/* Whether a snapshot made with `theirs` can go on in `ours`. */
bool vm_config_agree(const struct vm_config *theirs, const struct vm_config *ours,
                     struct crt_error *err);

void vm_config_state(struct vm_config *config, struct crt_state *s);

#endif
