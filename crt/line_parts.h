/* line_parts.h — what a pass over scan lines is made of; private to the files of that pass.
 *
 *      line_pass.c    lines to weights, rows of lines and glows
 *      line_bands.c   rows of lines to rows of cells, band by band
 *
 * Units:      mm; columns and rows of cells.
 * Ownership:  all parts belong to the pass.
 * Errors:     false when memory is out.
 */
#ifndef CRT_LINE_PARTS_H
#define CRT_LINE_PARTS_H

#include "crt/line_held.h"
#include "crt/line_memory.h"
#include "crt/line_pass.h"

/* Rows of cells, of one band, worked on together. */
#define CRT_LINE_STEP 64
/* Targets of one gun worked on together. */
#define CRT_LINE_TOGETHER 4

/* Dots of a line in a sigma of its spot, at most; lines of narrower dots are none that a head draws. */
#define CRT_MOST_DOTS 1e4

/* Lines that give a target less than this part of what the brightest gives it are left out. */
#define CRT_LINE_FAINT 1e-5

enum crt_line_kind {
    CRT_LINE_NONE,
    CRT_LINE_WHOLE,   /* the share of a whole line is known */
    CRT_LINE_CUT_OFF, /* a share begins or ends within the line */
    CRT_LINE_OWN      /* a glow of its own */
};

/* Of one line and target: light = (w0 + w1·column) × glow. */
struct crt_line_weight {
    enum crt_line_kind kind;
    float w0, w1;
    double peak; /* current */
    struct crt_share_fit fit;
    struct crt_glow *own; /* of lane 0 */
};

struct crt_line_entry {
    const struct crt_line *line;
    float y;
    size_t order;
    size_t weight; /* of the first target */
    uint64_t begin, end;
    const struct crt_receiver *receivers; /* for targets first … first + count − 1 */
    int first, count;
    bool used;
    bool repeats; /* the entry in front of it, dot for dot: their light is added once */
    const struct crt_line_course *course;
    const struct crt_line_place *place;
};

/* Entries [first, end) lie on one line of the screen. */
struct crt_line_row {
    float y;
    const struct crt_line_course *course;
    const struct crt_line_place *place;
    size_t first, end;
    double reach_mm;
};

struct crt_line_make {
    struct crt_strip *strip;
    const struct crt_line_place *place;
    bool ok;
};

struct crt_line_worker {
    struct crt_line_scratch scratch;
    float *lines; /* [target together][row][set][column of the tile] */
    size_t lines_room;
    struct crt_line_across *across; /* [row][set] */
    size_t across_room;
    float *weights; /* [row][set][anchor of the tile] */
    size_t weights_room;
    const float **pointers; /* of lines and weights for the kernel */
    size_t pointers_room;
    struct crt_line_near *near;
    size_t near_room;
    bool *lit; /* [target together][row][set] */
    size_t lit_room;
};

struct crt_line_pass {
    struct crt_grid grid;
    struct crt_line_beams beams;
    const struct crt_line_kernels *kernels;
    struct crt_line_worker *worker;
    int workers;
    struct crt_strip_memory *memory; /* NULL: none */
    bool even;                       /* nothing varies over the screen */
    double area;                     /* crt_line_area() */
    struct crt_line_held held;
    struct crt_line_key *key; /* of rows */
    size_t key_room;
    /* the running pass */
    struct crt_line_target target[CRT_MAX_TARGETS];
    int targets, planes; /* planes come first */
    double brightest[CRT_MAX_TARGETS];
    double peak_drive[CRT_MAX_GUNS], peak[CRT_MAX_GUNS];
    struct crt_line_entry *entry;
    size_t entries, entry_room;
    struct crt_line_weight *weight;
    size_t weight_room;
    struct crt_line_row *row;
    size_t rows, row_room;
    struct crt_line_make *make;
    size_t makes, make_room;
    struct crt_glow **glow; /* own ones */
    size_t glows, glow_room;
    double reach_mm; /* of all rows */
};

/* Memory for the bands. */
bool crt_line_bands_prepare(struct crt_line_pass *pass);

#endif
