/* fuzz_options.c — any lines as what people type: quantities, options and --set.
 *
 * Input:      lines of text. Each one goes through every parser of emu/quantity.h; then all of them
 *             together are the arguments of a command with every kind of option and the shared ones
 *             (--tubes left out: fuzz_ini reads those).
 * Checks:     accepted values lie within what the header promises and are what strtod makes of the
 *             same text; refusals are one sentence; a tube that --set leaves over passes its check.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "crt/image.h"
#include "display_file/df_regs.h"
#include "emu/options.h"
#include "emu/settings.h"

#define MAX_LINES 32

static void require(int holds)
{
    if (!holds)
        abort();
}

static void check_sentence(const struct crt_error *err)
{
    require(err->text[0] != '\0' && memchr(err->text, 0, sizeof err->text) != NULL);
}

/* The same text by the C library; 1 ps beside rounding down. */
static void check_time(const char *text, const struct vm_time *time)
{
    static const struct {
        const char *name;
        double ps;
    } units[] = {{"ps", 1}, {"ns", 1e3}, {"us", 1e6}, {"ms", 1e9}, {"s", 1e12}, {"f", 1}};
    char *end;
    double value = strtod(text, &end), ps = 1e12;
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(end, units[i].name) == 0)
            ps = units[i].ps;
    require(time->given && time->in_ticks == (*end == 'f'));
    require(time->in_ticks || time->value <= VM_TIME_MAX_PS);
    require(fabs((double)time->value - value * ps) <= 1 + value * ps * 1e-12);
}

static void check_times(const char *text)
{
    struct crt_error err = {""};
    struct vm_time time;
    char shown[40];
    if (!vm_parse_time(text, &time, &err)) {
        check_sentence(&err);
        return;
    }
    check_time(text, &time);
    const struct crt_rate ticks[] = {{60, 1}, {60000, 1001}, {1, 10}, {100000, 1}};
    for (int i = 0; i < 4; i++) {
        uint64_t ps;
        if (vm_time_ps(&time, ticks[i], &ps, &err)) {
            require(ps <= VM_TIME_MAX_PS);
            vm_format_time(ps, shown, sizeof shown);
            vm_format_seconds(ps, shown, sizeof shown);
        } else {
            check_sentence(&err);
        }
    }
}

static void check_quantities(const char *text)
{
    struct crt_error err = {""};
    struct vm_size size;
    struct crt_rate rate;
    uint32_t number;
    double real;
    long integer;
    check_times(text);
    if (vm_parse_size(text, &size, &err))
        require(size.width >= 16 && size.width <= CRT_IMAGE_MAX_SIDE && size.height >= 16 &&
                size.height <= CRT_IMAGE_MAX_SIDE);
    if (vm_parse_bytes(text, &number, &err))
        require(number == strtoul(text, NULL, 10) * (strpbrk(text, "Kk") ? 1024 : 1));
    if (vm_parse_rate(text, &rate, &err)) {
        double hz = (double)rate.num / (double)rate.den;
        require(rate.den > 0 && hz >= 0.1 && hz <= 1e5);
        if (!strchr(text, '/'))
            require(fabs(hz - strtod(text, NULL)) <= 1e-12 * hz);
        require(crt_tick_time(rate, 1) > 0);
    }
    if (vm_parse_real(text, -10, 1e6, &real, &err))
        require(real >= -10 && real <= 1e6 && real == strtod(text, NULL));
    if (vm_parse_integer(text, -5, 1000000, &integer, &err))
        require(integer >= -5 && integer <= 1000000 && integer == strtol(text, NULL, 10));
    if (vm_parse_octal(text, &number, &err))
        require(number < 1u << 18 && number == strtoul(text, NULL, 8));
}

struct everything {
    bool flag;
    const char *string, *choice;
    struct vm_list list;
    struct vm_time time;
    struct vm_size size;
    struct crt_rate rate;
    double real;
    long integer;
    struct vm_octal octal;
};

