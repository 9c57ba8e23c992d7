/* How late the machine answers hands: from an act to the first beam piece that is drawn otherwise than it would
 * have been without it, in simulated time, against the program's refresh.
 *
 * Two machines run the same program up to the act; one gets it. Acts come at many places of the refresh. No
 * light is computed: the first photon comes with the piece.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "emu/rig.h"
#include "input/noise.h"

#define TRIES  12
#define MOST   400000
#define BEFORE (3 * CRT_PS_PER_S) /* what is set up has settled by then */
#define WAIT   (CRT_PS_PER_S / 2)

struct drawn {
    struct crt_stroke *stroke;
    size_t count;
};

static void keep(void *ctx, const struct crt_stroke *stroke)
{
    struct drawn *d = ctx;
    if (d->count < MOST)
        d->stroke[d->count++] = *stroke;
}

struct run {
    struct vm_input input;
    struct vm_settings settings;
    struct vm_rig rig;
};

static bool open_run(struct run *r, const char *path, const char *phosphor)
{
    static const struct vm_input_options none;
    const struct vm_settings_options options = {.threads = 1, .phosphor = phosphor};
    struct crt_error err;
    if (vm_input_load(&r->input, path, &none, &err, NULL) &&
        !vm_settings_resolve(&options, NULL, vm_input_tube(&r->input), &r->settings, &err) &&
        vm_rig_open(&r->rig, &r->settings, &r->input, DF_TIMING_VALUE, NULL, &err))
        return true;
    printf("  %s: %s\n", path, err.text);
    return false;
}

static void close_run(struct run *r)
{
    vm_rig_close(&r->rig);
    vm_settings_free(&r->settings);
    vm_input_free(&r->input);
}

static bool same(const struct crt_stroke *a, const struct crt_stroke *b)
{
    return a->t0 == b->t0 && a->t1 == b->t1 && a->x0 == b->x0 && a->y0 == b->y0 && a->x1 == b->x1 &&
           a->y1 == b->y1 && a->drive == b->drive;
}

/* When the first stroke differs; 0: none does. */
static uint64_t first_difference(const struct drawn *a, const struct drawn *b)
{
    size_t i = 0, most = a->count < b->count ? a->count : b->count;
    while (i < most && same(&a->stroke[i], &b->stroke[i]))
        i++;
    if (i == a->count || i == b->count)
        return 0;
    const struct crt_stroke *x = &a->stroke[i], *y = &b->stroke[i];
    /* Begun alike, one was cut short: light differs where the shorter ends. */
    if (x->t0 == y->t0 && x->x0 == y->x0 && x->y0 == y->y0)
        return x->t1 < y->t1 ? x->t1 : y->t1;
    return x->t0 < y->t0 ? x->t0 : y->t0;
}

struct scene {
    const char *name, *path, *phosphor;
    struct inp_act before[3]; /* at 1 s, 1.5 s, 2 s; device INP_DEVICES: none */
    struct inp_act act;
};

static bool act_upon(struct run *r, const struct scene *s)
{
    for (int i = 0; i < 3; i++) {
        struct inp_act a = s->before[i];
        a.t = CRT_PS_PER_S + (uint64_t)i * CRT_PS_PER_S / 2;
        if (a.device != INP_DEVICES && !vm_operator_do(r->rig.person, &a))
            return false;
    }
    return true;
}

/* One act at t; the answer's time after it, 0: none came. */
static uint64_t answer(const struct scene *s, uint64_t t, struct drawn drawn[2], double *refresh_ms)
{
    struct run run[2];
    uint64_t found = 0;
    for (int i = 0; i < 2; i++) {
        struct inp_act act = s->act;
        const struct vm_hooks hooks = {.ctx = &drawn[i], .stroke = keep};
        drawn[i].count = 0;
        if (!open_run(&run[i], s->path, s->phosphor))
            exit(1);
        act.t = t;
        if (!act_upon(&run[i], s) || (i == 1 && !vm_operator_do(run[i].rig.person, &act)))
            exit(1);
        vm_machine_run(run[i].rig.machine, t);
        const struct vm_refresh *last = &run[i].rig.machine->refreshes.last;
        *refresh_ms = (double)(last->end - last->begin) / (double)CRT_PS_PER_MS;
        vm_machine_trace(run[i].rig.machine, t + WAIT, &hooks);
    }
    found = first_difference(&drawn[0], &drawn[1]);
    for (int i = 0; i < 2; i++)
        close_run(&run[i]);
    return found ? found - t : 0;
}

