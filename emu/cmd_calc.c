/* calc — the arithmetic of displays: refresh rates, refresh buffers, display lists, resolution; each with
 * its formula and the numbers put in. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/command.h"
#include "raster/mode.h"

enum {
    LINE_RATE,
    LINES,
    OVERHEAD,
    SIZE,
    INCHES,
    DPI,
    BITS,
    RATE,
    INSTRUCTION,
    REFRESH,
    DIAGONAL,
    OPTIONS
};

struct options {
    const char *text[OPTIONS]; /* as typed; NULL: not given */
    bool json;
};

#define TEXT(name, option, value, help)                                                            \
    [option] = {name, 0, VM_OPT_STRING, offsetof(struct options, text[option]), value, help, 0, 0}

static const struct vm_option rows[] = {
    TEXT("line-rate", LINE_RATE, "F", "lines a second, with Hz or kHz: 96kHz"),
    TEXT("lines", LINES, "N", "lines of the picture"),
    TEXT("overhead", OVERHEAD, "P", "time the beam takes to return, of a refresh; default 5%"),
    TEXT("size", SIZE, "WxH", "pixels: 1024x768"),
    TEXT("inches", INCHES, "WxH", "the screen in inches: 8x10"),
    TEXT("dpi", DPI, "N", "pixels an inch"),
    TEXT("bits", BITS, "N", "bits a pixel, 1 to 64"),
    TEXT("rate", RATE, "R", "bits a second"),
    TEXT("instruction", INSTRUCTION, "T", "mean time of an instruction of the display list"),
    TEXT("refresh", REFRESH, "HZ", "refreshes a second"),
    TEXT("diagonal", DIAGONAL, "D", "of the picture, with in, cm or mm: 17in"),
    [OPTIONS] = {"json", 0, VM_OPT_FLAG, offsetof(struct options, json), "",
                 "print the numbers as JSON", 0, 0},
};

/* ---- what is printed ---------------------------------------------------------------------------- */

#define MAX_LINES   8
#define MAX_FIGURES 12

/* Lines of text, and the same numbers by name. */
struct sheet {
    char line[MAX_LINES][160];
    int lines;
    struct {
        const char *name;
        double value;
    } figure[MAX_FIGURES];
    int figures;
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
say(struct sheet *s, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(s->line[s->lines++], sizeof s->line[0], format, args);
    va_end(args);
}

static void figure(struct sheet *s, const char *name, double value)
{
    s->figure[s->figures].name = name;
    s->figure[s->figures++].value = value;
}

static void print_sheet(const struct sheet *s, bool json)
{
    for (int i = 0; i < s->lines && !json; i++)
        printf("%s\n", s->line[i]);
    for (int i = 0; i < s->figures && json; i++)
        printf("%s\"%s\": %.15g%s", i ? ", " : "{", s->figure[i].name, s->figure[i].value,
               i + 1 < s->figures ? "" : "}\n");
}

/* ---- what is typed ------------------------------------------------------------------------------ */

struct unit {
    const char *name;
    double factor;
};

static const struct unit hertz[] = {{"", 1}, {"Hz", 1}, {"kHz", 1e3}, {"MHz", 1e6}, {NULL, 0}};
static const struct unit share[] = {{"", 1}, {"%", 0.01}, {NULL, 0}};
static const struct unit plain[] = {{"", 1}, {NULL, 0}};
static const struct unit bit_rate[] = {{"", 1},         {"bit/s", 1},    {"kbit/s", 1e3},
                                       {"Mbit/s", 1e6}, {"Gbit/s", 1e9}, {NULL, 0}};
static const struct unit length[] = {{"in", 25.4}, {"mm", 1}, {"cm", 10}, {NULL, 0}};

/* A decimal number with one of the units; what follows it. */
static const char *read_number(const char *text, double *value)
{
    size_t n = strspn(text, "0123456789.");
    char digits[32];
    if (n == 0 || n >= sizeof digits)
        return NULL;
    memcpy(digits, text, n);
    digits[n] = '\0';
    char *end;
    *value = strtod(digits, &end);
    return end == digits || *end ? NULL : text + n;
}

static bool measure(const char *option, const char *text, const struct unit *units, double low,
                    double high, double *value, struct crt_error *err)
{
    const char *unit = read_number(text, value);
    const struct unit *u = units;
    while (unit && u->name && strcmp(u->name, unit) != 0)
        u++;
    if (!unit || !u->name) {
        char names[64] = "";
        for (u = units; u->name; u++)
            snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s",
                     *names ? ", " : "", *u->name ? u->name : "no unit");
        return crt_fail(err, "--%s '%.40s' is not a number with a unit (%s)", option, text, names);
    }
    *value *= u->factor;
    if (!(*value >= low && *value <= high))
        return crt_fail(err, "--%s %.40s is out of range; give %g to %g", option, text,
                        low / u->factor, high / u->factor);
    return true;
}

