/* Where a failed assert() ends: the C library's own way of it needs signals. */
#include <assert.h>

#include "roms/bsp/board.h"
#include "roms/bsp/console.h"

_Noreturn void __assert_func(const char *file, int line, const char *function, const char *text);
_Noreturn void __assert_func(const char *file, int line, const char *function, const char *text)
{
    char digits[12], *p = digits + sizeof digits - 1;
    *p = '\0';
    do
        *--p = (char)('0' + line % 10);
    while ((line /= 10) > 0);
    console_write("\nAssertion failed: ");
    console_write(text);
    console_write(", ");
    console_write(function);
    console_write(", ");
    console_write(file);
    console_put(':');
    console_write(p);
    console_put('\n');
    board_exit(1);
}
