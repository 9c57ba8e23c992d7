/* Figures of the light pen: how far from the beam it points, when it fires, what rooms do to it. Plain
 * tables, a header line with units each; no timing. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "input/pen.h"

#define US UINT64_C(1000000)

static struct inp_pen_setup setup = {
#define X(field, unit, value, low, high, meaning, source) .field = {value, low, high, source},
    INP_PEN_FIGURES(X)
#undef X
};

static struct inp_pen pen;

static void make(const char *tube, const char *phosphor, uint64_t seed)
{
    const struct crt_tube_row *row = crt_tube_row_find(tube);
    struct inp_pen_desc desc = {
        &setup, row, crt_phosphor_find(phosphor ? phosphor : row->phosphor), {0, 1, 0}, seed};
    inp_pen_init(&pen, &desc);
    inp_hand_move(&pen.hand, (struct inp_place){0, 0, 0}, 0, 0);
}

static struct crt_stroke line_at(double speed, double drive)
{
    return (struct crt_stroke){.t0 = US,
                               .t1 = US + (uint64_t)(80 / speed * 1e6),
                               .x0 = -40,
                               .x1 = 40,
                               .drive = (float)drive};
}

/* Where the beam is when the pulse comes, mm right of the pen's middle. */
static bool fires_at(double speed, double drive, double *x)
{
    struct crt_stroke line = line_at(speed, drive);
    uint64_t when = inp_pen_offer(&pen, &line);
    *x = when == INP_NEVER ? 0 : -40 + 80 * ((double)(when - US) / (double)(line.t1 - US));
    return when != INP_NEVER;
}

/* ---- 1: a moving beam --------------------------------------------------------------------------- */

static const struct {
    const char *name, *phosphor;
    double infrared;
} screens[] = {{"P39", "P39", 0}, {"P39+infrared", "P39", 0.001},
               {"P31", "P31", 0}, {"P4", "P4", 0},
               {"P1", "P1", 0},   {"P46", "P46", 0}};
#define SCREENS (sizeof screens / sizeof screens[0])

static void row_of_errors(const char *name, double v)
{
    double x, with, delay = setup.delay.value;
    double pitch = pen.desc.row->width.value / 1024, edge = -setup.aperture.value / 2;
    printf("%-13s %9.3f ", name, v);
    if (!fires_at(v, 1, &with)) {
        puts("does not fire");
        return;
    }
    setup.delay.value = 0;
    inp_pen_set_knobs(&pen, pen.knobs);
    (void)fires_at(v, 1, &x);
    setup.delay.value = delay;
    inp_pen_set_knobs(&pen, pen.knobs);
    printf("%9.3f %9.3f %9.3f %9.3f %8.2f %9.3f\n", (x - edge) / v, delay, v * delay, with - x,
           (with - x) / pitch, with);
}

static void table_of_errors(void)
{
    static const double speeds[] = {0.5, 1, 2, 2.294, 4, 7, 10};
    puts("1. VR17, level 7, a line through the pen's middle. build-up [us]: from the edge of the "
         "aperture until "
         "the\n   signal reaches the threshold (negative: the skirt of the spot is enough); delay "
         "[us]: from "
         "there to the\n   pulse; v*delay [mm]; err: how far the beam gets in that time [mm], "
         "[units]; "
         "mid [mm]: where it is then,\n   right of the pen's middle");
    printf("%-13s %9s %9s %9s %9s %9s %8s %9s\n", "phosphor", "v [mm/us]", "build[us]", "delay[us]",
           "v*d [mm]", "err [mm]", "[units]", "mid [mm]");
    setup.noise.value = 0;
    for (unsigned s = 0; s < SCREENS; s++) {
        setup.infrared.value = screens[s].infrared;
        make("VR17", screens[s].phosphor, 1);
        for (unsigned i = 0; i < sizeof speeds / sizeof speeds[0]; i++)
            row_of_errors(screens[s].name, speeds[i]);
    }
    setup.infrared.value = 0;
    setup.noise.value = 2;
}

