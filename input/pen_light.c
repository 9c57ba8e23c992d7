/* Beam pieces made into the luminous power that falls within the aperture. */
#include "input/pen_parts.h"

#include <math.h>

#include "crt/maths.h"
#include "crt/optics.h"
#include "crt/penetration.h"
#include "crt/spot.h"

#define ROOT_2      1.41421356237309505
#define ROOT_TWO_PI 2.50662827463100050
#define WIDE        5.0 /* sigma from the edge of the aperture within which the share changes */
#define KNOTS       4.0 /* a sigma: the share is a straight line from one to the next */
#define LINE_KNOTS  2.0 /* the same of scan lines, which are fast */

/* ---- share of the spot -------------------------------------------------------------------------- */

/* Gauss-Legendre over s = 0…1 with y = (3s − s³)/2, so that the ends of the chords, where they go to 0
 * as a square root does, do no harm: y and its weight, both halves together. */
static const struct {
    double y, weight;
} chords[] = {
    {0.029778693955193176, 0.15178294437692322}, {0.15197472149119168, 0.33012371264022911},
    {0.34917494857413311, 0.444076913292973},    {0.57839472946001202, 0.45333945347032212},
    {0.783987170014673, 0.35354629825585282},    {0.92225593372369286, 0.19678239887051119},
    {0.98502122492081945, 0.064378439597876744}, {0.9994125778602847, 0.0059698394953117181},
};
#define CHORDS   (sizeof chords / sizeof chords[0])
#define CUT_WIDE 4.5 /* sigma to either side */
#define SHARP    5.0 /* radius over sigma from which the edge is nearly straight */

static double chord_sum(double radius, double sigma, double d)
{
    double half = fmin(radius, CUT_WIDE * sigma), share = 0;
    for (size_t i = 0; i < CHORDS; i++) {
        double y = half * chords[i].y, a = sqrt(radius * radius - y * y), u = y / sigma;
        double ends = crt_erf((a - d) / (ROOT_2 * sigma)) + crt_erf((a + d) / (ROOT_2 * sigma));
        share += chords[i].weight * crt_exp(-u * u / 2) * ends;
    }
    return share * half / (2 * ROOT_TWO_PI * sigma);
}

/* The edge as a straight one, and what its curvature adds: the integral over rings rho of
 * (rho/sigma^2)·e^(-(rho^2 + d^2)/2sigma^2)·I0(rho·d/sigma^2) with I0 for large arguments, by powers of
 * e = sigma/d. Good to 3e-5 where it is used. */
static double edge_series(double radius, double sigma, double d)
{
    double z = (radius - d) / sigma, e = sigma / d, z2 = z * z;
    double bend = e * (0.5 - e * (z / 8 - e * ((z2 + 1) / 16 - e * z * (5 * z2 + 9) / 128)));
    return 0.5 * (1 + crt_erf(z / ROOT_2)) - crt_exp(-z2 / 2) / ROOT_TWO_PI * bend;
}

double pen_share(double radius, double sigma, double d)
{
    if (d > radius + WIDE * sigma)
        return 0;
    if (radius > SHARP * sigma && d > radius / 2)
        return fmax(edge_series(radius, sigma, d), 0);
    return chord_sum(radius, sigma, d);
}

/* ---- strokes ------------------------------------------------------------------------------------ */

static bool far(const struct inp_pen *pen, const struct inp_place *p, float x0, float y0, float x1,
                float y1)
{
    const double reach = pen->model.reach, x = p->x, y = p->y;
    return (x0 < x - reach && x1 < x - reach) || (x0 > x + reach && x1 > x + reach) ||
           (y0 < y - reach && y1 < y - reach) || (y0 > y + reach && y1 > y + reach);
}

bool pen_far_stroke(const struct inp_pen *pen, const struct crt_stroke *s)
{
    struct inp_place p = inp_hand_at(&pen->hand, s->t0);
    return far(pen, &p, s->x0, s->y0, s->x1, s->y1);
}

/* The way past the pen: x from the foot of the perpendicular, which is `off` long. */
struct way {
    double x0, length, off; /* mm */
    uint64_t t0, t1;
    double radius, sigma;
    double last_x, last_share; /* share_of() as it was last */
};

