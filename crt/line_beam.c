#include "crt/line_beam.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crt/line_spot.h"
#include "crt/maths.h"
#include "crt/spot.h"
#include "crt/white.h"

#define TWO_PI 6.28318530717958648

/* Beams and ways kept from one pass to the next. */
#define KEPT 4

/* ---- the tube -------------------------------------------------------------------------------- */

void crt_line_current(const struct crt_tube_row *row, double drive, double current[CRT_LINE_SETS])
{
    double whole = drive > 0 ? crt_pow(fmin(drive, 1), row->gun_exponent.value) : 0;
    bool grows = row->spot_growth.value > 0;
    double u = grows && whole > 0 ? crt_pow(whole, 2 * row->spot_exponent.value) : 0;
    current[0] = whole - whole * u;
    current[1] = whole * u;
}

static bool make_tables(struct crt_line_beams *beams)
{
    for (int set = 0; set < CRT_LINE_SETS; set++) {
        beams->table[set] = malloc((CRT_POWER_CELLS + 1) * sizeof(float));
        if (!beams->table[set])
            return false;
    }
    for (int i = 0; i <= CRT_POWER_CELLS; i++) {
        double root = (double)i / CRT_POWER_CELLS, current[CRT_LINE_SETS];
        crt_line_current(beams->row, root * root, current);
        beams->table[0][i] = (float)(current[0] + current[1]);
        beams->table[1][i] = (float)current[1];
    }
    return true;
}

static bool set_powers(struct crt_line_beams *beams, const struct crt_phosphor *phosphor,
                       struct crt_error *err)
{
    const struct crt_tube_row *row = beams->row;
    double share[3] = {1, 0, 0}, full = row->field_luminance.value * row->width.value *
                                        row->height.value / row->field_duty.value;
    if (beams->guns == 3 && !crt_white_shares(phosphor, share))
        return crt_fail(err, "the colours of phosphor %s cannot make white on tube %s",
                        phosphor->name, row->name);
    for (int gun = 0; gun < beams->guns; gun++) {
        double terms = 0;
        for (int k = 0; k < phosphor->terms; k++)
            if (beams->guns == 1 || phosphor->term[k].colour == gun)
                terms += phosphor->term[k].w;
        beams->power[gun] = terms > 0 ? full * share[gun] / terms : 0;
    }
    return true;
}

bool crt_line_beams_init(struct crt_line_beams *beams, const struct crt_tube_row *row,
                         const struct crt_phosphor *phosphor, const struct crt_grid *grid,
                         struct crt_error *err)
{
    *beams = (struct crt_line_beams){.row = row, .grid = *grid, .guns = crt_tube_guns(row)};
    double sigma0 = crt_spot_sigma0(row), growth = row->spot_growth.value;
    crt_optics_init(&beams->optics, row);
    beams->sets = growth > 0 ? 2 : 1;
    beams->sigma_mm[0] = sigma0;
    beams->sigma_mm[1] = sqrt(sigma0 * sigma0 + growth * growth);
    if (!set_powers(beams, phosphor, err))
        return false;
    double whole = row->gun_exponent.value, wide = whole * (1 + 2 * row->spot_exponent.value);
    if (whole == 2.5 && (growth == 0 || fabs(wide - 5.5) < 1e-9))
        return true;
    if (make_tables(beams))
        return true;
    crt_line_beams_free(beams);
    return crt_fail(err, "out of memory for the guns of a tube");
}

/* ---- places ---------------------------------------------------------------------------------- */

static void free_place(struct crt_line_place *place)
{
    for (int gun = 0; place && gun < CRT_MAX_GUNS; gun++) {
        free(place->at[gun]);
        free(place->landing[gun]);
        free(place->spread[gun]);
        free(place->amount[gun]);
        for (int set = 0; set < CRT_LINE_SETS; set++)
            free(place->level[gun][set]);
    }
    free(place);
}

/* The dot whose beam lands on a column. */
struct origin {
    double x_mm, dots; /* from the first dot's centre */
    double stretch;    /* mm on the screen per mm of way */
    struct crt_beam_place beam;
};

