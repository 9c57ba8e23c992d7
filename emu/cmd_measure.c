/* measure — how fine a picture a tube can show, and why. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "emu/command.h"
#include "emu/json_out.h"
#include "emu/resolution.h"
#include "emu/settings.h"

#define DEFAULT_TUBE "COLOR17"
#define MM_PER_INCH  25.4

struct options {
    const char *tube, *mode;
    struct vm_list tubes, set;
    double current;
    bool csv, json, film;
};

#define ROW(field) offsetof(struct options, field)

static const struct vm_option rows[] = {
    {"tube", 0, VM_OPT_STRING, ROW(tube), "NAME",
     "tube row (list tubes); default " DEFAULT_TUBE ", a raster tube", 0, 0},
    {"tubes", 0, VM_OPT_LIST, ROW(tubes), "FILE.ini", "read more tubes and phosphors", 0, 0},
    {"set", 0, VM_OPT_LIST, ROW(set), "KEY=VALUE", "a figure of the tube row: spot=0.4", 0, 0},
    {"mode", 0, VM_OPT_STRING, ROW(mode), "MODE",
     "of a raster tube, such as 800x600@75; default: the tube's own", 0, 0},
    {"current", 0, VM_OPT_REAL, ROW(current), "0..1",
     "beam current in parts of full, by which the spot grows; default 1", 0, 1},
    {"csv", 0, VM_OPT_FLAG, ROW(csv), "", "print the modulations as CSV", 0, 0},
    {"json", 0, VM_OPT_FLAG, ROW(json), "", "print everything as JSON", 0, 0},
    {"film", 0, VM_OPT_FLAG, ROW(film), "",
     "check the centre on film: gratings drawn by the tube itself", 0, 0},
};

/* What is measured. */
struct subject {
    struct crt_catalogue catalogue;
    struct crt_tube_row row;
    struct ras_timing timing;
    char mode[32];
    struct vm_resolution r;
};

static const char *const places[VM_PLACES] = {"centre", "corner"};
static const char *const directions[VM_DIRECTIONS] = {"across", "up"};

static double tv_lines(const struct subject *s, double f)
{
    return 2 * f * s->row.height.value;
}

static double diagonal_inch(const struct subject *s)
{
    return hypot(s->row.width.value, s->row.height.value) / MM_PER_INCH;
}

static double per_inch(const struct subject *s)
{
    return hypot(s->r.dots_x, s->r.dots_y) / diagonal_inch(s);
}

/* A step of 1, 2 or 5 that takes about ten to the finest grating still seen. */
static double step_of(const struct subject *s)
{
    double about = vm_resolution_limit(&s->r, VM_CENTRE, VM_UP) / 10, decade = 0.001;
    while (10 * decade <= about)
        decade *= 10;
    return about >= 5 * decade ? 5 * decade : about >= 2 * decade ? 2 * decade : decade;
}

static int steps_of(const struct subject *s, double step)
{
    return (int)ceil(vm_resolution_limit(&s->r, VM_CENTRE, VM_UP) / step);
}

/* ---- text ------------------------------------------------------------------------------------ */

static void print_subject(const struct subject *s)
{
    const char *dots = s->row.kind == CRT_RASTER_TUBE ? "dots" : "units";
    printf("%s%s%s: %.4g x %.4g mm, diagonal %.1f inch; %.0f x %.0f %s, %.1f an inch\n",
           s->row.name, s->mode[0] ? " in " : "", s->mode, s->row.width.value, s->row.height.value,
           diagonal_inch(s), s->r.dots_x, s->r.dots_y, dots, per_inch(s));
}

static void print_spots(const struct subject *s, const char *where, double sigma)
{
    double w = vm_resolution_width60(sigma);
    printf("  %-28s %.3f mm  %5.0f x %.0f\n", where, w, floor(s->row.width.value / w),
           floor(s->row.height.value / w));
}

