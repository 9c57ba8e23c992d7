#include "crt/optics.h"

#define ROOT3_2 0.86602540378443865

void crt_optics_init(struct crt_optics *o, const struct crt_tube_row *row)
{
    double w = row->width.value, h = row->height.value;
    *o = (struct crt_optics){.per_mm2 = 4 / (w * w + h * h)};
    if (row->kind == CRT_RASTER_TUBE)
        o->edge = row->spot_edge.value - 1;
    if (row->mask == CRT_MASK_NONE)
        return;
    o->converge = row->converge.value;
    o->converge_edge = row->converge_edge.value;
    o->landing = row->landing.value;
    o->landing_edge = row->landing_edge.value;
    if (row->mask == CRT_MASK_DELTA) {
        o->way_x[0] = -ROOT3_2;
        o->way_x[1] = ROOT3_2;
        o->way_y[0] = o->way_y[1] = -0.5;
        o->way_y[2] = 1;
    } else {
        o->way_x[0] = -1;
        o->way_x[2] = 1;
    }
}

static double square_of_r(const struct crt_optics *o, double x, double y)
{
    return o->per_mm2 * (x * x + y * y);
}

struct crt_beam_place crt_optics_at(const struct crt_optics *o, int gun, double x_mm, double y_mm)
{
    double r2 = square_of_r(o, x_mm, y_mm), miss = o->converge + o->converge_edge * r2;
    return (struct crt_beam_place){miss * o->way_x[gun], miss * o->way_y[gun], 1 + o->edge * r2};
}

double crt_optics_landing(const struct crt_optics *o, double x_mm, double y_mm)
{
    return o->landing + o->landing_edge * square_of_r(o, x_mm, y_mm);
}
