/* view.c — which segments there are, and which are to be made anew. */
#include "roms/sketch/view.h"

#include <stdio.h>
#include <string.h>

#include "roms/sketch/view_parts.h"

void view_open(struct view *view)
{
    memset(view, 0, sizeof *view);
    stage_open(&view->stage);
    segments_begin(&view->segments, &view->stage, LIGHT_PEN_LOW - STAGE_FREE_LOW);
    light_pen_begin(&view->light_pen, STAGE_FREE_LOW);
    view_menu(view);
    view_cursor(view);
    view->settings = UINT32_MAX;
    view->tool = COMMAND_NONE;
    view->hot = -1;
}

void view_say(struct view *view, const char *text)
{
    if (strcmp(text, view->stage.prompted) != 0)
        stage_prompt(&view->stage, text);
}

/* ---- segments that take the place of others -------------------------------------------------- */

void view_renew(struct view *view)
{
    segment_create(&view->segments, NAME_NEW);
    view->segments.type = STAGE_SOLID;
}

/* There may be room for only one of both. */
bool view_renewed(struct view *view, int name)
{
    struct segments *s = &view->segments;
    if (segment_close(s) != SEGMENT_OK) {
        segment_delete(s, name);
        if (segment_close(s) != SEGMENT_OK) {
            segment_delete(s, NAME_NEW);
            view->full = true;
            return false;
        }
    }
    segment_delete(s, name);
    segment_rename(s, NAME_NEW, name);
    return true;
}

/* ---- what has changed ------------------------------------------------------------------------ */

static bool has_fresh_end(const struct drawing *d, const struct figure *f)
{
    for (int k = 0; k < figure_ends(f->kind); k++)
        if (d->fresh_point[f->end[k]])
            return true;
    return false;
}

static bool is_stale(const struct view *view, const struct tools *t, int i, bool moving)
{
    const struct drawing *d = &t->drawing;
    const struct figure *f = &d->now.figure[i];
    return d->fresh_figure[i] || view->selected[i] != t->selection.figure[i] ||
           view->moving[i] != moving || has_fresh_end(d, f) ||
           (f->kind == FIGURE_COPY && d->fresh_masters);
}

/* Of tools that pick, before the press. */
static int hot_figure(const struct tools *t, bool near)
{
    bool picks = t->tool >= COMMAND_MOVE && t->tool != COMMAND_COPY;
    return picks && near && t->phase == PHASE_IDLE ? t->cursor.figure : -1;
}

static void note_hot(struct view *view, int hot)
{
    if (view->hot == hot)
        return;
    if (view->hot >= 0)
        view->stale[view->hot / VIEW_GROUP] = true;
    if (hot >= 0)
        view->stale[hot / VIEW_GROUP] = true;
    view->hot = hot;
}

static void note_changes(struct view *view, struct tools *t)
{
    bool under_way = t->phase == PHASE_PLACING || (t->phase == PHASE_MOVING && t->moved);
    bool all = view->picture != t->picture;
    for (int i = 0; i < DRAWING_FIGURES; i++) {
        bool moving = under_way && t->moving.figure[i];
        if (all || is_stale(view, t, i, moving))
            view->stale[i / VIEW_GROUP] = true;
        view->selected[i] = t->selection.figure[i];
        view->moving[i] = moving;
    }
    for (int i = 0; i < VIEW_GROUPS; i++) /* a step may have made room */
        view->stale[i] |= view->lacking[i] && view->step != t->undo.now;
    view->step = t->undo.now;
    view->picture = t->picture;
    memset(t->drawing.fresh_point, 0, sizeof t->drawing.fresh_point);
    memset(t->drawing.fresh_figure, 0, sizeof t->drawing.fresh_figure);
    t->drawing.fresh_masters = false;
}

static uint32_t settings_of(const struct tools *t)
{
    return (uint32_t)t->snap.spacing << 8 | (uint32_t)t->tool << 3 | (uint32_t)t->upright << 2 |
           (uint32_t)t->snap.grid << 1 | (uint32_t)t->snap.gravity |
           (t->grid_shown ? 0x80000000u : 0);
}

static void bring_up_to_date(struct view *view, struct tools *t, bool near)
{
    uint32_t settings = settings_of(t), changed = settings ^ view->settings;
    int fullness = drawing_fullness(&t->drawing.now);
    note_changes(view, t);
    note_hot(view, hot_figure(t, near));
    if (changed >> 8 != 0)
        view_grid(view, t);
    if (changed != 0 || fullness != view->fullness)
        view_marks(view, t);
    view->settings = settings;
    view->fullness = fullness;
    for (int i = 0; i < VIEW_GROUPS; i++)
        if (view->stale[i])
            view_group(view, t, i);
    for (int i = 0; i < VIEW_GROUPS; i++)
        view->full |= view->lacking[i];
    view_band(view, t, near);
    view_status(view, t);
}

/* ---- showing --------------------------------------------------------------------------------- */

static void draw_all(struct view *view, const struct tools *t)
{
    char title[32];
    snprintf(title, sizeof title, t->picture == 0 ? "Sketch" : "Subpicture %c",
             'A' + t->picture - 1);
    stage_begin(&view->stage);
    stage_title(&view->stage, title);
    stage_caption(&view->stage, menu_hint(t->tool));
    segments_draw(&view->segments);
    if (view->light_pen.used)
        stage_chain(&view->stage, LIGHT_PEN_LOW); /* which leads on to the segments */
    stage_end(&view->stage);
}

void view_draw(struct view *view, struct tools *tools)
{
    view->tool = tools->tool;
    bring_up_to_date(view, tools, view->near);
    draw_all(view, tools);
}

static void move_cursor(struct view *view, struct point2 cursor, bool near)
{
    struct segments *s = &view->segments;
    const struct segment *old = segment_find(s, NAME_CURSOR);
    struct matrix3 at = matrix3_identity();
    at.at[0][2] = cursor.x;
    at.at[1][2] = cursor.y;
    if (old != NULL && old->visible != near)
        segment_set_visible(s, NAME_CURSOR, near);
    if (old != NULL && near && memcmp(&old->transform, &at, sizeof at) != 0)
        segment_set_transform(s, NAME_CURSOR, &at);
}

void view_show(struct view *view, struct tools *tools, struct point2 cursor, bool near)
{
    bool other = view->tool != tools->tool || view->picture != tools->picture;
    view->tool = tools->tool;
    view->full = false;
    bring_up_to_date(view, tools, near);
    move_cursor(view, cursor, near);
    if (other || !segments_redraw(&view->segments))
        draw_all(view, tools);
    view_say(view, view->full ? "Display memory is full: not all of the drawing is shown."
                              : tools->message);
}
