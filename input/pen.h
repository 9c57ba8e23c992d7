/* pen.h — a light pen: sees the light that beam pieces make under its tip, and says when.
 *
 *      strokes, scan lines ─▶ aperture ─▶ phosphor's rate ─▶ + noise, room ─▶ coupling, low pass ─▶ threshold
 *                                                                                              │
 *                 display processor stops / raster head latches ◀── delay ── pulse ◀────────────┘
 *
 * Models:     signal: the luminous intensity of what the phosphor glows within a round aperture, each term of
 *             it a store that is filled in proportion to the beam power within the aperture and empties with
 *             its time constant; times 1/y of its colour, since a detector that is flat over the visible range
 *             sees radiant power, not luminance (estimate: the tristimulus sum stands for it). So blue is
 *             seen well though it is dim to the eye.
 *             The spot is a round Gaussian as wide as crt/spot.h says, of lines at full drive and as
 *             crt/optics.h spreads and shifts it at the pen; power: crt/spot.h, crt/penetration.h,
 *             crt/line_beam.h. Screens doped for an infrared pen, as the VR17's: figure `infrared`, a
 *             band by itself, fast where the phosphor is slow.
 *             Then one pole, `response`; AC coupling, `couple`; a comparator that fires when
 *             signal and noise rise to the threshold, and is armed again when they are below its half;
 *             a fixed `delay` until the pulse arrives, which stands for `hold`. One pulse at a time:
 *             firing while one is on its way, or stands, makes no other.
 *             Noise: normal, constant for 2·response, then another; that of the amplifier and the shot noise of
 *             room light. Lamps flicker: what the coupling lets through is a sine.
 * Offers:     inp_pen_offer() tells when a piece would make the pen fire and changes nothing;
 *             inp_pen_stroke() and inp_pen_line() are told what was really drawn. So a stroke that the
 *             display processor cuts at a hit is seen only as far as it was drawn. The cut is rounded
 *             (time, and place to 1e-4 mm): a pulse late by no more than that has arrived by the stroke's end.
 * Vector head: a pulse is spent by the stroke at whose begin it stands or during which it arrives, also where
 *             hits are disabled; one that no stroke meets is lost.
 * Raster head: inp_pen_line() may know the pulse beforehand; inp_pen_next() says when it arrives, and
 *             inp_pen_event() takes it. Each line that passes the pen makes it fire where the signal fell
 *             below half in between: programs take the first of a field, or the mean.
 * As they are, the figures give (tests/figures/pen.c prints all of it): P31, P4 and P1 at the VR17's own beam
 *             speed fire at all levels, within 1 us of the pen's middle; P39 from level 4 on, about 1 us late,
 *             and not at twice that speed unless bright (hard: it flashes 200 times less than P31); a dot of a
 *             character on P31 (the pulse meets the next one); colour tubes on white, every primary, dark
 *             blue, but not on black. False firings: fewer than one a second below 700 lx,
 *             15 at 1000, thousands from 2000.
 * Accuracy:   the signal in closed form between knots a quarter of the spot's sigma apart; firing times within
 *             20 ns of a slow model at speeds of 0.2 to 5 mm/us, crossings of the closed form to some ps.
 * Time:       picoseconds since power-on. Pieces come in order of t0; they may lie in the future.
 * Position:   tube millimetres from the middle of the screen; the aperture rests where the hand is when a piece
 *             begins.
 * Units:      signal: ucd, luminance in cd/m2 times mm2 of the aperture.
 * Cost:       a piece far away: a few comparisons while nothing glows; near: 10 to 60 us a call.
 * Ownership:  the caller owns the struct; setup, row and phosphor must outlive it. Allocates nothing.
 * Errors:     none; hostile snapshots are refused (inp_pen_state).
 * Determinism: noise is a function of seed and time (input/noise.h).
 * Not modelled: the glass between phosphor and pen, what the pen collects from beyond its aperture, tilt; glow that
 *             moves into the aperture as the hand moves; shot noise of the screen's own light; video
 *             amplifier; the mask's holes.
 */
#ifndef INPUT_PEN_H
#define INPUT_PEN_H

#include <stdbool.h>
#include <stdint.h>

#include "crt/phosphor.h"
#include "crt/piece.h"
#include "crt/state.h"
#include "crt/tube.h"
#include "input/hand.h"

