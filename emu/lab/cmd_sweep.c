/* sweep — which phosphor at which refresh rate flickers, and for whom; how long a list may grow before it
 * does (cmd_sweep_length.c). */
#include <stdio.h>
#include <string.h>

#include "emu/command.h"
#include "emu/lab/sweep.h"
#include "emu/lab/sweep_length.h"
#include "emu/lab/sweep_out.h"

struct options {
    const char *phosphors, *rates, *luminances, *field, *sort;
    double pupil;
    struct vm_list tubes;
    struct vm_sweep_out out;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"phosphors", 0, VM_OPT_STRING, ROW(phosphors), "P1,P31,...",
     "which; default all (list phosphors)", 0, 0},
    {"rates", 0, VM_OPT_STRING, ROW(rates), "HZ,HZ,...", "refresh rates; default 30,40,50,60,75", 0,
     0},
    {"luminances", 0, VM_OPT_STRING, ROW(luminances), "CD,CD,...",
     "mean luminances in cd/m2; default 100", 0, 0},
    {"field", 0, VM_OPT_CHOICE, ROW(field), "10|30|50|70|all",
     "degrees that the lit field takes up; default all, which says who sees flicker; one of them "
     "also tells by how much",
     0, 0},
    {"sort", 0, VM_OPT_CHOICE, ROW(sort), "name|cff",
     "phosphors as the list has them (default), or by CFF: those that flicker least first", 0, 0},
    {"pupil", 0, VM_OPT_REAL, ROW(pupil), "MM", "diameter of the pupil; default 3", 1, 9},
    {"tubes", 0, VM_OPT_LIST, ROW(tubes), "FILE.ini", "read more phosphors", 0, 0},
    VM_SWEEP_OUT_ROWS(ROW(out)),
};

static int fill(struct vm_sweep *s, const struct options *o, struct crt_catalogue *c,
                struct crt_error *err)
{
    s->pupil_mm = o->pupil;
    vm_sweep_take_field(s, o->field);
    for (int i = 0; i < o->tubes.count; i++)
        if (!crt_catalogue_load(c, o->tubes.item[i], err))
            return VM_EXIT_TROUBLE;
    if (!vm_sweep_take_phosphors(s, c, o->phosphors, err) ||
        !vm_sweep_take_rates(s, o->rates, err) || !vm_sweep_take_luminances(s, o->luminances, err))
        return VM_EXIT_USAGE;
    if (o->sort && strcmp(o->sort, "cff") == 0)
        vm_sweep_sort(s);
    return VM_EXIT_OK;
}

/* ---- the three forms ---------------------------------------------------------------------------- */

static void put_text(FILE *to, const void *s)
{
    vm_sweep_print(to, s);
}

static void put_csv(FILE *to, const void *s)
{
    vm_sweep_print_csv(to, s);
}

static bool draw(const void *s, struct vm_size size, enum vm_plot_style style,
                 struct crt_image *image, struct crt_error *err)
{
    return vm_sweep_draw(s, size, style, image, err);
}

static int put(const struct vm_sweep *s, const struct vm_sweep_out *out, struct crt_error *err)
{
    struct vm_sweep_forms forms = {s, put_text, put_csv, draw, vm_sweep_size(s, out->projector)};
    return vm_sweep_out_put(out, &forms, err);
}

static int run(int argc, char **argv)
{
    if (argc > 0 && strcmp(argv[0], "length") == 0)
        return vm_command_sweep_length.run(argc - 1, argv + 1);
    struct options o = {.pupil = VM_SWEEP_PUPIL_MM};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    struct crt_error err;
    struct crt_catalogue catalogue;
    struct vm_sweep s = {0};
    int status = vm_command_parse(&vm_command_sweep, tables, 1, argc, argv, &args, 0, 1);
    if (status >= 0)
        return status;
    if (args.count > 0) {
        crt_fail(&err, "'%.60s' cannot be swept; give options only, or length first", args.item[0]);
        return vm_command_fail(&vm_command_sweep, VM_EXIT_USAGE, &err);
    }
    status = vm_sweep_out_check(&o.out, &err);
    if (!status && !crt_catalogue_init(&catalogue, &err))
        status = VM_EXIT_TROUBLE;
    if (status)
        return vm_command_fail(&vm_command_sweep, status, &err);
    status = fill(&s, &o, &catalogue, &err);
    if (!status)
        status = put(&s, &o.out, &err);
    crt_catalogue_free(&catalogue);
    return status ? vm_command_fail(&vm_command_sweep, status, &err) : status;
}

const struct vm_command vm_command_sweep = {
    "sweep",
    "[length] [--phosphors P1,P31]",
    "Tabulate which phosphor flickers at which refresh rate",
    "For every phosphor, refresh rate and luminance: whose eyes see flicker, by how much, and up "
    "to which "
    "luminance nobody does. kinescope sweep length --help: how long a display list may grow on a "
    "vector "
    "tube before it flickers.",
    "  kinescope sweep\n"
    "  kinescope sweep --field 30 --phosphors P1,P31,P39\n"
    "  kinescope sweep --phosphors P39 --luminances 1,3,10,30,100,300 --rates 30,40,50,60\n"
    "  kinescope sweep --field 30 --sort cff -o flicker.png --csv flicker.csv\n"
    "  kinescope sweep length --tube VR17",
    run,
};
