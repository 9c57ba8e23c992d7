/* fuzz_dpu.c — feeds the display processor a memory image, register writes and a pen.
 *
 * Input:      byte 0   settings: 1 pen, 2 average mode, 4 low screen, 8 little memory, 16 colours
 *             byte 1   how many register writes follow, 0–31
 *             3 bytes each: where in the run (in 16 words) and what, value low byte, value high
 * byte the rest: little-endian display words from address 0 Checks: tests/support/dpu_invariants.h.
 */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "display_file/df_regs.h"
#include "tests/support/dpu_invariants.h"

#define US        UINT64_C(1000000) /* ps */
#define MEMORY    32768u            /* words */
#define MAX_STEPS 4096u

enum { PEN = 1, AVERAGE = 2, LOW_SCREEN = 4, LITTLE_MEMORY = 8, COLOURS = 16 };

struct poke {
    unsigned at;
    unsigned what; /* 0 DPC, 1 DPC odd, 2 MPR, 3 sync, 4 another register, 5 reset */
    uint16_t value;
};

static struct poke poke_of(const uint8_t *b)
{
    return (struct poke){(b[0] >> 3) * 16u, b[0] & 7u, (uint16_t)(b[1] | b[2] << 8)};
}

static void apply(struct dpu_watch *w, const struct poke *p)
{
    struct df_dpu *d = w->dpu;
    uint64_t t = d->t + p->value % 1024u * 1000;

    switch (p->what) {
    case 0:
        df_dpu_write(d, DF_DPC, (uint16_t)(p->value & ~1u), t);
        break;
    case 1:
        df_dpu_write(d, DF_DPC, p->value | 1, t);
        break;
    case 2:
        df_dpu_write(d, DF_MPR, p->value, t);
        break;
    case 3:
        df_dpu_sync(d, t);
        break;
    case 4:
        df_dpu_write(d, p->value | 2u, p->value, t);
        break;
    default:
        df_dpu_reset(d, t);
        w->strokes = 0;
        break;
    }
    dpu_watch_state(w);
}

/* Some way of going on for a processor that stopped, so that the rest of memory is seen, too. */
static void wake(struct dpu_watch *w, unsigned step)
{
    struct df_dpu *d = w->dpu;

    if (d->state == DF_WAITING_SYNC)
        df_dpu_sync(d, d->t + US);
    else
        df_dpu_write(d, DF_DPC, step % 5 ? 1 : 0, d->t);
    dpu_watch_state(w);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static uint16_t memory[MEMORY];
    static struct df_dpu dpu;
    struct dpu_watch watch = {.dpu = &dpu};
    unsigned settings, pokes, next = 0;
    const uint8_t *poke_bytes;
    size_t words;

    if (size < 2)
        return 0;
    settings = data[0];
    pokes = data[1] & 31u;
    if (size < 2 + 3 * (size_t)pokes)
        return 0;
    poke_bytes = data + 2;
    data += 2 + 3 * (size_t)pokes;
    size -= 2 + 3 * (size_t)pokes;
    words = size / 2 < MEMORY ? size / 2 : MEMORY;
    memset(memory, 0, sizeof memory);
    for (size_t i = 0; i < words; i++)
        memory[i] = (uint16_t)(data[2 * i] | data[2 * i + 1] << 8);

    watch.pen = settings & PEN ? 0x9e3779b97f4a7c15u : 0;
    struct df_dpu_desc desc = {
        .personality = settings & COLOURS ? DF_VS60 : DF_VT11,
        .memory = memory,
        .memory_bytes = settings & LITTLE_MEMORY ? 4096 : sizeof memory,
        .screen = {235, 235, 1024, 1024},
        .timing = DPU_WATCH_TIMING,
        .drive = {0.30, 0.40, 0.50, 0.60, 0.70, 0.80, 0.90, 1.00},
        .beam = {&watch, dpu_watch_offer, dpu_watch_commit},
        .wires = {&watch, dpu_watch_interrupt, dpu_watch_bell},
    };
    if (settings & LOW_SCREEN)
        desc.screen = (struct crt_screen){229, 171, 1024, 768};
    if (settings & AVERAGE)
        desc.timing.average_ps = 33330000u >> (settings >> 4); /* down to 1 ns */
    df_dpu_init(&dpu, &desc);
    df_dpu_write(&dpu, DF_DPC, 0, 0);
    unsigned limit = words * 4 + 64 < MAX_STEPS ? (unsigned)words * 4 + 64 : MAX_STEPS;
    for (unsigned step = 0; step < limit; step++) {
        for (; next < pokes && poke_of(poke_bytes + 3 * next).at <= step; next++) {
            struct poke p = poke_of(poke_bytes + 3 * next);
            apply(&watch, &p);
        }
        if (dpu.state == DF_RUNNING)
            dpu_watch_step(&watch);
        else
            wake(&watch, step);
        if (dpu.illegal && next >= pokes)
            break;
    }
    return 0;
}
