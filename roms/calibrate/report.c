/* report.c — the table on the console: of each place the firing, the error before and after. */
#include <stdio.h>

#include "roms/calibrate/calibrate.h"
#include "roms/geometry/scalar.h"
#include "roms/stage/tenths.h"

void report_begin(const struct calibration *c)
{
    printf("calibrate: %u x %u, dot clock %u Hz, %d targets, %d checks\n",
           (unsigned)c->timing.h_visible, (unsigned)c->timing.v_visible,
           (unsigned)c->timing.clock_hz, TARGETS, CHECKS);
}

static void row(const char *kind, int number, const struct place *p)
{
    const float values[] = {p->dot, p->line, p->spread, p->dx, p->dy, p->left_x, p->left_y};
    static const int widths[] = {7, 7, 7, 8, 6, 8, 6};
    printf("%-6s %2d %5d %5d", kind, number, p->x, p->y);
    for (int i = 0; i < 7; i++) {
        char text[16];
        tenths_text(text, sizeof text, values[i], widths[i], i > 2);
        printf("%s", text);
    }
    printf(" %5d\n", p->rows);
}

static void worst(const struct calibration *c, const char *kind, int first, int end)
{
    char b[12], a[12];
    float before = 0, after = 0;
    for (int i = first; i < end; i++) {
        const struct place *p = &c->place[i];
        before = scalar_max(before, measure_length(p->dx, p->dy));
        after = scalar_max(after, measure_length(p->left_x, p->left_y));
    }
    tenths_text(b, sizeof b, before, 0, false);
    tenths_text(a, sizeof a, after, 0, false);
    printf("%s: worst error before %s, after %s pixels\n", kind, b, a);
}

void report_offset(const struct calibration *c)
{
    char dots[12], lines[12];
    printf("                       pen fires at           error before   error after\n");
    printf("target       x     y    dot   line spread    dots lines    dots lines  rows\n");
    for (int i = 0; i < TARGETS; i++)
        row("target", i + 1, &c->place[i]);
    worst(c, "targets", 0, TARGETS);
    tenths_text(dots, sizeof dots, c->dots, 0, true);
    tenths_text(lines, sizeof lines, c->lines, 0, true);
    printf("offset: %s dots, %s lines\n", dots, lines);
    printf("pen: sees %d um, fires %d ns late\n", c->sees_um, c->late_ns);
}

void report_checks(const struct calibration *c)
{
    for (int i = TARGETS; i < PLACES; i++)
        row("check", i - TARGETS + 1, &c->place[i]);
    worst(c, "checks", TARGETS, PLACES);
}
