/* heads.h — the machine's two heads, and which of them somebody looks at.
 *
 *      --view vector|raster|both        auto: those the program uses
 *
 * Models:     nothing.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef EMU_HEADS_H
#define EMU_HEADS_H

enum vm_head { VM_VECTOR, VM_RASTER, VM_HEADS };

/* Bits of heads; VM_VIEW_AUTO waits for what the program does. */
enum vm_view {
    VM_VIEW_AUTO = 0,
    VM_VIEW_VECTOR = 1 << VM_VECTOR,
    VM_VIEW_RASTER = 1 << VM_RASTER,
    VM_VIEW_BOTH = VM_VIEW_VECTOR | VM_VIEW_RASTER
};

#define VM_VIEW_NAMES "auto|vector|raster|both"

/* Of one of the names; NULL is auto. */
enum vm_view vm_view_of_name(const char *name);
const char *vm_view_name(enum vm_view view);

#endif
