/* refresh.h — what one refresh of the picture is, and how many there have been.
 *
 *      display file alone     emu/flow.h: by START, sync or the head of its loop
 *      started by firmware    the same, found anew at each START
 *      declared by firmware   from one store to IDENTITY_REFRESH to the next
 *      raster head alone      from one retrace that ends a frame to the next
 *
 * Models:     a refresh ends where the display processor stops, starts to wait for a sync tick or
 *             comes back to the head of a loop; RESUME after a stop begins another. A lone sync word
 *             is not a refresh. A program that draws one picture by several STARTs (display
 *             subroutines) declares refreshes itself.
 * Time:       picoseconds since power-on.
 * Ownership:  plain values. Allocates nothing.
 * Errors:     none.
 */
#ifndef EMU_REFRESH_H
#define EMU_REFRESH_H

#include <stdbool.h>
#include <stdint.h>

#include "emu/flow.h"

struct vm_refresh {
    uint64_t number; /* 1… ; 0 = none yet */
    uint64_t begin, end;
    uint64_t words, instructions, strokes;
    uint64_t lit; /* ps of beam on */
};

/* What has happened since power-on, counted by the machine. */
struct vm_counts {
    uint64_t words, instructions, strokes, lit;
};

struct vm_refreshes {
    struct vm_flow flow;
    bool declared;             /* the program says where they begin */
    bool running;              /* one is being drawn */
    struct vm_refresh current; /* its counts are totals at its begin */
    struct vm_refresh last;    /* the last complete one */
};

void vm_refreshes_init(struct vm_refreshes *r);
/* Another program: what was begun does not count. */
void vm_refreshes_flow(struct vm_refreshes *r, struct vm_flow flow);

/* Neither does anything once the program declares refreshes itself. */
void vm_refreshes_begin(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now);
void vm_refreshes_end(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now);
/* A frame of the raster head is complete, and that is what counts. */
void vm_refreshes_frame(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now);
/* The program declares one. */
void vm_refreshes_declare(struct vm_refreshes *r, uint64_t t, const struct vm_counts *now);

#endif
