/* show_typing.c — keys of the window as a terminal sends them: characters as they are, Ctrl with a
 * letter as a control character, the others by the sequences of a VT100 (ECMA-48) and its followers.
 * They reach the firmware at the simulated time at which they come. */
#include <stdio.h>
#include <string.h>

#include "emu/show.h"

static const struct {
    enum vm_key key;
    const char *sent;
} keys[] = {
    {VM_KEY_ENTER, "\r"},       {VM_KEY_KP_ENTER, "\r"},     {VM_KEY_TAB, "\t"},
    {VM_KEY_BACKSPACE, "\x7F"}, {VM_KEY_ESCAPE, "\x1B"},     {VM_KEY_UP, "\x1B[A"},
    {VM_KEY_DOWN, "\x1B[B"},    {VM_KEY_RIGHT, "\x1B[C"},    {VM_KEY_LEFT, "\x1B[D"},
    {VM_KEY_HOME, "\x1B[H"},    {VM_KEY_END, "\x1B[F"},      {VM_KEY_INSERT, "\x1B[2~"},
    {VM_KEY_DELETE, "\x1B[3~"}, {VM_KEY_PAGE_UP, "\x1B[5~"}, {VM_KEY_PAGE_DOWN, "\x1B[6~"},
};

/* What a key sends that makes no character; its length. */
static size_t sent_by(const struct vm_event *event, char text[8])
{
    enum vm_key key = event->u.key.key;
    if ((event->u.key.modifiers & VM_MOD_CONTROL) && key >= '@' && key <= '_') {
        text[0] = (char)(key & 0x1F);
        return 1;
    }
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i].key == key)
            return (size_t)snprintf(text, 8, "%s", keys[i].sent);
    return 0;
}

void vm_show_type(struct vm_show *show, const struct vm_event *event)
{
    struct vm_rig *rig = &show->program->rig;
    char text[8];
    size_t length = 0;
    if (!rig->console)
        return;
    if (event->kind == VM_EVENT_TEXT) {
        text[0] = (char)event->u.text.character;
        length = event->u.text.character < 0x80; /* the console is ASCII */
    } else if (event->u.key.action != VM_RELEASE) {
        length = sent_by(event, text);
    }
    if (length > 0 && !vm_console_type(rig->console, text, length, rig->machine->now))
        vm_show_say(show, "not enough memory for the key");
}
