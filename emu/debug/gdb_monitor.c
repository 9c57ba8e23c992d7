/* gdb_monitor.c — what "monitor …" does in gdb: commands of the user to the machine. */
#include <stdio.h>
#include <string.h>

#include "emu/debug/gdb_parts.h"

#define COMMAND_MAX 128
#define ANSWER_MAX  2048

static const char help[] =
    "step over    a step runs interrupt handlers through (as from the start)\n"
    "step into    a step stops in them\n";

static const char *own(struct vm_gdb_session *s, const char *command)
{
    if (strcmp(command, "step over") == 0 || strcmp(command, "step into") == 0) {
        s->step_into = strcmp(command, "step into") == 0;
        return s->step_into ? "a step stops in interrupt handlers\n"
                            : "a step runs interrupt handlers through\n";
    }
    return NULL;
}

static void answer(struct vm_gdb_session *s, const char *command, char *text, size_t size)
{
    const struct vm_gdb_target *t = &s->target;
    const char *said = own(s, command);
    text[0] = '\0';
    if (said) {
        snprintf(text, size, "%s", said);
        return;
    }
    bool known = t->monitor && t->monitor(t->ctx, command, text, size);
    if (strcmp(command, "help") == 0) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s", help);
    } else if (!known) {
        snprintf(text, size, "no such command: %s; \"monitor help\" lists them\n", command);
    }
}

/* Printable text without blanks at its ends; false when it is none. */
static bool clean(char *command, size_t size)
{
    while (size > 0 && command[size - 1] == ' ')
        size--;
    command[size] = '\0';
    for (size_t i = 0; i < size; i++)
        if (command[i] < ' ' || command[i] > '~')
            return false;
    return true;
}

void vm_gdb_monitor(struct vm_gdb_session *s, struct vm_gdb_fields *f)
{
    char command[COMMAND_MAX + 1], text[ANSWER_MAX];
    size_t size = vm_gdb_left(f) / 2;
    if (vm_gdb_left(f) % 2 != 0 || size > COMMAND_MAX ||
        !vm_gdb_take_bytes(f, (uint8_t *)command, size) || !clean(command, size)) {
        vm_gdb_say(s, VM_GDB_MALFORMED);
        return;
    }
    answer(s, size == 0 ? "help" : command, text, sizeof text);
    if (text[0] == '\0') {
        vm_gdb_say(s, "OK");
        return;
    }
    vm_gdb_begin(&s->reply);
    vm_gdb_add_bytes(&s->reply, (const uint8_t *)text, strlen(text));
    vm_gdb_send(s);
}