static void print_limits(const struct subject *s)
{
    printf("\nFinest gratings, %.0f %% of modulation left:\n", 100 * VM_LEAST_MODULATION);
    for (int d = 0; d < VM_DIRECTIONS; d++)
        for (int p = 0; p < VM_PLACES; p++) {
            double f = vm_resolution_limit(&s->r, (enum vm_place)p, (enum vm_direction)d);
            printf("  %-6s %-28s %6.3f lp/mm  %5.0f TV lines\n", directions[d], places[p], f,
                   tv_lines(s, f));
        }
    for (int d = 0; d < VM_DIRECTIONS; d++) {
        double mode = vm_resolution_mode_limit(&s->r, (enum vm_direction)d);
        double mask = vm_resolution_mask_limit(&s->row, (enum vm_direction)d);
        printf("  %-6s %-28s %6.3f lp/mm  %5.0f TV lines\n", directions[d],
               s->row.kind == CRT_RASTER_TUBE ? "addressed by the mode" : "addressed by units",
               mode, tv_lines(s, mode));
        if (mask > 0)
            printf("  %-6s %-28s %6.3f lp/mm  %5.0f TV lines\n", directions[d],
                   "sampled by the mask", mask, tv_lines(s, mask));
    }
}

static void print_modulations(const struct subject *s)
{
    double step = step_of(s);
    printf("\nModulation left, %%:\n  %7s %9s %9s %9s %9s %9s\n", "", "", "centre", "centre",
           "corner", "corner");
    printf("  %7s %9s %9s %9s %9s %9s\n", "lp/mm", "TV lines", "across", "up", "across", "up");
    for (int i = 1; i <= steps_of(s, step); i++) {
        double f = i * step;
        printf("  %7.4g %9.0f", f, tv_lines(s, f));
        for (int p = 0; p < VM_PLACES; p++)
            for (int d = 0; d < VM_DIRECTIONS; d++)
                printf(" %9.1f",
                       100 * vm_resolution_at(&s->r, (enum vm_place)p, (enum vm_direction)d, f));
        putchar('\n');
    }
}

static void print_text(const struct subject *s)
{
    print_subject(s);
    printf("\nSpots side by side, apart by their width at 60 %% of the peak:\n");
    print_spots(s, "centre, vanishing current", s->r.sigma_least);
    print_spots(s, "centre, current asked for", s->r.sigma[VM_CENTRE]);
    print_spots(s, "corner, current asked for", s->r.sigma[VM_CORNER]);
    print_limits(s);
    print_modulations(s);
}

/* ---- CSV and JSON ---------------------------------------------------------------------------- */

static void print_csv(const struct subject *s)
{
    double step = step_of(s);
    printf("lp_per_mm,tv_lines,centre_across,centre_up,corner_across,corner_up\n");
    for (int i = 1; i <= steps_of(s, step); i++) {
        double f = i * step;
        printf("%.6g,%.6g", f, tv_lines(s, f));
        for (int p = 0; p < VM_PLACES; p++)
            for (int d = 0; d < VM_DIRECTIONS; d++)
                printf(",%.6f", vm_resolution_at(&s->r, (enum vm_place)p, (enum vm_direction)d, f));
        putchar('\n');
    }
}

static void print_number_or_null(double v)
{
    if (v > 0)
        printf("%.6g", v);
    else
        printf("null");
}

