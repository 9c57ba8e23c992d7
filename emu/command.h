/* command.h — the subcommands of kinescope and what they share: help, errors, exit statuses.
 *
 * Exit status: 0 done; 1 host or guest trouble; 2 wrong usage; 3 a moment did not come in time.
 *              compare has its own: 0 same, 1 differ, 2 trouble.
 * Ownership:   nothing.
 */
#ifndef EMU_COMMAND_H
#define EMU_COMMAND_H

#include "emu/input_file.h"
#include "emu/options.h"

#define VM_VERSION "0.1"

enum { VM_EXIT_OK = 0, VM_EXIT_TROUBLE = 1, VM_EXIT_USAGE = 2, VM_EXIT_TIMEOUT = 3 };

struct vm_command {
    const char *name, *arguments;
    const char *summary; /* one line */
    const char *details; /* may be "" */
    const char *examples;
    int (*run)(int argc, char **argv); /* arguments after the name; an exit status */
};

extern const struct vm_command vm_command_run, vm_command_capture, vm_command_asm,
    vm_command_disasm, vm_command_trace, vm_command_list, vm_command_compare, vm_command_measure,
    vm_command_calc, vm_command_probe, vm_command_sweep, vm_command_why, vm_command_lesson;

/* Parses; −1 = go on, else the exit status (help was printed, or the error). At least `least` and
 * at most `most` arguments that are not options. */
int vm_command_parse(const struct vm_command *command, const struct vm_option_table *tables,
                     size_t table_count, int argc, char **argv, struct vm_args *args, int least,
                     int most);

/* vm_input_load for a command: a report of the assembler goes to stderr, and err->text is empty then: all is said. */
bool vm_command_load(struct vm_input *input, const char *path,
                     const struct vm_input_options *options, struct crt_error *err);

/* Prints "kinescope NAME: sentence" to stderr, unless all is said, and returns `status`. */
int vm_command_fail(const struct vm_command *command, int status, const struct crt_error *err);

#endif
