/* cohen_sutherland.h — a line clipped to a window by region codes.
 *
 *      1001 │ 1000 │ 1010        A B R L: above, below, right of, left of the window
 *      ─────┼──────┼─────
 *      0001 │ 0000 │ 0010        both codes 0000: accepted
 *      ─────┼──────┼─────        a bit in both (AND not 0): rejected
 *      0101 │ 0100 │ 0110        else: cut an end at an edge it is beyond, look again
 *
 * Models:     the algorithm, a cut at a time: the first end first, edges in the order left, right,
 *             below, above.
 * Cost:       8 comparisons for the two codes; a cut takes a multiplication, a division and 4
 *             comparisons. At most 4 cuts.
 * Domain:     finite coordinates whose differences and products of differences are finite; points
 *             on the edge are inside. A line of length 0 is a point.
 * Units:      the caller's.
 * Ownership:  plain values.
 * Errors:     none. An end that was cut is on the edge exactly; where rounding moves it back beyond
 *             an edge it was cut at before, it is put on the corner, so that the cuts end.
 * Source:     D. Cohen and I. Sutherland, 1967; W. M. Newman, R. F. Sproull, Principles of
 *             Interactive Computer Graphics (1973).
 */
#ifndef ROMS_CLIP_COHEN_SUTHERLAND_H
#define ROMS_CLIP_COHEN_SUTHERLAND_H

#include <stdbool.h>

#include "roms/clip/edge.h"

struct cohen_sutherland {
    struct point2 end[2]; /* what is left so far */
    unsigned code[2];     /* their regions */
    int cut;              /* which end the last cut moved */
    unsigned edge;        /* at which edge: REGION_…; 0: there was none yet */
    bool accepted;        /* once next has returned false */
    /* Private. */
    struct clip_window window;
    struct point2 line[2];
    unsigned done[2]; /* edges that the end was cut at */
};

void cohen_sutherland_begin(struct cohen_sutherland *k, const struct clip_window *window,
                            struct point2 a, struct point2 b);
/* The next cut; false: none is needed, and `accepted` tells the verdict. */
bool cohen_sutherland_next(struct cohen_sutherland *k);

/* All cuts. Moves the ends onto what is left of the line; false: nothing is left, and they stay. */
bool clip_cohen_sutherland(const struct clip_window *window, struct point2 *a, struct point2 *b);

#endif
