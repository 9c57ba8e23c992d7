/* pick.c — hits of a refresh or field become an opinion, opinions become events. */
#include "roms/interact/pick.h"

#include <stddef.h>

#include "roms/bsp/board.h"
#include "roms/bsp/dpu.h"
#include "roms/bsp/interrupts.h"
#include "roms/bsp/timer.h"
#include "roms/interact/pen_place.h"
#include "roms/interact/pen_rows.h"

enum {
    BUTTON_WORDS = 64, /* more than a button has */
    AGREED = 2,
    OVER = 2, /* so long after its hits a refresh, or field, has ended */
};

#define APERTURE 14.0f

/* Sixtieths of a second. */
static uint32_t now(void)
{
    return (uint32_t)(timer_now() / (TIMER_HZ / 60));
}

/* ---- handlers --------------------------------------------------------------------------------------- */

static void put(struct pick_opinion *o, struct pick_hit hit)
{
    if (o->put - o->taken == PICK_HITS)
        return;
    o->hit[o->put % PICK_HITS] = hit;
    o->put++;
}

void pick_hit(void *ctx)
{
    struct pick *pick = ctx;
    uint32_t pc = dpu_pc();
    struct pick_hit hit = {
        .name = pick_segment_at(pick->segments, pc),
        .at = stage_from_head(pick->segments->stage, (float)dpu_x(), (float)dpu_y()),
        .group = board_ticks(),
        .time = now(),
    };
    if (hit.name == 0 && pc < STAGE_FREE_LOW) {
        int button = pick_name_before(pc, BUTTON_WORDS);
        hit.name = button == 0 ? 0 : PICK_BUTTON + button;
    }
    if (hit.name != 0)
        put(&pick->head[INPUT_VECTOR], hit);
    dpu_resume();
}

/* One that has moved and is open as before was closed meanwhile. */
static void look_at_tip(struct pick_opinion *o, enum input_head head)
{
    if (!pen_tip_moved(head))
        return;
    bool down = pen_tip(head);
    if (down || !o->down)
        o->presses++;
    o->down = down;
}

static void on_raster_pen(void *ctx)
{
    struct pick *pick = ctx;
    struct pen_hit hit;
    while (pen_hit_take(&hit))
        put(&pick->head[INPUT_RASTER],
            (struct pick_hit){0, {(float)hit.dot, (float)hit.line}, hit.field, now()});
    look_at_tip(&pick->head[INPUT_RASTER], INPUT_RASTER);
}

/* ---- one refresh, one field -------------------------------------------------------------------------- */

static struct point2 mean(const struct pick_opinion *o, int name)
{
    struct point2 sum = {0, 0};
    int count = 0;
    for (int i = 0; i < o->grouped; i++)
        if (o->group[i].name == name) {
            sum.x += o->group[i].at.x;
            sum.y += o->group[i].at.y;
            count++;
        }
    return (struct point2){sum.x / (float)count, sum.y / (float)count};
}

/* The name with most hits; of equals the one seen last, which lies on top. */
static int winner(const struct pick_opinion *o)
{
    int best = 0, most = 0;
    for (int i = 0; i < o->grouped; i++) {
        int count = 0;
        for (int k = 0; k < o->grouped; k++)
            count += o->group[k].name == o->group[i].name;
        if (count >= most) {
            most = count;
            best = o->group[i].name;
        }
    }
    return best;
}

static int button_at(const struct pick *pick, struct point2 at)
{
    for (int i = 0; i < pick->buttons; i++) {
        const struct pick_button *b = &pick->button[i];
        if (at.x >= b->low.x && at.x <= b->high.x && at.y >= b->low.y && at.y <= b->high.y)
            return PICK_BUTTON + b->name;
    }
    return 0;
}

/* Where the raster pen is that fired there. */
static bool raster_place(const struct pick *pick, struct point2 *at)
{
    const struct pick_opinion *o = &pick->head[INPUT_RASTER];
    struct pen_rows rows = {0};
    float line, dot;
    for (int i = 0; i < o->grouped; i++) {
        const struct pick_hit *hit = &o->group[i];
        struct pen_hit fired = {(uint32_t)hit->at.y, (uint32_t)hit->at.x, hit->group, false};
        pen_rows_add(&rows, &fired);
    }
    if (!pen_rows_middle(&rows, &line, &dot, NULL))
        return false;
    *at = pen_place(pick->segments->stage, pick->pen_dots, pick->pen_lines, line, dot);
    return true;
}

