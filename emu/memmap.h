/* memmap.h — where everything is for a program on the processor: addresses, registers and lines.
 *
 *      0010_0000  test finisher            4003_0000  input registers (input/input_regs.h)
 *      0200_0000  CLINT                    4004_0000  interrupt controller
 *      1000_0000  16550 UART               4005_0000  identity
 *      4000_0000  DPU (df_regs.h)          4100_0000  display memory, 256 KiB
 *      4001_0000  video registers          4200_0000  refresh buffer, 8 MiB
 *      4002_0000  video look-up table      8000_0000  program memory, 16 MiB; entry
 *
 * Models:     the memory map; usable from C and from assembly: #defines only.
 * Units:      byte addresses. Device registers take accesses of their own width only: the DPU's
 *             and display memory's are 16 bits (display memory takes 8 and 32 too), the UART's 8,
 *             all others 32; the refresh buffer 8, 16 and 32. Anything else is an
 *             access fault.
 * Source:     finisher, CLINT, UART and program memory lie where QEMU's riscv32 "virt" board has
 *             them (hw/riscv/virt.c), so that console programs run on both.
 * Not modelled: bus contention, wait states.
 */
#ifndef EMU_MEMMAP_H
#define EMU_MEMMAP_H

/* Test finisher (SiFive's, as in QEMU): a store ends the program with an exit status. */
#define MAP_FINISHER      0x00100000
#define MAP_FINISHER_SIZE 0x1000
#define FINISHER_PASS     0x5555 /* exit status 0 */
#define FINISHER_FAIL     0x3333 /* | code << 16: the code's low 8 bits, or 255 where those are 0 */

/* Core-local interruptor: software interrupt and timer. */
#define MAP_CLINT      0x02000000
#define MAP_CLINT_SIZE 0x10000
#define CLINT_MSIP     0x0000 /* bit 0: software interrupt */
#define CLINT_MTIMECMP 0x4000 /* low word; high word at + 4. Timer interrupt: mtime >= mtimecmp */
#define CLINT_MTIME    0xBFF8 /* low word; high word at + 4 */
#define CLINT_HZ       10000000

/* Console: 16550A registers, a byte each. */
#define MAP_UART      0x10000000
#define MAP_UART_SIZE 0x100

/* Display processor: df_regs.h offsets, 16 bits each. */
#define MAP_DPU      0x40000000
#define MAP_DPU_SIZE 0x1000

/* Raster head: registers, look-up table and refresh buffer (raster/video_regs.h). */
#define MAP_VIDEO             0x40010000
#define MAP_VIDEO_SIZE        0x1000
#define MAP_VIDEO_LUT         0x40020000
#define MAP_VIDEO_LUT_SIZE    0x400
#define MAP_VIDEO_BUFFER      0x42000000
#define MAP_VIDEO_BUFFER_SIZE 0x00800000

/* Pens, tablet, touch panel, keyboard, mouse (input/input_regs.h). */
#define MAP_INPUT      0x40030000
#define MAP_INPUT_SIZE 0x1000

/* Interrupt controller: lines to the external interrupt of the processor. Level-triggered. */
#define MAP_IRQ          0x40040000
#define MAP_IRQ_SIZE     0x1000
#define IRQ_PENDING      0x00 /* read: bit n = line n is high, enabled or not */
#define IRQ_ENABLE       0x04 /* bit n = line n may interrupt */
#define IRQ_CLAIM        0x08 /* read: the lowest line that is high and enabled, 0 = none */
#define IRQ_LINE_STOP    1
#define IRQ_LINE_PEN     2
#define IRQ_LINE_CHAR    3
#define IRQ_LINE_NAME    4
#define IRQ_LINE_RETRACE 5
#define IRQ_LINE_COMPARE 6
#define IRQ_LINE_INPUT   7
#define IRQ_LINE_UART    8
#define IRQ_LINES        9 /* 0 is no line */

/* Identity, and what a program tells the machine's observers. */
#define MAP_IDENTITY      0x40050000
#define MAP_IDENTITY_SIZE 0x1000
#define IDENTITY_MAGIC    0x00 /* read: IDENTITY_KNSC; anything else: no heads here */
#define IDENTITY_KNSC     0x4B4E5343
#define IDENTITY_VERSION  0x04 /* read: of this memory map */
#define IDENTITY_HEADS    0x08 /* read: bit 0 vector head, bit 1 raster head */
#define IDENTITY_ENTRY    0x0C /* read: entry of a display file loaded beside; ~0 = none */
#define IDENTITY_CLOCK    0x10 /* read: nominal clock of the processor, Hz */
#define IDENTITY_TICK     0x14 /* read: sync ticks since power-on, modulo 2^32 */
#define IDENTITY_MARK     0x18 /* write: number of a mark that an observer may wait for */
#define IDENTITY_REFRESH                                                                           \
    0x1C /* write: a refresh begins here. From the first such store on, only \
                                  these bound refreshes, not START and stop */

/* Display memory: the DPU's address 0 is here. */
#define MAP_DISPLAY      0x41000000
#define MAP_DISPLAY_SIZE 0x40000

/* Program memory: the only place code can run from. */
#define MAP_PROGRAM      0x80000000
#define MAP_PROGRAM_SIZE 0x01000000

#endif
