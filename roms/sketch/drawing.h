/* drawing.h — what a drawing is made of: points, and figures between them.
 *
 *      figures: line ─ circle ─ arc ─ copy ──▶ points 0 … 767   a point that two lines end at is one
 *         └── copy ──▶ subpicture A … P ──▶ figures of its own   point: it stays shared when dragged
 *
 * Models:     a store of numbered slots. A point lives as long as a figure uses it. Lines may be kept
 *             horizontal or vertical (constraint.h). A copy shows a subpicture moved, turned and
 *             scaled; subpictures may hold copies of others, never of themselves.
 * Time:       each change of a slot is told first to `changing` (undo.h) and noted in `fresh` (view.h).
 * Domain:     places within ±PLACE_MOST; scales of SCALE_LEAST…SCALE_MOST; pictures that show at most
 *             DRAWING_STROKES figures when their copies are counted in full.
 * Units:      places in hundredths of a stage unit, angles in hundredths of a degree 0…35999,
 *             anticlockwise, scales in thousandths: whole numbers, so that text keeps them exactly.
 * Ownership:  plain value; `changing` is its owner's.
 * Errors:     a status, and a sentence for it; what fails changes nothing.
 * Source:     I. E. Sutherland, Sketchpad: A Man-Machine Graphical Communication System (MIT, 1963).
 * Not modelled: constraints but for shared points, horizontal, vertical; text.
 */
#ifndef ROMS_SKETCH_DRAWING_H
#define ROMS_SKETCH_DRAWING_H

#include <stdbool.h>
#include <stdint.h>

enum {
    DRAWING_POINTS = 768,
    DRAWING_FIGURES = 480,
    DRAWING_MASTERS = 16,   /* subpictures: pictures 1 …; picture 0 is the drawing */
    DRAWING_STROKES = 1200, /* figures that a picture shows, those of copies counted */
    DRAWING_ENDS = 3,       /* points of a figure, at most */
    PLACE_UNIT = 100,
    PLACE_MOST = 1000000,
    SCALE_ONE = 1000,
    SCALE_LEAST = 10,
    SCALE_MOST = 100000,
    ANGLE_DEGREE = 100,
    ANGLE_TURN = 36000
};

enum figure_kind { FIGURE_NONE, FIGURE_LINE, FIGURE_CIRCLE, FIGURE_ARC, FIGURE_COPY };
enum constraint { CONSTRAINT_NONE, CONSTRAINT_HORIZONTAL, CONSTRAINT_VERTICAL };

struct place {
    int32_t x, y;
};

struct drawing_point {
    struct place at;
    uint16_t users; /* ends of figures that are here; 0: the slot is free */
    uint16_t picture;
};

struct figure {
    uint8_t kind;       /* enum figure_kind */
    uint8_t picture;    /* that it is in */
    uint8_t constraint; /* of a line */
    uint8_t master;     /* picture that a copy shows */
    /* Line: both ends. Circle: middle, rim. Arc: middle, where it begins (that is its radius), the
     * direction where it ends, anticlockwise. Copy: where the subpicture's origin is. */
    uint16_t end[DRAWING_ENDS];
    uint16_t spare; /* 0 */
    int32_t scale, angle;
};

struct master {
    struct place origin;
    uint32_t used;
};

/* All of it: equal drawings are equal bytes. */
struct drawing_state {
    struct drawing_point point[DRAWING_POINTS];
    struct figure figure[DRAWING_FIGURES];
    struct master master[DRAWING_MASTERS + 1]; /* [0]: unused */
};

enum drawing_table { TABLE_POINT, TABLE_FIGURE, TABLE_MASTER };

struct drawing {
    struct drawing_state now;
    void (*changing)(void *ctx, enum drawing_table table, int index); /* NULL: nobody listens */
    void *ctx;
    /* Slots that were changed; whoever has seen that clears them. */
    bool fresh_point[DRAWING_POINTS], fresh_figure[DRAWING_FIGURES];
    bool fresh_masters; /* something that copies show */
};

enum drawing_status {
    DRAWING_OK,
    DRAWING_POINTS_FULL,
    DRAWING_FIGURES_FULL,
    DRAWING_MASTERS_FULL,
    DRAWING_STROKES_FULL,
    DRAWING_OUTSIDE,
    DRAWING_FLAT,
    DRAWING_IN_ITSELF,
    DRAWING_NOTHING,
    DRAWING_NO_MASTER,
    DRAWING_SAME_FIGURE,
    DRAWING_NO_LINE
};

/* An end of a figure that is to be: a point that there is, or (point < 0) a new one. */
struct drawing_end {
    int point;
    struct place at;
};

void drawing_begin(struct drawing *d);
const char *drawing_sentence(enum drawing_status status);
/* Ends that a kind of figure has. */
int figure_ends(unsigned kind);
bool place_is_inside(struct place p);

/* `like` gives all but the ends. *figure: its slot. */
enum drawing_status drawing_add(struct drawing *d, const struct figure *like,
                                const struct drawing_end *ends, int *figure);
void drawing_delete(struct drawing *d, int figure);
void drawing_clear(struct drawing *d);
/* All that ends at `from` ends at `into`. */
enum drawing_status drawing_merge(struct drawing *d, int from, int into);
/* Makes it the other state, slot by slot. */
void drawing_become(struct drawing *d, const struct drawing_state *state);

/* Told, noted, and then to be written by the caller. */
struct drawing_point *drawing_change_point(struct drawing *d, int index);
struct figure *drawing_change_figure(struct drawing *d, int index);
struct master *drawing_change_master(struct drawing *d, int index);

/* A figure's place of an end. */
struct place drawing_end_place(const struct drawing_state *s, int figure, int end);
/* Figures that a picture shows, copies counted in full; at most DRAWING_STROKES + 1. */
int drawing_strokes(const struct drawing_state *s, int picture);
/* Whether the picture shows the other one, however deep; a picture shows itself. */
bool drawing_reaches(const struct drawing_state *s, int picture, int other);
/* How full the store is that is fullest, in hundredths. */
int drawing_fullness(const struct drawing_state *s);

#endif
