/* side.h — pictures put together: side by side, one above the other, a black gap between them.
 *
 * Units:      pixels.
 * Ownership:  the caller's images; `out` need not be initialised, and is the caller's to free.
 * Errors:     out of memory: one sentence. All must have three channels; samples of 8 bits become those of 16
 *             where the whole has them, the other way does not happen.
 */
#ifndef EMU_SIDE_H
#define EMU_SIDE_H

#include "crt/error.h"
#include "crt/image.h"

#define VM_SIDE_GAP 16

/* Copies `part` into `whole`, where it fits. */
void vm_image_place(const struct crt_image *part, int x, int y, struct crt_image *whole);

/* Both of one depth; centred in height. */
bool vm_side_by_side(const struct crt_image *left, const struct crt_image *right,
                     struct crt_image *out, struct crt_error *err);
bool vm_side_by_side_apart(const struct crt_image *left, const struct crt_image *right, int gap,
                           struct crt_image *out, struct crt_error *err);

/* Of the greater depth; centred in width. */
bool vm_above(const struct crt_image *upper, const struct crt_image *lower, struct crt_image *out,
              struct crt_error *err);

#endif
