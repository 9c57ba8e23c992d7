/* lines.h — the journal of scan lines: lines that planes do not hold yet, in strips.
 *
 *      crt_tube_scan_line ──▶ lines ──▶ strip: up to 8 lines that sweep alike, side by side
 *                             (times)          (dots; later their light along the columns)
 *
 * Models:     lines in order of their start, those of the running epoch and, as far as quick terms of
 *             the phosphor need them, those of the epoch before. What a line looks like lies in a strip,
 *             which it shares with up to seven neighbours; strips that look the same field after field
 *             share the light that was worked out once (crt/line_light.h).
 * Bands:      lines of a strip lie in one band of the screen, whose height follows from the way of the
 *             lines and the tube's optics alone: a line's light does not depend on its neighbours.
 * Units:      ps, mm.
 * Ownership:  strips are counted: each line of a list holds its strip, and so does the memory of strips.
 *             crt_lines_free releases all.
 * Errors:     false when memory is out; nothing has changed then.
 */
#ifndef CRT_LINES_H
#define CRT_LINES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "crt/piece.h"
#include "crt/tube.h"

#define CRT_STRIP_LINES 8

/* Lines that sweep alike: the same stretch of the screen in the same time, as the same beam. */
struct crt_line_way {
    float x0, x1; /* mm, x0 < x1 */
    int dots;
    uint64_t lit; /* ps, rounded (crt_line_lit) */
    struct crt_knobs knobs;
};

struct crt_strip {
    int refs;
    int lines;
    bool closed; /* takes no more lines */
    struct crt_line_way way;
    int64_t band;
    float y[CRT_STRIP_LINES];
    uint8_t brightest[CRT_MAX_GUNS][CRT_STRIP_LINES]; /* dot */
    uint8_t *drive;                                   /* [gun][line][dots] */
    struct crt_glow *glow;            /* its light, once worked out (crt/line_light.h) */
    const struct crt_line_beam *beam; /* while a pass runs */
};

struct crt_line {
    uint64_t t0, t1; /* ps */
    uint32_t source;
    int lane; /* of the strip */
    struct crt_strip *strip;
};

struct crt_line_list {
    struct crt_line *at;
    size_t count, room;
};

struct crt_lines {
    struct crt_line_list now;    /* lines not wholly before the running epoch */
    struct crt_line_list before; /* lines with a part in the epoch before */
    struct crt_strip *open;      /* the strip that lines are added to; it is held */
};

bool crt_line_same_way(const struct crt_line_way *a, const struct crt_line_way *b);
/* Height of the bands of lines of a way, mm. */
double crt_line_band(const struct crt_tube_row *row, const struct crt_line_way *way);
/* Time lit, rounded to one part in some thousands: rounded times of lines differ by 1 ps. */
uint64_t crt_line_lit(uint64_t t0, uint64_t t1);

/* To the list of either epoch. */
bool crt_lines_push(struct crt_lines *lines, struct crt_line_list *list,
                    const struct crt_tube_row *row, const struct crt_knobs *knobs,
                    const struct crt_scan_line *line);

/* Adds a line of strips to a list, holding its strip. */
bool crt_line_list_push(struct crt_line_list *list, const struct crt_line *line);
void crt_line_list_clear(struct crt_line_list *list);

/* As crt_journal_turn. */
bool crt_lines_turn(struct crt_lines *lines, uint64_t end, uint64_t keep_from);
/* The same where the epoch ends before its time: lines of the epoch before may still matter. */
bool crt_lines_turn_early(struct crt_lines *lines, uint64_t end, uint64_t keep_from);
void crt_lines_free(struct crt_lines *lines);

void crt_strip_release(struct crt_strip *strip);

/* Seconds per dot. */
double crt_line_dot_seconds(const struct crt_line *line);

#endif
