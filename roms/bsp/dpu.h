/* dpu.h — the display processor: its memory, its registers, its interrupts.
 *
 *      program ──words──▶ display memory ──fetch──▶ DPU ──stop, pen, character──▶ handlers
 *         └── dpu_start, dpu_resume ────────────────▶┘
 *
 * Models:     START and RESUME, the registers, and a handler an interrupt line.
 * Time:       a store to display memory is seen by whatever is fetched later.
 * Units:      display addresses are byte addresses, even, from 0; memory is an array of words.
 * Ownership:  contexts belong to the caller.
 * Errors:     on a board without a vector head words go to memory that nobody draws, registers read
 *             0, and nothing ever interrupts.
 * Source:     display_file/df_regs.h.
 */
#ifndef ROMS_BSP_DPU_H
#define ROMS_BSP_DPU_H

#include <stdint.h>

#include "display_file/df_regs.h"

#define DPU_BYTES 0x10000u /* as far as it can reach */

/* Display memory; the word at address a is dpu_memory()[a / 2]. */
volatile uint16_t *dpu_memory(void);

/* Starts at an even address; goes on where it stopped. */
void dpu_start(uint32_t address);
void dpu_resume(void);

/* Registers: past the last word consumed; DF_MPR_… bits; position, after a pen hit that of the hit. */
uint32_t dpu_pc(void);
uint16_t dpu_status(void);
unsigned dpu_x(void);
unsigned dpu_y(void);

/* Calls handler(ctx) at a stop word with its interrupt enabled, at a pen hit with its interrupt
 * enabled, at a character that shifting out has none for. While the handler leaves the display
 * processor stopped, there it stays, until somebody calls dpu_start or dpu_resume. */
void dpu_on_stop(void (*handler)(void *ctx), void *ctx);
void dpu_on_pen(void (*handler)(void *ctx), void *ctx);
void dpu_on_character(void (*handler)(void *ctx), void *ctx);

#endif