/* Each knot is asked for twice in a row. */
static double share_of(struct way *way, double x)
{
    if (x != way->last_x) {
        way->last_x = x;
        way->last_share = pen_share(way->radius, way->sigma, sqrt(x * x + way->off * way->off));
    }
    return way->last_share;
}

static uint64_t time_of(const struct way *way, double x)
{
    double span = (double)(way->t1 - way->t0), part = (x - way->x0) / way->length;
    return way->t0 + (uint64_t)(span * fmin(fmax(part, 0), 1));
}

static double place_of(const struct way *way, uint64_t t)
{
    return way->x0 + way->length * ((double)(t - way->t0) / (double)(way->t1 - way->t0));
}

/* Half of the chord at `off` of a circle, 0 when it is missed. */
static double half_chord(double radius, double off)
{
    return radius > off ? sqrt((radius - off) * (radius + off)) : 0;
}

/* Between two knots. The stroke may begin or end there: the straight line stays the same, so that a stroke
 * that is cut gives what the whole one gave. */
static void between(const struct inp_pen *pen, struct inp_pen_sight *sight, struct way *way,
                    const double power[CRT_MAX_COLOURS], double xa, double xb, bool first)
{
    uint64_t ta = time_of(way, xa), tb = time_of(way, xb);
    ta = ta > sight->t ? ta : sight->t;
    if (ta >= tb)
        return;
    double a = share_of(way, xa), b = share_of(way, xb);
    double part = (place_of(way, ta) - xa) / (xb - xa);
    double slope = (b - a) / (xb - xa) * way->length / ((double)(way->t1 - way->t0) * 1e-6);
    struct pen_input input;
    for (int c = 0; c < CRT_MAX_COLOURS; c++) {
        input.power[c] = power[c] * (a + (b - a) * part);
        input.slope[c] = power[c] * slope;
    }
    pen_run(pen, sight, input, tb, first);
}

/* Knots while the spot comes over the edge, the flat top where there is one, knots while it leaves. */
static void along(const struct inp_pen *pen, struct inp_pen_sight *sight, struct way *way,
                  const double power[CRT_MAX_COLOURS], bool first)
{
    static const struct pen_input none;
    double wide = WIDE * way->sigma, end = half_chord(way->radius + wide, way->off);
    double flat = way->radius > wide ? half_chord(way->radius - wide, way->off) : 0;
    int steps = (int)ceil((end - flat) / way->sigma * KNOTS);
    double step = steps > 0 ? (end - flat) / steps : 0, x = -end;
    pen_run(pen, sight, none, time_of(way, x), first);
    for (int i = 1; i <= 2 * steps + 1 && !(first && sight->pulse != INP_NEVER); i++) {
        double to = i <= steps ? -end + i * step : flat + (i - steps - 1) * step;
        between(pen, sight, way, power, x, to, first);
        x = to;
    }
    if (!(first && sight->pulse != INP_NEVER))
        pen_run(pen, sight, none, way->t1, first);
}

void pen_light_stroke(const struct inp_pen *pen, struct inp_pen_sight *sight,
                      const struct crt_stroke *s, bool first)
{
    const struct inp_place p = inp_hand_at(&pen->hand, s->t0);
    const struct crt_voltage v =
        crt_voltage_at(pen->desc.row, pen->desc.phosphor, (enum crt_level)s->level);
    const struct crt_spot spot = crt_spot_at(pen->desc.row, &pen->knobs, (double)s->drive);
    double x = (double)s->x0 * v.place - p.x, y = (double)s->y0 * v.place - p.y;
    double dx = ((double)s->x1 - (double)s->x0) * v.place;
    double dy = ((double)s->y1 - (double)s->y0) * v.place;
    struct way way = {.length = sqrt(dx * dx + dy * dy),
                      .t0 = s->t0,
                      .t1 = s->t1,
                      .radius = pen->model.radius,
                      .sigma = spot.sigma_mm * v.sigma,
                      .last_x = HUGE_VAL};
    double power[CRT_MAX_COLOURS];
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        power[c] = spot.power * v.light[c];
    if (way.length > 0) {
        way.x0 = (x * dx + y * dy) / way.length;
        way.off = fabs(x * dy - y * dx) / way.length;
        along(pen, sight, &way, power, first);
        return;
    }
    double share = pen_share(way.radius, way.sigma, sqrt(x * x + y * y));
    struct pen_input input = {{0}, {0}};
    for (int c = 0; c < CRT_MAX_COLOURS; c++)
        input.power[c] = power[c] * share;
    pen_run(pen, sight, input, s->t1, first);
}

