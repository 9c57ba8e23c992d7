/* photodiode_parts.h — what a photodiode is made of; private to its files and to crt/waveform.c.
 *
 *      stroke, scan line ──▶ flux (crt/flux.h) ──▶ piece: moments, light per term when it is done
 *                                  ▲                          │
 *      looked into again, when asked for a time within ◀──────┘
 *
 * Models:     per phosphor term k, luminance L_k: dL_k/dt = −L_k/τ_k + weight_k·q(t)/τ_k, where q is the flux
 *             of a piece and weight_k the term's share of it.
 * Method:     what pieces give when they are done is worked out once; a cursor adds them up in order. It
 *             stands at the end of the last piece it has passed, so that what is read does not depend on
 *             what was read before.
 * Ownership:  all belongs to the diode.
 */
#ifndef CRT_PHOTODIODE_PARTS_H
#define CRT_PHOTODIODE_PARTS_H

#include "crt/aperture.h"
#include "crt/flux.h"
#include "crt/journal.h"
#include "crt/line_beam.h"
#include "crt/photodiode.h"

/* The dots of a scan line that reach the place, of each gun one after the other; on the whole screen none, but
 * the mean rate. */
struct crt_line_cut {
    double x0_mm, y_mm, pitch_mm; /* of the first of these dots */
    double start_s, dot_s;        /* when it begins, after the line's start */
    double gain, offset;          /* drive = gain·dot + offset */
    double blur, amplifier_s;
    double before[CRT_MAX_GUNS]; /* the amplifier's output when it begins */
    double rate[CRT_MAX_GUNS];   /* whole screen: cd/m² all the time */
    int dots, guns;
    uint8_t drive[];
};

struct crt_diode_piece {
    uint64_t t0;           /* ps */
    uint64_t done;         /* ps: all its light has fallen */
    double from_s, to_s;   /* s after t0: the part that counts */
    double lit0_s, lit1_s; /* when light falls on the place */
    int beams;
    struct crt_flux_moments beam[CRT_MAX_GUNS];
    uint64_t t1;
    struct crt_entry entry;   /* of a stroke */
    struct crt_line_cut *cut; /* of a scan line, or NULL */
    uint32_t source;
};

/* Luminance per term at t. */
struct crt_diode_store {
    uint64_t t;
    double cd_m2[CRT_MAX_TERMS];
};

/* The cursor at every CRT_MARK_STEP-th piece, for going back. */
#define CRT_MARK_STEP 64
struct crt_diode_mark {
    struct crt_diode_store store;
    size_t at; /* the first piece not passed */
};

/* Energy of a dot by what the amplifier comes from and goes to, in parts of a dot at full drive. */
struct crt_dot_energy {
    struct crt_line_way way;
    double at[256][256]; /* [from][to] */
};
#define CRT_DOT_ENERGIES 4

struct crt_photodiode {
    struct crt_tube *tube;
    struct crt_photodiode *next; /* the tube's list */
    struct crt_photodiode_desc desc;
    struct crt_aperture aperture;
    uint64_t from;
    struct crt_diode_store base, cursor;
    size_t cursor_at; /* the first piece the cursor has not passed */
    struct crt_diode_mark *mark;
    size_t marks, mark_room;
    struct crt_diode_piece *piece;
    double *end; /* [piece][term]: cd/m² at `done` */
    size_t first, count, room;
    struct crt_deposit *deposit; /* the same indices; those begun by the last advance */
    size_t shown, deposit_room;
    struct crt_flux flux; /* of piece flux_of */
    size_t flux_of;       /* SIZE_MAX: none */
    struct crt_dot_energy *energy[CRT_DOT_ENERGIES];
    int next_energy;
    uint64_t lost;
};

/* ---- making flux (photodiode_stroke.c, photodiode_line.c, photodiode_field.c) ------------------- */

/* Adds what a stroke puts on the place from `from` to `to` seconds after its start. False: memory out. */
bool crt_flux_stroke(struct crt_flux *flux, struct crt_aperture *aperture,
                     const struct crt_entry *entry, double from, double to);

/* The cut of a line; *cut NULL when it does not reach the place. False: memory out. */
bool crt_line_cut(struct crt_photodiode *diode, const struct crt_scan_line *line,
                  const struct crt_knobs *knobs, struct crt_line_cut **cut);
bool crt_flux_line(struct crt_flux *flux, struct crt_aperture *aperture,
                   const struct crt_line_beams *beams, const struct crt_line_cut *cut, double from,
                   double to);
