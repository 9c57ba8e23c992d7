/* history.h — undo and redo: models as they were.
 *
 *      … ─ before that ─ before ─┤ now ├─ undone ─ …       keep: `now` is stored, what was undone is gone
 *
 * Models:     whole models in a ring, the oldest gives way.
 * Domain:     HISTORY_MOST steps back.
 * Ownership:  plain value, some 30 KB.
 * Errors:     false: there is nothing to go back, or forth, to.
 */
#ifndef ROMS_SPLINE_HISTORY_H
#define ROMS_SPLINE_HISTORY_H

#include "roms/spline/model.h"

enum { HISTORY_MOST = 32 };

struct history {
    struct model kept[HISTORY_MOST];
    int first, back, forth; /* the oldest one's place; steps that can be undone, redone */
};

/* Before a change: the model as it is. */
void history_keep(struct history *history, const struct model *model);
/* Exchanges the model with the one before, after. */
bool history_undo(struct history *history, struct model *model);
bool history_redo(struct history *history, struct model *model);

#endif
