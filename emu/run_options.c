/* run_options.c — the options of `run`, and the window that follows from them. */
#include "emu/run_options.h"

#include <stdio.h>

#include "emu/command.h"
#include "emu/out_file.h"

#define ROW(field) offsetof(struct vm_run_options, field)

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

static bool shutter_of(const struct vm_run_options *o, struct crt_rate tick, uint64_t *shutter,
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
static int check_side(const struct vm_run_options *o, int side, uint64_t *shutter,
                      struct crt_error *err)
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

static void connect_tables(struct vm_run_options *o, int side)
{
    o->tables[side][0] =
        (struct vm_option_table)VM_OPTION_TABLE(vm_light_rows, &o->side[side].light);
    o->tables[side][1] =
        (struct vm_option_table)VM_OPTION_TABLE(vm_settings_rows, &o->side[side].settings);
}

/* What there can be but one of does not go with two machines. */
static bool check_versus(const struct vm_run_options *o, struct crt_error *err)
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
static bool second_side(struct vm_run_options *o, struct crt_error *err)
{
    if (!o->versus)
        return true;
    o->side[1] = o->side[0];
    connect_tables(o, 1);
    return vm_versus_parse(&o->other, o->versus, o->tables[1], VM_SHOW_TABLES, err);
}

void vm_run_begin(struct vm_run_options *o, struct vm_option_table tables[VM_RUN_TABLES])
{
    *o = (struct vm_run_options){.scale = 1};
    o->side[0].light.room = -1;
    connect_tables(o, 0);
    const struct vm_option_table all[VM_RUN_TABLES] = {VM_OPTION_TABLE(rows, o),
                                                       o->tables[0][0],
                                                       o->tables[0][1],
                                                       VM_OPTION_TABLE(vm_input_rows, &o->input),
                                                       VM_OPTION_TABLE(vm_saved_rows, &o->saved),
                                                       VM_OPTION_TABLE(vm_roms_rows, &o->roms)};
    for (int i = 0; i < VM_RUN_TABLES; i++)
        tables[i] = all[i];
}

static bool goes_together(const struct vm_run_options *o, const struct vm_args *args,
                          struct crt_error *err)
{
    if (o->length.given && o->length.value == 0)
        return crt_fail(err, "--for: nothing happens in no time; give a time above zero");
    if (o->tour && (args->count || o->headless))
        return crt_fail(err, "--tour goes through programs in a window; leave out %s",
                        args->count ? "FILE" : "--headless");
    return vm_input_check(&o->input, err) && check_versus(o, err);
}

int vm_run_check(struct vm_run_options *o, const struct vm_args *args, struct crt_error *err)
{
    if (!goes_together(o, args, err))
        return VM_EXIT_USAGE;
    if (!o->tour) {
        o->path = vm_roms_program(&o->roms, args->count ? args->item[0] : NULL, o->monitor,
                                  sizeof o->monitor, err);
        if (!o->path)
            return VM_EXIT_TROUBLE;
    }
    int status = vm_saved_check(&o->saved, o->path, &o->input, o->record, err);
    if (!status && o->record && !vm_out_check(o->record, err))
        status = VM_EXIT_TROUBLE;
    if (!status && !second_side(o, err))
        status = VM_EXIT_USAGE;
    return status;
}

int vm_run_show(const struct vm_run_options *o, struct vm_show_desc *desc, struct crt_error *err)
{
    uint64_t shutter = 0;
    int status = check_side(o, 0, &shutter, err);
    if (!status && o->versus)
        status = check_side(o, 1, &shutter, err);
    *desc = (struct vm_show_desc){.path = o->path,
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
    return status;
}

void vm_run_free(struct vm_run_options *o)
{
    vm_versus_free(&o->other);
}
