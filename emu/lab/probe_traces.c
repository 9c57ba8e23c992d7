/* probe_traces.c — deflection and grid signals as CSV and as panels of a plot. */
#include <stdlib.h>
#include <string.h>

#include "emu/command.h"
#include "emu/lab/probe_parts.h"
#include "emu/out_file.h"

#define COLUMNS (2 + CRT_MAX_GUNS)

struct column {
    const struct vm_trace *trace;
    const char *name;
    size_t next; /* of the trace, while it is walked through */
};

struct table {
    struct column column[COLUMNS];
    int count;
};

static void add_column(struct table *table, const struct vm_trace *trace, const char *name)
{
    table->column[table->count++] = (struct column){trace, name, 0};
}

static struct table columns_of(const struct vm_signals *s, unsigned wanted)
{
    static const char *const guns[] = {"z_red", "z_green", "z_blue"};
    struct table table = {.count = 0};
    if (wanted >> VM_SIGNAL_X & 1)
        add_column(&table, &s->x, "x_mm");
    if (wanted >> VM_SIGNAL_Y & 1)
        add_column(&table, &s->y, "y_mm");
    for (int g = 0; g < s->guns && (wanted >> VM_SIGNAL_Z & 1); g++)
        add_column(&table, &s->z[g], s->guns == 1 ? "z" : guns[g]);
    return table;
}

/* ---- CSV ---------------------------------------------------------------------------------------- */

static void print_time(FILE *out, uint64_t t)
{
    char text[VM_SECONDS_TEXT];
    vm_plain_seconds(t, text, sizeof text);
    fputs(text, out);
}

static void print_even(FILE *out, const struct table *table, uint64_t from, uint64_t to, double hz)
{
    for (uint64_t n = 0;; n++) {
        double dt = (double)n / hz * 1e12;
        if (!(dt < (double)(to - from)))
            return;
        uint64_t t = from + (uint64_t)(dt + 0.5);
        print_time(out, t);
        for (int i = 0; i < table->count; i++) {
            putc(',', out);
            vm_probe_number(out, vm_trace_at(table->column[i].trace, t));
        }
        putc('\n', out);
    }
}

static uint64_t next_time(const struct table *table)
{
    uint64_t t = UINT64_MAX;
    for (int i = 0; i < table->count; i++) {
        const struct column *c = &table->column[i];
        if (c->next < c->trace->count && c->trace->t[c->next] < t)
            t = c->trace->t[c->next];
    }
    return t;
}

/* The values just before t or, where some have an entry there, at the entry each is at. */
static void print_row(FILE *out, const struct table *table, uint64_t t)
{
    print_time(out, t);
    for (int i = 0; i < table->count; i++) {
        const struct column *c = &table->column[i];
        bool here = c->next < c->trace->count && c->trace->t[c->next] == t;
        putc(',', out);
        vm_probe_number(out, here ? c->trace->v[c->next] : vm_trace_before(c->trace, t));
    }
    putc('\n', out);
}

/* A row for each bend of any of them; where one jumps two rows of one time. */
static void print_bends(FILE *out, struct table *table)
{
    for (uint64_t t; (t = next_time(table)) != UINT64_MAX;) {
        print_row(out, table, t);
        bool jumps = false;
        for (int i = 0; i < table->count; i++) {
            struct column *c = &table->column[i];
            size_t last = c->next, n = c->trace->count;
            if (last >= n || c->trace->t[last] != t)
                continue;
            while (last + 1 < n && c->trace->t[last + 1] == t)
                last++;
            jumps = jumps || c->trace->v[last] != c->trace->v[c->next];
            c->next = last;
        }
        if (jumps)
            print_row(out, table, t);
        for (int i = 0; i < table->count; i++) {
            struct column *c = &table->column[i];
            if (c->next < c->trace->count && c->trace->t[c->next] == t)
                c->next++;
        }
    }
}

static bool write_csv(const struct vm_probe_job *job, const struct vm_signals *s,
                      struct crt_error *err)
{
    struct vm_out out;
    struct crt_error closing;
    struct table table = columns_of(s, job->signals);
    bool ok = vm_out_open(&out, job->o.csv, err);
    if (ok) {
        fputs("t_s", out.file);
        for (int i = 0; i < table.count; i++)
            fprintf(out.file, ",%s", table.column[i].name);
        putc('\n', out.file);
        if (job->o.rate > 0)
            print_even(out.file, &table, job->from, job->to, job->o.rate);
        else
            print_bends(out.file, &table);
    }
    return vm_out_close(&out, ok, ok ? err : &closing) && ok;
}

/* ---- plot --------------------------------------------------------------------------------------- */

/* The axis of time in the unit that suits the length. */
struct scale {
    double ps;
    const char *unit;
};

