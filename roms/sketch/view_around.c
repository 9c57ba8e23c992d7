/* view_around.c — grid, menu, marks in it, rubber band and attraction, status line, cursor. */
#include <stdio.h>
#include <string.h>

#include "roms/geometry/scalar.h"
#include "roms/sketch/view_parts.h"

static void put(struct view *view, enum ink ink, enum segment_kind kind,
                const struct point2 *points, int count)
{
    view->segments.ink = ink;
    if (segment_put(&view->segments, kind, points, count) != SEGMENT_OK)
        view->full = true;
}

static void put_text(struct view *view, enum ink ink, float x, float y, const char *text)
{
    view->segments.ink = ink;
    if (segment_put_text(&view->segments, (struct point2){x, y}, text) != SEGMENT_OK)
        view->full = true;
}

static void put_box(struct view *view, enum ink ink, float x0, float y0, float x1, float y1)
{
    const struct point2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    put(view, ink, SEGMENT_POLYGON, corners, 4);
}

/* ---- grid ------------------------------------------------------------------------------------ */

/* Dots; the closer the grid, the fewer of its places are shown. */
void view_grid(struct view *view, const struct tools *tools)
{
    struct point2 row[AREA_RIGHT / 40 + 1];
    int spacing = tools->snap.spacing / PLACE_UNIT, apart = spacing;
    while (apart < 40)
        apart *= 2;
    view_renew(view);
    for (int y = (AREA_BOTTOM + apart - 1) / apart * apart; tools->grid_shown && y <= AREA_TOP;
         y += apart) {
        int count = 0;
        for (int x = 0; x <= AREA_RIGHT; x += apart)
            row[count++] = (struct point2){(float)x, (float)y};
        put(view, INK_GRID, SEGMENT_DOT, row, count);
    }
    view_renewed(view, NAME_GRID);
}

/* ---- menu ------------------------------------------------------------------------------------ */

void view_menu(struct view *view)
{
    view_renew(view);
    for (int i = 0; i < MENU_ROWS; i++)
        put_text(view, INK_TEXT, MENU_LEFT, menu_row_y(i), menu_row(i)->text);
    view_renewed(view, NAME_MENU);
}

static void mark(struct view *view, enum ink ink, enum command command)
{
    float y = menu_row_y(menu_row_of(command));
    put_box(view, ink, MENU_LEFT - 8, y - 5, STAGE_WIDTH - 2, y + 22);
}

void view_marks(struct view *view, const struct tools *tools)
{
    char store[16];
    view_renew(view);
    if (tools->grid_shown)
        mark(view, INK_GREEN, COMMAND_GRID);
    if (tools->snap.grid)
        mark(view, INK_GREEN, COMMAND_SNAP);
    if (tools->snap.gravity)
        mark(view, INK_GREEN, COMMAND_GRAVITY);
    if (tools->upright)
        mark(view, INK_GREEN, COMMAND_UPRIGHT);
    mark(view, INK_YELLOW, tools->tool);
    snprintf(store, sizeof store, "store %3d%%", drawing_fullness(&tools->drawing.now));
    put_text(view, INK_CYAN, MENU_LEFT, 4, store);
    view_renewed(view, NAME_MARKS);
}

/* ---- rubber band, attraction ----------------------------------------------------------------- */

static void put_attraction(struct view *view, const struct snapped *cursor)
{
    struct point2 p = place_in_units(cursor->at);
    float r = cursor->kind == SNAP_POINT ? 9 : 7;
    const struct point2 diamond[] = {
        {p.x - r, p.y}, {p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}};
    if (cursor->kind == SNAP_POINT)
        put_box(view, INK_ORANGE, p.x - r, p.y - r, p.x + r, p.y + r);
    else if (cursor->kind == SNAP_LINE || cursor->kind == SNAP_CIRCLE)
        put(view, INK_ORANGE, SEGMENT_POLYGON, diamond, 4);
    else if (cursor->kind == SNAP_GRID)
        put(view, INK_ORANGE, SEGMENT_MARKER, &p, 1);
}

