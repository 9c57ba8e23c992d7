/* view_help.c — the page that explains. */
#include "roms/sketch/view.h"
#include "roms/stage/panel.h"

void view_help(struct view *view)
{
    static const char *const lines[] = {
        "Figures     Press, drag, let go; or press, move, press. Escape leaves",
        "            off what is under way.",
        "Points      Gravity draws the cursor to points, lines and circles.",
        "            What ends at a point shares it: both follow when it moves.",
        "Upright     New lines are horizontal or vertical and stay so; Shift",
        "            does it for one. Two short lines beside a line tell of it.",
        "Move        Drag a point, a figure, or what is selected. A point",
        "            dropped on another one becomes one with it.",
        "Select      Press on figures, or drag a box round them.",
        "Subpicture  What is selected becomes one, A to P. Copy places it; Copy",
        "            again: the next one. Turn and Size change copies that are",
        "            selected, else those to come.",
        "Open        The subpicture itself: all copies change with it. Open",
        "            again goes back to the drawing.",
        "Undo        Takes back, 64 steps at least; Redo does again.",
        "Save        prints the drawing as text on the console; Load takes such",
        "            text from there.",
        "",
        "Pen, stylus, finger, mouse: all point. Each word has its letter.",
    };
    enum { LINES = sizeof lines / sizeof lines[0] };
    stage_begin(&view->stage);
    stage_title(&view->stage, "Sketch: help");
    stage_caption(&view->stage, "Any key, or a press, goes back.");
    struct panel panel = panel_open(&view->stage, 0, 780, 70, LINES, "");
    for (int i = 0; i < LINES; i++)
        panel_line(&panel, INK_TEXT, lines[i]);
    stage_end(&view->stage);
}
