#include "emu/settings.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "crt/penetration.h"
#include "emu/settings_parts.h"

#define ROW(field) offsetof(struct vm_settings_options, field)

#define DEFAULT_VECTOR "VR17"
#define DEFAULT_RASTER "COLOR17"

const struct vm_option vm_settings_rows[VM_SETTINGS_ROWS] = {
    {"tube", 0, VM_OPT_LIST, ROW(tube), "NAME",
     "tube row (list tubes), or TUBE/PHOSPHOR; twice for one of each head; default: what the "
     "program "
     "says, else " DEFAULT_VECTOR " and " DEFAULT_RASTER,
     0, 0},
    {"phosphor", 0, VM_OPT_STRING, ROW(phosphor), "NAME",
     "phosphor instead of the tube's own (list phosphors)", 0, 0},
    {"mode", 0, VM_OPT_STRING, ROW(mode), "MODE",
     "what the raster head begins with: a mode of the table (list modes), or any WxH, WxH@HZ or "
     "WxH@HZi; default the tube's",
     0, 0},
    {"view", 0, VM_OPT_CHOICE, ROW(view), VM_VIEW_NAMES,
     "which head to look at; default auto: those the program uses", 0, 0},
    {"tubes", 0, VM_OPT_LIST, ROW(tubes), "FILE.ini", "read more tubes and phosphors", 0, 0},
    {"set", 0, VM_OPT_LIST, ROW(set), "KEY=VALUE",
     "memory=16K, dpu.average=33.33us, brightness=-1…1, contrast=0…4, focus=0…4, or any figure of "
     "the "
     "tube row: spot=0.4, vector_unit=50ns; raster.spot=0.5 names the head",
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

static const struct crt_tube_row *find_tube(struct vm_settings *s, const char *name,
                                            struct crt_error *err)
{
    const struct crt_tube_row *row = crt_catalogue_tube(&s->catalogue, name);
    const char *names[256];
    size_t count = 0;
    if (row)
        return row;
    for (size_t i = 0; i < s->catalogue.tube_count && count < 256; i++)
        names[count++] = s->catalogue.tubes[i].name;
    no_such("tube", name, names, count, err);
    return NULL;
}

static bool take_phosphor(struct vm_settings *s, enum vm_head head, const char *name,
                          struct crt_error *err)
{
    const struct crt_phosphor *p = crt_catalogue_phosphor(&s->catalogue, name);
    const char *names[256];
    size_t count = 0;
    if (p) {
        s->monitor[head].phosphor = *p;
        return crt_tube_check_phosphor(&s->monitor[head].row, p, err) &&
               crt_penetration_fits(&s->monitor[head].row, p, err);
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

/* ---- tubes --------------------------------------------------------------------------------------
 */

/* What each head is to have, before phosphors are looked up. */
struct choice {
    bool named[VM_HEADS]; /* by an option */
    char phosphor[VM_HEADS][16];
};

static enum vm_head head_of(const struct crt_tube_row *row)
{
    return row->kind == CRT_RASTER_TUBE ? VM_RASTER : VM_VECTOR;
}

/* TUBE or TUBE/PHOSPHOR to the head it is for. */
static bool choose(struct vm_settings *s, struct choice *c, const char *name, enum vm_head *head,
                   struct crt_error *err)
{
    struct glass glass;
    if (!glass_of(name, &glass, err))
        return false;
    const struct crt_tube_row *row = find_tube(s, glass.tube, err);
    if (!row)
        return false;
    *head = head_of(row);
    s->monitor[*head].row = *row;
    snprintf(c->phosphor[*head], sizeof c->phosphor[*head], "%s",
             glass.phosphor[0] ? glass.phosphor : row->phosphor);
    return true;
}

/* Those of the options; the main head is that of the one tube named. */
static bool choose_by_options(struct vm_settings *s, struct choice *c, const struct vm_list *tubes,
                              struct crt_error *err)
{
    for (int i = 0; i < tubes->count; i++) {
        enum vm_head head;
        if (!choose(s, c, tubes->item[i], &head, err))
            return false;
        if (c->named[head])
            return crt_fail(err, "--tube names two tubes for the %s head",
                            head == VM_RASTER ? "raster" : "vector");
        c->named[head] = true;
    }
    if (c->named[VM_RASTER] && !c->named[VM_VECTOR])
        s->main = VM_RASTER;
    return true;
}

/* Defaults, then what the program says, then the options. */
static int choose_tubes(struct vm_settings *s, const struct vm_settings_options *o,
                        const struct crt_beam_header *recording, const char *tube,
                        struct crt_error *err)
{
    struct choice c = {{false}, {""}};
    enum vm_head head;
    const char *said = recording ? recording->tube : tube;
    if (!choose(s, &c, DEFAULT_VECTOR, &head, err) || !choose(s, &c, DEFAULT_RASTER, &head, err))
        return 1;
    if (said && o->tube.count == 0) {
        if (!choose(s, &c, said, &head, err))
            return 1;
        s->main = head;
        if (recording && recording->phosphor[0])
            snprintf(c.phosphor[head], sizeof c.phosphor[head], "%s", recording->phosphor);
    } else if (said && !choose(s, &c, said, &head, err)) {
        return 1;
    }
    if (!choose_by_options(s, &c, &o->tube, err))
        return 2;
    s->view = vm_view_of_name(o->view);
    if (s->view == VM_VIEW_RASTER || s->view == VM_VIEW_VECTOR)
        s->main = s->view == VM_VIEW_RASTER ? VM_RASTER : VM_VECTOR;
    for (int h = 0; h < VM_HEADS; h++) {
        bool own = o->phosphor && h == (int)s->main;
        if (!take_phosphor(s, (enum vm_head)h, own ? o->phosphor : c.phosphor[h], err))
            return own || c.named[h] ? 2 : 1;
    }
    return 0;
}

/* The raster head's mode: asked for, or the tube's own. */
static bool take_mode(struct vm_settings *s, const char *mode, struct crt_error *err)
{
    const struct crt_tube_row *row = &s->monitor[VM_RASTER].row;
    struct ras_monitor monitor = ras_monitor_of(row);
    struct crt_error why;
    if (!ras_mode_parse(mode ? mode : row->mode, &s->timing, &why) ||
        !ras_monitor_follows(&monitor, &s->timing, row->name, &why))
        return crt_fail(err, "%s%.400s", mode ? "--mode: " : "", why.text);
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
    for (int h = 0; h < VM_HEADS; h++)
        s->monitor[h].knobs = (struct crt_knobs){0, 1, 0};
    inp_setup_default(&s->setup);
    s->memory_bytes = DF_ADDRESS_SPACE;
    s->on_stop = o->on_stop && strcmp(o->on_stop, "halt") == 0 ? VM_HALT : VM_RESTART;
    s->threads = o->threads ? (int)o->threads : default_threads();
    if (!crt_catalogue_init(&s->catalogue, err))
        return 1;
    for (int i = 0; i < o->tubes.count; i++)
        if (!crt_catalogue_load(&s->catalogue, o->tubes.item[i], err))
            return 1;
    s->raster_asked = o->mode != NULL;
    int status = choose_tubes(s, o, recording, tube, err);
    if (status)
        return status;
    inp_setup_screen(&s->setup, s->monitor[VM_VECTOR].row.name,
                     s->monitor[VM_VECTOR].phosphor.name);
    s->personality = take_personality(o->personality, &s->monitor[VM_VECTOR].row);
    if (!vm_settings_set(s, &o->set, err) || !take_mode(s, o->mode, err) ||
        !take_simd(s, o->simd, err))
        return 2;
    s->tick = o->refresh.num ? o->refresh
              : recording    ? recording->tick
                             : vm_rate_of_hz(s->monitor[VM_VECTOR].row.sync.value);
    double hz = crt_rate_hz(s->tick);
    return usage((hz >= 0.1 && hz <= 1e5) ||
                 crt_fail(err, "a sync tick of %g Hz is out of range; give 0.1 to 100000", hz));
}

void vm_settings_free(struct vm_settings *s)
{
    crt_catalogue_free(&s->catalogue);
}

struct vm_machine_desc vm_settings_machine(const struct vm_settings *s,
                                           enum df_timing_choice choice)
{
    const struct crt_tube_row *row = &s->monitor[VM_VECTOR].row;
    struct df_timing timing = df_timing_of_tube(row, choice);
    timing.average_ps = s->average_ps;
    return (struct vm_machine_desc){.row = row,
                                    .timing = timing,
                                    .personality = s->personality,
                                    .tick = s->tick,
                                    .memory_bytes = s->memory_bytes,
                                    .on_stop = s->on_stop,
                                    .raster_row = &s->monitor[VM_RASTER].row,
                                    .raster_timing = s->timing,
                                    .setup = &s->setup,
                                    .phosphor = &s->monitor[VM_VECTOR].phosphor,
                                    .raster_phosphor = &s->monitor[VM_RASTER].phosphor,
                                    .knobs = s->monitor[VM_VECTOR].knobs,
                                    .raster_knobs = s->monitor[VM_RASTER].knobs};
}

static struct crt_tube_desc tube_desc(const struct vm_settings *s, enum vm_head head)
{
    const struct vm_monitor *m = &s->monitor[head];
    return (struct crt_tube_desc){.row = &m->row,
                                  .phosphor = &m->phosphor,
                                  .grid = crt_tube_grid(&m->row),
                                  .epoch = head == VM_RASTER ? ras_field_rate(&s->timing) : s->tick,
                                  .knobs = m->knobs,
                                  .threads = s->threads,
                                  .simd = s->simd};
}

struct vm_tubes vm_settings_tubes(const struct vm_settings *s, enum vm_view view)
{
    struct vm_tubes tubes = {.heads = view == VM_VIEW_AUTO ? VM_VIEW_BOTH : view};
    for (int h = 0; h < VM_HEADS; h++)
        if (tubes.heads >> h & 1)
            tubes.desc[h] = tube_desc(s, (enum vm_head)h);
    return tubes;
}
