/* tube_table.h — tubes as data: glass, gun, deflection, mask and generator times, a source per
 * figure.
 *
 * Models:     a tube row is a set of named figures in groups; each figure has a value, the range it
 *             is believed to lie in, and the source it comes from, or the word "estimate". Which
 *             groups a row has follows from what it is: vector or raster, how many guns.
 * Units:      in the X-macro below.
 * Sources:    in the rows (`kinescope list tubes --why` prints them).
 * Ownership:  built-in rows are constant. A catalogue owns its rows and their text until
 *             crt_catalogue_free().
 * Errors:     crt_catalogue_load() writes one sentence with file and line.
 * Not modelled: see crt/tube.h.
 */
#ifndef CRT_TUBE_TABLE_H
#define CRT_TUBE_TABLE_H

#include <stdbool.h>
#include <stddef.h>

#include "crt/error.h"
#include "crt/geometry.h"
#include "crt/phosphor.h"

struct crt_figure {
    double value, low, high;
    const char *source; /* a citation, or "estimate: why" */
};

/* What a tube is for; which groups of figures a row has follows from it. */
enum crt_tube_kind {
    CRT_VECTOR_TUBE, /* of a random-scan head */
    CRT_RASTER_TUBE  /* of a raster head */
};

/* What stands before the phosphor of a three-gun tube. */
enum crt_mask_kind {
    CRT_MASK_NONE,  /* one gun, an even phosphor */
    CRT_MASK_DELTA, /* round holes, triads of dots; guns in a triangle */
    CRT_MASK_SLOT,  /* slots with bridges, stripes; guns in line */
    CRT_MASK_GRILLE /* aperture grille: stripes from top to bottom; guns in line */
};

/* X(field, unit, meaning): every tube has these. */
#define CRT_FIGURES_COMMON(X)                                                                      \
    X(width, "mm", "addressable width")                                                            \
    X(height, "mm", "addressable height")                                                          \
    X(border, "mm", "phosphor beyond the addressable area, each side")                             \
    X(face_radius, "mm", "radius of curvature of the faceplate")                                   \
    X(halation, "1", "share of the light scattered in the faceplate")                              \
    X(spot, "mm", "width of the spot at 60 % of its peak (2.02 sigma), at vanishing current")      \
    X(spot_growth, "mm", "sigma added in quadrature at full current")                              \
    X(spot_exponent, "1", "power of the current in that growth")                                   \
    X(gun_exponent, "1", "power of the drive in the beam current")

/* Vector tubes. */
#define CRT_FIGURES_VECTOR(X)                                                                      \
    X(units_x, "units", "addressable units across")                                                \
    X(units_y, "units", "addressable units up")                                                    \
    X(drive_low, "1", "drive of intensity level 0; level 7 is 1")                                  \
    X(line_luminance, "cd/m2", "mean luminance of the crest of a full-drive line")                 \
    X(line_speed, "mm/us", "beam speed at which line_luminance holds")                             \
    X(line_refresh, "Hz", "refresh rate at which line_luminance holds")                            \
    X(sync, "Hz", "line sync tick")                                                                \
    X(fetch, "us", "fetch and decode of one word")                                                 \
    X(vector_setup, "us", "vector: set-up")                                                        \
    X(vector_unit, "us", "vector: per unit of the longer axis")                                    \
    X(vector_rest, "us", "vector: lit at rest at each end, within the set-up")                     \
    X(settle, "us", "beam-off move: fixed part")                                                   \
    X(settle_unit, "us", "beam-off move: per unit of the longer axis")                             \
    X(settle_max, "us", "beam-off move: at most")                                                  \
    X(point, "us", "point: time lit")                                                              \
    X(character, "us", "character: whole cell")                                                    \
    X(dot, "us", "character: each dot lit")                                                        \
    X(intensify, "us", "pen intensify spot: time lit")

/* Vector tubes whose colour follows the beam voltage. */
#define CRT_FIGURES_PENETRATION(X)                                                                 \
    X(kv_red, "kV", "beam voltage of colour 1, red")                                               \
    X(kv_orange, "kV", "beam voltage of colour 2, orange")                                         \
    X(kv_yellow, "kV", "beam voltage of colour 3, yellow")                                         \
    X(kv_green, "kV", "beam voltage of colour 4, green")                                           \
    X(kv_dead, "kV", "voltage below which the screen stays dark")                                  \
    X(kv_exponent, "1", "power of the voltage above that in the light")                            \
    X(colour_switch, "us", "change of the beam voltage, until the beam may be lit again")          \
    X(colour_register, "1", "deflection left uncorrected, in parts of what the voltage changes")

/* Raster tubes. */
#define CRT_FIGURES_RASTER(X)                                                                      \
    X(field_luminance, "cd/m2", "mean luminance of a full-drive white field")                      \
    X(field_duty, "1", "share of the time the beam is lit in the mode that holds for")             \
    X(bandwidth, "MHz", "video amplifier: half the power, one pole")                               \
    X(spot_edge, "1", "sigma in the corner, in parts of that in the centre")                       \
    X(h_min, "kHz", "lowest line rate")                                                            \
    X(h_max, "kHz", "highest line rate")                                                           \
    X(v_min, "Hz", "lowest vertical rate (of fields)")                                             \
    X(v_max, "Hz", "highest vertical rate (of fields)")                                            \
    X(clock_max, "MHz", "highest dot clock")

