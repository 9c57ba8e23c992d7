/* names.h — names of rows are compared without regard to ASCII case, whatever the locale.
 *
 * Ownership:  nothing is kept.
 * Errors:     none.
 */
#ifndef CRT_NAMES_H
#define CRT_NAMES_H

#include <stdbool.h>

bool crt_same_name(const char *a, const char *b);

#endif
