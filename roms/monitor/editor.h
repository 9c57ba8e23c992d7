/* editor.h — a line typed at the prompt: with echo, rubbing out, and the lines typed before.
 *
 *      keys ──▶ line ──▶ echo on the console, prompt under the picture (stage_prompt)
 *
 * Models:     Backspace and Delete rub out a character, control-U the line; the cursor keys Up and Down
 *             fetch lines typed before.
 * Ownership:  plain value.
 * Errors:     what is typed beyond EDITOR_ROOM characters is not taken and rings the bell.
 */
#ifndef ROMS_MONITOR_EDITOR_H
#define ROMS_MONITOR_EDITOR_H

#include "roms/stage/stage.h"

enum { EDITOR_ROOM = 1024, EDITOR_LINES = 8 };

struct editor {
    char line[EDITOR_ROOM];
    int length;
    char before[EDITOR_LINES][EDITOR_ROOM];
    unsigned kept; /* lines, ever */
    unsigned back; /* how far Up went */
};

enum editor_event {
    EDITOR_TYPED,   /* the line has changed, or nothing has */
    EDITOR_ENTERED, /* it is complete: editor->line */
    EDITOR_OTHER    /* a key that is not the editor's */
};

/* An empty line; the prompt. */
void editor_begin(struct editor *editor, struct stage *stage);
/* The prompt under the picture anew. */
void editor_show(const struct editor *editor, struct stage *stage);
enum editor_event editor_key(struct editor *editor, struct stage *stage, int key);

#endif
