/* json_out.h — text as JSON.
 *
 * Models:     RFC 8259, section 7: quotation marks, backslashes and control characters are escaped, all else is
 *             printed as it is.
 * Ownership:  nothing.
 * Errors:     those of the stream.
 */
#ifndef EMU_JSON_OUT_H
#define EMU_JSON_OUT_H

#include <stdio.h>

/* With its quotation marks. */
void vm_json_text(FILE *out, const char *text);

#endif
