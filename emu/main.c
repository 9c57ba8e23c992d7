/* main.c — the kinescope command: finds the subcommand and runs it. */
#include <stdio.h>
#include <string.h>

#include "emu/command.h"

static const struct vm_command *const commands[] = {
    &vm_command_run,    &vm_command_capture, &vm_command_asm,     &vm_command_disasm,
    &vm_command_trace,  &vm_command_list,    &vm_command_compare, &vm_command_measure,
    &vm_command_calc,   &vm_command_probe,   &vm_command_sweep,   &vm_command_why,
    &vm_command_lesson,
};
#define COMMANDS (sizeof commands / sizeof *commands)

static const struct vm_command *find(const char *name)
{
    for (size_t i = 0; i < COMMANDS; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

static int unknown(const char *name)
{
    const char *names[COMMANDS];
    for (size_t i = 0; i < COMMANDS; i++)
        names[i] = commands[i]->name;
    const char *near = vm_nearest(name, names, COMMANDS);
    fprintf(stderr, "kinescope: there is no subcommand '%.60s'; %s%s%s\n", name,
            near ? "did you mean " : "kinescope help lists them", near ? near : "",
            near ? "?" : "");
    return VM_EXIT_USAGE;
}

static int help(void)
{
    printf("kinescope " VM_VERSION " — a simulated CRT display terminal you can program.\n\n"
           "Firmware runs on a simulated processor, a display processor draws with an electron "
           "beam, a "
           "phosphor\nglows and decays.\n\n");
    for (size_t i = 0; i < COMMANDS; i++)
        printf("  kinescope %-8s %-36s %s\n", commands[i]->name, commands[i]->arguments,
               commands[i]->summary);
    printf(
        "\nkinescope SUBCOMMAND --help lists the options of each, with examples. To begin:\n\n"
        "  kinescope run                                the monitor: lessons and a console, in a "
        "window\n"
        "  kinescope run --tour                         a tour of the programs that come along\n"
        "  kinescope capture roms/rose.df -o rose.png   a picture, without a display\n\n"
        "Exit status: 0 done, 1 trouble with a file, the host or the program, 2 wrong usage, 3 too "
        "late\n(compare: 0 same, 1 differ, 2 trouble; run of firmware: what it ended with).\n");
    return VM_EXIT_OK;
}

/* What was printed may be on a full disk or a closed pipe; a command that failed has said why. */
static int finish(int status)
{
    if (fflush(stdout) != 0 || ferror(stdout)) {
        if (status != VM_EXIT_OK)
            return status;
        fprintf(stderr, "kinescope: standard output cannot be written\n");
        return VM_EXIT_TROUBLE;
    }
    return status;
}

int main(int argc, char **argv)
{
    static char help_option[] = "--help";
    if (argc < 2 || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0)
        return finish(help());
    if (strcmp(argv[1], "--version") == 0) {
        printf("kinescope " VM_VERSION "\n");
        return finish(VM_EXIT_OK);
    }
    if (strcmp(argv[1], "help") == 0) {
        if (argc < 3)
            return finish(help());
        const struct vm_command *asked = find(argv[2]);
        char *arguments[] = {help_option};
        return asked ? finish(asked->run(1, arguments)) : unknown(argv[2]);
    }
    const struct vm_command *command = find(argv[1]);
    return command ? finish(command->run(argc - 2, argv + 2)) : unknown(argv[1]);
}
