/* why — what put the light there: deposits still glowing at a place, and who drew them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/command.h"
#include "emu/lab/why_text.h"
#include "emu/moment.h"
#include "emu/roms.h"
#include "emu/saved.h"
#include "emu/program_settings.h"
#include "emu/trouble.h"
#include "emu/view.h"

#define COLUMNS       100
#define LEAST_PERCENT 0.01
#define MAX_FILE      (UINT64_C(64) << 20)

struct options {
    const char *at, *order, *symbols;
    bool all, json;
    double least;
    struct vm_moment_options moment; /* its `at` is --time */
    struct vm_saved_options saved;
    struct vm_roms_options roms;
    struct vm_settings_options settings;
    struct vm_input_options input;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"at", 0, VM_OPT_STRING, ROW(at), "X,Y",
     "the place, in head units: of the vector head from the bottom left, of the raster head dots "
     "from "
     "the top left",
     0, 0},
    {"time", 0, VM_OPT_TIME, ROW(moment.at), "T",
     "when one looks: 16.7ms, 0.5s, 3f (sync ticks); default: when capture would", 0, 0},
    {"when", 0, VM_OPT_STRING, ROW(moment.when), "EVENT",
     "or at an event, as of capture: stop:N, refresh:N, mark:N, console:TEXT", 0, 0},
    {"timeout", 0, VM_OPT_TIME, ROW(moment.timeout), "T",
     "give up, with status 3, when --when has not come by then; default 60s", 0, 0},
    {"all", 0, VM_OPT_FLAG, ROW(all), "",
     "list every deposit by itself, not all of a source line, word or scan line together", 0, 0},
    {"least", 0, VM_OPT_REAL, ROW(least), "PERCENT",
     "sum up what gives less than this part of the light in one line; default 0.01; what gives "
     "less than "
     "1e-5 has faded, and is never listed",
     0, 100},
    {"order", 0, VM_OPT_CHOICE, ROW(order), "share|time",
     "the largest share first (default), or the latest", 0, 0},
    {"symbols", 0, VM_OPT_STRING, ROW(symbols), "FILE.elf",
     "the same firmware with its symbols and line tables, when FILE was stripped of them", 0, 0},
    {"json", 0, VM_OPT_FLAG, ROW(json), "", "print everything as JSON", 0, 0},
    {"load-state", 0, VM_OPT_STRING, ROW(saved.load), "FILE",
     "go on from the machine in FILE, made with the same program and tube: light from before is "
     "told "
     "apart from the rest, as older",
     0, 0},
};

/* Everything that an answer needs. */
struct asking {
    struct options o;
    struct vm_input input;
    struct vm_settings settings;
    const char *path;
    double x, y;
    /* --symbols */
    char *symbols;
    struct vm_elf elf;
    struct vm_source_lines *lines;
};

static int fail(int status, const struct crt_error *err)
{
    return vm_command_fail(&vm_command_why, status, err);
}

/* ---- options --------------------------------------------------------------------------------- */

static bool take_place(struct asking *a, struct crt_error *err)
{
    struct crt_error why;
    if (!a->o.at)
        return crt_fail(err, "no place is given: --at X,Y, such as --at 512,300");
    return vm_parse_place(a->o.at, &a->x, &a->y, &why) || crt_fail(err, "--at: %.400s", why.text);
}

static bool take_symbols(struct asking *a, struct crt_error *err)
{
    char name[64];
    size_t size;
    if (!a->o.symbols) {
        if (a->input.has_firmware)
            a->lines = vm_source_lines_open((const uint8_t *)a->input.image, a->input.image_size);
        return true;
    }
    if (!a->input.has_firmware)
        return crt_fail(err, "--symbols is for firmware, and %s has none", a->input.name);
    a->symbols = vm_read_file(a->o.symbols, "program", MAX_FILE, &size, err);
    if (!a->symbols)
        return false;
    vm_base_name(a->o.symbols, name, sizeof name);
    if (!vm_elf_parse(&a->elf, name, (const uint8_t *)a->symbols, size, err))
        return false;
    a->lines = vm_source_lines_open((const uint8_t *)a->symbols, size);
    return true;
}

static struct vm_why_names names_of(const struct asking *a)
{
    struct vm_why_names names = vm_why_names_of(&a->input, a->lines);
    if (a->symbols)
        names.elf = &a->elf;
    return names;
}

/* ---- when, and of which head ----------------------------------------------------------------- */

static bool choose_head(struct asking *a, const struct vm_machine *m, enum vm_head *head,
                        struct crt_error *err)
{
    enum vm_view view = vm_view_now(a->settings.view, m);
    bool vector = vm_machine_uses_vector(m), raster = vm_machine_uses_raster(m);
    if (view == VM_VIEW_BOTH)
        return crt_fail(err, "%s uses both heads; give --view vector or --view raster",
                        a->input.name);
    *head = view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
    if (*head == VM_VECTOR && !vector && raster)
        return crt_fail(err, "%s draws on the raster head alone by then; give --view raster",
                        a->input.name);
    return *head == VM_VECTOR || raster ||
           crt_fail(err, "%s has not switched the raster head on by then; choose a later time",
                    a->input.name);
}

/* What never lit the beam leaves nothing to explain; of other trouble one may ask what it left. */
static int judge(struct asking *a, struct vm_machine *m, struct crt_error *err)
{
    struct crt_error trouble;
    switch (vm_find_trouble(m, &a->input, &trouble)) {
    case VM_NO_TROUBLE:
        return VM_EXIT_OK;
    case VM_TROUBLE_DARK:
        *err = trouble;
        return VM_EXIT_TROUBLE;
    default:
        fprintf(stderr, "kinescope why: %s\n", trouble.text);
        return VM_EXIT_OK;
    }
}

