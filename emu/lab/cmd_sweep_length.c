/* sweep length — how long a display list may grow on a vector tube before it flickers. */
#include <stdlib.h>
#include <string.h>

#include "emu/lab/sweep.h"
#include "emu/lab/sweep_length.h"
#include "emu/lab/sweep_out.h"
#include "emu/out_file.h"

#define DEFAULT_FIELD "30"

struct options {
    struct vm_settings_options settings;
    const char *field, *of, *length, *write;
    double pupil, luminance;
    long items;
    bool held, sync;
    struct vm_sweep_out out;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"tube", 0, VM_OPT_LIST, ROW(settings.tube), "NAME",
     "vector tube, or TUBE/PHOSPHOR (list tubes); default: what the program says, else VR17", 0, 0},
    {"phosphor", 0, VM_OPT_STRING, ROW(settings.phosphor), "NAME",
     "phosphor instead of the tube's own (list phosphors)", 0, 0},
    {"tubes", 0, VM_OPT_LIST, ROW(settings.tubes), "FILE.ini", "read more tubes and phosphors", 0,
     0},
    {"set", 0, VM_OPT_LIST, ROW(settings.set), "KEY=VALUE",
     "a figure of the tube row: vector_unit=50ns; dpu.average=33.33us; memory=16K", 0, 0},
    {"refresh", 0, VM_OPT_RATE, ROW(settings.refresh), "HZ",
     "rate of the sync tick instead of the tube's", 0, 0},
    {"luminance", 0, VM_OPT_REAL, ROW(luminance), "CD",
     "mean luminance in cd/m2 at the tube's line_refresh; default the tube's line_luminance", 0.001,
     100000},
    {"held", 0, VM_OPT_FLAG, ROW(held), "",
     "the brightness is turned up as the rate falls: the luminance is the same at every rate", 0,
     0},
    {"field", 0, VM_OPT_CHOICE, ROW(field), "10|30|50|70",
     "degrees that the lit field takes up; default " DEFAULT_FIELD, 0, 0},
    {"pupil", 0, VM_OPT_REAL, ROW(pupil), "MM", "diameter of the pupil; default 3", 1, 9},
    {"of", 0, VM_OPT_CHOICE, ROW(of), VM_LIST_NAMES,
     "what the list that grows is made of; default vectors", 0, 0},
    {"length", 0, VM_OPT_STRING, ROW(length), "N|NUMBERmm",
     "of vectors, and the distance of points, in units or mm; default 100 (short vectors 40)", 0,
     0},
    {"write", 0, VM_OPT_STRING, ROW(write), "FILE.df",
     "write such a list as a program, to see it: the longest that does not flicker", 0, 0},
    {"items", 0, VM_OPT_INTEGER, ROW(items), "N", "with --write: of so many items instead", 1,
     1000000},
    {"sync", 0, VM_OPT_FLAG, ROW(sync), "", "with --write: locked to the tick", 0, 0},
    VM_SWEEP_OUT_ROWS(ROW(out)),
};

static const struct vm_command *const self = &vm_command_sweep_length;

/* ---- what is asked ------------------------------------------------------------------------------ */

static enum vm_list_kind kind_of(const char *name)
{
    static const char *const names[VM_LIST_KINDS] = {"vectors", "short", "points", "characters"};
    int kind = 0;
    for (int i = 0; i < VM_LIST_KINDS; i++)
        if (name && strcmp(name, names[i]) == 0)
            kind = i;
    return (enum vm_list_kind)kind;
}

/* Units, or millimetres of the tube. */
static bool take_units(const char *text, const struct crt_tube_row *row, int *units,
                       struct crt_error *err)
{
    size_t n = strlen(text);
    char number[32];
    struct crt_error why;
    double value, most = row->units_x.value - 1, pitch = row->width.value / row->units_x.value;
    bool mm = n > 2 && n < sizeof number && strcmp(text + n - 2, "mm") == 0;
    snprintf(number, sizeof number, "%.*s", mm ? (int)n - 2 : 31, text);
    if (!vm_parse_real(number, 0, 1e6, &value, &why))
        return crt_fail(err, "--length: %.300s", why.text);
    value = mm ? value / pitch : value;
    *units = (int)(value + 0.5);
    if (value >= 0.5 && value <= most)
        return true;
    return crt_fail(err, "--length: %s is out of range on %s; give 1 to %.0f units, %.3g to %.4gmm",
                    text, row->name, most, pitch, most * pitch);
}