static struct origin origin_of(const struct crt_line_beams *beams,
                               const struct crt_line_course *course, int gun, double col,
                               double y_mm)
{
    const struct crt_optics *optics = &beams->optics;
    double lands, unused;
    struct origin o;
    crt_cell_to_mm(&beams->grid, col, 0, &lands, &unused);
    o.x_mm = lands;
    for (int i = 0; i < 6; i++) /* the miss changes little with x: each round gains three digits */
        o.x_mm = lands - crt_optics_at(optics, gun, o.x_mm, y_mm).dx;
    o.beam = crt_optics_at(optics, gun, o.x_mm, y_mm);
    o.stretch = 1 + optics->way_x[gun] * optics->converge_edge * optics->per_mm2 * 2 * o.x_mm;
    o.stretch = fmax(o.stretch, 0.1);
    double dots = (o.x_mm - (double)course->x0) / course->pitch_mm - 0.5;
    o.dots = fmin(fmax(dots, -1e9), 1e9);
    return o;
}

static int level_of(double ratio)
{
    double n = floor(crt_log(ratio) * CRT_LEVEL_STEPS + 0.5) + CRT_LEVEL_BASE;
    return (int)fmin(fmax(n, 0), CRT_SIGMA_LEVELS - 1);
}

/* Columns and dots of a gun that have to do with each other. */
static void find_extent(const struct crt_line_course *course, struct crt_line_place *place, int gun,
                        int segments)
{
    const struct crt_line_spot *widest = course->spot[course->sets - 1];
    double dots = (double)course->dots * course->parts, first = 0, last = -1, width = 0;
    int reach = 0;
    place->col0[gun] = place->col1[gun] = 0;
    for (int s = 0; s < segments; s++) {
        const struct crt_line_level *level = &widest->level[place->level[gun][course->sets - 1][s]];
        double a = (double)place->at[gun][s] * 0x1p-32, b = (double)place->at[gun][s + 1] * 0x1p-32;
        double low = fmin(a, b) - level->reach - 1, high = fmax(a, b) + level->reach + 2;
        if (high < 0 || low > dots)
            continue;
        reach = level->reach > reach ? level->reach : reach;
        width = fmax(width, fabs(b - a));
        if (place->col1[gun] == 0) {
            place->col0[gun] = s * CRT_LINE_SEG;
            first = low;
        }
        place->col1[gun] = (s + 1) * CRT_LINE_SEG;
        first = fmin(first, low);
        last = fmax(last, high);
    }
    place->margin[gun] = 2 * reach + (int)width + 8;
    place->dot0[gun] = (int)fmin(fmax(first, 0), dots);
    place->dot1[gun] = (int)fmin(fmax(last + 1, 0), dots);
}

static bool place_gun(const struct crt_line_beams *beams, struct crt_line_course *course,
                      struct crt_line_place *place, int gun)
{
    int segments = beams->grid.cols / CRT_LINE_SEG;
    size_t anchors = (size_t)(beams->grid.cols / CRT_LINE_ANCHOR + 2);
    place->at[gun] = malloc((size_t)(segments + 1) * sizeof place->at[0][0]);
    place->landing[gun] = malloc(anchors * sizeof(float));
    place->spread[gun] = malloc(anchors * sizeof(float));
    place->amount[gun] = malloc(anchors * sizeof(float));
    if (!place->at[gun] || !place->landing[gun] || !place->spread[gun] || !place->amount[gun])
        return false;
    for (int set = 0; set < course->sets; set++) {
        place->level[gun][set] = malloc((size_t)segments * sizeof place->level[0][0][0]);
        if (!place->level[gun][set])
            return false;
    }
    for (int s = 0; s <= segments; s++) {
        double col = s * CRT_LINE_SEG;
        place->at[gun][s] =
            (int64_t)floor(origin_of(beams, course, gun, col, place->y_mm).dots * 0x1p32 + 0.5);
        if (s == segments)
            break;
        struct origin o =
            origin_of(beams, course, gun, col + (CRT_LINE_SEG - 1) / 2.0, place->y_mm);
        int level = level_of(o.beam.spread / o.stretch);
        for (int set = 0; set < course->sets; set++) {
            place->level[gun][set][s] = (uint16_t)level;
            if (!crt_line_spot_level(course->spot[set], level))
                return false;
        }
    }
    for (size_t i = 0; i < anchors; i++) {
        struct origin o = origin_of(beams, course, gun, (double)i * CRT_LINE_ANCHOR, place->y_mm);
        place->landing[gun][i] = (float)o.beam.dy;
        place->spread[gun][i] = (float)o.beam.spread;
        place->amount[gun][i] = (float)(1 / o.stretch);
        place->most_spread = fmax(place->most_spread, o.beam.spread);
        place->most_landing = fmax(place->most_landing, fabs(o.beam.dy));
    }
    find_extent(course, place, gun, segments);
    return true;
}

