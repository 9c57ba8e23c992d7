#include "emu/settings.h"

#include <string.h>
#include <unistd.h>

#define ROW(field) offsetof(struct vm_settings_options, field)

#define DEFAULT_TUBE "VR17"

const struct vm_option vm_settings_rows[VM_SETTINGS_ROWS] = {
    {"tube", 0, VM_OPT_STRING, ROW(tube), "NAME",
     "tube row (list tubes), or TUBE/PHOSPHOR; default: what the program says, else " DEFAULT_TUBE,
     0, 0},
    {"phosphor", 0, VM_OPT_STRING, ROW(phosphor), "NAME",
     "phosphor instead of the tube's own (list phosphors)", 0, 0},
    {"tubes", 0, VM_OPT_LIST, ROW(tubes), "FILE.ini", "read more tubes and phosphors", 0, 0},
    {"set", 0, VM_OPT_LIST, ROW(set), "KEY=VALUE",
     "memory=16K, dpu.average=33.33us, brightness=-1…1, contrast=0…4, focus=0…4, or any figure of "
     "the "
     "tube row: spot=0.4, vector_unit=50ns",
     0, 0},
    {"refresh", 0, VM_OPT_RATE, ROW(refresh), "HZ", "rate of the sync tick instead of the tube's",
     0, 0},
    {"personality", 0, VM_OPT_CHOICE, ROW(personality), "vt11|vs60",
     "display processor: vt11, or with the colours of the vs60; default vs60 on a penetration "
     "tube, "
     "else vt11",
     0, 0},
    {"on-stop", 0, VM_OPT_CHOICE, ROW(on_stop), "restart|halt",
     "what follows a stop word: restart at the next sync tick (default), or halt", 0, 0},
    {"threads", 0, VM_OPT_INTEGER, ROW(threads), "N",
     "threads that compute light (the samples do not depend on it)", 1, 64},
    {"simd", 0, VM_OPT_CHOICE, ROW(simd), "auto|baseline|avx2",
     "kernels to use (the samples do not depend on it)", 0, 0},
};

static int usage(bool ok)
{
    return ok ? 0 : 2;
}

/* ---- names --------------------------------------------------------------------------------------
 */

static bool no_such(const char *what, const char *name, const char *const *names, size_t count,
                    struct crt_error *err)
{
    const char *near = vm_nearest(name, names, count);
    if (near)
        return crt_fail(err, "there is no %s called '%.60s'; did you mean %s? (kinescope list %ss)",
                        what, name, near, what);
    return crt_fail(err, "there is no %s called '%.60s'; kinescope list %ss names them", what, name,
                    what);
}

static bool take_tube(struct vm_settings *s, const char *name, struct crt_error *err)
{
    const struct crt_tube_row *row = crt_catalogue_tube(&s->catalogue, name);
    const char *names[256];
    size_t count = 0;
    if (row) {
        s->row = *row;
        return true;
    }
    for (size_t i = 0; i < s->catalogue.tube_count && count < 256; i++)
        names[count++] = s->catalogue.tubes[i].name;
    return no_such("tube", name, names, count, err);
}

static bool take_phosphor(struct vm_settings *s, const char *name, struct crt_error *err)
{
    const struct crt_phosphor *p = crt_catalogue_phosphor(&s->catalogue, name);
    const char *names[256];
    size_t count = 0;
    if (p) {
        s->phosphor = *p;
        return true;
    }
    for (size_t i = 0; i < s->catalogue.phosphor_count && count < 256; i++)
        names[count++] = s->catalogue.phosphors[i].name;
    return no_such("phosphor", name, names, count, err);
}

/* TUBE or TUBE/PHOSPHOR, taken apart. */
struct glass {
    char tube[24], phosphor[16];
};

static bool glass_of(const char *name, struct glass *glass, struct crt_error *err)
{
    name = name ? name : DEFAULT_TUBE;
    size_t n = strcspn(name, "/");
    const char *phosphor = name[n] ? name + n + 1 : "";
    *glass = (struct glass){"", ""};
    if (n == 0 || n >= sizeof glass->tube || strlen(phosphor) >= sizeof glass->phosphor ||
        (name[n] && !*phosphor))
        return crt_fail(err, "'%.60s' is not a tube or TUBE/PHOSPHOR, such as VR17/P31", name);
    memcpy(glass->tube, name, n);
    strcpy(glass->phosphor, phosphor);
    return true;
}

