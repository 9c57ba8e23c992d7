/* curves.h — the pages of the lesson about curves.
 *
 *      lesson_curves: time, keys ──▶ struct curves_view ──▶ curves_page.draw
 *
 * Models:     pages (pages.h); points that drift until one is moved; a value that swings until it is set.
 * Units:      stage units; seconds.
 * Ownership:  the lesson's; pages only look.
 * Errors:     none.
 */
#ifndef ROMS_LESSONS_CURVES_H
#define ROMS_LESSONS_CURVES_H

#include "roms/lessons/curve_pen.h"

enum { CURVES_PAGE_POINTS = 8 };

struct curves_view {
    float clock; /* since the page began */
    float value; /* what + and - change, 0…1 */
    int chosen;  /* point; -1: none */
    int count;
    struct vector3 point[CURVES_PAGE_POINTS];
};

struct curves_page {
    const char *title;   /* of the picture */
    const char *caption; /* what to look at */
    float period;        /* seconds in which the value goes from 0 to 1 and back */
    float drift;         /* how far points drift, 0…1 */
    int count;
    struct point2 start[CURVES_PAGE_POINTS];
    void (*draw)(const struct curves_view *view, struct stage *s);
};

extern const struct curves_page curves_page_casteljau, curves_page_blending, curves_page_splines,
    curves_page_tension, curves_page_b_spline, curves_page_join, curves_page_patch;

/* Control points with their names; the chosen one bright. */
void curves_draw_controls(const struct curves_view *v, struct stage *s, enum ink ink);

#endif
