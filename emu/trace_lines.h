/* trace_lines.h — the machine's events as text, one line each.
 *
 *      dpu <t> DPC=oooooo WORD=oooooo MPR=oooooo XPR=oooooo YPR=oooooo       word executed; with the
 *          VS60's colours also COLOUR=green
 *      cpu <t> PC=hhhhhhhh WORD=hhhhhhhh addi a0,a0,1 a0=hhhhhhhh             instruction and its effect
 *      irq <t> stop high                                                     line of a device
 *      irq <t> processor takes machine external interrupt at PC=hhhhhhhh
 *      video <t> hsync high                                                  sync pulse, on or off
 *      video <t> row 17 begins                                               of the picture
 *      video <t> retrace base=hhhhhhhh pitch=1024 format=8                   what is taken then
 *
 *      input at 0.5s pen vector move 512 300                                 what a person does
 *      input <t> tablet report 17: 1000 800 0 near buttons=0                 what a device has found
 *      input <t> touch report 3: 40 22 touched
 *      input <t> pen raster fires, beam at line 17 dot 320 field 9
 *      input <t> mouse 12 -3 buttons=0
 *
 * Time:       picoseconds since power-on: when the word was fetched, the instruction begun.
 * Effects:    the register written; of a store [address]=value, of a jump nothing, of a trap its cause.
 * Ownership:  the caller's struct and stream.
 * Errors:     none; the stream's are its owner's.
 */
#ifndef EMU_TRACE_LINES_H
#define EMU_TRACE_LINES_H

#include <stdio.h>

#include "emu/machine.h"

enum vm_trace_what {
    VM_TRACE_DPU,
    VM_TRACE_BEAM,
    VM_TRACE_CPU,
    VM_TRACE_IRQ,
    VM_TRACE_VIDEO,
    VM_TRACE_INPUT
};

/* What of the input devices has been printed. */
struct vm_input_seen {
    uint32_t tablet, touch, firings[INP_SCREENS];
    uint32_t x, y, buttons; /* of the mouse */
};

struct vm_trace_lines {
    FILE *out;
    const struct vm_board *board; /* NULL: no processor */
    struct rv_access access;      /* of the instruction being executed */
    bool accesses;
    struct rv_hooks processor;
    const struct ras_head *head;
    struct ras_hooks raster;
    struct vm_input_seen seen; /* of the input devices, so far */
    struct vm_hooks hooks;     /* for vm_machine_trace */
};

/* For a trace from machine->now on: what devices reported before is not printed. `lines` must stay where it
 * is while its hooks are in use. */
void vm_trace_lines_init(struct vm_trace_lines *lines, enum vm_trace_what what, FILE *out,
                         const struct vm_machine *machine);

#endif
