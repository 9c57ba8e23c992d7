/* Light that a scan line puts on a place: of the dots that reach it, while the beam passes them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/maths.h"
#include "crt/photodiode_parts.h"
#include "crt/share.h"
#include "crt/tube_parts.h"

#define TWO_PI 6.28318530717958648

/* What the amplifier had left of a dot this many time constants ago does not matter: e^−40. */
#define FORGOTTEN 40.0

/* A change of drive below this is none. */
#define STEADY 1e-9

void crt_cut_current(const struct crt_tube_row *row, double drive, double current[CRT_LINE_SETS])
{
    bool grows = row->spot_growth.value > 0;
    if (row->gun_exponent.value != 2.5 || (grows && row->spot_exponent.value != 0.6)) {
        crt_line_current(row, drive, current);
        return;
    }
    /* The usual exponents: 2.5, and 2.5·(1 + 2·0.6) in the wide spot. */
    double d = fmin(fmax(drive, 0), 1), whole = d * d * sqrt(d);
    current[1] = grows ? whole * d * d * d : 0;
    current[0] = whole - current[1];
}

int crt_cut_ends(double dot_s, double amplifier_s, double ends[CRT_CUT_ENDS])
{
    int n = 0;
    ends[n++] = 0;
    for (double step = 0.5; n < CRT_CUT_ENDS - 1 && step * amplifier_s < dot_s; step *= 2)
        ends[n++] = step * amplifier_s;
    ends[n++] = dot_s;
    return n;
}

/* ---- the cut ----------------------------------------------------------------------------------- */

/* How far from the place beams may be sent and still reach it. Spread and convergence errors are those at the place:
 * within the reach of a spot they change by less than a twentieth and a half (tubes of the table; estimate). */
static double reach_of(const struct crt_aperture *a, const struct crt_line_beams *beams,
                       const struct crt_knobs *knobs)
{
    double x = fabs(a->x_mm) + a->radius_mm, y = fabs(a->y_mm) + a->radius_mm, miss = 0;
    double spread = crt_optics_at(&beams->optics, 0, x, y).spread * 1.05;
    double sigma = beams->sigma_mm[beams->sets - 1] * sqrt(1 + knobs->focus * knobs->focus);
    for (int gun = 0; gun < beams->guns; gun++) {
        struct crt_beam_place place = crt_optics_at(&beams->optics, gun, x, y);
        miss = fmax(miss, 1.5 * (fabs(place.dx) + fabs(place.dy)));
    }
    return crt_aperture_reach(a, sigma * spread) + miss;
}

static double amplifier_of(const struct crt_tube_row *row)
{
    return 1 / (TWO_PI * row->bandwidth.value * 1e6);
}

/* The amplifier's output when dot `first` begins. */
static double output_before(const struct crt_line_cut *cut, const uint8_t *drive, int first)
{
    double fade = crt_exp(-cut->dot_s / cut->amplifier_s);
    double back = fmin(ceil(FORGOTTEN * cut->amplifier_s / cut->dot_s), first);
    int dot = first - (int)back;
    double v = dot > 0 ? cut->gain * drive[dot - 1] + cut->offset : cut->offset;
    for (; dot < first; dot++) {
        double to = cut->gain * drive[dot] + cut->offset;
        v = to + (v - to) * fade;
    }
    return v;
}