/* ---- --set --------------------------------------------------------------------------------------
 */

static bool set_memory(struct vm_settings *s, const char *text, struct crt_error *err)
{
    uint32_t bytes;
    if (!vm_parse_bytes(text, &bytes, err))
        return false;
    if (bytes < 1024 || bytes > DF_MEMORY_BYTES || bytes % 2)
        return crt_fail(err, "%s is not a possible display memory; give 1K to 256K", text);
    s->memory_bytes = bytes;
    return true;
}

static bool set_average(struct vm_settings *s, const char *text, struct crt_error *err)
{
    struct vm_time time;
    if (!vm_parse_time(text, &time, err))
        return false;
    if (time.in_ticks || time.value == 0)
        return crt_fail(err, "'%s' must be a time above zero, such as 33.33us", text);
    s->average_ps = time.value;
    return true;
}

/* The number in front of the figure's unit, or a time where the unit is one. */
static bool figure_value(const char *text, const char *unit, double *value, struct crt_error *err)
{
    char number[40];
    size_t n = strlen(text), u = strlen(unit);
    struct vm_time time;
    if (strcmp(unit, "us") == 0 && n && text[n - 1] == 's') {
        if (!vm_parse_time(text, &time, err))
            return false;
        *value = (double)time.value / (double)CRT_PS_PER_US;
        return true;
    }
    if (n > u && strcmp(text + n - u, unit) == 0 && strcmp(unit, "1") != 0)
        n -= u;
    if (n >= sizeof number)
        return crt_fail(err, "'%.60s' is not a number", text);
    memcpy(number, text, n);
    number[n] = '\0';
    return vm_parse_real(number, -1e9, 1e9, value, err);
}

static bool set_figure(struct vm_settings *s, const char *name, const char *text,
                       struct crt_error *err)
{
    const char *unit = "";
    double value = 0;
    struct crt_figure *figure = crt_tube_figure(&s->row, name, &unit);
    if (!figure) {
#define X(field, unit, meaning) #field,
        static const char *const names[] = {CRT_TUBE_FIGURES(X) "memory", "dpu.average",
                                            "brightness", "contrast", "focus"};
#undef X
        const char *near = vm_nearest(name, names, sizeof names / sizeof *names);
        if (near)
            return crt_fail(err, "there is no '%.60s' to set; did you mean %s?", name, near);
        return crt_fail(
            err, "there is no '%.60s' to set; kinescope list tubes --why names the figures", name);
    }
    if (!figure_value(text, unit, &value, err))
        return false;
    *figure = (struct crt_figure){value, value, value, "set on the command line"};
    return crt_tube_check_figure(&s->row, name, err);
}

static bool set_one(struct vm_settings *s, const char *item, struct crt_error *err)
{
    char name[40];
    size_t n = strcspn(item, "=");
    if (item[n] != '=' || n == 0 || n >= sizeof name)
        return crt_fail(err, "'%.60s' is not KEY=VALUE, such as memory=16K", item);
    memcpy(name, item, n);
    name[n] = '\0';
    const char *text = item + n + 1;
    if (strcmp(name, "memory") == 0)
        return set_memory(s, text, err);
    if (strcmp(name, "dpu.average") == 0)
        return set_average(s, text, err);
    if (strcmp(name, "brightness") == 0)
        return vm_parse_real(text, -1, 1, &s->knobs.brightness, err);
    if (strcmp(name, "contrast") == 0)
        return vm_parse_real(text, 0, 4, &s->knobs.contrast, err);
    if (strcmp(name, "focus") == 0)
        return vm_parse_real(text, 0, 4, &s->knobs.focus, err);
    return set_figure(s, name, text, err);
}

static bool set_all(struct vm_settings *s, const struct vm_list *set, struct crt_error *err)
{
    struct crt_error why;
    for (int i = 0; i < set->count; i++)
        if (!set_one(s, set->item[i], &why))
            return crt_fail(err, "--set: %.400s", why.text);
    if (!crt_tube_check(&s->row, &why))
        return crt_fail(err, "--set: %.400s", why.text);
    return true;
}

/* ---- the rest -----------------------------------------------------------------------------------
 */

