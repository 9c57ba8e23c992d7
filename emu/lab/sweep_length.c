#include "emu/lab/sweep_length.h"

#include <math.h>
#include <stdlib.h>

#include "emu/trouble.h"

/* How far growth is shown: times the longest steady refresh. */
#define BEYOND 1.6

/* How long to wait for two refreshes of a program. */
#define PATIENCE_PS (30 * CRT_PS_PER_S)

struct vm_list_shape vm_length_shape(const struct vm_length *l, enum vm_list_kind kind, bool sync)
{
    return vm_list_shape(&l->settings->monitor[VM_VECTOR].row, kind, l->units[kind], sync);
}

struct vm_longest vm_length_longest(const struct vm_length *l, enum vm_list_kind kind)
{
    struct vm_list_shape free = vm_length_shape(l, kind, false);
    struct vm_list_shape locked = vm_length_shape(l, kind, true);
    uint32_t bytes = l->settings->memory_bytes;
    struct vm_longest r = {.memory_ends = false};
    for (int t = 0; t < VM_TIMINGS; t++) {
        r.free[t] = vm_list_longest(&free, &l->timing[t], l->steady.longest, bytes);
        r.locked[t] = l->steady.ticks == 0
                          ? 0
                          : vm_list_longest(&locked, &l->timing[t], l->steady.locked_ps, bytes);
    }
    r.memory_ends = r.free[DF_TIMING_VALUE] == vm_list_most(&free, bytes);
    return r;
}

double vm_length_times(const struct vm_length *l, bool locked, enum df_timing_choice choice)
{
    uint64_t room = locked ? l->steady.locked_ps : l->steady.longest;
    return (double)room / (double)l->program.ps[choice];
}

/* ---- growth ------------------------------------------------------------------------------------- */

/* Amounts are whole items, or any number of times a program. */
static struct vm_growth_row row_of(const struct vm_length *l, double amount)
{
    struct vm_growth_row r = {.amount = amount};
    struct vm_list_shape free = vm_length_shape(l, l->kind, false);
    struct vm_list_shape locked = vm_length_shape(l, l->kind, true);
    for (int t = 0; t < VM_TIMINGS; t++)
        r.ps[t] = l->program.given ? (uint64_t)((double)l->program.ps[t] * amount)
                                   : vm_list_ps(&free, &l->timing[t], (long)amount);
    r.locked_ps = l->program.given ? r.ps[DF_TIMING_VALUE]
                                   : vm_list_ps(&locked, &l->timing[DF_TIMING_VALUE], (long)amount);
    r.free_hz = vm_steady_free_hz(r.ps[DF_TIMING_VALUE]);
    r.locked_hz = vm_steady_locked_hz(&l->steady, r.locked_ps);
    r.free_flickers = vm_steady_flickers(&l->steady, r.free_hz);
    r.locked_flickers = vm_steady_flickers(&l->steady, r.locked_hz);
    return r;
}

/* 1, 2, 2.5 or 5 times a power of ten, at least `least`. */
static double round_step(double least)
{
    static const double steps[] = {1, 2, 2.5, 5, 10};
    double decade = 1e-3;
    int i = 0;
    while (decade * 10 <= least)
        decade *= 10;
    while (i < 4 && steps[i] * decade < least)
        i++;
    return steps[i] * decade;
}

static double furthest(const struct vm_length *l)
{
    double ps = BEYOND * (double)l->steady.longest;
    double two_ticks = 2.2 * (double)crt_tick_time(l->steady.tick, 1);
    ps = ps > two_ticks ? ps : two_ticks;
    if (l->program.given)
        return ps / (double)l->program.ps[DF_TIMING_VALUE];
    struct vm_list_shape shape = vm_length_shape(l, l->kind, true);
    return (double)vm_list_longest(&shape, &l->timing[DF_TIMING_VALUE], (uint64_t)ps,
                                   l->settings->memory_bytes);
}

static int by_amount(const void *a, const void *b)
{
    double x = ((const struct vm_growth_row *)a)->amount;
    double y = ((const struct vm_growth_row *)b)->amount;
    return (x > y) - (x < y);
}

