/* How long a list may grow: as tables for people, and as CSV. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "emu/lab/sweep_length.h"

#define TABLE_STEPS 12
#define CSV_STEPS   100

/* ---- what it is about --------------------------------------------------------------------------- */

static void print_subject(FILE *to, const struct vm_length *l)
{
    const struct vm_steady *s = &l->steady;
    const struct vm_monitor *m = &l->settings->monitor[VM_VECTOR];
    char text[400], rate[64];
    snprintf(rate, sizeof rate, s->held ? "every rate" : "%.4g Hz, less in proportion below it",
             s->at_hz);
    snprintf(
        text, sizeof text,
        "%s with %s, lines of %.3g cd/m2 at %s. A viewer of a field of %.0f degrees, pupil %g mm.",
        m->row.name, m->phosphor.name, s->cd_m2, rate, crt_fields_deg[s->viewer.field],
        s->viewer.pupil_mm);
    vm_print_wrapped(to, text, 0);
}

static void print_bound(FILE *to, const struct vm_length *l)
{
    const struct vm_steady *s = &l->steady;
    double tick_hz = crt_rate_hz(s->tick);
    char text[400], time[32], bound[64];
    vm_format_time(s->longest, time, sizeof time);
    snprintf(bound, sizeof bound, "Below %.1f Hz (%.3g cd/m2 then) it flickers", s->hz,
             vm_steady_luminance(s, s->hz));
    if (s->hz <= VM_STEADY_LEAST_HZ)
        snprintf(text, sizeof text,
                 "Too dim to flicker at %g Hz or more; the model does not hold for less.",
                 VM_STEADY_LEAST_HZ);
    else if (s->ticks == 0)
        snprintf(
            text, sizeof text,
            "%s: running freely a refresh may take %s; locked to the tick of %.4g Hz it flickers "
            "however short the list.",
            bound, time, tick_hz);
    else
        snprintf(
            text, sizeof text,
            "%s: running freely a refresh may take %s; locked to the tick of %.4g Hz, %d tick%s, "
            "which is %.4g Hz.",
            bound, time, tick_hz, s->ticks, s->ticks == 1 ? "" : "s", tick_hz / s->ticks);
    vm_print_wrapped(to, text, 0);
}

/* ---- the longest lists -------------------------------------------------------------------------- */

static void print_range(FILE *to, const long *n, int width)
{
    char text[96];
    if (n[DF_TIMING_VALUE] == 0)
        snprintf(text, sizeof text, "none");
    else
        snprintf(text, sizeof text, "%ld (%ld to %ld)", n[DF_TIMING_VALUE], n[DF_TIMING_HIGH],
                 n[DF_TIMING_LOW]);
    fprintf(to, "  %-*s", width, text);
}

static void print_longest(FILE *to, const struct vm_length *l)
{
    bool full = false;
    const struct crt_tube_row *row = &l->settings->monitor[VM_VECTOR].row;
    fprintf(to, "\nThe longest list that does not flicker (and the range that follows from the "
                "row's times):\n");
    fprintf(to, "  %-34s %8s  %-23s  %s\n", "", "each", "free running", "locked to the tick");
    for (int k = 0; k < VM_LIST_KINDS; k++) {
        struct vm_longest most = vm_length_longest(l, (enum vm_list_kind)k);
        struct vm_list_shape s = vm_length_shape(l, (enum vm_list_kind)k, false);
        char name[64], each[32];
        vm_list_describe(&s, name, sizeof name);
        if (k != VM_LIST_CHARACTERS) {
            size_t n = strlen(name);
            snprintf(name + n, sizeof name - n, ", %.3g mm",
                     s.units * row->width.value / row->units_x.value);
        }
        vm_format_time((uint64_t)vm_list_item_ps(&s, &l->timing[DF_TIMING_VALUE]), each,
                       sizeof each);
        fprintf(to, "  %-34s %8s", name, each);
        print_range(to, most.free, 23);
        print_range(to, most.locked, 0);
        fprintf(to, "%s\n", most.memory_ends ? " *" : "");
        full |= most.memory_ends;
    }
    if (full)
        fprintf(to, "  * then, running freely, the memory is full\n");
}

/* ---- growth ------------------------------------------------------------------------------------- */

static const char *verdict(bool flickers)
{
    return flickers ? "flickers" : "steady";
}

