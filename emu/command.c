#include "emu/command.h"

#include <stdlib.h>

int vm_command_fail(const struct vm_command *command, int status, const struct crt_error *err)
{
    if (err->text[0])
        fprintf(stderr, "kinescope %s: %s\n", command->name, err->text);
    return status;
}

bool vm_command_load(struct vm_input *input, const char *path,
                     const struct vm_input_options *options, struct crt_error *err)
{
    char *report;
    if (vm_input_load(input, path, options, err, &report))
        return true;
    if (report) {
        fputs(report, stderr);
        err->text[0] = '\0';
    }
    free(report);
    return false;
}

static void print_help(const struct vm_command *c, const struct vm_option_table *tables,
                       size_t table_count)
{
    printf("kinescope %s %s\n\n%s.\n", c->name, c->arguments, c->summary);
    if (*c->details)
        vm_print_wrapped(stdout, c->details, 0);
    printf("\nOptions:\n");
    vm_options_help(stdout, tables, table_count);
    printf("\nExamples:\n%s\n", c->examples);
}

int vm_command_parse(const struct vm_command *c, const struct vm_option_table *tables,
                     size_t table_count, int argc, char **argv, struct vm_args *args, int least,
                     int most)
{
    struct crt_error err;
    switch (vm_options_parse(tables, table_count, argc, argv, args, &err)) {
    case VM_PARSED_HELP:
        print_help(c, tables, table_count);
        return VM_EXIT_OK;
    case VM_PARSED_ERROR:
        return vm_command_fail(c, VM_EXIT_USAGE, &err);
    case VM_PARSED:
        break;
    }
    if (args->count < least)
        crt_fail(&err, "an argument is missing; usage: kinescope %s %s", c->name, c->arguments);
    else if (args->count > most)
        crt_fail(&err, "'%.100s' is one argument too many; usage: kinescope %s %s",
                 args->item[most], c->name, c->arguments);
    else
        return -1;
    return vm_command_fail(c, VM_EXIT_USAGE, &err);
}
