/* plain.h — a text in the letters that the window has: ASCII.
 *
 * Models:     nothing. What has a usual spelling in ASCII gets it (µ: u, ×: x, ≥: >=); other characters are '?'.
 * Ownership:  the caller's.
 * Errors:     a text that is too long is cut.
 */
#ifndef EMU_PLAIN_H
#define EMU_PLAIN_H

#include <stddef.h>

/* `text` is UTF-8. */
void vm_plain(const char *text, char *out, size_t size);

#endif
