/* input_regs.h — what points, presses and types, for a program: pens, tablet, touch panel, keyboard,
 * mouse.
 *
 *      pen ─ tablet ─ panel ─ keys ─ mouse ──▶ registers of each ──▶ INPUT_STATUS ─&─ IRQ_ENABLE ──▶ line 7
 *
 * Models:     the programming interface; usable from C and from assembly: #defines only. All registers
 *             are 32 bits wide. A device that is not connected reads 0 everywhere; INPUT_PRESENT tells.
 * Use:        INPUT_STATUS has a bit a device: something is there that the program has not taken. The
 *             interrupt line is the OR of those that INPUT_IRQ_ENABLE has, and drops when what raised it
 *             has been taken: reports by writing their status bit, keys by reading them.
 * Reports:    what is measured at one instant stays until the program has taken it: writing the …_REPORT
 *             bit to …_STATUS frees the place. What comes meanwhile is lost, and …_LOST is set: also
 *             cleared by writing it. With …_LATEST in the device's control register the newer report
 *             replaces the older one, which does not count as loss.
 * Light pens: on the vector head a pen's hit stops the display processor (display_file/df_regs.h: MPR,
 *             XPR, YPR; interrupt line 2); the registers here tell of its tip switch. On the raster head
 *             the pen latches the beam's line and dot.
 * Units:      as said at each register. "Counts" are the device's own steps; its …_UNIT register says
 *             how many nanometres a count is.
 * Source:     ours; the habits are those of the interfaces of the time (a bit "ready", a bit "lost").
 * Not modelled: several devices of a kind, but for the pens: each head has one.
 */
#ifndef INPUT_INPUT_REGS_H
#define INPUT_INPUT_REGS_H

/* Bits of INPUT_STATUS, INPUT_IRQ_ENABLE, INPUT_PRESENT. */
#define INPUT_BIT_PEN_VECTOR 0x01 /* INPUT_PEN_HIT of a raster pen; a tip switch changed, of both */
#define INPUT_BIT_PEN_RASTER 0x02
#define INPUT_BIT_TABLET     0x04 /* a report */
#define INPUT_BIT_TOUCH      0x08 /* a report */
#define INPUT_BIT_KEYBOARD   0x10 /* a key event */
#define INPUT_BIT_MOUSE      0x20 /* counts or buttons changed */
#define INPUT_BITS           0x3F

#define INPUT_STATUS     0x000 /* read */
#define INPUT_IRQ_ENABLE 0x004
#define INPUT_PRESENT    0x008 /* read */

/* ---- light pens: one block a head, the vector head's first ------------------------------------- */

#define INPUT_PEN_VECTOR 0x100
#define INPUT_PEN_RASTER 0x140

#define PEN_STATUS 0x00 /* offset within the block */
/* The pen fired: LINE, DOT and FIELD are those of the beam at that moment, and stay until this is written.
 * Raster head only; of the vector head the bit says that a pulse reached the display processor. */
#define PEN_HIT       0x01
#define PEN_LOST      0x02 /* it fired again while HIT stood; write to clear */
#define PEN_TIP_MOVED 0x04 /* the tip switch closed or opened; write to clear */
#define PEN_TIP       0x10 /* read: the tip is pressed against the glass */

#define PEN_CONTROL    0x04
#define PEN_ENABLE     0x01 /* raster head: firings set HIT (power-on: 0) */
#define PEN_TIP_ENABLE 0x02 /* raster head: firings count only while the tip is pressed */

#define PEN_LINE  0x08 /* read: as VIDEO_BEAM_LINE was */
#define PEN_DOT   0x0C /* read: as VIDEO_BEAM_DOT was */
#define PEN_FIELD 0x10 /* read: as VIDEO_FIELDS was */
#define PEN_FIRINGS                                                                                \
    0x14 /* read: firings since power-on, modulo 2^32, counted also while not enabled */

/* ---- tablet ------------------------------------------------------------------------------------- */

#define INPUT_TABLET_KIND 0x200 /* read */
#define TABLET_NONE       0
#define TABLET_ELECTRICAL 1
#define TABLET_SONIC      2
#define TABLET_RESISTIVE  3

#define INPUT_TABLET_STATUS 0x204
#define TABLET_REPORT       0x01 /* X, Y, Z, PROXIMITY and BUTTONS hold a report; write to take it */
#define TABLET_LOST         0x02 /* a report came while REPORT stood; write to clear */