const struct crt_line_place *crt_line_place_find(const struct crt_line_beams *beams,
                                                 struct crt_line_course *course, int64_t band)
{
    for (size_t i = course->places; i-- > 0;)
        if (course->place[i]->band == band)
            return course->place[i];
    if (course->places == course->room) {
        size_t room = course->room ? course->room * 2 : 64;
        struct crt_line_place **grown = realloc(course->place, room * sizeof(void *));
        if (!grown)
            return NULL;
        course->place = grown;
        course->room = room;
    }
    struct crt_line_place *place = calloc(1, sizeof *place);
    if (!place)
        return NULL;
    place->band = band;
    place->y_mm = ((double)band + 0.5) * course->band_mm;
    for (int gun = 0; gun < beams->guns; gun++)
        if (!place_gun(beams, course, place, gun)) {
            free_place(place);
            return NULL;
        }
    course->place[course->places++] = place;
    return place;
}

/* ---- courses --------------------------------------------------------------------------------- */

static void free_course(struct crt_line_course *course)
{
    if (!course)
        return;
    for (size_t i = 0; i < course->places; i++)
        free_place(course->place[i]);
    for (int set = 0; set < CRT_LINE_SETS; set++)
        crt_line_spot_free(course->spot[set]);
    free(course->place);
    free(course);
}

static struct crt_line_course *new_course(const struct crt_line_beams *beams,
                                          const struct crt_line_way *way)
{
    struct crt_line_course *c = calloc(1, sizeof *c);
    if (!c)
        return NULL;
    double blur = sqrt(1 + way->knobs.focus * way->knobs.focus);
    double sigma = beams->sigma_mm[0] * blur,
           pitch = ((double)way->x1 - (double)way->x0) / way->dots;
    const struct crt_optics *o = &beams->optics;
    c->x0 = way->x0;
    c->x1 = way->x1;
    c->dots = way->dots;
    c->focus = way->knobs.focus;
    c->parts = (int)fmin(fmax(ceil(pitch / (CRT_WIDEST_DOT * sigma)), 1), CRT_MOST_PARTS);
    c->pitch_mm = pitch / c->parts;
    c->band_mm = crt_line_band(beams->row, way);
    c->even = o->edge == 0 && o->converge_edge == 0;
    c->sets = beams->sets;
    for (int set = 0; set < c->sets; set++) {
        c->spot[set] = crt_line_spot_new(beams->sigma_mm[set] * blur, c->pitch_mm);
        if (!c->spot[set]) {
            free_course(c);
            return NULL;
        }
    }
    return c;
}

static struct crt_line_course *find_course(struct crt_line_beams *beams,
                                           const struct crt_line_way *way)
{
    for (size_t i = 0; i < beams->courses; i++) {
        struct crt_line_course *c = beams->course[i];
        if (c->x0 == way->x0 && c->x1 == way->x1 && c->dots == way->dots &&
            c->focus == way->knobs.focus)
            return c;
    }
    if (beams->courses == beams->course_room) {
        size_t room = beams->course_room + 8;
        struct crt_line_course **grown = realloc(beams->course, room * sizeof(void *));
        if (!grown)
            return NULL;
        beams->course = grown;
        beams->course_room = room;
    }
    struct crt_line_course *c = new_course(beams, way);
    if (c)
        beams->course[beams->courses++] = c;
    return c;
}

/* ---- beams ----------------------------------------------------------------------------------- */

/* ∫ over a dot of the nodes' polynomials times Legendre's, by Gauss-Legendre between moments graded to the
 * amplifier. */
static void weigh_nodes(struct crt_line_beam *b, const double z[CRT_LINE_NODES])
{
    static const double ends[] = {0, 0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16, 24, 40, 1e300};
    static const double at[8] = {-0.9602898564975363, -0.7966664774136267, -0.5255324099163290,
                                 -0.1834346424956498, 0.1834346424956498,  0.5255324099163290,
                                 0.7966664774136267,  0.9602898564975363};
    static const double load[8] = {0.1012285362903763, 0.2223810344533745, 0.3137066458778873,
                                   0.3626837833783620, 0.3626837833783620, 0.3137066458778873,
                                   0.2223810344533745, 0.1012285362903763};
    double sum[3][CRT_LINE_NODES] = {{0}}, left = crt_exp(-b->rate);
    for (int i = 0; ends[i] < b->rate; i++) {
        double from = ends[i] / b->rate, to = fmin(ends[i + 1] / b->rate, 1);
        for (int g = 0; g < 8; g++) {
            double t = from + (to - from) / 2 * (1 + at[g]), w = (to - from) / 2 * load[g];
            double x = crt_expm1(-b->rate * t), u = 2 * t - 1;
            x = 1 + x / (1 - left); /* 1 at the begin, 0 at the end */
            for (int j = 0; j < b->nodes; j++) {
                double l = w;
                for (int k = 0; k < b->nodes; k++)
                    l *= k != j ? (x - z[k]) / (z[j] - z[k]) : 1;
                sum[0][j] += l;
                sum[1][j] += l * 1.5 * u;
                sum[2][j] += l * 0.625 * (3 * u * u - 1);
            }
        }
    }
    for (int m = 0; m < 3; m++)
        for (int j = 0; j < b->nodes; j++)
            b->weight[m][j] = (float)sum[m][j];
}