static void measure(const struct scene *s)
{
    struct drawn drawn[2];
    double sum = 0, most = 0, least = 1e9, refresh = 0;
    int answered = 0;
    for (int i = 0; i < 2; i++)
        if (!(drawn[i].stroke = malloc(MOST * sizeof *drawn[i].stroke)))
            exit(1);
    for (uint64_t i = 0; i < TRIES; i++) {
        uint64_t t =
            BEFORE + inp_noise_bits(7, i) % (CRT_PS_PER_S / 10) / CRT_PS_PER_US * CRT_PS_PER_US;
        uint64_t after = answer(s, t, drawn, &refresh);
        double ms = (double)after / (double)CRT_PS_PER_MS;
        if (after == 0)
            continue;
        answered++;
        sum += ms;
        most = ms > most ? ms : most;
        least = ms < least ? ms : least;
    }
    if (answered)
        printf("%-44s %7.2f %8.2f %8.2f %8.2f %6d/%d\n", s->name, refresh, least, sum / answered,
               most, answered, TRIES);
    else
        printf("%-44s %7.2f   no answer\n", s->name, refresh);
    for (int i = 0; i < 2; i++)
        free(drawn[i].stroke);
}

#define NONE                                                                                       \
    {                                                                                              \
        .device = INP_DEVICES                                                                      \
    }
#define PEN(X, Y)                                                                                  \
    {                                                                                              \
        .device = INP_PEN, .verb = INP_MOVE, .space = INP_UNITS, .x = (X)*1000, .y = (Y)*1000      \
    }
#define STYLUS(X, Y, Z)                                                                            \
    {                                                                                              \
        .device = INP_TABLET, .verb = INP_MOVE, .x = (X)*1000, .y = (Y)*1000, .z = (Z)*1000        \
    }
#define KEY(CODE, CHARACTER)                                                                       \
    {                                                                                              \
        .device = INP_KEYBOARD, .verb = INP_PRESS, .code = CODE, .character = CHARACTER            \
    }

int main(void)
{
    static const struct scene scenes[] = {
        {"pen comes to a lit vector (testcard.df)",
         "roms/testcard.df",
         "P31",
         {NONE, NONE, NONE},
         PEN(512, 380)},
        {"pen moves the tracking cross (track.elf)",
         "roms/track.elf",
         NULL,
         {PEN(512, 512), NONE, NONE},
         PEN(520, 516)},
        {"stylus moves the cursor (sketch.elf)",
         "roms/sketch.elf",
         NULL,
         {STYLUS(100, 100, 5), NONE, NONE},
         STYLUS(140, 120, 5)},
        {"mouse moves the cursor (sketch.elf)",
         "roms/sketch.elf",
         NULL,
         {NONE, NONE, NONE},
         {.device = INP_MOUSE, .verb = INP_MOVE, .x = 5000, .y = 5000}},
        {"stylus drags a control point (spline.elf)",
         "roms/spline.elf",
         NULL,
         {STYLUS(100, 100, 5), NONE, NONE},
         STYLUS(140, 120, 5)},
        {"a key chooses (choice.elf)",
         "roms/choice.elf",
         NULL,
         {NONE, NONE, NONE},
         KEY(KEYCODE_DOWN, 0)},
        {"a letter is typed (monitor.elf)",
         "roms/monitor.elf",
         NULL,
         {NONE, NONE, NONE},
         KEY('C', 'c')},
    };
    printf("%-44s %7s %8s %8s %8s %8s\n", "from the act to the first piece that differs, ms",
           "refresh", "least", "mean", "most", "answered");
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++)
        measure(&scenes[i]);
    return 0;
}
