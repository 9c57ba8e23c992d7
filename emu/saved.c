#include "emu/saved.h"

#include <string.h>

#include "emu/command.h"
#include "emu/debug/snapshot.h"
#include "emu/out_file.h"

#define ROW(field) offsetof(struct vm_saved_options, field)

const struct vm_option vm_saved_rows[VM_SAVED_ROWS] = {
    {"save-state", 0, VM_OPT_STRING, ROW(save), "FILE",
     "write the whole machine and its tube to FILE when all is done", 0, 0},
    {"load-state", 0, VM_OPT_STRING, ROW(load), "FILE",
     "go on from the machine in FILE, made with the same program and tube", 0, 0},
};

static bool spares(const struct vm_saved_options *o, const char *program,
                   const struct vm_input_options *input, const char *out, struct crt_error *err)
{
    if (!vm_input_spared(input, program, o->save, err) ||
        !vm_input_spared(input, program, out, err) || !vm_out_spares(out, o->load, err))
        return false;
    return !o->save || !out || strcmp(o->save, out) != 0 ||
           crt_fail(err, "--save-state: %.200s is where the output goes; give another name", out);
}

int vm_saved_check(const struct vm_saved_options *o, const char *program,
                   const struct vm_input_options *input, const char *out, struct crt_error *err)
{
    if (!spares(o, program, input, out, err))
        return VM_EXIT_USAGE;
    return !o->save || vm_out_check(o->save, err) ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}

bool vm_saved_load(const struct vm_saved_options *o, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err)
{
    if (!o->load)
        return true;
    if (!vm_snapshot_load(o->load, rig, settings, input, err))
        return false;
    /* Knobs are part of the snapshot; those of --set are turned now. */
    for (int h = 0; h < VM_HEADS; h++)
        if (settings->monitor[h].turned)
            vm_machine_turn(rig->machine, (enum inp_screen)h, settings->monitor[h].knobs);
    return true;
}

bool vm_saved_save(const struct vm_saved_options *o, struct vm_rig *rig,
                   const struct vm_settings *settings, const struct vm_input *input,
                   struct crt_error *err)
{
    return !o->save || vm_snapshot_save(o->save, rig, settings, input, err);
}
