/* disasm — words back to display-file source. */
#include <stdio.h>
#include <stdlib.h>

#include "display_file/disasm.h"
#include "emu/command.h"
#include "emu/input_file.h"
#include "emu/out_file.h"

struct options {
    const char *out;
    struct vm_input_options input;
};

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, offsetof(struct options, out), "OUT.df",
     "where the source goes; default standard output", 0, 0},
};

static bool write_text(const char *path, const char *text, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error ignored;
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        fputs(text, out.file);
    return vm_out_close(&out, ok, ok ? err : &ignored) && ok;
}

static int disassemble(const struct options *o, const struct vm_input *input)
{
    struct crt_error err = {"not enough memory for the source"};
    if (input->is_recording) {
        crt_fail(&err, "%s is a recording of beam pieces; it holds no words", input->name);
        return vm_command_fail(&vm_command_disasm, VM_EXIT_TROUBLE, &err);
    }
    if (input->has_firmware && !input->program.words) {
        crt_fail(&err, "%s is firmware; it holds no display-file words", input->name);
        return vm_command_fail(&vm_command_disasm, VM_EXIT_TROUBLE, &err);
    }
    char *text = df_disassemble(&input->program);
    bool ok = text != NULL;
    if (ok && o->out)
        ok = write_text(o->out, text, &err);
    else if (ok)
        fputs(text, stdout);
    free(text);
    return ok ? VM_EXIT_OK : vm_command_fail(&vm_command_disasm, VM_EXIT_TROUBLE, &err);
}

static int run(int argc, char **argv)
{
    struct options o = {0};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o),
                                             VM_OPTION_TABLE(vm_input_rows, &o.input)};
    struct vm_args args;
    struct vm_input input;
    struct crt_error err;
    char *report;
    int status = vm_command_parse(&vm_command_disasm, tables, 2, argc, argv, &args, 1, 1);
    if (status >= 0)
        return status;
    if (!vm_out_spares(o.out, args.item[0], &err))
        return vm_command_fail(&vm_command_disasm, VM_EXIT_USAGE, &err);
    if (!vm_input_load(&input, args.item[0], &o.input, &err, &report)) {
        free(report);
        return vm_command_fail(&vm_command_disasm, VM_EXIT_TROUBLE, &err);
    }
    status = disassemble(&o, &input);
    vm_input_free(&input);
    return status;
}

const struct vm_command vm_command_disasm = {
    "disasm",
    "FILE.oct [-o OUT.df]",
    "Turn words back into source that assembles to the same words",
    "FILE may also be a DEC absolute tape (.lda) or, with --base, a raw memory image.",
    "  kinescope disasm rose.oct -o again.df\n"
    "  kinescope disasm dump.bin --base 1000 --start 1000",
    run,
};
