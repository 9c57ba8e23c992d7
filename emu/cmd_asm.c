/* asm — display-file source to words. */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "display_file/asm.h"
#include "display_file/loaders.h"
#include "emu/command.h"
#include "emu/out_file.h"

struct options {
    const char *out;
    bool listing;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"out", 'o', VM_OPT_STRING, ROW(out), "OUT.oct",
     "where the words go; without it and without --listing, standard output", 0, 0},
    {"listing", 0, VM_OPT_FLAG, ROW(listing), "",
     "print addresses, words and source to standard output", 0, 0},
};

static bool write_words(const char *path, const struct df_program *program, struct crt_error *err)
{
    struct vm_out out;
    struct crt_error ignored;
    bool ok = vm_out_open(&out, path, err);
    if (ok)
        df_write_oct(out.file, program);
    return vm_out_close(&out, ok, ok ? err : &ignored) && ok;
}

/* Words and recordings are not source: one sentence instead of an error for each of their lines. */
static bool is_source(const char *path, struct crt_error *err)
{
    static const char *const others[] = {".oct", ".lda", ".beam"};
    const char *dot = strrchr(path, '.');
    for (size_t i = 0; dot && i < sizeof others / sizeof *others; i++)
        if (strcasecmp(dot, others[i]) == 0)
            return crt_fail(err, "%.300s is no source; kinescope disasm makes source of words",
                            path);
    return true;
}

static int assemble(const struct options *o, const char *path)
{
    const struct df_asm_options options = {o->listing};
    struct df_asm_report report = {0};
    struct df_program program = {0};
    struct crt_error err;
    int status = VM_EXIT_OK;
    if (!df_assemble_file(path, &options, &program, &report)) {
        fputs(report.text ? report.text : "kinescope asm: not enough memory\n", stderr);
        status = VM_EXIT_TROUBLE;
    }
    if (report.listing)
        fputs(report.listing, stdout);
    if (status == VM_EXIT_OK && o->out && !write_words(o->out, &program, &err))
        status = vm_command_fail(&vm_command_asm, VM_EXIT_TROUBLE, &err);
    if (status == VM_EXIT_OK && !o->out && !o->listing)
        df_write_oct(stdout, &program);
    df_asm_report_free(&report);
    df_program_free(&program);
    return status;
}

static int run(int argc, char **argv)
{
    struct options o = {0};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    int status = vm_command_parse(&vm_command_asm, tables, 1, argc, argv, &args, 1, 1);
    if (status >= 0)
        return status;
    struct crt_error err;
    if (!is_source(args.item[0], &err) || !vm_out_spares(o.out, args.item[0], &err))
        return vm_command_fail(&vm_command_asm, VM_EXIT_USAGE, &err);
    return assemble(&o, args.item[0]);
}

const struct vm_command vm_command_asm = {
    "asm",
    "FILE.df [-o OUT.oct] [--listing]",
    "Assemble display-file source into octal words",
    "All errors of a file are printed in one go, each with its place and what was expected.",
    "  kinescope asm roms/rose.df -o rose.oct\n"
    "  kinescope asm roms/rose.df --listing",
    run,
};