/* Raster tubes with three guns. */
#define CRT_FIGURES_MASK(X)                                                                        \
    X(mask_pitch, "mm", "triads: nearest holes; slots and grilles: one stripe of each colour")     \
    X(mask_transmission, "1", "share of the screen that one beam reaches through the mask")        \
    X(converge, "mm", "miss of the outer beams in the centre")                                     \
    X(converge_edge, "mm", "what is added to that in the corner")                                  \
    X(landing, "mm", "miss of the beams on their phosphor in the centre (purity)")                 \
    X(landing_edge, "mm", "what is added to that in the corner")

#define CRT_TUBE_FIGURES(X)                                                                        \
    CRT_FIGURES_COMMON(X)                                                                          \
    CRT_FIGURES_VECTOR(X)                                                                          \
    CRT_FIGURES_PENETRATION(X)                                                                     \
    CRT_FIGURES_RASTER(X)                                                                          \
    CRT_FIGURES_MASK(X)

enum crt_figure_group {
    CRT_GROUP_COMMON,
    CRT_GROUP_VECTOR,
    CRT_GROUP_PENETRATION,
    CRT_GROUP_RASTER,
    CRT_GROUP_MASK
};

/* Figures of groups a row does not have are 0 and have no source. */
struct crt_tube_row {
    char name[24]; /* "VR17" */
    char description[96];
    char phosphor[16]; /* name of the phosphor it has */
    enum crt_tube_kind kind;
    bool penetration;        /* vector tubes: the colour follows the beam voltage */
    enum crt_mask_kind mask; /* raster tubes */
    char mode[24];           /* raster tubes: the mode they are used in, "1024x768@60" */
#define X(field, unit, meaning) struct crt_figure field;
    CRT_TUBE_FIGURES(X)
#undef X
};

/* 3 with a mask, else 1. Colour c of a three-gun tube's phosphor is what gun c lights. */
int crt_tube_guns(const struct crt_tube_row *row);

bool crt_tube_has_group(const struct crt_tube_row *row, enum crt_figure_group group);
/* Whether the row's group has the figure called `name`; false, too, when there is no such figure. */
bool crt_tube_has_figure(const struct crt_tube_row *row, const char *name);

const struct crt_tube_row *crt_tube_rows(size_t *count);
const struct crt_tube_row *crt_tube_row_find(const char *name);

/* The figure called `name` in a row, whether it applies or not; NULL when there is none; and its
 * unit. */
struct crt_figure *crt_tube_figure(struct crt_tube_row *row, const char *name, const char **unit);

/* How head units lie on a vector tube. On a raster tube they are the dots of its mode
 * (raster/head.h): here they are set to 1 and 1. */
struct crt_screen crt_tube_screen(const struct crt_tube_row *row);

/* Width of a Gaussian at 60 % of its peak, in sigma: 2·sqrt(2·ln(1/0.6)). */
#define CRT_WIDTH60_SIGMA 2.0215356

/* The grid film and planes use: cells no larger than sigma of the smallest spot. Its size must have
 * passed crt_tube_check (built-in rows and those of a catalogue have); else it asserts. */
struct crt_grid crt_tube_grid(const struct crt_tube_row *row);

/* No grid has more cells than this (a plane of 64 MiB). */
#define CRT_MAX_GRID_CELLS 16777216

/* Whether every figure is a number within its possible range, ordered low <= value <= high, figures
 * that belong together agree, and the grid has a sensible size; if not, one sentence naming tube,
 * figure and limits. To be called after figures were changed by hand. */
bool crt_tube_check(const struct crt_tube_row *row, struct crt_error *err);

/* Whether the tube can have the phosphor: three guns need three colours. */
bool crt_tube_check_phosphor(const struct crt_tube_row *row, const struct crt_phosphor *phosphor,
                             struct crt_error *err);

/* The same for the figure called `name` alone. */
bool crt_tube_check_figure(const struct crt_tube_row *row, const char *name, struct crt_error *err);

/* A catalogue: the built-in rows and phosphors plus those of INI files. */
struct crt_catalogue {
    struct crt_tube_row *tubes;
    size_t tube_count;
    struct crt_phosphor *phosphors;
    size_t phosphor_count;
    char **strings; /* text the rows point at */
    size_t string_count;
};

bool crt_catalogue_init(struct crt_catalogue *c, struct crt_error *err);
/* Adds the [tube NAME] and [phosphor NAME] sections of an INI file (format: crt/tube_ini.h); a tube
 * may name `like = VR17` and change only some figures. Nothing is added when the file has an error.
 * Rows looked up before may move: look them up again. */
bool crt_catalogue_load(struct crt_catalogue *c, const char *path, struct crt_error *err);
/* The same for text in memory, `length` bytes; `name` stands for the file in sentences. */
bool crt_catalogue_load_text(struct crt_catalogue *c, const char *name, const char *text,
                             size_t length, struct crt_error *err);
const struct crt_tube_row *crt_catalogue_tube(const struct crt_catalogue *c, const char *name);
const struct crt_phosphor *crt_catalogue_phosphor(const struct crt_catalogue *c, const char *name);
void crt_catalogue_free(struct crt_catalogue *c);

#endif
