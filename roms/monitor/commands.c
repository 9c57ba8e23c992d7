#include <stdio.h>
#include <string.h>

#include "roms/monitor/command.h"

static const struct command *const groups[] = {
    commands_general, commands_arithmetic, commands_lines, commands_areas,
    commands_clip,    commands_plane,      commands_space, commands_curves,
    commands_solids,  commands_surfaces,   commands_light, commands_segments,
};
enum { GROUPS = sizeof groups / sizeof groups[0] };

void command_each(void (*visit)(const struct command *command, void *ctx), void *ctx)
{
    for (int i = 0; i < GROUPS; i++)
        for (const struct command *c = groups[i]; c->name != NULL; c++)
            visit(c, ctx);
}

const struct command *command_find(const char *name)
{
    for (int i = 0; i < GROUPS; i++)
        for (const struct command *c = groups[i]; c->name != NULL; c++)
            if (strcmp(c->name, name) == 0)
                return c;
    return NULL;
}

void command_line(struct monitor *monitor, char *line)
{
    struct words words;
    if (!words_cut(&words, line)) {
        printf("%s.\n", words.trouble);
        return;
    }
    if (words.count == 0)
        return;
    const char *name = words.at[words.next++];
    const struct command *command = command_find(name);
    if (command == NULL) {
        printf("There is no command \"%.40s\"; \"help\" lists them.\n", name);
        return;
    }
    if (!command->run(monitor, &words))
        printf("%s: %s. Expected: %s %s\n", command->name, words.trouble, command->name,
               command->form);
}
