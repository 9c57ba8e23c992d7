/* run — a program in a window, or headless as fast as the host can. */
#include <stdio.h>
#include <stdlib.h>

#include "emu/command.h"
#include "emu/headless.h"
#include "emu/out_file.h"
#include "emu/roms.h"
#include "emu/script_suits.h"
#include "emu/show.h"
#include "emu/view.h"

struct options {
    bool headless, console, full_screen, gdb_anywhere, tour, latency, no_flash;
    const char *gdb, *record, *versus;
    struct vm_time length, shutter;
    struct vm_size size;
    double scale;
    struct vm_saved_options saved;
    struct vm_show_options side[VM_SIDES]; /* left, or alone; right */
    struct vm_option_table tables[VM_SIDES][VM_SHOW_TABLES];
    struct vm_versus other; /* what is different on the right */
    struct vm_input_options input;
    struct vm_roms_options roms;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"headless", 0, VM_OPT_FLAG, ROW(headless), "",
     "no window and no light: as fast as the host can, to the end of firmware or of --for T (of a "
     "display file 10s)",
     0, 0},
    {"console", 0, VM_OPT_FLAG, ROW(console), "",
     "join the firmware's console to the terminal, where every key is the firmware's and Ctrl-A x "
     "leaves; or to a pipe, which is waited for whenever the firmware has been quiet for 10 ms, "
     "and "
     "after whose end it gets 0x04; </dev/null types nothing",
     0, 0},
    {"gdb", 0, VM_OPT_STRING, ROW(gdb), "ADDRESS:PORT",
     "wait there for gdb before the first instruction of the firmware, and let it debug", 0, 0},
    {"gdb-anywhere", 0, VM_OPT_FLAG, ROW(gdb_anywhere), "",
     "--gdb may listen where other machines can connect: they control the program", 0, 0},
    {"for", 0, VM_OPT_TIME, ROW(length), "T",
     "end after this much simulated time; with status 3 when firmware has not ended itself by then "
     "(--headless)",
     0, 0},
    {"time-scale", 0, VM_OPT_REAL, ROW(scale), "X",
     "simulated seconds a second, 1e-6 to 10; F7 and F8 change it", 1e-6, 10},
    {"shutter", 0, VM_OPT_TIME, ROW(shutter), "T",
     "how long the light of a picture has been gathered, 1us to 1s, whatever the time scale; "
     "default "
     "the time that a picture stands for; Right Ctrl E with Up, Down changes it",
     0, 0},
    {"no-flash", 0, VM_OPT_FLAG, ROW(no_flash), "",
     "show the mean light of the last second, so that nothing flashes", 0, 0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "size of the window; default fits the monitor", 0,
     0},
    {"full-screen", 0, VM_OPT_FLAG, ROW(full_screen), "", "begin on the full screen", 0, 0},
    {"record", 0, VM_OPT_STRING, ROW(record), "FILE",
     "write what is done with mouse and keys in the window, and by --input, as a script that "
     "--input "
     "does again, to the same bytes",
     0, 0},
    {"latency", 0, VM_OPT_FLAG, ROW(latency), "",
     "when the window closes, say how long after an event of mouse or keys the picture came that "
     "shows it",
     0, 0},
    {"versus", 0, VM_OPT_STRING, ROW(versus), "NAME=VALUE;...",
     "beside it the same program on another machine, which gets the same keys and hands: options "
     "without dashes that are different there, such as 'phosphor=P31;refresh=30;set.spot=0.5'",
     0, 0},
    {"tour", 0, VM_OPT_FLAG, ROW(tour), "", "a tour through the programs that come along", 0, 0},
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_run, status, err);
}

/* A console and a debugger are for firmware. */
static bool has_use(const struct options *o, const struct vm_input *input, struct crt_error *err)
{
    return input->has_firmware || (!o->console && !o->gdb) ||
           crt_fail(err, "%s: %s has no firmware", o->console ? "--console" : "--gdb", input->name);
}

/* The debugger's door, when there is to be one; false: a sentence, with its status. */
static bool open_gdb(const struct options *o, const char *path, struct vm_gdb **gdb, int *status,
                     struct crt_error *err)
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

