/* Figures, tube and knobs made into what the pen computes with. */
#include "input/pen_parts.h"

#include <math.h>

#include "crt/maths.h"
#include "crt/optics.h"
#include "crt/penetration.h"
#include "crt/spot.h"
#include "crt/white.h"
#include "input/noise.h"

#define PI        3.14159265358979324
#define WIDE      5.0 /* sigma beyond which nothing of the spot is looked for */
#define WHITE_SUM (1 / CRT_D65_Y)

static uint64_t ps_of(double us)
{
    return (uint64_t)(us * 1e6 + 0.5);
}

/* A detector that is flat over the visible range sees radiant power, not luminance: the tristimulus sum
 * stands for it, (X + Y + Z)/Y = 1/y. */
static double seen(const struct crt_chromaticity *colour)
{
    return colour->y > 0 ? 1 / colour->y : 0;
}

static void make_terms(struct inp_pen_model *m, const struct inp_pen_setup *setup,
                       const struct crt_phosphor *phosphor)
{
    for (int k = 0; k < phosphor->terms; k++) {
        const struct crt_phosphor_term *term = &phosphor->term[k];
        m->gain[k] = term->w * seen(&phosphor->colour[term->colour]);
        m->tau[k] = term->tau_s * 1e6;
        m->colour[k] = term->colour;
    }
    m->terms = phosphor->terms;
    if (setup->infrared.value > 0) {
        m->gain[m->terms] = setup->infrared.value;
        m->tau[m->terms] = setup->infrared_decay.value;
        m->colour[m->terms++] = 0;
    }
}

/* Light of lamps that the screen throws back: a steady current, which the coupling takes away but for
 * its noise and the flicker. */
static void make_noise(struct inp_pen_model *m, const struct inp_pen_setup *setup)
{
    double area = PI * m->radius * m->radius;
    double room = setup->room.value * setup->reflectance.value / PI * area * WHITE_SUM;
    double noise = setup->noise.value, turn = 2 * PI * setup->lamp.value * 1e-6; /* rad/us */
    double high = turn * m->couple, low = turn * m->response;
    m->sigma = sqrt(noise * noise + setup->shot.value * room);
    m->ripple = room * setup->ripple.value * high / sqrt((1 + high * high) * (1 + low * low));
    m->lamp = setup->lamp.value * 1e-12;
    m->stir = INP_NOISE_MOST * m->sigma + m->ripple;
}

/* As crt/line_beam.h says. */
static void make_lines(struct inp_pen_model *m, const struct inp_pen_desc *desc,
                       const struct crt_knobs *knobs)
{
    const struct crt_tube_row *row = desc->row;
    const int guns = crt_tube_guns(row);
    double share[CRT_MAX_GUNS] = {1, 1, 1};
    double full =
        row->field_luminance.value * row->width.value * row->height.value / row->field_duty.value;
    if (guns == CRT_MAX_GUNS && !crt_white_shares(desc->phosphor, share))
        full = 0;
    for (int c = 0; c < CRT_MAX_GUNS; c++) {
        double terms = 0;
        for (int k = 0; k < desc->phosphor->terms; k++)
            if (guns == 1 || desc->phosphor->term[k].colour == c)
                terms += desc->phosphor->term[k].w;
        m->power[c] = terms > 0 ? full * share[c] / terms : 0;
    }
    for (int i = 0; i < 256; i++)
        m->current[i] = crt_spot_at(row, knobs, i / 255.0).current;
}

/* The widest spot there can be, and how far it can miss its place. */
static double most_reach(const struct inp_pen_desc *desc, const struct crt_knobs *knobs)
{
    const struct crt_tube_row *row = desc->row;
    const struct crt_knobs bright = {0, 1, knobs->focus};
    double x = row->width.value / 2 + row->border.value;
    double y = row->height.value / 2 + row->border.value;
    struct crt_voltage red = crt_voltage_at(row, desc->phosphor, CRT_LEVEL_RED);
    struct crt_optics optics;
    crt_optics_init(&optics, row);
    struct crt_beam_place corner = crt_optics_at(&optics, 0, x, y);
    double sigma = crt_spot_at(row, &bright, 1).sigma_mm * red.sigma * corner.spread;
    double miss = fabs(red.place - 1) * sqrt(x * x + y * y);
    return WIDE * sigma + miss + optics.converge +
           optics.converge_edge * optics.per_mm2 * (x * x + y * y);
}

void pen_model_make(struct inp_pen *pen)
{
    const struct inp_pen_setup *setup = pen->desc.setup;
    struct inp_pen_model *m = &pen->model;
    *m = (struct inp_pen_model){
        .response = setup->response.value,
        .couple = setup->couple.value,
        .radius = setup->aperture.value / 2,
        .threshold = setup->threshold.value,
        .delay = ps_of(setup->delay.value),
        .hold = ps_of(setup->hold.value),
        .cell = ps_of(2 * setup->response.value) + 1,
        .raster = pen->desc.row->kind == CRT_RASTER_TUBE,
    };
    make_terms(m, setup, pen->desc.phosphor);
    make_noise(m, setup);
    pen_signal_part(m);
    if (m->raster)
        make_lines(m, &pen->desc, &pen->knobs);
    m->reach = m->radius + most_reach(&pen->desc, &pen->knobs);
}