static struct crt_line_cut *new_cut(const struct crt_photodiode *diode,
                                    const struct crt_scan_line *line, const struct crt_knobs *knobs,
                                    int first, int dots)
{
    struct crt_line_cut *cut = malloc(sizeof *cut + (size_t)dots * (size_t)line->guns);
    if (!cut)
        return NULL;
    *cut = (struct crt_line_cut){.dots = dots, .guns = line->guns};
    cut->pitch_mm = ((double)line->x1 - (double)line->x0) / line->dots;
    cut->x0_mm = (double)line->x0 + first * cut->pitch_mm;
    cut->y_mm = (double)line->y0;
    cut->dot_s = crt_seconds(line->t0, line->t1) / line->dots;
    cut->start_s = first * cut->dot_s;
    cut->gain = knobs->contrast / 255;
    cut->offset = knobs->brightness;
    cut->blur = sqrt(1 + knobs->focus * knobs->focus);
    cut->amplifier_s = amplifier_of(diode->tube->desc.row);
    for (int gun = 0; gun < line->guns; gun++) {
        cut->before[gun] = output_before(cut, line->drive[gun], first);
        memcpy(cut->drive + (size_t)gun * (size_t)dots, line->drive[gun] + first, (size_t)dots);
    }
    return cut;
}

static bool screen_cut(struct crt_photodiode *diode, const struct crt_scan_line *line,
                       const struct crt_knobs *knobs, struct crt_line_cut **cut)
{
    const struct crt_line_beams *beams = crt_line_pass_beams(diode->tube->line_pass);
    double mean[CRT_MAX_GUNS], any = 0;
    *cut = NULL;
    if (!crt_field_mean(diode, line, knobs, mean))
        return false;
    for (int gun = 0; gun < line->guns; gun++)
        any += mean[gun];
    if (!(any > 0))
        return true;
    *cut = new_cut(diode, line, knobs, 0, 0);
    for (int gun = 0; *cut && gun < line->guns; gun++)
        (*cut)->rate[gun] = beams->power[gun] * mean[gun] / diode->aperture.area_mm2;
    return *cut != NULL;
}

bool crt_line_cut(struct crt_photodiode *diode, const struct crt_scan_line *line,
                  const struct crt_knobs *knobs, struct crt_line_cut **cut)
{
    const struct crt_aperture *a = &diode->aperture;
    if (a->kind == CRT_DIODE_SCREEN)
        return screen_cut(diode, line, knobs, cut);
    double reach = reach_of(a, crt_line_pass_beams(diode->tube->line_pass), knobs);
    double pitch = ((double)line->x1 - (double)line->x0) / line->dots;
    double low = floor((a->x_mm - reach - (double)line->x0) / pitch);
    double high = ceil((a->x_mm + reach - (double)line->x0) / pitch);
    *cut = NULL;
    low = fmax(low, 0);
    high = fmin(high, line->dots);
    if (!(fabs(a->y_mm - (double)line->y0) < reach) || !(low < high))
        return true;
    *cut = new_cut(diode, line, knobs, (int)low, (int)high - (int)low);
    return *cut != NULL;
}

/* ---- its light ------------------------------------------------------------------------------------ */

struct sweeping {
    struct crt_flux *flux;
    struct crt_aperture *a;
    const struct crt_line_beams *beams;
    const struct crt_line_cut *cut;
    int gun;
    double from, to; /* the part that counts */
    struct crt_view view[CRT_LINE_SETS];
};

static void views_at(struct sweeping *s, double x)
{
    double spread = crt_optics_at(&s->beams->optics, s->gun, x, s->cut->y_mm).spread;
    for (int set = 0; set < s->beams->sets; set++)
        s->view[set] = crt_aperture_view(s->a, s->beams->sigma_mm[set] * s->cut->blur * spread);
}

/* Rate at t, seconds after the cut's first dot began. */
static double rate_at(struct sweeping *s, double t, double drive)
{
    double x = s->cut->x0_mm + t / s->cut->dot_s * s->cut->pitch_mm, y = s->cut->y_mm;
    double current[CRT_LINE_SETS], sum = 0;
    crt_cut_current(s->beams->row, drive, current);
    if (!(current[0] + current[1] > 0))
        return 0;
    struct crt_beam_place place = crt_optics_at(&s->beams->optics, s->gun, x, y);
    double dx = s->a->x_mm - x - place.dx, dy = s->a->y_mm - y - place.dy;
    double d2 = dx * dx + dy * dy;
    if (s->a->kind == CRT_DIODE_POINT && s->beams->optics.edge != 0)
        views_at(s, x);
    for (int set = 0; set < s->beams->sets; set++)
        sum += current[set] * crt_aperture_density(s->a, &s->view[set], d2);
    return sum * s->beams->power[s->gun];
}

