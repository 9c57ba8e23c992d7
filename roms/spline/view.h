/* view.h — the picture of a model: curve, polygon, hull, construction, comb, joints, figures, menu.
 *
 * Models:     view.c puts the picture together; construction.c shows how a point comes about; comb.c
 *             curvature; figures.c what stands in words and numbers.
 * Units:      stage units; angles in degrees, counter-clockwise from the x axis.
 * Ownership:  nothing; draws between stage_begin and stage_end.
 * Errors:     a model that makes no curve is shown by its points, and the caption says why.
 */
#ifndef ROMS_SPLINE_VIEW_H
#define ROMS_SPLINE_VIEW_H

#include "roms/spline/editor.h"
#include "roms/spline/menu.h"
#include "roms/stage/stage.h"

/* A whole picture. */
void view_draw(const struct editor *editor, struct stage *stage, struct menu_kept *menu);

/* De Casteljau's lines, of B-splines de Boor's, at the part. */
void construction_draw(const struct editor *editor, const struct curve *curve, struct stage *stage);
/* Teeth across the curve, as long as it bends. */
void comb_draw(const struct curve *curve, struct stage *stage);
/* What joins how: C2, C1, G1 … at each joint. */
void joints_draw(const struct curve *curve, struct stage *stage);
/* Title and caption; `trouble`: why there is no curve, NULL: there is one. */
void figures_draw(const struct editor *editor, const struct curve *curve, const char *trouble,
                  struct stage *stage);

#endif
