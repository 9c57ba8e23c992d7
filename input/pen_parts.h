/* pen_parts.h — the light pen's insides: what its files share.
 *
 *      pen_light.c: pieces ─▶ share of the spot within the aperture, straight from knot to knot
 *      pen_signal.c: luminous power, a straight line in time ─▶ phosphor, detector, coupling in closed form
 *      pen_comparator.c: signal and noise against the threshold ─▶ pulse
 *      pen.c, pen_state.c: what pen.h promises
 *
 * Units:      time: microseconds within a stretch, picoseconds between them; signal: ucd.
 * Ownership:  plain values.
 * Errors:     none.
 */
#ifndef INPUT_PEN_PARTS_H
#define INPUT_PEN_PARTS_H

#include "input/pen.h"

/* Luminous power within the aperture, of each colour: a straight line in time. */
struct pen_input {
    double power[CRT_MAX_COLOURS]; /* ucd */
    double slope[CRT_MAX_COLOURS]; /* ucd/us */
};

/* ---- pen_signal.c ------------------------------------------------------------------------------- */

/* Poles: the terms, the detector, the coupling. */
#define PEN_POLES (INP_PEN_TERMS + 2)

/* How the signal goes on from a state, with
 *      x_i(t) = tau_i·(1 − e^(−t/tau_i)):  V(t) = start − Σ fall_i·x_i(t)
 * which unlike a sum of e^(−t/tau_i) loses no digits when tau_i is much longer than t. */
struct pen_course {
    int poles;
    double start; /* V at t = 0 */
    double tau[PEN_POLES], fall[PEN_POLES];
    /* The same of the terms' rates (at t = 0 stored) and of the detector. */
    double rise[INP_PEN_TERMS], back[INP_PEN_TERMS]; /* R_k = stored_k + rise_k·t − back_k·x_k */
    double fast_rise, fast_back[PEN_POLES];
};

/* Moves time constants of the detector and the coupling that nearly coincide with others, by parts in
 * 1e5: what the closed form divides by. */
void pen_signal_part(struct inp_pen_model *model);
void pen_course_begin(struct pen_course *course, const struct inp_pen_model *model,
                      const struct inp_pen_sight *sight, const struct pen_input *input);
double pen_course_at(const struct pen_course *course, double us);
double pen_course_slope(const struct pen_course *course, double us);
/* Between what V stays within the next `us`: at little cost, and closely. The second takes it that V turns
 * but once in that time. */
struct pen_bounds {
    double low, high;
};
struct pen_bounds pen_course_within(const struct pen_course *course, double us);
struct pen_bounds pen_course_between(const struct pen_course *course, double us);
void pen_course_end(const struct pen_course *course, struct inp_pen_sight *sight, uint64_t ps);

/* ---- pen_comparator.c --------------------------------------------------------------------------- */

/* What noise and lamps add during a cell. */
double pen_stir_of(const struct inp_pen *pen, uint64_t cell);
/* On to `until`; with `first` no further than needed to know the first pulse. */
void pen_run(const struct inp_pen *pen, struct inp_pen_sight *sight, struct pen_input input,
             uint64_t until, bool first);
/* The same without light. Of a long darkness only the end is searched: what came before is over. */
void pen_dark(const struct inp_pen *pen, struct inp_pen_sight *sight, uint64_t until);
/* Whether nothing can make it fire without light. */
bool pen_is_quiet(const struct inp_pen *pen, const struct inp_pen_sight *sight);

/* ---- pen_light.c -------------------------------------------------------------------------------- */

/* Share of a Gaussian spot of width sigma, d from the middle of the aperture, that is within it. */
double pen_share(double radius, double sigma, double d);
void pen_light_stroke(const struct inp_pen *pen, struct inp_pen_sight *sight,
                      const struct crt_stroke *stroke, bool first);
void pen_light_line(const struct inp_pen *pen, struct inp_pen_sight *sight,
                    const struct crt_scan_line *line);
bool pen_far_stroke(const struct inp_pen *pen, const struct crt_stroke *stroke);
bool pen_far_line(const struct inp_pen *pen, const struct crt_scan_line *line);

/* ---- pen_model.c -------------------------------------------------------------------------------- */

void pen_model_make(struct inp_pen *pen);

/* ---- pen.c -------------------------------------------------------------------------------------- */

/* What follows from the state, after each change of it. */
void pen_settle(struct inp_pen *pen);

#endif