static struct scale scale_of(uint64_t length)
{
    return length >= 2 * CRT_PS_PER_MS ? (struct scale){1e9, "ms"} : (struct scale){1e6, "µs"};
}

static double *times_of(const struct vm_trace *trace, uint64_t from, struct scale scale)
{
    double *x = malloc(trace->count * sizeof *x);
    for (size_t i = 0; x && i < trace->count; i++)
        x[i] = (double)(trace->t[i] - from) / scale.ps;
    return x;
}

/* False: there was no memory for the times. */
static bool add_series(struct vm_plot_panel *panel, const struct vm_trace *trace, int colour,
                       const double *x)
{
    panel->series[panel->series_count++] =
        (struct vm_plot_series){NULL, VM_PLOT_LINE, x, trace->v, trace->count, colour, false};
    return x != NULL;
}

static struct vm_plot_panel *add_panel(struct vm_plot *plot, const char *label, double low,
                                       double high)
{
    struct vm_plot_panel *panel = &plot->panel[plot->panel_count++];
    panel->y = (struct vm_plot_axis){label, false, low, high};
    return panel;
}

static bool fill(struct vm_plot *plot, const struct vm_probe_job *job, const struct vm_signals *s,
                 struct scale scale, double *x[COLUMNS])
{
    static const char *const guns[] = {"z red", "z green", "z blue"};
    static const int colours[] = {1, 2, 0}; /* of the palette: nearest to the guns' */
    bool ok = true;
    int n = 0;
    if (job->signals >> VM_SIGNAL_X & 1)
        ok = add_series(add_panel(plot, "x, mm", 0, 0), &s->x, 0,
                        x[n++] = times_of(&s->x, job->from, scale));
    if (job->signals >> VM_SIGNAL_Y & 1)
        ok = add_series(add_panel(plot, "y, mm", 0, 0), &s->y, 0,
                        x[n++] = times_of(&s->y, job->from, scale)) &&
             ok;
    for (int g = 0; g < s->guns && (job->signals >> VM_SIGNAL_Z & 1); g++)
        ok = add_series(add_panel(plot, s->guns == 1 ? "z, of full drive" : guns[g], 0, 1.05),
                        &s->z[g], s->guns == 1 ? 0 : colours[g],
                        x[n++] = times_of(&s->z[g], job->from, scale)) &&
             ok;
    return ok;
}

static bool draw(const struct vm_probe_job *job, const struct vm_signals *s, const char *title,
                 struct crt_image *image, struct crt_error *err)
{
    struct scale scale = scale_of(job->to - job->from);
    double *x[COLUMNS] = {0};
    char label[64], from[32];
    vm_format_time(job->from, from, sizeof from);
    snprintf(label, sizeof label, "time after %s, %s", from, scale.unit);
    struct vm_plot plot = {
        .title = title,
        .x = {label, false, 0, (double)(job->to - job->from) / scale.ps},
        .note = s->head == VM_RASTER
                    ? "deflection from the timing, flyback as a straight line during sync pulses"
                    : "deflection while the beam is off: straight lines of the settling time"};
    bool ok = fill(&plot, job, s, scale, x) ||
              crt_fail(err, "not enough memory for the plot; shorten the time");
    ok = ok && vm_plot_draw(&plot, job->o.size.width ? job->o.size : vm_plot_size,
                            job->o.projector ? VM_PLOT_PROJECTOR : VM_PLOT_PAPER, image, err);
    for (int i = 0; i < COLUMNS; i++)
        free(x[i]);
    return ok;
}

static bool write_plot(const struct vm_probe_job *job, const struct vm_signals *s,
                       struct crt_error *err)
{
    struct crt_image image;
    char title[160];
    snprintf(title, sizeof title, "%s on %s: signals of the %s head", job->input.name,
             job->settings.monitor[s->head].row.name, s->head == VM_RASTER ? "raster" : "vector");
    if (!draw(job, s, title, &image, err))
        return false;
    bool ok = vm_plot_write(job->o.out, &image, title, err);
    crt_image_free(&image);
    return ok;
}

/* ------------------------------------------------------------------------------------------------- */

int vm_probe_signals(struct vm_probe_job *job, struct crt_error *err)
{
    struct vm_rig rig;
    struct vm_signals signals;
    if (!vm_rig_open(&rig, &job->settings, &job->input, DF_TIMING_VALUE, NULL, err))
        return VM_EXIT_TROUBLE;
    bool ok = vm_saved_load(&job->o.saved, &rig, &job->settings, &job->input, err) &&
              vm_signals_record(&signals, &rig, job->place.head, job->from, job->to, err);
    if (ok) {
        ok = (!job->o.csv || write_csv(job, &signals, err)) &&
             (!job->o.out || write_plot(job, &signals, err));
        vm_signals_free(&signals);
    }
    vm_rig_close(&rig);
    return ok ? VM_EXIT_OK : VM_EXIT_TROUBLE;
}
