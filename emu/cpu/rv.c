/* rv.c — the processor as a whole: its beginning, end and reset. */
#include <assert.h>
#include <stdlib.h>

#include "emu/cpu/rv_decode.h"
#include "emu/cpu/rv_parts.h"

bool rv_init(struct rv_cpu *cpu, const struct rv_desc *desc)
{
    assert(desc->memory_base % RV_PAGE == 0 && desc->memory_size % RV_PAGE == 0);
    assert(desc->memory_size != 0 && desc->memory_size - 1 <= UINT32_MAX - desc->memory_base);
    *cpu = (struct rv_cpu){.desc = *desc};
    uint32_t words = desc->memory_size / 4;
    cpu->entries = calloc((size_t)rv_index_of_word(words) + 1, sizeof *cpu->entries);
    cpu->decoded = calloc(desc->memory_size / RV_PAGE, 1);
    if (cpu->entries == NULL || cpu->decoded == NULL) {
        rv_free(cpu);
        return false;
    }
    rv_writable(cpu);
    rv_reset(cpu);
    return true;
}

void rv_free(struct rv_cpu *cpu)
{
    free(cpu->entries);
    free(cpu->decoded);
    cpu->entries = NULL;
    cpu->decoded = NULL;
}

void rv_reset(struct rv_cpu *cpu)
{
    memset(cpu->x, 0, sizeof cpu->x);
    memset(cpu->f, 0, sizeof cpu->f);
    cpu->pc = cpu->desc.memory_base;
    cpu->fflags = cpu->frm = 0;
    cpu->mstatus = cpu->mie = cpu->mtvec = cpu->mscratch = 0;
    cpu->mepc = cpu->mcause = cpu->mtval = cpu->mcountinhibit = 0;
    cpu->cycle_offset = cpu->retire_offset = 0;
    cpu->cycle_held = cpu->retire_held = 0;
    cpu->state = RV_RUNNING;
    cpu->trouble = (struct rv_trouble){0};
    cpu->attention = false;
}
