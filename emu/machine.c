#include "emu/machine.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "emu/machine_parts.h"

void vm_machine_init(struct vm_machine *m, const struct vm_machine_desc *desc)
{
    memset(m, 0, sizeof *m);
    m->desc = *desc;
    m->entry = m->beside = VM_NO_ENTRY;
    m->ticks = 1;
    m->tick_time = crt_tick_time(desc->tick, 1);
    vm_refreshes_init(&m->refreshes);
    for (int line = 0; line < DF_INT_COUNT; line++)
        m->interrupt[line].change = VM_NEVER;
    struct df_dpu_desc d = {
        .personality = desc->personality,
        .memory = m->memory,
        .memory_bytes = desc->memory_bytes,
        .screen = crt_tube_screen(desc->row),
        .timing = desc->timing,
    };
    vm_wire_dpu(m, &d);
    double low = desc->row->drive_low.value;
    for (int level = 0; level < 8; level++)
        d.drive[level] = low + (1 - low) * level / 7;
    df_dpu_init(&m->dpu, &d);
    df_dpu_reset(&m->dpu, 0);
    if (desc->buffer)
        vm_raster_init(m);
    if (desc->setup)
        vm_devices_init(m);
    if (desc->board)
        vm_bus_connect(m);
}

/* ---- programs -----------------------------------------------------------------------------------
 */

/* Whether a display file fits. */
static bool fits(const struct vm_machine *m, const struct df_program *program, const char *name,
                 struct crt_error *err)
{
    if (program->low >= program->high)
        return crt_fail(err, "%.200s holds no words; a display file needs at least one", name);
    if (program->high > m->desc.memory_bytes)
        return crt_fail(
            err,
            "%.200s has a word at address %o, beyond the display memory of %u bytes; give "
            "--set memory=64K or move the words",
            name, program->high - 2, m->desc.memory_bytes);
    if (program->entry >= m->desc.memory_bytes || program->entry >= DF_ADDRESS_SPACE)
        return crt_fail(
            err,
            "%.200s starts at %o, which the display processor cannot reach: its memory "
            "ends at %o",
            name, program->entry,
            (m->desc.memory_bytes < DF_ADDRESS_SPACE ? m->desc.memory_bytes : DF_ADDRESS_SPACE) -
                2);
    return true;
}

/* The words of `program` at power-on of the display processor. */
static void insert(struct vm_machine *m, const struct df_program *program)
{
    df_dpu_reset(&m->dpu, m->now);
    if (program)
        memcpy(m->memory, program->words, sizeof m->memory);
    else
        memset(m->memory, 0, sizeof m->memory);
    m->loaded = m->now;
    m->strokes_before = m->strokes;
}

bool vm_machine_load(struct vm_machine *m, const struct df_program *program, const char *name,
                     struct crt_error *err)
{
    if (!fits(m, program, name, err))
        return false;
    insert(m, program);
    m->entry = program->entry & ~1u;
    m->has_program = true;
    vm_refreshes_flow(&m->refreshes, vm_flow_of(m->memory, m->desc.memory_bytes, m->entry));
    vm_start(m, (uint16_t)m->entry, m->now);
    return true;
}

bool vm_machine_boot(struct vm_machine *m, const struct vm_elf *elf,
                     const struct df_program *display, const char *name, struct crt_error *err)
{
    assert(m->desc.board);
    if (display && !fits(m, display, name, err))
        return false;
    insert(m, display);
    m->has_program = false;
    m->entry = VM_NO_ENTRY;
    m->beside = display ? display->entry & ~1u : VM_NO_ENTRY;
    vm_refreshes_flow(&m->refreshes, (struct vm_flow){.head = VM_NO_HEAD});
    m->refreshes.declared = false;
    if (m->desc.buffer) {
        memset(m->desc.buffer, 0, VIDEO_BUFFER_BYTES);
        ras_head_reset(&m->raster, m->now);
    }
    if (m->desc.setup)
        inp_unit_reset(&m->devices, m->now);
    vm_board_load(m->desc.board, elf, m->now);
    return true;
}

void vm_machine_play(struct vm_machine *m, struct vm_recording recording)
{
    m->recording = recording;
    m->played = 0;
}

bool vm_machine_uses_vector(const struct vm_machine *m)
{
    return m->entry != VM_NO_ENTRY || m->recording.count > 0;
}

bool vm_machine_uses_raster(const struct vm_machine *m)
{
    /* On, or off again after it had drawn. */
    return m->desc.buffer && (m->raster.on || m->raster.lit_until > m->loaded);
}

bool vm_machine_exited(const struct vm_machine *m, int *status)
{
    if (!m->desc.board || !m->desc.board->finisher.done)
        return false;
    *status = m->desc.board->finisher.status;
    return true;
}

/* ---- copies -------------------------------------------------------------------------------------
 */

/* A board in the same state; NULL: out of memory. */
static struct vm_board *copy_board(struct vm_board *board)
{
    struct crt_error err;
    struct crt_state state;
    struct vm_board *copy = vm_board_create(board->clock, NULL, &err);
    if (!copy)
        return NULL;
    crt_state_save(&state);
    vm_board_state(board, &state);
    bool ok = !state.failed;
    if (ok) {
        struct crt_state load;
        crt_state_load(&load, state.out, state.size);
        vm_board_state(copy, &load);
        ok = !load.failed;
    }
    crt_state_free(&state);
    if (ok)
        return copy;
    vm_board_destroy(copy);
    return NULL;
}

/* The refresh buffer, and the raster head wired to the copy. */
static bool copy_buffer(struct vm_machine *copy, const struct vm_machine *m)
{
    if (!m->desc.buffer)
        return true;
    copy->desc.buffer = malloc(VIDEO_BUFFER_BYTES);
    if (!copy->desc.buffer)
        return false;
    memcpy(copy->desc.buffer, m->desc.buffer, VIDEO_BUFFER_BYTES);
    copy->raster.desc.buffer = copy->desc.buffer;
    vm_raster_wire(copy, &copy->raster.desc.wires);
    return true;
}

bool vm_machine_copy(struct vm_machine *copy, const struct vm_machine *m)
{
    *copy = *m;
    copy->desc.tube = copy->desc.raster_tube = NULL;
    copy->desc.buffer = NULL;
    copy->desc.console = NULL;
    copy->dpu.desc.memory = copy->memory;
    copy->dpu.desc.beam.ctx = copy;
    copy->dpu.desc.wires.ctx = copy;
    if (m->desc.setup)
        vm_devices_wire(copy);
    if (!m->desc.board)
        return true;
    copy->desc.board = copy_board(m->desc.board);
    if (!copy->desc.board || !copy_buffer(copy, m))
        return false;
    vm_bus_connect(copy);
    return true;
}

void vm_machine_forget(struct vm_machine *copy)
{
    if (copy->desc.board)
        vm_board_destroy(copy->desc.board);
    free(copy->desc.buffer);
    copy->desc.board = NULL;
    copy->desc.buffer = NULL;
}
