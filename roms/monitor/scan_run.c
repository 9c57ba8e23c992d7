/* scan_run.c — shows a scan conversion: all of it, or decision by decision. */
#include <stdio.h>
#include <string.h>

#include "roms/monitor/keys.h"
#include "roms/monitor/stepper.h"

enum {
    MOST_RUNS = 8192,
    AROUND = 9, /* cells shown on each side of a candidate */
    APART = 3,  /* between dots on the vector head, stage units */
    ACROSS = STAGE_WIDTH / APART + 1,
    UP = STAGE_HEIGHT / APART + 1,
};

/* What was lit so far. */
struct scan {
    const struct stepper *stepper;
    struct step_run lit[MOST_RUNS];
    int count;
    uint8_t dots[(ACROSS * UP + 7) / 8]; /* places that the vector head has a dot at */
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

static struct grid fit(struct monitor *m, const struct stepper *s, const struct step *now)
{
    struct grid grid =
        grid_fit(&m->stage, 0, 0, STAGE_WIDTH, STAGE_HEIGHT, s->x0, s->y0, s->x1, s->y1);
    if (now == NULL || now->candidate_count == 0 || grid_ruled(&grid))
        return grid;
    int x = (int)now->candidate[0].x, y = (int)now->candidate[0].y;
    return grid_fit(&m->stage, 0, 0, STAGE_WIDTH, STAGE_HEIGHT, x - AROUND, y - AROUND, x + AROUND,
                    y + AROUND);
}

/* Whether a pixel falls where the vector head has a dot; it has one then. */
static bool has_dot(struct scan *scan, const struct grid *grid, int x, int y)
{
    struct point2 at = grid_place(grid, (float)x, (float)y);
    if (at.x < 0 || at.y < 0 || at.x > STAGE_WIDTH || at.y > STAGE_HEIGHT)
        return true;
    unsigned place = (unsigned)at.y / APART * ACROSS + (unsigned)at.x / APART;
    bool has = scan->dots[place / 8] >> place % 8 & 1;
    scan->dots[place / 8] |= (uint8_t)(1u << place % 8);
    return has;
}

static void show_lit(struct monitor *m, struct scan *scan, const struct grid *grid)
{
    memset(scan->dots, 0, sizeof scan->dots);
    for (int i = 0; i < scan->count; i++) {
        const struct step_run *run = &scan->lit[i];
        bool crowded =
            !grid_ruled(grid) && run->x0 == run->x1 && has_dot(scan, grid, run->x0, run->y);
        stage_heads(&m->stage, crowded ? STAGE_RASTER : STAGE_BOTH);
        grid_run(grid, run->y, run->x0, run->x1, run->ink);
    }
    stage_heads(&m->stage, STAGE_BOTH);
}

static void show_decision(struct monitor *m, const struct grid *grid, const struct step *now)
{
    for (int i = 0; i < now->candidate_count; i++)
        grid_candidate(grid, (int)now->candidate[i].x, (int)now->candidate[i].y, INK_YELLOW);
    if (now->has_midpoint) {
        struct point2 at = grid_place(grid, now->midpoint.x, now->midpoint.y);
        stage_ink(&m->stage, INK_RED);
        stage_marker(&m->stage, at.x, at.y);
    }
    stage_caption(&m->stage, now->decision);
}

static void show(struct monitor *m, struct scan *scan, const struct step *now)
{
    const struct stepper *s = scan->stepper;
    stage_begin(&m->stage);
    struct grid grid = fit(m, s, now);
    grid_rules(&grid);
    if (s->before != NULL)
        s->before(s->state, &grid);
    show_lit(m, scan, &grid);
    if (s->ideal != NULL && grid_ruled(&grid))
        s->ideal(s->state, &grid);
    if (now != NULL)
        show_decision(m, &grid, now);
    else if (s->caption != NULL)
        stage_caption(&m->stage, s->caption);
    stage_title(&m->stage, s->title);
    stage_end(&m->stage);
}

bool step_ask(struct monitor *m, unsigned number)
{
    char text[STAGE_PROMPT + 1];
    snprintf(text, sizeof text, "step %u   space next   r the rest", number);
    stage_prompt(&m->stage, text);
    for (;;) {
        switch (keys_next(KEYS_FOREVER)) {
        case ' ':
        case 'n':
        case KEYS_ENTER:
        case KEYS_LINE:
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
        stepping = step_ask(m, number);
    }
    show(m, &scan, NULL);
}