/* X(field, unit, value, low, high, meaning, source) */
#define INP_PEN_FIGURES(X)                                                                         \
    X(aperture, "mm", 3, 2, 5, "diameter of what the pen sees",                                    \
      "estimate: 2 to 5 mm are quoted for pens of the time")                                       \
    X(threshold, "ucd", 25, 0.001, 1e6, "signal at which it fires",                                \
      "estimate: a third of what a full line of the VR17's P39 gives")                             \
    X(response, "us", 0.3, 0.01, 100, "time constant of the detector",                             \
      "estimate: pens of the time took 0.3 to 1 us altogether")                                    \
    X(delay, "us", 0.3, 0, 100, "from the threshold to the pulse at the interface",                \
      "estimate: amplifier, comparator and cable")                                                 \
    X(couple, "us", 20, 1, 1e5, "time constant of the AC coupling",                                \
      "estimate: passes the beam, not lamps and afterglow")                                        \
    X(hold, "us", 2, 0.1, 1000, "how long the pulse stands", "estimate: a one-shot")               \
    X(noise, "ucd", 2, 0, 1e3, "noise of the amplifier, root mean square",                         \
      "estimate: false firings in the dark must not happen")                                       \
    X(room, "lx", 0, 0, 1e5, "light that falls on the screen where the pen looks", "the room's")   \
    X(reflectance, "1", 0.3, 0, 1, "share of that light which the screen throws back",             \
      "estimate: bare phosphor behind glass")                                                      \
    X(shot, "ucd", 0.012, 0, 1e3, "noise of light: its variance a ucd of signal",                  \
      "estimate: 500 lx double the noise")                                                         \
    X(lamp, "Hz", 120, 1, 1e5, "flicker of the lamps", "twice the mains frequency")                \
    X(ripple, "1", 0.1, 0, 1, "amplitude of that flicker, share of the mean",                      \
      "estimate: tungsten lamps; fluorescent ones 0.3")                                            \
    X(infrared, "1", 0, 0, 1,                                                                      \
      "signal of a fast infrared band of a doped screen, share of its visible light",              \
      "0: none; estimate: 0.001 for the doped P39 of the VR17")                                    \
    X(infrared_decay, "us", 1, 0.01, 1000, "time constant of that band", "estimate")

struct inp_pen_setup {
#define X(field, unit, value, low, high, meaning, source) struct crt_figure field;
    INP_PEN_FIGURES(X)
#undef X
};

struct inp_pen_desc {
    const struct inp_pen_setup *setup;
    const struct crt_tube_row *row;
    const struct crt_phosphor *phosphor;
    struct crt_knobs knobs; /* of the monitor, at power-on */
    uint64_t seed;
};

#define INP_NEVER UINT64_MAX

/* The phosphor's terms and the infrared band. */
#define INP_PEN_TERMS (CRT_MAX_TERMS + 1)

/* Worked out of setup, tube and knobs; private. Microseconds, millimetres, ucd. */
struct inp_pen_model {
    int terms;
    double gain[INP_PEN_TERMS], tau[INP_PEN_TERMS]; /* signal for luminous power; time constant */
    int colour[INP_PEN_TERMS];
    double response, couple;
    double radius, reach; /* of the aperture; and within which a beam can matter */
    double sigma;         /* noise, room light included */
    double ripple, lamp;  /* amplitude behind the coupling; radians per ps over 2 pi */
    double stir;          /* what noise and ripple never exceed */
    double threshold;
    uint64_t delay, hold, cell; /* ps; cell: noise is independent from one to the next */
    bool raster;
    double power[CRT_MAX_GUNS]; /* raster tubes: of full drive */
    double current[256];        /* raster tubes: of a dot */
};

/* What the pen remembers; private. */
struct inp_pen_sight {
    uint64_t t;                   /* what follows is as of this time */
    double stored[INP_PEN_TERMS]; /* rate of light of each term within the aperture */
    double fast, slow;            /* the detector's and the coupling's memory */
    bool armed;
    uint64_t pulse; /* when the pulse arrives that is on its way or stands; INP_NEVER */
};

struct inp_pen {
    struct inp_pen_desc desc;
    struct crt_knobs knobs;
    struct inp_hand hand; /* away at power-on */
    bool tip;             /* pressed */
    struct inp_pen_model model;
    struct inp_pen_sight sight;
    bool quiet;    /* nothing can make it fire without light */
    uint64_t wake; /* raster head: when to look for a pulse without light */
};

void inp_pen_init(struct inp_pen *pen, const struct inp_pen_desc *desc);
void inp_pen_reset(struct inp_pen *pen, uint64_t t);

/* Whether it looks at the glass at all: when not, nothing below needs to be called. */
bool inp_pen_looks(const struct inp_pen *pen);

/* When the pulse arrives, were the stroke drawn: at most its t1, and not before t0 where a pulse stands
 * already; INP_NEVER: not by then. */
uint64_t inp_pen_offer(const struct inp_pen *pen, const struct crt_stroke *stroke);
/* What was drawn. A pulse that arrived by its end is spent. True: it did, at *when. */
bool inp_pen_stroke(struct inp_pen *pen, const struct crt_stroke *stroke, uint64_t *when);
void inp_pen_line(struct inp_pen *pen, const struct crt_scan_line *line);

/* When a pulse next arrives without further light, or the pen wants to look for one again (now, if that is
 * past: it has just come to the glass); INP_NEVER: not without light. Of a pen on the vector head always
 * INP_NEVER: the next stroke finds out. */
uint64_t inp_pen_next(const struct inp_pen *pen);
/* At that time. True: a pulse arrived at t, and is spent. Of a pen on the vector head always false. */
bool inp_pen_event(struct inp_pen *pen, uint64_t t);

void inp_pen_set_knobs(struct inp_pen *pen, struct crt_knobs knobs);

/* A snapshot's section "PEN ". */
void inp_pen_state(struct inp_pen *pen, struct crt_state *s);

#endif
