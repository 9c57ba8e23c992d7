/* handler.h — display subroutines and more for a display processor that has none: the convention of
 * RT-11's graphics support.
 *
 *      DPU ──stop interrupt──▶ the stop word's unused bits say what is wanted ──▶ start elsewhere
 *
 *      173400, return, sub   DJSR    goes to sub; a DRET there goes back to return
 *      173400, 0             DRET    back; of the outermost: the end of a refresh
 *      173420                DSTAT   writes the status buffer, goes on
 *      173500                DHALT   the display stays dark
 *      173520, n             DNAME   what follows is called n (1…77777 octal)
 *
 * Models:     a stack of ten returns; names; seven words of status at a DSTAT, and at a pen hit when
 *             the buffer's flag is 0. The handler's own words in display memory wait for the sync
 *             tick and call the display file, unless its first word waits for the tick itself.
 * Units:      display addresses, bytes; words of 16 bits.
 * Ownership:  the caller's struct, alive as long as interrupts come.
 * Errors:     too deep a stack, a stop word that is none of these, a file that leaves no room for the
 *             handler's words: `trouble` says so, and the display stays stopped.
 * Source:     DEC, RT-11 Advanced Programmer's Guide (display handler), as to what the words mean;
 *             which call a DRET without DJSR belongs to is assumed: that of the handler's words.
 * Not modelled: the monitor's calls (.INSRT, .TRACK, …); light-pen tracking.
 */
#ifndef ROMS_RT11_HANDLER_H
#define ROMS_RT11_HANDLER_H

#include <stdbool.h>
#include <stdint.h>

#define RT11_DEPTH 10

/* A buffer of status: seven words, in this order. */
struct rt11_status {
    uint16_t flag; /* 0: may be written; 1: holds news until the reader sets it to 0 */
    uint16_t name; /* of the last DNAME */
    uint16_t tag;  /* the subroutine it happened in; 0: in none */
    uint16_t pc;   /* the registers: past the word, … */
    uint16_t status, x, y;
};

enum rt11_trouble { RT11_FINE, RT11_TOO_DEEP, RT11_UNKNOWN_STOP, RT11_NO_ROOM };

struct rt11 {
    uint32_t entry;
    uint32_t calls[RT11_DEPTH][2]; /* where each goes back to; which subroutine it is */
    unsigned depth;
    uint16_t name;
    volatile bool halted; /* by a DHALT, or by trouble */
    struct rt11_status pen, stat;
    volatile uint32_t refreshes; /* begun */
    volatile enum rt11_trouble trouble;
    uint32_t where; /* of the trouble: address of the stop word, or of what is in the way */
};

/* Serves the display file that starts at `entry` from now on. */
void rt11_start(struct rt11 *handler, uint32_t entry);

/* One sentence, without its end. */
const char *rt11_trouble_text(enum rt11_trouble trouble);

#endif
