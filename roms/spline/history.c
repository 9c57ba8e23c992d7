#include "roms/spline/history.h"

static struct model *slot(struct history *h, int i)
{
    return &h->kept[(h->first + i) % HISTORY_MOST];
}

static void exchange(struct model *a, struct model *b)
{
    struct model was = *a;
    *a = *b;
    *b = was;
}

void history_keep(struct history *h, const struct model *model)
{
    if (h->back == HISTORY_MOST) {
        h->first = (h->first + 1) % HISTORY_MOST;
        h->back--;
    }
    *slot(h, h->back++) = *model;
    h->forth = 0;
}

/* The place of the one taken gets the present one: undo and redo walk over the same row. */
bool history_undo(struct history *h, struct model *model)
{
    if (h->back == 0)
        return false;
    exchange(slot(h, --h->back), model);
    h->forth++;
    return true;
}

bool history_redo(struct history *h, struct model *model)
{
    if (h->forth == 0)
        return false;
    exchange(slot(h, h->back++), model);
    h->forth--;
    return true;
}
