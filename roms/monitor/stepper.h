/* stepper.h — a scan conversion that goes one decision at a time.
 *
 *      algorithm ──next──▶ struct step: what it lit, what it chose from, its decision parameter
 *                             ├──▶ a row of the table (table on)
 *                             └──▶ enlarged pixels on the stage; in step mode a key for each
 *
 * Models:     what lines, curves and fills have in common for those who watch. A figure too large
 *             for cells that can be told apart is shown without its ideal; in step mode the cells
 *             about the candidates.
 * Units:      pixels, y up.
 * Ownership:  the state is the caller's and must outlive scan_run.
 * Errors:     none; a scan conversion without end must end itself.
 */
#ifndef ROMS_MONITOR_STEPPER_H
#define ROMS_MONITOR_STEPPER_H

#include "roms/monitor/monitor.h"
#include "roms/stage/grid.h"

enum { STEP_RUNS = 16, STEP_CANDIDATES = 4, STEP_TEXT = 96 };

/* Pixels x0…x1 of row y. */
struct step_run {
    int y, x0, x1;
    enum ink ink;
};

/* One decision. */
struct step {
    struct step_run lit[STEP_RUNS];
    int lit_count;
    struct point2 candidate[STEP_CANDIDATES]; /* pixels it could choose */
    int candidate_count;
    struct point2 midpoint; /* what the decision looks at, if has_midpoint */
    bool has_midpoint;
    char row[STEP_TEXT];      /* of the table, without its end; "": none */
    char decision[STEP_TEXT]; /* in words: "p = 6 >= 0: y steps" */
};

struct stepper {
    const char *title;  /* of the picture */
    const char *header; /* of the table */
    int x0, y0, x1, y1; /* the pixels to be shown */
    /* The next decision, into an empty step; false: there was none left. The first may be the
     * start. */
    bool (*next)(void *state, struct step *step);
    /* Draws the ideal over the pixels; may be NULL. */
    void (*ideal)(const void *state, const struct grid *grid);
    /* Draws what stands before the first decision (a boundary to be filled); may be NULL. */
    void (*before)(const void *state, const struct grid *grid);
    void *state;
    const char *caption; /* under the finished picture; may be NULL */
};

/* After a step in step mode, for those who show their steps themselves: waits for a key; true: the
 * next one, false: the rest at once. At the end of input a picture that somebody may look at stays. */
bool step_ask(struct monitor *monitor, unsigned number);

/* Runs it: to the end, or key by key in step mode. Prints its rows when the table is on. */
void scan_run(struct monitor *monitor, const struct stepper *stepper);

#endif
