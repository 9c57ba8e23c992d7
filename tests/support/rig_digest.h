/* rig_digest.h — a sum over all that a rig is: light, registers, memory, counts; for tests. */
#ifndef TESTS_SUPPORT_RIG_DIGEST_H
#define TESTS_SUPPORT_RIG_DIGEST_H

#include "emu/debug/snapshot.h"

struct digest {
    uint8_t byte[VM_SNAPSHOT_SUM];
};

static inline struct digest rig_digest(struct vm_rig *rig)
{
    struct crt_state s;
    struct digest d;
    crt_state_save(&s);
    vm_rig_state(rig, &s);
    assert_false(s.failed);
    vm_snapshot_sum(s.out, s.size, d.byte);
    crt_state_free(&s);
    return d;
}

#endif
