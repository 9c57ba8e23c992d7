/* The C library's standard streams on the console: linked when a program uses them. */
#include <stdio.h>

#include "roms/bsp/console.h"

static int put(char c, FILE *stream)
{
    (void)stream;
    console_put(c);
    return (unsigned char)c;
}

static int get(FILE *stream)
{
    (void)stream;
    int c = console_get();
    return c == CONSOLE_EOF ? _FDEV_EOF : c;
}

static FILE console = FDEV_SETUP_STREAM(put, get, NULL, _FDEV_SETUP_RW);

FILE *const stdin = &console;
FILE *const stdout = &console;
FILE *const stderr = &console;
