#include "emu/rig.h"

#include <stdlib.h>

static void transmit(void *ctx, uint8_t byte, uint64_t t)
{
    vm_console_print(ctx, byte, t);
}

static bool open_tubes(struct vm_rig *rig, const struct vm_input *input,
                       const struct vm_tubes *tubes, struct crt_error *err)
{
    for (int h = 0; h < VM_HEADS; h++) {
        bool is_there = h == VM_VECTOR || input->has_firmware;
        if (is_there && (tubes->heads >> h & 1) &&
            !(rig->tube[h] = crt_tube_create(&tubes->desc[h], err)))
            return false;
    }
    return true;
}

/* The processor's side, for an input with firmware. */
static bool open_board(struct vm_rig *rig, const struct vm_input *input, struct crt_error *err)
{
    static const struct vm_console_desc nobody = {NULL, NULL, NULL};
    static const struct crt_rate clock = {VM_CPU_HZ, 1};
    rig->buffer = calloc(1, VIDEO_BUFFER_BYTES);
    if (!rig->buffer)
        return crt_fail(err, "not enough memory for the refresh buffer; close other programs");
    rig->console = malloc(sizeof *rig->console);
    if (!rig->console)
        return crt_fail(err, "not enough memory for the console; close other programs");
    vm_console_init(rig->console, &nobody);
    rig->board = vm_board_create(clock, &(struct vm_uart_out){rig->console, transmit}, err);
    if (!rig->board)
        return false;
    return !input->typed || vm_console_type(rig->console, input->typed, input->typed_length, 0) ||
           crt_fail(err, "not enough memory for --type");
}

bool vm_rig_open(struct vm_rig *rig, const struct vm_settings *settings,
                 const struct vm_input *input, enum df_timing_choice timing,
                 const struct vm_tubes *tubes, struct crt_error *err)
{
    *rig = (struct vm_rig){.machine = calloc(1, sizeof *rig->machine)};
    rig->person = calloc(1, sizeof *rig->person);
    bool ok = (rig->machine && rig->person) ||
              crt_fail(err, "not enough memory for the machine; close other programs");
    if (ok && !vm_operator_read(rig->person, input->script.act, input->script.count))
        ok = crt_fail(err, "not enough memory for --input");
    if (ok && tubes)
        ok = open_tubes(rig, input, tubes, err);
    if (ok && input->has_firmware)
        ok = open_board(rig, input, err);
    if (ok) {
        struct vm_machine_desc desc = vm_settings_machine(settings, timing);
        desc.tube = rig->tube[VM_VECTOR];
        desc.raster_tube = rig->tube[VM_RASTER];
        desc.buffer = rig->buffer;
        desc.board = rig->board;
        desc.console = rig->console;
        desc.person = rig->person;
        vm_machine_init(rig->machine, &desc);
        ok = vm_input_insert(input, rig->machine, err);
    }
    if (!ok)
        vm_rig_close(rig);
    return ok;
}

void vm_rig_close(struct vm_rig *rig)
{
    for (int h = 0; h < VM_HEADS; h++)
        if (rig->tube[h])
            crt_tube_destroy(rig->tube[h]);
    if (rig->board)
        vm_board_destroy(rig->board);
    if (rig->console)
        vm_console_free(rig->console);
    free(rig->console);
    if (rig->person)
        vm_operator_free(rig->person);
    free(rig->person);
    free(rig->buffer);
    free(rig->machine);
    *rig = (struct vm_rig){0};
}