static void print_json(const struct subject *s)
{
    printf("{\"tube\": ");
    vm_json_text(stdout, s->row.name);
    printf(", \"mode\": ");
    if (s->mode[0])
        vm_json_text(stdout, s->mode);
    else
        printf("null");
    printf(", \"width_mm\": %.6g, \"height_mm\": %.6g, \"diagonal_inch\": %.6g, \"dots\": [%.0f, "
           "%.0f], \"per_inch\": %.6g, \"least_modulation\": %g",
           s->row.width.value, s->row.height.value, diagonal_inch(s), s->r.dots_x, s->r.dots_y,
           per_inch(s), VM_LEAST_MODULATION);
    printf(", \"width60_mm\": {\"least\": %.6g, \"centre\": %.6g, \"corner\": %.6g}",
           vm_resolution_width60(s->r.sigma_least), vm_resolution_width60(s->r.sigma[VM_CENTRE]),
           vm_resolution_width60(s->r.sigma[VM_CORNER]));
    for (int d = 0; d < VM_DIRECTIONS; d++) {
        enum vm_direction way = (enum vm_direction)d;
        printf(
            ", \"%s_lp_per_mm\": {\"centre\": %.6g, \"corner\": %.6g, \"mode\": %.6g, \"mask\": ",
            directions[d], vm_resolution_limit(&s->r, VM_CENTRE, way),
            vm_resolution_limit(&s->r, VM_CORNER, way), vm_resolution_mode_limit(&s->r, way));
        print_number_or_null(vm_resolution_mask_limit(&s->row, way));
        putchar('}');
    }
    printf(", \"modulation\": [");
    double step = step_of(s);
    for (int i = 1; i <= steps_of(s, step); i++) {
        printf("%s{\"lp_per_mm\": %.6g", i > 1 ? ", " : "", i * step);
        for (int p = 0; p < VM_PLACES; p++)
            for (int d = 0; d < VM_DIRECTIONS; d++)
                printf(", \"%s_%s\": %.6f", places[p], directions[d],
                       vm_resolution_at(&s->r, (enum vm_place)p, (enum vm_direction)d, i * step));
        putchar('}');
    }
    printf("]}\n");
}

/* ---- on film --------------------------------------------------------------------------------- */

static bool print_lines_on_film(const struct subject *s, struct crt_error *err)
{
    double full = s->r.sigma[VM_CENTRE];
    printf("%s, gratings of full-drive lines:\n  %9s %12s %12s\n", s->row.name, "lines/mm",
           "on film, %", "Gaussian, %");
    for (int i = 0; i < 6; i++) {
        double sigmas = 5 - 0.6 * i, f = 1 / (sigmas * full), on_film;
        if (!vm_resolution_on_film(&s->r, VM_ACROSS, f, &on_film, err))
            return false;
        printf("  %9.4g %12.2f %12.2f\n", f, 100 * on_film, 100 * vm_resolution_lines(full, f));
    }
    return true;
}

static bool print_sines_on_film(const struct subject *s, struct crt_error *err)
{
    printf("%s in %s, centre, modulation left, %%:\n  %9s %9s %9s %9s %9s %9s\n", s->row.name,
           s->mode, "", "", "across", "across", "up", "up");
    printf("  %9s %9s %9s %9s %9s %9s\n", "lp/mm", "TV lines", "on film", "figures", "on film",
           "figures");
    double limit = vm_resolution_mode_limit(&s->r, VM_UP);
    for (int i = 1; i <= 6; i++) {
        double f = limit * i / 8; /* nearer to the limit the lines themselves beat with it */
        printf("  %9.4g %9.0f", f, tv_lines(s, f));
        for (int d = 0; d < VM_DIRECTIONS; d++) {
            double on_film;
            if (!vm_resolution_on_film(&s->r, (enum vm_direction)d, f, &on_film, err))
                return false;
            printf(" %9.2f %9.2f", 100 * on_film,
                   100 * vm_resolution_at(&s->r, VM_CENTRE, (enum vm_direction)d, f));
        }
        putchar('\n');
    }
    return true;
}

static bool print_film(const struct subject *s, struct crt_error *err)
{
    return s->row.kind == CRT_RASTER_TUBE ? print_sines_on_film(s, err)
                                          : print_lines_on_film(s, err);
}

/* ---- the command ----------------------------------------------------------------------------- */

static bool set_figure(struct crt_tube_row *row, const char *item, struct crt_error *err)
{
    char name[40];
    const char *unit = "", *text = strchr(item, '=');
    size_t n = text ? (size_t)(text - item) : 0;
    struct crt_error why;
    double value;
    if (!text || n == 0 || n >= sizeof name)
        return crt_fail(err, "--set: '%.60s' is not KEY=VALUE, such as spot=0.4", item);
    memcpy(name, item, n);
    name[n] = '\0';
    struct crt_figure *figure = crt_tube_figure(row, name, &unit);
    if (!figure)
        return crt_fail(
            err, "--set: a tube has no '%s'; kinescope list tubes --why names the figures", name);
    if (!vm_figure_value(text + 1, unit, &value, &why))
        return crt_fail(err, "--set: %.300s", why.text);
    *figure = (struct crt_figure){value, value, value, "set on the command line"};
    return crt_tube_check_figure(row, name, err);
}

