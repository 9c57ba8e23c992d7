/* overlap.h — areas of simple figures cut with a rectangle.
 *
 * Units:      any length; areas in its square.
 * Source:     elementary geometry; arcs by Gauss's quadrature of 8 points between the places where
 *             the outline changes, with the ends made smooth: to 1e-5 of a disc's area (mostly
 *             to 1e-7).
 * Ownership:  plain values.
 * Errors:     none.
 * Not modelled: nothing.
 */
#ifndef CRT_OVERLAP_H
#define CRT_OVERLAP_H

struct crt_box {
    double x0, y0, x1, y1;
};

struct crt_disc {
    double x, y, radius;
};

/* What one disc, or two, have in common with a box. */
double crt_overlap_discs(const struct crt_disc *disc, int count, const struct crt_box *box);

/* The part of from…to within the teeth k·pitch + low … k·pitch + high of a comb, k = …−1, 0, 1…;
 * high − low <= pitch. */
double crt_overlap_comb(double from, double to, double pitch, double low, double high);

#endif
