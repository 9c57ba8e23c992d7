#include "roms/bsp/console.h"

#include "emu/memmap.h"
#include "roms/bsp/uart_regs.h"

enum { BELL = 7, BACKSPACE = 8, DELETE = 127 };

static volatile uint8_t *uart(uint32_t offset)
{
    return (volatile uint8_t *)(MAP_UART + offset);
}

static void send(char c)
{
    while ((*uart(UART_LSR) & UART_LSR_EMPTY) == 0)
        continue;
    *uart(UART_THR) = (uint8_t)c;
}

void console_put(char c)
{
    if (c == '\n')
        send('\r');
    send(c);
}

void console_write(const char *text)
{
    while (*text != '\0')
        console_put(*text++);
}

void console_hex(uint32_t value)
{
    for (int shift = 28; shift >= 0; shift -= 4)
        console_put("0123456789abcdef"[value >> shift & 15]);
}

void console_drain(void)
{
    while ((*uart(UART_LSR) & UART_LSR_IDLE) == 0)
        continue;
}

int console_poll(void)
{
    return *uart(UART_LSR) & UART_LSR_RECEIVED ? *uart(UART_RBR) : -1;
}

int console_get(void)
{
    int c;
    do
        c = console_poll();
    while (c < 0);
    return c;
}

/* Takes or refuses one typed character; the new length. */
static size_t typed(char *line, size_t length, size_t size, char c)
{
    if (c == BACKSPACE || c == DELETE) {
        if (length == 0)
            return 0;
        console_write("\b \b");
        return length - 1;
    }
    if (length + 1 >= size || (c < ' ' && c != '\t')) {
        console_put(BELL);
        return length;
    }
    console_put(c);
    line[length] = c;
    return length + 1;
}

int console_line(char *line, size_t size)
{
    size_t length = 0;
    for (;;) {
        char c = (char)console_get();
        if (c == CONSOLE_EOF && length == 0)
            return -1;
        if (c == '\r' || c == '\n' || c == CONSOLE_EOF)
            break;
        length = typed(line, length, size, c);
    }
    console_put('\n');
    line[length] = '\0';
    return (int)length;
}