static bool take_mode(const struct options *o, struct subject *s, struct crt_error *err)
{
    const char *mode = o->mode ? o->mode : s->row.mode;
    if (s->row.kind != CRT_RASTER_TUBE) {
        if (o->mode)
            return crt_fail(err, "%s is a vector tube; --mode is for raster tubes", s->row.name);
        return true;
    }
    struct ras_monitor monitor = ras_monitor_of(&s->row);
    if (!ras_mode_parse(mode, &s->timing, err) ||
        !ras_monitor_follows(&monitor, &s->timing, s->row.name, err))
        return false;
    ras_timing_name(&s->timing, s->mode, sizeof s->mode);
    return true;
}

static bool find_tube(const struct options *o, struct subject *s, struct crt_error *err)
{
    const char *name = o->tube ? o->tube : DEFAULT_TUBE;
    const struct crt_tube_row *row = crt_catalogue_tube(&s->catalogue, name);
    if (!row)
        return crt_fail(err, "there is no tube called '%.60s'; kinescope list tubes names them",
                        name);
    s->row = *row;
    for (int i = 0; i < o->set.count; i++)
        if (!set_figure(&s->row, o->set.item[i], err))
            return false;
    if (!crt_tube_check(&s->row, err) || !take_mode(o, s, err))
        return false;
    vm_resolution_init(&s->r, &s->row, s->mode[0] ? &s->timing : NULL, o->current);
    return true;
}

static int measure(const struct options *o, struct subject *s, struct crt_error *err)
{
    for (int i = 0; i < o->tubes.count; i++)
        if (!crt_catalogue_load(&s->catalogue, o->tubes.item[i], err))
            return VM_EXIT_TROUBLE;
    if (!find_tube(o, s, err))
        return VM_EXIT_USAGE;
    if (o->film)
        return print_film(s, err) ? VM_EXIT_OK : VM_EXIT_TROUBLE;
    if (o->json)
        print_json(s);
    else if (o->csv)
        print_csv(s);
    else
        print_text(s);
    return VM_EXIT_OK;
}

static int run(int argc, char **argv)
{
    struct options o = {.current = 1};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct subject s = {.mode = ""};
    struct vm_args args;
    struct crt_error err;
    int status = vm_command_parse(&vm_command_measure, tables, 1, argc, argv, &args, 1, 1);
    if (status >= 0)
        return status;
    if (strcmp(args.item[0], "resolution") != 0) {
        crt_fail(&err, "'%.60s' cannot be measured; give resolution", args.item[0]);
        return vm_command_fail(&vm_command_measure, VM_EXIT_USAGE, &err);
    }
    if (o.csv + o.json + o.film > 1) {
        crt_fail(&err, "--csv, --json and --film exclude each other");
        return vm_command_fail(&vm_command_measure, VM_EXIT_USAGE, &err);
    }
    if (!crt_catalogue_init(&s.catalogue, &err))
        return vm_command_fail(&vm_command_measure, VM_EXIT_TROUBLE, &err);
    status = measure(&o, &s, &err);
    crt_catalogue_free(&s.catalogue);
    return status == VM_EXIT_OK ? status : vm_command_fail(&vm_command_measure, status, &err);
}

const struct vm_command vm_command_measure = {
    "measure",
    "resolution [--tube T] [--mode M]",
    "Measure what a tube can resolve, and what limits it",
    "Modulation of gratings against line pairs a millimetre and TV lines, in the centre and in the "
    "corner: spot, video amplifier, mask and mode; how many spots fit side by side; dots an inch.",
    "  kinescope measure resolution\n"
    "  kinescope measure resolution --tube SLOT14 --mode 800x600@60\n"
    "  kinescope measure resolution --tube TV12M --set bandwidth=3 --csv\n"
    "  kinescope measure resolution --tube VR17 --film\n"
    "  kinescope measure resolution --set spot_growth=0 --film",
    run,
};
