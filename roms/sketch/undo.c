#include "roms/sketch/undo.h"

#include <string.h>

static int slot_of(unsigned table, int index)
{
    return table == TABLE_POINT    ? index
           : table == TABLE_FIGURE ? DRAWING_POINTS + index
                                   : DRAWING_POINTS + DRAWING_FIGURES + index;
}

static void *content(struct drawing *d, unsigned table, int index, size_t *size)
{
    switch (table) {
    case TABLE_POINT:
        *size = sizeof d->now.point[0];
        return &d->now.point[index];
    case TABLE_FIGURE:
        *size = sizeof d->now.figure[0];
        return &d->now.figure[index];
    default:
        *size = sizeof d->now.master[0];
        return &d->now.master[index];
    }
}

static void changing(void *ctx, enum drawing_table table, int index)
{
    struct undo *u = ctx;
    int slot = slot_of(table, index);
    size_t size;
    if (!u->open || u->turning || u->kept[slot])
        return;
    u->kept[slot] = true;
    struct undo_change *c = &u->before[u->count++];
    memset(c, 0, sizeof *c);
    c->table = (uint16_t)table;
    c->index = (uint16_t)index;
    const void *now = content(u->drawing, table, index, &size);
    memcpy(&c->held, now, size);
}

void undo_attach(struct undo *u, struct drawing *drawing)
{
    memset(u, 0, sizeof *u);
    u->drawing = drawing;
    u->first = u->now = u->last = 1; /* step 0 is the empty one before all */
    drawing->changing = changing;
    drawing->ctx = u;
}

void undo_begin(struct undo *u)
{
    u->open = true;
    u->count = 0;
    memset(u->kept, 0, sizeof u->kept);
}

/* The slot and the record exchange contents, by way of the drawing, which notes that. */
static void turn(struct undo *u, struct undo_change *c)
{
    struct undo_change other = *c;
    size_t size;
    u->turning = true;
    if (c->table == TABLE_POINT)
        drawing_change_point(u->drawing, c->index);
    else if (c->table == TABLE_FIGURE)
        drawing_change_figure(u->drawing, c->index);
    else
        drawing_change_master(u->drawing, c->index);
    void *now = content(u->drawing, c->table, c->index, &size);
    memcpy(&c->held, now, size);
    memcpy(now, &other.held, size);
    /* What it is now may be in a subpicture, too. */
    u->drawing->fresh_masters = true;
    u->turning = false;
}

static bool differs(struct undo *u, const struct undo_change *c)
{
    size_t size;
    const void *now = content(u->drawing, c->table, c->index, &size);
    return memcmp(&c->held, now, size) != 0;
}

static uint32_t begin_of(const struct undo *u, uint32_t step)
{
    return u->end[(step - 1) % UNDO_STEPS];
}

bool undo_commit(struct undo *u)
{
    uint32_t begin = begin_of(u, u->now), at = begin;
    u->open = false;
    for (int i = 0; i < u->count; i++)
        if (differs(u, &u->before[i]))
            u->change[at++ % UNDO_CHANGES] = u->before[i];
    if (at == begin)
        return false;
    u->end[u->now % UNDO_STEPS] = at;
    u->last = ++u->now;
    /* The oldest whose changes or whose place is written over. */
    while (u->last - u->first >= UNDO_STEPS - 1 || at - begin_of(u, u->first) > UNDO_CHANGES)
        u->first++;
    return true;
}

void undo_cancel(struct undo *u)
{
    u->open = false;
    for (int i = u->count - 1; i >= 0; i--)
        turn(u, &u->before[i]);
}

bool undo_back(struct undo *u)
{
    if (u->now == u->first || u->open)
        return false;
    u->now--;
    for (uint32_t at = u->end[u->now % UNDO_STEPS]; at-- != begin_of(u, u->now);)
        turn(u, &u->change[at % UNDO_CHANGES]);
    return true;
}

bool undo_again(struct undo *u)
{
    if (u->now == u->last || u->open)
        return false;
    for (uint32_t at = begin_of(u, u->now); at != u->end[u->now % UNDO_STEPS]; at++)
        turn(u, &u->change[at % UNDO_CHANGES]);
    u->now++;
    return true;
}

unsigned undo_depth(const struct undo *u)
{
    return u->now - u->first;
}