static bool take_simd(struct vm_settings *s, const char *name, struct crt_error *err)
{
    s->simd = CRT_SIMD_AUTO;
    if (!name || strcmp(name, "auto") == 0)
        return true;
    s->simd = strcmp(name, "avx2") == 0 ? CRT_SIMD_AVX2 : CRT_SIMD_BASELINE;
#if defined(__x86_64__)
    if (s->simd == CRT_SIMD_AVX2 && !__builtin_cpu_supports("avx2"))
        return crt_fail(err, "--simd: this processor has no AVX2; use auto or baseline");
#else
    if (s->simd == CRT_SIMD_AVX2)
        return crt_fail(err, "--simd: avx2 is for x86-64 only; use auto or baseline");
#endif
    return true;
}

/* Without colours on the tube the words that set them stay without effect, as on a VT11. */
static enum df_personality take_personality(const char *name, const struct crt_tube_row *row)
{
    if (!name)
        return crt_tube_has_group(row, CRT_GROUP_PENETRATION) ? DF_VS60 : DF_VT11;
    return strcmp(name, "vs60") == 0 ? DF_VS60 : DF_VT11;
}

static int default_threads(void)
{
    long n = sysconf(_SC_NPROCESSORS_ONLN);
    return n < 1 ? 1 : n > 4 ? 4 : (int)n;
}

int vm_settings_resolve(const struct vm_settings_options *o,
                        const struct crt_beam_header *recording, const char *tube,
                        struct vm_settings *s, struct crt_error *err)
{
    memset(s, 0, sizeof *s);
    s->knobs = (struct crt_knobs){0, 1, 0};
    s->memory_bytes = DF_ADDRESS_SPACE;
    s->on_stop = o->on_stop && strcmp(o->on_stop, "halt") == 0 ? VM_HALT : VM_RESTART;
    s->threads = o->threads ? (int)o->threads : default_threads();
    if (!crt_catalogue_init(&s->catalogue, err))
        return 1;
    for (int i = 0; i < o->tubes.count; i++)
        if (!crt_catalogue_load(&s->catalogue, o->tubes.item[i], err))
            return 1;
    struct glass glass;
    if (!glass_of(o->tube     ? o->tube
                  : recording ? recording->tube
                              : tube,
                  &glass, err) ||
        !take_tube(s, glass.tube, err))
        return o->tube ? 2 : 1;
    s->personality = take_personality(o->personality, &s->row);
    const char *phosphor = o->phosphor                           ? o->phosphor
                           : glass.phosphor[0]                   ? glass.phosphor
                           : recording && recording->phosphor[0] ? recording->phosphor
                                                                 : s->row.phosphor;
    if (!take_phosphor(s, phosphor, err))
        return o->phosphor || o->tube ? 2 : 1;
    if (!set_all(s, &o->set, err) || !take_simd(s, o->simd, err))
        return 2;
    s->tick = o->refresh.num ? o->refresh
              : recording    ? recording->tick
                             : vm_rate_of_hz(s->row.sync.value);
    double hz = (double)s->tick.num / (double)s->tick.den;
    return usage((hz >= 0.1 && hz <= 1e5) ||
                 crt_fail(err, "a sync tick of %g Hz is out of range; give 0.1 to 100000", hz));
}

void vm_settings_free(struct vm_settings *s)
{
    crt_catalogue_free(&s->catalogue);
}

struct vm_machine_desc vm_settings_machine(const struct vm_settings *s,
                                           enum df_timing_choice choice, struct crt_tube *tube)
{
    struct df_timing timing = df_timing_of_tube(&s->row, choice);
    timing.average_ps = s->average_ps;
    return (struct vm_machine_desc){.row = &s->row,
                                    .timing = timing,
                                    .personality = s->personality,
                                    .tick = s->tick,
                                    .memory_bytes = s->memory_bytes,
                                    .on_stop = s->on_stop,
                                    .tube = tube};
}

struct crt_tube_desc vm_settings_tube(const struct vm_settings *s)
{
    return (struct crt_tube_desc){.row = &s->row,
                                  .phosphor = &s->phosphor,
                                  .grid = crt_tube_grid(&s->row),
                                  .epoch = s->tick,
                                  .knobs = s->knobs,
                                  .threads = s->threads,
                                  .simd = s->simd};
}
