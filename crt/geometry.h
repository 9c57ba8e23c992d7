/* geometry.h — the only converter between head units, tube millimetres, grid cells and window
 * pixels.
 *
 *      head units (vector)      millimetres               grid cells
 *        y                        y                        (0,0)──▶ col
 *        ▲                        ▲                          │
 *        │                     ───┼──▶ x                     ▼
 *      (0,0)──▶ x                 │ (0,0) = centre          row
 *
 * Head units: origin bottom left, y up; unit n has its centre at n + ½ pitches from the left edge,
 *             so 0 … units-1 is centred on the glass. Units may be fractional.
 * Cells:      square, row 0 at the top; the centre of cell (c, r) is
 *             (left_mm + (c+½)·cell_mm, top_mm − (r+½)·cell_mm).
 * Millimetres: square; a head with unequal pitches shows oval circles, as the tube would.
 * Source:     elementary; the figures come from the tube row.
 * Ownership:  plain values.
 * Errors:     none.
 * Not modelled: distortion of the picture by the deflection (pincushion, non-linearity).
 */
#ifndef CRT_GEOMETRY_H
#define CRT_GEOMETRY_H

/* How head units lie on the glass. */
struct crt_screen {
    double width_mm, height_mm; /* the addressable area */
    double units_x, units_y;    /* addressable units across and up */
};

/* A grid of square cells on the glass: what planes and film are stored on. */
struct crt_grid {
    int cols, rows;         /* cols is a multiple of 8, one chunk of the kernels */
    double cell_mm;         /* side of a cell */
    double left_mm, top_mm; /* the outer corner of cell (0, 0) */
};

void crt_screen_to_mm(const struct crt_screen *s, double ux, double uy, float *x_mm, float *y_mm);

/* The same for many points: what does not depend on the point, worked out once. */
struct crt_placing {
    double pitch_x, pitch_y;   /* mm a unit */
    double middle_x, middle_y; /* head units of the screen's centre */
};

struct crt_placing crt_screen_placing(const struct crt_screen *s);

static inline void crt_place(const struct crt_placing *p, double ux, double uy, float *x_mm,
                             float *y_mm)
{
    *x_mm = (float)((ux - p->middle_x) * p->pitch_x);
    *y_mm = (float)((uy - p->middle_y) * p->pitch_y);
}

void crt_mm_to_units(const struct crt_screen *s, double x_mm, double y_mm, double *ux, double *uy);

/* Continuous cell coordinates: the centre of cell (c, r) is (c, r) exactly. */
void crt_mm_to_cell(const struct crt_grid *g, double x_mm, double y_mm, double *col, double *row);
void crt_cell_to_mm(const struct crt_grid *g, double col, double row, double *x_mm, double *y_mm);

/* The grid that covers the screen plus `border_mm` on every side with cells of at most cell_mm;
 * cols is rounded up to a multiple of 8 and the grid is centred on the glass. */
struct crt_grid crt_grid_cover(const struct crt_screen *s, double border_mm, double cell_mm);

/* The grid of a close-up: `width_mm` wide, centred on (x_mm, y_mm), cols × rows cells. */
struct crt_grid crt_grid_closeup(double x_mm, double y_mm, double width_mm, int cols, int rows);

/* Letterbox: the largest rectangle of aspect (w_mm : h_mm) centred in a window of win_w × win_h
 * pixels; x, y is its top left corner, in pixels. */
struct crt_viewport {
    double x, y, w, h;
};
struct crt_viewport crt_letterbox(double w_mm, double h_mm, int win_w, int win_h);

#endif
