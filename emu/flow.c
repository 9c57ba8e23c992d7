#include "emu/flow.h"

#include <string.h>

#include "display_file/df_regs.h"
#include "display_file/program.h"

#define WORDS (DF_ADDRESS_SPACE / 2)

/* The walk over the words in the order in which they are executed. */
struct walk {
    const uint16_t *memory;
    uint32_t bytes, address;
    uint16_t syncs;               /* sync words met so far */
    bool data_first;              /* a data word came before any sync word */
    uint8_t visited[WORDS];       /* 1: executed */
    uint16_t syncs_before[WORDS]; /* sync words met before this one */
};

enum step { STEP_ON, STEP_STOP, STEP_LOOP, STEP_OUT };

/* The program counter has 16 bits: it wraps. */
static uint32_t following(uint32_t address)
{
    return (address + 2) % DF_ADDRESS_SPACE;
}

static enum step step(struct walk *w)
{
    if (w->address + 2 > w->bytes)
        return STEP_OUT;
    uint32_t index = w->address / 2;
    if (w->visited[index])
        return STEP_LOOP;
    w->visited[index] = 1;
    w->syncs_before[index] = w->syncs;
    uint16_t word = w->memory[index];
    w->address = following(w->address);
    if (!(word & DF_CONTROL)) {
        w->data_first |= w->syncs == 0;
    } else if ((word & 0174000) == DF_JUMP) {
        if (w->address + 2 > w->bytes)
            return STEP_OUT;
        w->address = w->memory[w->address / 2] & 0177776u;
    } else if ((word & 0174000) == DF_STATUS_A) {
        if (word & DF_LSA_STOP)
            return STEP_STOP;
        w->syncs = (uint16_t)(w->syncs + ((word & DF_LSA_SYNC) != 0));
    }
    return STEP_ON;
}

struct vm_flow vm_flow_of(const uint16_t *memory, uint32_t memory_bytes, uint32_t entry)
{
    static const struct vm_flow none = {.head = VM_NO_HEAD};
    struct vm_flow flow = none;
    struct walk w;
    memset(&w, 0, sizeof w);
    w.memory = memory;
    w.bytes = memory_bytes;
    w.address = entry;
    enum step s;
    while ((s = step(&w)) == STEP_ON)
        ;
    uint16_t repeated = w.syncs;
    if (s == STEP_LOOP)
        repeated = (uint16_t)(w.syncs - w.syncs_before[w.address / 2]);
    flow.stops = s == STEP_STOP;
    flow.loops = s == STEP_LOOP;
    flow.synchronised = repeated > 0;
    flow.start_begins = flow.stops
                            ? w.data_first || w.syncs == 0
                            : flow.loops && repeated > 0 && w.data_first && w.address == entry;
    if (flow.loops && !flow.synchronised)
        flow.head = w.address;
    return flow;
}
