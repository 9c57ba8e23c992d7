#include "emu/list_modes.h"

#include <stdio.h>
#include <string.h>

#include "raster/mode.h"

/* "1024+24+136+160 = 1344": visible, front porch, sync, back porch. */
static void span_text(char text[48], const struct ras_span *s)
{
    snprintf(text, 48, "%u+%u+%u+%u = %u", s->visible, s->sync_start - s->visible,
             s->sync_end - s->sync_start, s->total - s->sync_end, s->total);
}

static void print_row(const struct ras_mode *mode)
{
    const struct ras_timing *t = &mode->timing;
    char dots[48], lines[48];
    span_text(dots, &t->h);
    span_text(lines, &t->v);
    printf("%-13s %8.3f %8.3f %7.3f  %-23s %-18s  %c%c\n", mode->name, crt_rate_hz(t->clock) / 1e6,
           crt_rate_hz(ras_line_rate(t)) / 1e3, crt_rate_hz(ras_field_rate(t)), dots, lines,
           t->h_plus ? '+' : '-', t->v_plus ? '+' : '-');
}

static void print_span(const char *what, const struct ras_span *s, double unit, const char *units,
                       bool plus)
{
    printf("  %-10s %u visible, front porch %u, sync %u, back porch %u, total %u\n", what,
           s->visible, s->sync_start - s->visible, s->sync_end - s->sync_start,
           s->total - s->sync_end, s->total);
    printf("  %-10s visible %.3f %s, sync %.3f %s, %s\n", "", s->visible * unit, units,
           (s->sync_end - s->sync_start) * unit, units, plus ? "positive" : "negative");
}

static void explain(const char *name, const char *description, const char *source,
                    const struct ras_timing *t)
{
    double clock = crt_rate_hz(t->clock), line = crt_rate_hz(ras_line_rate(t)),
           field = crt_rate_hz(ras_field_rate(t));
    printf("%s — %s\n", name, description);
    printf("  %-10s %.3f MHz: a dot lasts %.4f ns\n", "dot clock", clock / 1e6, 1e9 / clock);
    printf("  %-10s %.4f kHz: a line lasts %.4f us\n", "line rate", line / 1e3, 1e6 / line);
    if (t->interlaced)
        printf("  %-10s %.4f Hz: a field lasts %.4f ms; two make a frame, %.4f Hz\n", "fields",
               field, 1e3 / field, field / 2);
    else
        printf("  %-10s %.4f Hz: a frame lasts %.4f ms\n", "frames", field, 1e3 / field);
    print_span("dots", &t->h, 1e6 / clock, "us", t->h_plus);
    print_span("lines", &t->v, (t->interlaced ? 0.5e3 : 1e3) / line, "ms", t->v_plus);
    printf("  %-10s %s\n", "source", source);
}

void vm_list_modes(bool why)
{
    size_t count;
    const struct ras_mode *modes = ras_modes(&count);
    if (!why)
        printf("%-13s %8s %8s %7s  %-23s %-18s  %s\n", "mode", "dots MHz", "kHz", "Hz",
               "visible+front+sync+back", "lines of the frame", "sync h v");
    for (size_t i = 0; i < count; i++) {
        if (why && i > 0)
            printf("\n");
        if (why)
            explain(modes[i].name, modes[i].description, modes[i].source, &modes[i].timing);
        else
            print_row(&modes[i]);
    }
    if (!why)
        printf(
            "\nInterlaced modes end in i: Hz are fields, two make a frame. Any other size and "
            "rate, "
            "such as\n1400x1050@75 or 640x480@50i, is made by VESA's CVT formula; kinescope list "
            "modes 1400x1050@75\nshows it.\n");
}

bool vm_explain_mode(const char *name, struct crt_error *err)
{
    struct ras_timing timing;
    char own[48];
    size_t count;
    const struct ras_mode *modes = ras_modes(&count);
    if (!ras_mode_parse(name, &timing, err))
        return false;
    ras_timing_name(&timing, own, sizeof own);
    for (size_t i = 0; i < count; i++)
        if (strcmp(modes[i].name, own) == 0) {
            explain(own, modes[i].description, modes[i].source, &timing);
            return true;
        }
    explain(own, "by formula", "VESA CVT, normal blanking, as libxcvt computes it", &timing);
    return true;
}
