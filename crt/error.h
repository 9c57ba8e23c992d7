/* error.h — one sentence for the user when the host is in trouble.
 *
 * Models:     a function that can fail for reasons outside the program takes a struct crt_error and
 *             returns false (or NULL) after writing one sentence that names the file, the place and
 *             the remedy. Programmer errors assert instead.
 * Ownership:  the caller's; plain value. Never NULL.
 * Errors:     a sentence that is too long is cut.
 */
#ifndef CRT_ERROR_H
#define CRT_ERROR_H

#include <stdbool.h>

struct crt_error {
    char text[512];
};

/* Formats the sentence and returns false, so that `return crt_fail(err, ...)` reads well. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
bool crt_fail(struct crt_error *err, const char *format, ...);

#endif