static bool whole(const char *option, const char *text, long low, long high, long *value,
                  struct crt_error *err)
{
    struct crt_error why;
    return vm_parse_integer(text, low, high, value, &why) ||
           crt_fail(err, "--%s: %s", option, why.text);
}

static bool inches(const char *text, double *w, double *h, struct crt_error *err)
{
    const char *p = read_number(text, w);
    p = p && *p == 'x' ? read_number(p + 1, h) : NULL;
    if (!p || *p || *w <= 0 || *h <= 0 || *w > 1000 || *h > 1000)
        return crt_fail(err, "--inches '%.40s' is not a size; write WIDTHxHEIGHT, such as 8x10",
                        text);
    return true;
}

/* ---- the calculations --------------------------------------------------------------------------- */

static bool calc_refresh(const struct options *o, const char *name, struct sheet *s,
                         struct crt_error *err)
{
    double rate, overhead = 0.05;
    long lines;
    (void)name;
    if (!measure("line-rate", o->text[LINE_RATE], hertz, 1, 1e9, &rate, err) ||
        !whole("lines", o->text[LINES], 1, 1000000, &lines, err) ||
        (o->text[OVERHEAD] &&
         !measure("overhead", o->text[OVERHEAD], share, 0, 0.99, &overhead, err)))
        return false;
    double hz = rate / (double)lines * (1 - overhead);
    say(s, "refresh rate = line rate / lines x (1 - overhead)");
    say(s, "             = %.10g Hz / %ld x %.6g", rate, lines, 1 - overhead);
    say(s, "             = %.2f Hz; rounded down %.0f Hz", hz, floor(hz + 1e-9));
    figure(s, "line_rate_hz", rate);
    figure(s, "lines", (double)lines);
    figure(s, "overhead", overhead);
    figure(s, "refresh_hz", hz);
    figure(s, "refresh_whole_hz", floor(hz + 1e-9)); /* 76.00 may be a hair below 76 */
    return true;
}

/* The pixels of --size, or of --inches and --dpi. */
static bool read_pixels(const struct options *o, struct sheet *s, double *w, double *h,
                        struct crt_error *err)
{
    struct vm_size size;
    double wide, high, dpi;
    bool by_size = o->text[SIZE], by_inches = o->text[INCHES] && o->text[DPI];
    if (by_size == by_inches || (by_size && (o->text[INCHES] || o->text[DPI])))
        return crt_fail(err, "give either --size WxH, or --inches WxH and --dpi N");
    if (by_size) {
        if (!vm_parse_size(o->text[SIZE], &size, err))
            return false;
        *w = size.width;
        *h = size.height;
    } else {
        if (!inches(o->text[INCHES], &wide, &high, err) ||
            !measure("dpi", o->text[DPI], plain, 1, 10000, &dpi, err))
            return false;
        *w = floor(wide * dpi + 0.5);
        *h = floor(high * dpi + 0.5);
        say(s, "pixels = %.6g in x %.6g by %.6g in x %.6g = %.0f x %.0f", wide, dpi, high, dpi, *w,
            *h);
    }
    figure(s, "width", *w);
    figure(s, "height", *h);
    return true;
}

static bool calc_buffer(const struct options *o, const char *name, struct sheet *s,
                        struct crt_error *err)
{
    double w, h;
    long bits;
    (void)name;
    if (!read_pixels(o, s, &w, &h, err) || !whole("bits", o->text[BITS], 1, 64, &bits, err))
        return false;
    double bytes = ceil(w * h * (double)bits / 8);
    say(s, "bytes = width x height x bits / 8");
    say(s, "      = %.0f x %.0f x %ld / 8", w, h, bits);
    say(s, "      = %.0f bytes = %.4g MB (MB = 1024 x 1024 bytes)", bytes, bytes / 1048576);
    figure(s, "bits", (double)bits);
    figure(s, "bytes", bytes);
    figure(s, "megabytes", bytes / 1048576);
    return true;
}

