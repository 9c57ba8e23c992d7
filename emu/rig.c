#include "emu/rig.h"

#include <stdlib.h>

bool vm_rig_open(struct vm_rig *rig, const struct vm_settings *settings,
                 const struct vm_input *input, enum df_timing_choice timing,
                 const struct crt_tube_desc *tube, struct crt_error *err)
{
    *rig = (struct vm_rig){calloc(1, sizeof *rig->machine), NULL};
    if (!rig->machine)
        return crt_fail(err, "not enough memory for the machine; close other programs");
    if (tube && !(rig->tube = crt_tube_create(tube, err))) {
        vm_rig_close(rig);
        return false;
    }
    struct vm_machine_desc desc = vm_settings_machine(settings, timing, rig->tube);
    vm_machine_init(rig->machine, &desc);
    if (!vm_input_insert(input, rig->machine, err)) {
        vm_rig_close(rig);
        return false;
    }
    return true;
}

void vm_rig_close(struct vm_rig *rig)
{
    if (rig->tube)
        crt_tube_destroy(rig->tube);
    free(rig->machine);
    *rig = (struct vm_rig){NULL, NULL};
}