/* ---- 2: levels and rooms ------------------------------------------------------------------------ */

static double drive_of(int level)
{
    double low = crt_tube_row_find("VR17")->drive_low.value;
    return low + (1 - low) * level / 7;
}

/* Percent of lines through the middle that are hit while the beam is within 5 mm. */
static double hits(const char *phosphor, int level, int trials)
{
    double v = crt_tube_row_find("VR17")->line_speed.value, count = 0;
    for (int i = 0; i < trials; i++) {
        make("VR17", phosphor, (uint64_t)i + 1);
        struct crt_stroke line = {.t0 = US, .x0 = -4, .x1 = 5, .drive = (float)drive_of(level)};
        line.t1 = US + (uint64_t)(9 / v * 1e6);
        count += inp_pen_offer(&pen, &line) != INP_NEVER;
    }
    return 100 * count / trials;
}

static void table_of_levels(void)
{
    puts("\n2a. VR17, a line through the pen's middle at the generator's own speed, 2.294 mm/us: "
         "hits [%]");
    printf("%-13s", "level");
    for (int level = 0; level < 8; level++)
        printf(" %6d", level);
    puts("");
    for (unsigned s = 0; s < SCREENS; s++) {
        setup.infrared.value = screens[s].infrared;
        printf("%-13s", screens[s].name);
        for (int level = 0; level < 8; level++)
            printf(" %6.1f", hits(screens[s].phosphor, level, 400));
        puts("");
    }
    setup.infrared.value = 0;
}

static double false_rate(uint64_t until)
{
    double count = 0;
    for (uint64_t t = inp_pen_next(&pen); t < until; t = inp_pen_next(&pen))
        count += inp_pen_event(&pen, t);
    return count / ((double)until * 1e-12);
}

static void table_of_rooms(void)
{
    static const double rooms[] = {0, 100, 300, 500, 1000, 2000, 3000, 5000, 10000, 30000, 100000};
    puts("\n2b. The same in a lit room; hits [%] of P39 at levels 3, 4 and 7, of P31 at level 0; "
         "noise [ucd];\n"
         "    flicker behind the coupling [ucd]; firings without any light of the beam [1/s]");
    printf("%9s %8s %8s %7s %7s %7s %7s %10s\n", "room [lx]", "noise", "flicker", "P39/3", "P39/4",
           "P39/7", "P31/0", "false [/s]");
    for (unsigned i = 0; i < sizeof rooms / sizeof rooms[0]; i++) {
        setup.room.value = rooms[i];
        double p39[3] = {hits("P39", 3, 400), hits("P39", 4, 400), hits("P39", 7, 400)};
        double p31 = hits("P31", 0, 400);
        make("COLOR17", NULL, 5);
        printf("%9.0f %8.2f %8.2f %7.1f %7.1f %7.1f %7.1f %10.0f\n", rooms[i], pen.model.sigma,
               pen.model.ripple, p39[0], p39[1], p39[2], p31, false_rate(US * 200000));
    }
    setup.room.value = 0;
}

/* ---- 3: raster ---------------------------------------------------------------------------------- */

static const struct {
    const char *tube, *name;
    double clock_mhz;
    int dots, total, lines;
} modes[] = {{"SLOT14", "640x480", 25.175, 640, 800, 480},
             {"COLOR17", "1024x768", 65, 1024, 1344, 768}};

static const struct {
    const char *name;
    uint8_t drive[3];
} fields[] = {{"white", {255, 255, 255}}, {"red", {255, 0, 0}},      {"green", {0, 255, 0}},
              {"blue", {0, 0, 255}},      {"dark blue", {0, 0, 64}}, {"grey", {128, 128, 128}},
              {"black", {0, 0, 0}}};

struct sums {
    double lines, dots, dots2, middle, middles, fired, firings, count;
};