static bool calc_load(const struct options *o, const char *name, struct sheet *s,
                      struct crt_error *err)
{
    double w, h, rate;
    long bits;
    (void)name;
    if (!read_pixels(o, s, &w, &h, err) || !whole("bits", o->text[BITS], 1, 64, &bits, err) ||
        !measure("rate", o->text[RATE], bit_rate, 1, 1e15, &rate, err))
        return false;
    double seconds = w * h * (double)bits / rate;
    say(s, "time = width x height x bits / rate");
    say(s, "     = %.0f x %.0f x %ld / (%.10g bit/s)", w, h, bits, rate);
    say(s, "     = %.0f bits / (%.10g bit/s) = %.8g s", w * h * (double)bits, rate, seconds);
    figure(s, "bits", (double)bits);
    figure(s, "rate_bits_s", rate);
    figure(s, "seconds", seconds);
    return true;
}

static bool calc_display_list(const struct options *o, const char *name, struct sheet *s,
                              struct crt_error *err)
{
    struct vm_time each;
    double hz;
    (void)name;
    if (!vm_parse_time(o->text[INSTRUCTION], &each, err) ||
        !measure("refresh", o->text[REFRESH], hertz, 0.001, 1e6, &hz, err))
        return false;
    if (each.in_ticks || each.value == 0)
        return crt_fail(err, "--instruction '%.40s' must be a time above zero, such as 33.33us",
                        o->text[INSTRUCTION]);
    double us = (double)each.value / 1e6, refresh_us = 1e6 / hz;
    double count = floor(refresh_us / us + 1e-9);
    say(s, "instructions = 1 / (refresh rate x time of an instruction)");
    say(s, "             = 1 / (%.10g Hz x %.10g us) = %.8g us / %.10g us", hz, us, refresh_us, us);
    say(s, "             = %.0f, rounded down", count);
    figure(s, "instruction_us", us);
    figure(s, "refresh_hz", hz);
    figure(s, "instructions", count);
    return true;
}

static bool calc_mode(const struct options *o, const char *name, struct sheet *s,
                      struct crt_error *err)
{
    struct ras_timing t;
    char own[48];
    (void)o;
    if (!ras_mode_parse(name, &t, err))
        return false;
    ras_timing_name(&t, own, sizeof own);
    double clock = crt_rate_hz(t.clock), line = crt_rate_hz(ras_line_rate(&t)),
           hz = crt_rate_hz(ras_field_rate(&t));
    double near = line / t.v.visible * 0.95 * (t.interlaced ? 2 : 1);
    const char *two = t.interlaced ? "2 x " : "", *what = t.interlaced ? "fields" : "frames";
    say(s, "%s: %.3f MHz, %u dots a line, %u lines a frame in all", own, clock / 1e6, t.h.total,
        t.v.total);
    say(s, "line rate = dot clock / dots of a line = %.10g Hz / %u = %.3f kHz", clock, t.h.total,
        line / 1e3);
    say(s, "%s    = %sline rate / lines in all = %.3f Hz", what, two, hz);
    say(s, "approximation: %sline rate / visible lines x 0.95 = %s%.6g Hz / %u x 0.95 = %.2f Hz",
        two, two, line, t.v.visible, near);
    say(s, "it is off by %+.1f %%: the beam's return takes %.1f %% here, not 5 %%",
        100 * (near / hz - 1), 100.0 * (t.v.total - t.v.visible) / t.v.total);
    figure(s, "clock_hz", clock);
    figure(s, "line_total", t.h.total);
    figure(s, "lines_total", t.v.total);
    figure(s, "lines_visible", t.v.visible);
    figure(s, "line_hz", line);
    figure(s, "field_hz", hz);
    figure(s, "approximate_hz", near);
    return true;
}

static int common_divisor(int a, int b)
{
    while (b) {
        int r = a % b;
        a = b;
        b = r;
    }
    return a;
}

static bool calc_dpi(const struct options *o, const char *name, struct sheet *s,
                     struct crt_error *err)
{
    struct vm_size size;
    double mm;
    (void)name;
    if (!measure("diagonal", o->text[DIAGONAL], length, 1, 100000, &mm, err) ||
        !vm_parse_size(o->text[SIZE], &size, err))
        return false;
    double w = size.width, h = size.height, across = sqrt(w * w + h * h), dpi = across / mm * 25.4;
    int d = common_divisor(size.width, size.height);
    say(s, "aspect ratio = %d : %d = %d : %d", size.width, size.height, size.width / d,
        size.height / d);
    say(s, "diagonal     = sqrt(%d^2 + %d^2) = %.2f pixels", size.width, size.height, across);
    say(s, "resolution   = %.2f pixels / %.6g in = %.2f dpi", across, mm / 25.4, dpi);
    say(s, "pixel pitch  = 25.4 mm / %.2f = %.4f mm (square pixels)", dpi, 25.4 / dpi);
    say(s, "picture      = %.1f x %.1f mm", w * 25.4 / dpi, h * 25.4 / dpi);
    figure(s, "aspect_x", size.width / d);
    figure(s, "aspect_y", size.height / d);
    figure(s, "diagonal_mm", mm);
    figure(s, "dpi", dpi);
    figure(s, "pitch_mm", 25.4 / dpi);
    figure(s, "width_mm", w * 25.4 / dpi);
    figure(s, "height_mm", h * 25.4 / dpi);
    return true;
}