static bool on_the_glass(const struct asking *a, const struct vm_why_place *place,
                         struct crt_error *err)
{
    const struct crt_tube_row *row = &a->settings.monitor[place->head].row;
    return (fabs(place->x_mm) <= row->width.value / 2 + row->border.value &&
            fabs(place->y_mm) <= row->height.value / 2 + row->border.value) ||
           crt_fail(err, "the place %g,%g is beside the screen: %.0f, %.0f mm from its middle",
                    a->x, a->y, place->x_mm, place->y_mm);
}

/* Runs the program in the dark to the moment. */
static int plan(struct asking *a, struct vm_why_place *place, uint64_t *t, struct crt_error *err)
{
    struct vm_rig rig;
    enum vm_head head = VM_VECTOR;
    int status = VM_EXIT_TROUBLE;
    if (!vm_rig_open(&rig, &a->settings, &a->input, DF_TIMING_VALUE, NULL, err))
        return status;
    if (vm_saved_load(&a->o.saved, &rig, &a->settings, &a->input, err)) {
        status = vm_moment_find(&rig, &a->o.moment, &a->settings, &a->input, t, err);
        if (status == VM_EXIT_OK && !choose_head(a, rig.machine, &head, err))
            status = VM_EXIT_USAGE;
        if (status == VM_EXIT_OK)
            status = judge(a, rig.machine, err);
        if (status == VM_EXIT_OK)
            *place = vm_why_at(rig.machine, head, a->x, a->y);
        if (status == VM_EXIT_OK && !on_the_glass(a, place, err))
            status = VM_EXIT_TROUBLE;
    }
    vm_rig_close(&rig);
    return status;
}

/* ---- the answer ------------------------------------------------------------------------------ */

static void print_line(void *ctx, const char *line)
{
    fprintf(ctx, "%s\n", line);
}

static void print(const struct asking *a, const struct vm_why *why)
{
    const struct vm_why_text text = {.names = names_of(a),
                                     .columns = COLUMNS,
                                     .all = a->o.all,
                                     .by_time = strcmp(a->o.order, "time") == 0,
                                     .least = a->o.least / 100};
    if (a->o.json)
        vm_why_json(stdout, why, &text);
    else
        vm_why_lines(why, &text, print_line, stdout);
}

static int ask(struct asking *a, struct crt_error *err)
{
    struct vm_why_desc desc = {&a->settings, &a->input, {0}};
    struct vm_why why;
    uint64_t t = 0;
    if (!take_symbols(a, err))
        return VM_EXIT_TROUBLE;
    int status = plan(a, &desc.place, &t, err);
    if (status == VM_EXIT_OK)
        status = vm_why_run(&why, &desc, &a->o.saved, t, err);
    if (status != VM_EXIT_OK)
        return status;
    print(a, &why);
    vm_why_free(&why);
    return VM_EXIT_OK;
}

static int answer(struct asking *a)
{
    struct crt_error err;
    int status = vm_program_settings(&a->o.settings, &a->input, &a->settings, &err);
    if (status == VM_EXIT_OK)
        status = ask(a, &err);
    vm_settings_free(&a->settings);
    vm_source_lines_free(a->lines);
    vm_elf_free(&a->elf);
    free(a->symbols);
    return status ? fail(status, &err) : status;
}

static int run(int argc, char **argv)
{
    struct asking a = {.o = {.order = "share", .least = LEAST_PERCENT}};
    const struct vm_option_table tables[] = {
        VM_OPTION_TABLE(rows, &a.o), VM_OPTION_TABLE(vm_settings_rows, &a.o.settings),
        VM_OPTION_TABLE(vm_input_rows, &a.o.input), VM_OPTION_TABLE(vm_roms_rows, &a.o.roms)};
    struct vm_args args;
    struct crt_error err;
    char monitor[4096 + 16];
    int status = vm_command_parse(&vm_command_why, tables, sizeof tables / sizeof *tables, argc,
                                  argv, &args, 0, 1);
    if (status >= 0)
        return status;
    a.path =
        vm_roms_program(&a.o.roms, args.count ? args.item[0] : NULL, monitor, sizeof monitor, &err);
    if (!a.path)
        return fail(VM_EXIT_TROUBLE, &err);
    if (!take_place(&a, &err) || !vm_input_check(&a.o.input, &err))
        return fail(VM_EXIT_USAGE, &err);
    if (!vm_command_load(&a.input, a.path, &a.o.input, &err))
        return fail(VM_EXIT_TROUBLE, &err);
    status = answer(&a);
    vm_input_free(&a.input);
    return status;
}

const struct vm_command vm_command_why = {
    "why",
    "[FILE] --at X,Y [--time T]",
    "Say what put the light there that a place on the screen shows",
    "Lists what still glows there: its share of the light, when it was drawn, how strong, and by "
    "what: on the "
    "vector head the display word with its line of source, on the raster head the scan line and "
    "its dots; "
    "and with firmware the store that wrote them, with symbol and line of source where FILE (or "
    "--symbols) has them. The machine is run from power-on with a photodiode at that place, and a "
    "record "
    "of who has stored each byte. In the dark it says what came nearest.",
    "  kinescope why roms/rose.df --at 512,690\n"
    "  kinescope why roms/radar.df --at 700,512 --time 2.5s --order time\n"
    "  kinescope why roms/pattern.elf --at 512,300\n"
    "  kinescope why roms/sketch.elf --input roms/sketch.script --at 300,200 --time 5s --json",
    run,
};
