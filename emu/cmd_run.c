/* run — a program in a window, or headless as fast as the host can. */
#include <stdio.h>
#include <stdlib.h>

#include "emu/command.h"
#include "emu/headless.h"
#include "emu/run_options.h"
#include "emu/program_settings.h"

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_run, status, err);
}

/* A console and a debugger are for firmware. */
static bool has_use(const struct vm_run_options *o, const struct vm_input *input,
                    struct crt_error *err)
{
    return input->has_firmware || (!o->console && !o->gdb) ||
           crt_fail(err, "%s: %s has no firmware", o->console ? "--console" : "--gdb", input->name);
}

/* The debugger's door, when there is to be one; false: a sentence, with its status. */
static bool open_gdb(const struct vm_run_options *o, const char *path, struct vm_gdb **gdb,
                     int *status, struct crt_error *err)
{
    *gdb = NULL;
    if (!o->gdb)
        return true;
    *status = VM_EXIT_USAGE;
    if (!path)
        return crt_fail(err, "--gdb needs a FILE, firmware that it can debug");
    if (!vm_gdb_check(o->gdb, o->gdb_anywhere, err))
        return false;
    *status = VM_EXIT_TROUBLE;
    *gdb = vm_gdb_open(o->gdb, o->gdb_anywhere, err);
    if (*gdb)
        vm_gdb_announce(*gdb, path);
    return *gdb != NULL;
}

static int debuggable_headless(const struct vm_run_options *o, const char *path,
                               const struct vm_settings *settings, const struct vm_input *input,
                               struct crt_error *err)
{
    struct vm_headless headless = {
        .console = o->console, .length = o->length, .saved = o->saved, .record = o->record};
    int status;
    if (!has_use(o, input, err))
        return VM_EXIT_USAGE;
    if (!open_gdb(o, path, &headless.gdb, &status, err))
        return status;
    status = vm_headless(&headless, settings, input, err);
    vm_gdb_close(headless.gdb);
    return status;
}

static int run_headless(const struct vm_run_options *o, const char *path)
{
    struct vm_input input;
    struct vm_settings settings;
    struct crt_error err;
    if (!vm_command_load(&input, path, &o->input, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    int status = vm_program_settings(&o->side[0].settings, &input, &settings, &err);
    if (!status)
        status = debuggable_headless(o, path, &settings, &input, &err);
    vm_settings_free(&settings);
    vm_input_free(&input);
    return status && err.text[0] ? fail(status, &err) : status;
}

/* The window loads its file itself; what is wrong with that it says itself, too. */
static bool window_has_use(const struct vm_run_options *o, const char *path, struct crt_error *err)
{
    struct vm_input input;
    struct crt_error said;
    if (!path || (!o->console && !o->gdb) || !vm_input_load(&input, path, &o->input, &said, NULL))
        return true;
    bool ok = has_use(o, &input, err);
    vm_input_free(&input);
    return ok;
}

static int run_window(const struct vm_run_options *o)
{
    struct crt_error err;
    struct vm_show_desc desc;
    int status = vm_run_show(o, &desc, &err);
    if (!status && !window_has_use(o, o->path, &err))
        status = VM_EXIT_USAGE;
    if (status)
        return fail(status, &err);
    err.text[0] = '\0';
    if (open_gdb(o, o->path, &desc.gdb, &status, &err))
        status = vm_show(&desc, &err);
    vm_gdb_close(desc.gdb);
    return status && err.text[0] ? fail(status, &err) : status;
}

static int run(int argc, char **argv)
{
    struct vm_run_options o;
    struct vm_option_table tables[VM_RUN_TABLES];
    struct vm_args args;
    struct crt_error err;
    vm_run_begin(&o, tables);
    int status = vm_command_parse(&vm_command_run, tables, VM_RUN_TABLES, argc, argv, &args, 0, 1);
    if (status >= 0)
        return status;
    status = vm_run_check(&o, &args, &err);
    if (status)
        fail(status, &err);
    else
        status = o.headless ? run_headless(&o, o.path) : run_window(&o);
    vm_run_free(&o);
    return status;
}

const struct vm_command vm_command_run = {
    "run",
    "[FILE]",
    "Show a program in a window; without FILE the monitor",
    "F1 in the window shows the keys. Every key except F1 to F12 and those held with Right Ctrl "
    "belongs "
    "to the program. A file that changes is loaded again; a file dropped on the window is shown. "
    "A monitor of 60 Hz cannot show flicker of 60 Hz and more as on the tube: slow motion (F7) and "
    "the "
    "oscilloscope (F4) can. Where refresh makes the window flash 3 to 30 times a second a message "
    "warns (of what blinks in a program by itself it does not), and --no-flash shows the mean "
    "light.",
    "  kinescope run\n"
    "  kinescope run --tour\n"
    "  kinescope run --headless --console < script\n"
    "  kinescope run roms/lander.df --tube VR14 --time-scale 0.001\n"
    "  kinescope run roms/spin.df --versus 'phosphor=P39;refresh=30'\n"
    "  kinescope run roms/lander.df --phosphor P31 --time-scale 1e-5 --shutter 100us\n"
    "  kinescope run roms/growing.df --refresh 25 --no-flash\n"
    "  kinescope run roms/spin.df --headless --for 60s\n"
    "  kinescope run roms/pattern.elf --tube MONO12/P134\n"
    "  kinescope run roms/hello.elf --headless --console\n"
    "  kinescope run roms/clock.elf --gdb 127.0.0.1:1234\n"
    "  kinescope run roms/clock.elf --headless --for 5s --save-state clock.state\n"
    "  kinescope run roms/sketch.elf --record drawing.script\n"
    "  kinescope run roms/sketch.elf --headless --input drawing.script --for 60s\n"
    "  echo hello | kinescope run roms/hello.elf --headless --console --for 5s",
    run,
};
