#include "emu/program_settings.h"

#include "emu/command.h"
#include "emu/script_suits.h"
#include "emu/view.h"

bool vm_program_suits(const struct vm_settings *settings, const struct vm_input *input,
                      struct crt_error *err)
{
    return vm_view_suits(settings, input, err) && vm_script_suits(settings, input, err);
}

int vm_program_settings(const struct vm_settings_options *options, const struct vm_input *input,
                        struct vm_settings *settings, struct crt_error *err)
{
    int status = vm_settings_resolve(options, input->is_recording ? &input->header : NULL,
                                     vm_input_tube(input), settings, err);
    return status == VM_EXIT_OK && !vm_program_suits(settings, input, err) ? VM_EXIT_USAGE : status;
}
