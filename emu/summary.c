#include "emu/summary.h"

#include <math.h>

#include "emu/trouble.h"

/* How long to wait for two refreshes to be complete. */
#define PATIENCE_PS (30 * CRT_PS_PER_S)

/* What one run measured: sums over `refreshes`, and how far apart they begin. */
struct measure {
    uint64_t refreshes;
    uint64_t shortest, longest, total;
    uint64_t words, instructions, strokes, lit, colours;
    uint64_t first_begin, last_begin, periods;
    uint64_t late, first_late,
        first_late_begin; /* refreshes longer than a tick; the first's number */
    struct vm_flow flow;
    bool declared; /* by firmware: refreshes have the waiting between them in them */
};

static void add(struct measure *m, const struct vm_refresh *r, uint64_t tick)
{
    uint64_t took = r->end - r->begin;
    if (took > tick && m->late++ == 0) {
        m->first_late = m->refreshes + 1;
        m->first_late_begin = r->begin;
    }
    m->shortest = m->refreshes == 0 || took < m->shortest ? took : m->shortest;
    m->longest = took > m->longest ? took : m->longest;
    m->refreshes++;
    m->total += took;
    m->words += r->words;
    m->instructions += r->instructions;
    m->strokes += r->strokes;
    m->lit += r->lit;
}

static void add_period(struct measure *m, const struct vm_refresh *r, bool first)
{
    if (first)
        m->first_begin = r->begin;
    else
        m->periods++;
    m->last_begin = r->begin;
}

static bool measure(const struct vm_settings *s, const struct vm_input *input,
                    enum df_timing_choice timing, uint64_t length, struct measure *result,
                    struct crt_error *err)
{
    struct vm_rig rig;
    *result = (struct measure){0};
    if (!vm_rig_open(&rig, s, input, timing, NULL, err))
        return false;
    struct vm_machine *m = rig.machine;
    /* Without a length the figures are of the first refresh; the second gives the rate. */
    while ((length || result->periods == 0) &&
           vm_machine_run_refresh(m, length ? length : PATIENCE_PS)) {
        add_period(result, &m->refreshes.last, result->refreshes == 0);
        if (length || result->refreshes == 0) {
            add(result, &m->refreshes.last, crt_tick_time(s->tick, 1));
            result->colours = m->dpu.usage.colours;
        }
    }
    result->flow = m->refreshes.flow;
    result->declared = m->refreshes.declared;
    if (result->refreshes == 0 && !vm_find_trouble(m, input, err))
        crt_fail(err, "%s completes no refresh in that time; it has no end and does not come round",
                 input->name);
    bool measured = result->refreshes > 0;
    if (measured && vm_machine_uses_raster(m) && !vm_machine_uses_vector(m))
        measured = crt_fail(err,
                            "--summary measures the vector head, and %s draws with the raster head "
                            "alone; kinescope list modes tells the times of its mode",
                            input->name);
    vm_rig_close(&rig);
    return measured;
}

static double mean(uint64_t sum, const struct measure *m)
{
    return (double)sum / (double)m->refreshes;
}

static void print_count(FILE *out, const char *name, uint64_t sum, const struct measure *m)
{
    if (sum % m->refreshes == 0)
        fprintf(out, "  %-13s %llu a refresh", name, (unsigned long long)(sum / m->refreshes));
    else
        fprintf(out, "  %-13s %.2f a refresh, on average", name, mean(sum, m));
}

static void print_refresh(FILE *out, const struct vm_settings *s, const struct measure *m,
                          const struct measure *low, const struct measure *high)
{
    char text[32], from[32], to[32];
    vm_format_time(m->total / m->refreshes, text, sizeof text);
    fprintf(out, "  %-13s %s", "refresh time", text);
    if (m->longest - m->shortest > m->longest / 1000000) {
        vm_format_time(m->shortest, from, sizeof from);
        vm_format_time(m->longest, to, sizeof to);
        fprintf(out, " on average, %s to %s", from, to);
    }
    if (s->average_ps) {
        vm_format_time(s->average_ps, from, sizeof from);
        fprintf(out, " (every instruction takes %s, as set)\n", from);
        return;
    }
    vm_format_time(low->total / low->refreshes, from, sizeof from);
    vm_format_time(high->total / high->refreshes, to, sizeof to);
    fprintf(out, ", uncertain: %s to %s (times of the %s row; list tubes --why)\n", from, to,
            s->monitor[VM_VECTOR].row.name);
}

