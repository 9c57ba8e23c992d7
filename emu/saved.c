#include "emu/saved.h"

#include "emu/debug/snapshot.h"

#define ROW(field) offsetof(struct vm_saved_options, field)

const struct vm_option vm_saved_rows[VM_SAVED_ROWS] = {
    {"save-state", 0, VM_OPT_STRING, ROW(save), "FILE",
     "write the whole machine and its tube to FILE when all is done", 0, 0},
    {"load-state", 0, VM_OPT_STRING, ROW(load), "FILE",
     "go on from the machine in FILE, made with the same program and tube", 0, 0},
};

bool vm_saved_load(const struct vm_saved_options *o, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err)
{
    return !o->load || vm_snapshot_load(o->load, rig, settings, input, err);
}

bool vm_saved_save(const struct vm_saved_options *o, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err)
{
    return !o->save || vm_snapshot_save(o->save, rig, settings, input, err);
}
