#include "roms/monitor/transcript.h"

#include <stdio.h>
#include <string.h>

#include "roms/bsp/console.h"

static struct {
    char line[TRANSCRIPT_KEPT][TRANSCRIPT_WIDTH + 1];
    unsigned count;  /* lines begun before the present one */
    unsigned column; /* in it */
} said;

static void end_line(void)
{
    said.count++;
    said.column = 0;
    said.line[said.count % TRANSCRIPT_KEPT][0] = '\0';
}

/* The present line is full: its last word, if it is not all of it, goes to the next. */
static void break_line(void)
{
    char *line = said.line[said.count % TRANSCRIPT_KEPT], *blank = strrchr(line, ' ');
    char word[TRANSCRIPT_WIDTH + 1] = "";
    if (blank != NULL && blank > line) {
        strcpy(word, blank + 1);
        *blank = '\0';
    }
    end_line();
    strcpy(said.line[said.count % TRANSCRIPT_KEPT], word);
    said.column = (unsigned)strlen(word);
}

static void keep(char c)
{
    if (c == '\n') {
        end_line();
    } else if ((unsigned char)c >= ' ') {
        if (said.column == TRANSCRIPT_WIDTH)
            break_line();
        char *line = said.line[said.count % TRANSCRIPT_KEPT];
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

unsigned transcript_draw(struct stage *stage, unsigned back)
{
    enum { PITCH = STAGE_HEIGHT / (TRANSCRIPT_LINES + 2) };
    unsigned kept = said.count < TRANSCRIPT_KEPT - 1 ? said.count : TRANSCRIPT_KEPT - 1;
    unsigned pages = kept == 0 ? 0 : (kept - 1) / TRANSCRIPT_LINES;
    back = back < pages ? back : pages;
    unsigned end = said.count - back * TRANSCRIPT_LINES;
    unsigned first = said.count - kept;
    if (end - first > TRANSCRIPT_LINES)
        first = end - TRANSCRIPT_LINES;
    for (unsigned i = first; i < end; i++) {
        const char *line = said.line[i % TRANSCRIPT_KEPT];
        if (line[0] != '\0')
            stage_text(stage, 4, (float)(STAGE_HEIGHT - PITCH * (int)(i - first + 2)), line);
    }
    return pages;
}
