#include "crt/line_look.h"

#include <math.h>
#include <stdlib.h>

#include "crt/maths.h"
#include "crt/share.h"

#define TWO_PI 6.28318530717958648

/* Light further away than this is left out, sigma: e^−32 = 1e-14. */
#define REACH 8.0

/* ---- luminance ------------------------------------------------------------------------------- */

struct looking {
    const struct crt_tube *tube;
    const struct crt_line_beams *beams;
    double x_mm, y_mm;
    uint64_t t;
    uint32_t mask;
    double *cd_m2;
    /* the line, and its gun */
    const struct crt_line *line;
    int gun;
    double y, pitch_mm, dot_s, amplifier_s;
    double sigma_mm[CRT_LINE_SETS];
    double until_s; /* t from the line's start */
};

#define MOST_ENDS 96

/* Moments of a dot between which its light changes little: of the amplifier, and of terms that fade
 * within it before t. */
static int ends_of(const struct looking *at, double from, double to, double after,
                   double ends[MOST_ENDS])
{
    const struct crt_phosphor *phosphor = at->tube->desc.phosphor;
    static const double steps[] = {0.5, 1, 2, 4, 8, 16, 32};
    int n = 0;
    ends[n++] = from;
    for (int i = 0; i < 7; i++)
        ends[n++] = steps[i] * at->amplifier_s;
    for (int k = 0; k < phosphor->terms && n < MOST_ENDS - 8; k++) {
        double tau = phosphor->term[k].tau_s;
        if ((at->mask >> k & 1) && tau < 2 * (to - from) && after < 40 * tau)
            for (int i = 0; i < 7 && n < MOST_ENDS - 1; i++)
                ends[n++] = to - steps[i] * tau;
    }
    ends[n++] = to;
    for (int i = 0; i < n; i++) {
        double e = fmin(fmax(ends[i], from), to);
        int k = i;
        for (; k > 0 && ends[k - 1] > e; k--)
            ends[k] = ends[k - 1];
        ends[k] = e;
    }
    return n;
}

/* Light that falls on the point per second of beam, relative to the gun's power. */
static double flux(const struct looking *at, double x, double drive)
{
    double current[CRT_LINE_SETS], sum = 0;
    struct crt_beam_place place = crt_optics_at(&at->beams->optics, at->gun, x, at->y);
    double dx = at->x_mm - x - place.dx, dy = at->y_mm - at->y - place.dy;
    crt_line_current(at->tube->desc.row, drive, current);
    for (int set = 0; set < at->beams->sets; set++) {
        double sigma = at->sigma_mm[set] * place.spread;
        if (current[set] > 0)
            sum += current[set] * crt_exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)) /
                   (TWO_PI * sigma * sigma);
    }
    return sum;
}

/* One dot between two moments after its start, in which the amplifier goes from v to drive. */
static void look_at_dot(const struct looking *at, int dot, double v, double drive, double from,
                        double to)
{
    static const double node[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                   0.8611363115940526};
    static const double load[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                   0.3478548451374538};
    const struct crt_phosphor *phosphor = at->tube->desc.phosphor;
    double ends[MOST_ENDS], start = dot * at->dot_s;
    double speed = at->pitch_mm / at->dot_s, power = at->beams->power[at->gun];
    int guns = at->beams->guns, count = ends_of(at, from, to, at->until_s - start - to, ends);
    for (int i = 0; i + 1 < count; i++) {
        double half = (ends[i + 1] - ends[i]) / 2;
        for (int j = 0; j < 4 && half > 0; j++) {
            double t = ends[i] + half * (1 + node[j]);
            double driven = drive + (v - drive) * crt_exp(-t / at->amplifier_s);
            double x = (double)at->line->strip->way.x0 + (start + t) * speed;
            double light = power * half * load[j] * flux(at, x, driven);
            if (light <= 0)
                continue;
            for (int k = 0; k < phosphor->terms; k++) {
                const struct crt_phosphor_term *term = &phosphor->term[k];
                double ago = (at->until_s - start - t) / term->tau_s;
                if ((at->mask >> k & 1) && ago < 60 && (guns == 1 || term->colour == at->gun))
                    at->cd_m2[term->colour] += light * term->w / term->tau_s * crt_exp(-ago);
            }
        }
    }
}

/* Drawn between `from` and `to` seconds after its start. */
static void look_at_line(const struct looking *at, double from, double to, double reach)
{
    const struct crt_strip *strip = at->line->strip;
    const uint8_t *dots = strip->drive + (size_t)(at->gun * CRT_STRIP_LINES + at->line->lane) *
                                             (size_t)strip->way.dots;
    const struct crt_knobs *knobs = &strip->way.knobs;
    double v = knobs->brightness, fade = crt_exp(-at->dot_s / at->amplifier_s);
    double first = (double)strip->way.x0;
    for (int dot = 0; dot < strip->way.dots && dot * at->dot_s < to; dot++) {
        double drive = knobs->contrast * dots[dot] / 255 + knobs->brightness;
        double a = fmax(from - dot * at->dot_s, 0), b = fmin(to - dot * at->dot_s, at->dot_s);
        double x = first + dot * at->pitch_mm;
        bool dark = fmax(drive, v) <= 0;
        if (a < b && !dark && at->x_mm > x - reach && at->x_mm < x + at->pitch_mm + reach) {
            /* Wide dots only where they are near. */
            double speed = at->pitch_mm / at->dot_s, near = (at->x_mm - x) / speed;
            double step = at->sigma_mm[0] / speed;
            a = fmax(a, near - reach / speed);
            b = fmin(b, near + reach / speed);
            for (; a < b; a += step)
                look_at_dot(at, dot, v, drive, a, fmin(a + step, b));
        }
        v = drive + (v - drive) * fade;
    }
}

