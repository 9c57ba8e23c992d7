/* scan_run.c — shows a scan conversion: all of it, or decision by decision. */
#include <stdio.h>

#include "roms/monitor/keys.h"
#include "roms/monitor/stepper.h"

enum { MOST_RUNS = 8192 };

/* What was lit so far. */
struct scan {
    const struct stepper *stepper;
    struct step_run lit[MOST_RUNS];
    int count;
};

static bool step(struct monitor *m, struct scan *scan, struct step *now)
{
    *now = (struct step){0};
    if (!scan->stepper->next(scan->stepper->state, now))
        return false;
    for (int i = 0; i < now->lit_count && scan->count < MOST_RUNS; i++)
        scan->lit[scan->count++] = now->lit[i];
    if (m->table && now->row[0] != '\0')
        printf("%s\n", now->row);
    return true;
}

static void show(struct monitor *m, const struct scan *scan, const struct step *now)
{
    const struct stepper *s = scan->stepper;
    stage_begin(&m->stage);
    struct grid grid =
        grid_fit(&m->stage, 0, 0, STAGE_WIDTH, STAGE_HEIGHT, s->x0, s->y0, s->x1, s->y1);
    grid_rules(&grid);
    if (s->before != NULL)
        s->before(s->state, &grid);
    for (int i = 0; i < scan->count; i++)
        grid_run(&grid, scan->lit[i].y, scan->lit[i].x0, scan->lit[i].x1, scan->lit[i].ink);
    if (s->ideal != NULL)
        s->ideal(s->state, &grid);
    if (now != NULL) {
        for (int i = 0; i < now->candidate_count; i++)
            grid_candidate(&grid, (int)now->candidate[i].x, (int)now->candidate[i].y, INK_YELLOW);
        if (now->has_midpoint) {
            struct point2 at = grid_place(&grid, now->midpoint.x, now->midpoint.y);
            stage_ink(&m->stage, INK_RED);
            stage_marker(&m->stage, at.x, at.y);
        }
        stage_caption(&m->stage, now->decision);
    }
    stage_title(&m->stage, s->title);
    stage_end(&m->stage);
}

/* After a decision in step mode: true: the next one; false: the rest at once. */
static bool ask(struct monitor *m, unsigned number)
{
    char text[STAGE_PROMPT + 1];
    snprintf(text, sizeof text, "step %u   space next   r the rest", number);
    stage_prompt(&m->stage, text);
    for (;;) {
        switch (keys_next(KEYS_FOREVER)) {
        case ' ':
        case 'n':
        case KEYS_ENTER:
        case KEY_RIGHT:
            return true;
        case 'r':
        case 'q':
        case KEYS_ESCAPE:
        case KEYS_INPUT_END:
            return false;
        default:
            break;
        }
    }
}

void scan_run(struct monitor *m, const struct stepper *stepper)
{
    static struct scan scan;
    struct step now;
    scan = (struct scan){.stepper = stepper};
    bool stepping = m->steps;
    if (m->table)
        printf("%s\n", stepper->header);
    for (unsigned number = 1; step(m, &scan, &now); number++) {
        if (!stepping)
            continue;
        show(m, &scan, &now);
        if (!m->table && now.decision[0] != '\0')
            printf("%s\n", now.decision);
        stepping = ask(m, number);
    }
    show(m, &scan, NULL);
}