static void look(struct pick *pick, enum input_head head, int *name, int *part, struct point2 *at)
{
    struct pick_opinion *o = &pick->head[head];
    const struct segment *g = NULL;
    *part = 0;
    *name = 0;
    if (head == INPUT_VECTOR) {
        *name = winner(o);
        *at = mean(o, *name);
        g = segment_find(pick->segments, *name);
        if (g)
            *part = pick_part_at(pick->segments, g, *at);
        return;
    }
    if (!raster_place(pick, at))
        return;
    *name = button_at(pick, *at);
    if (*name == 0)
        g = segment_at(pick->segments, *at, pick->aperture, part);
    if (g)
        *name = g->name;
}

static bool may_tell(const struct pick *pick)
{
    return pick->put - pick->taken < PICK_EVENTS;
}

static void tell(struct pick *pick, enum pick_kind kind, enum input_head head)
{
    const struct pick_opinion *o = &pick->head[head];
    if (!may_tell(pick))
        return;
    pick->event[pick->put++ % PICK_EVENTS] =
        (struct pick_event){kind, head, o->name, o->part, o->at};
}

static void conclude(struct pick *pick, enum input_head head)
{
    struct pick_opinion *o = &pick->head[head];
    struct point2 at;
    int name, part;
    if (o->grouped == 0)
        return;
    look(pick, head, &name, &part, &at);
    uint32_t when = o->group[0].time;
    o->grouped = 0;
    o->agreed = name == o->candidate ? o->agreed + 1 : 1;
    o->candidate = name;
    if (name == o->name && name != 0) {
        o->seen = when;
        o->at = at;
    }
    if (name == 0 || o->agreed < AGREED || (name == o->name && part == o->part))
        return;
    o->seen = when;
    o->at = at;
    o->name = name;
    o->part = part;
    tell(pick, PICK_POINTS, head);
}

static void forget(struct pick *pick, enum input_head head)
{
    struct pick_opinion *o = &pick->head[head];
    if (o->name == 0 || now() - o->seen <= PICK_HOLD)
        return;
    o->name = o->part = o->candidate = 0;
    tell(pick, PICK_POINTS, head);
}

/* A place that is given back is written over at once. */
static bool take_hit(struct pick_opinion *o, struct pick_hit *hit)
{
    uint32_t state = irq_lock();
    bool any = o->put != o->taken;
    if (any)
        *hit = o->hit[o->taken++ % PICK_HITS];
    irq_unlock(state);
    return any;
}

static void take_hits(struct pick *pick, enum input_head head)
{
    struct pick_opinion *o = &pick->head[head];
    struct pick_hit hit;
    while (take_hit(o, &hit)) {
        if (o->grouped > 0 && o->group[0].group != hit.group)
            conclude(pick, head);
        if (o->grouped < PICK_HITS)
            o->group[o->grouped++] = hit;
    }
    if (o->grouped > 0 && now() - o->group[0].time >= OVER)
        conclude(pick, head);
}

/* ---- for the program ----------------------------------------------------------------------------------- */

void pick_begin(struct pick *pick, struct segments *segments)
{
    *pick = (struct pick){.segments = segments, .aperture = APERTURE};
    pick->pen_dots = pen_usual_dots();
    dpu_on_pen(pick_hit, pick);
    input_on(INPUT_BIT_PEN_RASTER, on_raster_pen, pick);
    pen_raster_on(false);
}

static void poll_head(struct pick *pick, enum input_head head)
{
    struct pick_opinion *o = &pick->head[head];
    take_hits(pick, head);
    forget(pick, head);
    uint32_t state = irq_lock();
    look_at_tip(o, head);
    irq_unlock(state);
    for (; o->pressed != o->presses && may_tell(pick); o->pressed++) /* others wait */
        tell(pick, PICK_PRESSED, head);
}

bool pick_poll(struct pick *pick, struct pick_event *event)
{
    poll_head(pick, INPUT_VECTOR);
    poll_head(pick, INPUT_RASTER);
    if (pick->put == pick->taken)
        return false;
    *event = pick->event[pick->taken++ % PICK_EVENTS];
    return true;
}