/* Part of a dot in which the amplifier goes from v, at its start, to drive. */
static bool add_part(struct sweeping *s, int dot, double v, double drive, double from, double to)
{
    double start = dot * s->cut->dot_s, off = s->cut->start_s, most = 0;
    from = fmax(from, s->from - off - start);
    to = fmin(to, s->to - off - start);
    if (!(from < to))
        return true;
    struct crt_flux_span span = {
        .from = off + start + from, .to = off + start + to, .beam = s->gun};
    for (int i = 0; i < CRT_FLUX_NODES; i++) {
        double t = crt_flux_time(from, to, i);
        double driven = drive;
        if (fabs(v - drive) > STEADY)
            driven += (v - drive) * crt_exp(-t / s->cut->amplifier_s);
        span.q[i] = rate_at(s, start + t, driven);
        most = fmax(most, span.q[i]);
    }
    return !(most > 0) || crt_flux_add(s->flux, &span);
}

static bool add_dot(struct sweeping *s, int dot, double v, double drive)
{
    const struct crt_line_cut *cut = s->cut;
    double ends[CRT_CUT_ENDS] = {0, cut->dot_s};
    bool steady = fabs(v - drive) <= STEADY, ok = true;
    int count = steady ? 2 : crt_cut_ends(cut->dot_s, cut->amplifier_s, ends);
    double sigma = s->beams->sigma_mm[0] * cut->blur, speed = cut->pitch_mm / cut->dot_s;
    views_at(s, cut->x0_mm + (dot + 0.5) * cut->pitch_mm);
    for (int i = 0; i + 1 < count && ok; i++) {
        double width = ends[i + 1] - ends[i];
        int parts = (int)fmin(ceil(width * speed / sigma), 1e4);
        for (int k = 0; k < parts && ok; k++)
            ok = add_part(s, dot, v, drive, ends[i] + width * k / parts,
                          k + 1 == parts ? ends[i + 1] : ends[i] + width * (k + 1) / parts);
    }
    return ok;
}

static bool add_gun(struct sweeping *s)
{
    const struct crt_line_cut *cut = s->cut;
    const uint8_t *drive = cut->drive + (size_t)s->gun * (size_t)cut->dots;
    double v = cut->before[s->gun], fade = crt_exp(-cut->dot_s / cut->amplifier_s);
    for (int dot = 0; dot < cut->dots; dot++) {
        double to = cut->gain * drive[dot] + cut->offset;
        if (fmax(v, to) > 0 && !add_dot(s, dot, v, to))
            return false;
        v = to + (v - to) * fade;
    }
    return true;
}

static bool add_field(const struct sweeping *s, int gun)
{
    struct crt_flux_span span = {.from = s->from, .to = s->to, .beam = gun, .constant = true};
    for (int i = 0; i < CRT_FLUX_NODES; i++)
        span.q[i] = s->cut->rate[gun];
    return !(span.q[0] > 0) || !(s->from < s->to) || crt_flux_add(s->flux, &span);
}

bool crt_flux_line(struct crt_flux *flux, struct crt_aperture *a,
                   const struct crt_line_beams *beams, const struct crt_line_cut *cut, double from,
                   double to)
{
    struct sweeping s = {.flux = flux, .a = a, .beams = beams, .cut = cut, .from = from, .to = to};
    bool ok = true;
    for (s.gun = 0; s.gun < cut->guns && ok; s.gun++)
        ok = a->kind == CRT_DIODE_SCREEN ? add_field(&s, s.gun) : add_gun(&s);
    return ok;
}