static void set_amplifier(const struct crt_line_beams *beams, struct crt_line_beam *b)
{
    const struct crt_knobs *knobs = &b->way.knobs;
    double seconds = (double)b->way.lit * 1e-12 / b->way.dots / b->course->parts;
    double low = fmin(knobs->brightness, knobs->brightness + knobs->contrast);
    double high = fmax(knobs->brightness, knobs->brightness + knobs->contrast);
    double z[CRT_LINE_NODES];
    b->gain = (float)(knobs->contrast / 255);
    b->offset = b->start = (float)knobs->brightness;
    b->rate = fmax(TWO_PI * beams->row->bandwidth.value * 1e6 * seconds, 1e-6);
    b->clamped = low < 0 || high > 1;
    b->nodes = b->clamped ? CRT_LINE_NODES : beams->sets > 1 || beams->table[0] ? 5 : 4;
    double left = crt_exp(-b->rate);
    for (int j = 0; j < b->nodes; j++) {
        z[j] = (1 + crt_cos(TWO_PI / 2 * j / (b->nodes - 1))) / 2;
        b->node[j] = (float)(left + (1 - left) * z[j]);
    }
    b->fade = (float)left;
    weigh_nodes(b, z);
    b->power = beams->table[0]   ? CRT_POWER_TABLE
               : beams->sets > 1 ? CRT_POWER_5_2_AND_11_2
                                 : CRT_POWER_5_2;
    b->table[0] = beams->table[0];
    b->table[1] = beams->table[1];
}

struct crt_line_beam *crt_line_beam_find(struct crt_line_beams *beams,
                                         const struct crt_line_way *way)
{
    for (size_t i = 0; i < beams->beams; i++)
        if (crt_line_same_way(&beams->beam[i]->way, way)) {
            beams->beam[i]->used = beams->beam[i]->course->used = beams->turn;
            return beams->beam[i];
        }
    if (beams->beams == beams->beam_room) {
        size_t room = beams->beam_room + 8;
        struct crt_line_beam **grown = realloc(beams->beam, room * sizeof(void *));
        if (!grown)
            return NULL;
        beams->beam = grown;
        beams->beam_room = room;
    }
    struct crt_line_course *course = find_course(beams, way);
    struct crt_line_beam *beam = course ? calloc(1, sizeof *beam) : NULL;
    if (!beam)
        return NULL;
    beam->way = *way;
    beam->course = course;
    beam->used = course->used = beams->turn;
    set_amplifier(beams, beam);
    return beams->beam[beams->beams++] = beam;
}

void crt_line_beams_trim(struct crt_line_beams *beams)
{
    size_t kept = 0;
    for (size_t i = 0; i < beams->beams; i++)
        if (beams->beam[i]->used + KEPT >= beams->turn)
            beams->beam[kept++] = beams->beam[i];
        else
            free(beams->beam[i]);
    beams->beams = kept;
    kept = 0;
    for (size_t i = 0; i < beams->courses; i++)
        if (beams->course[i]->used + KEPT >= beams->turn)
            beams->course[kept++] = beams->course[i];
        else
            free_course(beams->course[i]);
    beams->courses = kept;
    beams->turn++;
}

void crt_line_beams_free(struct crt_line_beams *beams)
{
    for (size_t i = 0; i < beams->beams; i++)
        free(beams->beam[i]);
    for (size_t i = 0; i < beams->courses; i++)
        free_course(beams->course[i]);
    free(beams->beam);
    free(beams->course);
    free(beams->table[0]);
    free(beams->table[1]);
    *beams = (struct crt_line_beams){0};
}
