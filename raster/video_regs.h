/* video_regs.h — the raster head for a program: registers, formats, look-up table.
 *
 *      refresh buffer ──pixels──▶ look-up table ──▶ red, green, blue ──▶ tube
 *          ▲  BASE, PITCH, FORMAT (taken at vertical retrace)
 *
 * Models:     the raster head's programming interface; usable from C and from assembly: #defines
 *             only. All registers are 32 bits wide; the refresh buffer takes 8, 16 and 32 bits.
 * Use:        at power-on the timing registers hold the mode the machine was started with (--mode, or
 *             the tube's own), BASE 0, PITCH and FORMAT 8 bits a pixel, sync off. Set what differs,
 *             write VIDEO_CONTROL_ON: a first field begins. A new timing is taken when VIDEO_LOAD is
 *             written. Whenever a timing begins, BASE, PITCH and FORMAT are taken at once.
 * Units:      dots and lines; bytes in the refresh buffer; Hz.
 * Source:     ours; the habits are those of the boards of the time: counters that end visible part,
 *             sync pulse and total, registers that wait for retrace.
 * Errors:     what cannot be is refused with a bit of VIDEO_STATUS, and what was goes on.
 * Not modelled: bus contention, hardware cursor, overlays, panning by dots.
 */
#ifndef RASTER_VIDEO_REGS_H
#define RASTER_VIDEO_REGS_H

#define VIDEO_BUFFER_BYTES 0x800000 /* 8 MiB */

#define VIDEO_CONTROL       0x00
#define VIDEO_CONTROL_ON    1 /* sync and scan; 0: the monitor sees no signal */
#define VIDEO_CONTROL_BLANK 2 /* black picture and overscan from the next line on, sync goes on */

#define VIDEO_STATUS            0x04
#define VIDEO_STATUS_VBLANK     0x0001 /* read: not in the picture's lines */
#define VIDEO_STATUS_HBLANK     0x0002 /* read: not in the line's dots */
#define VIDEO_STATUS_VSYNC      0x0004 /* read: in the vertical sync pulse */
#define VIDEO_STATUS_HSYNC      0x0008 /* read: in the horizontal one */
#define VIDEO_STATUS_FIELD      0x0010 /* read: the second field of an interlaced frame */
#define VIDEO_STATUS_WAITING    0x0020 /* read: BASE, PITCH or FORMAT not yet taken */
#define VIDEO_STATUS_RETRACE    0x0100 /* vertical retrace has begun; write 1 to clear */
#define VIDEO_STATUS_COMPARE    0x0200 /* line LINE_COMPARE has begun; write 1 to clear */
#define VIDEO_STATUS_BAD_MODE   0x0400 /* timing impossible: not taken; write 1 to clear */
#define VIDEO_STATUS_OUT_RANGE  0x0800 /* the monitor cannot follow: not taken; write 1 to clear */
#define VIDEO_STATUS_BAD_FORMAT 0x1000 /* no such FORMAT: not taken; write 1 to clear */
#define VIDEO_STATUS_BAD_BASE                                                                      \
    0x2000 /* a line reached beyond the buffer: shown as overscan; write 1 to clear */

#define VIDEO_IRQ_ENABLE 0x08 /* VIDEO_STATUS_RETRACE, VIDEO_STATUS_COMPARE: bits that interrupt */

#define VIDEO_BASE      0x0C /* byte in the buffer of the first pixel, a multiple of 4 */
#define VIDEO_PITCH     0x10 /* bytes from line to line, a multiple of 4 */
#define VIDEO_FORMAT    0x14
#define VIDEO_FORMAT_1  1 /* 1, 2, 4 bits: the first pixel is in the high bits of its byte */
#define VIDEO_FORMAT_2  2
#define VIDEO_FORMAT_4  4
#define VIDEO_FORMAT_8  8  /* up to here through the look-up table */
#define VIDEO_FORMAT_16 16 /* rrrrrggggggbbbbb, little-endian */
#define VIDEO_FORMAT_24 24 /* bytes blue, green, red */
#define VIDEO_FORMAT_32 32 /* 00RRGGBB, little-endian */

#define VIDEO_OVERSCAN                                                                             \
    0x18 /* 00RRGGBB: around the picture, as far as the tube shows; from the next line on */
#define VIDEO_LINE_COMPARE 0x1C /* picture line at whose beginning COMPARE is set; ~0: none */

/* Where the beam is, exact to the dot. Lines count from 0 at the top of the picture to V_TOTAL − 1
 * (interlaced: the rows of the field being scanned, 0, 2, 4 … or 1, 3, 5 …; the line in whose middle
 * the second field begins is V_TOTAL − 1 throughout), dots from 0 at the left to H_TOTAL − 1. All 0,
 * and in blanking, while sync is off. */
#define VIDEO_BEAM_LINE 0x20 /* read */
#define VIDEO_BEAM_DOT  0x24 /* read */
#define VIDEO_FIELDS    0x28 /* read: fields begun since the timing was taken, modulo 2^32 */

/* The screen, for round circles: addressable width and height. */
#define VIDEO_WIDTH_UM  0x2C /* read */
#define VIDEO_HEIGHT_UM 0x30 /* read */

/* Timing. Each count ends a part of the line or frame: visible, then front porch to SYNC_START, then
 * sync to SYNC_END, then back porch to TOTAL. Interlaced: lines are those of the whole frame, V_TOTAL is
 * odd and greater than V_SYNC_END, H_TOTAL is even; in either field rows and sync pulses count in half
 * lines, the pulse one half line late. */
#define VIDEO_CLOCK           0x40 /* dot clock, Hz */
#define VIDEO_H_VISIBLE       0x44
#define VIDEO_H_SYNC_START    0x48
#define VIDEO_H_SYNC_END      0x4C
#define VIDEO_H_TOTAL         0x50
#define VIDEO_V_VISIBLE       0x54
#define VIDEO_V_SYNC_START    0x58
#define VIDEO_V_SYNC_END      0x5C
#define VIDEO_V_TOTAL         0x60
#define VIDEO_SYNC            0x64
#define VIDEO_SYNC_H_PLUS     1
#define VIDEO_SYNC_V_PLUS     2
#define VIDEO_SYNC_INTERLACED 4
#define VIDEO_LOAD                                                                                 \
    0x68 /* write anything: the timing is taken; while sync is on, a first field begins now */

/* Look-up table, at MAP_VIDEO_LUT: 256 words 00RRGGBB; acts from the next line on. At power-on
 * entry n is grey n. */
#define VIDEO_LUT_ENTRIES 256

#endif
