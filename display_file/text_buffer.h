/* text_buffer.h — text that grows, for listings, reports and disassembly.
 *
 * Models:     bytes appended to one terminated string.
 * Units:      bytes; columns are bytes, too.
 * Ownership:  df_text_take hands the malloced text to the caller; df_text_free drops it.
 * Errors:     when memory runs out `failed` is set, later additions do nothing and df_text_take
 *             returns NULL.
 */
#ifndef DF_TEXT_BUFFER_H
#define DF_TEXT_BUFFER_H

#include <stdbool.h>
#include <stddef.h>

struct df_text {
    char *bytes; /* terminated once anything was added */
    size_t length, capacity;
    bool failed;
};

void df_text_bytes(struct df_text *text, const char *bytes, size_t length);
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void df_text_add(struct df_text *text, const char *format, ...);
/* Spaces up to this column of the last line (0 = its start); at least one when already past it. */
void df_text_column(struct df_text *text, size_t column);
char *df_text_take(struct df_text *text);
void df_text_free(struct df_text *text);

#endif