void crt_lines_look(const struct crt_tube *tube, const struct crt_line_list *list, double x_mm,
                    double y_mm, uint64_t t, uint64_t from, uint64_t to, uint32_t mask,
                    double cd_m2[CRT_MAX_COLOURS])
{
    const struct crt_line_beams *beams = crt_line_pass_beams(tube->line_pass);
    struct looking at = {.tube = tube, .beams = beams, .x_mm = x_mm, .y_mm = y_mm, .t = t};
    at.mask = mask;
    at.cd_m2 = cd_m2;
    at.amplifier_s = 1 / (TWO_PI * tube->desc.row->bandwidth.value * 1e6);
    for (size_t i = 0; i < list->count; i++) {
        const struct crt_line *line = &list->at[i];
        const struct crt_line_way *way = &line->strip->way;
        uint64_t begin = line->t0 > from ? line->t0 : from, end = line->t1 < to ? line->t1 : to;
        if (begin >= end)
            continue;
        at.line = line;
        at.y = (double)line->strip->y[line->lane];
        at.pitch_mm = ((double)way->x1 - (double)way->x0) / way->dots;
        at.dot_s = crt_line_dot_seconds(line);
        at.until_s = crt_seconds(line->t0, t);
        double blur = sqrt(1 + way->knobs.focus * way->knobs.focus);
        double spread = crt_optics_at(&beams->optics, 0, x_mm, y_mm).spread * 1.05;
        for (int set = 0; set < beams->sets; set++)
            at.sigma_mm[set] = beams->sigma_mm[set] * blur;
        for (at.gun = 0; at.gun < beams->guns; at.gun++) {
            struct crt_beam_place miss = crt_optics_at(&beams->optics, at.gun, x_mm, y_mm);
            double reach = REACH * at.sigma_mm[beams->sets - 1] * spread +
                           1.5 * (fabs(miss.dx) + fabs(miss.dy));
            if (fabs(y_mm - at.y) < reach)
                look_at_line(&at, crt_seconds(line->t0, begin), crt_seconds(line->t0, end), reach);
        }
    }
}

/* ---- totals ---------------------------------------------------------------------------------- */

static void all_terms(struct crt_receiver *receiver, const struct crt_tube *tube, int gun,
                      uint32_t mask, uint64_t to)
{
    const struct crt_phosphor *phosphor = tube->desc.phosphor;
    *receiver = (struct crt_receiver){.shares = 1};
    receiver->share[0] = (struct crt_share){.ref = tube->now, .to = to};
    for (int k = 0; k < phosphor->terms; k++)
        if ((mask >> k & 1) &&
            (crt_tube_guns(tube->desc.row) == 1 || phosphor->term[k].colour == gun))
            crt_share_add(&receiver->share[0], phosphor->term[k].w, phosphor->term[k].tau_s);
}

double crt_lines_stored(const struct crt_tube *tube)
{
    const struct crt_grid *grid = &tube->desc.grid;
    struct crt_receiver before[CRT_MAX_GUNS], now[CRT_MAX_GUNS];
    struct crt_line_target target[CRT_MAX_GUNS];
    int guns = crt_tube_guns(tube->desc.row);
    size_t cells = (size_t)grid->cols * (size_t)grid->rows;
    float *sum = calloc(cells, sizeof *sum);
    double total = 0;
    if (!sum)
        return NAN;
    for (int gun = 0; gun < guns; gun++) {
        all_terms(&before[gun], tube, gun, tube->quick, tube->begin);
        all_terms(&now[gun], tube, gun, UINT32_MAX, tube->now);
        target[gun] = (struct crt_line_target){.cells = sum, .gun = gun};
    }
    struct crt_line_pass *pass = tube->line_pass;
    crt_line_pass_begin(pass, target, guns, 0);
    bool ok = crt_line_pass_add(pass, &tube->lines.before, before, 0, guns, 0, tube->begin) &&
              crt_line_pass_add(pass, &tube->lines.now, now, 0, guns, tube->begin, tube->now) &&
              crt_line_pass_prepare(pass, tube->pool);
    crt_line_pass_band(pass, 0, grid->rows, 0, NULL, 0);
    crt_line_pass_end(pass);
    for (size_t i = 0; i < cells; i++)
        total += (double)sum[i];
    free(sum);
    return ok ? total : NAN;
}
