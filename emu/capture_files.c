#include "emu/capture_files.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Length of the %d at `p`, with its field width; 0 when there is none. */
static size_t field(const char *p, int *width)
{
    const char *start = p++;
    *width = 0;
    while (isdigit((unsigned char)*p) && p - start < 3)
        *width = *width * 10 + (*p++ - '0');
    return *p == 'd' ? (size_t)(p - start) + 1 : 0;
}

bool vm_frame_name_ok(const char *pattern)
{
    const char *first = strchr(pattern, '%');
    int width;
    return first && field(first, &width) && !strchr(first + 1, '%');
}

bool vm_frame_name(const char *pattern, bool numbered, uint64_t number, char *name, size_t size,
                   struct crt_error *err)
{
    const char *first = numbered ? strchr(pattern, '%') : NULL;
    int width = 0;
    size_t length = first ? field(first, &width) : 0;
    int n = length ? snprintf(name, size, "%.*s%0*llu%s", (int)(first - pattern), pattern, width,
                              (unsigned long long)number, first + length)
                   : snprintf(name, size, "%s", pattern);
    return (n > 0 && (size_t)n < size) || crt_fail(err, "the name %.100s... is too long", pattern);
}
