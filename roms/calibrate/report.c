/* report.c — the table on the console: of each place the firing, the error before and after. */
#include <stdio.h>
#include <stdlib.h>

#include "roms/calibrate/calibrate.h"
#include "roms/geometry/scalar.h"

void report_tenths(char *text, size_t size, float value, int width, bool sign)
{
    char number[24];
    int tenths = scalar_nearest(value * 10);
    snprintf(number, sizeof number, "%s%d.%d",
             tenths < 0 ? "-"
             : sign     ? "+"
                        : "",
             abs(tenths) / 10, abs(tenths) % 10);
    snprintf(text, size, "%*s", width, number);
}

void report_begin(const struct calibration *c)
{
    printf("calibrate: %u x %u, dot clock %u Hz, %d targets, %d checks\n",
           (unsigned)c->timing.h_visible, (unsigned)c->timing.v_visible,
           (unsigned)c->timing.clock_hz, TARGETS, CHECKS);
}

static void row(const char *kind, int number, const struct place *p)
{
    char bx[12], by[12], ax[12], ay[12];
    report_tenths(bx, sizeof bx, p->dx, 7, true);
    report_tenths(by, sizeof by, p->dy, 6, true);
    report_tenths(ax, sizeof ax, p->left_x, 7, true);
    report_tenths(ay, sizeof ay, p->left_y, 6, true);
    printf("%-6s %2d %5d %5d %5d %5d %6d %s %s %s %s\n", kind, number, p->x, p->y, p->dot, p->line,
           p->spread, bx, by, ax, ay);
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
    report_tenths(b, sizeof b, before, 0, false);
    report_tenths(a, sizeof a, after, 0, false);
    printf("%s: worst error before %s, after %s pixels\n", kind, b, a);
}

void report_offset(const struct calibration *c)
{
    char dots[12], lines[12];
    printf("                  pen fires at       error before  error after\n");
    printf("target       x     y   dot  line spread    dots  lines    dots  lines\n");
    for (int i = 0; i < TARGETS; i++)
        row("target", i + 1, &c->place[i]);
    worst(c, "targets", 0, TARGETS);
    report_tenths(dots, sizeof dots, c->dots, 0, true);
    report_tenths(lines, sizeof lines, c->lines, 0, true);
    float rows = c->timing.v_visible > 0 ? (float)c->timing.v_visible : 1;
    printf("offset: %s dots, %s lines: %d ns late, %d um above the middle\n", dots, lines,
           scalar_nearest(c->dots * 1e9f / (float)c->timing.clock_hz),
           scalar_nearest(-c->lines * (float)video_height_um() / rows));
}

void report_checks(const struct calibration *c)
{
    for (int i = TARGETS; i < PLACES; i++)
        row("check", i - TARGETS + 1, &c->place[i]);
    worst(c, "checks", TARGETS, PLACES);
}