static void print_growth(FILE *to, const struct vm_length *l)
{
    struct vm_growth g;
    struct crt_error err;
    if (!vm_length_growth(l, TABLE_STEPS, true, &g, &err)) {
        fprintf(to, "%s\n", err.text);
        return;
    }
    fprintf(to, "\nHow the rate falls, %s:\n  %9s  %10s   %-20s %s\n", g.label,
            l->program.given ? "times" : vm_list_name(l->kind), "takes", "free running",
            "locked to the tick");
    for (int i = 0; i < g.count; i++) {
        const struct vm_growth_row *r = &g.row[i];
        char text[32];
        vm_format_time(r->ps[DF_TIMING_VALUE], text, sizeof text);
        fprintf(to, "  %9g  %10s   %6.1f Hz %-10s %6.1f Hz %s\n", r->amount, text, r->free_hz,
                verdict(r->free_flickers), r->locked_hz, verdict(r->locked_flickers));
    }
    free(g.row);
}

/* What is printed is still steady. */
static double down(double times)
{
    return floor(times * 100) / 100;
}

static void print_times(FILE *to, const struct vm_length *l, bool locked)
{
    fprintf(to, "  %-20s %.2f times as much (%.2f to %.2f)\n",
            locked ? "locked to the tick" : "free running",
            down(vm_length_times(l, locked, DF_TIMING_VALUE)),
            down(vm_length_times(l, locked, DF_TIMING_HIGH)),
            down(vm_length_times(l, locked, DF_TIMING_LOW)));
}

static void print_program(FILE *to, const struct vm_length *l)
{
    const struct vm_program_time *p = &l->program;
    char text[32], low[32], high[32];
    vm_format_time(p->ps[DF_TIMING_VALUE], text, sizeof text);
    vm_format_time(p->ps[DF_TIMING_LOW], low, sizeof low);
    vm_format_time(p->ps[DF_TIMING_HIGH], high, sizeof high);
    fprintf(to, "\n%s takes %s a refresh (%s to %s)", p->name, text, low, high);
    if (p->hz > 0)
        fprintf(to, "; now it is refreshed %.4g times a second: %s", p->hz,
                verdict(vm_steady_flickers(&l->steady, p->hz)));
    fprintf(to, ".\nBefore it flickers it could show\n");
    print_times(to, l, false);
    if (l->steady.ticks > 0)
        print_times(to, l, true);
    else
        fprintf(to, "  %-20s nothing: the tick itself flickers\n", "locked to the tick");
}

void vm_length_print(FILE *to, const struct vm_length *l)
{
    print_subject(to, l);
    print_bound(to, l);
    if (l->program.given)
        print_program(to, l);
    else
        print_longest(to, l);
    print_growth(to, l);
    fputc('\n', to);
    vm_print_wrapped(to, vm_steady_model, 0);
}

/* ---- CSV ---------------------------------------------------------------------------------------- */

void vm_length_print_csv(FILE *to, const struct vm_length *l)
{
    struct vm_growth g;
    struct crt_error err;
    struct vm_list_shape s = vm_length_shape(l, l->kind, false);
    fputs("of,units,amount,refresh_s,refresh_low_s,refresh_high_s,free_hz,free_flickers,locked_hz,"
          "locked_flickers,cd_m2_free,cd_m2_locked\n",
          to);
    if (!vm_length_growth(l, CSV_STEPS, true, &g, &err))
        return;
    for (int i = 0; i < g.count; i++) {
        const struct vm_growth_row *r = &g.row[i];
        fprintf(to, "%s,%d,%.9g", l->program.given ? "program" : vm_list_name(l->kind),
                l->program.given || l->kind == VM_LIST_CHARACTERS ? 0 : s.units, r->amount);
        for (int t = 0; t < VM_TIMINGS; t++)
            fprintf(to, ",%.12g", (double)r->ps[t] / (double)CRT_PS_PER_S);
        fprintf(to, ",%.9g,%s,%.9g,%s,%.9g,%.9g\n", r->free_hz, r->free_flickers ? "true" : "false",
                r->locked_hz, r->locked_flickers ? "true" : "false",
                vm_steady_luminance(&l->steady, r->free_hz),
                vm_steady_luminance(&l->steady, r->locked_hz));
    }
    free(g.row);
}