#define ROW(field) offsetof(struct everything, field)
static const struct vm_option rows[] = {
    {"flag", 'f', VM_OPT_FLAG, ROW(flag), NULL, "", 0, 0},
    {"string", 'o', VM_OPT_STRING, ROW(string), "S", "", 0, 0},
    {"choice", 0, VM_OPT_CHOICE, ROW(choice), "one|two|three", "", 0, 0},
    {"list", 'l', VM_OPT_LIST, ROW(list), "S", "", 0, 0},
    {"time", 't', VM_OPT_TIME, ROW(time), "T", "", 0, 0},
    {"size", 0, VM_OPT_SIZE, ROW(size), "WxH", "", 0, 0},
    {"rate", 0, VM_OPT_RATE, ROW(rate), "HZ", "", 0, 0},
    {"real", 0, VM_OPT_REAL, ROW(real), "X", "", -1, 1},
    {"integer", 'i', VM_OPT_INTEGER, ROW(integer), "N", "", 1, 64},
    {"octal", 0, VM_OPT_OCTAL, ROW(octal), "A", "", 0, 0},
};

static void check_settings(struct vm_settings_options *o)
{
    struct crt_error err = {""};
    struct vm_settings s;
    o->tubes.count = 0;
    int status = vm_settings_resolve(o, NULL, NULL, &s, &err);
    if (status) {
        require(status == 2);
        check_sentence(&err);
    } else {
        require(crt_tube_check(&s.monitor[VM_VECTOR].row, &err));
        require(s.threads >= 1 && s.threads <= 64);
        require(s.memory_bytes >= 1024 && s.memory_bytes <= DF_MEMORY_BYTES);
        require(s.monitor[VM_VECTOR].knobs.brightness >= -1 &&
                s.monitor[VM_VECTOR].knobs.brightness <= 1);
        require(s.monitor[VM_VECTOR].knobs.contrast >= 0 &&
                s.monitor[VM_VECTOR].knobs.contrast <= 4 && s.monitor[VM_VECTOR].knobs.focus >= 0 &&
                s.monitor[VM_VECTOR].knobs.focus <= 4);
        struct vm_machine_desc m = vm_settings_machine(&s, DF_TIMING_VALUE);
        require(m.timing.fetch_ps > 0 && m.timing.fetch_ps <= CRT_PS_PER_S);
        struct vm_tubes t = vm_settings_tubes(&s, s.view);
        for (int h = 0; h < VM_HEADS; h++)
            if (t.heads >> h & 1)
                require(t.desc[h].grid.cols > 0 && t.desc[h].grid.rows > 0 &&
                        t.desc[h].epoch.num > 0);
    }
    vm_settings_free(&s);
}

static void check_command(int argc, char **argv)
{
    struct everything all = {.real = 0};
    struct vm_settings_options shared = {.phosphor = NULL};
    struct vm_option_table tables[] = {VM_OPTION_TABLE(rows, &all),
                                       VM_OPTION_TABLE(vm_settings_rows, &shared)};
    struct vm_args args;
    struct crt_error err = {""};
    switch (vm_options_parse(tables, 2, argc, argv, &args, &err)) {
    case VM_PARSED:
        require(args.count <= argc && all.list.count <= VM_LIST_MAX);
        require(all.real >= -1 && all.real <= 1 && all.integer >= 0 && all.integer <= 64);
        check_settings(&shared);
        break;
    case VM_PARSED_ERROR:
        check_sentence(&err);
        break;
    case VM_PARSED_HELP:
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *argv[MAX_LINES + 1];
    int argc = 0;
    for (size_t at = 0; at < size && argc < MAX_LINES;) {
        size_t length = 0;
        while (at + length < size && data[at + length] != '\n' && data[at + length] != 0)
            length++;
        /* Each in memory of its own, so that a sanitizer sees reads past it. */
        char *line = malloc(length + 1);
        require(line != NULL);
        memcpy(line, data + at, length);
        line[length] = '\0';
        check_quantities(line);
        argv[argc++] = line;
        at += length + 1;
    }
    argv[argc] = NULL;
    check_command(argc, argv);
    while (argc > 0)
        free(argv[--argc]);
    return 0;
}