/* ---- scan lines --------------------------------------------------------------------------------- */

bool pen_far_line(const struct inp_pen *pen, const struct crt_scan_line *line)
{
    double off = (double)line->y0 - inp_hand_at(&pen->hand, line->t0).y;
    return off > pen->model.reach || off < -pen->model.reach;
}

/* The beams of a line at the pen. */
struct beams {
    int guns;
    double x[CRT_MAX_GUNS], y[CRT_MAX_GUNS]; /* of dot 0's begin from the pen, mm */
    double sigma, pitch;
};

static double share_at(const struct inp_pen *pen, const struct beams *beams, int gun, double x)
{
    double dx = x + beams->x[gun], dy = beams->y[gun];
    return pen_share(pen->model.radius, beams->sigma, sqrt(dx * dx + dy * dy));
}

static void set_beams(const struct inp_pen *pen, const struct crt_scan_line *line,
                      struct beams *beams)
{
    const struct inp_place p = inp_hand_at(&pen->hand, line->t0);
    struct crt_optics optics;
    crt_optics_init(&optics, pen->desc.row);
    beams->guns = line->guns;
    beams->pitch = ((double)line->x1 - (double)line->x0) / line->dots;
    for (int gun = 0; gun < line->guns; gun++) {
        struct crt_beam_place place = crt_optics_at(&optics, gun, p.x, p.y);
        beams->x[gun] = (double)line->x0 + place.dx - p.x;
        beams->y[gun] = (double)line->y0 + place.dy - p.y;
        beams->sigma = place.spread * crt_spot_at(pen->desc.row, &pen->knobs, 1).sigma_mm;
    }
}

static uint64_t dot_time(const struct crt_scan_line *line, double dot)
{
    return line->t0 + (uint64_t)((double)(line->t1 - line->t0) * (dot / line->dots));
}

/* One dot, in parts of at most a fraction of sigma. */
static void dot_light(const struct inp_pen *pen, struct inp_pen_sight *sight,
                      const struct crt_scan_line *line, const struct beams *beams, int dot)
{
    const struct inp_pen_model *m = &pen->model;
    double full[CRT_MAX_COLOURS] = {0}, sum = 0;
    for (int c = 0; c < CRT_MAX_COLOURS; c++) {
        int gun = beams->guns == 1 ? 0 : c;
        full[c] = m->power[c] * m->current[line->drive[gun][dot]];
        sum += full[c];
    }
    if (!(sum > 0))
        return;
    int parts = (int)fmin(ceil(beams->pitch / beams->sigma * LINE_KNOTS), 1e6);
    for (int i = 0; i < parts; i++) {
        double d0 = dot + (double)i / parts, d1 = dot + (double)(i + 1) / parts;
        uint64_t t0 = dot_time(line, d0), t1 = dot_time(line, d1);
        if (t0 >= t1 || t1 <= sight->t)
            continue;
        static const struct pen_input none;
        struct pen_input input = none;
        pen_run(pen, sight, none, t0, false);
        for (int c = 0; c < CRT_MAX_COLOURS; c++) {
            int gun = beams->guns == 1 ? 0 : c;
            if (!(full[c] > 0))
                continue;
            double a = full[c] * share_at(pen, beams, gun, d0 * beams->pitch);
            double b = full[c] * share_at(pen, beams, gun, d1 * beams->pitch);
            input.power[c] = a;
            input.slope[c] = (b - a) / ((double)(t1 - t0) * 1e-6);
        }
        pen_run(pen, sight, input, t1, false);
    }
}

void pen_light_line(const struct inp_pen *pen, struct inp_pen_sight *sight,
                    const struct crt_scan_line *line)
{
    struct beams beams = {0};
    set_beams(pen, line, &beams);
    if (!(beams.pitch > 0))
        return;
    double at = inp_hand_at(&pen->hand, line->t0).x - (double)line->x0, reach = pen->model.reach;
    double from = fmax(floor((at - reach) / beams.pitch), 0);
    double to = fmin(ceil((at + reach) / beams.pitch), line->dots);
    for (double dot = from; dot < to; dot++)
        dot_light(pen, sight, line, &beams, (int)dot);
}