static void put_band(struct view *view, const struct tools *tools, struct place to)
{
    struct point2 a = place_in_units(tools->from), b = place_in_units(to);
    const struct point2 line[] = {a, b};
    view->segments.type = STAGE_SHORT_DASH;
    if (tools->phase == PHASE_BOX)
        put_box(view, INK_ORANGE, a.x, a.y, b.x, b.y);
    else if (tools->phase == PHASE_MOVING || tools->tool == COMMAND_CIRCLE ||
             tools->tool == COMMAND_ARC)
        put(view, INK_ORANGE, SEGMENT_POLYLINE, line, 2);
    view->segments.type = STAGE_SOLID;
}

void view_band(struct view *view, const struct tools *tools, bool near)
{
    struct place to;
    bool banded = tools_band(tools, &to);
    if (banded == view->banded && near == view->near &&
        memcmp(&to, &view->band_to, sizeof to) == 0 &&
        memcmp(&tools->cursor, &view->cursor, sizeof view->cursor) == 0)
        return;
    view->banded = banded;
    view->near = near;
    view->band_to = to;
    view->cursor = tools->cursor;
    view_renew(view);
    if (banded)
        put_band(view, tools, to);
    if (near)
        put_attraction(view, &tools->cursor);
    view_renewed(view, NAME_BAND);
}

void view_cursor(struct view *view)
{
    static const struct point2 arms[4][2] = {
        {{-24, 0}, {-6, 0}}, {{6, 0}, {24, 0}}, {{0, -24}, {0, -6}}, {{0, 6}, {0, 24}}};
    view_renew(view);
    for (int i = 0; i < 4; i++)
        put(view, INK_BRIGHT, SEGMENT_POLYLINE, arms[i], 2);
    view_renewed(view, NAME_CURSOR);
    segment_set_visible(&view->segments, NAME_CURSOR, false);
}

/* ---- status ---------------------------------------------------------------------------------- */

/* One decimal, without printf's floats. */
static const char *tenths(char text[12], int32_t hundredths)
{
    long v = (hundredths + (hundredths < 0 ? -5 : 5)) / 10, size = v < 0 ? -v : v;
    snprintf(text, 12, "%s%ld.%ld", v < 0 ? "-" : "", size / 10 % 100000, size % 10);
    return text;
}

static void say_band(const struct tools *tools, char text[VIEW_STATUS_TEXT + 1])
{
    struct place to;
    char length[12], angle[12];
    text[0] = '\0';
    if (!tools_band(tools, &to))
        return;
    struct point2 a = place_in_units(tools->from), b = place_in_units(to);
    float x = b.x - a.x, y = b.y - a.y, degrees = atan2f(y, x) / DEGREE;
    degrees += degrees < 0 ? 360 : 0;
    snprintf(text, VIEW_STATUS_TEXT + 1, "%s at %s",
             tenths(length, scalar_nearest(sqrtf(x * x + y * y) * 100)),
             tenths(angle, scalar_nearest(degrees * 100)));
}

void view_status(struct view *view, const struct tools *tools)
{
    static const char *const kinds[] = {[SNAP_NONE] = "",
                                        [SNAP_GRID] = "to the grid",
                                        [SNAP_LINE] = "to a line",
                                        [SNAP_CIRCLE] = "to a circle",
                                        [SNAP_POINT] = "to a point"};
    static const float columns[VIEW_STATUS] = {0, 405, 670};
    char text[VIEW_STATUS][VIEW_STATUS_TEXT + 1], x[12], y[12];
    struct place at = tools->cursor.at;
    memset(text, 0, sizeof text);
    snprintf(text[0], sizeof text[0], "%-10s %6s %5s", menu_tool(tools->tool), tenths(x, at.x),
             tenths(y, at.y));
    say_band(tools, text[1]);
    snprintf(text[2], sizeof text[2], "%s", kinds[tools->cursor.kind]);
    if (memcmp(text, view->status, sizeof text) == 0)
        return;
    memcpy(view->status, text, sizeof text);
    view_renew(view);
    for (int i = 0; i < VIEW_STATUS; i++)
        if (text[i][0] != '\0')
            put_text(view, INK_CYAN, columns[i], 4, text[i]);
    view_renewed(view, NAME_STATUS);
}
