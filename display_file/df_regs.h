/* df_regs.h — the display processor as a program sees it: registers, bits, words and modes.
 *
 * Models:     the VT11's programming interface, and of the VS60's what sets the colour; usable from
 *             C and from assembly: #defines only.
 * Units:      register values are 16-bit; offsets are bytes from the DPU base.
 * Source:     DEC EK-VT11-TM-001 (VT11 display processor), EK-VT48-TM-001 (VS60).
 * Not modelled: the other registers and words that only the VS60 has.
 */
#ifndef DF_REGS_H
#define DF_REGS_H

/* Registers. */
#define DF_DPC 0 /* read: display program counter; write even: START there, odd: RESUME */
#define DF_MPR 2 /* read: mode and status; write: rings the bell */
#define DF_XPR 4 /* read: graphplot step and X */
#define DF_YPR 6 /* read: character low six bits and Y */

#define DF_SCR 022 /* VS60, read: the colour; of its other bits none is modelled, they read 0 */

/* MPR bits. */
#define DF_MPR_STOP      0100000 /* internal stop */
#define DF_MPR_MODE      0074000
#define DF_MPR_INTENSITY 0003400
#define DF_MPR_HIT       0000200 /* light pen hit */
#define DF_MPR_SO        0000100 /* shift out */
#define DF_MPR_EDGE      0000040 /* edge indicator */
#define DF_MPR_ITALICS   0000020
#define DF_MPR_BLINK     0000010
#define DF_MPR_LINE      0000003 /* line type */

#define DF_XPR_STEP 0176000
#define DF_XPR_X    0001777
#define DF_YPR_CHAR 0176000
#define DF_YPR_Y    0001777

#define DF_SCR_COLOUR       0000014
#define DF_SCR_COLOUR_SHIFT 2

/* Control words. */
#define DF_CONTROL  0100000 /* bit 15: control, else data */
#define DF_SET_MODE 0100000 /* + mode << 11 */
#define DF_JUMP     0160000 /* address follows; VT11: all of 160000–163777 */
#define DF_NOP      0164000 /* VT11: all of 164000–167777 */
#define DF_STATUS_A 0170000
#define DF_STATUS_B 0174000
#define DF_STOP     0172000

/* Graphic modes: bits 14:11 of Set Graphic Mode. */
#define DF_MODE_SHIFT    11
#define DF_MODE_CHAR     0
#define DF_MODE_SHORT    1
#define DF_MODE_LONG     2
#define DF_MODE_POINT    3
#define DF_MODE_GRAPHX   4
#define DF_MODE_GRAPHY   5
#define DF_MODE_RELPOINT 6

/* Parameters of Set Graphic Mode. */
#define DF_SGM_INTENSITY       0002000 /* change intensity to bits 1600 */
#define DF_SGM_INTENSITY_SHIFT 7
#define DF_SGM_PEN             0000100 /* change light-pen interrupt */
#define DF_SGM_PEN_ON          0000040
#define DF_SGM_BLINK           0000020
#define DF_SGM_BLINK_ON        0000010
#define DF_SGM_LINE            0000004 /* change line type to bits 3 */
#define DF_LINE_SOLID          0
#define DF_LINE_LONG           1
#define DF_LINE_SHORT          2
#define DF_LINE_DOTDASH        3

/* Parameters of Load Status A. */
#define DF_LSA_STOP          0002000
#define DF_LSA_STOP_INT      0001000 /* change stop interrupt */
#define DF_LSA_STOP_INT_ON   0000400
#define DF_LSA_INTENSIFY     0000200 /* change light-pen intensify */
#define DF_LSA_INTENSIFY_OFF 0000100
#define DF_LSA_ITALICS       0000040
#define DF_LSA_ITALICS_ON    0000020
#define DF_LSA_SYNC          0000004 /* wait for the line sync tick; no change-enable */

/* Parameters of Load Status B. */
#define DF_LSB_STEP         0000100 /* change graphplot step to bits 77 */
#define DF_LSB_VALUE        0000077
#define DF_LSB_COLOUR       0001000 /* VS60: change colour to bits 600; the VT11 ignores both */
#define DF_LSB_COLOUR_BITS  0000600
#define DF_LSB_COLOUR_SHIFT 7
#define DF_COLOUR_GREEN     0
#define DF_COLOUR_YELLOW    1
#define DF_COLOUR_ORANGE    2
#define DF_COLOUR_RED       3

/* Data words. */
#define DF_BEAM_ON        0040000 /* I */
#define DF_SIGN_X         0020000 /* S */
#define DF_SHORT_DX       0017600
#define DF_SHORT_DX_SHIFT 7
#define DF_SHORT_SIGN_Y   0000100
#define DF_SHORT_DY       0000077
#define DF_LONG_DELTA     0001777

#endif
