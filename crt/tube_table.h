/* tube_table.h — tubes as data: glass, gun, deflection and generator times, a source per figure.
 *
 * Models:     a tube row is a set of named figures; each has a value, the range it is believed to
 *             lie in, and the source it comes from, or the word "estimate".
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

/* X(field, unit, meaning) */
#define CRT_TUBE_FIGURES(X)                                                                        \
    X(width, "mm", "addressable width")                                                            \
    X(height, "mm", "addressable height")                                                          \
    X(border, "mm", "phosphor beyond the addressable area, each side")                             \
    X(units_x, "units", "addressable units across")                                                \
    X(units_y, "units", "addressable units up")                                                    \
    X(face_radius, "mm", "radius of curvature of the faceplate")                                   \
    X(halation, "1", "share of the light scattered in the faceplate")                              \
    X(spot, "mm", "width of the spot at 60 % of its peak (2.02 sigma), at vanishing current")      \
    X(spot_growth, "mm", "sigma added in quadrature at full current")                              \
    X(spot_exponent, "1", "power of the current in that growth")                                   \
    X(gun_exponent, "1", "power of the drive in the beam current")                                 \
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

struct crt_tube_row {
    char name[24]; /* "VR17" */
    char description[96];
    char phosphor[16]; /* name of the phosphor it has */
#define X(field, unit, meaning) struct crt_figure field;
    CRT_TUBE_FIGURES(X)
#undef X
};

const struct crt_tube_row *crt_tube_rows(size_t *count);
const struct crt_tube_row *crt_tube_row_find(const char *name);

/* The figure called `name` in a row, NULL when there is none; and its unit. */
struct crt_figure *crt_tube_figure(struct crt_tube_row *row, const char *name, const char **unit);

struct crt_screen crt_tube_screen(const struct crt_tube_row *row);

/* Width of a Gaussian at 60 % of its peak, in sigma: 2·sqrt(2·ln(1/0.6)). */
#define CRT_WIDTH60_SIGMA 2.0215356

/* The grid film and planes use: cells no larger than sigma of the smallest spot. Its size must have
 * passed crt_tube_check (built-in rows and those of a catalogue have); else it asserts. */
struct crt_grid crt_tube_grid(const struct crt_tube_row *row);

/* No grid has more cells than this (a plane of 64 MiB). */
#define CRT_MAX_GRID_CELLS 16777216

/* Whether every figure is a number within its possible range, ordered low <= value <= high, and the
 * grid has a sensible size; if not, one sentence naming tube, figure and limits. To be called after
 * figures were changed by hand. */
bool crt_tube_check(const struct crt_tube_row *row, struct crt_error *err);

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
