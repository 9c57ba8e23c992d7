/* calibrate.h — how late the light pen of the raster head is: targets, measurements, what they say.
 *
 *      target at dot x, line y ──▶ pen pressed on it ──▶ where the beam was when it fired: too far to
 *                                                        the right, as it is late
 *
 * Models:     a pen sees a round spot of some millimetres. In each row of it that the beam lights it fires:
 *             when the beam has come in at the left, and the time that the pen takes later; meanwhile the
 *             beam goes on. So its dot is that of the middle, plus time times dot clock, less the
 *             spot's radius. Its first row lies above the middle by that radius, too; roms/interact/pen_rows.h
 *             takes all rows, so that what is left is little.
 * Method:     the median of some fields for each target; the offset is the middle of their differences
 *             from the targets. Further targets, which the offset is not made from, check it.
 * Units:      dots and lines of the mode that runs; whole numbers are middles of dots.
 * Ownership:  plain values.
 * Errors:     firings that scatter more than a hand does, or come from elsewhere, are not taken: the
 *             target begins anew.
 */
#ifndef ROMS_CALIBRATE_CALIBRATE_H
#define ROMS_CALIBRATE_CALIBRATE_H

#include <stdbool.h>
#include <stddef.h>

#include "roms/bsp/input.h"
#include "roms/bsp/video.h"
#include "roms/interact/pen_rows.h"
#include "roms/raster/canvas.h"

enum { TARGETS = 9, CHECKS = 4, PLACES = TARGETS + CHECKS };
enum { HITS = 11 /* fields that are measured on a target; odd */ };

struct place {
    int x, y; /* the target: dot, line */
    bool measured;
    float dot, line;      /* medians of what the fields say */
    float spread;         /* of their dots, from the first to the last */
    int rows;             /* in which the pen fires in a field */
    float dx, dy;         /* before: firing minus target */
    float left_x, left_y; /* after: what is left of it */
};

struct calibration {
    struct video_timing timing;
    struct canvas page[2];
    int shown;
    int scale;          /* of text, pixels a dot of the font */
    int half_x, half_y; /* of a target's box, dots and lines */
    struct place place[PLACES];
    bool found; /* the offset is known */
    float dots, lines;
    int late_ns, sees_um; /* what is behind them */
};

/* measure.c */
struct firings {
    int count, skipped;
    float dot[HITS], line[HITS];
};
/* One more field with its firings, or none. Pressed: the tip is. True: there are enough, and the place has
 * been filled in. */
bool measure_field(const struct calibration *c, struct firings *f, struct place *place,
                   bool pressed, const struct pen_rows *rows);
/* From the first TARGETS places; what is left of each that has been measured. */
void measure_offset(struct calibration *c);
void measure_left(const struct calibration *c, struct place *place);
float measure_length(float x, float y);

/* targets.c: where they are. */
void targets_place(struct calibration *c);

/* picture.c */
void picture_target(struct calibration *c, int number);
/* On the page that is shown: so many fields are done. */
void picture_progress(const struct calibration *c, int number, int done);
void picture_results(struct calibration *c);
/* With the results: the pen is here. */
void picture_pen(const struct calibration *c, float dot, float line, bool pressed);

/* report.c: what is printed. */
void report_begin(const struct calibration *c);
void report_offset(const struct calibration *c);
void report_checks(const struct calibration *c);

#endif