/* ---- the command -------------------------------------------------------------------------------- */

#define USE(option) (1u << (option))

static const struct calculation {
    const char *name;
    unsigned needs, takes; /* options it cannot do without; others it knows */
    bool named;            /* a second argument */
    bool (*run)(const struct options *o, const char *name, struct sheet *s, struct crt_error *err);
} calculations[] = {
    {"refresh", USE(LINE_RATE) | USE(LINES), USE(OVERHEAD), false, calc_refresh},
    {"buffer", USE(BITS), USE(SIZE) | USE(INCHES) | USE(DPI), false, calc_buffer},
    {"load", USE(BITS) | USE(RATE), USE(SIZE) | USE(INCHES) | USE(DPI), false, calc_load},
    {"display-list", USE(INSTRUCTION) | USE(REFRESH), 0, false, calc_display_list},
    {"mode", 0, 0, true, calc_mode},
    {"dpi", USE(DIAGONAL) | USE(SIZE), 0, false, calc_dpi},
};
#define CALCULATIONS (sizeof calculations / sizeof *calculations)

static const struct calculation *find(const char *name, struct crt_error *err)
{
    const char *names[CALCULATIONS];
    for (size_t i = 0; i < CALCULATIONS; i++) {
        names[i] = calculations[i].name;
        if (strcmp(names[i], name) == 0)
            return &calculations[i];
    }
    const char *near = vm_nearest(name, names, CALCULATIONS);
    crt_fail(err, "there is no calculation '%.40s'; %s%s", name,
             near ? "did you mean " : "give refresh, buffer, load, display-list, mode or dpi",
             near ? near : "");
    return NULL;
}

static bool options_fit(const struct calculation *c, const struct options *o, int arguments,
                        struct crt_error *err)
{
    for (unsigned i = 0; i < OPTIONS; i++) {
        if (!o->text[i] && c->needs & USE(i))
            return crt_fail(err, "%s needs --%s %s: %s", c->name, rows[i].name, rows[i].value,
                            rows[i].help);
        if (o->text[i] && !((c->needs | c->takes) & USE(i)))
            return crt_fail(err, "%s has no use for --%s", c->name, rows[i].name);
    }
    if (c->named && arguments < 2)
        return crt_fail(err, "%s needs a video mode, such as 1024x768@60", c->name);
    if (!c->named && arguments > 1)
        return crt_fail(err, "%s takes options only; kinescope calc --help shows them", c->name);
    return true;
}

static int run(int argc, char **argv)
{
    struct options o = {{0}, false};
    const struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &o)};
    struct vm_args args;
    struct crt_error err;
    struct sheet sheet = {.lines = 0};
    int status = vm_command_parse(&vm_command_calc, tables, 1, argc, argv, &args, 1, 2);
    if (status >= 0)
        return status;
    const struct calculation *c = find(args.item[0], &err);
    if (!c || !options_fit(c, &o, args.count, &err) ||
        !c->run(&o, args.count > 1 ? args.item[1] : NULL, &sheet, &err))
        return vm_command_fail(&vm_command_calc, VM_EXIT_USAGE, &err);
    print_sheet(&sheet, o.json);
    return VM_EXIT_OK;
}

const struct vm_command vm_command_calc = {
    "calc",
    "refresh|buffer|load|mode|dpi …",
    "Reckon as display designers do",
    "Prints the formula, the numbers put in, and the result: refresh rate of a monitor, size of a "
    "refresh buffer, time to load it, length of a display list, exact refresh of a video mode, "
    "resolution of a screen.",
    "  kinescope calc refresh --line-rate 96kHz --lines 1024\n"
    "  kinescope calc buffer --size 1024x1024 --bits 24\n"
    "  kinescope calc buffer --inches 8x10 --dpi 100 --bits 8\n"
    "  kinescope calc load --size 640x480 --bits 12 --rate 100000\n"
    "  kinescope calc display-list --instruction 33.33us --refresh 30\n"
    "  kinescope calc mode 1024x768@60\n"
    "  kinescope calc dpi --diagonal 17in --size 1024x768",
    run,
};