/* The last that is steady and the first that is not, free and locked. */
static int add_limits(const struct vm_length *l, struct vm_growth_row *row)
{
    struct vm_longest most = vm_length_longest(l, l->kind);
    long last[] = {most.free[DF_TIMING_VALUE], most.locked[DF_TIMING_VALUE]};
    int count = 0;
    for (int i = 0; i < 2; i++)
        for (long n = last[i]; last[i] > 0 && n <= last[i] + 1; n++)
            row[count++] = row_of(l, (double)n);
    return count;
}

static void sort_rows(struct vm_growth *g)
{
    int kept = 0;
    qsort(g->row, (size_t)g->count, sizeof *g->row, by_amount);
    for (int i = 0; i < g->count; i++)
        if (kept == 0 || g->row[i].amount > g->row[kept - 1].amount)
            g->row[kept++] = g->row[i];
    g->count = kept;
}

bool vm_length_growth(const struct vm_length *l, int steps, bool limits, struct vm_growth *g,
                      struct crt_error *err)
{
    double end = furthest(l), step = round_step(end / steps);
    if (!l->program.given)
        step = ceil(step);
    *g = (struct vm_growth){.row = calloc((size_t)steps + 16, sizeof *g->row)};
    if (!g->row)
        return crt_fail(err, "not enough memory for the table; close other programs");
    for (int i = 1; i <= steps + 8 && i * step <= end; i++)
        g->row[g->count++] = row_of(l, i * step);
    if (limits && !l->program.given)
        g->count += add_limits(l, g->row + g->count);
    sort_rows(g);
    if (l->program.given) {
        snprintf(g->label, sizeof g->label, "times %s", l->program.name);
    } else {
        struct vm_list_shape shape = vm_length_shape(l, l->kind, false);
        vm_list_describe(&shape, g->label, sizeof g->label);
    }
    return true;
}

/* ---- a program ---------------------------------------------------------------------------------- */

/* Its first refresh, and when the second began. */
static bool run_program(struct vm_length *l, const struct vm_input *input,
                        enum df_timing_choice choice, struct crt_error *err)
{
    struct vm_program_time *p = &l->program;
    struct vm_rig rig;
    if (!vm_rig_open(&rig, l->settings, input, choice, NULL, err))
        return false;
    struct vm_machine *m = rig.machine;
    bool ok = vm_machine_run_refresh(m, PATIENCE_PS);
    if (!ok && !vm_find_trouble(m, input, err))
        crt_fail(err, "%s completes no refresh in %d s; it has no end and does not come round",
                 input->name, (int)(PATIENCE_PS / CRT_PS_PER_S));
    struct vm_refresh first = m->refreshes.last;
    if (ok && m->refreshes.declared)
        ok = crt_fail(
            err,
            "the firmware of %s says itself where a refresh begins, waiting included: how long "
            "the drawing takes is not known",
            input->name);
    if (ok && vm_machine_uses_raster(m) && !vm_machine_uses_vector(m))
        ok = crt_fail(err,
                      "%s draws with the raster head alone, whose refresh rate is its mode's "
                      "(kinescope list modes)",
                      input->name);
    if (ok) {
        p->ps[choice] = first.end - first.begin;
        p->synchronised = m->refreshes.flow.synchronised || m->refreshes.flow.stops;
        if (choice == DF_TIMING_VALUE && vm_machine_run_refresh(m, m->now + PATIENCE_PS))
            p->hz = (double)CRT_PS_PER_S / (double)(m->refreshes.last.begin - first.begin);
    }
    vm_rig_close(&rig);
    return ok;
}

bool vm_length_measure(struct vm_length *l, const struct vm_input *input, struct crt_error *err)
{
    l->program = (struct vm_program_time){.given = true};
    snprintf(l->program.name, sizeof l->program.name, "%s", input->name);
    for (int t = 0; t < VM_TIMINGS; t++)
        if (!run_program(l, input, (enum df_timing_choice)t, err))
            return false;
    return true;
}
