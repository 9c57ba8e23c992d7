/* list_shape.h — display lists of equal items: how long a refresh of one takes, and one as source.
 *
 *      [sync] point at · longv  draw draw draw …  jump      vectors, short vectors
 *      [sync] point at  plot plot plot …          jump      points
 *      [sync] point at · char   text … point at · char …    characters, in lines
 *
 * Models:     the display processor's arithmetic (display_file/dpu.h): words are fetched one after the
 *             other, the generators work between fetches. Vectors and points lie on a zigzag, in
 *             columns, in which each moves the beam equally far and none crosses another.
 * Time:       picoseconds.
 * Units:      head units.
 * Ownership:  plain values; the stream stays the caller's.
 * Errors:     none; the caller looks at ferror() of its stream.
 * Not modelled: what display_file/timing.h does not.
 */
#ifndef EMU_LAB_LIST_SHAPE_H
#define EMU_LAB_LIST_SHAPE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "crt/tube_table.h"
#include "display_file/timing.h"

enum vm_list_kind {
    VM_LIST_VECTORS,
    VM_LIST_SHORT,
    VM_LIST_POINTS,
    VM_LIST_CHARACTERS,
    VM_LIST_KINDS
};

struct vm_list_shape {
    enum vm_list_kind kind;
    int units; /* length of a vector, distance of points; 1 … the kind's most */
    bool sync; /* waits for the tick */
    int units_x, units_y;
};

/* For a tube; units are brought into what the kind and the screen allow. */
struct vm_list_shape vm_list_shape(const struct crt_tube_row *row, enum vm_list_kind kind,
                                   int units, bool sync);

/* What one item more takes: of characters half a word's fetch and a cell. */
double vm_list_item_ps(const struct vm_list_shape *s, const struct df_timing *t);
/* A refresh of n items. */
uint64_t vm_list_ps(const struct vm_list_shape *s, const struct df_timing *t, long n);
long vm_list_words(const struct vm_list_shape *s, long n);
/* As many as fit into `bytes` of memory, and of these whose refresh takes no longer than `ps`. */
long vm_list_most(const struct vm_list_shape *s, uint32_t bytes);
long vm_list_longest(const struct vm_list_shape *s, const struct df_timing *t, uint64_t ps,
                     uint32_t bytes);

/* Source of n items (display_file/LANGUAGE.md) for a tube, TUBE/PHOSPHOR or NULL. */
void vm_list_write(FILE *to, const struct vm_list_shape *s, long n, const char *tube);

/* "vectors of 100 units", "points 100 units apart", "characters"; "vectors". */
void vm_list_describe(const struct vm_list_shape *s, char *text, size_t size);
const char *vm_list_name(enum vm_list_kind kind);
#define VM_LIST_NAMES "vectors|short|points|characters"

#endif
