/* why_entries.h — deposits put together by what drew them, in an order to be read.
 *
 *      deposits ─▶ one entry each, or one for all of a source ─▶ sorted ─▶ small ones summed up
 *
 * Sources:    on the vector head a line of the display file's source, where nobody has stored over it, else
 *             a display word and the instruction that stored it; on the raster head a scan line and the
 *             instruction that stored its pixel.
 * Ownership:  vm_why_entries_make allocates, vm_why_entries_free releases; deposits stay the answer's.
 * Errors:     false: out of memory, and there are none.
 */
#ifndef EMU_LAB_WHY_ENTRIES_H
#define EMU_LAB_WHY_ENTRIES_H

#include "emu/lab/why_text.h"

struct vm_why_entry {
    const struct vm_why_deposit *last; /* its latest deposit */
    size_t deposits, pieces;           /* all of them; those that have not faded */
    double share;                      /* cd/m², of all of them */
    double fluence;                    /* cd·s/m², of those that have not faded */
};

struct vm_why_entries {
    struct vm_why_entry *at;
    size_t count;
    /* Left out: less than the least share, or no room. */
    size_t hidden;
    double hidden_share; /* cd/m² */
};

bool vm_why_entries_make(struct vm_why_entries *entries, const struct vm_why *why,
                         const struct vm_why_text *text, bool all);
void vm_why_entries_free(struct vm_why_entries *entries);

#endif
