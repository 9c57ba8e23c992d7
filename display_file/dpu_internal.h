/* dpu_internal.h — what the files of the display processor share; not for others.
 *
 *      dpu.c          registers, fetch, state, interrupts, time
 *      dpu_control.c  one function per control word     dpu_data.c  one per graphic mode
 *      vecgen.c       vectors and moves                 chargen.c   characters
 *      beam.c         lights pieces: pen, cut, intensify spot
 */
#ifndef DF_DPU_INTERNAL_H
#define DF_DPU_INTERNAL_H

#include "crt/ticks.h"
#include "display_file/dpu.h"

enum df_phase {
    DF_PHASE_FIRST,   /* the next data word starts a datum */
    DF_PHASE_SECOND,  /* the next data word completes one */
    DF_PHASE_ADDRESS, /* the next word, whatever it is, is a jump address */
};

typedef void df_word_handler(struct df_dpu *dpu, uint16_t word);

extern df_word_handler *const df_control_words[16]; /* by bits 14:11 */
extern df_word_handler *const df_data_words[7];     /* by graphic mode */

void df_dpu_raise(struct df_dpu *dpu, enum df_interrupt line, uint64_t t);

/* Stops until RESUME when a pen hit with its interrupt enabled happened since the action began. */
void df_dpu_stop_for_pen(struct df_dpu *dpu, uint64_t t);

/* floor(whole·part/of) by a 128-bit product. */
uint64_t df_ratio(uint64_t whole, uint64_t part, uint64_t of);

/* The generator is busy for `lead` ps dark, then for `lit` ps: gives the lit interval and moves the
 * clock past it. In average mode both are scaled to fill the window. */
void df_dpu_schedule(struct df_dpu *dpu, uint64_t lead, uint64_t lit, uint64_t *t0, uint64_t *t1);

/* 12-bit two's complement: 2047 + 1 = −2048. */
static inline int32_t df_wrap12(int32_t v)
{
    return ((v + 2048) & 4095) - 2048;
}

static inline bool df_on_screen(const struct df_dpu *dpu, int32_t x, int32_t y)
{
    return x >= 0 && x <= dpu->max_x && y >= 0 && y <= dpu->max_y;
}

/* Blinking items are dark in every second 266 ms; assumed: lit first, and decided when an item
 * begins. */
#define DF_BLINK_HALF_PS (266 * CRT_PS_PER_MS)

static inline bool df_blinked_out(const struct df_dpu *dpu, uint64_t t)
{
    return dpu->blink && (t / DF_BLINK_HALF_PS & 1);
}

#endif