static bool take_lengths(const struct options *o, struct vm_length *l, struct crt_error *err)
{
    int units = 0;
    l->units[VM_LIST_VECTORS] = l->units[VM_LIST_POINTS] = l->units[VM_LIST_CHARACTERS] = 100;
    l->units[VM_LIST_SHORT] = 40;
    if (!o->length)
        return true;
    if (!take_units(o->length, &l->settings->monitor[VM_VECTOR].row, &units, err))
        return false;
    for (int k = 0; k < VM_LIST_KINDS; k++)
        l->units[k] = units;
    struct vm_list_shape s = vm_length_shape(l, l->kind, false);
    return s.units == units ||
           crt_fail(err, "--length: a short vector has at most %d units", s.units);
}

static bool take_steady(const struct options *o, struct vm_length *l, struct crt_error *err)
{
    const struct vm_monitor *m = &l->settings->monitor[VM_VECTOR];
    struct vm_sweep field;
    if (l->settings->main == VM_RASTER)
        return crt_fail(
            err,
            "%s is a raster tube, whose refresh rate is its mode's (list modes); give a "
            "vector tube",
            l->settings->monitor[VM_RASTER].row.name);
    vm_sweep_take_field(&field, o->field ? o->field : DEFAULT_FIELD);
    l->steady = (struct vm_steady){
        .viewer = {field.field[0], o->pupil},
        .glow = crt_glow_of(&m->phosphor),
        .cd_m2 = o->luminance > 0 ? o->luminance : m->row.line_luminance.value,
        .at_hz = m->row.line_refresh.value,
        .held = o->held,
        .tick = l->settings->tick,
    };
    vm_steady_find(&l->steady);
    return true;
}

static void take_timing(struct vm_length *l)
{
    for (int t = 0; t < VM_TIMINGS; t++) {
        l->timing[t] =
            df_timing_of_tube(&l->settings->monitor[VM_VECTOR].row, (enum df_timing_choice)t);
        l->timing[t].average_ps = l->settings->average_ps;
    }
}

/* ---- what is put out ---------------------------------------------------------------------------- */

static int write_list(const struct options *o, const struct vm_length *l, struct crt_error *err)
{
    struct vm_list_shape s = vm_length_shape(l, l->kind, o->sync);
    struct vm_longest longest = vm_length_longest(l, l->kind);
    uint32_t bytes = l->settings->memory_bytes;
    long most = vm_list_most(&s, bytes);
    long items = o->items ? o->items : (o->sync ? longest.locked : longest.free)[DF_TIMING_VALUE];
    struct vm_out file;
    char tube[48];
    if (items == 0) {
        crt_fail(err, "--write: even the shortest list flickers; --items N writes one that does");
        return VM_EXIT_USAGE;
    }
    if (items > most) {
        crt_fail(err, "--items: at most %ld of them fit into %u KiB", most, bytes / 1024);
        return VM_EXIT_USAGE;
    }
    if (!vm_out_open(&file, o->write, err))
        return VM_EXIT_TROUBLE;
    snprintf(tube, sizeof tube, "%s/%s", l->settings->monitor[VM_VECTOR].row.name,
             l->settings->monitor[VM_VECTOR].phosphor.name);
    vm_list_write(file.file, &s, items, tube);
    return vm_out_close(&file, true, err) ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}

static void put_text(FILE *to, const void *l)
{
    vm_length_print(to, l);
}

static void put_csv(FILE *to, const void *l)
{
    vm_length_print_csv(to, l);
}

