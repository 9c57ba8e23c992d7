/* view.h — the picture of a session: the paper, heights from the side, what the tablet says.
 *
 *      ┌───────────────┬─────────┐
 *      │ paper         │ tablet  │
 *      │               │ noise   │
 *      ├───────────────┤ paper   │
 *      │ heights       │ lines   │
 *      └───────────────┴─────────┘
 *
 * Models:     view_paper.c, view_side.c, view_panel.c draw a part each.
 * Units:      stage units; the paper has millimetres on its axes.
 * Ownership:  nothing; draws between stage_begin and stage_end.
 * Errors:     none.
 */
#ifndef ROMS_DIGITISE_VIEW_H
#define ROMS_DIGITISE_VIEW_H

#include "roms/digitise/session.h"
#include "roms/stage/graph.h"

enum { VIEW_WIDTH = 790, VIEW_SIDE_HEIGHT = 170, VIEW_PANEL_LEFT = 812 };

/* A whole picture. */
void view_draw(const struct session *session, struct stage *stage);

/* Above `bottom`; where millimetres are on the stage. */
struct graph view_paper(const struct session *session, struct stage *stage, float bottom);
/* Heights below it, above the same x. */
void view_side(const struct session *session, const struct graph *paper, struct stage *stage);
void view_panel(const struct session *session, struct stage *stage);

#endif
