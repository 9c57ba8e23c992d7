/* html.h — pieces of a page: text that is escaped, pictures as data.
 *
 * Ownership:  nothing.
 * Errors:     those of the stream.
 */
#ifndef EMU_LESSON_HTML_H
#define EMU_LESSON_HTML_H

#include <stdio.h>

/* As it is, also within the quotes of an attribute. */
void vm_html_text(FILE *out, const char *text);
void vm_html_bytes(FILE *out, const char *text, size_t n);
/* With `code` between backquotes. */
void vm_html_prose(FILE *out, const char *text);
/* RFC 4648, in one line. */
void vm_html_base64(FILE *out, const unsigned char *bytes, size_t length);
/* <img>, the bytes being a PNG's; its size is stated, so that the page does not move while it is shown. */
void vm_html_png(FILE *out, const unsigned char *bytes, size_t length, const char *alt);
/* Rows of comma-separated values, the first being the headings; after `most` rows it is said how many are left. */
void vm_html_csv(FILE *out, const char *csv, int most);

#endif