static bool draw(const void *l, struct vm_size size, enum vm_plot_style style,
                 struct crt_image *image, struct crt_error *err)
{
    return vm_length_draw(l, size, style, image, err);
}

static int put(const struct options *o, const struct vm_length *l, struct crt_error *err)
{
    struct vm_sweep_forms forms = {l, put_text, put_csv, draw, vm_plot_size};
    int status = o->write ? write_list(o, l, err) : VM_EXIT_OK;
    if (status || vm_out_is_stdout(o->write))
        return status;
    return vm_sweep_out_put(&o->out, &forms, err);
}

/* ---- the command -------------------------------------------------------------------------------- */

static int sweep(const struct options *o, const struct vm_input *input, struct crt_error *err)
{
    struct vm_settings settings;
    struct vm_length l = {.settings = &settings, .kind = kind_of(o->of)};
    int status = vm_settings_resolve(&o->settings, NULL, input ? vm_input_tube(input) : NULL,
                                     &settings, err);
    if (!status && (!take_steady(o, &l, err) || !take_lengths(o, &l, err)))
        status = VM_EXIT_USAGE;
    if (!status) {
        take_timing(&l);
        if (input && !vm_length_measure(&l, input, err))
            status = VM_EXIT_TROUBLE;
    }
    if (!status)
        status = put(o, &l, err);
    vm_settings_free(&settings);
    return status;
}

static int sweep_file(const struct options *o, const char *path, struct crt_error *err)
{
    static const struct vm_input_options none;
    struct vm_input input = {0};
    if (!vm_command_load(&input, path, &none, err))
        return VM_EXIT_TROUBLE;
    int status = VM_EXIT_USAGE;
    if (input.is_recording)
        crt_fail(err, "%s is a recording, which does not grow; give a program", input.name);
    else
        status = sweep(o, &input, err);
    vm_input_free(&input);
    return status;
}

static int check(const struct options *o, const char *path, struct crt_error *err)
{
    int status = vm_sweep_out_check(&o->out, err);
    if (status)
        return status;
    if ((o->items || o->sync) && !o->write)
        crt_fail(err, "--%s is for --write", o->sync ? "sync" : "items");
    else if (path && (o->of || o->length || o->write))
        crt_fail(err, "--%s is for lists of equal items; leave it out, or the program",
                 o->of       ? "of"
                 : o->length ? "length"
                             : "write");
    else if (vm_out_is_stdout(o->write) && vm_out_is_stdout(o->out.csv))
        crt_fail(err, "--write and --csv cannot both go to standard output");
    else
        return VM_EXIT_OK;
    return VM_EXIT_USAGE;
}

static int run(int argc, char **argv)
{
    struct options o = {.pupil = VM_SWEEP_PUPIL_MM};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    struct crt_error err = {""};
    int status = vm_command_parse(self, tables, 1, argc, argv, &args, 0, 1);
    if (status >= 0)
        return status;
    const char *path = args.count ? args.item[0] : NULL;
    status = check(&o, path, &err);
    if (!status)
        status = path ? sweep_file(&o, path, &err) : sweep(&o, NULL, &err);
    return status && err.text[0] ? vm_command_fail(self, status, &err) : status;
}

const struct vm_command vm_command_sweep_length = {
    "sweep length",
    "[FILE] [--tube T] [--of KIND]",
    "Tell how long a display list may grow on a vector tube before it flickers",
    "The longer the list, the longer a refresh takes. From the tube's own times, for lists of "
    "equal items: "
    "vectors, short vectors, points, characters; running freely, and locked to the sync tick, "
    "where the "
    "rate falls in steps. With FILE, a program: how many times as much of it could be shown.",
    "  kinescope sweep length\n"
    "  kinescope sweep length --tube LAB31 --field 50 --length 40mm\n"
    "  kinescope sweep length --of characters -o characters.png\n"
    "  kinescope sweep length roms/rose.df\n"
    "  kinescope sweep length --set dpu.average=33.33us\n"
    "  kinescope sweep length --write longest.df --sync; kinescope run longest.df",
    run,
};
