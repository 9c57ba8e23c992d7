#include "crt/line_light.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void crt_glow_release(struct crt_glow *glow)
{
    if (!glow || --glow->refs > 0)
        return;
    for (int gun = 0; gun < CRT_MAX_GUNS; gun++)
        for (int set = 0; set < CRT_LINE_SETS; set++)
            free(glow->cells[gun][set]);
    free(glow);
}

static bool ensure_room(struct crt_line_scratch *scratch, size_t words)
{
    if (scratch->room >= words)
        return true;
    free(scratch->stream);
    scratch->room = 0;
    scratch->stream = malloc(words * sizeof scratch->stream[0]);
    if (!scratch->stream)
        return false;
    scratch->room = words;
    return true;
}

/* How the lines of a strip differ from the middle of their band. */
static void set_corrections(struct crt_line_source *source, const struct crt_strip *strip, int gun,
                            const struct crt_line_beams *beams, const struct crt_line_place *place)
{
    const struct crt_optics *o = &beams->optics;
    const struct crt_line_course *course = source->beam->course;
    for (int lane = 0; lane < strip->lines; lane++) {
        double y = (double)strip->y[lane], more = o->per_mm2 * (y * y - place->y_mm * place->y_mm);
        double shift = o->way_x[gun] * o->converge_edge * more / (course->pitch_mm / 2);
        source->shift[lane] = (float)shift;
        for (int set = 0; set < course->sets; set++) {
            double half = 2 * course->spot[set]->sigma_dots, extra = o->edge * more;
            source->widen[set][0][lane] = (float)(shift * shift + half * half * extra * extra);
            source->widen[set][1][lane] = (float)(half * half * 2 * extra);
        }
    }
    source->spread_0 = 1 + o->edge * o->per_mm2 * place->y_mm * place->y_mm;
    source->spread_2 = o->edge * o->per_mm2;
    source->x_mm = (double)course->x0 + course->pitch_mm / 2;
}

/* Current of the brightest dot of each line, per set; false when all are dark. */
static bool set_scales(struct crt_line_source *source, float scale[][CRT_STRIP_LINES],
                       const struct crt_strip *strip, int gun, const struct crt_line_beams *beams)
{
    const struct crt_knobs *knobs = &strip->way.knobs;
    bool lit = false;
    for (int lane = 0; lane < strip->lines; lane++) {
        double drive =
            fmax(knobs->brightness,
                 knobs->brightness + knobs->contrast * strip->brightest[gun][lane] / 255.0);
        double current[CRT_LINE_SETS];
        crt_line_current(beams->row, drive, current);
        double most[CRT_LINE_SETS] = {current[0] + current[1], current[1]};
        for (int set = 0; set < beams->sets; set++)
            if (most[set] > 1e-12) {
                source->scale[set][lane] = (float)((double)CRT_FULL_LIGHT / most[set]);
                scale[set][lane] = (float)(most[set] / (double)CRT_FULL_LIGHT);
                lit = true;
            }
    }
    return lit;
}

/* Streams with dots of 0 in front and behind. */
static bool lay_streams(struct crt_line_source *source, const struct crt_line_place *place, int gun,
                        struct crt_line_scratch *scratch, const int32_t *first[CRT_LINE_SETS])
{
    int sets = source->beam->course->sets;
    source->dot0 = place->dot0[gun];
    source->dot1 = place->dot1[gun];
    size_t margin = (size_t)place->margin[gun], word = 3 * CRT_STRIP_LINES;
    size_t dots = (size_t)(source->dot1 - source->dot0), each = (dots + 2 * margin + 1) * word;
    if (!ensure_room(scratch, each * (size_t)sets))
        return false;
    for (int set = 0; set < sets; set++) {
        int32_t *stream = scratch->stream + (size_t)set * each;
        memset(stream, 0, margin * word * sizeof stream[0]);
        memset(stream + (margin + dots) * word, 0, (margin + 1) * word * sizeof stream[0]);
        source->stream[set] = stream + margin * word;
        first[set] = source->stream[set] - (ptrdiff_t)source->dot0 * (ptrdiff_t)word;
    }
    return true;
}