/* One field with the pen at a dot and line. */
static void sweep(unsigned mode, const uint8_t drive[3], double dot, double row, struct sums *sums)
{
    static uint8_t dots[3][1024];
    double w = pen.desc.row->width.value, h = pen.desc.row->height.value, first = -1;
    double line_ps = modes[mode].total / modes[mode].clock_mhz * 1e6,
           dot_ps = 1e6 / modes[mode].clock_mhz;
    for (int gun = 0; gun < 3; gun++)
        memset(dots[gun], drive[gun], sizeof dots[gun]);
    struct inp_place at = {(dot / modes[mode].dots - 0.5) * w, (0.5 - row / modes[mode].lines) * h,
                           0};
    inp_pen_reset(&pen, 0);
    pen.hand.there = false;
    inp_hand_move(&pen.hand, at, 0, 0);
    for (int i = 0; i < modes[mode].lines; i++) {
        struct crt_scan_line line = {
            .t0 = (uint64_t)(i * line_ps), .dots = modes[mode].dots, .guns = 3};
        line.t1 = line.t0 + (uint64_t)(modes[mode].dots * dot_ps);
        line.x0 = (float)(-w / 2);
        line.x1 = (float)(w / 2);
        line.y0 = line.y1 = (float)((0.5 - (i + 0.5) / modes[mode].lines) * h);
        for (int gun = 0; gun < 3; gun++)
            line.drive[gun] = dots[gun];
        inp_pen_line(&pen, &line);
        for (uint64_t t = inp_pen_next(&pen); t < line.t0 + (uint64_t)line_ps;
             t = inp_pen_next(&pen)) {
            if (!inp_pen_event(&pen, t))
                continue;
            double error = (double)(t - line.t0) / dot_ps - dot;
            sums->firings++;
            if (first < 0) {
                first = i;
                sums->lines += i + 0.5 - row;
                sums->dots += error;
                sums->dots2 += error * error;
                sums->fired++;
            }
            if (fabs(i + 0.5 - row) <= 0.5) {
                sums->middle += error;
                sums->middles++;
            }
        }
    }
    sums->count++;
}

static void table_of_fields(void)
{
    enum { PLACES = 24 };
    puts("\n3. Colour tubes, a field of one colour, pen at 24 places in the middle of the screen: "
         "first firing of a\n"
         "   field, lines below [lines] and dots right [dots] of the pen's middle, spread of the "
         "dots [dots rms];\n"
         "   the line through the middle [dots]; firings a field [1]");
    printf("%-9s %-9s %9s %8s %8s %8s %8s %9s\n", "mode", "field", "clock MHz", "[lines]", "[dots]",
           "spread", "middle", "[firings]");
    for (unsigned mode = 0; mode < 2; mode++)
        for (unsigned f = 0; f < sizeof fields / sizeof fields[0]; f++) {
            struct sums s = {0};
            make(modes[mode].tube, NULL, 3);
            for (int i = 0; i < PLACES; i++)
                sweep(mode, fields[f].drive, modes[mode].dots / 2.0 + i * 2.37,
                      modes[mode].lines / 2.0 + i * 1.61, &s);
            printf("%-9s %-9s %9.3f ", modes[mode].name, fields[f].name, modes[mode].clock_mhz);
            if (!(s.fired > 0)) {
                puts("does not fire");
                continue;
            }
            double mean = s.dots / s.fired;
            printf("%8.1f %8.1f %8.2f ", s.lines / s.fired, mean,
                   sqrt(fmax(s.dots2 / s.fired - mean * mean, 0)));
            if (s.middles > 0)
                printf("%8.1f", s.middle / s.middles);
            else
                printf("%8s", "-");
            printf(" %9.1f%s\n", s.firings / s.count, s.fired < s.count ? " (not everywhere)" : "");
        }
}

int main(void)
{
    table_of_errors();
    table_of_levels();
    table_of_rooms();
    table_of_fields();
    return 0;
}
