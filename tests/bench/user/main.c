/* The first line that the firmware prints (roms/bench/main.c), from the same kernel. */
#include <stddef.h>

#include "roms/bench/kernel.h"

int user_main(void);
void user_write(const char *text, size_t length);

static size_t add(char *line, size_t n, const char *text)
{
    while (*text != '\0')
        line[n++] = *text++;
    return n;
}

int user_main(void)
{
    char line[64];
    uint32_t sum = kernel_run();
    size_t n = add(line, add(line, 0, kernel_name), ": check sum ");
    for (int shift = 28; shift >= 0; shift -= 4)
        line[n++] = "0123456789abcdef"[sum >> shift & 15];
    line[n++] = '\n';
    user_write(line, n);
    return 0;
}
