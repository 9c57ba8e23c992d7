#include "roms/monitor/transcript.h"

#include <stdio.h>

#include "roms/bsp/console.h"

static struct {
    char line[TRANSCRIPT_LINES][TRANSCRIPT_WIDTH + 1];
    unsigned count;  /* lines begun before the present one */
    unsigned column; /* in it */
} said;

static void end_line(void)
{
    said.count++;
    said.column = 0;
    said.line[said.count % TRANSCRIPT_LINES][0] = '\0';
}

static void keep(char c)
{
    if (c == '\n') {
        end_line();
    } else if ((unsigned char)c >= ' ') {
        if (said.column == TRANSCRIPT_WIDTH)
            end_line();
        char *line = said.line[said.count % TRANSCRIPT_LINES];
        line[said.column++] = c;
        line[said.column] = '\0';
    }
}

static int put(char c, FILE *stream)
{
    (void)stream;
    console_put(c);
    keep(c);
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

void transcript_add(const char *text)
{
    while (*text != '\0')
        keep(*text++);
}

unsigned transcript_count(void)
{
    return said.count;
}

void transcript_draw(struct stage *stage)
{
    enum { PITCH = STAGE_HEIGHT / TRANSCRIPT_LINES };
    unsigned first = said.count >= TRANSCRIPT_LINES - 2 ? said.count - (TRANSCRIPT_LINES - 2) : 0;
    for (unsigned i = first; i < said.count; i++) {
        const char *line = said.line[i % TRANSCRIPT_LINES];
        if (line[0] != '\0')
            stage_text(stage, 4, (float)(STAGE_HEIGHT - PITCH * (int)(i - first + 2)), line);
    }
}
