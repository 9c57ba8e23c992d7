/* pen.h — a light pen: sees the light that beam pieces make under its tip, and says when.
 *
 *      strokes, scan lines ─▶ aperture ─▶ phosphor's rate ─▶ + noise, room ─▶ coupling, low pass ─▶ threshold
 *                                                                                              │
 *                 display processor stops / raster head latches ◀── delay ── pulse ◀────────────┘
 *
 * Models:     the luminous intensity of what the phosphor emits within a round aperture, Σ_k (w_k/τ_k)-wise, as
 *             a detector that is flat over the visible range sees it; a one-pole detector; AC coupling; a
 *             comparator that fires when the signal rises above the threshold, and is armed again when
 *             it has fallen below its half; a fixed delay until the pulse arrives; the pulse stands for
 *             `hold`, so that it is seen where the beam is lit a moment later only. Noise of the
 *             amplifier, and of room light that reaches the tip; room light flickers with the mains.
 * Offers:     inp_pen_offer() tells when a piece would make the pen fire and changes nothing;
 *             inp_pen_stroke() and inp_pen_line() are told what was really drawn. So a stroke that the
 *             display processor cuts at a hit is seen only as far as it was drawn.
 * Time:       picoseconds since power-on. Pieces come in order of t0; they may lie in the future.
 * Position:   tube millimetres from the middle of the screen.
 * Units:      signal: µcd, luminance in cd/m² times mm² of the aperture.
 * Ownership:  the caller owns the struct; setup, row and phosphor must outlive it. Allocates nothing.
 * Errors:     none; hostile snapshots are refused (inp_pen_state).
 * Determinism: noise is a function of seed and time (input/noise.h).
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
      "estimate: half of what a full line of the VR17's P39 gives")                                \
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

/* When a pulse next arrives without further light, or the pen wants to look for one again; INP_NEVER:
 * not without light. */
uint64_t inp_pen_next(const struct inp_pen *pen);
/* At that time. True: a pulse arrived at t, and is spent. Of a pen on the vector head it stands for
 * `hold` instead, to be seen by the next stroke, and this is false. */
bool inp_pen_event(struct inp_pen *pen, uint64_t t);

void inp_pen_set_knobs(struct inp_pen *pen, struct crt_knobs knobs);

/* A snapshot's section "PEN ". */
void inp_pen_state(struct inp_pen *pen, struct crt_state *s);

#endif