static bool make_cells(struct crt_glow *glow, int gun, int sets,
                       const struct crt_line_source *source,
                       const int32_t *const first[CRT_LINE_SETS],
                       const struct crt_line_place *place, const struct crt_line_kernels *kernels)
{
    int col0 = glow->col0[gun] = place->col0[gun], col1 = glow->col1[gun] = place->col1[gun];
    for (int set = 0; set < sets; set++) {
        int16_t *cells = aligned_alloc(64, ((size_t)(col1 - col0) * 16 + 63) / 64 * 64);
        if (!cells)
            return false;
        glow->cells[gun][set] = cells;
        kernels->light(source->beam->course->spot[set], place->at[gun], place->level[gun][set],
                       first[set], col0, col1, cells);
    }
    return true;
}

bool crt_glow_make(struct crt_strip *strip, const struct crt_line_beams *beams,
                   const struct crt_line_place *place, const struct crt_line_kernels *kernels,
                   struct crt_line_scratch *scratch)
{
    struct crt_glow *glow = calloc(1, sizeof *glow);
    if (!glow)
        return false;
    glow->refs = 1;
    for (int gun = 0; gun < beams->guns; gun++) {
        struct crt_line_source source = {.beam = strip->beam};
        const int32_t *first[CRT_LINE_SETS];
        if (place->col0[gun] >= place->col1[gun] ||
            !set_scales(&source, glow->scale[gun], strip, gun, beams))
            continue;
        set_corrections(&source, strip, gun, beams, place);
        for (int lane = 0; lane < CRT_STRIP_LINES; lane++)
            source.drive[lane] =
                strip->drive + (size_t)(gun * CRT_STRIP_LINES + (lane < strip->lines ? lane : 0)) *
                                   (size_t)strip->way.dots;
        bool ok = lay_streams(&source, place, gun, scratch, first);
        if (ok)
            kernels->currents(&source);
        if (!ok || !make_cells(glow, gun, beams->sets, &source, first, place, kernels)) {
            crt_glow_release(glow);
            return false;
        }
    }
    strip->glow = glow;
    strip->closed = true;
    return true;
}

/* ---- weighted lines -------------------------------------------------------------------------- */

/* Current and its wide part, of a drive between 0 and 1. */
static void current_of(const struct crt_line_beam *beam, float v, float current[CRT_LINE_SETS])
{
    v = v > 0 ? v < 1 ? v : 1 : 0;
    float root = sqrtf(v);
    current[1] = 0;
    if (beam->power == CRT_POWER_TABLE) {
        float at = root * CRT_POWER_CELLS;
        int i = at < CRT_POWER_CELLS - 1 ? (int)at : CRT_POWER_CELLS - 1;
        float part = at - (float)i;
        for (int set = 0; set < CRT_LINE_SETS; set++)
            current[set] =
                beam->table[set][i] + (beam->table[set][i + 1] - beam->table[set][i]) * part;
    } else {
        current[0] = v * v * root;
        if (beam->power == CRT_POWER_5_2_AND_11_2)
            current[1] = current[0] * (v * v * v);
    }
}

/* The amplifier's output at the end of a dot, and the moments of the current during it. */
static float moments_of(const struct crt_line_beam *beam, float v, float drive,
                        float moment[CRT_LINE_SETS][3])
{
    float d = v - drive;
    memset(moment, 0, CRT_LINE_SETS * sizeof moment[0]);
    for (int j = 0; j < beam->nodes; j++) {
        float current[CRT_LINE_SETS];
        current_of(beam, drive + d * beam->node[j], current);
        current[0] -= current[1];
        for (int m = 0; m < 3; m++)
            for (int set = 0; set < CRT_LINE_SETS; set++)
                moment[set][m] += current[set] * beam->weight[m][j];
    }
    return drive + d * beam->fade;
}

/* Moments of a quadratic current times a straight share over [a, b] of a dot, −1…1; by Gauss-Legendre,
 * which is exact. */
static void add_stretch(const float moment[3], double a, double b, double s0, double s1,
                        double sum[3])
{
    static const double at[3] = {-0.7745966692414834, 0, 0.7745966692414834};
    static const double load[3] = {5 / 9.0, 8 / 9.0, 5 / 9.0};
    for (int i = 0; i < 3; i++) {
        double u = a + (b - a) / 2 * (1 + at[i]), p2 = (3 * u * u - 1) / 2;
        double light = (double)moment[0] + 2 * (double)moment[1] * u + 4 * (double)moment[2] * p2;
        double w = (b - a) / 4 * load[i] * light * (s0 + s1 * u);
        sum[0] += w;
        sum[1] += w * 1.5 * u;
        sum[2] += w * 1.25 * p2;
    }
}