static void print_rate(FILE *out, const struct vm_input *input, const struct measure *m)
{
    const char *stops = input->has_firmware ? "started again by its firmware"
                                            : "started again at the sync tick after its stop word";
    if (m->periods == 0) {
        fprintf(out, "  %-13s none: the program is not refreshed again\n", "refresh rate");
        return;
    }
    double hz =
        (double)m->periods * (double)CRT_PS_PER_S / (double)(m->last_begin - m->first_begin);
    fprintf(out, "  %-13s %.4g Hz, %s\n", "refresh rate", hz,
            m->declared            ? "as its firmware declares it, waiting included"
            : m->flow.synchronised ? "waiting for the sync tick"
            : m->flow.stops        ? stops
                                   : "running freely, without sync");
}

static void print_fit(FILE *out, const struct vm_settings *s, const struct measure *m,
                      const struct measure *high)
{
    uint64_t tick = crt_tick_time(s->tick, 1);
    double hz = (double)s->tick.num / (double)s->tick.den;
    char text[32], spare[32];
    vm_format_time(tick, text, sizeof text);
    fprintf(out, "  %-13s %s (%.4g Hz): ", "sync tick", text, hz);
    if (m->late > 0 && m->refreshes > 1) {
        vm_format_time(m->longest - tick, spare, sizeof spare);
        vm_format_time(m->first_late_begin, text, sizeof text);
        fprintf(out,
                "%llu of %llu refreshes exceed it, the first is number %llu at %s; the longest "
                "exceeds it by %s and takes %.0f ticks\n",
                (unsigned long long)m->late, (unsigned long long)m->refreshes,
                (unsigned long long)m->first_late, text, spare,
                ceil((double)m->longest / (double)tick));
        return;
    }
    if (m->longest > tick) {
        vm_format_time(m->longest - tick, spare, sizeof spare);
        fprintf(out, "the refresh exceeds it by %s and takes %.0f ticks: it flickers more\n", spare,
                ceil((double)m->longest / (double)tick));
        return;
    }
    vm_format_time(tick - m->longest, spare, sizeof spare);
    fprintf(out, "the refresh fits, with %s to spare%s\n", spare,
            !s->average_ps && high->longest > tick
                ? "; at the slow end of its uncertainty it does not"
                : "");
}

static void print_all(FILE *out, const struct vm_settings *s, const struct vm_input *input,
                      const struct measure *m, const struct measure *low,
                      const struct measure *high)
{
    fprintf(out, "%s on %s (%s)", input->name, s->monitor[VM_VECTOR].row.name,
            s->monitor[VM_VECTOR].phosphor.name);
    if (m->refreshes > 1)
        fprintf(out, ", %llu refreshes", (unsigned long long)m->refreshes);
    else
        fprintf(out, ", the first refresh (--for T measures all within T)");
    fputc('\n', out);
    print_refresh(out, s, m, low, high);
    print_rate(out, input, m);
    if (!m->declared)
        print_fit(out, s, m, high);
    print_count(out, "words", m->words, m);
    fputc('\n', out);
    print_count(out, "instructions", m->instructions, m);
    fputs(input->has_firmware ? ", of the display processor\n" : "\n", out);
    print_count(out, "strokes", m->strokes, m);
    fprintf(out, ", beam on for %.1f %% of the refresh\n",
            100.0 * (double)m->lit / (double)m->total);
}

/* Changes of the colour and what they cost, on a tube where they do. */
static void print_colours(FILE *out, const struct vm_settings *s, const struct measure *m)
{
    char text[32];
    if (m->colours == 0)
        return;
    print_count(out, "colours", m->colours, m);
    double ps =
        s->average_ps ? 0 : s->monitor[VM_VECTOR].row.colour_switch.value * (double)CRT_PS_PER_US;
    vm_format_time((uint64_t)(mean(m->colours, m) * ps), text, sizeof text);
    if (ps > 0)
        fprintf(out, ", with the beam off for %s while they change", text);
    fputc('\n', out);
}

int vm_print_summary(FILE *out, const struct vm_time *length, const struct vm_settings *s,
                     const struct vm_input *input, struct crt_error *err)
{
    struct measure m, low, high;
    uint64_t ps = 0;
    if (length->given && !vm_time_ps(length, s->tick, &ps, err))
        return 2;
    if (!measure(s, input, DF_TIMING_VALUE, ps, &m, err) ||
        !measure(s, input, DF_TIMING_LOW, ps, &low, err) ||
        !measure(s, input, DF_TIMING_HIGH, ps, &high, err))
        return 1;
    print_all(out, s, input, &m, &low, &high);
    print_colours(out, s, &m);
    if (m.strokes == 0) {
        crt_fail(err, "%s never lights the beam in the time measured", input->name);
        return 1;
    }
    return 0;
}
