/* curves_take.c — words to points and splines, numbers to figures. */
#include "roms/commands/curves.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "roms/monitor/print.h"

bool curves_take_places(struct words *w, float low, float high, float *place, int *count)
{
    *count = 0;
    if (words_left(w) == 0)
        for (; *count < 5; ++*count)
            place[*count] = low + (high - low) * (float)*count / 4;
    else if (!words_take(w, "at"))
        return words_refuse(w, "\"%.40s\" is not known here", words_peek(w));
    while (words_left(w) > 0) {
        if (*count == CURVES_PLACES)
            return words_refuse(w, "at most %d places", CURVES_PLACES);
        if (!words_bounded(w, low, high, &place[*count]))
            return false;
        ++*count;
    }
    return *count > 0 || words_refuse(w, "a place is missing");
}

/* Of the plane, for a spline. */
static bool take_points(struct words *w, int least, struct curve_points *out)
{
    return words_points(w, 2, (struct words_wanted){least, SPLINE_POINTS_MOST, WORDS_FARTHEST},
                        out->at, &out->count);
}

static bool take_slope(struct words *w, struct vector3 *out)
{
    out->z = 0;
    return words_amount(w, &out->x) && words_amount(w, &out->y);
}

/* ---- splines --------------------------------------------------------------------------------- */

static bool take_natural(struct words *w, bool clamped, struct named_spline *out)
{
    enum spline_parameter parameter = SPLINE_UNIFORM;
    struct vector3 slope0, slope1;
    if (words_take(w, "chordal"))
        parameter = SPLINE_CHORDAL;
    else if (words_take(w, "centripetal"))
        parameter = SPLINE_CENTRIPETAL;
    else
        words_take(w, "uniform");
    struct curve_points *p = &out->points;
    if (!take_points(w, 2, p))
        return false;
    if (clamped) {
        if (!words_take(w, "slopes"))
            return words_refuse(w, "the slopes at the ends are missing");
        if (!take_slope(w, &slope0) || !take_slope(w, &slope1))
            return false;
    }
    out->through = true;
    if (clamped ? spline_clamped(p->at, p->count, parameter, slope0, slope1, &out->spline)
                : spline_natural(p->at, p->count, parameter, &out->spline))
        return true;
    return words_refuse(w, "neighbouring points coincide, and the parameter is their distance");
}

static bool take_hermite(struct words *w, struct named_spline *out)
{
    struct vector3 slope[SPLINE_POINTS_MOST];
    struct curve_points *p = &out->points;
    p->count = 0;
    out->through = true;
    while (words_next_is_number(w) || p->count < 2) {
        if (p->count == SPLINE_POINTS_MOST)
            return words_refuse(w, "at most %d points", SPLINE_POINTS_MOST);
        if (!take_slope(w, &p->at[p->count]) || !take_slope(w, &slope[p->count]))
            return false;
        p->count++;
    }
    return spline_hermite(p->at, slope, p->count, &out->spline);
}

static bool take_cardinal(struct words *w, float tension, struct named_spline *out)
{
    struct curve_points *p = &out->points;
    return take_points(w, 4, p) && spline_cardinal(p->at, p->count, tension, &out->spline);
}

static bool take_b_spline(struct words *w, struct named_spline *out)
{
    struct curve_points *p = &out->points;
    return take_points(w, 4, p) && spline_b_spline(p->at, p->count, &out->spline);
}

static bool take_bezier(struct words *w, struct named_spline *out)
{
    struct curve_points *p = &out->points;
    if (!take_points(w, 4, p))
        return false;
    return spline_bezier(p->at, p->count, &out->spline) ||
           words_refuse(w, "cubic Bezier pieces take 4, 7, 10 ... points");
}

bool curves_take_spline(struct words *w, struct named_spline *out)
{
    static const char *const names[] = {"natural",     "clamped",  "hermite", "cardinal",
                                        "catmull-rom", "b-spline", "bezier",  NULL};
    enum { NATURAL, CLAMPED, HERMITE, CARDINAL, CATMULL_ROM, B_SPLINE };
    int which;
    float tension;
    if (!words_choice(w, names, &which))
        return false;
    out->name = names[which];
    out->through = false;
    switch (which) {
    case NATURAL:
    case CLAMPED:
        return take_natural(w, which == CLAMPED, out);
    case HERMITE:
        return take_hermite(w, out);
    case CARDINAL:
        if (!words_bounded(w, -10, 10, &tension))
            return false;
        return take_cardinal(w, tension, out);
    case CATMULL_ROM:
        return take_cardinal(w, 0, out);
    case B_SPLINE:
        return take_b_spline(w, out);
    default:
        return take_bezier(w, out);
    }
}

/* ---- figures --------------------------------------------------------------------------------- */

const char *curves_figure(char text[CURVES_FIGURE], float value)
{
    snprintf(text, CURVES_FIGURE, "%.5f", print_tidy_to(value, 5));
    char *end = text + strlen(text);
    while (end[-1] == '0')
        end--;
    end -= end[-1] == '.';
    *end = '\0';
    return text;
}

void curves_text_of_point(char *text, int room, struct vector3 p, int dimensions)
{
    char x[CURVES_FIGURE], y[CURVES_FIGURE], z[CURVES_FIGURE];
    bool flat = dimensions < 3;
    snprintf(text, (size_t)room, "(%s,%s%s%s)", curves_figure(x, p.x), curves_figure(y, p.y),
             flat ? "" : ",", flat ? "" : curves_figure(z, p.z));
}

void curves_print_point(struct vector3 p, int dimensions)
{
    char text[3 * CURVES_FIGURE + 5];
    curves_text_of_point(text, sizeof text, p, dimensions);
    printf("%s", text);
}