/* Current of a drive in each spot, as crt_line_current. */
void crt_cut_current(const struct crt_tube_row *row, double drive, double current[CRT_LINE_SETS]);
/* Within a dot: moments between which the amplifier changes little; returns how many. */
#define CRT_CUT_ENDS 8
int crt_cut_ends(double dot_s, double amplifier_s, double ends[CRT_CUT_ENDS]);

/* Mean current over a line, of a gun: full drive is 1. */
bool crt_field_mean(struct crt_photodiode *diode, const struct crt_scan_line *line,
                    const struct crt_knobs *knobs, double mean[CRT_MAX_GUNS]);

/* ---- pieces (photodiode_piece.c) ---------------------------------------------------------------- */

int crt_diode_terms(const struct crt_photodiode *diode);
/* Share of a piece's beam that goes to term k. */
double crt_diode_weight(const struct crt_photodiode *diode, const struct crt_diode_piece *piece,
                        int beam, int k);
/* Makes the flux of a piece in `flux`, which is emptied first. */
bool crt_diode_flux(struct crt_photodiode *diode, const struct crt_diode_piece *piece,
                    struct crt_flux *flux);
/* The same, kept; NULL when memory is out. */
const struct crt_flux *crt_diode_flux_of(struct crt_photodiode *diode, size_t i);
/* Fills in what follows from the flux, and the light per term when done; false when nothing falls. */
bool crt_diode_finish(struct crt_photodiode *diode, struct crt_diode_piece *piece,
                      const struct crt_flux *flux, double end[CRT_MAX_TERMS]);
/* Adds what piece i gives at t. */
void crt_diode_piece_at(struct crt_photodiode *diode, size_t i, uint64_t t,
                        double cd_m2[CRT_MAX_TERMS]);
/* What falls between a and b, as fluence times e^(−jω(t − t0 of the piece)), of each beam. */
void crt_diode_piece_turned(struct crt_photodiode *diode, size_t i, uint64_t a, uint64_t b,
                            double omega, struct crt_phasor beam[CRT_MAX_GUNS]);

/* ---- light from before (photodiode_older.c) ------------------------------------------------------ */

/* What planes and journal have at the tube's `now`; pieces that go on are delivered to the diode. */
void crt_diode_begin(struct crt_photodiode *diode);

/* ---- the diode (photodiode.c) -------------------------------------------------------------------- */

void crt_diode_add_entry(struct crt_photodiode *diode, const struct crt_entry *entry,
                         uint64_t from);
void crt_diode_add_line(struct crt_photodiode *diode, const struct crt_scan_line *line,
                        const struct crt_knobs *knobs, uint64_t from);

/* ---- reading (photodiode_read.c) ------------------------------------------------------------------ */

void crt_diode_decay(const struct crt_photodiode *diode, const struct crt_diode_store *store,
                     uint64_t t, double cd_m2[CRT_MAX_TERMS]);
/* The store after piece i. */
void crt_diode_pass(const struct crt_photodiode *diode, struct crt_diode_store *store, size_t i);
/* Pieces before `first` were passed into the base; then pieces move forward by `by`. */
void crt_diode_drop_marks(struct crt_photodiode *diode, size_t first);
void crt_diode_move_marks(struct crt_photodiode *diode, size_t by);

/* A stretch of time in which luminance follows start·e^(−t/τ) + toward·(1 − e^(−t/τ)) by term: exactly in the
 * dark; while light falls, as if it fell evenly. */
struct crt_diode_stretch {
    double at_s, seconds; /* from t0 of the walk */
    bool lit;
    double start[CRT_MAX_TERMS], toward[CRT_MAX_TERMS];
    double end[CRT_MAX_TERMS]; /* exactly */
    double first, last;        /* sums of start and end */
};
/* Of a stretch, t seconds after it began. */
double crt_stretch_at(const struct crt_phosphor *phosphor, const struct crt_diode_stretch *s,
                      double t);
typedef void crt_stretch_fn(void *context, const struct crt_diode_stretch *stretch);
/* Stretches that cross `level` while light falls are cut up until that is exact; infinity: none are. */
void crt_diode_walk(struct crt_photodiode *diode, uint64_t t0, uint64_t t1, double level,
                    crt_stretch_fn *each, void *context);

/* ---- the tube (tube.c, tube_state.c) ----------------------------------------------------------------- */

void crt_diodes_stroke(struct crt_photodiode *list, const struct crt_entry *entry);
void crt_diodes_scan_line(struct crt_photodiode *list, const struct crt_scan_line *line,
                          const struct crt_knobs *knobs);
void crt_diodes_advance(struct crt_photodiode *list);
/* A snapshot was loaded; with `dark` that failed. */
void crt_diodes_restart(struct crt_photodiode *list, bool dark);

#endif
