/* side.h — two pictures side by side, a black gap between them, centred in height.
 *
 * Units:      pixels.
 * Ownership:  the caller's images; `out` need not be initialised, and is the caller's to free.
 * Errors:     out of memory: one sentence. Both must have the same depth and channels.
 */
#ifndef EMU_SIDE_H
#define EMU_SIDE_H

#include "crt/error.h"
#include "crt/image.h"

#define VM_SIDE_GAP 16

bool vm_side_by_side(const struct crt_image *left, const struct crt_image *right,
                     struct crt_image *out, struct crt_error *err);

#endif
