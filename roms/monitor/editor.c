#include "roms/monitor/editor.h"

#include <stdio.h>
#include <string.h>

#include "roms/bsp/console.h"
#include "roms/monitor/keys.h"
#include "roms/monitor/transcript.h"

enum { BELL = 7, CONTROL_U = 21 };

void editor_show(const struct editor *e, struct stage *stage)
{
    enum { ROOM = STAGE_PROMPT - 3 };
    char text[STAGE_PROMPT + 1];
    const char *tail = e->line + (e->length > ROOM ? e->length - ROOM : 0);
    snprintf(text, sizeof text, "> %s_", tail);
    stage_prompt(stage, text);
}

void editor_begin(struct editor *e, struct stage *stage)
{
    e->length = 0;
    e->back = 0;
    e->line[0] = '\0';
    console_write("> ");
    editor_show(e, stage);
}

static void rub_out(struct editor *e, int count)
{
    for (; count > 0 && e->length > 0; count--) {
        e->line[--e->length] = '\0';
        console_write("\b \b");
    }
}

static void take(struct editor *e, char c)
{
    if (e->length + 1 >= EDITOR_ROOM) {
        console_put(BELL);
        return;
    }
    e->line[e->length++] = c;
    e->line[e->length] = '\0';
    console_put(c);
}

static void keep(struct editor *e)
{
    if (e->length > 0)
        memcpy(e->before[e->kept++ % EDITOR_LINES], e->line, (size_t)e->length + 1);
}

/* The line typed `back` lines before; 0: an empty one. */
static void fetch(struct editor *e, unsigned back)
{
    unsigned most = e->kept < EDITOR_LINES ? e->kept : EDITOR_LINES;
    if (back > most)
        return;
    rub_out(e, e->length);
    e->back = back;
    if (back == 0)
        return;
    for (const char *c = e->before[(e->kept - back) % EDITOR_LINES]; *c != '\0'; c++)
        take(e, *c);
}

static enum editor_event enter(struct editor *e)
{
    transcript_add("> ");
    transcript_add(e->line);
    printf("\n");
    keep(e);
    return EDITOR_ENTERED;
}

enum editor_event editor_key(struct editor *e, struct stage *stage, int key)
{
    if (key == KEYS_ENTER || key == KEYS_LINE || (key == KEYS_INPUT_END && e->length > 0))
        return enter(e);
    if (key == KEYS_BACKSPACE)
        rub_out(e, 1);
    else if (key == CONTROL_U)
        rub_out(e, e->length);
    else if (key == KEY_UP)
        fetch(e, e->back + 1);
    else if (key == KEY_DOWN && e->back > 0)
        fetch(e, e->back - 1);
    else if (key >= ' ' && key < 127)
        take(e, (char)key);
    else if (key == '\t' && e->length > 0)
        take(e, ' ');
    else
        return EDITOR_OTHER;
    editor_show(e, stage);
    return EDITOR_TYPED;
}
