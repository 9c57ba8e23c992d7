/* video.h — the raster head: its mode, its refresh buffer, the look-up table, the beam.
 *
 *      video_open ──▶ canvas (roms/raster/canvas.h) ──pixels──▶ refresh buffer ──▶ tube
 *      video_show ──▶ BASE, taken at retrace           retrace, line compare ──▶ handlers
 *
 * Models:     the registers of raster/video_regs.h: several pages of pixels in the refresh buffer,
 *             one of them shown; waiting for the beam without spinning.
 * Use:        at power-on the mode is the one the machine was started with; a program that does
 *             not care calls video_open(8) and draws.
 * Units:      dots, rows, Hz; colours 0x00RRGGBB.
 * Ownership:  contexts belong to the caller.
 * Errors:     without a raster head (QEMU's "virt" board has none) every call returns at once, a
 *             canvas is 0 wide and 0 high, and handlers are never called.
 * Source:     raster/video_regs.h, emu/memmap.h.
 * Not modelled: pixels of 24 bits.
 */
#ifndef ROMS_BSP_VIDEO_H
#define ROMS_BSP_VIDEO_H

#include <stdbool.h>
#include <stdint.h>

#include "raster/video_regs.h"
#include "roms/raster/canvas.h"

bool video_present(void);

/* ---- timing ----------------------------------------------------------------------------------- */

/* As the timing registers have them: each figure counts from the beginning of the line or frame. */
struct video_timing {
    uint32_t clock_hz;
    uint32_t h_visible, h_sync_start, h_sync_end, h_total;
    uint32_t v_visible, v_sync_start, v_sync_end, v_total;
    uint32_t sync; /* VIDEO_SYNC_… */
};

/* The timing that runs, or would when switched on. All 0 without a head. */
struct video_timing video_timing(void);
/* Takes another; false: it is impossible, or the monitor cannot follow it, and the old one goes on.
 * Call it while the head is off, and video_open afterwards: the size is another. */
bool video_set_timing(const struct video_timing *timing);

/* Lines and fields a second, in thousandths. */
uint32_t video_line_millihertz(const struct video_timing *timing);
uint32_t video_field_millihertz(const struct video_timing *timing);

/* ---- pictures ---------------------------------------------------------------------------------- */

/* Page 0 of the present mode, `bits` a pixel: 1, 2, 4, 8 (by the look-up table), 16, 32. It is shown
 * from the next retrace on, or from video_on on. Empty when that is more than the buffer holds. */
struct canvas video_open(unsigned bits);
/* Sync and picture; a first field begins now. Off: the monitor has no signal and is dark. */
void video_on(void);
void video_off(void);
/* The n-th page: pages of a mode lie one after the other, as many as have room. */
struct canvas video_page(const struct canvas *canvas, unsigned n);
/* Shows it from the next retrace on. */
void video_show(const struct canvas *page);

void video_set_colour(unsigned index, uint32_t rgb);
/* Around the picture, as far as the tube shows. */
void video_set_overscan(uint32_t rgb);

/* The screen that the picture fills, micrometres. */
uint32_t video_width_um(void);
uint32_t video_height_um(void);

/* ---- the beam ---------------------------------------------------------------------------------- */

/* Waits until vertical retrace begins: at least a moment, at most a field. Interrupts are taken
 * meanwhile. Not within irq_lock or a handler. Returns at once while the head is off. */
void video_wait_retrace(void);
/* Retraces since somebody first waited for one or set a handler. */
uint32_t video_retraces(void);

/* Calls handler(ctx) when retrace begins; when the beam begins a row. Interrupts are off
 * meanwhile. NULL: nobody any more. */
void video_on_retrace(void (*handler)(void *ctx), void *ctx);
void video_on_row(void (*handler)(void *ctx), void *ctx);
/* Which row: the handler may ask for the next one. VIDEO_NO_ROW: none. */
void video_compare(uint32_t row);
#define VIDEO_NO_ROW 0xFFFFFFFFu

/* Where the beam is: a row, or beyond the last one in blanking; a dot likewise. 0 without a head. */
uint32_t video_beam_row(void);
uint32_t video_beam_dot(void);

#endif
