/* line_beam.h — what a scan line's light depends on besides its dots: amplifier, spot and optics.
 *
 *      dots ─▶ knobs ─▶ video amplifier ─▶ clamp ─▶ power law ─▶ current within each dot
 *                                                                 a0·P0 + a1·P1 + a2·P2 (Legendre)
 *      current ⊗ spot, at each column's place among the dots ─▶ light along the line
 *
 * Models:     drive = contrast·dot/255 + brightness; a one-pole amplifier of time constant
 *             1/(2π·bandwidth), at rest at `brightness` when the line begins; current = clamped drive to
 *             the gun_exponent. The spot is a mixture of a Gaussian of sigma0 and one of sigma at full
 *             current, with the share u = (current)^(2·spot_exponent) in the wide one, so that its second
 *             moment is that of sigma² = sigma0² + (growth·current^exponent)².
 *             The spot is cut at CRT_LINE_CUT sigma, where a term in the eighth power brings it to 0.
 * Power:      a full-drive white field, lit field_duty of the time over width × height, has the mean
 *             luminance field_luminance. Three guns share it so that they make white
 *             (crt/white.h); the terms of a gun's colour share its light as their w are.
 * Method:     drive is an exponential within a dot, so the current is a smooth function of that
 *             exponential: a polynomial through a few nodes, whose moments are known weights. Dots wider
 *             than CRT_WIDEST_DOT sigma are split. Kernels are tabled by phase and by sigma.
 * Units:      mm; dots (after splitting); drive and current 0…1.
 * Sources:    the tube row (crt/tube_table.h). Half the power at `bandwidth`: definition.
 * Ownership:  crt_line_beams owns all beams; those asked for stay until crt_line_beams_trim.
 * Errors:     NULL when memory is out.
 * Not modelled: overshoot of the amplifier, saturation of the phosphor.
 */
#ifndef CRT_LINE_BEAM_H
#define CRT_LINE_BEAM_H

#include "crt/lines.h"
#include "crt/optics.h"

#define CRT_LINE_SETS  2 /* spots that the mixture is made of */
#define CRT_LINE_CUT   4.0
#define CRT_LINE_EDGE  3.35462627902511839e-4F /* e^(−CUT²/2) */
#define CRT_WIDEST_DOT 1.5                     /* sigma */
#define CRT_MOST_PARTS 10000                   /* of a dot; lines of wider dots are left out */
#define CRT_LINE_NODES 24                      /* at most */
#define CRT_LINE_SEG   8                       /* columns of one sigma */
#define CRT_LINE_ANCHOR                                                                            \
    32 /* columns between which what varies over the screen is a straight line */
#define CRT_SIGMA_LEVELS 8192 /* of sigma: e^(n/CRT_LEVEL_STEPS) */
#define CRT_LEVEL_STEPS  2000.0
#define CRT_LEVEL_BASE   2048 /* the level of the spot in the centre of the screen */

/* 32768 in a kernel is 1; 30000 in a line's light is the current of its brightest dot. */
#define CRT_KERNEL_BITS 15
#define CRT_FULL_LIGHT  30000.0F

/* The kernels of one sigma: for each phase, for each pair of dots, for a0, 2·a1, 4·a2: two int16. */
struct crt_line_level {
    int reach; /* the first dot is floor(place) − reach */
    int pairs;
    int stride; /* int16 a phase, a multiple of 16 */
    int16_t *kernel;
};

struct crt_line_spot {
    double sigma_mm;   /* in the centre */
    double sigma_dots; /* the same, in dots */
    int phase_bits;
    struct crt_line_level level[CRT_SIGMA_LEVELS]; /* made when first needed */
};

/* Where the columns lie among the dots, in the middle of one band of the screen, for each gun. */
struct crt_line_place {
    int64_t band;
    double y_mm;
    int col0[CRT_MAX_GUNS], col1[CRT_MAX_GUNS]; /* columns that dots reach, in eights */
    int dot0[CRT_MAX_GUNS], dot1[CRT_MAX_GUNS]; /* dots that reach columns */
    double most_spread, most_landing;           /* of anchors; mm up or down */
    int margin[CRT_MAX_GUNS];  /* dots beyond these that kernels of such columns touch */
    int64_t *at[CRT_MAX_GUNS]; /* place of each 8th column, 2^-32 dots */
    uint16_t *level[CRT_MAX_GUNS][CRT_LINE_SETS]; /* of each 8 columns */
    float *landing[CRT_MAX_GUNS], *spread[CRT_MAX_GUNS],
        *amount[CRT_MAX_GUNS]; /* of anchors: mm up,
                     sigma in parts of the centre's, light in parts of the centre's */
};

/* The way of lines over the screen. */
struct crt_line_course {
    float x0, x1;
    int dots;
    double focus;
    int parts;       /* of each dot as delivered */
    double pitch_mm; /* of dots after splitting */
    double band_mm;
    bool even; /* nothing varies over the screen */
    int sets;
    struct crt_line_spot *spot[CRT_LINE_SETS];
    struct crt_line_place **place;
    size_t places, room;
    uint64_t used;
};

enum crt_line_power { CRT_POWER_5_2, CRT_POWER_5_2_AND_11_2, CRT_POWER_TABLE };
#define CRT_POWER_CELLS 2048

struct crt_line_beam {
    struct crt_line_way way;
    struct crt_line_course *course;
    float gain, offset;              /* drive = gain·dot + offset */
    float start;                     /* the amplifier's output when the line begins */
    float fade;                      /* what is left of a step after a dot */
    int nodes;                       /* the first is the dot's begin, the last its end */
    float node[CRT_LINE_NODES];      /* what is left of a step there */
    float weight[3][CRT_LINE_NODES]; /* of the current there, in a0, a1/2, a2/4 */
    double rate;                     /* e^(−rate·t) in a dot, t = 0…1 */
    bool clamped;                    /* some drive is below 0 or above 1 */
    enum crt_line_power power;
    const float *table[CRT_LINE_SETS]; /* current of √drive: whole, and wide share of it */
    uint64_t used;
};

struct crt_line_beams {
    const struct crt_tube_row *row;
    struct crt_grid grid;
    struct crt_optics optics;
    int guns, sets;
    double sigma_mm[CRT_LINE_SETS]; /* best focus */
    double power[CRT_MAX_GUNS];     /* cd·mm²/m² of a full drive */
    float *table[CRT_LINE_SETS];    /* CRT_POWER_CELLS + 1, or NULL */
    struct crt_line_beam **beam;
    size_t beams, beam_room;
    struct crt_line_course **course;
    size_t courses, course_room;
    uint64_t turn;
};

/* False and a sentence when memory is out or three colours cannot make white. */
bool crt_line_beams_init(struct crt_line_beams *beams, const struct crt_tube_row *row,
                         const struct crt_phosphor *phosphor, const struct crt_grid *grid,
                         struct crt_error *err);
void crt_line_beams_free(struct crt_line_beams *beams);

struct crt_line_beam *crt_line_beam_find(struct crt_line_beams *beams,
                                         const struct crt_line_way *way);
/* The place of a band, with all levels it needs. */
const struct crt_line_place *crt_line_place_find(const struct crt_line_beams *beams,
                                                 struct crt_line_course *course, int64_t band);
/* Forgets all but the beams used last. */
void crt_line_beams_trim(struct crt_line_beams *beams);

/* Current of a drive, and the part of it in the wide spot. */
void crt_line_current(const struct crt_tube_row *row, double drive, double current[CRT_LINE_SETS]);

/* Area of the cut spot's profile, in sigma. */
double crt_line_area(void);

#endif