#define INPUT_TABLET_CONTROL 0x208
#define TABLET_ON            0x01 /* it measures and reports (power-on: 0) */
#define TABLET_LATEST        0x02 /* a newer report replaces one not taken */

/* Of the report. Counts from the lower left corner; beyond the edges negative, or more than WIDTH. */
#define INPUT_TABLET_X         0x20C /* read, signed */
#define INPUT_TABLET_Y         0x210 /* read, signed */
#define INPUT_TABLET_Z         0x214 /* read: height above the surface where the kind measures it, else 0 */
#define INPUT_TABLET_PROXIMITY 0x218 /* read */
#define TABLET_FAR             0 /* one report when it has gone; X, Y, Z are the last measured */
#define TABLET_NEAR            1
#define TABLET_TOUCH           2
#define INPUT_TABLET_BUTTONS                                                                       \
    0x21C /* read: bit 0 tip or first button of the puck, 1 … 3 the others */
#define INPUT_TABLET_SERIAL 0x220 /* read: number of this report, modulo 2^32: gaps are losses */

#define INPUT_TABLET_UNIT   0x230 /* read: nanometres a count */
#define INPUT_TABLET_WIDTH  0x234 /* read: counts; resistive: along the sheet */
#define INPUT_TABLET_HEIGHT 0x238 /* read: counts */
#define INPUT_TABLET_RATE   0x23C /* read: reports in 1000 s */
/* What the device measures, before it is made into X and Y, of the report:
 *   sonic: 0 … 3: travel times of the sound to the microphones lower left, lower right, upper left, upper
 *     right, ns. The second and third stand above the surface.
 *   resistive: 0, 1: currents at the left and right edge, parts of 65536 of their sum; 2, 3: at the lower
 *     and upper edge, of theirs.
 *   electrical: 0, 1: numbers of the strongest loop of wires across and up; loop n has its middle
 *     (n - 1) times the pitch from the corner. 2, 3: across, its signal and that of the stronger
 *     neighbour; 4, 5: up; parts of 65536 of the signal of a stylus that touches in the middle of a loop. */
#define INPUT_TABLET_RAW 0x240 /* read: 4 words of it (electrical: 6) */
#define TABLET_RAW_WORDS 6

/* ---- touch panel -------------------------------------------------------------------------------- */

#define INPUT_TOUCH_KIND 0x300 /* read */
#define TOUCH_NONE       0
#define TOUCH_OPTICAL    1
#define TOUCH_SONIC      2
#define TOUCH_ELECTRICAL 3

#define INPUT_TOUCH_STATUS 0x304
#define TOUCH_REPORT       0x01 /* a finger came, moved or went; write to take it */
#define TOUCH_LOST         0x02 /* that happened again while REPORT stood; write to clear */
#define TOUCH_TOUCHED      0x10 /* of the report: a finger is there */
#define TOUCH_UNSURE                                                                               \
    0x20 /* of the report: beams apart are broken, or echoes or pressure contradict */

#define INPUT_TOUCH_CONTROL 0x308
#define TOUCH_ON            0x01 /* (power-on: 0) */
#define TOUCH_LATEST        0x02

/* Of the report: positions from the lower left of the panel, in halves: 2·n is on beam n, 2·n + 1 between
 * beams n and n + 1 (sonic, electrical: 2·n). */
#define INPUT_TOUCH_X       0x30C /* read */
#define INPUT_TOUCH_Y       0x310 /* read */
#define INPUT_TOUCH_COLUMNS 0x314 /* read: positions across */
#define INPUT_TOUCH_ROWS    0x318 /* read: positions up */
#define INPUT_TOUCH_HEAD    0x31C /* read: the head it lies over: 0 vector, 1 raster */
/* Where positions lie on that head's screen, micrometres from the addressable area's lower left corner:
 * of position 0, and from one to the next. */
#define INPUT_TOUCH_LEFT    0x320 /* read, signed */
#define INPUT_TOUCH_BOTTOM  0x324 /* read, signed */
#define INPUT_TOUCH_PITCH_X 0x328 /* read */
#define INPUT_TOUCH_PITCH_Y 0x32C /* read */
#define INPUT_TOUCH_SERIAL  0x330 /* read: number of this report */
/* optical: broken beams, bit n = beam n: 2 words across, 2 up; sonic: echo times across and up, ns;
 * electrical: voltages across and up, parts of 65536, and the resistance of the contact, ohms. */
#define INPUT_TOUCH_RAW 0x340 /* read: 4 words */
#define TOUCH_RAW_WORDS 4

