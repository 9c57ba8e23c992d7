#include "emu/rig.h"

#include <stdlib.h>

static void transmit(void *ctx, uint8_t byte, uint64_t t)
{
    vm_console_print(ctx, byte, t);
}

/* The processor's side, for an input with firmware. */
static bool open_board(struct vm_rig *rig, const struct vm_input *input, struct crt_error *err)
{
    static const struct vm_console_desc nobody = {NULL, NULL, NULL};
    static const struct crt_rate clock = {VM_CPU_HZ, 1};
    rig->console = malloc(sizeof *rig->console);
    if (!rig->console)
        return crt_fail(err, "not enough memory for the console; close other programs");
    vm_console_init(rig->console, &nobody);
    rig->board = vm_board_create(clock, &(struct vm_uart_out){rig->console, transmit}, err);
    if (!rig->board)
        return false;
    if (!input->typed)
        return true;
    vm_console_close(rig->console);
    return vm_console_type(rig->console, input->typed, input->typed_length, 0) ||
           crt_fail(err, "not enough memory for --type");
}

bool vm_rig_open(struct vm_rig *rig, const struct vm_settings *settings,
                 const struct vm_input *input, enum df_timing_choice timing,
                 const struct crt_tube_desc *tube, struct crt_error *err)
{
    *rig = (struct vm_rig){.machine = calloc(1, sizeof *rig->machine)};
    bool ok =
        rig->machine || crt_fail(err, "not enough memory for the machine; close other programs");
    if (ok && tube)
        ok = (rig->tube = crt_tube_create(tube, err)) != NULL;
    if (ok && input->has_firmware)
        ok = open_board(rig, input, err);
    if (ok) {
        struct vm_machine_desc desc = vm_settings_machine(settings, timing, rig->tube);
        desc.board = rig->board;
        desc.console = rig->console;
        vm_machine_init(rig->machine, &desc);
        ok = vm_input_insert(input, rig->machine, err);
    }
    if (!ok)
        vm_rig_close(rig);
    return ok;
}

void vm_rig_close(struct vm_rig *rig)
{
    if (rig->tube)
        crt_tube_destroy(rig->tube);
    if (rig->board)
        vm_board_destroy(rig->board);
    if (rig->console)
        vm_console_free(rig->console);
    free(rig->console);
    free(rig->machine);
    *rig = (struct vm_rig){0};
}