static void weigh_dot(float moment[3], int dot, const struct crt_line_stretch *stretch, int count)
{
    double sum[3] = {0};
    for (int i = 0; i < count; i++) {
        const struct crt_line_stretch *s = &stretch[i];
        double from = fmax(s->from, dot), to = fmin(s->to, dot + 1), half = (s->to - s->from) / 2;
        if (from >= to)
            continue;
        double middle = (s->from + s->to) / 2, slope = s->slope / half;
        double s0 = s->mean + (dot + 0.5 - middle) * slope, s1 = slope / 2;
        add_stretch(moment, 2 * (from - dot) - 1, 2 * (to - dot) - 1, s0, s1, sum);
    }
    for (int m = 0; m < 3; m++)
        moment[m] = (float)sum[m];
}

/* As the kernel does with whole strips (crt/line_kernel.inc). */
static void correct(float moment[3], float shift, float widen)
{
    moment[2] += 2.5F * shift * moment[1] + 1.875F * widen * moment[0];
    moment[1] += 1.5F * shift * moment[0];
}

static int16_t whole(float x)
{
    return (int16_t)fmin(fmax(floor((double)x + 0.5), -32767), 32767);
}

static void weighted_streams(const struct crt_line_source *source,
                             const struct crt_line_stretch *stretch, int count)
{
    const struct crt_line_beam *beam = source->beam;
    const int parts = beam->course->parts;
    float v = beam->start, moment[CRT_LINE_SETS][3];
    for (int dot = 0; dot < source->dot1; dot++) {
        float drive = beam->gain * (float)source->drive[0][dot / parts] + beam->offset;
        v = moments_of(beam, v, drive, moment);
        if (dot < source->dot0)
            continue;
        for (int set = 0; set < beam->course->sets; set++) {
            double x = source->x_mm + dot * beam->course->pitch_mm;
            float spread = (float)(source->spread_0 + source->spread_2 * x * x);
            weigh_dot(moment[set], dot, stretch, count);
            correct(moment[set], source->shift[0],
                    source->widen[set][0][0] + source->widen[set][1][0] * spread);
            int32_t *to = source->stream[set] + (ptrdiff_t)(dot - source->dot0) * 24;
            for (int m = 0; m < 3; m++) {
                uint16_t bits = (uint16_t)whole(moment[set][m] * source->scale[set][0]);
                to[m * 8] = (int32_t)bits;
                to[m * 8 - 24] = (int32_t)((uint32_t)to[m * 8 - 24] | (uint32_t)bits << 16);
            }
        }
    }
}

bool crt_glow_weighted(struct crt_glow *glow, const struct crt_strip *strip, int lane, int gun,
                       const struct crt_line_stretch *stretch, int count,
                       const struct crt_line_beams *beams, const struct crt_line_place *place,
                       const struct crt_line_kernels *kernels, struct crt_line_scratch *scratch)
{
    struct crt_line_source source = {.beam = strip->beam};
    struct crt_strip alone = *strip;
    const int32_t *first[CRT_LINE_SETS];
    *glow = (struct crt_glow){.refs = 1};
    alone.lines = 1;
    alone.y[0] = strip->y[lane];
    alone.brightest[gun][0] = strip->brightest[gun][lane];
    if (place->col0[gun] >= place->col1[gun] ||
        !set_scales(&source, glow->scale[gun], &alone, gun, beams))
        return true;
    set_corrections(&source, &alone, gun, beams, place);
    source.drive[0] =
        strip->drive + (size_t)(gun * CRT_STRIP_LINES + lane) * (size_t)strip->way.dots;
    if (!lay_streams(&source, place, gun, scratch, first))
        return false;
    for (int set = 0; set < beams->sets; set++)
        memset(source.stream[set], 0, (size_t)(source.dot1 - source.dot0) * 24 * sizeof(int32_t));
    weighted_streams(&source, stretch, count);
    return make_cells(glow, gun, beams->sets, &source, first, place, kernels);
}