/* ---- keyboard ----------------------------------------------------------------------------------- */

#define INPUT_KEY_STATUS 0x400
#define KEY_READY        0x01 /* read: an event can be read */
#define KEY_LOST                                                                                   \
    0x02 /* the keyboard's store was full and events are missing here; write to clear */
#define INPUT_KEY_EVENT   0x404      /* read: takes the oldest event; 0: there is none */
#define KEY_ASCII         0x000000FF /* the character that the press makes, 0: none */
#define KEY_CODE          0x0000FF00 /* KEYCODE_…: which key, by its place; 0: not known */
#define KEY_MODIFIERS     0x000F0000 /* KEYMOD_…, held when it happened */
#define KEY_UP            0x00100000 /* released (ASCII is 0) */
#define KEY_REPEAT        0x00200000 /* held: the keyboard repeats the press */
#define KEY_VALID         0x80000000 /* it is an event */
#define KEYMOD_SHIFT      0x1
#define KEYMOD_CONTROL    0x2
#define KEYMOD_ALT        0x4
#define KEYMOD_CAPS       0x8 /* caps lock is on */
#define INPUT_KEY_CONTROL 0x408
#define KEY_CONSOLE       0x01 /* keys are also sent to the UART, as a terminal does (power-on: 1) */
#define KEY_STORE         0x02  /* events are stored for KEY_EVENT (power-on: 0) */
#define INPUT_KEY_WAITING 0x40C /* read: events stored */
#define INPUT_KEY_MISSED  0x410 /* read: events lost since power-on, modulo 2^32 */
#define KEY_EVENTS_MOST   256   /* stored at most */

/* Places of keys. Printable ones: the unshifted character of a US keyboard, letters upper case. */
#define KEYCODE_ENTER      0x80
#define KEYCODE_TAB        0x81
#define KEYCODE_BACKSPACE  0x82
#define KEYCODE_ESCAPE     0x83
#define KEYCODE_UP         0x84
#define KEYCODE_DOWN       0x85
#define KEYCODE_LEFT       0x86
#define KEYCODE_RIGHT      0x87
#define KEYCODE_HOME       0x88
#define KEYCODE_END        0x89
#define KEYCODE_INSERT     0x8A
#define KEYCODE_DELETE     0x8B
#define KEYCODE_PAGE_UP    0x8C
#define KEYCODE_PAGE_DOWN  0x8D
#define KEYCODE_SHIFT      0x90
#define KEYCODE_CONTROL    0x91
#define KEYCODE_ALT        0x92
#define KEYCODE_CAPS_LOCK  0x93
#define KEYCODE_SUPER      0x94
#define KEYCODE_MENU       0x95
#define KEYCODE_F1         0xA0 /* F1 … F12 in a row */
#define KEYCODE_F12        0xAB
#define KEYCODE_PAD_0      0xB0 /* numeric pad: 0 … 9 in a row */
#define KEYCODE_PAD_9      0xB9
#define KEYCODE_PAD_POINT  0xBA
#define KEYCODE_PAD_DIVIDE 0xBB
#define KEYCODE_PAD_TIMES  0xBC
#define KEYCODE_PAD_MINUS  0xBD
#define KEYCODE_PAD_PLUS   0xBE
#define KEYCODE_PAD_ENTER  0xBF
#define KEYCODE_PAD_EQUAL  0xC0

/* ---- mouse -------------------------------------------------------------------------------------- */

#define INPUT_MOUSE_KIND   0x500 /* read */
#define MOUSE_NONE         0
#define MOUSE_MECHANICAL   1
#define MOUSE_OPTICAL      2
#define INPUT_MOUSE_STATUS 0x504
#define MOUSE_MOVED        0x01 /* a count or a button changed; write to clear */
#define MOUSE_OVERRUN                                                                              \
    0x02 /* it moved faster than the counters follow: counts are missing; write to clear */
/* Counts since power-on, modulo 2^32: a program takes differences. Right and away from the person count
 * up. */
#define INPUT_MOUSE_X       0x508 /* read */
#define INPUT_MOUSE_Y       0x50C /* read */
#define INPUT_MOUSE_BUTTONS 0x510 /* read: bit 0 left, 1 middle, 2 right */
/* The detectors' light, interrupted or not: bit 0, 1: first and second detector of x; 2, 3: of y. */
#define INPUT_MOUSE_PHASES 0x514 /* read */
#define INPUT_MOUSE_UNIT   0x518 /* read: nanometres a count */

#define INPUT_REGISTERS_END 0x520

#endif
