#include "emu/script_suits.h"

#include <stdio.h>
#include <string.h>

#include "emu/heads.h"

/* Why the act cannot be done. */
static void say_why(const struct vm_settings *s, unsigned heads, const struct inp_act *act,
                    const char *program, char *why, size_t size)
{
    static const char *const names[] = {"pen", "tablet", "touch", "keyboard", "mouse"};
    const struct inp_setup *setup = &s->setup;
    bool headed = act->device == INP_PEN || act->device == INP_TOUCH || act->device == INP_KNOB;
    if (act->device == INP_TABLET && setup->tablet.kind != TABLET_NONE)
        snprintf(why, size, "the last button there is %g (--set tablet.buttons=%g)",
                 setup->tablet.buttons.value - 1, setup->tablet.buttons.value);
    else if (act->device == INP_TOUCH && setup->touch.kind != TOUCH_NONE &&
             act->screen != setup->touch.screen)
        snprintf(why, size, "the touch panel is over the other head (--set touch.screen=%s)",
                 act->screen == INP_RASTER ? "raster" : "vector");
    else if (headed && !(heads >> act->screen & 1))
        snprintf(why, size, "%s has no firmware and so no raster head", program);
    else
        snprintf(why, size, "there is none (--set %s=none)", names[act->device]);
}

bool vm_script_suits(const struct vm_settings *s, const struct vm_input *input,
                     struct crt_error *err)
{
    char text[INP_STATEMENT_MOST], why[160];
    unsigned heads = 1u << VM_VECTOR | (input->has_firmware ? 1u << VM_RASTER : 0);
    for (size_t i = 0; i < input->script.count; i++) {
        const struct inp_act *act = &input->script.act[i];
        if (inp_setup_has(&s->setup, heads, act))
            continue;
        inp_script_write(act, text);
        text[strcspn(text, "\n")] = '\0';
        say_why(s, heads, act, input->name, why, sizeof why);
        return crt_fail(err, "--input: nothing notices '%.100s': %s", text, why);
    }
    return true;
}