static int debuggable_headless(const struct options *o, const char *path,
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

static int run_headless(const struct options *o, const char *path)
{
    struct vm_input input;
    struct vm_settings settings;
    struct crt_error err;
    char *report;
    if (!vm_input_load(&input, path, &o->input, &err, &report)) {
        if (report)
            fputs(report, stderr);
        free(report);
        return report ? VM_EXIT_TROUBLE : fail(VM_EXIT_TROUBLE, &err);
    }
    int status =
        vm_settings_resolve(&o->side[0].settings, input.is_recording ? &input.header : NULL,
                            vm_input_tube(&input), &settings, &err);
    if (!status &&
        !(vm_view_suits(&settings, &input, &err) && vm_script_suits(&settings, &input, &err)))
        status = VM_EXIT_USAGE;
    if (!status)
        status = debuggable_headless(o, path, &settings, &input, &err);
    vm_settings_free(&settings);
    vm_input_free(&input);
    return status && err.text[0] ? fail(status, &err) : status;
}

/* The window loads its file itself; what is wrong with that it says itself, too. */
static bool window_has_use(const struct options *o, const char *path, struct crt_error *err)
{
    struct vm_input input;
    struct crt_error said;
    if (!path || (!o->console && !o->gdb) || !vm_input_load(&input, path, &o->input, &said, NULL))
        return true;
    bool ok = has_use(o, &input, err);
    vm_input_free(&input);
    return ok;
}

static bool shutter_of(const struct options *o, struct crt_rate tick, uint64_t *shutter,
                       struct crt_error *err)
{
    if (!o->shutter.given)
        return true;
    if (!vm_time_ps(&o->shutter, tick, shutter, err))
        return false;
    return (*shutter >= CRT_PS_PER_US && *shutter <= VM_SHUTTER_MOST) ||
           crt_fail(err, "--shutter: give a time of 1us to 1s; without it a picture gathers the "
                         "light of the time that it stands for");
}

/* Options of a side are checked before a window appears. */
static int check_side(const struct options *o, int side, uint64_t *shutter, struct crt_error *err)
{
    struct vm_settings settings;
    struct vm_lights lights;
    struct crt_error why;
    int status = vm_settings_resolve(&o->side[side].settings, NULL, NULL, &settings, &why);
    if (!status && !shutter_of(o, settings.tick, shutter, &why))
        status = VM_EXIT_USAGE;
    if (!status)
        status = vm_light_settings(&o->side[side].light, &settings, &lights, &why);
    vm_settings_free(&settings);
    if (status)
        crt_fail(err, "%s%.490s", side ? "--versus: " : "", why.text);
    return status;
}

/* `path` NULL: the tour. */
static int run_window(const struct options *o, const char *path)
{
    struct crt_error err;
    uint64_t shutter = 0;
    int status = check_side(o, 0, &shutter, &err);
    if (!status && o->versus)
        status = check_side(o, 1, &shutter, &err);
    if (!status && !window_has_use(o, path, &err))
        status = VM_EXIT_USAGE;
    if (status)
        return fail(status, &err);
    struct vm_show_desc desc = {.path = path,
                                .roms = o->roms.folder,
                                .options = {&o->side[0], o->versus ? &o->side[1] : NULL},
                                .tables = {o->tables[0], o->tables[1]},
                                .versus = &o->other,
                                .input = &o->input,
                                .size = o->size,
                                .full_screen = o->full_screen,
                                .scale = o->scale,
                                .length = o->length,
                                .shutter = shutter,
                                .no_flash = o->no_flash,
                                .console = o->console,
                                .saved = &o->saved,
                                .record = o->record,
                                .latency = o->latency};
    err.text[0] = '\0';
    if (open_gdb(o, path, &desc.gdb, &status, &err))
        status = vm_show(&desc, &err);
    vm_gdb_close(desc.gdb);
    return status && err.text[0] ? fail(status, &err) : status;
}

static void connect_tables(struct options *o, int side)
{
    o->tables[side][0] =
        (struct vm_option_table)VM_OPTION_TABLE(vm_light_rows, &o->side[side].light);
    o->tables[side][1] =
        (struct vm_option_table)VM_OPTION_TABLE(vm_settings_rows, &o->side[side].settings);
}

/* What there can be but one of does not go with two machines. */
static bool check_versus(const struct options *o, struct crt_error *err)
{
    const char *one = o->headless     ? "--headless"
                      : o->console    ? "--console"
                      : o->gdb        ? "--gdb"
                      : o->saved.save ? "--save-state"
                                      : NULL;
    return !o->versus || !one ||
           crt_fail(err, "--versus is for a window with two machines; leave out %s", one);
}

/* The right side is the left one but for what --versus says. */
static bool second_side(struct options *o, struct crt_error *err)
{
    if (!o->versus)
        return true;
    o->side[1] = o->side[0];
    connect_tables(o, 1);
    return vm_versus_parse(&o->other, o->versus, o->tables[1], VM_SHOW_TABLES, err);
}

static int run(int argc, char **argv)
{
    struct options o = {.scale = 1};
    o.side[0].light.room = -1;
    connect_tables(&o, 0);
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o),
                                             o.tables[0][0],
                                             o.tables[0][1],
                                             VM_OPTION_TABLE(vm_input_rows, &o.input),
                                             VM_OPTION_TABLE(vm_saved_rows, &o.saved),
                                             VM_OPTION_TABLE(vm_roms_rows, &o.roms)};
    struct vm_args args;
    struct crt_error err;
    int status = vm_command_parse(&vm_command_run, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 0, 1);
    if (status >= 0)
        return status;
    if (o.length.given && o.length.value == 0) {
        crt_fail(&err, "--for: nothing happens in no time; give a time above zero");
        return fail(VM_EXIT_USAGE, &err);
    }
    if (o.tour && (args.count || o.headless)) {
        crt_fail(&err, "--tour goes through programs in a window; leave out %s",
                 args.count ? "FILE" : "--headless");
        return fail(VM_EXIT_USAGE, &err);
    }
    if (!vm_input_check(&o.input, &err) || !check_versus(&o, &err))
        return fail(VM_EXIT_USAGE, &err);
    char monitor[4096 + 16];
    const char *path = NULL;
    if (!o.tour) {
        path = vm_roms_program(&o.roms, args.count ? args.item[0] : NULL, monitor, sizeof monitor,
                               &err);
        if (!path)
            return fail(VM_EXIT_TROUBLE, &err);
    }
    status = vm_saved_check(&o.saved, path, &o.input, o.record, &err);
    if (!status && o.record && !vm_out_check(o.record, &err))
        status = VM_EXIT_TROUBLE;
    if (status)
        return fail(status, &err);
    if (!second_side(&o, &err))
        status = fail(VM_EXIT_USAGE, &err);
    else
        status = o.headless ? run_headless(&o, path) : run_window(&o, path);
    vm_versus_free(&o.other);
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
    "oscilloscope (F4) can; of pictures that flash 3 to 30 times a second a message warns, and "
    "--no-flash shows them steady.",
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
