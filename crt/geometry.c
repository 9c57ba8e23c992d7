#include "crt/geometry.h"

#include <math.h>

struct crt_placing crt_screen_placing(const struct crt_screen *s)
{
    return (struct crt_placing){s->width_mm / s->units_x, s->height_mm / s->units_y,
                                s->units_x / 2 - 0.5, s->units_y / 2 - 0.5};
}

void crt_screen_to_mm(const struct crt_screen *s, double ux, double uy, float *x_mm, float *y_mm)
{
    struct crt_placing placing = crt_screen_placing(s);
    crt_place(&placing, ux, uy, x_mm, y_mm);
}

void crt_mm_to_units(const struct crt_screen *s, double x_mm, double y_mm, double *ux, double *uy)
{
    *ux = x_mm * s->units_x / s->width_mm + s->units_x / 2 - 0.5;
    *uy = y_mm * s->units_y / s->height_mm + s->units_y / 2 - 0.5;
}

void crt_mm_to_cell(const struct crt_grid *g, double x_mm, double y_mm, double *col, double *row)
{
    *col = (x_mm - g->left_mm) / g->cell_mm - 0.5;
    *row = (g->top_mm - y_mm) / g->cell_mm - 0.5;
}

void crt_cell_to_mm(const struct crt_grid *g, double col, double row, double *x_mm, double *y_mm)
{
    *x_mm = g->left_mm + (col + 0.5) * g->cell_mm;
    *y_mm = g->top_mm - (row + 0.5) * g->cell_mm;
}

struct crt_grid crt_grid_cover(const struct crt_screen *s, double border_mm, double cell_mm)
{
    double w = s->width_mm + 2 * border_mm, h = s->height_mm + 2 * border_mm;
    int cols = (int)ceil(w / cell_mm), rows = (int)ceil(h / cell_mm);
    cols = (cols + 7) / 8 * 8;
    return (struct crt_grid){cols, rows, cell_mm, -cols * cell_mm / 2, rows * cell_mm / 2};
}

struct crt_grid crt_grid_closeup(double x_mm, double y_mm, double width_mm, int cols, int rows)
{
    double cell = width_mm / cols;
    return (struct crt_grid){cols, rows, cell, x_mm - cols * cell / 2, y_mm + rows * cell / 2};
}

struct crt_viewport crt_letterbox(double w_mm, double h_mm, int win_w, int win_h)
{
    double k = fmin(win_w / w_mm, win_h / h_mm);
    return (struct crt_viewport){(win_w - k * w_mm) / 2, (win_h - k * h_mm) / 2, k * w_mm,
                                 k * h_mm};
}
